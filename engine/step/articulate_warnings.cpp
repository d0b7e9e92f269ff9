#include "step/articulate_warnings.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "articulates/solve/row_gaps.hpp"
#include "constraints/row_rule.hpp"
#include "constraints/stiff.hpp"
#include "measure/query.hpp"

namespace pantin {

namespace {

/// What ties by a row, for whoever reads of it.
std::string describe_tie(const World& world, const Articulate& articulate, const Row& row) {
  if (row.condition < 0) return describe(world, world.points[row.member].particle);
  return describe(world, condition(articulate, row).constraint);
}

/// Names, once, a motor of unlimited torque that stands against a limit.
void tell_stalled(World& world, const Articulate& a) {
  if (a.all_rigid) return;
  const Row* limit = nullptr;
  for (const Condition& c : a.conditions)
    if (c.ranged && c.held && (limit == nullptr || norm2(row(a, c).f) > norm2(limit->f))) limit = &row(a, c);
  if (limit == nullptr) return;
  for (const Condition& c : a.conditions)
    if (std::isfinite(c.stall_force) && std::isinf(c.upper))
      tell_once(world, "warning", text(describe_tie(world, a, row(a, c)), " stalls: "),
                text(describe_tie(world, a, *limit), " does not let it turn"));
}

/// Names, once, what has stayed open for some steps: constraints contradict each other, or are pulled too far.
void tell_open(World& world, Articulate& a) {
  constexpr std::uint32_t some = 10;
  a.open_steps = a.gaps.unaccepted > world.settings.tolerance * a.length ? a.open_steps + 1 : 0;
  if (a.open_steps != some) return;
  const Row* worst = nullptr;
  double most = 0.0;
  for (const Row& row : a.rows) {
    const double open = is_soft(row) ? 0.0 : norm(gap(a, row));
    if (open <= most) continue;
    worst = &row;
    most = open;
  }
  if (worst == nullptr) return;
  const std::string what = describe_tie(world, a, *worst) + " cannot be kept: ";
  tell_once(world, "warning", what,
            text("it is open by ", most, " m, and what ties the same things contradicts it, or pulls them too far"));
}

/// Whether nothing was solved for some steps though nothing is open.
bool is_stuck(const World& world, const Articulate& a) {
  return a.fell_back && a.effort.failed >= most_failed && !(a.gaps.unaccepted > world.settings.tolerance * a.length);
}

/// Names the stiffest connection of what is not solved for some steps though it is not open; one of a scene is enough.
void tell_too_stiff(World& world, const Articulate& a) {
  constexpr std::string_view too_stiff = " is too stiff for the step: ";
  if (!is_stuck(world, a)) return;
  const StiffBond* stiffest = nullptr;
  double most = 0.0;
  for (const Condition& c : a.conditions) {
    if (!c.stiff) continue;
    double pull = 0.0;
    for (const double of_curve : c.stiff->pulls) pull += std::fabs(of_curve);
    if (!(pull > most)) continue;
    stiffest = c.stiff.get();
    most = pull;
  }
  const auto told = [&](const LogLine& line) { return line.text.find(too_stiff) != std::string_view::npos; };
  if (stiffest == nullptr || std::any_of(world.log.begin(), world.log.end(), told)) return;
  log_line(world, "warning",
           text(describe(world, stiffest->connection), too_stiff, "its motion at a step of ", world.settings.step,
                " s cannot be solved, and in fallback steps its length is held as it is; a rod keeps a length"));
}

/// Names, once, what bears a hundred times all that acts, where nothing is solved: it has no way to go that would bear less.
void tell_held_by_itself(World& world, Articulate& a) {
  constexpr double beyond_all = 100.0;
  constexpr std::uint32_t some = 60;
  a.stuck_steps = is_stuck(world, a) && !a.touches ? a.stuck_steps + 1 : 0;
  if (a.stuck_steps != some) return;
  double acts = 0.0, most = 0.0;  // [N]
  for (const Node& n : a.nodes) acts += norm(n.force);
  const Row* worst = nullptr;
  for (std::size_t k = 0; k < a.rows.size(); k++) {
    const double bears = is_soft(a.rows[k]) ? 0.0 : norm(force_in_drift(a, k));
    if (!(bears > std::max(most, beyond_all * acts))) continue;
    worst = &a.rows[k];
    most = bears;
  }
  if (worst == nullptr) return;
  tell_once(world, "warning", text(describe_tie(world, a, *worst), held_by_itself),
            text("it bears ", most, " N where ", acts,
                 " N act, as in a chain that is drawn straight between two nails; a little slack, a millimetre, bears "
                 "less"));
}

}  // namespace

/// What begins so is told once of a scene.
void tell_once(World& world, const std::string& kind, const std::string& what, const std::string& rest) {
  const auto told = [&](const LogLine& line) { return line.text.starts_with(what); };
  if (std::none_of(world.log.begin(), world.log.end(), told)) log_line(world, kind, what + rest);
}

/// The first thing of an articulate, for whoever reads of it.
std::string first_of(const World& world, const Articulate& articulate) {
  const Node& n = articulate.nodes[0];
  return n.is_body ? describe(world, world.bodies.id_at(n.slot))
                   : describe(world, world.points.at_slot(n.slot).particle);
}

void warn(World& world, Articulate& articulate) {
  tell_open(world, articulate);
  tell_stalled(world, articulate);
  tell_too_stiff(world, articulate);
  tell_held_by_itself(world, articulate);
}

}  // namespace pantin
