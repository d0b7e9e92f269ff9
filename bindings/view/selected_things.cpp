#include "view/selected_things.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "choreography/copy_by_hand.hpp"
#include "measure/measure.hpp"
#include "view/draw_list.hpp"
#include "view/making.hpp"
#include "view/stroke.hpp"

namespace pantin {
namespace {

constexpr double longest_click = 5.0;  // [px] a press that moves less is a click
constexpr std::size_t most_rings = 200;
constexpr Color chosen_color = {0.20f, 0.50f, 0.85f, 0.9f};

bool is_alive(const World& world, const AnyId& thing) {
  if (const auto* body = std::get_if<BodyId>(&thing)) return world.bodies.alive(*body);
  const auto* point = std::get_if<PointId>(&thing);
  return point && world.points.alive(*point) && !world.points[*point].body;
}

Things whole(const World& world, const AnyId& thing) {
  return whole_of(world, command_of(Command::Kind::remove, 0, thing));
}

bool is_in(const Things& things, const AnyId& thing) {
  if (const auto* body = std::get_if<BodyId>(&thing)) return std::ranges::count(things.bodies, *body) > 0;
  return std::ranges::count(things.free_points, std::get<PointId>(thing)) > 0;
}

void add_line(std::vector<Mark>& marks, Vec3 from, Vec3 to, bool on_screen) {
  Mark& mark = marks.emplace_back();
  mark.from = from;
  mark.to = to;
  mark.color = chosen_color;
  mark.on_screen = on_screen;
}

void add_ring(std::vector<Mark>& marks, Vec3 at) {
  Mark& mark = marks.emplace_back();
  mark.kind = Mark::Kind::ring;
  mark.from = at;
  mark.size = 22.0;
  mark.color = chosen_color;
}

}  // namespace

AnyId thing_at(const Viewport& viewport, double x, double y) {
  const Held held = pick_held(viewport, x, y);
  if (held.body) return held.body;
  if (!held.point) return {};
  if (const BodyId body = viewport.world.points[held.point].body) return body;
  return held.point;
}

Vec3 centre_of(const World& world, const AnyId& thing) {
  if (const auto* body = std::get_if<BodyId>(&thing)) return world.motion_of(*body).x;
  return position(world, std::get<PointId>(thing));
}

Command command_of(Command::Kind kind, std::int32_t hand, const AnyId& thing) {
  Command c;
  c.kind = kind;
  c.hand = hand;
  if (const auto* point = std::get_if<PointId>(&thing))
    c.point = *point;
  else
    c.thing = thing;
  return c;
}

void SelectedThings::clear() { *this = {}; }

std::vector<AnyId> SelectedThings::wholes(const World& world) const {
  std::vector<AnyId> found;
  std::vector<Things> seen;
  for (const AnyId& thing : things_) {
    if (!is_alive(world, thing)) continue;
    if (std::ranges::any_of(seen, [&](const Things& things) { return is_in(things, thing); })) continue;
    seen.push_back(whole(world, thing));
    found.push_back(thing);
  }
  return found;
}

bool SelectedThings::has(const World& world, const AnyId& thing) const {
  return !std::holds_alternative<std::monostate>(thing) &&
         std::ranges::any_of(wholes(world), [&](const AnyId& one) { return is_in(whole(world, one), thing); });
}

void SelectedThings::press(double x, double y, bool moves) {
  does_ = moves ? Does::moves : Does::chooses;
  x0_ = x_ = x;
  y0_ = y_ = y;
}

void SelectedThings::move(double x, double y) {
  x_ = x;
  y_ = y;
}

/// A click takes one more, or one less; a box those whose centres are in it; a click beside all forgets them.
void SelectedThings::choose(const Viewport& viewport) {
  const World& world = viewport.world;
  if (std::hypot(x_ - x0_, y_ - y0_) < longest_click) {
    const AnyId thing = thing_at(viewport, x_, y_);
    if (std::holds_alternative<std::monostate>(thing)) return things_.clear();
    if (!has(world, thing)) return things_.push_back(thing);
    const Things joined = whole(world, thing);
    std::erase_if(things_, [&](const AnyId& one) { return is_alive(world, one) && is_in(joined, one); });
    return;
  }
  const auto take = [&](const AnyId& thing) {
    const auto seen = viewport.project(centre_of(world, thing));
    const bool within = seen && seen->x > std::fmin(x0_, x_) && seen->x < std::fmax(x0_, x_) &&
                        seen->y > std::fmin(y0_, y_) && seen->y < std::fmax(y0_, y_);
    if (within && std::ranges::count(things_, thing) == 0) things_.push_back(thing);
  };
  const Things all = everything(world);
  for (const BodyId body : all.bodies) take(body);
  for (const PointId point : all.free_points) take(point);
}

/// As far as the pointer went, in numbers that can be read.
Vec3 SelectedThings::way(const Viewport& viewport) const {
  const Vec3 way = place_to_make(viewport, x_, y_, false) - place_to_make(viewport, x0_, y0_, false);
  return viewport.world.plane.along(way);
}

void SelectedThings::release(const Viewport& viewport, std::int32_t hand, ToolOutput& output) {
  const World& world = viewport.world;
  const Does did = std::exchange(does_, Does::nothing);
  if (did == Does::chooses) {
    choose(viewport);
    const std::size_t count = wholes(world).size();
    return output.said.push_back(count == 0
                                     ? "nothing is selected"
                                     : text(count, count == 1 ? " thing is" : " things are",
                                            " selected: ctrl + c copies, delete removes; drag moves while paused"));
  }
  const Vec3 by = way(viewport);
  if (did == Does::nothing || norm2(by) == 0.0) return;
  for (const AnyId& thing : wholes(world)) {
    const Bounds box = bounds(world, whole(world, thing));
    Command c = command_of(Command::Kind::bring, hand, thing);
    c.position = 0.5 * (box.low + box.high) + by;
    output.input.commands.push_back(c);
  }
  output.acts.push_back("move");
  output.said.push_back("moved");
}

void SelectedThings::add_marks(const Viewport& viewport, std::vector<Mark>& marks) const {
  const World& world = viewport.world;
  const Vec3 by = does_ == Does::moves ? way(viewport) : zero3();
  std::size_t rings = 0;
  const auto mark = [&](Vec3 at) {
    if (++rings > most_rings) return;
    if (norm2(by) > 0.0) add_line(marks, at, at + by, false);
    add_ring(marks, at + by);
  };
  for (const AnyId& thing : wholes(world)) {
    const Things things = whole(world, thing);
    for (const BodyId body : things.bodies) mark(world.motion_of(body).x);
    for (const PointId point : things.free_points) mark(position(world, point));
  }
  if (does_ != Does::chooses) return;
  const Vec3 corners[] = {vec(x0_, y0_, 0), vec(x_, y0_, 0), vec(x_, y_, 0), vec(x0_, y_, 0)};
  for (std::size_t i = 0; i < 4; i++) add_line(marks, corners[i], corners[(i + 1) % 4], true);
}

}  // namespace pantin
