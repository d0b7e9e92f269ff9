#include "player/sweep/best.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "player/csv.hpp"
#include "scene/errors.hpp"

namespace pantin::player {
namespace {

constexpr std::uint64_t most_searched = 100'000, usual_for_each_range = 100;
constexpr std::uint64_t most_without = 8;  // cases that do not tell what is wanted, before any that does

bool is_searched(const Axis& axis) { return axis.values.empty() && !axis.of_seeds; }

std::vector<std::size_t> searched_of(const std::vector<Axis>& axes) {
  std::vector<std::size_t> searched;
  for (std::size_t a = 0; a < axes.size(); a++)
    if (is_searched(axes[a])) searched.push_back(a);
  return searched;
}

std::uint64_t seeds_of(const std::vector<Axis>& axes) {
  const auto seeds = std::ranges::find_if(axes, &Axis::of_seeds);
  return seeds == axes.end() ? 1 : seeds->size();
}

bool is_text(const std::string& measure) { return measure == "hash" || measure == "error"; }

const std::string* cell_of(const Cases& cases, const CaseRow& row, const std::string& column) {
  for (const Cells* cells : {&row.told, &row.probes})
    for (const auto& [name, value] : *cells)
      if (told_column(cases, name) == column) return &value;
  for (const auto& [name, value] : row.measured)
    if (name == column && !is_text(name)) return &value;
  return nullptr;
}

std::optional<double> number_of_cell(const std::string& cell) {
  double x = 0.0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), x);
  if (error != std::errc{} || end != cell.data() + cell.size()) return {};
  return x;
}

std::string columns_of(const Cases& cases, const CaseRow& row) {
  std::string all;
  for (const Cells* cells : {&row.told, &row.probes})
    for (const auto& [name, value] : *cells) all += (all.empty() ? "" : ", ") + told_column(cases, name);
  for (const auto& [name, value] : row.measured)
    if (!is_text(name)) all += (all.empty() ? "" : ", ") + name;
  return all;
}

}  // namespace

std::uint64_t Best::count(const std::vector<Axis>& axes, std::uint64_t sample) {
  for (const Axis& axis : axes) {
    if (axis.values.size() > 1 && !axis.of_seeds)
      throw UsageError(text(axis.name,
                            " has a list of values, and --best and --least search ranges FROM:TO alone: set "
                            "one of them, or run a sweep for each"));
    if (is_searched(axis) && axis.count > 0)
      throw UsageError(text("the range of ", axis.name,
                            " has a count, and a search chooses by itself where to look: --set ", axis.name, "=",
                            axis.from, ":", axis.to));
    if (is_searched(axis) && axis.from == axis.to)
      throw UsageError(text("the range of ", axis.name, " has equal ends: --set ", axis.name, "=", axis.from));
  }
  const std::size_t ranges = searched_of(axes).size();
  const std::uint64_t seeds = seeds_of(axes);
  if (ranges == 0) throw UsageError("--best and --least search ranges: --set NAME=FROM:TO");
  if (sample == 0) sample = usual_for_each_range * ranges * seeds;
  if (sample > most_searched)
    throw UsageError(text("--sample ", sample, ": a search has at most ", most_searched, " cases"));
  if (sample < seeds) throw UsageError(text("--sample ", sample, " is less than a case for each of ", seeds, " seeds"));
  return sample / seeds * seeds;
}

Best::Best(Cases& cases, Wanted wanted)
    : cases_(cases),
      seeds_(seeds_of(cases.axes())),
      wanted_(std::move(wanted)),
      searched_(searched_of(cases.axes())),
      search_(searched_.size(), cases.count() / seeds_, [this](const CubePoint& point) { return key_of(point); }) {}

std::vector<double> Best::parts_of(const CubePoint& point, std::uint64_t seed) const {
  std::vector<double> parts(cases_.axes().size(), (static_cast<double>(seed) + 0.5) / static_cast<double>(seeds_));
  for (std::size_t i = 0; i < point.size(); i++) parts[searched_[i]] = point[i];
  return parts;
}

std::string Best::key_of(const CubePoint& point) const {
  std::string key;
  for (std::size_t i = 0; i < point.size(); i++) key += cases_.axes()[searched_[i]].value_at(point[i]) + " ";
  return key;
}

std::optional<std::uint64_t> Best::next(const Rows& rows) {
  while (waiting_.empty()) {
    const auto asked = search_.ask();
    if (!asked) return {};
    for (std::uint64_t seed = 0; seed < seeds_; seed++) {
      const std::uint64_t number = asked->number * seeds_ + seed;
      cases_.place(number, parts_of(asked->at, seed));
      if (!rows.contains(number)) waiting_.push_back(number);
    }
    if (waiting_.empty()) search_.tell(asked->number, mean(rows, asked->number).value());
  }
  const std::uint64_t number = waiting_.front();
  waiting_.pop_front();
  return number;
}

void Best::kept(const Rows& rows, std::uint64_t number) {
  check(rows);
  if (const auto value = mean(rows, number / seeds_)) search_.tell(number / seeds_, *value);
}

/// In the order of the cases, so that it does not depend on which is done first.
void Best::check(const Rows& rows) {
  for (; !known_ && rows.contains(checked_); checked_++) {
    const CaseRow& row = rows.at(checked_);
    if (failed(row)) continue;
    const std::string* cell = cell_of(cases_, row, wanted_.column);
    if (!cell && ++without_ < most_without) continue;
    if (!cell)
      throw UsageError(text("none of the first ", without_, " cases has a number '", wanted_.column, "'; case ",
                            row.number, " has: ", columns_of(cases_, row)));
    if (!number_of_cell(*cell))
      throw UsageError(text("'", wanted_.column, "' of case ", row.number, " is no number: ", *cell));
    known_ = true;
  }
}

double Best::value_of(const CaseRow& row) const {
  const std::string* cell = failed(row) ? nullptr : cell_of(cases_, row, wanted_.column);
  const auto number = cell ? number_of_cell(*cell) : std::nullopt;
  return number.value_or(std::numeric_limits<double>::quiet_NaN());
}

std::optional<double> Best::mean(const Rows& rows, std::uint64_t point) const {
  double sum = 0.0;
  for (std::uint64_t i = 0; i < seeds_; i++) {
    const auto row = rows.find(point * seeds_ + i);
    if (row == rows.end()) return {};
    sum += value_of(row->second);
  }
  const double mean = sum / static_cast<double>(seeds_);
  return wanted_.least ? -mean : mean;
}

std::string Best::told(const Rows& rows) const {
  std::optional<std::uint64_t> best;
  double largest = 0.0;
  for (auto row = rows.begin(); row != rows.end();) {
    const std::uint64_t point = row->first / seeds_;
    const double value = mean(rows, point).value_or(std::numeric_limits<double>::quiet_NaN());
    if (std::isfinite(value) && (!best || value > largest)) {
      best = point;
      largest = value;
    }
    row = rows.lower_bound((point + 1) * seeds_);
  }
  if (!best) return "";
  const std::uint64_t first = *best * seeds_;
  std::string all = text(wanted_.least ? "least " : "largest ", wanted_.column, ": ",
                         number_text(wanted_.least ? -largest : largest));
  all +=
      seeds_ > 1 ? text(", the mean of cases ", first, " to ", first + seeds_ - 1, ":") : text(", case ", first, ":");
  const auto settings = cases_.settings(first);
  for (const std::size_t axis : searched_) all += text(" --set ", settings[axis].first, "=", settings[axis].second);
  for (const std::size_t axis : searched_) {
    const Axis& range = cases_.axes()[axis];
    if (!range.is_near_end(settings[axis].second)) continue;
    all += text("\n", range.name, " is at an end of its range, ", range.from, " to ", range.to,
                ": there may be better beyond it");
  }
  return all;
}

}  // namespace pantin::player
