#include "player/closing.hpp"

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <sstream>

#include "choreography/choreography.hpp"
#include "fields/measures.hpp"
#include "forces/forces.hpp"
#include "forces/integrator.hpp"
#include "lua/scene/open.hpp"
#include "measure/measure.hpp"
#include "player/home.hpp"
#include "player/message.hpp"
#include "scene/printable.hpp"
#include "step/articulate_warnings.hpp"

namespace pantin::player {
namespace {

std::string show(const SceneValue& value) {
  if (const double* number = std::get_if<double>(&value)) return to_text(*number);
  if (const bool* truth = std::get_if<bool>(&value)) return *truth ? "true" : "false";
  return std::get<std::string>(value);
}

/// Laws whose work no energy of theirs holds to account, as friction: the first suspects where the energy is wrong.
std::string suspects(const World& world) {
  std::string names;
  for (const std::string& name : law_ledger(world).without_energy) names += text(names.empty() ? "" : ", ", name);
  return names.empty() ? "" : text("; without an energy of their own act ", names);
}

/// Potentials whose energy no force of theirs on what they read pays for.
std::string unpaid(const World& world) {
  std::string all;
  for (const std::string& name : lua::one_sided_potentials(world)) all += (all.empty() ? "" : ", ") + name;
  if (all.empty()) return "";
  return "; potentials that read what they act on with no force give and take energy, which no shorter step mends: " +
         all;
}

bool tells(const World& world, std::string_view what) {
  return std::ranges::any_of(world.log, [&](const LogLine& line) { return line.text.find(what) != std::string::npos; });
}

/// What to do about an energy that went wrong.
std::string remedy(const World& world, const std::string& path) {
  if (tells(world, " cannot be kept: ")) return "; it goes where ties cannot be kept, which no shorter step mends";
  if (tells(world, held_by_itself)) return "; it goes where ties have no way to go, which no shorter step mends";
  return text(unpaid(world), "; `pantin report ", path, "` compares steps and integrators", try_accuracy(world),
              suspects(world));
}

}  // namespace

std::optional<std::string> energy_gone_wrong(const World& world) {
  if (fields::worst_accuracy(world).energy <= 0.1) return {};
  return "the energy went wrong by more than a tenth of what the scene exchanges";
}

namespace {

/// "body 'arm'", also of what is gone: "body 'arm' (removed at 1.5 s by scene.lua:12)"; where that is forgotten "a body
/// that is gone".
std::string name_of(const World& world, const AnyId& id) {
  const std::string told = describe(world, id), was = " was ";
  if (alive(world, id)) return told;
  if (const auto at = told.find(was + "removed at "); at != std::string::npos)
    return text(told.substr(0, at), " (", told.substr(at + was.size()), ")");
  return std::holds_alternative<BodyId>(id)       ? "a body that is gone"
         : std::holds_alternative<ParticleId>(id) ? "a particle that is gone"
                                                  : "a shape that is gone";
}

}  // namespace

std::optional<std::string> deep_overlap(const World& world) {
  const DeepestOverlap& deepest = world.contacts.deepest;
  if (deepest.part == 0.0) return {};
  char how[100], when[40];
  std::snprintf(how, sizeof how, "shapes overlapped by up to %.3g m, %.3g %% of the thinner: ", deepest.depth,
                100.0 * deepest.part);
  std::snprintf(when, sizeof when, ", at %.4g s", deepest.time);
  const std::string a = name_of(world, deepest.pair.a), b = name_of(world, deepest.pair.b);
  return text(how, a, " and ", a == b ? "another" : b, when);
}

std::optional<std::string> loosely_solved(const World& world) {
  const std::uint64_t times = world.stats.unsolved_islands;
  if (times == 0) return {};
  return text("contacts of an island were solved more loosely than wanted ", times, times == 1 ? " time" : " times",
              " in ", world.steps, " steps");
}

std::optional<std::string> gains_taken_back(const World& world) {
  constexpr double told_from = 1e-2;
  const double part = world.stats.gains_taken_back / world.largest_kinetic;
  if (!(part > told_from)) return {};
  char line[200];
  std::snprintf(line, sizeof line,
                "contacts gave %.2g J too much, %.2g times the largest kinetic energy, which was taken back by slowing "
                "things down; a shorter step follows their blows",
                world.stats.gains_taken_back, part);
  return line;
}

void print_closing(const Scene& scene, const std::string& path, double seconds) {
  const World& world = scene.world();
  std::ostringstream told;
  char line[200];
  std::snprintf(line, sizeof line, ": %.6g s in %llu steps, %.2g s of wall time\n", world.time,
                static_cast<unsigned long long>(world.steps), seconds);
  told << scene_name(path) << line;
  const Accuracy now = accuracy(world), worst = fields::worst_accuracy(world);
  std::snprintf(line, sizeof line,
                "  energy error %.2g (worst %.2g)   largest gap %.2g m (worst %.2g m)   hash %016llx\n", now.energy,
                worst.energy, now.constraint, worst.constraint, static_cast<unsigned long long>(state_hash(world)));
  told << line;
  if (world.stats.fallback_steps > 0)
    told << text("  ", world.stats.fallback_steps,
                 " fallback steps, which only lose energy, where an articulate could not be solved\n");
  if (const auto overlap = deep_overlap(world)) told << "  " << *overlap << "\n";
  if (const auto loosely = loosely_solved(world)) told << "  " << *loosely << "\n";
  if (const auto gains = gains_taken_back(world)) told << "  " << *gains << "\n";
  if (const auto wrong = energy_gone_wrong(world)) told << "  " << *wrong << remedy(world, path) << "\n";
  if (world.settings.accuracy) {
    const MostSubSteps most = most_sub_steps(world);
    told << text("  accuracy ", *world.settings.accuracy,
                 world.settings.accuracy_per_step ? " per step took " : " per second took ", world.sub_steps.count,
                 world.sub_steps.count == 1 ? " sub-step" : " sub-steps", " of the scene in the last step, and ",
                 most.count, most.thing.empty() ? " of everything" : " of what moves with " + most.thing, "\n");
    if (world.stats.unreached > 0)
      told << text("  it was missed in ", world.stats.unreached, world.stats.unreached == 1 ? " step" : " steps",
                   world.stats.worst_unreached < 1.0 ? ", with an error of up to " : ", with an error of ",
                   told_rate(world, world.stats.worst_unreached), "\n");
  }
  for (const TimelineEntry& event : timeline(world))
    if (event.kind == EventKind::once && event.time <= with_round_off(world.time))
      if (event.state == EventState::waiting)
        told << "  what was set for " << to_text(event.time) << " s, when the run ends, is not done: " << event.label
             << "\n";
  for (const Probe& probe : world.probes)
    if (!probe.values.empty()) told << "  " << probe.name << " " << to_text(probe.values.back()) << "\n";
  for (const auto& [name, value] : scene.results()) told << "  " << name << " " << show(value) << "\n";
  for (const std::string& notice : scene.notices()) told << "  " << notice << "\n";
  std::cout << printable(told.str()) << std::flush;
  for (const std::string& warning : scene.warnings()) say(warning);
}

}  // namespace pantin::player
