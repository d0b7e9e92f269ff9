// What the runs of a study say about each other.
#include <algorithm>
#include <cmath>

#include "player/doubt.hpp"

namespace pantin::player {
namespace {

const double nan = std::numeric_limits<double>::quiet_NaN();

/// What a run is worth as the measure of all others.
struct Worth {
  double together = 0.0, comparable = 0.0, doubt = 0.0;
};

bool better(const Worth& a, const Worth& b) {
  if (a.comparable != b.comparable) return a.comparable > b.comparable;
  return a.doubt < b.doubt;
}

/// Comparing ends where the finest is still sure of errors that are small beside those that are looked for, and of smaller
/// ones where it is sure of them for much of the motion that it shows.
Worth worth(const Study& study, const std::vector<double>& list) {
  Worth result;
  result.together = result.comparable = last_within(study, list, apart * study.size);
  constexpr double sure = 5e-4;                                                            // of the size
  constexpr std::pair<double, double> limits[] = {{1e-5, 0.5}, {1e-4, 0.2}, {sure, 0.0}};  // of the size, of that time
  if (!(largest_until(study, list, study.until) <= sure * study.size))
    for (const auto& [limit, part] : limits) {
      result.comparable = last_within(study, list, limit * study.size);
      if (result.comparable >= part * result.together) break;
    }
  if (result.comparable == 0.0) result.comparable = result.together;
  result.doubt = largest_until(study, list, result.comparable);
  return result;
}

/// The run that is sure for longest and, of those, the surest. Null where no three runs of any series tell.
const Doubted* choose_reference(Study& study, const std::vector<Doubted>& finest) {
  const Doubted* best = nullptr;
  Worth of_best;
  for (const Doubted& one : finest) {
    if (study.runs[one.run].accuracy > 0.0) continue;
    if (best == nullptr) study.reference = one.run;
    const Worth now = worth(study, one.doubt);
    if (now.together == 0.0 || (best && !better(now, of_best))) continue;
    best = &one;
    of_best = now;
  }
  if (!best) return nullptr;
  study.reference = best->run;
  study.together = of_best.together;
  study.comparable = of_best.comparable;
  return best;
}

/// How fast the distance of the two finest runs grows where they part: slope of its logarithm over the last half of the
/// times until then, by least squares, [1/s]. 0 where it does not grow tenfold along such a line: one impact or
/// encounter is no law of growth.
double growth(const Study& study, const std::vector<double>& list) {
  constexpr double seen = 1e-9;  // of the size: below is round-off
  constexpr double least = 8;    // points
  double n = 0, t = 0, y = 0, tt = 0, ty = 0, yy = 0;
  for (std::size_t k = 0; k < list.size(); k++) {
    const double time = study.times[k];
    if (time < 0.5 * study.together || time > study.together * (1 + 1e-9) || !(list[k] > seen * study.size)) continue;
    const double value = std::log(list[k]);
    n += 1, t += time, y += value, tt += time * time, ty += time * value, yy += value * value;
  }
  if (n < least) return 0.0;
  const double of_t = n * tt - t * t, of_y = n * yy - y * y, both = n * ty - t * y;
  const double slope = both / of_t, span = n * study.times[0];
  const bool on_a_line = both * both > 0.7 * of_t * of_y;
  return on_a_line && slope * span > std::log(10.0) ? slope : 0.0;
}

void compare_run(Study& study, std::size_t i, const std::vector<double>& doubt) {
  StudyRun& run = study.runs[i];
  std::vector<double> list = rising_gaps(run, study.finest(), &Gap::mean);
  for (std::size_t k = 0; k < list.size(); k++) list[k] += doubt[k];
  run.true_until = last_within(study, list, apart * study.size);
  if (i == study.reference || list.empty() || study.times[list.size() - 1] < study.comparable * (1 - 1e-9)) return;
  run.error = largest_until(study, rising_gaps(run, study.finest(), &Gap::mean), study.comparable);
  run.farthest = largest_until(study, rising_gaps(run, study.finest(), &Gap::most), study.comparable);
}

/// [s] when a run and the one with twice its step part.
double parting(const Study& study, std::size_t i) {
  const StudyRun* const before = coarser(study, i);
  return before ? last_within(study, gaps(study.runs[i], *before, &Gap::mean), apart * study.size) : 0.0;
}

/// A small error grows by itself: the nearer runs begin, the longer they stay together.
bool is_chaotic(const Study& study) {
  return study.parts() && !study.unresolved() && study.growth > 0.0 &&
         parting(study, study.reference) > parting(study, study.reference - 1);
}

/// The first to have lost or made energy when the finest runs parted, or in the interval after: of those as fine as the
/// reference, and of the three that tell how wrong that may be.
std::optional<std::size_t> find_loser(const Study& study, const std::vector<Doubted>& finest) {
  if (!study.parts()) return {};
  double first = *std::upper_bound(study.times.begin(), study.times.end(), study.together * (1 + 1e-9)) * (1 - 1e-9);
  std::optional<std::size_t> loser;
  const auto look = [&](std::size_t i) {
    if (study.runs[i].right_until >= first) return;
    first = study.runs[i].right_until;
    loser = i;
  };
  for (const Doubted& one : finest)
    if (const StudyRun& run = study.runs[one.run]; run.accuracy == 0.0 && run.step <= study.finest().step * (1 + 1e-9))
      look(one.run);
  for (std::size_t i = study.reference; i > 0 && i + 2 > study.reference && coarser(study, i); i--) look(i - 1);
  return loser;
}

/// By how the error fell from twice the step; of runs as exact as the finest, by how what the halving changed did.
double order(const Study& study, std::size_t i) {
  const StudyRun* const before = coarser(study, i);
  const StudyRun& run = study.runs[i];
  if (!before || !(before->error < 0.1 * study.size)) return nan;
  const double halvings = std::log2(before->step / run.step);
  if (run.error > 10.0 * study.uncertain) return std::log2(before->error / run.error) / halvings;
  const StudyRun* const first = coarser(study, i - 1);
  if (!first) return nan;
  const double changed = largest_until(study, gaps(run, *before, &Gap::mean), study.comparable);
  const double changed_before = largest_until(study, gaps(*before, *first, &Gap::mean), study.comparable);
  return changed > 1e-10 * study.size ? std::log2(changed_before / changed) / halvings : nan;
}

void find_orders(Study& study) {
  for (std::size_t i = 0; i < study.runs.size(); i++) study.runs[i].order = order(study, i);
}

}  // namespace

double distance(const StudyRun& a, const StudyRun& b) {
  const std::vector<double> list = gaps(a, b, &Gap::mean);
  return list.empty() ? nan : *std::max_element(list.begin(), list.end());
}

void compare(Study& study) {
  const std::vector<Doubted> finest = doubts(study, &Gap::mean);
  const Doubted* const reference = choose_reference(study, finest);
  study.loser = find_loser(study, finest);
  if (!reference) return;
  const std::vector<Doubted> worst = doubts(study, &Gap::most);
  study.uncertain = largest_until(study, reference->doubt, study.comparable);
  StudyRun& run = study.runs[study.reference];
  run.error = study.uncertain;
  run.farthest =
      largest_until(study, worst[static_cast<std::size_t>(reference - finest.data())].doubt, study.comparable);
  for (std::size_t i = 0; i < study.runs.size(); i++) compare_run(study, i, reference->doubt);
  if (const StudyRun* const before = coarser(study, study.reference))
    study.growth = growth(study, gaps(run, *before, &Gap::mean));
  study.chaotic = is_chaotic(study);
  find_orders(study);
}

const StudyRun* cheapest(const Study& study, double error) {
  constexpr double as_cheap = 1.2;  // clocks are no better
  // A run may be near the finest until then, and invent energy later.
  const double energy = std::max(0.1, 2.0 * study.finest().worst.energy);
  const auto serves = [&](const StudyRun& run) {
    return run.trouble.empty() && run.worst.energy <= energy && study.error_of(run) <= error;
  };
  // What is exact by luck, where shorter steps are not, serves nobody.
  std::vector<const StudyRun*> serving;
  bool so_far = true;
  for (std::size_t i = study.runs.size(); i-- > 0;) {
    const StudyRun& run = study.runs[i];
    if (i + 1 == study.runs.size() || !same_series(run, study.runs[i + 1])) so_far = true;
    so_far = so_far && serves(run);
    if (so_far) serving.insert(serving.begin(), &run);
  }
  double least = std::numeric_limits<double>::infinity();
  for (const StudyRun* run : serving) least = std::min(least, run->cost());
  const StudyRun* best = nullptr;
  for (const StudyRun* run : serving)
    if (run->cost() <= as_cheap * least && (!best || run->error < 0.5 * best->error)) best = run;
  return best;
}

}  // namespace pantin::player
