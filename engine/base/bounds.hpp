#pragma once
#include "base/lanes.hpp"

namespace pantin {

/// A box along the world's axes, [m]; low > high where nothing is in it.
struct Bounds {
  Vec3 low = vec(infinity, infinity, infinity), high = vec(-infinity, -infinity, -infinity);

  bool empty() const { return low[0] > high[0]; }
  void add(Vec3 x) {
    low = x < low ? x : low;
    high = x > high ? x : high;
  }
  void add(const Bounds& b) {
    add(b.low);
    add(b.high);
  }
};
inline Bounds widened(const Bounds& b, double by) {
  const Vec3 d = vec(by, by, by);
  return {b.low - d, b.high + d};
}
inline bool overlap(const Bounds& a, const Bounds& b) {
  for (int i = 0; i < 3; i++)
    if (a.low[i] > b.high[i] || b.low[i] > a.high[i]) return false;
  return true;
}

}  // namespace pantin
