#include "forces/swing.hpp"

#include <algorithm>
#include <cmath>

namespace pantin {

void Swing::add(Vec3 position, double time, double weight) {
  if (!begun) {
    begun = true;
    first = position;
    since = time;
  }
  const Vec3 d = position - first;
  const double at = time - since;
  n += weight;
  t += at * weight;
  tt += at * at * weight;
  x += d * weight;
  xt += d * (at * weight);
  squares += d * d * weight;
  products += d * rotate_lanes(d) * weight;
}

double Swing::along(Vec3 u) const {
  if (n == 0.0) return 0.0;
  const double square = dot(squares, u * u) + 2.0 * dot(products, u * rotate_lanes(u));
  const double mean = dot(x, u) / n, times = tt - t * t / n, both = dot(xt, u) - mean * t;
  const double rest = square - n * mean * mean - (times > 0.0 ? both * both / times : 0.0);
  constexpr double round_off = 1e-14;
  return rest > round_off * square ? std::sqrt(8.0 * rest / n) : 0.0;
}

}  // namespace pantin
