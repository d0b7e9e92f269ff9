#include "articulates/solve/moment.hpp"

#include "articulates/solve/conditions.hpp"
#include "articulates/solve/momenta.hpp"
#include "articulates/solve/newton.hpp"
#include "articulates/solve/node_batches.hpp"
#include "articulates/solve/project.hpp"
#include "articulates/solve/state.hpp"
#include "articulates/solve/wanted_velocities.hpp"

namespace pantin {

void stand_still(Articulate& a, double step, double at) {
  set_conditions(a, step, at, at);
  for (Node& n : a.nodes) set_end_from_start(n);
  for (Condition& c : a.conditions) c.angle1 = c.angle0;  // an attempt that failed left another
  place_rows_at_end(a);
}

double make_consistent_at(Articulate& a, const DriftSettings& settings, double at, DriftReport& report,
                          double struck_for) {
  const double before = kinetic_energy(a);
  stand_still(a, settings.step, at);
  const WantedVelocities wanted(a, settings.step, at);
  const bool at_distance = acts_at_distance(a);
  const Momenta momenta = at_distance ? momenta_of(a) : Momenta{};
  const ImpulseWork work = make_consistent(a, 0.5 * settings.full, struck_for);
  if (at_distance) restore_momenta(a, momenta);
  report.tell(work);
  return kinetic_energy(a) - before - work.all();
}

void begin_part_at(Articulate& a, const DriftSettings& settings, double at, DriftReport& report) {
  const double given = make_consistent_at(a, settings, at, report);
  report.energy_projected += given;
  a.symmetric_energy += given;
}

void begin_cut(Articulate& a, const DriftSettings& settings, double at, DriftReport& report) {
  begin_exerted(a);
  begin_part_at(a, settings, at, report);
}

}  // namespace pantin
