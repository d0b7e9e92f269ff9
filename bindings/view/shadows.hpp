#pragma once
#include <optional>

#include "view/camera.hpp"
#include "view/draw_list.hpp"
#include "view/gl.hpp"
#include "view/shadow_region.hpp"
#include "view/sheets.hpp"
#include "view/stage.hpp"

namespace pantin {

/// What throws shadows.
struct Casters {
  const FloatRows &balls, &bars, &ellipsoids, &corners, &shades;
  const Sheets& sheets;
};

/// Soft shadows on the ground; and, for pictures, what shadows things throw on each other and how they hide the sky.
class Shadows {
 public:
  explicit Shadows(bool shelters);

  /// Draws the scene from the light onto maps of the ground, soft where it is high above it. False if no shadow is seen.
  bool draw_maps(const Casters& casters, const DrawList& draw_list, const Stage& stage, const Camera& camera,
                 double aspect);
  /// For a program that shows them.
  void bind_maps(const ShaderProgram& program) const;
  const ShadowRegion& region() const { return region_; }
  bool shelters() const { return shelter_.has_value(); }
  /// Darkens what was drawn into `picture`, as far as `depths` has it; `ground` is how much of it is there, 0 … 1.
  void darken(const Target& picture, const Target& depths, const Stage& stage, const Camera& camera, float ground);

 private:
  void draw_heights(const Casters& casters);

  Target map_;
  ShaderProgram ball_, bar_, mesh_, sprite_;
  struct Programs {
    Target heights;
    std::optional<Target> found, smoothed;  // half as many pixels a side
    ShaderProgram ball, bar, ellipsoid, mesh, shelter, smooth, sheltered;
    FloatRows nothing{{1}, false};
    Programs();
  };
  std::optional<Programs> shelter_;
  // Of the last ones: in units of the camera's distance, relative to the eye.
  ShadowRegion region_;
  float level_ = 0.0f;
};

}  // namespace pantin
