#include "player/sweep/row.hpp"

#include <algorithm>
#include <cstdio>

#include "fields/measures.hpp"
#include "lua/scene/open.hpp"
#include "measure/measure.hpp"
#include "player/csv.hpp"
#include "player/run.hpp"
#include "player/study_run.hpp"
#include "scene/errors.hpp"
#include "scene/headway.hpp"
#include "scene/memory.hpp"

namespace pantin::player {
namespace {

std::string result_cell(const SceneValue& value) {
  if (const auto* number = std::get_if<double>(&value)) return number_text(*number);
  if (const auto* truth = std::get_if<bool>(&value)) return *truth ? "true" : "false";
  return std::get<std::string>(value);
}

void run_to_end(Scene& scene, const SceneOptions& options, std::optional<double> wanted) {
  const World& world = scene.world();
  double until = end_of(scene, wanted);
  Headway headway(world);
  MemoryLimit memory(options.memory_limit);
  while (world.time < until - 0.5 * world.settings.step && !scene.finished()) {
    scene.step();
    require(world.failure.empty(), world.failure);
    until = end_of(scene, wanted);
    headway.check(world, until);
    memory.check();
  }
}

constexpr const char* parts_of_probe[] = {" last", " least", " largest"};

void tell_probe(Cells& cells, const Probe& probe) {
  if (probe.values.empty()) return;
  double least = infinity, largest = -infinity;
  for (std::size_t i = 0; i < probe.values.size(); i++) {
    least = std::min(least, probe.values[i]);
    largest = std::max(largest, probe.values[i]);
  }
  const double told[] = {probe.values[probe.values.size() - 1], least, largest};
  for (std::size_t i = 0; i < 3; i++) cells.emplace_back(probe.name + parts_of_probe[i], number_text(told[i]));
}

/// A name with so many suffixes that it is not taken. Others stay others.
template <class IsTaken>
std::string free_name(std::string name, std::string_view suffix, const IsTaken& is_taken) {
  int own = 0;
  for (; name.ends_with(suffix); own++) name.resize(name.size() - suffix.size());
  while (is_taken(name) || own-- > 0) name += suffix;
  return name;
}

bool is_probe_column(const World& world, const std::string& name) {
  return std::ranges::any_of(world.probes, [&](const Probe& probe) {
    return std::ranges::any_of(parts_of_probe, [&](const char* part) { return name == probe.name + part; });
  });
}

void tell_scene(CaseRow& row, const Scene& scene, const std::string& failure) {
  const World& world = scene.world();
  const auto is_taken = [&](const std::string& name) { return is_probe_column(world, name); };
  for (const auto& [name, value] : scene.results())
    row.told.emplace_back(free_name(name, " told", is_taken), result_cell(value));
  for (const Probe& probe : world.probes) tell_probe(row.probes, probe);
  const Stats& stats = world.stats;
  const Accuracy worst = fields::worst_accuracy(world);
  row.measured = {{"time", number_text(world.time)},
                  {"steps", std::to_string(world.steps)},
                  {"hinge_gap", number_text(worst.hinge_gap)},
                  {"constraint", number_text(worst.constraint)},
                  {"penetration", number_text(worst.penetration)},
                  {"energy_error", number_text(worst.energy)},
                  {"iterations", std::to_string(stats.newton_iterations + stats.contact_iterations)},
                  {"halved_steps", std::to_string(stats.halved_steps)},
                  {"fallback_steps", std::to_string(stats.fallback_steps)},
                  {"factorisations", std::to_string(stats.factorisations)}};
  // A failed case ends where a limit met it: amid a step, each time elsewhere.
  row.measured.push_back(failure.empty() ? std::pair("hash", hex_text(state_hash(world)))
                                         : std::pair("error", failure));
}

void add_names(std::vector<std::string>& names, const Cells& cells) {
  for (const auto& [name, value] : cells)
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
}

const std::string& cell_of(const Cells& cells, const std::string& name) {
  static const std::string empty;
  for (const auto& [other, value] : cells)
    if (other == name) return value;
  return empty;
}

std::string unit_of(const std::string& measure) {
  if (measure == "time" || measure == "seconds") return "s";
  return measure == "hinge_gap" || measure == "constraint" || measure == "penetration" ? "m" : "";
}

bool is_measure(const std::string& name) { return name == "case" || std::ranges::count(measures, name); }

std::string set_column(const std::string& name) { return free_name(name, " set", is_measure); }

/// A fraction as the number that it is; another text as it is.
std::string as_number(const std::string& value) {
  if (value.find('/') == std::string::npos) return value;
  const auto x = number_or_fraction(value);
  return x ? number_text(*x) : value;
}

}  // namespace

CaseRow run_case(std::uint64_t number, const std::string& path, const SceneOptions& options,
                 std::optional<double> until, bool timed) {
  CaseRow row;
  row.number = number;
  const double start = processor_time();
  SceneOptions noting = options;
  noting.on_read = [&](const FileRead& file) { row.files.emplace_back(file.path, hash_text(file.content)); };
  try {
    const auto scene = lua::open_scene(path, noting);
    std::string failure;
    try {
      run_to_end(*scene, options, until);
      failure = scene->broken_off();
    } catch (const Error& error) { failure = error.what(); }
    tell_scene(row, *scene, failure);
  } catch (const std::exception& error) { row.measured.emplace_back("error", error.what()); }
  if (timed) row.measured.emplace_back("seconds", number_text(processor_time() - start));
  return row;
}

std::string error_of(const CaseRow& row) { return cell_of(row.measured, "error"); }

std::string told_column(const Cases& cases, const std::string& name) {
  return free_name(name, " told", [&](const std::string& other) {
    return is_measure(other) ||
           std::ranges::any_of(cases.axes(), [&](const Axis& axis) { return set_column(axis.name) == other; });
  });
}

std::vector<Column> case_columns(const Cases& cases, const std::map<std::uint64_t, CaseRow>& rows, bool timed) {
  std::vector<Column> columns;
  const auto add = [&](const std::string& name, const std::string& unit, auto cell) {
    std::vector<std::string> cells;
    for (const auto& [number, row] : rows) cells.push_back(cell(row));
    columns.push_back({name, unit, std::move(cells), name == "hash" || name == "error"});
  };
  add("case", "", [](const CaseRow& row) { return std::to_string(row.number); });
  for (std::size_t a = 0; a < cases.axes().size(); a++) {
    add(set_column(cases.axes()[a].name), "",
        [&](const CaseRow& row) { return as_number(cases.settings(row.number)[a].second); });
  }
  std::vector<std::string> told;
  for (const auto& [number, row] : rows) add_names(told, row.told);
  for (const auto& [number, row] : rows) add_names(told, row.probes);
  for (const std::string& name : told)
    add(told_column(cases, name), "", [&](const CaseRow& row) {
      const std::string& result = cell_of(row.told, name);
      return result.empty() ? cell_of(row.probes, name) : result;
    });
  for (const std::string name : measures)
    if (timed || name != "seconds")
      add(name, unit_of(name), [&](const CaseRow& row) { return cell_of(row.measured, name); });
  return columns;
}

}  // namespace pantin::player
