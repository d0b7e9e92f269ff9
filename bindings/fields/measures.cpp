// What is measured of the whole world.
#include "fields/measures.hpp"

#include <cmath>
#include <cstdio>
#include <string>

#include "articulates/articulate.hpp"
#include "fields/make.hpp"
#include "forces/forces.hpp"
#include "forces/integrator.hpp"
#include "forces/sleep.hpp"
#include "measure/ledger_closure.hpp"
#include "measure/measure.hpp"
#include "measure/query.hpp"

namespace pantin::fields {
namespace {

Table table_of_numbers(const std::map<std::string, double>& numbers) {
  Table table;
  for (const auto& [name, value] : numbers) table.push_back({name, value});
  return table;
}

Table errors(const World& world) {
  const Accuracy now = accuracy(world), worst = worst_accuracy(world);
  return {{"penetration", now.penetration},         {"hinge_gap", now.hinge_gap},
          {"constraint", now.constraint},           {"energy", now.energy},
          {"worst_penetration", worst.penetration}, {"worst_hinge_gap", worst.hinge_gap},
          {"worst_constraint", worst.constraint},   {"worst_energy", worst.energy}};
}

Table ledger(const World& world) {
  const LawLedger laws = law_ledger(world);
  Table without_energy;
  for (const std::string& name : laws.without_energy) without_energy.push_back({"", name});
  Table table = {
      {"laws", table_of_numbers(laws.given)}, {"without_energy", std::move(without_energy)}, {"open", laws.open}};
  const Ledger& kept = world.ledger;
  std::array<double, source_names.size()> given = kept.given;
  if (world.steps > 0 && !acting_now(world))  // the next step brings it in again
    given[static_cast<std::size_t>(Source::law)] += law_energy(world);
  for (std::size_t i = 0; i < source_names.size(); i++) table.push_back({std::string(source_names[i]), given[i]});
  if (!kept.kept) return table;
  table.push_back({"since", kept.since});
  table.push_back({"gravity", kept.gravity});
  table.push_back({"closure", closure(world)});
  table.push_back({"truncation", table_of_numbers(truncation(world))});
  return table;
}

Table ns_per_phase(const World& world) {
  Table table;
  table.reserve(phase_names.size());
  for (std::size_t i = 0; i < phase_names.size(); i++)
    table.push_back({std::string(phase_names[i]), static_cast<double>(world.profile.ns[i])});
  return table;
}

Table stats(const World& world) {
  const Stats& s = world.stats;
  MostSubSteps most = most_sub_steps(world);
  Table table;
  table.reserve(20);
  const auto count = [&](const char* name, std::uint64_t value) {
    table.push_back({name, static_cast<std::int64_t>(value)});
  };
  count("steps", world.steps);
  count("articulates", world.articulates.size());
  count("asleep", sleepers(world));
  count("newton_iterations", s.newton_iterations);
  count("worst_iterations", s.worst_iterations);
  count("solves", s.solves);
  count("factorisations", s.factorisations);
  count("halved_steps", s.halved_steps);
  count("fallback_steps", s.fallback_steps);
  count("rejected_steps", s.rejected);
  table.push_back({"missed_accuracy", worst_missed(world)});
  count("projections", s.projections);
  count("evaluations", s.evaluations);
  count("contacts", s.contacts);
  count("contact_islands", s.contact_islands);
  count("contact_iterations", s.contact_iterations);
  count("unsolved_islands", s.unsolved_islands);
  table.push_back({"gains_taken_back", s.gains_taken_back});
  count("sub_steps", world.sub_steps.count);
  count("most_sub_steps", most.count);
  table.push_back({"most_sub_steps_of", std::move(most.thing)});
  table.push_back({"ns", ns_per_phase(world)});
  return table;
}

/// By pair, without things where one of the two is gone.
Table contact_heat(const World& world) {
  Table list;
  for (const TouchHeat& one : world.contacts.heat) {
    Table entry;
    if (one.pair != TouchPair{}) {
      entry.push_back({"a", one.pair.a});
      entry.push_back({"b", one.pair.b});
    }
    entry.push_back({"heat", one.heat});
    list.push_back({"", std::move(entry)});
  }
  return list;
}

Table log_of(const World& world) {
  Table list;
  list.reserve(world.log.size());
  for (const LogLine& line : world.log)
    list.push_back({"", Table{{"time", line.time}, {"kind", line.kind}, {"text", line.text}}});
  return list;
}

using None = std::monostate;

std::vector<Property> sums() {
  return {
      property<None>("time", "number", "s", "simulated time", [](const World& w, None) { return w.time; }),
      property<None>("energy", "Energy", "J", "of all things",
                     [](const World& w, None) { return table_of(energy(w)); }),
      property<None>("momentum", "vec", "kg m/s", "sum over all things",
                     [](const World& w, None) { return momentum(w, everything(w)); }),
      property<None>("angular_momentum", "vec", "kg m²/s", "sum over all things about the world's origin",
                     [](const World& w, None) { return angular_momentum(w, everything(w)); }),
      property<None>("temperature", "number", "K", "relative to the common motion; in J while scene.boltzmann is 1",
                     [](const World& w, None) { return temperature(w, everything(w)); }),
  };
}

std::vector<Property> accounts() {
  return {
      property<None>("error", "Accuracy", "", "what is left open now, and the worst since the start",
                     [](const World& w, None) { return errors(w); }),
      property<None>(
          "ledger", "Ledger", "J",
          "where energy came from and went since the start; the first reading has all of it kept from the next step on",
          [](const World& w, None) { return ledger(w); }),
      property<None>(
          "contact_heat", "ContactHeat[]", "",
          "what friction and impact took, by who touches; the first reading has it kept from the next step on",
          [](const World& w, None) { return contact_heat(w); }),
      property<None>("stats", "Stats", "", "counts since the start, and ns per phase",
                     [](const World& w, None) { return stats(w); }),
      property<None>("log", "LogLine[]", "", "all that was logged", [](const World& w, None) { return log_of(w); }),
      property<None>("timeline", "TimelineEntry[]", "",
                     "events that ended, then those that wait: the latest and the next 1000",
                     [](const World& w, None) { return timeline_of(w); }),
  };
}

std::vector<Property> things() {
  return {
      property<None>("bodies", "Body[]", "", "all bodies, in the order of making",
                     [](const World& w, None) { return w.bodies.ids(); }),
      property<None>("particles", "Particle[]", "", "all particles that are no hinges, and do not sleep in one",
                     [](const World& w, None) { return particles(w); }),
      property<None>("hash", "string", "",
                     "16 hexadecimal digits that all positions and velocities make: equal states have equal ones",
                     [](const World& w, None) {
                       char digits[17];
                       std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(state_hash(w)));
                       return std::string(digits);
                     }),
      property<None>("hinges", "Particle[]", "", "all hinges", [](const World& w, None) { return hinges(w); }),
      property<None>("connections", "Connection[]", "", "all connections, in the order of making",
                     [](const World& w, None) { return w.connections.ids(); }),
  };
}

std::vector<Property> measures() {
  std::vector<Property> all;
  for (const auto& some : {sums(), accounts(), things()}) all.insert(all.end(), some.begin(), some.end());
  return all;
}

}  // namespace

Accuracy worst_accuracy(const World& world) {
  const Accuracy now = accuracy(world);
  Accuracy worst = world.worst;
  worst.penetration = std::fmax(worst.penetration, now.penetration);
  worst.hinge_gap = std::fmax(worst.hinge_gap, now.hinge_gap);
  worst.constraint = std::fmax(worst.constraint, now.constraint);
  worst.energy = std::fmax(worst.energy, now.energy);
  return worst;
}

Table table_of(const Energy& energy) {
  return {{"kinetic", energy.kinetic}, {"potential", energy.potential}, {"total", energy.total()}};
}

const Type& any_scene_type() {
  static const Type type = {"AnyScene", "scene",
                            "What a scene tells of itself: to its script, and to a test that opened it.", measures()};
  return type;
}

}  // namespace pantin::fields
