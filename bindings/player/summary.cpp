#include "player/summary.hpp"

#include <algorithm>

#include "fields/property.hpp"
#include "forces/integrator.hpp"
#include "measure/measure.hpp"
#include "player/closing.hpp"
#include "player/csv.hpp"
#include "player/json.hpp"

namespace pantin::player {
namespace {

/// A property of the whole world.
Json property(const World& world, const char* name) { return json_of(fields::read(world, {}, name)); }

Json ns_per_phase(const World& world, const Json& ns) {
  Json result = Json::object();
  for (const auto& [phase, sum] : ns.items())
    result[phase] = sum.get<double>() / static_cast<double>(std::max<std::uint64_t>(1, world.steps));
  return result;
}

/// But for what stands elsewhere in the summary.
Json stats(const World& world, Json all) {
  all.erase("ns");
  all.erase("steps");
  all["bodies"] = world.bodies.size();
  all["constraints"] = world.constraints.size();
  return all;
}

Json results(const Scene& scene) {
  Json list = Json::object();
  for (const auto& result : scene.results()) std::visit([&](const auto& v) { list[result.first] = v; }, result.second);
  return list;
}

}  // namespace

Json json_of(const fields::Value& value) {
  if (const auto* number = std::get_if<double>(&value)) return *number;
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return *whole;
  if (const auto* truth = std::get_if<bool>(&value)) return *truth;
  if (const auto* words = std::get_if<std::string>(&value)) return *words;
  if (const auto* v = std::get_if<Vec3>(&value)) return {(*v)[0], (*v)[1], (*v)[2]};
  const auto* table = std::get_if<fields::Table>(&value);
  if (!table) return nullptr;
  const bool list = !table->empty() && table->front().name.empty();
  Json json = list ? Json::array() : Json::object();
  for (const fields::Entry& entry : *table)
    if (list)
      json.push_back(json_of(entry.value));
    else
      json[entry.name] = json_of(entry.value);
  return json;
}

std::string text_of(const Json& json) {
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::string summary(const Scene& scene, const std::string& failure) {
  const World& world = scene.world();
  const Json all_stats = property(world, "stats");
  Json result;
  result["title"] = scene.title();
  result["time"] = property(world, "time");
  result["steps"] = world.steps;
  result["hash"] = hex_text(state_hash(world));
  result["energy"] = property(world, "energy");
  result["error"] = property(world, "error");
  if (const DeepestOverlap& deepest = world.contacts.deepest; deepest.part > 0.0)
    result["deepest_overlap"] = {{"depth", deepest.depth},
                                 {"part", deepest.part},
                                 {"things", {describe(world, deepest.pair.a), describe(world, deepest.pair.b)}},
                                 {"time", deepest.time}};
  if (world.settings.accuracy)
    result["accuracy"] = {{"wanted", property(world, "accuracy")},
                          {"per", property(world, "accuracy_per")},
                          {"missed", world.stats.unreached},
                          {"worst_missed", worst_missed(world)}};
  result["ledger"] = property(world, "ledger");
  result["ledger"].erase("without_energy");
  result["stats"] = stats(world, all_stats);
  result["ns_per_phase"] = ns_per_phase(world, all_stats.at("ns"));
  result["results"] = results(scene);
  std::vector<std::string> warnings = scene.warnings();
  if (const auto wrong = energy_gone_wrong(world)) warnings.push_back(*wrong);
  result["warnings"] = warnings;
  result["notices"] = scene.notices();
  if (const std::string& why = failure.empty() ? world.failure : failure; !why.empty()) result["failure"] = why;
  return text_of(result);
}

}  // namespace pantin::player
