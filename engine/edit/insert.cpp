// How constraints come into a world, and leave it.
#include "edit/common.hpp"
#include "edit/constrain.hpp"
#include "forces/sleep.hpp"

namespace pantin {

ConstraintId add_constraint(World& world, Constraint c) {
  internal::check_constraint(world, c);
  internal::start_constraint(world, c);
  return internal::insert_constraint(world, std::move(c));
}

void change_constraint(World& world, ConstraintId id, std::string_view call,
                       const std::function<void(Constraint&)>& change) {
  internal::require_unlocked(world, call);
  Constraint changed = world.constraints[id];
  change(changed);
  internal::check_constraint(world, changed, id);
  Constraint& c = world.constraints[id];
  wake(world, c);
  c = std::move(changed);
  internal::start_constraint(world, c);
}

namespace internal {

void require_point(const World& world, std::string_view call, PointId point) {
  require(world.points.alive(point), call, ": ", world.points.story(point));
}

void require_turning(const World& world, std::string_view call, BodyId body) {
  require(world.bodies.alive(body), call, ": ", world.bodies.story(body));
  require(world.motion_of(body).freedom != Freedom::point, call, ": ", describe(world, body),
          " has all its mass at one position, so it has no orientation; give it an inertia");
}

Vec3 in_frame(const World& world, BodyId body, Vec3 v) {
  return body ? rotate(conjugate(orientation(world, body)), v) : v;
}

void check_constraint(const World& world, Constraint& c, ConstraintId same) {
  const std::string_view call = kind_name(c.kind);
  const ConstraintRule& rule = rule_of(c);
  require_unlocked(world, call);
  if (!c.body_a && !c.is<StringData>()) require_point(world, call, c.a);  // of a string its rule tells what is missing
  bool is_listed = static_cast<bool>(c.body_a);
  c.each_point([&](PointId point) {
    require_point(world, call, point);
    is_listed = is_listed || point == c.a;
  });
  c.each_body([&](BodyId body) { require_turning(world, call, body); });
  require(!c.body_a || c.body_a != c.body_b, call, ": both are ", describe(world, c.body_a), "; it needs two bodies");
  require_positive(call, "time_constant", c.time_constant, "s");
  if (rule.check != nullptr) rule.check(world, c);
  require(is_listed, call, ": its first point is none of those that it ties, so its rows would be found nowhere");
  if (rule.keeps.name != nullptr) require_kept(call, c, c.by_speed ? c.number.rate : c.number.now);
  if (pins(c)) require_free_of_holders(world, call, c.a, same);
  require_in_plane(world, c);
}

ConstraintId insert_constraint(World& world, Constraint c) {
  require_in_plane(world, c);
  c.serial = world.next_serial++;
  const ConstraintId id = world.constraints.add(std::move(c));
  const Constraint& row = world.constraints[id];
  row.each_point([&](PointId point) { world.points[point].constraints.push_back(id); });
  row.each_body([&](BodyId body) {
    world.bodies[body].constraints.push_back(id);
    if (world.motion_of(body).freedom == Freedom::line) update_mass(world, body);
  });
  mark_edited(world, row);
  return id;
}

void take_out_constraint(World& world, ConstraintId id, Obituary obituary) {
  const Constraint& c = world.constraints[id];
  mark_edited(world, c);
  c.each_point([&](PointId point) { std::erase(world.points[point].constraints, id); });
  c.each_body([&](BodyId body) { std::erase(world.bodies[body].constraints, id); });
  if (c.ring() && world.particles.alive(c.ring())) std::erase(world.particles[c.ring()].axes, id);
  const std::shared_ptr<JoinProgress> progress = c.progress();
  world.constraints.remove(id, obituary);
  if (progress && world.constraints.alive(progress->holder))
    take_out_constraint(world, progress->holder, {describe(world, progress->holder), obituary.time, obituary.who});
}

}  // namespace internal

}  // namespace pantin
