#include "player/gaps.hpp"

#include <algorithm>
#include <cmath>

namespace pantin::player {
namespace {

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

}  // namespace

std::vector<double> gaps(const StudyRun& a, const StudyRun& b, double Gap::*of) {
  std::vector<double> list;
  for (std::size_t k = 0; k < std::min(a.positions.size(), b.positions.size()); k++)
    list.push_back(gap(a.positions[k], b.positions[k]).*of);
  return list;
}

std::vector<double> rising_gaps(const StudyRun& a, const StudyRun& b, double Gap::*of) {
  std::vector<double> list = gaps(a, b, of);
  double most = 0.0;
  for (std::size_t k = 0; k < list.size(); k++) {
    if (!std::isfinite(list[k])) {
      list.resize(k);
      break;
    }
    most = list[k] = std::max(most, list[k]);
  }
  return list;
}

double largest_until(const Study& study, const std::vector<double>& list, double until) {
  double result = 0.0;
  for (std::size_t k = 0; k < list.size() && study.times[k] <= until * (1 + 1e-9); k++)
    if (!(list[k] <= result)) result = list[k];
  return result;
}

double last_within(const Study& study, const std::vector<double>& list, double limit) {
  double time = 0.0;
  for (std::size_t k = 0; k < list.size() && list[k] <= limit; k++) time = study.times[k];
  return time;
}

}  // namespace pantin::player
