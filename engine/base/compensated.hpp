#pragma once
#include <cmath>

#include "base/lanes.hpp"

namespace pantin {

/// A sum that carries what rounding takes from it (Neumaier 1974; two-sum of Knuth).
struct CompensatedSum {
  double sum = 0.0, rest = 0.0;

  void add(double x) {
    const double s = sum + x, part = s - sum;
    rest += (sum - (s - part)) + (x - part);
    sum = s;
  }
  void add(const CompensatedSum& other) {
    add(other.sum);
    rest += other.rest;
  }
  double value() const { return sum + rest; }
};

/// Four such sums at a time.
struct CompensatedLanes {
  Vec3 sum = zero3(), rest = zero3();

  void add(Vec3 x) {
    const Vec3 s = sum + x, part = s - sum;
    rest += (sum - (s - part)) + (x - part);
    sum = s;
  }
  CompensatedSum total() const {
    CompensatedSum all;
    for (int i = 0; i < 4; i++) all.add({sum[i], rest[i]});
    return all;
  }
};

}  // namespace pantin
