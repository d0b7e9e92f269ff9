#include "player/summary.hpp"

#include <algorithm>
#include <cstdio>

#include "forces/forces.hpp"
#include "forces/integrator.hpp"
#include "forces/sleep.hpp"
#include "measure/measure.hpp"
#include "player/closing.hpp"
#include "player/json.hpp"

namespace pantin::player {
namespace {

Json ns_per_phase(const World& world) {
  Json result = Json::object();
  for (std::size_t i = 0; i < phase_names.size(); i++)
    result[std::string(phase_names[i])] =
        static_cast<double>(world.profile.ns[i]) / static_cast<double>(std::max<std::uint64_t>(1, world.steps));
  return result;
}

Json stats(const World& world) {
  const Stats& s = world.stats;
  return {{"articulates", world.articulates.size()},
          {"asleep", sleepers(world)},
          {"bodies", world.bodies.size()},
          {"constraints", world.constraints.size()},
          {"newton_iterations", s.newton_iterations},
          {"worst_iterations", s.worst_iterations},
          {"solves", s.solves},
          {"factorisations", s.factorisations},
          {"halved_steps", s.halved_steps},
          {"fallback_steps", s.fallback_steps},
          {"projections", s.projections},
          {"rejected_steps", s.rejected},
          {"sub_steps", world.sub_steps.count},
          {"most_sub_steps", most_sub_steps(world).count},
          {"most_sub_steps_of", most_sub_steps(world).thing}};
}

Json results(const Scene& scene) {
  Json list = Json::object();
  for (const auto& result : scene.results()) std::visit([&](const auto& v) { list[result.first] = v; }, result.second);
  return list;
}

}  // namespace

Json json_of(const LedgerLines& ledger) {
  const Ledger& posts = ledger.posts;
  Json result;
  result["laws"] = ledger.laws.given;
  result["open"] = ledger.laws.open;
  for (std::size_t i = 0; i < source_names.size(); i++) result[std::string(source_names[i])] = posts.given[i];
  if (!posts.kept) return result;
  result["since"] = posts.since;
  result["gravity"] = posts.gravity;
  result["closure"] = ledger.closure;
  result["truncation"] = ledger.truncation;
  return result;
}

std::string text_of(const Json& json) {
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::string summary(const Scene& scene, const std::string& failure) {
  const World& world = scene.world();
  Energy now = energy(world);
  char hash[17];
  std::snprintf(hash, sizeof hash, "%016llx", static_cast<unsigned long long>(state_hash(world)));
  Json result;
  result["title"] = scene.title();
  result["time"] = world.time;
  result["steps"] = world.steps;
  result["hash"] = hash;
  result["energy"] = {{"kinetic", now.kinetic}, {"potential", now.potential}, {"total", now.total()}};
  result["error"] = {{"hinge_gap", world.error.hinge_gap},
                     {"constraint", world.error.constraint},
                     {"energy", world.error.energy},
                     {"worst_hinge_gap", world.worst.hinge_gap},
                     {"worst_energy", world.worst.energy}};
  if (world.settings.accuracy)
    result["accuracy"] = {{"wanted", *world.settings.accuracy},
                          {"per", world.settings.accuracy_per_step ? "step" : "second"},
                          {"missed", world.stats.unreached},
                          {"worst_missed", worst_missed(world)}};
  result["ledger"] = json_of(ledger_lines(world));
  result["stats"] = stats(world);
  result["ns_per_phase"] = ns_per_phase(world);
  result["results"] = results(scene);
  std::vector<std::string> warnings = scene.warnings();
  if (const auto wrong = energy_gone_wrong(world)) warnings.push_back(*wrong);
  result["warnings"] = warnings;
  result["notices"] = scene.notices();
  if (const std::string& why = failure.empty() ? world.failure : failure; !why.empty()) result["failure"] = why;
  return text_of(result);
}

}  // namespace pantin::player
