#include "fields/contacts.hpp"

#include "contacts/heat.hpp"
#include "contacts/touching.hpp"
#include "measure/measure.hpp"
#include "measure/query.hpp"

namespace pantin::fields {
namespace {

Vec3 velocity_at(const World& world, std::uint32_t thing, Vec3 at) {
  if (is_point(thing)) return world.free_motion[slot_of(thing)].v;
  const Motion& m = world.motion[thing];
  return m.p / m.mass + cross(angular_velocity(m), at - m.x);
}

/// How fast the surface of a slides on that of b [m/s], belts included.
Vec3 slip_of(const World& world, const Contact& c) {
  const bool on_thing = c.body_b >= 0 && alive(world, second_of(world, c.body_b, c.key.b));
  const Vec3 of_b = on_thing ? velocity_at(world, static_cast<std::uint32_t>(c.body_b), c.at) : zero3();
  const Vec3 v = velocity_at(world, c.body_a, c.at) - of_b + c.belt;
  return v - c.normal * dot(c.normal, v);
}

void add_contact(const World& world, std::uint32_t thing, const Contact& c, bool sensor, Table& list) {
  const bool first = c.body_a == thing, second = c.body_b >= 0 && static_cast<std::uint32_t>(c.body_b) == thing;
  if (!(first || second) || (c.gap > 0.0 && norm2(c.total) == 0.0)) return;
  const double side = first ? 1.0 : -1.0;
  const AnyId other = first ? second_of(world, c.body_b, c.key.b) : thing_of(world, c.body_a);
  const std::optional<double> heat = heat_of(world.contacts, pair_of(world, c.body_a, c.body_b, c.key.b));
  list.push_back({"", Table{{"with", other == AnyId() ? Value() : Value(other)},
                            {"at", between(c)},
                            {"normal", c.normal * side},
                            {"force", contact_force(world, c) * side},
                            {"depth", -c.gap},
                            {"slip", slip_of(world, c) * side},
                            {"sensor", sensor},
                            {"heat", heat ? Value(*heat) : Value()}}});
}

}  // namespace

Table contacts_of(const World& world, std::uint32_t thing) {
  Table list;
  const auto add = [&](const std::vector<Contact>& contacts, bool sensor) {
    for (const Contact& c : contacts) add_contact(world, thing, c, sensor, list);
  };
  add(world.contacts.list, false);
  add(world.contacts.resting, false);
  add(world.contacts.sensed, true);
  add(world.contacts.resting_sensed, true);
  return list;
}

}  // namespace pantin::fields
