#include "view/tool_use.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>

#include "choreography/commands.hpp"
#include "contacts/find.hpp"
#include "edit/assemble.hpp"
#include "structures/polyhedra.hpp"
#include "view/draw_list.hpp"
#include "view/pick.hpp"
#include "view/stroke.hpp"

namespace pantin {

namespace {

constexpr double click_distance = 5.0;  // [px] a press that moves less is a click
constexpr double push_time = 60.0;      // [steps] in which what is pushed comes as far as it was dragged
constexpr std::size_t longest_trail = 16;
constexpr double heat_rate = 3.0;  // [1/s] of the energy there, that a hand adds or takes

double step_times(const World& world, double steps) { return steps * world.settings.step; }

std::string counted(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

const char* kind_of(const World& world, const AnyId& thing, bool many) {
  if (std::holds_alternative<ParticleId>(thing)) return many ? "hinges" : "hinge";
  if (std::holds_alternative<ConnectionId>(thing)) return many ? "connections" : "connection";
  const auto* id = std::get_if<ConstraintId>(&thing);
  const ConstraintDrawing& drawing =
      id && world.constraints.alive(*id) ? drawing_of(world.constraints[*id]) : ConstraintDrawing{};
  return many ? drawing.many : drawing.one;
}

/// "cut 3 hinges", "cut 2 ties" of several kinds.
std::string cut_story(const World& world, const std::vector<AnyId>& things) {
  const char* const first = kind_of(world, things[0], true);
  const bool alike = std::ranges::all_of(things, [&](const AnyId& t) { return kind_of(world, t, true) == first; });
  if (!alike) return "cut " + counted(things.size(), "tie", "ties");
  return "cut " + counted(things.size(), kind_of(world, things[0], false), first);
}

/// What a usual thing of the scene weighs [kg].
double usual_mass(const World& world) {
  const Things all = everything(world);
  const std::size_t count = all.bodies.size() + all.free_points.size();
  const double mean = count > 0 ? mass(world, all) / static_cast<double>(count) : 1.0;
  return mean > 0.0 && std::isfinite(mean) ? mean : 1.0;
}

/// A place at the height at which things are, in the plane of the world if it has one.
std::optional<Vec3> usual_height(const World& world) {
  const Things all = everything(world);
  if (!all.bodies.empty()) return world.motion_of(all.bodies[0]).x;
  if (!all.free_points.empty()) return position(world, all.free_points[0]);
  return {};
}

enum Makes : std::size_t { rod, ball, box, wheel, tetrahedron, octahedron, dodecahedron };
enum Joins : std::size_t { hinge };
enum Spins : std::size_t { once, motor };

std::vector<Vec3> vertices_of(std::size_t variant) {
  switch (variant) {
    case tetrahedron: return shapes::tetrahedron(1.0).vertices;
    case octahedron: return shapes::octahedron(1.0).vertices;
    case dodecahedron: return shapes::dodecahedron(1.0).vertices;
    default: return shapes::icosahedron(1.0).vertices;
  }
}

/// What is built by hand has numbers that can be read: to some hundredth of the unit, a power of ten [m].
double round_step(double unit) { return std::pow(10.0, std::floor(std::log10(0.02 * unit))); }
Vec3 rounded(Vec3 x, double step) {
  const double per_step = std::round(1.0 / step);
  for (int i = 0; i < 3; i++)
    x[i] = step < 1.0 ? std::round(x[i] * per_step) / per_step : std::round(x[i] / step) * step;
  return x;
}

/// [m] Where a pixel's line meets the plane of a world that has one.
std::optional<double> depth_of_plane(const Viewport& viewport, double x, double y) {
  const int normal = viewport.world.plane.normal;
  if (normal < 0) return {};
  const Vec3 near = viewport.place(x, y, 1.0), far = viewport.place(x, y, 2.0);
  const double height = usual_height(viewport.world).value_or(zero3())[normal];
  const double depth = 1.0 + (height - near[normal]) / (far[normal] - near[normal]);
  return std::isfinite(depth) && depth > 0.0 ? std::optional(depth) : std::nullopt;
}

/// [m] What a pixel shows of the plane, or else of that depth.
Vec3 place_shown(const Viewport& viewport, double x, double y, double depth) {
  return viewport.place(x, y, depth_of_plane(viewport, x, y).value_or(depth));
}

std::vector<Vec3> corners_of(Vec3 half) {
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; i++) corners.push_back(half * vec(i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0));
  return corners;
}

/// Half the edges of a box that is dragged from corner to corner: as deep as it is narrow.
Vec3 half_of_box(Vec3 way, double least) {
  Vec3 half = 0.5 * vec(std::fabs(way[0]), std::fabs(way[1]), std::fabs(way[2]));
  int depth = 0;
  for (int i = 1; i < 3; i++)
    if (half[i] < half[depth]) depth = i;
  const double a = std::fmax(half[(depth + 1) % 3], least), b = std::fmax(half[(depth + 2) % 3], least);
  half[(depth + 1) % 3] = a;
  half[(depth + 2) % 3] = b;
  half[depth] = std::fmin(a, b);
  return half;
}

/// [m] How far a body's shapes are from a place along a direction, either way; no body: 0.
double half_width(const World& world, BodyId body, Vec3 at, Vec3 along) {
  double most = 0.0;
  if (!body) return most;
  for (const ShapeId id : world.bodies[body].shapes) {
    const Bounds box = bounds_of(world.shapes[id].geometry, pose_of(world, world.shapes[id]));
    most = std::max({most, dot(box.high - at, along), dot(at - box.low, along)});
  }
  return most;
}

/// Across the plane, or along the axis of the ground that is seen along most.
Vec3 axle_of(const Viewport& viewport) {
  if (viewport.world.plane.flat()) return viewport.world.plane.about(vec(1, 1, 1));
  const Vec3 along = viewport.camera.forward();
  return std::fabs(along[0]) > std::fabs(along[2]) ? vec(1, 0, 0) : vec(0, 0, 1);
}

}  // namespace

std::string short_number(double value) {
  char text[32];
  const double size = std::fabs(value);
  const bool plain = size >= 1e-3 && size < 1e6;
  const int digits = size >= 100.0 ? 0 : size >= 10.0 ? 1 : size >= 1.0 ? 2 : 3;
  std::snprintf(text, sizeof text, plain || size == 0.0 ? "%.*f" : "%.*e", plain ? digits : size == 0.0 ? 0 : 2, value);
  return text;
}

double heat_radius(const Viewport& viewport, double depth) {
  return depth * std::tan(0.5 * viewport.camera.fov) * 2.0 / 15.0;
}

void ToolUse::press(const Viewport& viewport, ToolChoice choice, std::int32_t hand, double x, double y,
                    ToolOutput& output) {
  *this = {};
  choice_ = choice;
  hand_ = hand;
  active_ = true;
  x0_ = x_ = x;
  y0_ = y_ = y;
  const Held held = pick_held(viewport, x, y);
  point_ = held.point;
  body_ = held.body;
  depth_ = dot(viewport.camera.target - viewport.camera.eye(), viewport.camera.forward());
  const auto seen = held ? viewport.project(shown_place(viewport.world, held)) : std::nullopt;
  if (seen) {
    depth_ = seen->depth;
    if (body_)
      on_body_ = rotate(conjugate(orientation(viewport.world, body_)), held.at - origin(viewport.world, body_));
    offset_ = start(viewport) - viewport.place(x, y, depth_);
  } else {
    point_ = {};
    body_ = {};
    if (const auto depth = depth_of_plane(viewport, x, y)) depth_ = *depth;
  }
  switch (choice.kind) {
    case ToolKind::drag: return grab(viewport, output);
    case ToolKind::cut: return cut(viewport, x, y, output);
    case ToolKind::nail: return nail(viewport, output);
    case ToolKind::remove: return remove(viewport, output);
    case ToolKind::join:
      if (!point_ && !body_) output.said.push_back("join: begin at a thing, and let go at another");
      break;
    case ToolKind::push:
    case ToolKind::spin:
      if (!point_ && !body_)
        output.said.push_back(std::string(choice.tool().name) + ": there is nothing under the cursor");
      break;
    default: break;
  }
}

void ToolUse::move(const Viewport& viewport, double x, double y, ToolOutput& output) {
  if (!active_) return;
  if (choice_.kind == ToolKind::cut) cut(viewport, x, y, output);
  x_ = x;
  y_ = y;
  if (trail_.size() == longest_trail) trail_.erase(trail_.begin());
  trail_.push_back(vec(x, y, 0));
  if (choice_.kind == ToolKind::remove) remove(viewport, output);
}

void ToolUse::hold(const Viewport& viewport, double time, ToolOutput& output) {
  if (!active_) return;
  if (point_ && !viewport.world.points.alive(point_)) point_ = {};
  if (body_ && !viewport.world.bodies.alive(body_)) body_ = {};
  if (body_ && choice_.kind == ToolKind::drag) take_point(viewport.world);
  if (choice_.kind != ToolKind::heat) return;
  Command c = command(Command::Kind::heat);
  const Held under = pick_held(viewport, x_, y_);
  if (const auto seen = under ? viewport.project(shown_place(viewport.world, under)) : std::nullopt)
    depth_ = seen->depth;
  c.position = viewport.place(x_, y_, depth_);
  c.radius = heat_radius(viewport, depth_);
  const Things things = heated_by(viewport.world, c.position, c.radius);
  if (things.bodies.empty() && things.free_points.empty()) return;
  const double there = heat_in(viewport.world, things),
               cold = 0.05 * viewport.stage.unit / step_times(viewport.world, 240.0);
  const double part = std::min(0.5, heat_rate * time);
  c.energy = choice_.variant == 1 ? -part * there : part * std::max(there, mass(viewport.world, things) * cold * cold);
  if (c.energy != 0.0) send(c, output);
}

void ToolUse::release(const Viewport& viewport, ToolOutput& output) {
  if (!active_) return;
  active_ = false;
  const bool alive = begun_at(viewport.world);
  switch (choice_.kind) {
    case ToolKind::drag:
      if (point_ || body_) output.input.commands.push_back(command(Command::Kind::release));
      break;
    case ToolKind::cut:
      if (done_.empty()) output.said.push_back(std::string("nothing was cut: ") + choice_.tool().help);
      break;
    case ToolKind::join:
      if (alive) join(viewport, output);
      break;
    case ToolKind::push:
    case ToolKind::spin:
      if (alive) turn_or_push(viewport, output);
      break;
    case ToolKind::make:
      send(making(viewport), output);
      output.said.push_back(std::string("made a ") + choice_.tool().variants[choice_.variant]);
      break;
    default: break;
  }
}

void ToolUse::cancel(ToolOutput& output) {
  if (holding()) output.input.commands.push_back(command(Command::Kind::release));
  active_ = false;
}

void ToolUse::carry_over(std::int32_t hand, PointId point) {
  if (!holding() || !point || hand < 0) {
    *this = {};
    return;
  }
  hand_ = hand;
  point_ = point;
}

Vec3 ToolUse::place(const Viewport& viewport, double x, double y) const {
  const Vec3 at = viewport.place(x, y, active_ ? depth_ : viewport.camera.distance);
  return holding() ? at + offset_ : at;
}

Vec3 ToolUse::start(const Viewport& viewport) const {
  const World& world = viewport.world;
  if (world.points.alive(point_)) return position(world, point_);
  if (world.bodies.alive(body_)) return origin(world, body_) + rotate(orientation(world, body_), on_body_);
  return viewport.place(x0_, y0_, depth_);
}

Vec3 ToolUse::way(const Viewport& viewport) const {
  return viewport.place(x_, y_, depth_) - viewport.place(x0_, y0_, depth_);
}

bool ToolUse::is_click() const { return std::hypot(x_ - x0_, y_ - y0_) < click_distance; }

Vec3 ToolUse::impulse(const Viewport& viewport) const {
  if (!begun_at(viewport.world)) return zero3();
  const BodyId body = body_of(viewport.world);
  const double mass = body ? viewport.world.motion_of(body).mass : viewport.world.points[point_].mass;
  // A click pushes away from the eye.
  const Vec3 way_to = is_click() ? viewport.camera.forward() * (0.5 * viewport.stage.unit) : way(viewport);
  return viewport.world.plane.along(way_to) * (mass / step_times(viewport.world, push_time));
}

Vec3 ToolUse::turn(const Viewport& viewport) const {
  const double angle = 6.283 / viewport.height / step_times(viewport.world, push_time);
  if (viewport.world.plane.flat()) {
    // To the right is clockwise.
    const Vec3 normal = viewport.world.plane.about(vec(1, 1, 1));
    return normal * (dot(normal, viewport.camera.forward()) > 0.0 ? (x_ - x0_) * angle : (x0_ - x_) * angle);
  }
  return viewport.camera.up() * ((x_ - x0_) * angle) + viewport.camera.right() * ((y_ - y0_) * angle);
}

Command ToolUse::making(const Viewport& viewport) const {
  Command c = command(Command::Kind::make);
  const World& world = viewport.world;
  const bool touches = !world.shapes.empty();
  c.point = {};
  double part = 1.0;  // of its usual size
  if (choice_.variant == rod)
    part = make_rod(viewport, c);
  else if (choice_.variant == box)
    part = make_box(viewport, c);
  else
    part = make_round(viewport, c);
  if (const auto height = usual_height(world); !world.points.alive(c.point))
    c.position = world.plane.beside(c.position, height.value_or(zero3()));
  if (choice_.variant == rod) c.points[1] = world.plane.along(c.points[1]);
  if (!touches) {
    c.mass = usual_mass(world) * part;
    c.amount = zero3();
    return c;
  }
  static constexpr std::array<MadeForm, 4> forms = {MadeForm::rod, MadeForm::ball, MadeForm::box, MadeForm::wheel};
  c.form = choice_.variant < forms.size() ? forms[choice_.variant] : MadeForm::hull;
  return c;
}

/// Each returns its mass by that of a usual thing.
double ToolUse::make_rod(const Viewport& viewport, Command& c) const {
  const World& world = viewport.world;
  const bool touches = !world.shapes.empty();
  const double unit = viewport.stage.unit;
  c.position = start(viewport);
  c.point = world.points.alive(point_) ? point_ : PointId{};
  if (touches) c.radius = 0.05 * unit;
  if (touches && !c.point && body_) c.thing = body_;
  if (touches && !c.point && !body_) c.position = rounded(c.position, round_step(unit));
  if (is_click()) {
    c.points = {zero3(), viewport.camera.right() * unit};
    return 1.0;
  }
  Vec3 to = place_shown(viewport, x_, y_, depth_);
  const Held end = pick_held(viewport, x_, y_);
  if (end.point && end.point != point_) {
    c.other = end.point;
    to = position(world, end.point);
  } else if (touches && end.body && end.body != body_) {
    c.other_thing = end.body;
  } else if (touches) {
    to = rounded(to, round_step(unit));
  }
  c.points = {zero3(), to - c.position};
  return norm(c.points[1]) / unit;
}

double ToolUse::make_box(const Viewport& viewport, Command& c) const {
  const double unit = viewport.stage.unit, step = round_step(unit);
  const Vec3 from = place_shown(viewport, x0_, y0_, depth_);
  const Vec3 to = is_click() ? from + 0.5 * unit * (viewport.camera.right() + viewport.camera.up())
                             : place_shown(viewport, x_, y_, depth_);
  const Vec3 way_to = rounded(to, step) - rounded(from, step);
  c.position = 0.5 * (rounded(from, step) + rounded(to, step));
  c.amount = half_of_box(way_to, step);
  c.points = corners_of(c.amount);
  return c.amount[0] * c.amount[1] * c.amount[2] / std::pow(0.25 * unit, 3.0);
}

double ToolUse::make_round(const Viewport& viewport, Command& c) const {
  const double unit = viewport.stage.unit, step = round_step(unit);
  const bool is_round = choice_.variant == ball || choice_.variant == wheel, touches = !viewport.world.shapes.empty();
  const double usual = is_round ? 0.25 * unit : 0.5 * unit, length = is_click() ? usual : norm(way(viewport));
  const double radius = std::fmax(touches ? rounded(vec(length, 0, 0), step)[0] : length, step);
  c.position = viewport.place(x0_, y0_, depth_);
  if (choice_.variant == wheel && (point_ || body_)) {
    c.position = start(viewport);
    c.point = viewport.world.points.alive(point_) ? point_ : PointId{};
    if (!c.point) c.thing = body_;
  } else if (touches) {
    c.position = rounded(c.position, step);
  }
  c.points = {zero3()};
  if (is_round) c.radius = radius;
  if (choice_.variant == wheel) {
    const double beyond = half_width(viewport.world, body_of(viewport.world), c.position, axle_of(viewport));
    c.amount = axle_of(viewport) * std::fmax(0.2 * radius, beyond + 0.1 * radius);
    constexpr int spokes = 12;
    const Vec3 across = cross(axle_of(viewport), vec(0, 1, 0)), other = cross(across, axle_of(viewport));
    for (int i = 0; i < spokes && norm2(across) > 0.0; i++) {
      const double angle = 6.283185307179586 * i / spokes;
      c.points.push_back((across * std::cos(angle) + other * std::sin(angle)) * radius);
    }
  } else if (!is_round) {
    c.points = vertices_of(choice_.variant);
    const double scale = radius / norm(c.points[0]);
    for (Vec3& p : c.points) p *= scale;
  }
  return std::pow(radius / usual, 3.0);
}

Command ToolUse::command(Command::Kind kind) const {
  Command c;
  c.kind = kind;
  c.hand = hand_;
  c.point = point_;
  return c;
}

/// The same, of what it began at: a point, or a place on a body.
Command ToolUse::command_there(const Viewport& viewport, Command::Kind kind) const {
  Command c = command(kind);
  if (point_ || !body_) return c;
  c.thing = body_;
  c.position = start(viewport);
  return c;
}

bool ToolUse::begun_at(const World& world) const { return world.points.alive(point_) || world.bodies.alive(body_); }

BodyId ToolUse::body_of(const World& world) const {
  return world.points.alive(point_) ? world.points[point_].body : body_;
}

/// The point that its grab made on the body.
void ToolUse::take_point(const World& world) {
  const auto index = static_cast<std::size_t>(hand_);
  if (index >= world.hands.size() || !world.constraints.alive(world.hands[index].grab)) return;
  point_ = world.constraints[world.hands[index].grab].a;
  body_ = {};
}

void ToolUse::send(Command command, ToolOutput& output) {
  if (!acted_) output.acts.push_back(choice_.tool().name);
  acted_ = true;
  output.input.commands.push_back(std::move(command));
}

void ToolUse::grab(const Viewport& viewport, ToolOutput& output) {
  if (!point_ && !body_) return;
  output.input.moves.push_back({hand_, start(viewport), true});
  send(command_there(viewport, Command::Kind::grab), output);
}

void ToolUse::nail(const Viewport& viewport, ToolOutput& output) {
  if (!point_ && !body_) return output.said.push_back("nail: there is no point under the cursor");
  if (body_) {
    send(command_there(viewport, Command::Kind::nail), output);
    return output.said.push_back("nailed");
  }
  const Particle& ring = viewport.world.particles[viewport.world.points[point_].particle];
  for (const PointId p : ring.points)
    for (const ConstraintId id : viewport.world.points[p].constraints)
      if (viewport.world.constraints[id].kind == ConstraintKind::nail) {
        Command c = command(Command::Kind::cut);
        c.thing = id;
        send(c, output);
        return output.said.push_back("pulled the nail out");
      }
  send(command(Command::Kind::nail), output);
  output.said.push_back("nailed");
}

void ToolUse::cut(const Viewport& viewport, double x, double y, ToolOutput& output) {
  bool more = false;
  for (const AnyId& thing : cuttable(viewport, {x_, y_, x, y})) {
    if (std::ranges::count(done_, thing) > 0) continue;
    done_.push_back(thing);
    more = true;
    Command c = command(Command::Kind::cut);
    c.point = {};
    c.thing = thing;
    send(c, output);
  }
  std::vector<AnyId> alive = done_;
  std::erase_if(alive, [&](const AnyId& t) { return !pantin::alive(viewport.world, t); });
  if (more && !alive.empty())
    output.said.push_back(alive.size() == done_.size() ? cut_story(viewport.world, done_)
                                                       : "cut " + counted(done_.size(), "tie", "ties"));
}

void ToolUse::remove(const Viewport& viewport, ToolOutput& output) {
  const AnyId thing = pick_thing(viewport, x_, y_);
  const bool none = std::holds_alternative<std::monostate>(thing);
  if (none && is_click() && done_.empty()) output.said.push_back("remove: there is nothing under the cursor");
  if (none || std::ranges::count(done_, thing) > 0) return;
  done_.push_back(thing);
  Command c = command(Command::Kind::remove);
  c.point = {};
  c.thing = thing;
  send(c, output);
  output.said.push_back(done_.size() == 1 ? "removed " + describe(viewport.world, thing)
                                          : "removed " + counted(done_.size(), "thing", "things"));
}

void ToolUse::turn_or_push(const Viewport& viewport, ToolOutput& output) {
  const bool push = choice_.kind == ToolKind::push, drive = !push && choice_.variant == motor;
  Command c = command_there(viewport, push ? Command::Kind::push : drive ? Command::Kind::drive : Command::Kind::spin);
  if (push)
    c.amount = impulse(viewport);
  else if (!is_click())
    c.amount = turn(viewport);
  if (!push && !drive && is_click()) return output.said.push_back("spin: drag over a body");
  send(c, output);
  const std::string size = short_number(norm(c.amount));
  output.said.push_back(push                     ? "pushed by " + size + " N s"
                        : !drive                 ? "spun by " + size + " rad/s"
                        : norm2(c.amount) == 0.0 ? std::string("took its motor away")
                                                 : "a motor turns it by " + size + " rad/s");
}

void ToolUse::join(const Viewport& viewport, ToolOutput& output) {
  const bool hinged = choice_.variant == hinge;
  Command c = command_there(viewport, hinged ? Command::Kind::join : Command::Kind::tie);
  const Held end = pick_held(viewport, x_, y_);
  c.position = start(viewport);
  c.points = {end ? shown_place(viewport.world, end) : viewport.place(x_, y_, depth_)};
  c.other = end.point;
  if (!end.point && end.body) c.other_thing = end.body;
  const bool same = end && (end.point ? end.point == point_ : end.body == body_);
  if (same || (hinged && !end) || is_click()) return output.said.push_back("join: let go at another thing");
  c.name = hinged ? "" : choice_.tool().variants[choice_.variant];
  send(c, output);
  output.said.push_back(hinged ? std::string("joining") : "tied by a " + c.name);
}

}  // namespace pantin
