#include "laws/run/answers.hpp"

#include <algorithm>
#include <cmath>

namespace pantin {

double velocity_difference(const Sites& sites) {
  double fastest = 0.0;
  for (std::size_t i = 0; i < sites.n; i++) fastest = std::max(fastest, norm2(sites.v[i]));
  return fastest > 0.0 ? 1e-7 * std::sqrt(fastest) : 1e-7;
}

}  // namespace pantin
