#include "view/draw_list.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "edit/edit.hpp"
#include "forces/curves.hpp"
#include "forces/forces.hpp"
#include "laws/run/sites.hpp"
#include "view/draw_eye.hpp"

namespace pantin {

namespace {

constexpr Color paper = {1.00f, 0.965f, 0.89f, 1.0f}, deep = {0.13f, 0.24f, 0.30f, 1.0f},
                iron = {0.25f, 0.27f, 0.30f, 1.0f}, grip = {0.85f, 0.20f, 0.26f, 1.0f},
                thread = {0.52f, 0.52f, 0.50f, 1.0f}, strut = {0.16f, 0.40f, 0.78f, 1.0f};

constexpr Color spark = {1.00f, 0.62f, 0.18f, 1.0f};

constexpr double least_pull = 1e-9;   // [units/s²] that a load could give all that moves, to be shown
constexpr double streak_time = 0.03;  // [s] of its flight that a streak shows
constexpr double break_time = 0.5;    // [s] for which a break is shown

/// [N] The largest force that a hinge exerts on a member.
double load_of(const World& world, const Particle& hinge) {
  double most = 0.0;
  for (const PointId point : hinge.points) most = std::fmax(most, norm(world.points[point].row_force));
  return most;
}

/// [kg] Of all that moves.
double mass_of(const World& world) {
  double sum = 0.0;
  const auto add = [&](double mass) { sum += std::isfinite(mass) ? mass : 0.0; };
  for (std::uint32_t s = 0; s < world.bodies.slots(); s++)
    if (world.bodies.alive_at(s)) add(world.motion[s].mass);
  for (std::uint32_t s = 0; s < world.points.slots(); s++)
    if (world.points.alive_at(s) && !world.points.at_slot(s).body) add(world.points.at_slot(s).mass);
  return sum;
}

}  // namespace

void shade_ellipsoid(DrawList& s, const DrawList::Ellipsoid& ellipsoid, float level) {
  constexpr int corners = 28;
  const Vec3 light = key_light();
  const float lx = static_cast<float>(light[0] / light[1]), lz = static_cast<float>(light[2] / light[1]);
  float xx = 0.0f, xz = 0.0f, zz = 0.0f;
  for (const Float3 a : {ellipsoid.x, ellipsoid.y, ellipsoid.z}) {
    const float px = a.x - lx * a.y, pz = a.z - lz * a.y;
    xx += px * px;
    xz += px * pz;
    zz += pz * pz;
  }
  const float l = std::sqrt(std::max(xx, 1e-30f)), m = xz / l, n = std::sqrt(std::max(zz - m * m, 0.0f));
  // Dark within, fading across its rim.
  const float high = std::max(ellipsoid.at.y - level, 0.0f),
              soft = std::min(0.9f, 0.08f + 0.10f * high / std::max(l, 1e-9f));
  const auto at = [&](float angle, float part, float dark) {
    dark *= ellipsoid.opacity;
    const float c = std::cos(angle) * part, d = std::sin(angle) * part;
    s.shades.push_back(
        {{ellipsoid.at.x + l * c, ellipsoid.at.y, ellipsoid.at.z + m * c + n * d}, {}, {dark, dark, dark}});
  };
  for (int i = 0; i < corners; i++) {
    const float a = 6.2831853f * static_cast<float>(i) / corners, b = 6.2831853f * static_cast<float>(i + 1) / corners;
    const float in = 1.0f - soft, out = 1.0f + soft;
    at(0.0f, 0.0f, 1.0f), at(a, in, 1.0f), at(b, in, 1.0f);
    at(a, in, 1.0f), at(a, out, 0.0f), at(b, in, 1.0f);
    at(b, in, 1.0f), at(a, out, 0.0f), at(b, out, 0.0f);
  }
}

Vec3 key_light() {
  static const Vec3 to_light = direction(vec(-0.42, 0.85, 0.38));
  return to_light;
}

Vec3 image_shift(const World& world, Vec3 at) {
  if (!world.settings.box || !finite(at)) return zero3();
  return Box{*world.settings.box}.wrapped(at) - at;
}

Vec3 shown_place(const World& world, PointId id) {
  const Vec3 at = position(world, id);
  const BodyId body = world.points[id].body;
  return at + image_shift(world, body ? world.motion_of(body).x : at);
}

double drawn_radius(const World& world, PointId id, const Stage& stage) {
  const Point& point = world.points[id];
  const Particle& particle = world.particles[point.particle];
  const double given = particle.radius.value_or(point.radius);
  return given > 0.0 && given < stage.size ? given : 0.1 * stage.unit;
}

void DrawListMaker::draw(const World& world, const Camera& camera, const Stage& stage, const Overlay& overlay,
                         int height, DrawList& draw_list) {
  draw_list.balls.clear();
  draw_list.bars.clear();
  draw_list.ellipsoids.clear();
  draw_list.corners.clear();
  draw_list.floors.clear();
  draw_list.shades.clear();
  draw_list.glows.clear();
  draw_list.streaks.clear();
  draw_list.lower = {1e30f, 1e30f, 1e30f};
  draw_list.upper = {-1e30f, -1e30f, -1e30f};
  const Eye eye{camera.eye(), camera.forward(), camera.right(),
                camera.up(),  camera.distance,  2.0 * std::tan(0.5 * camera.fov) / height};
  draw_list.clear_sheets();
  joints_.assign(world.particles.slots(), 0.0f);
  tints_.update(world, overlay.views, stage.size);
  find_loads(world, overlay.views, stage);
  if (overlay.views.on(View::bodies)) {
    for (std::uint32_t s = 0; s < world.bodies.slots(); s++)
      if (world.bodies.alive_at(s)) draw_body(world, world.bodies.id_at(s), eye, stage, draw_list);
    draw_ground(world, eye, stage, draw_list);
    draw_particles(world, eye, stage, draw_list);
  }
  draw_constraints(world, eye, stage, draw_list);
  draw_connections(world, eye, stage, draw_list);
  draw_breaks(world, eye, stage, overlay.pace, draw_list);
}

void DrawListMaker::draw_figure(const Figure& figure, const Pose& pose, const Tint& tint, const Eye& eye,
                                const Stage& stage, DrawList& draw_list) {
  const auto shown = [&](const Color& color) { return linear(tint.of(color)); };
  for (const Figure::Bar& b : figure.bars) {
    const Vec3 from = pose.to_world(b.from), to = pose.to_world(b.to);
    eye.bar(draw_list, from, to, b.radius, std::clamp(0.1 * norm(to - from) / eye.pixel_at(from), 0.8, 2.4),
            shown(b.color), false, b.color.a);
  }
  for (const Figure::Ball& b : figure.balls)
    eye.ball(draw_list, pose.to_world(b.at), b.radius, 1.0, shown(b.color), DrawList::plain, {}, b.color.a);
  for (const Figure::Ellipsoid& e : figure.ellipsoids) {
    const Mat3 axes = pose.R * e.axes;
    const Rgb color = shown(e.color), light = mix(color, linear(paper), 0.75f);
    const Float3 at = eye.place(pose.to_world(e.at));
    draw_list.ellipsoids.push_back({at, floats(axes[0] / eye.unit), floats(axes[1] / eye.unit),
                                    floats(axes[2] / eye.unit), color, light, e.color.a});
    const double most = std::max({norm(axes[0]), norm(axes[1]), norm(axes[2])});
    include(draw_list, at, static_cast<float>(most / eye.unit));
    shade_ellipsoid(draw_list, draw_list.ellipsoids.back(), static_cast<float>((stage.ground - eye.at[1]) / eye.unit));
  }
  for (const Figure::Corner& c : figure.corners) {
    draw_list.corners.push_back({eye.place(pose.to_world(c.at)), floats(pose.R * c.normal), shown(c.color), c.color.a});
    include(draw_list, draw_list.corners.back().at, 0.0f);
  }
  for (const Figure::Sheet& sheet : figure.sheets) draw_sheet(sheet, pose, tint, eye, stage, draw_list);
}

/// The world's shapes.
void DrawListMaker::draw_ground(const World& world, const Eye& eye, const Stage& stage, DrawList& draw_list) {
  const double square = ground_square(stage);
  for (std::uint32_t s = 0; s < world.shapes.slots(); s++) {
    if (!world.shapes.alive_at(s) || world.shapes.at_slot(s).body) continue;
    const Shape& shape = world.shapes.at_slot(s);
    const ShapeId id = world.shapes.id_at(s);
    if (!std::holds_alternative<HalfSpaceShape>(shape.geometry)) {
      draw_figure(figures_.of(world, id), {}, {}, eye, stage, draw_list);
      continue;
    }
    const Floor floor = floor_seen(world, id, stage, eye.at + eye.forward * eye.unit, eye.unit);
    const Mat3 axes = matrix(shape.orientation);
    if (dot(axes[2], eye.at - floor.middle) <= 0.0) continue;
    const auto from = [&](Vec3 axis) { return static_cast<float>(std::fmod(dot(floor.middle, axis) / square, 2.0)); };
    const bool level = axes[2][1] > 1.0 - 1e-9 && std::fabs(floor.middle[1] - stage.ground) <= 1e-6 * stage.size;
    draw_list.floors.push_back({eye.place(floor.middle), floats(axes[0]), floats(axes[1]), floats(axes[2]),
                                linear(shape.color), shape.color.a, from(axes[0]), from(axes[1]),
                                static_cast<float>(floor.reach / eye.unit), static_cast<float>(eye.unit / square),
                                level, nullptr});
    if (shape.cover) cover_floor(draw_list, draw_list.floors.back(), *shape.cover, floor.middle, axes, eye.unit);
  }
}

void DrawListMaker::draw_body(const World& world, BodyId id, const Eye& eye, const Stage& stage, DrawList& draw_list) {
  const Figure& figure = figures_.of(world, id, stage);
  const Vec3 at = origin(world, id) + image_shift(world, world.motion_of(id).x);
  const Mat3 turn = matrix(orientation(world, id));
  if (!finite(at)) return;
  const Tint tint = tints_.of_body(id.slot - 1);
  if (figure.sprite)
    draw_sprite(world, *figure.sprite, {at, turn}, tint.of(untinted), id.slot, eye, draw_list);
  else
    draw_figure(figure, {at, turn}, tint, eye, stage, draw_list);
  const std::vector<PointId>& points = world.bodies[id].points;
  for (std::size_t i = 0; i < points.size(); i++) {
    float& joint = joints_[world.points[points[i]].particle.slot - 1];
    joint = std::max(joint, static_cast<float>(figure.joints[i] / stage.unit));
  }
}

void DrawListMaker::draw_particles(const World& world, const Eye& eye, const Stage& stage, DrawList& draw_list) {
  const Rgb dark = linear(deep);
  appearance_.update(world);
  for (std::uint32_t s = 0; s < world.particles.slots(); s++) {
    const Particle& particle = world.particles.at_slot(s);
    if (!world.particles.alive_at(s) || particle.asleep_in || particle.points.empty()) continue;
    const Point& first = world.points[particle.points[0]];
    if (!particle.is_hinge() && first.body) continue;
    const Vec3 place = position(world, world.particles.id_at(s)), at = place + image_shift(world, place);
    if (!finite(at)) continue;
    if (!particle.is_hinge()) {
      draw_free(world, s, at, eye, stage, draw_list);
      continue;
    }
    const double joint = joints_[s] > 0.0f ? static_cast<double>(joints_[s]) * stage.unit : 0.05 * stage.unit;
    const double given = particle.radius.value_or(0.0), pixel = eye.pixel_at(at);
    const double radius = given > 0.0 ? given : 1.45 * joint;
    if (radius < 0.5 * pixel) continue;
    // A colour that is not just its first point's was meant.
    const bool own = particle.color && !(*particle.color == first.color);
    const Color shown = tints_.of_particle(s).of(own ? *particle.color : paper);
    eye.ball(draw_list, at, radius, std::min(3.8, 2.2 * joint / pixel), linear(shown), DrawList::hinge,
             by_load(dark, load_of(world, particle)), shown.a);
  }
}

/// A free particle, as its look says.
void DrawListMaker::draw_free(const World& world, std::uint32_t slot, Vec3 at, const Eye& eye, const Stage& stage,
                              DrawList& draw_list) {
  const Particle& particle = world.particles.at_slot(slot);
  const PointId point = particle.points[0];
  Color color = appearance_.color(slot).value_or(particle.color.value_or(world.points[point].color));
  const Cover* sprite = particle.family ? world.families[particle.family].sprite.get() : nullptr;
  if (sprite && color == ParticleDef::usual_color) color = untinted;
  color = tints_.of_particle(slot).of(color);
  if (sprite) return draw_sprite(world, *sprite, {at, identity33()}, color, slot, eye, draw_list);
  const auto followed = appearance_.radius(slot);
  if (followed && !(*followed > 0.0)) return;
  const double radius = followed ? *followed : drawn_radius(world, point, stage);
  const Look look = look_of(world, particle);
  if (look == Look::ball) return eye.ball(draw_list, at, radius, 1.0, linear(color), DrawList::plain, {}, color.a);
  // What is thinner than a pixel is drawn as wide as one, and fainter.
  const double pixel = eye.pixel_at(at), least = std::max(radius, (look == Look::glow ? 1.2 : 0.8) * pixel);
  const double fainter = look == Look::glow ? (radius / least) * (radius / least) : radius / least;
  const float opacity = color.a * static_cast<float>(fainter);
  if (!(opacity > 0.002f)) return;
  const Rgb shown = {color.r, color.g, color.b};
  const auto width = static_cast<float>(least / eye.unit);
  if (look == Look::glow) return draw_list.glows.push_back({eye.place(at), width, shown, opacity});
  Vec3 trail = velocity(world, point) * streak_time;
  if (const double length = norm(trail); length > 0.25 * stage.size) trail *= 0.25 * stage.size / length;
  draw_list.streaks.push_back({eye.place(at), width, eye.place(at - trail), shown, opacity});
}

/// What a hand holds by: redder the harder it pulls.
void DrawListMaker::draw_grab(const World& world, const Constraint& c, const Eye& eye, DrawList& draw_list) {
  const Vec3 a = shown_place(world, c.a), place = c.position.now + (a - position(world, c.a));
  const double pull = std::isfinite(c.max_force) && c.max_force > 0.0 ? norm(c.force) / c.max_force : 0.5;
  const double width = 1.2 + 2.3 * std::clamp(std::sqrt(pull), 0.0, 1.0);  // [px]
  if (!finite(a)) return;
  eye.bar(draw_list, a, place, 0.0, width, linear(grip), true);
  eye.ball(draw_list, place, 0.0, 5.5, linear(grip), DrawList::plain, {});
}

void DrawListMaker::draw_constraints(const World& world, const Eye& eye, const Stage& stage, DrawList& draw_list) {
  const Rgb metal = linear(iron);
  for (std::uint32_t s = 0; s < world.constraints.slots(); s++) {
    const Constraint& c = world.constraints.at_slot(s);
    if (!world.constraints.alive_at(s) || !c.enabled) continue;
    if (c.hand >= 0) draw_grab(world, c, eye, draw_list);
    find_look(world, c, stage, look_);
    for (const ConstraintLook::Line& l : look_.lines) {
      const Rgb color = linear(l.metal ? iron : thread);
      eye.bar(draw_list, l.from, l.to, l.radius, l.least, l.loaded ? by_load(color, c.tension) : color);
    }
    for (const ConstraintLook::Knob& k : look_.knobs) {
      double radius = k.radius, least = 2.5;  // [px]
      if (k.joints > 0.0) {
        const double joint =
            std::max(static_cast<double>(joints_[world.points[c.a].particle.slot - 1]), 0.04) * stage.unit;
        radius = k.joints * joint;
        least = std::min(4.5, 3.2 * joint / eye.pixel_at(shown_place(world, c.a)));
      }
      eye.ball(draw_list, k.at, radius, least, metal, DrawList::hinge, mix(metal, linear(grip), k.red ? 0.6f : 0.0f));
    }
  }
}

namespace {

/// In a periodic box the images nearest to each other, the first in the box.
std::array<Vec3, 2> shown_ends(const World& world, Vec3 a, Vec3 b) {
  if (!world.settings.box) return {a, b};
  const Vec3 from = a + image_shift(world, a);
  return {from, from + Box{*world.settings.box}.nearest(b - a)};
}

}  // namespace

/// Loads of connections, and the largest of all that ties things.
void DrawListMaker::find_loads(const World& world, const Views& views, const Stage& stage) {
  most_load_ = 0.0;
  loads_.assign(world.connections.slots(), 0.0);
  if (!views.on(View::loads)) return;
  const auto count = [&](double load) {
    if (std::isfinite(load)) most_load_ = std::fmax(most_load_, std::fabs(load));
  };
  for (std::uint32_t s = 0; s < world.connections.slots(); s++) {
    if (!world.connections.alive_at(s)) continue;
    loads_[s] = tension(world, world.connections.id_at(s));
    count(loads_[s]);
  }
  for (std::uint32_t s = 0; s < world.constraints.slots(); s++)
    if (world.constraints.alive_at(s)) count(world.constraints.at_slot(s).tension);
  for (std::uint32_t s = 0; s < world.particles.slots(); s++)
    if (world.particles.alive_at(s) && world.particles.at_slot(s).is_hinge())
      count(load_of(world, world.particles.at_slot(s)));
  if (most_load_ < least_pull * mass_of(world) * stage.unit) most_load_ = 0.0;  // rounding
}

/// Red where it pulls, blue where it pushes.
Rgb DrawListMaker::by_load(Rgb slack, double load) const {
  if (!(most_load_ > 0.0) || !std::isfinite(load)) return slack;
  return mix(slack, linear(load > 0.0 ? grip : strut), static_cast<float>(std::sqrt(std::fabs(load) / most_load_)));
}

/// Pairs that a law ties.
void DrawListMaker::draw_connections(const World& world, const Eye& eye, const Stage& stage,
                                     DrawList& draw_list) const {
  const Rgb slack = linear(thread);
  for (std::uint32_t s = 0; s < world.connections.slots(); s++) {
    const Connection& c = world.connections.at_slot(s);
    if (!world.connections.alive_at(s) || !c.enabled || c.count != 2) continue;
    const auto [a, b] = shown_ends(world, end_of(world, c, 0), end_of(world, c, 1));
    if (!finite(a) || !finite(b)) continue;
    eye.bar(draw_list, a, b, 0.012 * std::min(norm(b - a), stage.unit), 0.6, by_load(slack, loads_[s]));
  }
}

/// What has just broken: its ends shrink back from a flash between them.
void DrawListMaker::draw_breaks(const World& world, const Eye& eye, const Stage& stage, double pace,
                                DrawList& draw_list) {
  for (const Break& broken : world.breaks) {
    const double past = (world.time - broken.time) / (break_time * pace);
    const auto [a, b] = shown_ends(world, broken.from, broken.to);
    if (!(past >= 0.0 && past < 1.0) || !finite(a) || !finite(b)) continue;
    const Vec3 middle = 0.5 * (a + b);
    const auto left = static_cast<float>(1.0 - past);
    const double width = std::max(0.02 * std::min(norm(b - a), stage.unit), 1.5 * eye.pixel_at(middle));
    for (const Vec3 end : {a, b}) {
      const Vec3 tip = middle + (end - middle) * past;
      draw_list.streaks.push_back(
          {eye.place(end), static_cast<float>(width / eye.unit), eye.place(tip), {grip.r, grip.g, grip.b}, left});
    }
    const double flash = std::max(0.6 * std::min(norm(b - a), stage.unit), 7.0 * eye.pixel_at(middle));
    draw_list.glows.push_back(
        {eye.place(middle), static_cast<float>(flash / eye.unit), {spark.r, spark.g, spark.b}, left * left});
  }
}

}  // namespace pantin
