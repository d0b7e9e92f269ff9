#include "forces/sleep.hpp"

#include <algorithm>
#include <cmath>

#include "articulates/articulate.hpp"
#include "articulates/solve/state.hpp"
#include "forces/forces.hpp"

namespace pantin {

namespace {

constexpr double stillness = 1e-8;   // of its length; the square, an energy, is lost in the round-off of its weight's
constexpr double round_off = 4e-11;  // of its distance from the origin, which positions are rounded to
constexpr double least_steps = 256, swing = 4.0;  // times sqrt(length / gravity)
constexpr double most_growth = 2.0;               // round-off grows slowly, a fall by thousands in such a time,
constexpr double unseen = 1e-20;                  // but what is so much smaller may grow

void wake(World& world, std::int32_t articulate) {
  if (articulate >= 0 && static_cast<std::size_t>(articulate) < world.articulates.size())
    wake(*world.articulates[static_cast<std::size_t>(articulate)]);
}

/// How long its motion is looked at [s].
double watch_time(const World& world, const Articulate& a) {
  const double gravity = norm(world.settings.gravity);
  const double least = least_steps * world.settings.step;
  return gravity > 0.0 ? std::max(least, swing * std::sqrt(a.length / gravity)) : least;
}

/// Whether its motion has died away, at the end of a step.
bool is_still(const World& world, Articulate& a) {
  Rest& r = a.rest;
  r.peak = std::max(r.peak, a.totals.kinetic);
  if (++r.steps < least_steps) return false;
  const double time = watch_time(world, a);
  if (r.steps * world.settings.step < time) return false;
  double least = a.total_mass, far = 0.0;
  for (const Node& n : a.nodes) {
    least = std::min(least, n.mass);
    far = std::max(far, largest(n.x0));
  }
  const double speed = (stillness * a.length + round_off * far) / time;
  const double rest = 0.5 * least * speed * speed;
  const bool still =
      r.last_peak >= 0.0 && r.peak <= rest && r.peak <= std::max(most_growth * r.last_peak, unseen * rest);
  const bool closed = !a.fell_back && a.gaps.open <= 1e-8 * a.length;
  r = {false, 0, 0.0, r.peak, speed / time, {}, 0};
  return still && closed;
}

void stop(World& world, Articulate& a) {
  for (Node& n : a.nodes) n.p0 = n.P0 = n.O0 = zero3();
  post(world, Source::sleep, -a.totals.kinetic);
  a.totals.kinetic = 0.0;
  a.rest.asleep = true;
  store(a, world);
}

/// Notes what laws do to articulates that fall asleep.
void note_pulls(World& world, const std::vector<char>& falling) {
  if (!world.forces) return;
  for (const Receiver& m : world.forces->receivers) {
    if (m.articulate < 0 || !falling[static_cast<std::size_t>(m.articulate)]) continue;
    Articulate& a = *world.articulates[static_cast<std::size_t>(m.articulate)];
    a.rest.pulls.resize(a.nodes.size());
    a.rest.pulls[m.node] = {m.force, m.torque, m.nonconservative_force, m.nonconservative_torque};
    a.rest.receivers++;
  }
}

/// Whether a law's pull is another than that which its articulate sleeps in.
bool differs(const Articulate& a, const Receiver& m) {
  if (a.rest.pulls.empty()) return true;
  const NodePull& was = a.rest.pulls[m.node];
  const Node& n = a.nodes[m.node];
  const double most = n.mass * a.rest.acceleration;
  const Vec3 force = m.force + m.nonconservative_force - was.force - was.nonconservative_force;
  const Vec3 torque = m.torque + m.nonconservative_torque - was.torque - was.nonconservative_torque;
  return !(norm(force) <= most && norm(torque) <= most * n.reach);
}

/// Which wake; empty: none.
std::vector<char> find_pulled(const World& world) {
  std::vector<char> woken;
  for (const Receiver& m : world.forces->receivers) {
    if (m.articulate < 0) continue;
    const auto i = static_cast<std::size_t>(m.articulate);
    const Articulate& a = *world.articulates[i];
    if (!a.rest.asleep || !differs(a, m)) continue;
    woken.resize(world.articulates.size());
    woken[i] = 1;
  }
  return woken;
}

void wake(World& world, const std::vector<char>& woken) {
  for (std::size_t i = 0; i < woken.size(); i++)
    if (woken[i]) wake(*world.articulates[i]);
}

bool changes_by_itself(const Forces& f) {
  const auto& names = f.sites.names;
  return any_element(f, [](const ActingElement& a) { return a.law->timed; }) ||
         std::find(names.begin(), names.end(), "age") != names.end() ||
         std::find(f.followed.begin(), f.followed.end(), char{1}) != f.followed.end();
}

}  // namespace

void wake(World& world, BodyId body) { wake(world, world.motion_of(body).articulate); }

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
}

void fall_asleep(World& world) {
  std::vector<char> falling;
  for (std::size_t i = 0; i < world.articulates.size(); i++) {
    Articulate& a = *world.articulates[i];
    if (a.rest.asleep || !is_still(world, a)) continue;
    stop(world, a);
    falling.resize(world.articulates.size());
    falling[i] = 1;
  }
  if (!falling.empty()) note_pulls(world, falling);
}

void wake_pulled(World& world) {
  if (sleepers(world) == 0) return;
  std::vector<std::uint32_t> receivers(world.articulates.size(), 0);
  if (world.forces) {
    for (const Receiver& m : world.forces->receivers)
      if (m.articulate >= 0) receivers[static_cast<std::size_t>(m.articulate)]++;
    wake(world, find_pulled(world));
  }
  for (std::size_t i = 0; i < receivers.size(); i++)
    if (world.articulates[i]->rest.asleep && world.articulates[i]->rest.receivers != receivers[i])
      wake(*world.articulates[i]);
}

void wake_pulled(World& world, double half) {
  if (!world.forces || sleepers(world) == 0) return;
  const std::vector<char> woken = find_pulled(world);
  if (woken.empty()) return;
  kick_from_rest(world, woken, half);
  wake(world, woken);
}

bool all_asleep(const World& world) {
  if (world.articulates.empty() || !world.loose_points.empty() || !world.loose_bodies.empty()) return false;
  const auto asleep = [](const auto& articulate) { return articulate->rest.asleep; };
  return std::all_of(world.articulates.begin(), world.articulates.end(), asleep) &&
         (!world.forces || !changes_by_itself(*world.forces));
}

std::uint64_t sleepers(const World& world) {
  const auto asleep = [](const auto& articulate) { return articulate->rest.asleep; };
  return static_cast<std::uint64_t>(std::count_if(world.articulates.begin(), world.articulates.end(), asleep));
}

}  // namespace pantin
