#include "player/sweep/cases.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>

#include "player/csv.hpp"
#include "scene/errors.hpp"

namespace pantin::player {
namespace {

constexpr std::uint64_t most_cases = 1'000'000;
constexpr std::uint64_t seed_of_samples = 1;

/// A list in which a value may be in quotes, "a,b", and have commas then.
std::vector<std::string> split_list(const std::string& setting, const std::string& list) {
  std::vector<std::string> values;
  for (std::size_t from = 0; from <= list.size();) {
    std::size_t end = list.find(',', from);
    if (list[from] != '"') {
      end = std::min(end, list.size());
      values.push_back(list.substr(from, end - from));
    } else {
      const std::size_t close = list.find('"', from + 1);
      if (close == std::string::npos || (close + 1 < list.size() && list[close + 1] != ','))
        throw UsageError(
            text("'", setting, "': a value in quotes ends with a quote, and a comma or the end follows it"));
      values.push_back(list.substr(from + 1, close - from - 1));
      end = close + 1;
    }
    from = end + 1;
  }
  return values;
}

std::vector<std::string> split(const std::string& text, char by) {
  std::vector<std::string> parts{""};
  for (const char c : text)
    if (c == by)
      parts.emplace_back();
    else
      parts.back() += c;
  return parts;
}

template <class Number>
std::optional<Number> number_of(const std::string& text) {
  Number x{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), x);
  if (error != std::errc{} || end != text.data() + text.size()) return {};
  return x;
}

[[noreturn]] void refuse_values(const std::string& setting, const std::string& why) {
  throw UsageError(text("'", setting, "': ", why,
                        "; a value, a list 1,10,100, or a range FROM:TO:COUNT, evenly in the logarithm with :log"));
}

void read_range(Axis& axis, const std::vector<std::string>& parts, const std::string& setting) {
  const auto from = number_or_fraction(parts[0]), to = number_or_fraction(parts[1]);
  if (!from || !to || !std::isfinite(*from) || !std::isfinite(*to)) refuse_values(setting, "a range needs two numbers");
  axis.from = *from;
  axis.to = *to;
  axis.logarithmic = parts.back() == "log";
  const std::size_t told = parts.size() - (axis.logarithmic ? 1 : 0);
  if (told > 3) refuse_values(setting, "that is no range");
  if (told == 3) {
    const auto count = number_of<double>(parts[2]);
    if (!count || !(*count >= 2.0) || *count != std::floor(*count))
      refuse_values(setting, "the count of a range must be a whole number from 2 on");
    axis.count = static_cast<std::uint64_t>(std::min(*count, 1e18));  // which is too many, and told so
  }
  if (axis.logarithmic && !(axis.from > 0.0 && axis.to > 0.0)) refuse_values(setting, "a logarithm needs ends above 0");
}

/// Each would be run twice.
void refuse_duplicates(const std::string& setting, const std::vector<std::string>& values) {
  std::set<std::string> met;
  for (const std::string& value : values) {
    const auto number = number_or_fraction(value);
    if (!met.insert(number ? number_text(*number) : value).second)
      throw UsageError(text(setting, " has ", value, " twice"));
  }
}

}  // namespace

std::optional<double> number_or_fraction(const std::string& text) {
  const auto slash = text.find('/');
  if (slash == std::string::npos) return number_of<double>(text);
  const auto above = number_of<double>(text.substr(0, slash)), below = number_of<double>(text.substr(slash + 1));
  if (!above || !below || *below == 0.0) return {};
  return *above / *below;
}

std::string Axis::value_at(double part) const {
  if (!values.empty())
    return values[std::min(values.size() - 1, static_cast<std::size_t>(part * static_cast<double>(values.size())))];
  if (!whole) return number_text(between(part));
  const double least = std::ceil(std::min(from, to)), largest = std::floor(std::max(from, to));
  if (logarithmic) {
    const double low = std::log(least - 0.5), high = std::log(largest + 0.5);
    return number_text(std::clamp(std::round(std::exp(low + part * (high - low))), least, largest));
  }
  return number_text(std::min(largest, std::floor(least + part * (largest - least + 1.0))));
}

bool Axis::is_near_end(const std::string& value) const {
  const double x = number_or_fraction(value).value_or(std::nan(""));
  if (whole) return x == std::ceil(std::min(from, to)) || x == std::floor(std::max(from, to));
  const double part =
      logarithmic ? (std::log(x) - std::log(from)) / (std::log(to) - std::log(from)) : (x - from) / (to - from);
  return std::fmin(part, 1.0 - part) < 1e-3;
}

std::string Axis::value(std::uint64_t index) const {
  if (!values.empty()) return values[index];
  const double x = between(count < 2 ? 0.0 : static_cast<double>(index) / static_cast<double>(count - 1));
  return number_text(whole ? std::round(x) : x);
}

double Axis::between(double part) const {
  if (part == 1.0) return to;
  if (!logarithmic) return from * (1.0 - part) + to * part;
  const double ratio = to / from;
  return std::isfinite(ratio) ? from * std::pow(ratio, part) : std::pow(from, 1.0 - part) * std::pow(to, part);
}

Axis read_axis(const std::string& setting) {
  const auto equals = setting.find('=');
  if (equals == std::string::npos || equals == 0) throw UsageError(text("'", setting, "' must be name=values"));
  Axis axis;
  axis.name = setting.substr(0, equals);
  const std::string told = setting.substr(equals + 1);
  const std::vector<std::string> parts = split(told, ':');
  if (parts.size() > 1 && told.find_first_of(",\"") == std::string::npos)
    read_range(axis, parts, setting);
  else
    axis.values = split_list(setting, told);
  if (axis.values.size() > 1 && std::ranges::count(axis.values, ""))
    refuse_values(setting, "a value of the list is missing");
  refuse_duplicates("--set " + setting, axis.values);
  return axis;
}

Axis read_seeds(const std::string& seeds) {
  Axis axis;
  const std::vector<std::string> ends = split(seeds, ':');
  const auto first = number_of<std::uint64_t>(ends[0]), last = number_of<std::uint64_t>(ends.back());
  if (ends.size() == 2 && first && last && *first <= *last && *last < (std::uint64_t{1} << 53)) {
    axis.from = static_cast<double>(*first);
    axis.to = static_cast<double>(*last);
    axis.count = *last - *first + 1;
    axis.whole = true;
  } else {
    if (ends.size() == 2 && first && last && *first > *last)
      throw UsageError(text("--seeds: the first comes before the last, ", ends[1], ':', ends[0], ", not ", seeds));
    axis.values = split(seeds, ',');
    for (const std::string& seed : axis.values)
      if (!number_of<std::uint64_t>(seed))
        throw UsageError(text("--seeds must be FIRST:LAST or a list of whole numbers, 1,5,9, not '", seeds, "'"));
    refuse_duplicates("--seeds " + seeds, axis.values);
  }
  axis.name = "scene.seed";
  axis.of_seeds = true;
  return axis;
}

std::vector<std::vector<double>> latin_hypercube(std::size_t dimensions, std::uint64_t points, Random& random) {
  std::vector<std::vector<double>> all;
  for (std::size_t d = 0; d < dimensions; d++) {
    std::vector<double> parts(points);
    std::iota(parts.begin(), parts.end(), 0.0);
    for (std::size_t i = parts.size(); i > 1; i--)
      std::swap(parts[i - 1], parts[static_cast<std::size_t>(random.uniform() * static_cast<double>(i))]);
    for (double& part : parts) part = (part + random.uniform()) / static_cast<double>(points);
    all.push_back(std::move(parts));
  }
  return all;
}

Cases::Cases(std::vector<Axis> axes, std::uint64_t sample) : axes_(std::move(axes)) {
  double all = 1.0;
  for (const Axis& axis : axes_) {
    if (sample == 0 && axis.size() == 0)
      throw UsageError(text("the range of ", axis.name, " has no count: FROM:TO:COUNT, or draw --sample N cases"));
    all *= static_cast<double>(axis.size());
  }
  if (sample > 0) all = static_cast<double>(sample);
  if (all > static_cast<double>(most_cases))
    throw UsageError(text(all, " cases are more than the ", most_cases,
                          " of one sweep; take fewer values, or draw some of them with --sample N"));
  count_ = static_cast<std::uint64_t>(all);
  if (sample == 0) return;
  Random random{seed_of_samples, 0};
  parts_ = latin_hypercube(axes_.size(), count_, random);
}

Cases Cases::unplaced(std::vector<Axis> axes, std::uint64_t count) {
  Cases cases;
  cases.parts_.assign(axes.size(), std::vector<double>(count));
  cases.axes_ = std::move(axes);
  cases.count_ = count;
  return cases;
}

void Cases::place(std::uint64_t number, const std::vector<double>& parts) {
  for (std::size_t a = 0; a < parts.size(); a++) parts_[a][number] = parts[a];
}

std::vector<std::pair<std::string, std::string>> Cases::settings(std::uint64_t number) const {
  std::vector<std::pair<std::string, std::string>> set(axes_.size());
  for (std::size_t a = axes_.size(); a-- > 0;) {
    const Axis& axis = axes_[a];
    set[a].first = axis.name;
    if (parts_.empty()) {
      set[a].second = axis.value(number % axis.size());
      number /= axis.size();
    } else {
      set[a].second = axis.value_at(parts_[a][number]);
    }
  }
  return set;
}

}  // namespace pantin::player
