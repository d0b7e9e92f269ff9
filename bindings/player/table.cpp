#include "player/table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pantin::player {
namespace {

bool is_known(const Probe& probe, std::uint64_t step) {
  return step >= probe.first_step && step - probe.first_step < probe.values.size();
}

/// First known, or another number than in the step before.
bool changed(const Probe& probe, std::uint64_t step) {
  if (!is_known(probe, step)) return false;
  const std::uint64_t i = step - probe.first_step;
  return i == 0 || probe.values[i] != probe.values[i - 1];
}

/// The last step of each interval, the first of which begins before the first step, and those at which probes change.
std::vector<std::size_t> rows_due(const Times& all, const std::vector<Probe>& probes, const TableRows& rows) {
  const SharedList& times = all.values;
  std::vector<std::size_t> due;
  const auto interval = [&](double time) { return std::floor(time / rows.every * (1.0 + 1e-12) + 1e-9); };
  const auto by_time = [&](std::size_t i) {
    if (rows.every <= 0.0) return rows.when.empty();
    const double before = i > 0 ? times[i - 1] : times.size() == 1 ? 0.0 : times[0] - (times[1] - times[0]);
    return interval(times[i]) > interval(before);
  };
  const auto by_probe = [&](std::size_t i) {
    return std::ranges::any_of(probes, [&](const Probe& probe) {
      return std::ranges::count(rows.when, probe.name) > 0 && changed(probe, all.first_step + i);
    });
  };
  for (std::size_t i = 0; i < times.size(); i++)
    if (i + 1 == times.size() || by_time(i) || by_probe(i)) due.push_back(i);
  return due;
}

/// Those that are known, both ends with them.
std::vector<double> values_between(const Probe& probe, std::uint64_t first, std::uint64_t last) {
  std::vector<double> values;
  for (std::uint64_t step = first; step <= last; step++)
    if (is_known(probe, step)) values.push_back(probe.values[step - probe.first_step]);
  return values;
}

double reduced(const std::vector<double>& values, const std::string& reduction) {
  if (reduction == "least") return *std::ranges::min_element(values);
  if (reduction == "largest") return *std::ranges::max_element(values);
  double sum = 0.0;
  for (const double x : values) sum += reduction == "rms" ? x * x : x;
  const double mean = sum / static_cast<double>(values.size());
  return reduction == "rms" ? std::sqrt(mean) : mean;
}

}  // namespace

void Times::add(const World& world) {
  if (world.steps <= first_step) values = {};
  if (values.empty()) first_step = world.steps > 0 ? world.steps - 1 : 0;
  const std::size_t count = world.steps - first_step;
  values.shorten(count);
  for (std::size_t i = values.size(); i < count; i++)  // more than one where a script went forward again
    values.push_back(world.time - static_cast<double>(count - 1 - i) * world.settings.step);
}

std::vector<Column> probe_columns(const Times& times, const std::vector<Probe>& probes, const TableRows& rows) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::size_t> due = rows_due(times, probes, rows);
  std::vector<Column> columns;
  const auto add = [&](const std::string& name, const std::string& unit, auto cell) {
    std::vector<double> cells;
    cells.reserve(due.size());
    for (std::size_t i = 0; i < due.size(); i++) cells.push_back(cell(i));
    columns.push_back({name, unit, std::move(cells), false});
  };
  add("time", "s", [&](std::size_t i) { return times.values[due[i]]; });
  for (const Probe& probe : probes) {
    add(probe.name, "", [&](std::size_t i) {
      const std::uint64_t step = times.first_step + due[i];
      return is_known(probe, step) ? probe.values[step - probe.first_step] : unknown;
    });
    for (const std::string& reduction : rows.reductions)
      add(probe.name + " " + reduction, "", [&](std::size_t i) {
        const std::vector<double> values =
            values_between(probe, times.first_step + (i > 0 ? due[i - 1] + 1 : 0), times.first_step + due[i]);
        return values.empty() ? unknown : reduced(values, reduction);
      });
  }
  return columns;
}

std::string probe_table(const Times& times, const std::vector<Probe>& probes, const TableRows& rows) {
  return csv_text(probe_columns(times, probes, rows));
}

}  // namespace pantin::player
