#include "view/renderer.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

#include "base/check.hpp"
#include "view/draw_list.hpp"
#include "view/gl.hpp"
#include "view/panel.hpp"
#include "view/shadows.hpp"
#include "view/sheets.hpp"
#include "view/view_marks.hpp"

namespace pantin {

namespace {

constexpr int ground_corners = 24;
constexpr double trail_interval = 1.0 / 40.0;  // [s] at the scene's pace

struct Background {
  Vec3 high, low, grid, shade;  // sRGB
  float rim;                    // light that sets things off from it
};
const Background light_background = {vec(0.972, 0.953, 0.916), vec(0.885, 0.845, 0.775), vec(0.30, 0.235, 0.17),
                                     vec(0.30, 0.235, 0.17), 0.10f},
                 dark_background = {vec(0.105, 0.118, 0.145), vec(0.185, 0.205, 0.245), vec(0.62, 0.68, 0.78),
                                    vec(0.02, 0.025, 0.035), 0.9f};

const char* const light_definitions = "const float veil = 0.75;\n";

int pixels(int length, double scale) { return std::max(1, static_cast<int>(std::lround(length * scale))); }

Vec3 wide(float x, float y, float z) {
  return vec(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
}

std::string edge_definitions(int samples) {
  return text("const bool sampled = ", samples > 0 ? "true" : "false", ";\nconst int samples = ", samples, ";\n");
}

}  // namespace

struct Renderer::Parts {
  int width, height;
  double scale;
  int pixels_wide, pixels_high, samples;
  std::optional<Target> target;
  std::optional<Target> resolved;
  ShaderProgram ball, bar, ellipsoid, mesh, glow, streak, backdrop{"backdrop", {}, ""},
      grid{"grid", {"common.glsl", "fade.glsl"}, text("const float corners = ", ground_corners, ".0;\n")},
      floor{"floor", {"common.glsl", "picture.glsl"}, text("const float corners = ", ground_corners, ".0;\n")}, shade;
  FloatRows balls{{4, 4, 4}, true}, bars{{4, 4, 4}, true}, ellipsoids{{3, 3, 3, 3, 3, 4}, true},
      corners{{3, 3, 4}, false}, shades{{3, 3, 4}, false}, glows{{4, 4}, true}, streaks{{4, 3, 4}, true},
      nothing{{1}, false};
  Sheets sheets;
  Shadows shadows;
  Panel panel;
  DrawListMaker draw_list_maker;
  DrawList draw_list;
  Stage stage;
  Trails trails;
  ViewMarks view_marks;
  std::vector<Mark> marks;  // of the views
  std::vector<std::uint8_t> row;

  Parts(int w, int h, int samples_wanted, double scale_wanted)
      : width(w),
        height(h),
        scale(scale_wanted),
        pixels_wide(pixels(w, scale)),
        pixels_high(pixels(h, scale)),
        samples(samples_wanted),
        target(std::in_place, pixels_wide, pixels_high, samples_wanted, Target::Format::color, Target::Depth::kept),
        ball("ball", {"common.glsl", "edges.glsl", "opacity.glsl", "triangle.glsl"},
             edge_definitions(target->samples())),
        bar("bar", {"common.glsl", "edges.glsl", "opacity.glsl", "capsule.glsl"}, edge_definitions(target->samples())),
        ellipsoid("ellipsoid", {"common.glsl", "edges.glsl", "opacity.glsl", "stripes.glsl"},
                  edge_definitions(target->samples())),
        mesh("mesh", {"common.glsl", "opacity.glsl"}, edge_definitions(target->samples())),
        glow("glow", {"common.glsl"}, light_definitions),
        streak("streak", {"common.glsl"}, light_definitions),
        shade("shade", {"common.glsl", "fade.glsl", "shadow_maps.glsl"},
              text("const bool smooth_edges = ", target->samples() > 0 ? "true" : "false", ";\n")),
        sheets(edge_definitions(target->samples())),
        shadows(target->samples() > 0),
        panel(scale) {
    resolve_target();
  }

  void resolve_target() {
    resolved.reset();
    if (target->samples() > 0)
      resolved.emplace(pixels_wide, pixels_high, 0, Target::Format::color, Target::Depth::texture);
  }
  const Target& picture() const { return resolved ? *resolved : *target; }
  const Background& background(const Views& views) const {
    return views.on(View::dark) ? dark_background : light_background;
  }
  void collect_marks(const World& world, const Overlay& overlay);
  void draw_backdrop(const Background& colors);
  void draw_shadows(const Camera& camera, bool wanted);
  float ground_strength(const Camera& camera) const;
  void darken(const Camera& camera);
  void resolve(GLbitfield what);
  void draw_ground(const Camera& camera, const Background& colors);
  void draw_floors(const Camera& camera);
  void draw_things(const Camera& camera);
  void draw_lights(const Camera& camera);
  void set_camera(const ShaderProgram& program, const Camera& camera) const;

  float rim = 0.0f;
  bool shaded = false;
};

Renderer::Renderer(int width, int height, int samples, double scale) {
  require(width > 0 && height > 0, "a picture's size must be > 0 pixels, got ", width, " x ", height);
  require(std::isfinite(scale) && scale > 0.0, "a picture's pixels in each px must be > 0, got ", scale);
  parts_ = std::make_unique<Parts>(width, height, samples, scale);
}

Renderer::~Renderer() = default;

void Renderer::resize(int width, int height, double scale) {
  Parts& p = *parts_;
  if ((width == p.width && height == p.height && scale == p.scale) || width <= 0 || height <= 0) return;
  p.width = width;
  p.height = height;
  p.pixels_wide = pixels(width, scale);
  p.pixels_high = pixels(height, scale);
  if (scale != p.scale) p.panel.set_scale(p.scale = scale);
  p.target.emplace(p.pixels_wide, p.pixels_high, p.samples, Target::Format::color, Target::Depth::kept);
  p.resolve_target();
}

int Renderer::width() const { return parts_->width; }
int Renderer::height() const { return parts_->height; }
double Renderer::scale() const { return parts_->scale; }
int Renderer::pixels_wide() const { return parts_->pixels_wide; }
int Renderer::pixels_high() const { return parts_->pixels_high; }
const Stage& Renderer::stage() const { return parts_->stage; }
const std::string& Renderer::pressed_button() const { return parts_->panel.pressed(); }
bool Renderer::pointer_on_panel() const { return parts_->panel.under_pointer(); }
bool Renderer::writing() const { return parts_->panel.writing(); }
void Renderer::listen(Gestures& gestures) { parts_->panel.take(gestures); }

void Renderer::open(const World& world) {
  parts_->stage = find_stage(world);
  parts_->draw_list_maker.clear();
  parts_->trails.clear();
}

void Renderer::watch(const World& world, const Views& views, double pace) {
  if (views.on(View::trails))
    parts_->trails.note(world, trail_interval * pace);
  else
    parts_->trails.clear();
}

void Renderer::draw(const World& world, const Camera& camera, const Overlay& overlay) {
  Parts& p = *parts_;
  if (p.stage.empty) open(world);
  watch(world, overlay.views, overlay.pace);
  p.draw_list_maker.draw(world, camera, p.stage, overlay, p.height, p.draw_list);
  p.balls.send(p.draw_list.balls);
  p.bars.send(p.draw_list.bars);
  p.ellipsoids.send(p.draw_list.ellipsoids);
  p.corners.send(p.draw_list.corners);
  p.shades.send(p.draw_list.shades);
  p.glows.send(p.draw_list.glows);
  p.streaks.send(p.draw_list.streaks);
  p.sheets.send(p.draw_list.sheets);
  p.draw_shadows(camera, overlay.views.on(View::shadows));
  p.target->bind();
  const Background& colors = p.background(overlay.views);
  glClearColor(static_cast<float>(colors.low[0]), static_cast<float>(colors.low[1]), static_cast<float>(colors.low[2]),
               1.0f);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  p.rim = colors.rim;
  p.draw_backdrop(colors);
  p.draw_floors(camera);
  p.draw_ground(camera, colors);
  p.draw_things(camera);
  p.darken(camera);
  p.draw_lights(camera);
  if (p.resolved) {
    p.resolve(GL_COLOR_BUFFER_BIT);
    p.resolved->bind();
  }
  p.collect_marks(world, overlay);
  p.panel.draw(overlay, {p.marks, p.draw_list_maker.tints().legend(), p.view_marks.legend()}, camera, p.width,
               p.height);
}

void Renderer::Parts::collect_marks(const World& world, const Overlay& overlay) {
  marks.clear();
  if (overlay.views.on(View::trails)) trails.draw(world, stage, marks);
  view_marks.add(world, overlay.views, stage, overlay.pace, marks);
  if (world.points.alive(overlay.highlight)) add_highlight(world, overlay.highlight, marks);
}

void Renderer::Parts::set_camera(const ShaderProgram& program, const Camera& camera) const {
  const Eigen::Matrix4f projection = camera.projection(static_cast<double>(width) / height);
  program.use();
  program.set("camera", Eigen::Matrix4f(projection * camera.view()));
  program.set("backward", -camera.forward());
  program.set("depth_row", projection(2, 2), projection(2, 3));
  program.set("pixel", static_cast<float>(2.0 * std::tan(0.5 * camera.fov) / pixels_high));
  program.set("light", key_light());
  program.set("rim", rim);
}

void Renderer::Parts::draw_backdrop(const Background& colors) {
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  backdrop.use();
  backdrop.set("low", colors.low);
  backdrop.set("high", colors.high);
  nothing.draw(backdrop, GL_TRIANGLE_STRIP, 4);
}

void Renderer::Parts::draw_shadows(const Camera& camera, bool wanted) {
  shaded = wanted && draw_list.lower.x <= draw_list.upper.x;
  if (shaded)
    shaded = shadows.draw_maps({balls, bars, ellipsoids, corners, shades, sheets}, draw_list, stage, camera,
                               static_cast<double>(width) / height);
}

void Renderer::Parts::resolve(GLbitfield what) {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, target->framebuffer());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved->framebuffer());
  glBlitFramebuffer(0, 0, pixels_wide, pixels_high, 0, 0, pixels_wide, pixels_high, what, GL_NEAREST);
}

void Renderer::Parts::darken(const Camera& camera) {
  if (!shaded || !resolved || !shadows.shelters()) return;
  resolve(GL_DEPTH_BUFFER_BIT);
  shadows.darken(*target, *resolved, stage, camera, ground_strength(camera));
}

// A little behind where they are, so that shadows fall on them.
void Renderer::Parts::draw_floors(const Camera& camera) {
  if (draw_list.floors.empty()) return;
  set_camera(floor, camera);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_TRUE);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(1.0f, 4.0f);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  for (const DrawList::Floor& f : draw_list.floors) {
    floor.set("middle", wide(f.middle.x, f.middle.y, f.middle.z));
    floor.set("along_x", wide(f.x.x, f.x.y, f.x.z));
    floor.set("along_y", wide(f.y.x, f.y.y, f.y.z));
    floor.set("normal", wide(f.normal.x, f.normal.y, f.normal.z));
    floor.set("paint", wide(f.color.r, f.color.g, f.color.b));
    floor.set("opacity", f.opacity);
    floor.set("from", f.from_x, f.from_y);
    floor.set("squares", f.squares);
    floor.set("reach", f.reach);
    glDepthMask(f.opacity < 1.0f ? GL_FALSE : GL_TRUE);
    floor.set("aspect", f.picture ? sheets.bind(*f.picture) : 0.0f);
    nothing.draw(floor, GL_TRIANGLE_FAN, ground_corners);
  }
  glDepthMask(GL_TRUE);
  for (const int what : {GL_BLEND, GL_POLYGON_OFFSET_FILL, GL_DEPTH_TEST}) glDisable(static_cast<GLenum>(what));
}

// Faded where the eye is below it, and where the scene has fallen through it.
float Renderer::Parts::ground_strength(const Camera& camera) const {
  const float level = static_cast<float>((stage.ground - camera.eye()[1]) / camera.distance);
  const float size = static_cast<float>(stage.size / camera.distance);
  const float above = std::clamp(-level / (0.03f * size), 0.0f, 1.0f);
  const float fallen = draw_list.lower.x > draw_list.upper.x ? 0.0f : (level - draw_list.lower.y) / size;
  return above * std::clamp(1.0f - (fallen - 0.08f) / 0.25f, 0.0f, 1.0f);
}

void Renderer::Parts::draw_ground(const Camera& camera, const Background& colors) {
  const Vec3 eye = camera.eye(), middle = (stage.lower + stage.upper) * 0.5;
  const double unit = camera.distance, square = ground_square(stage);
  const float level = static_cast<float>((stage.ground - eye[1]) / unit), size = static_cast<float>(stage.size / unit);
  const float strength = ground_strength(camera);
  if (!(strength > 0.0f)) return;
  for (const ShaderProgram* program : {&shade, &grid}) {
    set_camera(*program, camera);
    program->set("level", level);
    program->set("middle", static_cast<float>((middle[0] - eye[0]) / unit),
                 static_cast<float>((middle[2] - eye[2]) / unit));
    program->set("reach", 2.2f * size);
    program->set("strength", strength);
  }
  grid.set("origin", static_cast<float>(std::fmod(eye[0] / square, 10.0)),
           static_cast<float>(std::fmod(eye[2] / square, 10.0)));
  grid.set("squares", static_cast<float>(unit / square));
  grid.set("ink", colors.grid);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  if (!draw_list.floors.empty()) glEnable(GL_DEPTH_TEST);  // some may be in front of it
  glDepthMask(GL_FALSE);
  if (shaded) {
    shadows.bind_maps(shade);
    shade.set("corners", shadows.region().corners);
    shade.set("dark", colors.shade);
    nothing.draw(shade, GL_TRIANGLE_STRIP, 4);
  }
  const bool squares =
      std::any_of(draw_list.floors.begin(), draw_list.floors.end(), [](const DrawList::Floor& f) { return f.level; });
  if (!squares) nothing.draw(grid, GL_TRIANGLE_FAN, ground_corners);
  glDisable(GL_BLEND);
  glDisable(GL_DEPTH_TEST);
  glDepthMask(GL_TRUE);
}

void Renderer::Parts::draw_things(const Camera& camera) {
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_TRUE);
  glDisable(GL_CULL_FACE);
  if (target->samples() > 0) {
    glEnable(GL_MULTISAMPLE);
    glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
  }
  for (const ShaderProgram* program : {&mesh, &ellipsoid, &ball, &bar}) set_camera(*program, camera);
  corners.draw(mesh, GL_TRIANGLES);
  ellipsoids.draw(ellipsoid, GL_TRIANGLE_STRIP, 4);
  balls.draw(ball, GL_TRIANGLES, 3);
  glEnable(GL_CULL_FACE);
  glCullFace(GL_FRONT);
  bars.draw(bar, GL_TRIANGLE_STRIP, 14);
  glDisable(GL_CULL_FACE);
  if (!sheets.empty()) sheets.draw([&](const ShaderProgram& program) { set_camera(program, camera); });
  glDisable(GL_SAMPLE_ALPHA_TO_COVERAGE);
  glDisable(GL_DEPTH_TEST);
}

// Soft things after the solid ones that may hide them; in the order of their slots, which stays from picture to picture.
void Renderer::Parts::draw_lights(const Camera& camera) {
  if (glows.count() == 0 && streaks.count() == 0) return;
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  for (const ShaderProgram* program : {&glow, &streak}) set_camera(*program, camera);
  glows.draw(glow, GL_TRIANGLE_STRIP, 4);
  streaks.draw(streak, GL_TRIANGLE_STRIP, 4);
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
  glDisable(GL_DEPTH_TEST);
}

std::vector<std::uint8_t> Renderer::read_pixels() {
  std::vector<std::uint8_t> pixels;
  read_pixels(pixels);
  return pixels;
}

void Renderer::read_pixels(std::vector<std::uint8_t>& into) {
  Parts& p = *parts_;
  const std::size_t line = 4u * static_cast<std::size_t>(p.pixels_wide), rows = static_cast<std::size_t>(p.pixels_high);
  into.resize(line * rows);
  p.row.resize(line);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, p.picture().framebuffer());
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, p.pixels_wide, p.pixels_high, GL_RGBA, GL_UNSIGNED_BYTE, into.data());
  for (std::size_t top = 0, bottom = rows - 1; top < bottom; top++, bottom--) {
    std::memcpy(p.row.data(), &into[top * line], line);
    std::memcpy(&into[top * line], &into[bottom * line], line);
    std::memcpy(&into[bottom * line], p.row.data(), line);
  }
  for (std::size_t i = 3; i < into.size(); i += 4) into[i] = 255;
}

void Renderer::show(int window_width, int window_height) {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, parts_->picture().framebuffer());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  glBlitFramebuffer(0, 0, parts_->pixels_wide, parts_->pixels_high, 0, 0, window_width, window_height,
                    GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

}  // namespace pantin
