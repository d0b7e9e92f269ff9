#include "laws/run/skin.hpp"

#include <algorithm>
#include <cmath>

namespace pantin {

void Skin::restart(const Sites& sites, double width) {
  width_ = width;
  start_.resize(sites.n);
  std::copy_n(sites.x.begin(), sites.n, start_.begin());
}

bool Skin::spent(const Sites& sites) const {
  constexpr std::size_t chunk = 512;
  if (start_.size() != sites.n) return true;
  const double most2 = 0.25 * width_ * width_;
  for (std::size_t begin = 0; begin < sites.n; begin += chunk) {
    bool far = false;
    for (std::size_t i = begin; i < std::min(begin + chunk, sites.n); i++)
      far |= !(norm2(sites.x[i] - start_[i]) <= most2);
    if (far) return true;
  }
  return false;
}

double best_skin(const Sites& sites, double dt, double cutoff) {
  // Per step what grows with the rows costs (1 + s)³ (1 + build u / (s / 2)), where s is the skin and u the greatest motion
  // in a step, both in cutoffs, and building costs as much as looking at the rows `build` times: most of an evaluation is
  // for the pairs within the cutoff, whatever the skin. Least where 3 s² + 4 build u s = 2 build u.
  constexpr double build = 7.0;
  if (cutoff == infinity) return 0.0;
  double fastest2 = 0.0;
  for (std::size_t i = 0; i < sites.n; i++) fastest2 = std::max(fastest2, norm2(sites.v[i]));
  const double c = build * std::sqrt(fastest2) * dt / cutoff;
  const double s = c < 1e6 ? (std::sqrt(16.0 * c * c + 24.0 * c) - 4.0 * c) / 6.0 : 0.5;
  return cutoff * std::clamp(s, 0.02, 0.5);
}

}  // namespace pantin
