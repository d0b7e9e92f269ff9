#include "phases/phases.hpp"
#include "world/forces.hpp"

namespace pantin::phases {

namespace {

void kick_loose_points(World& world, double half) {
  const Vec3 gravity = world.settings.gravity;
  if (!world.pushed) {
    if (norm2(gravity) == 0.0) return;
    for (std::uint32_t slot : world.loose_points) world.free_motion[slot].v += gravity * half;
    return;
  }
  for (std::uint32_t slot : world.loose_points) {
    const Point& p = world.points.at_slot(slot);
    FreeMotion& m = world.free_motion[slot];
    const Vec3 before = m.v;
    m.v += (gravity + p.force / p.mass) * half;
    post(world, Source::event, dot(p.force, before + m.v) * (0.5 * half));
  }
}

}  // namespace

void half_kick(World& world) {
  if (world.loose_points.empty() && !world.forces) return;
  const Timed timed(world.profile, Phase::half_kick);
  const double half = 0.5 * world.settings.step;
  const LedgerMark before = ledger_mark(world, false);
  kick_loose_points(world, half);
  post_kick(world, before, false);
  kick(world, half);
}

void half_kick_to_end(World& world) {
  if (world.loose_points.empty() && !world.forces) return;
  const Timed timed(world.profile, Phase::half_kick_to_end);
  const double half = 0.5 * world.settings.step;
  const LedgerMark before = ledger_mark(world, true);
  kick_loose_points(world, half);
  post_kick(world, before, true);
  kick_to_end(world, half);
}

}  // namespace pantin::phases
