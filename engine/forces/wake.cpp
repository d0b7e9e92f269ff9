#include <algorithm>

#include "articulates/articulate.hpp"
#include "contacts/bodies.hpp"
#include "contacts/resting.hpp"
#include "forces/forces.hpp"
#include "forces/receiver_momenta.hpp"
#include "forces/sleep.hpp"

namespace pantin {

namespace {

void wake(World& world, std::int32_t articulate) {
  if (articulate >= 0 && static_cast<std::size_t>(articulate) < world.articulates.size())
    wake(*world.articulates[static_cast<std::size_t>(articulate)]);
}

void wake_slot(World& world, std::uint32_t slot) {
  wake(world, world.motion[slot].articulate);
  if (slot < world.contacts.bodies.size()) world.contacts.bodies[slot].rest = {};
}

/// Numbers of islands that something of is awake, rising.
std::vector<std::int32_t> woken_islands(const World& world) {
  std::vector<std::int32_t> list;
  const auto add = [&](std::uint32_t slot) {
    if (slot >= world.contacts.bodies.size()) return;
    if (const std::int32_t island = world.contacts.bodies[slot].island; island >= 0) list.push_back(island);
  };
  for (const BodyId body : world.stirred) add(body.slot - 1);
  for (const auto& articulate : world.articulates) {
    if (articulate->rest.asleep) continue;
    const auto body =
        std::find_if(articulate->nodes.begin(), articulate->nodes.end(), [](const Node& n) { return n.is_body; });
    if (body != articulate->nodes.end()) add(body->slot);
  }
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  return list;
}

/// Puts bodies among those that move, and where a step has begun their states among those at its start.
void loosen(World& world, const std::vector<std::uint32_t>& slots) {
  std::vector<std::uint32_t> loose;
  std::vector<Motion> saved;
  std::size_t next = 0;
  const auto add_up_to = [&](std::uint32_t slot) {
    for (; next < world.loose_bodies.size() && world.loose_bodies[next] <= slot; next++) {
      loose.push_back(world.loose_bodies[next]);
      saved.push_back(next < world.saved_motion.size() ? world.saved_motion[next] : world.motion[loose.back()]);
    }
  };
  for (const std::uint32_t slot : slots) {
    add_up_to(slot);
    if (!loose.empty() && loose.back() == slot) continue;
    loose.push_back(slot);
    saved.push_back(world.motion[slot]);
  }
  add_up_to(~0u);
  world.loose_bodies = std::move(loose);
  world.saved_motion = std::move(saved);
}

/// Whether a law's pull is another than that which its thing sleeps in.
bool differs(const World& world, const Receiver& m) {
  const NodePull* was = nullptr;
  double mass = 0.0, reach = 0.0, acceleration = 0.0;
  if (m.articulate >= 0) {
    const Articulate& a = *world.articulates[static_cast<std::size_t>(m.articulate)];
    if (!a.rest.pulls.empty()) was = &a.rest.pulls[m.node];
    mass = a.nodes[m.node].mass;
    reach = a.nodes[m.node].reach;
    acceleration = a.rest.acceleration;
  } else {
    const Rest& rest = world.contacts.bodies[m.slot].rest;
    if (!rest.pulls.empty()) was = &rest.pulls[0];
    mass = world.motion[m.slot].mass;
    reach = gyration(world.motion[m.slot]);
    acceleration = rest.acceleration;
  }
  if (!was) return true;
  const Vec3 force = m.force + m.nonconservative_force - was->force - was->nonconservative_force;
  const Vec3 torque = m.torque + m.nonconservative_torque - was->torque - was->nonconservative_torque;
  return !(norm(force) <= mass * acceleration && norm(torque) <= mass * acceleration * reach);
}

/// Which are pulled otherwise.
struct Pulled {
  std::vector<char> articulates;      ///< empty: none
  std::vector<std::uint32_t> bodies;  ///< slots of those that nothing ties
};

Pulled find_pulled(const World& world) {
  Pulled pulled;
  for (const Receiver& m : world.forces->receivers) {
    if (!sleeps(world, m) || !differs(world, m)) continue;
    if (m.articulate < 0) {
      pulled.bodies.push_back(m.slot);
      continue;
    }
    pulled.articulates.resize(world.articulates.size());
    pulled.articulates[static_cast<std::size_t>(m.articulate)] = 1;
  }
  return pulled;
}

void wake(World& world, const Pulled& pulled) {
  for (std::size_t i = 0; i < pulled.articulates.size(); i++)
    if (pulled.articulates[i]) wake(*world.articulates[i]);
  for (const std::uint32_t slot : pulled.bodies) {
    wake_slot(world, slot);
    world.stirred.push_back(world.bodies.id_at(slot));
  }
}

bool changes_by_itself(const Forces& f) {
  const auto& names = f.sites.names;
  return any_element(f, [](const ActingElement& a) { return a.law->timed; }) ||
         std::find(names.begin(), names.end(), "age") != names.end() ||
         std::find(f.followed.begin(), f.followed.end(), char{1}) != f.followed.end();
}

}  // namespace

void wake(World& world, BodyId body) {
  wake(world, world.motion_of(body).articulate);
  world.stirred.push_back(body);
}

void wake(World& world, PointId id) {
  const Point& point = world.points[id];
  point.body ? wake(world, point.body) : wake(world, point.articulate);
}

void wake(World& world, const Constraint& constraint) {
  constraint.each_point([&](PointId point) { wake(world, point); });
  constraint.each_body([&](BodyId body) { wake(world, body); });
}

void wake_all(World& world) {
  for (const auto& articulate : world.articulates) wake(*articulate);
  for (const std::uint32_t slot : world.contacts.sleepers)
    if (world.bodies.alive_at(slot)) world.stirred.push_back(world.bodies.id_at(slot));
}

void wake_stirred(World& world) {
  Contacts& contacts = world.contacts;
  if (world.stirred.empty() && contacts.sleepers.empty()) return;
  const std::vector<std::int32_t> islands =
      contacts.sleepers.empty() ? std::vector<std::int32_t>() : woken_islands(world);
  for (const BodyId body : world.stirred) wake_slot(world, body.slot - 1);
  world.stirred.clear();
  if (islands.empty()) return;
  std::vector<std::uint32_t> loose;
  std::erase_if(contacts.sleepers, [&](std::uint32_t slot) {
    if (!std::binary_search(islands.begin(), islands.end(), contacts.bodies[slot].island)) return false;
    contacts.bodies[slot].island = -1;
    wake_slot(world, slot);
    if (world.bodies.alive_at(slot) && world.motion[slot].articulate < 0) loose.push_back(slot);
    return true;
  });
  loosen(world, loose);
  sort_resting(world, world.articulates, contacts);
}

void wake_touched(World& world) {
  const auto sleeps = [&](std::uint32_t slot) { return asleep(world, world.articulates, world.contacts, slot); };
  for (const Contact& c : world.contacts.list) {
    if (c.body_b < 0) continue;
    const auto b = static_cast<std::uint32_t>(c.body_b);
    const bool a_sleeps = sleeps(c.body_a);
    if (a_sleeps == sleeps(b)) continue;
    const std::uint32_t thing = a_sleeps ? c.body_a : b;
    if (is_point(thing))
      wake(world, world.points.at_slot(slot_of(thing)).articulate);
    else
      world.stirred.push_back(world.bodies.id_at(thing));
  }
  wake_stirred(world);
}

void wake_pulled(World& world) {
  if (sleepers(world) == 0) return;
  std::vector<std::uint32_t> tied(world.articulates.size(), 0), loose(world.contacts.bodies.size(), 0);
  if (world.forces) {
    for (const Receiver& m : world.forces->receivers) {
      if (m.articulate >= 0)
        tied[static_cast<std::size_t>(m.articulate)]++;
      else if (m.is_body && m.slot < loose.size())
        loose[m.slot]++;
    }
    wake(world, find_pulled(world));
  }
  for (std::size_t i = 0; i < tied.size(); i++)
    if (const Rest& rest = world.articulates[i]->rest; rest.asleep && rest.receivers != tied[i])
      wake(*world.articulates[i]);
  for (const std::uint32_t slot : world.contacts.sleepers)
    if (const Rest& rest = world.contacts.bodies[slot].rest; rest.asleep && rest.receivers != loose[slot])
      world.stirred.push_back(world.bodies.id_at(slot));
  wake_stirred(world);
}

void wake_pulled(World& world, double half) {
  if (!world.forces || sleepers(world) == 0) return;
  const Pulled pulled = find_pulled(world);
  if (!pulled.articulates.empty()) kick_from_rest(world, pulled.articulates, half);
  wake(world, pulled);
  wake_stirred(world);
}

bool all_asleep(const World& world) {
  if (world.articulates.empty() && world.contacts.sleepers.empty()) return false;
  if (!world.loose_points.empty() || !world.loose_bodies.empty()) return false;
  const auto sleeps = [](const auto& articulate) { return articulate->rest.asleep; };
  return std::all_of(world.articulates.begin(), world.articulates.end(), sleeps) &&
         (!world.forces || !changes_by_itself(*world.forces));
}

std::uint64_t sleepers(const World& world) {
  std::uint64_t count = 0;
  for (const auto& articulate : world.articulates) count += articulate->rest.asleep;
  for (const std::uint32_t slot : world.contacts.sleepers) count += world.contacts.bodies[slot].rest.asleep;
  return count;
}

}  // namespace pantin
