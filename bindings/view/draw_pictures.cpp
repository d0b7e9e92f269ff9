// What shows pictures: shapes, floors and sprites.
#include <cmath>
#include <utility>

#include "view/draw_eye.hpp"
#include "view/figure_pictures.hpp"

namespace pantin {

namespace {

constexpr double sprite_lift = 2e-5;  // [units] by which a sprite is before the one that was made before it
constexpr std::uint32_t sprite_lifts = 256;

// The picture's directions to the right and up, and towards who looks at it.
struct Upright {
  Vec3 right, up, normal;
};

Upright standing_in(int normal) {
  switch (normal) {
    case 0: return {vec(0, 0, -1), vec(0, 1, 0), vec(1, 0, 0)};
    case 1: return {vec(1, 0, 0), vec(0, 0, -1), vec(0, 1, 0)};
    default: return {vec(1, 0, 0), vec(0, 1, 0), vec(0, 0, 1)};
  }
}

}  // namespace

DrawList::Sheet& DrawList::sheet_of(const std::shared_ptr<const Picture>& picture) {
  for (Sheet& sheet : sheets) {
    if (sheet.picture != picture) continue;
    sheet.shown = true;
    return sheet;
  }
  return sheets.emplace_back(Sheet{picture, {}, {}, {}, {}, true});
}

void DrawList::clear_sheets() {
  std::erase_if(sheets, [](const Sheet& sheet) { return !sheet.shown; });
  for (Sheet& sheet : sheets) {
    sheet.corners.clear();
    sheet.sprites.clear();
    sheet.shades.clear();
    sheet.globes.clear();
    sheet.shown = false;
  }
}

void DrawListMaker::draw_sheet(const Figure::Sheet& sheet, const Pose& pose, const Tint& tint, const Eye& eye,
                               const Stage& stage, DrawList& draw_list) {
  DrawList::Sheet& to = draw_list.sheet_of(sheet.picture);
  for (const Figure::PictureCorner& c : sheet.corners) {
    to.corners.push_back(
        {eye.place(pose.to_world(c.at)), floats(pose.R * c.normal), linear(tint.of(c.color)), c.color.a, c.u, c.v});
    include(draw_list, to.corners.back().at, 0.0f);
  }
  for (const Figure::Globe& g : sheet.globes) {
    const Mat3 axes = pose.R * g.shape.axes;
    to.globes.push_back({eye.place(pose.to_world(g.shape.at)),
                         floats(axes[0] / eye.unit),
                         floats(axes[1] / eye.unit),
                         floats(axes[2] / eye.unit),
                         linear(tint.of(g.shape.color)),
                         {g.around, g.down, 0.0f},
                         g.shape.color.a});
    include(draw_list, to.globes.back().at, static_cast<float>(norm(axes[0]) / eye.unit));
    shade_ellipsoid(draw_list, to.globes.back(), static_cast<float>((stage.ground - eye.at[1]) / eye.unit));
  }
}

void DrawListMaker::draw_sprite(const World& world, const Cover& sprite, const Pose& pose, const Color& color,
                                std::uint32_t slot, const Eye& eye, DrawList& draw_list) {
  Upright way = {eye.right, eye.up, -eye.forward};
  if (world.plane.flat()) {
    way = standing_in(world.plane.normal);
    way.right = pose.R * way.right;
    way.up = pose.R * way.up;
    if (dot(way.normal, eye.forward) > 0.0) way.normal = -way.normal;
  }
  const Vec3 middle = pose.x + way.normal * (sprite_lift * (slot % sprite_lifts) * eye.unit);
  const PictureEdges e = edges_of(*sprite.picture);
  DrawList::Sheet& sheet = draw_list.sheet_of(sprite.picture);
  const auto add = [&](std::vector<DrawList::PictureCorner>& corners, const Upright& as) {
    const Vec3 half_right = as.right * (0.5 * sprite.width), half_up = as.up * (0.5 * height_of(sprite));
    const auto corner = [&](double right, double up) {
      corners.push_back({eye.place(middle + half_right * right + half_up * up),
                         {},
                         linear(color),
                         color.a,
                         right < 0.0 ? e.left : e.right,
                         up < 0.0 ? e.lower : e.upper});
      include(draw_list, corners.back().at, 0.0f);
    };
    corner(-1, -1), corner(1, -1), corner(1, 1);
    corner(-1, -1), corner(1, 1), corner(-1, 1);
  };
  add(sheet.sprites, way);
  add(sheet.shades,
      world.plane.flat() ? way : Upright{way.right, vec(0, 1, 0), way.normal});  // else of what stands upright
}

void cover_floor(DrawList& draw_list, DrawList::Floor& floor, const Cover& cover, Vec3 middle, const Mat3& axes,
                 double unit) {
  const double height = height_of(cover);
  floor.picture = draw_list.sheet_of(cover.picture).picture;
  floor.from_x = static_cast<float>(std::fmod(dot(middle, axes[0]) / cover.width, 1.0));
  floor.from_y = static_cast<float>(std::fmod(dot(middle, axes[1]) / height, 1.0));
  floor.squares = static_cast<float>(unit / cover.width);
}

}  // namespace pantin
