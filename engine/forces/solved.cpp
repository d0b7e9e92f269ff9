#include "forces/solved.hpp"

#include <algorithm>

#include "articulates/articulate.hpp"
#include "constraints/stiff.hpp"
#include "forces/forces_parts.hpp"
#include "forces/integrator.hpp"

namespace pantin {

bool can_be_solved(const World& world, const Connection& c) {
  if (world.settings.box || c.count != 2) return false;
  const Vec3 ends = end_of(world, c, 0) - end_of(world, c, 1);
  if (norm(ends - world.plane.along(ends)) > 1e-9 * norm(ends)) return false;  // articulates are solved at one height
  for (auto law = c.law; law; law = law->also)
    if (!PairCurve::possible(*law)) return false;
  return true;
}

namespace {

/// Time stands still within what is solved: a law of time is asked once a step. Where an accuracy is wanted that will not do.
bool needs_its_time(const World& world, const Connection& c) {
  bool timed = false;
  for (auto law = c.law; law; law = law->also) timed = timed || law->timed;
  return timed && world.settings.accuracy && rule_of(world).divides;
}

}  // namespace

void choose_solved(World& world) {
  const bool ties = rule_of(world).ties;
  for (ConnectionId id : world.connections.ids()) {
    Connection& c = world.connections[id];
    Solve solve = c.asked;
    if (solve == Solve::explicitly && (c.too_stiff || world.settings.integrator == Integrator::implicit))
      solve = Solve::at_middle;
    if (solve != Solve::explicitly && (!ties || !can_be_solved(world, c) || needs_its_time(world, c)))
      solve = Solve::explicitly;
    if (solve == c.solve) continue;
    c.solve = solve;
    c.tension = 0.0;
    for (ParticleId end : {c.particles[0], c.particles[1]})
      if (end) mark_edited(world, end);
  }
}

void set_solved_inputs(World& world, bool only_changing) {
  for (const auto& articulate : world.articulates)
    for (Condition& condition : articulate->conditions) {
      if (!condition.stiff) continue;
      bool changed = false;
      StiffBond& tie = *condition.stiff;
      const Connection& c = world.connections[tie.connection];
      std::shared_ptr<const Law> law = c.law;
      for (PairCurve& curve : tie.curves) {
        const std::vector<double> parameters = present_parameters(world, *law, c.parameters);
        for (std::size_t i = 0; i < curve.inputs().size(); i++) {
          const Input& input = curve.inputs()[i];
          if (input.role == Role::parameter && !only_changing) {
            const auto named = [&](const Parameter& p) { return p.name == input.name; };
            const auto found = std::find_if(law->parameters.begin(), law->parameters.end(), named);
            changed |= curve.set(i, parameters[static_cast<std::size_t>(found - law->parameters.begin())]);
          } else if (input.role == Role::time) {
            changed |= curve.set(i, 0.5 * (world.time + next_time(world)));
          } else if (input.role == Role::attribute) {
            const ParticleId end = c.particles[input.who];
            changed |= curve.set(i, end ? attribute(world, end, input.name).value_or(0.0) : 0.0);
          }
        }
        law = law->also;
      }
      if (changed) wake(*articulate);
    }
}

namespace {

/// Tension / distance of the law stands for the largest slope of its force.
std::shared_ptr<const Law> slope_of(const Law& law) {
  auto slope = std::make_shared<Law>(law);
  Expressions& g = slope->graph;
  const Expr along = g.apply(Function::abs, law.stiffness), across = g.apply(Function::abs, law.force[0]);
  slope->force = {g.apply(Function::maximum, along, across)};
  slope->energy = no_expression;
  slope->also = nullptr;
  return slope;
}

/// How far a unit impulse moves a site, at most, [1/kg]; and whether it is bound to what rows hold, whose velocities are
/// projected.
struct Give {
  double mobility = 0.0;
  bool held = false;
};

/// What rows that are not soft do to a node: nothing, hold it, or nail a point, which then does not move.
enum class Grip : std::uint8_t { none, held, nailed };

std::vector<Grip> grips(const Articulate& articulate) {
  std::vector<Grip> list(articulate.nodes.size(), Grip::none);
  for (const Row& row : articulate.rows) {
    if (is_soft(row)) continue;
    const auto a = static_cast<std::size_t>(row.a);
    const bool nails = row.b < 0 && is_rigid(row) && !articulate.nodes[a].turns;
    if (list[a] != Grip::nailed) list[a] = nails ? Grip::nailed : Grip::held;
    if (row.b >= 0) list[static_cast<std::size_t>(row.b)] = std::max(list[static_cast<std::size_t>(row.b)], Grip::held);
  }
  return list;
}

std::vector<Give> gives(const World& world, const Forces& f) {
  std::vector<Give> list(f.sites.n);
  for (std::size_t i = 0; i < f.sites.n; i++) list[i].mobility = f.inverse_mass[i];
  std::vector<std::vector<Grip>> on;
  for (const auto& articulate : world.articulates) on.push_back(grips(*articulate));
  for (const Attached& a : f.attached) {
    const Receiver& m = f.receivers[a.receiver];
    Give& give = list[a.site];
    const Grip grip = m.articulate < 0 ? Grip::none : on[static_cast<std::size_t>(m.articulate)][m.node];
    if (grip == Grip::nailed) continue;
    give.held = grip == Grip::held;
    if (!m.is_body) {
      give.mobility = 1.0 / world.points.at_slot(m.slot).mass;
      continue;
    }
    const Motion& motion = world.motion[m.slot];
    const Vec3 l = a.arm, i = inverse_inertia(motion);
    give.mobility = 1.0 / motion.mass +
                    dot(i, vec(l[1] * l[1] + l[2] * l[2], l[2] * l[2] + l[0] * l[0], l[0] * l[0] + l[1] * l[1]));
  }
  return list;
}

/// A connection that could be solved, by its ends' sites, with the slopes of its force by distance [N/m] and by rate
/// [N s/m].
struct Candidate {
  ConnectionId id;
  std::uint32_t a, b;
  double slope, damping;
};

/// (connections) how much the force changes with the rate of the distance [N s/m].
std::vector<double> dampings(const World& world, const Forces& f, ActingConnections& acting) {
  std::vector<double> list(acting.ids.size(), 0.0);
  if (!acting.law->velocity_dependent) return list;
  std::vector<VelocityPair> pairs;
  SiteSlopes none;
  acting.bonds.add_slopes(f.sites, box_of(world), instant_of(world, world.time, world.instant), {}, *world.workers,
                          none, pairs);
  for (std::size_t k = 0; k < pairs.size(); k++) list[acting.bonds.number(k)] = std::fabs(trace(pairs[k].slope));
  return list;
}

std::vector<Candidate> candidates(const World& world, Forces& f) {
  std::vector<Candidate> list;
  const KeptForces kept(f.sites);
  for (ActingConnections& acting : f.connections) {
    if (acting.ids.empty() || acting.solved || !PairCurve::possible(*acting.law)) continue;
    Bonds slopes(slope_of(*acting.law), f.sites.names, *world.workers);
    slopes.arrange(acting.bond_list, f.sites);
    slopes.add_forces(f.sites, box_of(world), instant_of(world, world.time, world.instant), {}, *world.workers);
    const std::vector<double> damping = dampings(world, f, acting);
    for (std::size_t k = 0; k < acting.ids.size(); k++) {
      const std::uint32_t a = acting.bond_list.sites[2 * k], b = acting.bond_list.sites[2 * k + 1];
      const double slope = slopes.pull(k, f.sites, box_of(world));
      if (std::isfinite(slope)) list.push_back({acting.ids[k], a, b, slope, damping[k]});
    }
  }
  return list;
}

}  // namespace

bool find_too_stiff(World& world, Forces& f) {
  if (world.settings.box || f.connections.empty() || !rule_of(world).ties) return false;
  const std::vector<Candidate> list = candidates(world, f);
  const std::vector<Give> give = gives(world, f);
  std::vector<double> sums(f.sites.n, 0.0);
  const double h = world.stage.full;
  for (const Candidate& c : list)
    for (std::uint32_t site : {c.a, c.b}) sums[site] += h * h * c.slope * give[site].mobility;
  std::vector<const Law*> told;
  bool any = false;
  for (const Candidate& c : list) {
    Connection& row = world.connections[c.id];
    const double limit = give[c.a].held || give[c.b].held ? 0.01 : 2.5;
    const bool stiff = sums[c.a] + sums[c.b] > limit;
    const bool strong = h * c.damping * (give[c.a].mobility + give[c.b].mobility) > 1.0;
    if (row.too_stiff || !(stiff || strong) || !can_be_solved(world, row)) continue;
    row.too_stiff = any = true;
    const bool by_itself = strong || c.slope > 0.0;  // else what is beside it is stiff, and told
    if (!by_itself || std::find(told.begin(), told.end(), row.law.get()) != told.end()) continue;
    told.push_back(row.law.get());
    const bool by_slope = !strong || h * h * c.slope * (give[c.a].mobility + give[c.b].mobility) > limit;
    log_line(
        world, "notice",
        text(law_in_place(row), ": connections as ", by_slope ? "stiff" : "strongly damped", " as ",
             describe(world, c.id), " (", by_slope ? c.slope : c.damping, by_slope ? " N/m" : " N s/m",
             ") are solved with what they tie, since steps of ", h, " s are too long for them", try_accuracy(world)));
  }
  return any;
}

}  // namespace pantin
