#pragma once
// Functions over a unit cube to search: how far their search came is known.
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "base/random.hpp"
#include "player/sweep/cases.hpp"
#include "player/sweep/search.hpp"

namespace pantin::support {

using player::CubePoint;

struct Searched {
  std::string name;
  std::size_t dimensions = 1;
  double goal = 0.0;  ///< a value that counts as found; the largest is 0, but of `edge` 1
  /// Of a point, and of a place that moves the function about.
  double (*value)(const CubePoint& at, const CubePoint& place) = nullptr;
};

inline constexpr double failed_case = std::numeric_limits<double>::quiet_NaN();

inline double distance_squared(const CubePoint& a, const CubePoint& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); i++) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return sum;
}

inline double bowl(const CubePoint& at, const CubePoint& place) { return -distance_squared(at, place); }

/// Rosenbrock's (1960).
inline double valley(const CubePoint& at, const CubePoint& place) {
  const double x = 1.0 + 3.0 * (at[0] - place[0]), y = 1.0 + 3.0 * (at[1] - place[1]);
  return -100.0 * (y - x * x) * (y - x * x) - (1.0 - x) * (1.0 - x);
}

/// Rastrigin's (1974), of some eight hills along each axis.
inline double hills(const CubePoint& at, const CubePoint& place) {
  double sum = 0.0;
  for (std::size_t i = 0; i < at.size(); i++) {
    const double x = at[i] - place[i];
    sum += x * x + 0.1 * (1.0 - std::cos(8.0 * M_PI * x));
  }
  return -sum;
}

/// The farther out the better, but what goes too far fails.
inline double edge(const CubePoint& at, const CubePoint& place) {
  const double out = std::hypot(at[0], at[1] * (0.5 + place[0])) / 0.9, turn = std::atan2(at[1], at[0]);
  return out > 1.0 || at[1] < 0.15 * place[1] ? failed_case : out * std::cos(turn - 0.3 - 0.8 * place[1]);
}

/// Most of the cube fails.
inline double small_part(const CubePoint& at, const CubePoint& place) {
  const double away = distance_squared(at, place);
  return away > 0.07 || at[0] + at[1] > place[0] + place[1] + 0.05 ? failed_case : -away;
}

/// The first is one of twelve whole numbers.
inline double twelve(double x) { return std::min(11.0, std::floor(12.0 * x)); }
inline double whole(const CubePoint& at, const CubePoint& place) {
  const double n = twelve(at[0]) - twelve(place[0]), x = at[1] - place[1] - 0.02 * n;
  return -0.05 * std::fabs(n) - x * x;
}

inline const Searched searched[] = {
    {"bowl", 2, -1e-4, bowl},         {"bowl of 5", 5, -1e-3, bowl},      {"curved valley", 2, -0.01, valley},
    {"hills", 2, -0.02, hills},       {"edge of failure", 2, 0.98, edge}, {"small part", 3, -1e-3, small_part},
    {"whole number", 2, -1e-3, whole}};

/// Where a function has its largest value in a trial.
inline CubePoint place_of(const Searched& function, std::uint64_t trial) {
  Random random{trial, 0};
  CubePoint place(function.dimensions);
  for (double& x : place) x = 0.1 + 0.8 * random.uniform();
  return place;
}

inline player::Search search_of(const Searched& function, std::uint64_t points) {
  const bool whole_number = function.value == whole;
  return {function.dimensions, points, [whole_number](const CubePoint& at) {
            std::string key;
            for (std::size_t i = 0; i < at.size(); i++)
              key += std::to_string(whole_number && i == 0 ? twelve(at[i]) : 1e6 * at[i]) + " ";
            return key;
          }};
}

/// How many points a search asks until it finds the goal, or `points` + 1.
inline std::uint64_t points_needed(const Searched& function, std::uint64_t trial, std::uint64_t points) {
  const CubePoint place = place_of(function, trial);
  player::Search search = search_of(function, points);
  std::uint64_t needed = points + 1;
  while (const auto asked = search.ask()) {
    const double value = function.value(asked->at, place);
    if (value >= function.goal) needed = std::min(needed, asked->number + 1);
    search.tell(asked->number, value);
  }
  return needed;
}

/// How long that takes where so many points at a time are asked: in points one after the other. Else `points` + 1.
inline std::uint64_t rounds_needed(const Searched& function, std::uint64_t trial, std::uint64_t points,
                                   std::size_t at_a_time) {
  const CubePoint place = place_of(function, trial);
  player::Search search = search_of(function, points);
  for (std::uint64_t round = 1;; round++) {
    std::vector<player::Search::Asked> all;
    while (all.size() < at_a_time)
      if (auto asked = search.ask())
        all.push_back(*asked);
      else
        break;
    if (all.empty()) return points + 1;
    bool found = false;
    for (const auto& asked : all) {
      const double value = function.value(asked.at, place);
      found = found || value >= function.goal;
      search.tell(asked.number, value);
    }
    if (found) return round;
  }
}

/// The same of a Latin hypercube.
inline std::uint64_t points_of_hypercube(const Searched& function, std::uint64_t trial, std::uint64_t points) {
  const CubePoint place = place_of(function, trial);
  Random random{trial, 1000};
  const auto parts = player::latin_hypercube(function.dimensions, points, random);
  for (std::uint64_t i = 0; i < points; i++) {
    CubePoint at;
    for (const auto& part : parts) at.push_back(part[i]);
    if (function.value(at, place) >= function.goal) return i + 1;
  }
  return points + 1;
}

}  // namespace pantin::support
