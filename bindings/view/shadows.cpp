#include "view/shadows.hpp"

#include <cmath>

namespace pantin {

namespace {

constexpr int height_pixels = 1024;  // of the map of heights, a side

/// Of the finest map, see shadow_maps.glsl.
int map_pixels(bool shelters) { return shelters ? 512 : 352; }

Vec3 vector(Float3 v) { return vec(static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)); }

}  // namespace

Shadows::Programs::Programs()
    : heights(height_pixels, height_pixels, 0, Target::Format::height),
      ball("height_ball", {"shadow_maps.glsl", "height.glsl", "triangle.glsl"}, ""),
      bar("height_bar", {"shadow_maps.glsl", "height.glsl", "capsule.glsl"}, ""),
      ellipsoid("height_ellipsoid", {"shadow_maps.glsl", "height.glsl"}, ""),
      mesh("height_mesh", {"shadow_maps.glsl", "height.glsl"}, ""),
      shelter("shelter", {"shadow_maps.glsl", "height.glsl"}, ""),
      smooth("smooth", {}, ""),
      sheltered("sheltered", {}, "") {}

Shadows::Shadows(bool shelters)
    : map_(map_pixels(shelters) * 3 / 2, map_pixels(shelters), 0, Target::Format::shade),
      ball_("shadow_ball", {"shadow_maps.glsl", "shadow.glsl", "triangle.glsl"}, ""),
      bar_("shadow_bar", {"shadow_maps.glsl", "shadow.glsl"}, ""),
      mesh_("shadow_mesh", {"shadow_maps.glsl", "shadow.glsl"}, ""),
      sprite_("shadow_sprite", {"shadow_maps.glsl", "shadow.glsl"}, "") {
  if (shelters) shelter_.emplace();
}

bool Shadows::draw_maps(const Casters& casters, const DrawList& draw_list, const Stage& stage, const Camera& camera,
                        double aspect) {
  level_ = static_cast<float>((stage.ground - camera.eye()[1]) / camera.distance);
  const Vec3 light = key_light();
  region_ = find_shadow_region(vector(draw_list.lower), vector(draw_list.upper), static_cast<double>(level_),
                               {light[0] / light[1], light[2] / light[1]}, camera, aspect);
  if (region_.empty) return false;
  map_.bind();
  glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  glClear(GL_COLOR_BUFFER_BIT);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendEquation(GL_MAX);
  for (const ShaderProgram* program : {&ball_, &bar_, &mesh_, &sprite_}) {
    bind_maps(*program);
    program->set("size", static_cast<float>(stage.size / camera.distance));
    program->set("pixels", static_cast<float>(map_.height()));
  }
  for (GLenum side = 0; side < 4; side++) glEnable(GL_CLIP_DISTANCE0 + side);
  mesh_.use();
  mesh_.set("solid", 1.0f);
  casters.corners.draw(mesh_, GL_TRIANGLES);
  casters.sheets.draw_shadows(mesh_);
  mesh_.set("solid", 0.0f);
  casters.shades.draw(mesh_, GL_TRIANGLES);
  casters.balls.draw(ball_, GL_TRIANGLES, 3);
  casters.bars.draw(bar_, GL_TRIANGLE_STRIP, 4);
  casters.sheets.draw_sprite_shadows(sprite_);
  for (GLenum side = 0; side < 4; side++) glDisable(GL_CLIP_DISTANCE0 + side);
  if (shelter_) draw_heights(casters);
  glBlendEquation(GL_FUNC_ADD);
  return true;
}

void Shadows::bind_maps(const ShaderProgram& program) const {
  program.use();
  program.set("shadow", 0);
  program.set("to_map", region_.to_map);
  program.set("widths", 2.0f * region_.along, 2.0f * region_.across);
  program.set("level", level_);
  program.set("light", key_light());
  map_.bind_texture(0);
}

void Shadows::draw_heights(const Casters& casters) {
  const Programs& s = *shelter_;
  s.heights.bind();
  glClearColor(-1e9f, 0.0f, 0.0f, 0.0f);
  glClear(GL_COLOR_BUFFER_BIT);
  for (const ShaderProgram* program : {&s.ball, &s.bar, &s.ellipsoid, &s.mesh}) bind_maps(*program);
  casters.corners.draw(s.mesh, GL_TRIANGLES);
  casters.sheets.draw_shadows(s.mesh);
  casters.balls.draw(s.ball, GL_TRIANGLES, 3);
  casters.ellipsoids.draw(s.ellipsoid, GL_TRIANGLE_STRIP, 4);
  casters.sheets.draw_globes(s.ellipsoid);
  casters.bars.draw(s.bar, GL_TRIANGLE_STRIP, 4);
}

void Shadows::darken(const Target& picture, const Target& depths, const Stage& stage, const Camera& camera,
                     float ground) {
  Programs& s = *shelter_;
  if (!s.shelter.usable() || !s.smooth.usable() || !s.sheltered.usable()) return;
  const int wide = (picture.width() + 1) / 2, tall = (picture.height() + 1) / 2;
  if (!s.found || s.found->width() != wide || s.found->height() != tall) {
    s.found.emplace(wide, tall, 0, Target::Format::shelter);
    s.smoothed.emplace(wide, tall, 0, Target::Format::shelter);
  }
  const double aspect = static_cast<double>(picture.width()) / picture.height(), slope = std::tan(0.5 * camera.fov);
  const Eigen::Matrix4f projection = camera.projection(aspect);
  const float near_by = static_cast<float>(0.5 * stage.unit / camera.distance);
  for (const int what : {GL_BLEND, GL_DEPTH_TEST, GL_CULL_FACE}) glDisable(static_cast<GLenum>(what));
  s.found->bind();
  bind_maps(s.shelter);
  s.shelter.set("depth", 0);
  s.shelter.set("heights", 1);
  s.shelter.set("depth_row", projection(2, 2), projection(2, 3));
  s.shelter.set("slopes", static_cast<float>(slope * aspect), static_cast<float>(slope));
  s.shelter.set("turn", camera.view());
  s.shelter.set("near_by", near_by);
  s.shelter.set("ground", ground);
  depths.bind_depths(0);
  s.heights.bind_texture(1);
  s.nothing.draw(s.shelter, GL_TRIANGLE_STRIP, 4);
  s.smoothed->bind();
  s.smooth.use();
  s.smooth.set("near_by", near_by);
  s.found->bind_texture(0);
  s.nothing.draw(s.smooth, GL_TRIANGLE_STRIP, 4);
  picture.bind();
  s.sheltered.use();
  s.sheltered.set("depth", 1);
  s.sheltered.set("depth_row", projection(2, 2), projection(2, 3));
  s.sheltered.set("near_by", near_by);
  s.smoothed->bind_texture(0);
  depths.bind_depths(1);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ZERO, GL_SRC_COLOR);
  s.nothing.draw(s.sheltered, GL_TRIANGLE_STRIP, 4);
  glDisable(GL_BLEND);
}

}  // namespace pantin
