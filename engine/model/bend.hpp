#pragma once
#include "base/lanes.hpp"

namespace pantin {

/// What something that moves as it wants is off the straight way between the ends of a step, at the part s (0 … 1) of it: a
/// polynomial of fourth order, zero at both ends, through what it is off at a quarter, a half and three quarters.
struct Bend {
  Vec3 middle = zero3(), slope = zero3(), curve = zero3();
  double missed = 0.0;  ///< what it is off itself, where it was looked at between these

  static Bend through(Vec3 quarter, Vec3 half, Vec3 three_quarters) {
    const Vec3 a = quarter * (16.0 / 3.0), b = half * 4.0, c = three_quarters * (16.0 / 3.0);
    return {b, (c - a) * 0.5, (a + c) * 0.5 - b, 0.0};
  }

  /// With all that it is off mapped, which makes it larger by `scale`.
  template <class Map>
  Bend mapped(double scale, Map map) const {
    return {map(middle), map(slope), map(curve), missed * scale};
  }
  Vec3 at(double s) const { return factor(s) * (s * (1.0 - s)); }
  /// Its derivative by s.
  Vec3 rate(double s) const {
    return factor(s) * (1.0 - 2.0 * s) + (slope + curve * (2.0 * u(s))) * (4.0 * s * (1.0 - s));
  }
  bool straight() const { return norm2(middle) + norm2(slope) + norm2(curve) == 0.0; }

 private:
  static double u(double s) { return 4.0 * s - 2.0; }
  Vec3 factor(double s) const { return middle + slope * u(s) + curve * (u(s) * u(s)); }
};

}  // namespace pantin
