#include <algorithm>

#include "articulates/articulate.hpp"
#include "articulates/solve/state.hpp"
#include "forces/forces.hpp"
#include "forces/integrator.hpp"
#include "forces/kick_error.hpp"
#include "forces/sleep.hpp"
#include "forces/work_check.hpp"
#include "step/ledger_posts.hpp"
#include "step/phases.hpp"
#include "step/reject.hpp"

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
  if (world.stage.index == 0)
    for (const auto& articulate : world.articulates) articulate->reaction.clear();
  if (rule_of(world).kicks || world.stage.index == 0) begin_kick(world);
  if (!rule_of(world).kicks || (world.loose_points.empty() && !world.forces)) return;
  const Timed timed(world.profile, Phase::half_kick);
  const double half = 0.5 * world.stage.h;
  const bool drifted = world.stage.index > 0;
  const LedgerMark before = ledger_mark(world, drifted);
  kick_loose_points(world, half);
  post_kick(world, before, drifted);
  kick(world, half);
  note_nonconservative_forces(world);
  if (world.settings.accuracy) note_kicks(world);
}

void half_kick_to_end(World& world) {
  if (!rule_of(world).kicks || (world.loose_points.empty() && !world.forces)) return;
  const Timed timed(world.profile, Phase::half_kick_to_end);
  const double half = 0.5 * world.stage.h;
  wake_pulled(world, half);
  const LedgerMark before = ledger_mark(world, true);
  kick_loose_points(world, half);
  post_kick(world, before, true);
  kick_to_end(world, half);
  check_work(world);
  if (world.settings.accuracy) note_error(world);
}

}  // namespace pantin::phases
