#include "player/table.hpp"

#include <algorithm>
#include <cmath>

#include "player/csv.hpp"

namespace pantin::player {
namespace {

/// The last step of each interval; the first one begins before the first step.
std::vector<std::size_t> rows_due(const SharedList& times, double every) {
  std::vector<std::size_t> rows;
  const auto interval = [&](double time) { return std::floor(time / every * (1.0 + 1e-12) + 1e-9); };
  for (std::size_t i = 0; i < times.size(); i++) {
    const bool last = i + 1 == times.size();
    const double before = i > 0 ? times[i - 1] : last ? 0.0 : times[0] - (times[1] - times[0]);
    if (every <= 0.0 || last || interval(times[i]) > interval(before)) rows.push_back(i);
  }
  return rows;
}

bool is_known(const Probe& probe, std::uint64_t step) {
  return step >= probe.first_step && step - probe.first_step < probe.values.size();
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

std::string probe_table(const Times& times, const std::vector<Probe>& probes, const TableRows& rows) {
  std::string out = "time";
  for (const Probe& probe : probes) {
    out += "," + csv_cell(probe.name);
    for (const std::string& reduction : rows.reductions) out += "," + csv_cell(probe.name + " " + reduction);
  }
  out += "\n";
  std::size_t first = 0;
  for (const std::size_t row : rows_due(times.values, rows.every)) {
    out += number_text(times.values[row]);
    for (const Probe& probe : probes) {
      const std::vector<double> values = values_between(probe, times.first_step + first, times.first_step + row);
      const bool known = is_known(probe, times.first_step + row);
      out += known ? "," + number_text(values.back()) : ",";
      for (const std::string& reduction : rows.reductions)
        out += values.empty() ? "," : "," + number_text(reduced(values, reduction));
    }
    out += "\n";
    first = row + 1;
  }
  return out;
}

}  // namespace pantin::player
