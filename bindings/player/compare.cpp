// What the runs of a study say about each other.
#include <algorithm>
#include <cmath>
#include <map>

#include "player/study.hpp"

namespace pantin::player {
namespace {

constexpr double apart = 0.01;  // of the size: runs that are further from each other show different motions
const double nan = std::numeric_limits<double>::quiet_NaN();

/// Over the things that two runs have at a time, [m]; NaN where there are none.
struct Gap {
  double mean = nan;  ///< root mean square
  double most = nan;
};

Gap gap(const Places& a, const Places& b) {
  double sum = 0.0, most = 0.0;
  std::size_t count = 0;
  for (auto i = a.begin(), j = b.begin(); i != a.end() && j != b.end();) {
    if (i->first < j->first)
      ++i;
    else if (j->first < i->first)
      ++j;
    else {
      const double square = norm2(i->second - j->second);
      sum += square;
      if (!(square <= most)) most = square;
      count++;
      ++i, ++j;
    }
  }
  if (count == 0) return {};
  return {std::sqrt(sum / static_cast<double>(count)), std::sqrt(most)};
}

/// Over the times that both reached, [m].
std::vector<double> gaps(const StudyRun& a, const StudyRun& b, double Gap::*of) {
  std::vector<double> list;
  for (std::size_t k = 0; k < std::min(a.places.size(), b.places.size()); k++)
    list.push_back(gap(a.places[k], b.places[k]).*of);
  return list;
}

std::vector<double> distances(const StudyRun& a, const StudyRun& b) { return gaps(a, b, &Gap::mean); }

/// The largest of those until a time [s].
double largest(const Study& study, const std::vector<double>& list, double until) {
  double result = 0.0;
  for (std::size_t k = 0; k < list.size() && study.times[k] <= until * (1 + 1e-9); k++)
    if (!(list[k] <= result)) result = list[k];
  return result;
}

/// [s] of the last time before the distance exceeds `limit`.
double last_within(const Study& study, const std::vector<double>& list, double limit) {
  double time = 0.0;
  for (std::size_t k = 0; k < list.size() && list[k] <= limit; k++) time = study.times[k];
  return time;
}

/// The run with the same integrator and the next longer step, or null; of what chooses its own steps always null.
const StudyRun* coarser(const Study& study, std::size_t i) {
  if (i == 0 || study.runs[i].accuracy > 0.0) return nullptr;
  return same_series(study.runs[i - 1], study.runs[i]) ? &study.runs[i - 1] : nullptr;
}

bool complete(const Study& study, const StudyRun& run) { return run.places.size() == study.times.size(); }

/// What two runs of an integrator, one with half the step of the other, are worth as the measure of all others.
struct Worth {
  double together = -1.0, comparable = 0.0, distance = 0.0;
};

bool better(const Worth& a, const Worth& b) {
  if (a.comparable != b.comparable) return a.comparable > b.comparable;
  return a.distance < b.distance;
}

/// What the last halving of the step changed, or a quarter of the one before, lest two runs agree by luck; at each time,
/// [m].
std::vector<double> changes(const Study& study, std::size_t i) {
  const StudyRun* const before = coarser(study, i);
  const StudyRun* const first = coarser(study, i - 1);
  std::vector<double> list = distances(study.runs[i], *before);
  if (!first) return list;
  const std::vector<double> earlier = distances(*before, *first);
  for (std::size_t k = 0; k < std::min(list.size(), earlier.size()); k++)
    list[k] = std::max(list[k], 0.25 * earlier[k]);
  return list;
}

/// Comparing ends where the finest is still sure of errors that are small beside those that are looked for, and of smaller
/// ones where it is sure of them for much of the motion that it shows.
Worth worth(const Study& study, const std::vector<double>& list) {
  Worth result;
  result.together = result.comparable = last_within(study, list, apart * study.size);
  constexpr double sure = 3e-4;                                                            // of the size
  constexpr std::pair<double, double> limits[] = {{1e-5, 0.5}, {1e-4, 0.2}, {sure, 0.0}};  // of the size, of that time
  if (!(largest(study, list, study.until) <= sure * study.size))
    for (const auto& [limit, part] : limits) {
      result.comparable = last_within(study, list, limit * study.size);
      if (result.comparable >= part * result.together) break;
    }
  if (result.comparable == 0.0) result.comparable = result.together;
  result.distance = largest(study, list, result.comparable);
  return result;
}

/// The finest run of the integrator whose finest runs stay together longest and, of those, are nearest. The paper's is the
/// measure of others only where it is alone: it is of first order, and what it dissipates hides chaos.
void choose_reference(Study& study) {
  const auto find = [&](bool papers) {
    Worth best;
    for (std::size_t i = 0; i < study.runs.size(); i++) {
      const StudyRun* const before = coarser(study, i);
      const bool last = i + 1 == study.runs.size() || !same_series(study.runs[i + 1], study.runs[i]) ||
                        !complete(study, study.runs[i + 1]);
      if (!before || !last || !complete(study, study.runs[i])) continue;
      if ((study.runs[i].integrator == "euler") != papers) continue;
      const Worth now = worth(study, changes(study, i));
      if (best.together >= 0.0 && !better(now, best)) continue;
      best = now;
      study.reference = i;
    }
    return best;
  };
  Worth best = find(false);
  if (best.together < 0.0) best = find(true);
  require(best.together >= 0.0,
          "report: there was no time for two runs to be compared: give a shorter time by --until");
  study.together = best.together;
  study.comparable = best.comparable;
}

/// How fast the distance of the two finest runs grows where they part: slope of its logarithm over the last half of the
/// times until then, by least squares, [1/s].
double growth(const Study& study, const std::vector<double>& list) {
  double n = 0, t = 0, y = 0, tt = 0, ty = 0;
  for (std::size_t k = 0; k < list.size(); k++) {
    const double time = study.times[k];
    if (time < 0.5 * study.together || time > study.together * (1 + 1e-9) || !(list[k] > 0.0)) continue;
    const double value = std::log(list[k]);
    n += 1, t += time, y += value, tt += time * time, ty += time * value;
  }
  return n >= 3 ? (n * ty - t * y) / (n * tt - t * t) : 0.0;
}

void compare_run(Study& study, std::size_t i) {
  StudyRun& run = study.runs[i];
  const std::vector<double> list = distances(run, study.finest());
  run.true_until = last_within(study, list, apart * study.size);
  if (study.comparable == 0.0 || list.empty() || study.times[list.size() - 1] < study.comparable * (1 - 1e-9)) return;
  run.error = largest(study, list, study.comparable);
  run.farthest = largest(study, gaps(run, study.finest(), &Gap::most), study.comparable);
}

/// By how much the finest run may be wrong, [m], by what the last halvings of its step changed. Where that falls by the
/// same factor each time, it goes on so; else, as where events happen in whole steps, what is left may be as much as the
/// largest of them leaves at order 1.
double doubt(const Study& study, double Gap::*of) {
  std::vector<double> changed;  // by the last halving, the one before it ...
  const StudyRun* finer = &study.finest();
  for (std::size_t i = study.reference; changed.size() < 3; i--) {
    const StudyRun* const before = coarser(study, i);
    if (!before || before->places.size() < study.finest().places.size()) break;
    changed.push_back(largest(study, gaps(*finer, *before, of), study.comparable));
    finer = before;
  }
  if (changed.size() == 3 && changed[0] > 0.0) {
    const double order = std::log2(changed[1] / changed[0]), order_before = std::log2(changed[2] / changed[1]);
    if (order > 0.7 && std::fabs(order - order_before) < 0.5) return 1.5 * changed[0] / (std::exp2(order) - 1.0);
  }
  double most = 0.0;
  for (std::size_t k = 0; k < changed.size(); k++) most = std::max(most, std::ldexp(changed[k], -static_cast<int>(k)));
  return most;
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
  const double changed = largest(study, distances(run, *before), study.comparable);
  const double changed_before = largest(study, distances(*before, *first), study.comparable);
  return changed > 1e-10 * study.size ? std::log2(changed_before / changed) / halvings : nan;
}

void find_orders(Study& study) {
  for (std::size_t i = 0; i < study.runs.size(); i++) study.runs[i].order = order(study, i);
}

}  // namespace

double distance(const StudyRun& a, const StudyRun& b) {
  const std::vector<double> list = distances(a, b);
  return list.empty() ? nan : *std::max_element(list.begin(), list.end());
}

void compare(Study& study) {
  choose_reference(study);
  const std::vector<double> list = changes(study, study.reference);
  for (std::size_t i = 0; i < study.runs.size(); i++)
    if (i != study.reference) compare_run(study, i);
  study.growth = growth(study, list);
  study.uncertain = doubt(study, &Gap::mean);
  study.runs[study.reference].true_until = study.together;
  if (study.comparable > 0.0) {
    study.runs[study.reference].error = study.uncertain;
    study.runs[study.reference].farthest = doubt(study, &Gap::most);
  }
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
