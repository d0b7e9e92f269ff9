#include "player/sweep/search.hpp"

#include <algorithm>
#include <cmath>
#include <nlopt.hpp>
#include <numeric>
#include <set>

#include "base/random.hpp"
#include "player/sweep/cases.hpp"

namespace pantin::player {
namespace {

// Measured by `pantin bench search`.
constexpr double sampled = 0.15;    // of all points, before the local searches begin
constexpr double per_climb = 25.0;  // points for each dimension and one more, that one local search may take
constexpr std::uint64_t least_climbs = 2;
constexpr double longest_step = 0.25;
constexpr double converged = 1e-4;             // of a range
constexpr std::size_t most_recalled = 20'000;  // values that are known already, until there seem to be no others
constexpr double worst = 1e300;                // what is minimised: the value with a minus
constexpr std::uint64_t seed_of_sample = 1, seed_of_starts = 2;

double cost_of(double value) { return std::isfinite(value) ? std::clamp(-value, -worst, worst) : worst; }

double largest_distance(const CubePoint& a, const CubePoint& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); i++) largest = std::max(largest, std::fabs(a[i] - b[i]));
  return largest;
}

/// A local search done again with the values that are known, up to the first that is not.
struct Replay {
  const std::function<std::string(const CubePoint&)>& key;
  const std::map<std::string, double>&of_sample, &of_climb;
  std::optional<CubePoint> unknown = {};
  std::size_t recalled = 0;

  bool ended() const { return unknown || recalled > most_recalled; }
  double cost(const CubePoint& at) {
    if (std::ranges::any_of(at, [](double x) { return !std::isfinite(x); })) throw nlopt::forced_stop();
    const std::string name = key(at);
    for (const auto* known : {&of_sample, &of_climb})
      if (const auto found = known->find(name); found != known->end() && ++recalled <= most_recalled)
        return found->second;
    if (recalled <= most_recalled) unknown = at;
    throw nlopt::forced_stop();
  }
};

double cost_for_nlopt(const std::vector<double>& at, std::vector<double>&, void* replay) {
  return static_cast<Replay*>(replay)->cost(at);
}

void search_from(CubePoint at, nlopt::algorithm method, double step, Replay& replay) {
  nlopt::opt search(method, static_cast<unsigned>(at.size()));
  search.set_lower_bounds(0.0);
  search.set_upper_bounds(1.0);
  search.set_initial_step(step);
  search.set_xtol_abs(converged);
  search.set_min_objective(cost_for_nlopt, &replay);
  double least = 0.0;
  try {
    search.optimize(at, least);
  } catch (const std::exception&) {}  // it asks what is not known, or is at its end: the next begins elsewhere
}

}  // namespace

std::string Search::library() {
  int major = 0, minor = 0, bugfix = 0;
  nlopt::version(major, minor, bugfix);
  return "NLopt " + std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(bugfix);
}

Search::Search(std::size_t dimensions, std::uint64_t points, std::function<std::string(const CubePoint&)> key)
    : dimensions_(dimensions), points_(points), key_(std::move(key)) {
  const double all = static_cast<double>(points);
  const auto climbs =
      std::max(least_climbs, static_cast<std::uint64_t>(all / (per_climb * static_cast<double>(dimensions + 1))));
  const std::uint64_t first = std::min(points, std::max(climbs, static_cast<std::uint64_t>(sampled * all)));
  climbs_.resize(std::min(climbs, points - first));
  Random random{seed_of_sample, 0};
  const auto parts = latin_hypercube(dimensions, first, random);
  std::set<std::string> seen;
  for (std::uint64_t i = 0; i < first; i++) {
    CubePoint at;
    for (const auto& part : parts) at.push_back(part[i]);
    if (seen.insert(key_(at)).second) sample_.push_back(at);
  }
  costs_.resize(sample_.size());
}

std::optional<Search::Asked> Search::ask() {
  if (asked_ < sample_.size()) {
    asked_++;
    return Asked{asked_ - 1, sample_[asked_ - 1]};
  }
  if (told_ < sample_.size()) return {};
  if (starts_.empty()) begin_climbs();
  while (!ready_.empty()) {
    const std::size_t climb = ready_.front();
    ready_.pop_front();
    std::vector<CubePoint>& points = climbs_[climb].points;
    const std::uint64_t number = sample_.size() + points.size() * climbs_.size() + climb;
    const auto at = number < points_ ? next_of(climb) : std::nullopt;
    if (!at) continue;  // it has come to its end
    points.push_back(*at);
    return Asked{number, *at};
  }
  return {};
}

void Search::tell(std::uint64_t number, double value) {
  if (number < sample_.size()) {
    costs_[number] = known_[key_(sample_[number])] = cost_of(value);
    told_++;
    return;
  }
  const std::size_t climb = (number - sample_.size()) % climbs_.size();
  climbs_[climb].known[key_(climbs_[climb].points.back())] = cost_of(value);
  ready_.push_back(climb);
}

void Search::begin_climbs() {
  const double apart = std::pow(static_cast<double>(sample_.size()), -1.0 / static_cast<double>(dimensions_));
  step_ = std::min(longest_step, apart);
  std::vector<std::size_t> order(sample_.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return costs_[i]; });
  for (const std::size_t i : order) {
    const auto is_far = [&](const CubePoint& other) { return largest_distance(sample_[i], other) >= apart; };
    if (std::ranges::all_of(starts_, is_far)) starts_.push_back(sample_[i]);
  }
  for (std::size_t climb = 0; climb < climbs_.size(); climb++) ready_.push_back(climb);
}

CubePoint Search::start_of(std::size_t climb, std::size_t start) const {
  const std::size_t index = climb + start * climbs_.size();
  if (index < starts_.size()) return starts_[index];
  Random random{seed_of_starts, index * dimensions_};
  CubePoint at(dimensions_);
  for (double& x : at) x = random.uniform();
  return at;
}

std::optional<CubePoint> Search::next_of(std::size_t climb) const {
  Replay replay{key_, known_, climbs_[climb].known};
  const bool by_model = climb % 2 == 1 && dimensions_ > 1;  // which BOBYQA asks for
  for (std::size_t start = 0; start < most_recalled && !replay.ended(); start++)
    search_from(start_of(climb, start), by_model ? nlopt::LN_BOBYQA : nlopt::LN_NELDERMEAD, step_, replay);
  return replay.unknown;
}

}  // namespace pantin::player
