#include "player/machine.hpp"

#include <time.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.hpp"
#include "base/lanes.hpp"

namespace pantin::player {

double thread_time() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

double product_time() {
  constexpr int products = 20000;
  const Mat3 turn = matrix(normalised({1.0, 0.1, 0.2, 0.3}));
  Mat3 m = identity33();
  double best = std::numeric_limits<double>::infinity();
  for (int window = 0; window < 10; window++) {
    const double start = thread_time();
    for (int i = 0; i < products; i++) m = m * turn;
    best = std::min(best, (thread_time() - start) / products);
  }
  require(std::isfinite(trace(m)), "the product of rotations is not finite");
  return best;
}

}  // namespace pantin::player
