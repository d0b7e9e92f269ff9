#include "player/json.hpp"
#include "player/report.hpp"

namespace pantin::player {
namespace {

Json of_run(const Study& study, const StudyRun& run) {
  Json json;
  json["integrator"] = run.integrator;
  json["step"] = run.step;
  if (run.accuracy > 0.0) json["accuracy"] = run.accuracy;
  if (!run.trouble.empty()) json["trouble"] = run.trouble;
  json["reference"] = &run == &study.finest();
  json["from_reference"] = &run == &study.finest() ? 0.0 : run.error;
  json["error_at_most"] = study.error_of(run);
  json["worst_error_at_most"] = study.farthest_of(run);
  json["order"] = run.order;
  json["true_until"] = run.true_until;
  json["ms_per_second"] = 1e3 * run.cost();
  json["ns_per_step"] = 1e9 * run.seconds / static_cast<double>(run.steps);
  json["steps"] = run.steps;
  json["newton_iterations"] = run.stats.newton_iterations;
  json["solves"] = run.stats.solves;
  json["halved_steps"] = run.stats.halved_steps;
  json["fallback_steps"] = run.stats.fallback_steps;
  json["worst_penetration"] = run.worst.penetration;
  json["unsolved_islands"] = run.stats.unsolved_islands;
  if (!run.overlap.empty()) json["deep_overlap"] = run.overlap;
  json["worst_hinge_gap"] = run.worst.hinge_gap;
  json["worst_constraint"] = run.worst.constraint;
  json["worst_energy"] = run.worst.energy;
  return json;
}

Json of_ledger(const LedgerLines& ledger) {
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

}  // namespace

std::string report_json(const Study& study, double product_ns) {
  Json json;
  json["scene"] = study.path;
  json["title"] = study.title;
  json["until"] = study.until;
  json["asked_until"] = study.wanted_until;
  json["size"] = study.size;
  json["things"] = study.things;
  json["moved"] = study.moved;
  json["energy_return"] = study.energy_return;
  json["together_until"] = study.together;
  json["comparable_until"] = study.comparable;
  json["growth"] = study.growth;
  json["chaotic"] = study.chaotic;
  json["unresolved"] = study.unresolved();
  json["product_ns"] = product_ns;
  if (study.ledger) {
    json["ledger"] = of_ledger(*study.ledger);
    json["ledger"]["until"] = study.ledger->time;
  } else {
    json["ledger"] = nullptr;
  }
  json["runs"] = Json::array();
  for (const StudyRun& run : study.runs) json["runs"].push_back(of_run(study, run));
  json["left_out"] = Json::object();
  for (const Refused& refused : study.refused) json["left_out"][refused.integrator] = refused.why;
  json["advice"] = advice(study);
  json["warnings"] = study.warnings;
  return text_of(json);
}

}  // namespace pantin::player
