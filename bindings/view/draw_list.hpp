#pragma once
#include <vector>

#include "view/appearance.hpp"
#include "view/constraint_look.hpp"
#include "view/figure.hpp"
#include "view/floor.hpp"
#include "view/overlay.hpp"
#include "view/tints.hpp"

namespace pantin {

struct Rgb {
  float r = 0.0f, g = 0.0f, b = 0.0f;
};
struct Float3 {
  float x = 0.0f, y = 0.0f, z = 0.0f;
};

/// What is to be drawn of a world, as rows of floats for the shaders: places relative to the eye in units of the camera's
/// distance, linear colours. What has an opacity below 1 is drawn in a part of the pixels, or of their samples.
struct DrawList {
  enum Style { plain = 0, hinge = 1 };  ///< of a ball; of a bar 1 is unlit
  struct Ball {
    Float3 at;
    float radius;
    Rgb color;
    float style;
    Rgb second;
    float opacity = 1.0f;
  };
  struct Bar {
    Float3 from;
    float radius;
    Float3 to;
    float style;
    Rgb color;
    float opacity = 1.0f;
  };
  struct Ellipsoid {
    Float3 at, x, y, z;
    Rgb color, second;
    float opacity = 1.0f;
  };
  struct Corner {
    Float3 at, normal;
    Rgb color;
    float opacity = 1.0f;
  };
  struct PictureCorner {
    Float3 at, normal;  ///< without a normal it is shown as the picture is, where that is opaque
    Rgb color;
    float opacity;
    float u, v;
  };
  /// What shows one picture; globes have in `second` how many round them and down.
  struct Sheet {
    std::shared_ptr<const Picture> picture;
    std::vector<PictureCorner> corners, sprites, shades;  ///< shades: of sprites, as they throw shadows
    std::vector<Ellipsoid> globes;
    bool shown;  ///< in this frame
  };
  /// A piece of a plane on which things rest, in two tones of squares.
  struct Floor {
    Float3 middle, x, y;  ///< of length 1 along the squares
    Float3 normal;
    Rgb color;
    float opacity;
    float from_x, from_y;  ///< where the middle is [squares]
    float reach;
    float squares;                           ///< in a unit
    bool level;                              ///< at the height of the ground, whose shadows fall on it
    std::shared_ptr<const Picture> picture;  ///< instead of squares, as wide as one; null: none
  };
  /// A soft disc of light; its color is as shown.
  struct Glow {
    Float3 at;
    float radius;
    Rgb color;
    float opacity;
  };
  /// A line of light along a velocity.
  struct Streak {
    Float3 head;
    float radius;
    Float3 tail;
    Rgb color;
    float opacity;
  };
  std::vector<Ball> balls;
  std::vector<Bar> bars;
  std::vector<Ellipsoid> ellipsoids;
  std::vector<Corner> corners;
  std::vector<Floor> floors;
  std::vector<Corner> shades;  ///< shadows of the ellipsoids, on the ground
  std::vector<Glow> glows;
  std::vector<Streak> streaks;
  std::vector<Sheet> sheets;
  Float3 lower, upper;  ///< box of all balls, bars, ellipsoids and corners

  /// The one of a picture, which there is from then on.
  Sheet& sheet_of(const std::shared_ptr<const Picture>& picture);
  /// Forgets what was to be drawn, and pictures that were not shown.
  void clear_sheets();
};

/// Fills a draw_list, of which one is kept so that nothing is allocated once it has grown.
class DrawListMaker {
 public:
  void draw(const World& world, const Camera& camera, const Stage& stage, const Overlay& overlay, int height,
            DrawList& draw_list);
  void clear() { figures_.clear(); }
  const Tints& tints() const { return tints_; }

 private:
  struct Eye;
  static void draw_figure(const Figure& figure, const Pose& pose, const Tint& tint, const Eye& eye, const Stage& stage,
                          DrawList& draw_list);
  static void draw_sheet(const Figure::Sheet& sheet, const Pose& pose, const Tint& tint, const Eye& eye,
                         const Stage& stage, DrawList& draw_list);
  static void draw_sprite(const World& world, const Cover& sprite, const Pose& pose, const Color& color,
                          std::uint32_t slot, const Eye& eye, DrawList& draw_list);
  void draw_body(const World& world, BodyId body, const Eye& eye, const Stage& stage, DrawList& draw_list);
  void draw_ground(const World& world, const Eye& eye, const Stage& stage, DrawList& draw_list);
  void draw_particles(const World& world, const Eye& eye, const Stage& stage, DrawList& draw_list);
  void draw_free(const World& world, std::uint32_t slot, Vec3 at, const Eye& eye, const Stage& stage,
                 DrawList& draw_list);
  static void draw_grab(const World& world, const Constraint& constraint, const Eye& eye, DrawList& draw_list);
  void draw_constraints(const World& world, const Eye& eye, const Stage& stage, DrawList& draw_list);
  void draw_connections(const World& world, const Eye& eye, const Stage& stage, DrawList& draw_list) const;
  void find_loads(const World& world, const Views& views, const Stage& stage);
  Rgb by_load(Rgb slack, double load) const;
  void draw_breaks(const World& world, const Eye& eye, const Stage& stage, double pace, DrawList& draw_list);

  Figures figures_;
  Appearance appearance_;
  Tints tints_;
  ConstraintLook look_;
  std::vector<double> loads_;  // [N] (slots of connections)
  double most_load_ = 0.0;     // [N] of all; 0: loads are not shown
  std::vector<float> joints_;  // [m] (slots of particles): what a hinge should exceed
};

/// What is to be added to a place [m] so that it shows where the periodic box has it; 0 in open space.
Vec3 image_shift(const World& world, Vec3 at);
/// Where a point is shown [m]; with its body, whose centre is in the box.
Vec3 shown_place(const World& world, PointId point);

/// Radius [m] at which a free particle, or a point of a body, is drawn.
double drawn_radius(const World& world, PointId point, const Stage& stage);

/// Direction to the key light, of length 1.
Vec3 key_light();

}  // namespace pantin
