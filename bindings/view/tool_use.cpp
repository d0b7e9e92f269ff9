#include "view/tool_use.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>

#include "choreography/commands.hpp"
#include "edit/assemble.hpp"
#include "shapes/convex_parts.hpp"
#include "view/draw_list.hpp"
#include "view/making.hpp"
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

std::string nothing_heated(const ToolChoice& choice) {
  return text("nothing was ", choice.variant == 1 ? "cooled" : "heated", ": ", choice.tool().help);
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

/// A place on a body that is seen, at the height where a plane keeps the body; things of any thickness can be tied there.
Vec3 within_plane(const World& world, BodyId body, Vec3 seen) {
  return world.bodies.alive(body) ? world.plane.beside(seen, world.motion_of(body).x) : seen;
}

enum Joins : std::size_t { by_hinge, by_rod, by_rope, by_spring, by_chain, by_ball_hinge };
enum Spins : std::size_t { once, motor };

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
  std::vector<Vec3> corners;
  if (choice.is_polygon() && choice_.is_polygon()) corners = std::move(corners_);
  const bool snaps = snaps_;
  *this = {};
  snaps_ = snaps;
  corners_ = std::move(corners);
  clicked_ = corners_.size();
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
    case ToolKind::make:
      if (choice.is_polygon()) corners_.push_back(place_to_make(viewport, x, y, snaps_));
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
  if (choice_.is_polygon() && !is_click()) draw_on(viewport);
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
  if (c.energy != 0.0 && takes_heat(viewport.world, things, c.energy)) send(c, output);
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
    case ToolKind::heat:
      if (!acted_) output.said.push_back(nothing_heated(choice_));
      break;
    case ToolKind::join:
      if (alive) join(viewport, output);
      break;
    case ToolKind::push:
    case ToolKind::spin:
      if (alive) turn_or_push(viewport, output);
      break;
    case ToolKind::make:
      if (choice_.is_polygon()) return end_corner(viewport, output);
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

double ToolUse::mass_pushed(const World& world) const {
  const BodyId body = body_of(world);
  return body ? world.motion_of(body).mass : world.points[point_].mass;
}

std::string ToolUse::push_story(const Viewport& viewport) const {
  const double impulse_size = norm(impulse(viewport)), mass = mass_pushed(viewport.world);
  return short_number(impulse_size) + " N s: " + short_number(mass > 0.0 ? impulse_size / mass : 0.0) + " m/s";
}

Vec3 ToolUse::impulse(const Viewport& viewport) const {
  if (!begun_at(viewport.world)) return zero3();
  const double mass = mass_pushed(viewport.world);
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
  Command c = made_by_drag(
      viewport, {choice_.variant, x0_, y0_, x_, y_, is_click(), snaps_, depth_, point_, body_, start(viewport)});
  c.hand = hand_;
  return c;
}

/// A stroke goes on from where it was; one that begins after clicks only moves the corner that it began.
void ToolUse::draw_on(const Viewport& viewport) {
  const Vec3 at = place_to_make(viewport, x_, y_, snaps_);
  if (clicked_ > 0)
    corners_.back() = at;
  else if (norm2(at - corners_.back()) > 0.0)
    corners_.push_back(at);
}

void ToolUse::end_corner(const Viewport& viewport, ToolOutput& output) {
  constexpr double near = 12.0;  // [px] of the first corner, that closes the outline
  const auto first = viewport.project(corners_[0]);
  const bool closes = clicked_ >= 3 && first && std::hypot(first->x - x_, first->y - y_) < near;
  if (closes) corners_.pop_back();
  if (!closes && clicked_ == 0 && !is_click()) corners_ = corners_of_stroke(viewport, corners_);
  if (closes || (clicked_ == 0 && !is_click())) return make_polygon(viewport, output);
  output.said.push_back(corners_.size() < 3 ? "polygon: click more corners"
                                            : "polygon: click the first corner to close it");
}

void ToolUse::make_polygon(const Viewport& viewport, ToolOutput& output) {
  const Command made = made_of_outline(viewport, std::exchange(corners_, {}));
  try {
    convex_parts(made.points, made.amount);
  } catch (const Error& error) { return output.said.push_back(text("polygon: ", error.what())); }
  send(made, output);
  output.said.push_back("made a polygon");
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
  output.said.push_back(push                     ? "pushed by " + push_story(viewport)
                        : !drive                 ? "spun by " + size + " rad/s"
                        : norm2(c.amount) == 0.0 ? std::string("took its motor away")
                                                 : "a motor turns it by " + size + " rad/s");
}

void ToolUse::join(const Viewport& viewport, ToolOutput& output) {
  const bool hinged = choice_.variant == by_hinge || choice_.variant == by_ball_hinge;
  Command c = command_there(viewport, hinged ? Command::Kind::join : Command::Kind::tie);
  const Held end = pick_held(viewport, x_, y_);
  c.position = within_plane(viewport.world, point_ ? BodyId{} : body_, start(viewport));
  const double depth = depth_of_plane(viewport, x_, y_, c.position).value_or(depth_);
  c.points = {end ? shown_place(viewport.world, end)
                  : viewport.world.plane.beside(viewport.place(x_, y_, depth), c.position)};
  if (!end.point) c.points[0] = within_plane(viewport.world, end.body, c.points[0]);
  c.other = end.point;
  if (!end.point && end.body) c.other_thing = end.body;
  const bool same = end && (end.point ? end.point == point_ : end.body == body_);
  if (same || (hinged && !end) || is_click()) return output.said.push_back("join: let go at another thing");
  c.name = hinged ? "" : choice_.tool().variants[choice_.variant];
  if (choice_.variant == by_hinge) c.amount = hinge_axis(viewport);
  if (choice_.variant == by_chain) c.radius = 0.05 * viewport.stage.unit;
  send(c, output);
  output.said.push_back(hinged ? std::string("joining") : "tied by a " + c.name);
}

}  // namespace pantin
