#include "articulates/solve/drift.hpp"

#include <algorithm>
#include <array>

#include "articulates/build/build.hpp"
#include "articulates/solve/midpoint.hpp"
#include "articulates/solve/project.hpp"
#include "articulates/solve/row_gaps.hpp"
#include "articulates/solve/settle.hpp"
#include "articulates/solve/state.hpp"
#include "articulates/solve/sub_steps.hpp"
#include "articulates/solve/tree_drift.hpp"
#include "base/check.hpp"
#include "constraints/row_rule.hpp"
#include "constraints/stiff.hpp"
#include "forces/forces.hpp"
#include "forces/integrator.hpp"
#include "step/articulate_warnings.hpp"
#include "step/ledger_posts.hpp"
#include "step/phases.hpp"
#include "step/reject.hpp"
#include "step/rk4.hpp"
#include "step/share.hpp"
#include "step/touch.hpp"
#include "trees/tree.hpp"

namespace pantin::phases {

namespace {

DriftSettings drift_settings(const World& world) {
  const Settings& s = world.settings;
  const StepStage& p = world.stage;
  return {s.step, s.gravity, s.tolerance, s.energy_return, world.ledger.kept,
          p.from, p.to,      p.full,      p.first,         rule_of(world).backwards};
}

SubStepSettings sub_step_settings(const World& world) {
  const bool alike = rule_of(world).stages.size() == 1, first = world.stage.index == 0;
  return {world.settings.accuracy ? wanted_accuracy(world) : 0.0, first,
          alike   ? world.stage.h
          : first ? world.settings.step
                  : 0.0};
}

void drift_points(World& world) {
  share_each(world, world.loose_points.size(), [&](std::size_t i) {
    FreeMotion& m = world.free_motion[world.loose_points[i]];
    m.x += m.v * world.stage.h;
  });
}

/// Moves a body by `move(node, its motion)`; returns the work of pushes and twists [J].
template <class Move>
double drift_body(World& world, std::uint32_t slot, Move move) {
  const Vec3 gravity = world.settings.gravity;
  Motion& m = world.motion[slot];
  Node n{};
  n.is_body = true;
  n.slot = slot;
  n.mass = m.mass;
  n.inverse_mass = 1.0 / m.mass;
  n.inertia = m.inertia;
  n.inverse_inertia = inverse_inertia(m);
  n.turns = m.freedom != Freedom::point;
  load(n, world, gravity);
  const Vec3 x = n.x0;
  const double before = kinetic_energy(n);
  move(n, m);
  store(n, world);
  const bool pushed = norm2(m.force) > 0.0 || norm2(m.torque) > 0.0;
  return pushed ? kinetic_energy(n) - before - n.mass * dot(gravity, n.x0 - x) : 0.0;
}

template <class Move>
void drift_bodies(World& world, Move move) {
  constexpr std::size_t enough = 64;
  if (world.pushed) {  // their work is summed in order
    for (std::uint32_t slot : world.loose_bodies) post(world, Source::event, drift_body(world, slot, move));
    return;
  }
  share_blocks(world, world.loose_bodies.size(), enough, [&](std::size_t first, std::size_t last, int) {
    for (std::size_t i = first; i < last; i++) drift_body(world, world.loose_bodies[i], move);
  });
}

void post_work(World& world, const DriftReport& report) {
  post(world, Source::hand, report.hand);
  post(world, Source::motor, report.motor);
  post(world, Source::damper, report.damped);
  post(world, Source::limit, report.limit);
}

void count(World& world, const Articulate& articulate) {
  const DriftReport& report = articulate.report;
  world.stats.newton_iterations += report.iterations;
  world.stats.factorisations += report.factorisations;
  world.stats.halved_steps += report.halved;
  world.stats.fallback_steps += report.fallbacks;
  world.stats.solves++;
  world.stats.evaluations += report.evaluations;
  world.stats.worst_iterations = std::max(world.stats.worst_iterations, report.iterations);
  world.work += report.nonconservative_work;
  world.nonconservative_work += report.nonconservative_work;
  world.ledger.posted += std::fabs(report.nonconservative_work);
  post_work(world, report);
  post(world, Source::edit, report.after_edit);
  post_report(world, report);
  if (report.offsets_accepted > 0)
    tell_once(world, "notice", "a gap that no motion can close was taken as a constant offset of its hinges", "");
  if (report.unreached > 0.0)
    tell_unreached(world, report.unreached, "the motion of what is tied to " + first_of(world, articulate));
}

/// Which articulates laws act on, or may touch something; none: none.
std::vector<char> articulates_acted_on(const World& world) {
  if (!world.forces && !world.contact_finder && !world.solids) return {};
  std::vector<char> acted_on(world.articulates.size(), 0);
  const auto mark = [&](std::int32_t articulate) {
    if (articulate >= 0) acted_on[static_cast<std::size_t>(articulate)] = 1;
  };
  if (world.forces)
    for (const Receiver& r : world.forces->receivers) mark(r.articulate);
  if (world.contact_finder)
    for (std::uint32_t slot = 0; slot < world.bodies.slots(); slot++)
      if (world.bodies.alive_at(slot) && !world.bodies.at_slot(slot).shapes.empty())
        mark(world.motion[slot].articulate);
  if (world.solids)
    for (std::uint32_t slot = 0; slot < world.points.slots(); slot++)
      if (world.points.alive_at(slot)) mark(world.points.at_slot(slot).articulate);
  return acted_on;
}

/// Whether loading would leave the nodes as they are.
bool is_as_left(const World& world, const Articulate& articulate) {
  const Node& first = articulate.nodes.front();
  if (world.pushed || !same(first.force, world.settings.gravity * first.mass)) return false;
  return std::all_of(articulate.nodes.begin(), articulate.nodes.end(), [&](const Node& n) {
    if (!n.is_body) {
      const FreeMotion& m = world.free_motion[n.slot];
      return same(m.x, n.x0) && same(m.v, n.p0 * n.inverse_mass);
    }
    const Motion& m = world.motion[n.slot];
    const Quat q = n.turns ? normalised(n.q0) : n.q0;
    return same(m.x, n.x0) && same(m.p, n.p0) && same(m.angular, n.P0) && same(m.q, q);
  });
}

/// Whether nothing acts on what is tied between its drift and the projection of its velocities: all of it is done in one visit
/// then, while an articulate is in the cache.
bool ends_in_drift(const World& world) {
  return world.stage.last && !world.forces && !may_touch(world) && !world.ledger.kept;
}

void project(Articulate& articulate, const DriftSettings& settings) {
  articulate.projection_report = {};
  if (!articulate.by_tree) project_articulate(articulate, settings, articulate.projection_report);
}

/// Moves every articulate by `move(articulate, worker)`; a first stage begins with the state of the model.
template <class Move>
void drift_articulates(World& world, Move move) {
  share_articulates(
      world,
      [&](Articulate& articulate, int worker) {
        if (articulate.rest.asleep) return;
        if (world.stage.from == 0.0) {
          articulate.by_tree = articulate.by_tree && is_as_left(world, articulate);
          if (!articulate.by_tree)
            load(articulate, world, world.settings.gravity);
          else
            load_conditions(articulate, world);
          if (articulate.length_of_motion) grow_length_of_motion(articulate, world.settings.step);
        }
        begin_report(articulate);
        move(articulate, worker);
      },
      true);
  for (const auto& articulate : world.articulates) {
    if (articulate->rest.asleep) continue;
    if (world.stage.to == 1.0) warn(world, *articulate);
    tell_tensions(*articulate, world);
    post_solved_laws(world, *articulate);
    count(world, *articulate);
  }
}

/// Where it is in World::articulates.
std::size_t index_of(const World& world, const Articulate& articulate) {
  const Node& n = articulate.nodes.front();
  return static_cast<std::size_t>(n.is_body ? world.motion[n.slot].articulate
                                            : world.points.at_slot(n.slot).articulate);
}

void drift_by_midpoint(World& world) {
  const DriftSettings settings = drift_settings(world);
  const SubStepSettings wanted = sub_step_settings(world);
  if (wanted.accuracy > 0.0)
    while (world.trials.size() < static_cast<std::size_t>(world.workers->count()))
      world.trials.push_back(std::make_unique<Trial>());
  drift_points(world);
  std::vector<double> missed(wanted.accuracy > 0.0 ? world.bodies.slots() : 0, 0.0);  // [1/s]
  drift_bodies(world, [&](Node& n, Motion& m) {
    const double rate = drift_alone_accurately(n, world.stage.h, wanted, m.sub_steps);
    if (rate > 0.0) missed[n.slot] = rate;
  });
  for (std::size_t slot = 0; slot < missed.size(); slot++)
    if (missed[slot] > 0.0)
      tell_unreached(world, missed[slot],
                     "the turning of " + describe(world, world.bodies.id_at(static_cast<std::uint32_t>(slot))));
  const double tree = tree_accuracy(world);
  const bool ends = ends_in_drift(world);
  const std::vector<char> acted_on = tree > 0.0 ? articulates_acted_on(world) : std::vector<char>();
  while (tree > 0.0 && world.tree_workspaces.size() < static_cast<std::size_t>(world.workers->count()))
    world.tree_workspaces.push_back(std::make_unique<TreeWorkspace>());
  const auto drift_one = [&](Articulate& articulate, std::size_t worker) {
    if (tree > 0.0 && (acted_on.empty() || !acted_on[index_of(world, articulate)]) &&
        drift_as_tree(articulate, settings, tree, *world.tree_workspaces[worker], articulate.report))
      return;
    articulate.by_tree = false;
    if (wanted.accuracy == 0.0) return drift_midpoint(articulate, settings, articulate.report);
    drift_accurately(articulate, settings, wanted, *world.trials[worker]);
  };
  drift_articulates(world, [&](Articulate& articulate, int worker) {
    drift_one(articulate, static_cast<std::size_t>(worker));
    if (!ends) return;
    project(articulate, settings);
    if (!articulate.all_rigid || articulate.breakable) return;  // edits may follow
    articulate.totals = totals_of(articulate);
    store_early(articulate, world);
  });
}

void drift_by_euler(World& world) {
  const DriftSettings settings = drift_settings(world);
  drift_points(world);
  drift_bodies(world, [&](Node& n, Motion&) { drift_euler_alone(n, world.stage.h); });
  drift_articulates(world, [&](Articulate& articulate, int) {
    articulate.by_tree = false;
    drift_euler(articulate, settings, articulate.report);
  });
}

void project_articulates(World& world) {
  const DriftSettings settings = drift_settings(world);
  const LedgerMark before = ledger_mark(world, true);
  double returned = 0.0;
  if (!ends_in_drift(world))
    share_articulates(
        world,
        [&](Articulate& articulate, int) {
          if (!articulate.rest.asleep) project(articulate, settings);
        },
        true);
  for (const auto& articulate : world.articulates) {
    if (articulate->rest.asleep) continue;
    world.stats.projections += articulate->projection_report.exact_projections;
    post_work(world, articulate->projection_report);
    returned += articulate->projection_report.returned;
  }
  post_projection(world, before, returned);
}

/// Damped connections that are solved, once all kicks are over.
void settle_articulates(World& world) {
  const auto settles = [](const auto& articulate) { return !articulate->rest.asleep && is_to_settle(*articulate); };
  if (std::none_of(world.articulates.begin(), world.articulates.end(), settles)) return;
  const LedgerMark before = ledger_mark(world, true);
  share_articulates(world, [&](Articulate& articulate, int) {
    articulate.projection_report = {};
    if (!articulate.rest.asleep && is_to_settle(articulate))
      settle_velocities(articulate, articulate.projection_report);
  });
  for (const auto& articulate : world.articulates) post_work(world, articulate->projection_report);
  post_projection(world, before, 0.0);
}

void leave_velocities(World&) {}

/// How an integrator moves things over a stage of the step, and what it does with the velocities after a full sub-step.
struct Moves {
  Integrator integrator;
  void (*drift)(World&);
  void (*project)(World&);
  void (*settle)(World&);
};

constexpr std::array<Moves, integrators.size()> moves = {{
    {Integrator::verlet, drift_by_midpoint, project_articulates, settle_articulates},
    {Integrator::implicit, drift_by_midpoint, project_articulates, settle_articulates},
    {Integrator::euler, drift_by_euler, leave_velocities, leave_velocities},
    {Integrator::suzuki4, drift_by_midpoint, project_articulates, settle_articulates},
    {Integrator::rk4, take_rk4_stage, leave_velocities, leave_velocities},
    {Integrator::adaptive, drift_by_midpoint, project_articulates, settle_articulates},
}};

const Moves& moves_of(const World& world) {
  for (const Moves& m : moves)
    if (m.integrator == world.settings.integrator) return m;
  assume(false);
  return moves[0];
}

/// In two halves, with thermostats between.
void drift_halved(World& world) {
  const StepStage whole = world.stage;
  StepStage& p = world.stage;
  p.h = 0.5 * whole.h;
  p.to = 0.5 * (whole.from + whole.to);
  p.last = false;
  moves_of(world).drift(world);
  kick_by_thermostats(world, whole.h);
  p.from = p.to;
  p.to = whole.to;
  p.first = false;
  p.last = whole.last;
  moves_of(world).drift(world);
  p = whole;
}

}  // namespace

void drift(World& world) {
  const Timed timed(world.profile, Phase::drift);
  const LedgerMark before = ledger_mark(world, world.stage.index > 0);
  if (world.forces && world.forces->thermal)
    drift_halved(world);
  else
    moves_of(world).drift(world);
  post_drift(world, before);
}

void project_velocities(World& world) {
  if (!world.stage.last) return;
  const Timed timed(world.profile, Phase::project_velocities);
  moves_of(world).project(world);
  end_kick(world, 0.5 * world.stage.h);
  moves_of(world).settle(world);
}

}  // namespace pantin::phases
