#include "player/doubt.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace pantin::player {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double rounding = 1e-9;   // of the size: smaller changes may be round-off and tolerances of the solver
constexpr double promised = 1e-10;  // of the size: no error is told to be smaller

/// Of the error in the step; 0: it falls in no such way.
double expected_order(const StudyRun& run) {
  if (run.acted_in_steps || run.integrator == "adaptive") return 0.0;
  if (run.integrator == "euler") return 1.0;
  return run.integrator == "suzuki4" || run.integrator == "rk4" ? 4.0 : 2.0;
}

/// At each time that both runs reached with right energy, the largest until then, [m].
std::vector<double> right_gaps(const Study& study, std::size_t a, std::size_t b, double Gap::*of) {
  std::vector<double> list = rising_gaps(study.runs[a], study.runs[b], of);
  const double right = std::min(study.runs[a].right_until, study.runs[b].right_until) * (1 + 1e-9);
  while (!list.empty() && study.times[list.size() - 1] > right) list.pop_back();
  return list;
}

/// What each halving of the step changed, the last one first.
std::vector<std::vector<double>> changes(const Study& study, std::size_t i, double Gap::*of) {
  std::vector<std::vector<double>> lists;
  for (std::size_t j = i; j > 0 && same_series(study.runs[j - 1], study.runs[j]); j--)
    lists.push_back(right_gaps(study, j, j - 1, of));
  return lists;
}

/// Whether the changes fall from halving to halving as the order says: once surely, and roughly once more unless the runs
/// before show a different motion.
bool fall_as_expected(const std::vector<double>& changed, std::size_t first, double order, double size) {
  if (order == 0.0 || changed.size() < first + 2) return false;
  const auto off = [&](std::size_t j) { return std::fabs(std::log2(changed[j + 1] / changed[j]) - order); };
  if (!(off(first) < 0.5)) return false;
  return changed.size() < first + 3 || changed[first + 2] > apart * size || off(first + 1) < 1.0;
}

/// By how much the finest of at least three runs may be wrong, by what the halvings of the step changed, the last one
/// first, [m]. Nothing is extrapolated. Where the changes fall as the order says, what is left is less than the last,
/// taken three times. Else, as where forces have kinks and things happen in whole steps, runs may agree by luck: what is left
/// is less than the last three together, and than each of all leaves at order 1, twice.
double doubt(const std::vector<double>& changed, double order, double size) {
  if (changed.size() < 2) return infinity;
  std::size_t same = 0;  // runs that show nothing new
  while (same < changed.size() && changed[same] <= rounding * size) same++;
  const double of_rounding = 2.0 * (same > 0 ? *std::max_element(&changed[0], &changed[0] + same) : 0.0);
  if (same == changed.size()) return of_rounding;
  const std::size_t first = same > 0 && changed[same - 1] > 1e-3 * rounding * size ? same - 1 : same;
  if (fall_as_expected(changed, first, order, size)) return same > 0 ? of_rounding : 3.0 * changed[0];
  const std::size_t last = std::min<std::size_t>(changed.size(), 3);
  const double sum = std::accumulate(changed.begin(), changed.begin() + static_cast<std::ptrdiff_t>(last), 0.0);
  const double before = *std::max_element(&changed[1], &changed[0] + last);
  double most = changed[0] > 0.75 * before ? 2.0 * sum : sum;
  for (std::size_t j = 0; j < changed.size(); j++)
    if (changed[j] <= apart * size) most = std::max(most, 2.0 * std::ldexp(changed[j], -static_cast<int>(j)));
  return most;
}

/// By the runs of its own series. What chooses its own steps may take the same with each accuracy, which tells nothing.
std::vector<double> own_doubt(const Study& study, std::size_t i, double Gap::*of) {
  std::vector<double> result(study.times.size(), infinity);
  if (study.runs[i].accuracy > 0.0) return result;
  const std::vector<std::vector<double>> lists = changes(study, i, of);
  const double order = expected_order(study.runs[i]);
  double most = promised * study.size;
  for (std::size_t k = 0; k < result.size(); k++) {
    std::vector<double> changed;
    for (const std::vector<double>& list : lists) {
      if (list.size() <= k) break;
      changed.push_back(list[k]);
    }
    most = std::max(most, doubt(changed, order, study.size));
    result[k] = most;
  }
  return result;
}

/// One of each series, but of the paper's integrator only where it is alone.
std::vector<std::size_t> finest_runs(const Study& study) {
  const auto complete = [&](const StudyRun& run) { return run.positions.size() == study.times.size(); };
  std::vector<std::size_t> list, papers;
  for (std::size_t i = 0; i < study.runs.size(); i++) {
    const StudyRun& run = study.runs[i];
    const bool last =
        i + 1 == study.runs.size() || !same_series(study.runs[i + 1], run) || !complete(study.runs[i + 1]);
    if (complete(run) && last) (run.integrator == "euler" ? papers : list).push_back(i);
  }
  return list.empty() ? papers : list;
}

/// Whether at least three of the finest look at the forces at other instants: then luck cannot make them agree where
/// forces have kinks or jump, as it can where all of them act in whole steps.
bool look_at_other_times(const Study& study, const std::vector<Doubted>& finest) {
  const auto run = [&](const Doubted& one) -> const StudyRun& { return study.runs[one.run]; };
  return finest.size() >= 3 &&
         std::any_of(finest.begin(), finest.end(), [&](const Doubted& one) { return run(one).integrator == "rk4"; }) &&
         std::none_of(finest.begin(), finest.end(), [&](const Doubted& one) { return run(one).acted_in_steps; });
}

/// By how much one of the finest may be wrong, seen by the others as well: where it is further from one than both allow,
/// that one may be right. Where all look `at_other_times`, what is left is less than three times what they are away, and
/// than the last change of the step, taken twice.
std::vector<double> seen_by_others(const Study& study, const std::vector<Doubted>& own, std::size_t a,
                                   bool at_other_times, double Gap::*of) {
  std::vector<double> list = own[a].doubt, farthest = rising_gaps(study.runs[own[a].run], study.runs[own[a].run], of);
  for (std::size_t b = 0; b < own.size(); b++) {
    if (b == a) continue;
    const std::vector<double> between = right_gaps(study, own[a].run, own[b].run, of);
    farthest.resize(std::min(farthest.size(), between.size()));
    for (std::size_t k = 0; k < between.size(); k++) {
      if (between[k] > own[a].doubt[k] + own[b].doubt[k]) list[k] = std::max(list[k], between[k] + own[b].doubt[k]);
      if (k < farthest.size()) farthest[k] = std::max(farthest[k], between[k]);
    }
  }
  const std::vector<std::vector<double>> changed = changes(study, own[a].run, of);
  for (std::size_t k = 0; at_other_times && k < farthest.size() && std::isfinite(list[k]); k++)
    list[k] = std::min(list[k], std::max({3.0 * farthest[k], 2.0 * changed[0][k], promised * study.size}));
  for (std::size_t k = 1; k < list.size(); k++) list[k] = std::max(list[k], list[k - 1]);
  return list;
}

}  // namespace

std::vector<Doubted> doubts(const Study& study, double Gap::*of) {
  std::vector<Doubted> own, all;
  for (const std::size_t i : finest_runs(study)) own.push_back({i, own_doubt(study, i, of)});
  const bool at_other_times = look_at_other_times(study, own);
  for (std::size_t a = 0; a < own.size(); a++)
    all.push_back({own[a].run, seen_by_others(study, own, a, at_other_times, of)});
  return all;
}

const StudyRun* coarser(const Study& study, std::size_t i) {
  if (i == 0 || study.runs[i].accuracy > 0.0) return nullptr;
  return same_series(study.runs[i - 1], study.runs[i]) ? &study.runs[i - 1] : nullptr;
}

}  // namespace pantin::player
