#include "articulates/solve/prediction.hpp"

#include <algorithm>

#include "articulates/solve/batches.hpp"

namespace pantin {

namespace {

/// Takes the newest value into a table of differences, and returns what its first `order` levels make of the next one.
template <class T, class Miss>
T extrapolate(std::array<T, Forecast::levels>& table, T value, const std::array<double, Forecast::levels>& old_scale,
              const std::array<double, Forecast::levels>& scale, std::size_t order, Miss miss) {
  T next = value * 0.0;
  for (std::size_t k = 0; k < Forecast::levels; k++) {
    const T before = table[k];
    table[k] = value;
    miss(k, value);
    if (k < order) next += value * scale[k];
    value -= before * old_scale[k];
  }
  return next;
}

/// The order that would have missed least; where the steps are too long for the motion, the last values serve best.
std::size_t best_order(const Forecast& forecast) {
  const std::size_t known = forecast.known;
  if (known <= 2) return known;
  if (forecast.rough) return 1;
  const auto first = forecast.missed.begin() + 1,
             last = forecast.missed.begin() + static_cast<std::ptrdiff_t>(std::min(known, Forecast::levels));
  return static_cast<std::size_t>(std::min_element(first, last) - forecast.missed.begin());
}

/// Places the middle of a step of `h` after one of `last_h`.
void set_scale(Forecast& forecast, double last_h, double h) {
  const double away = 0.5 * (last_h + h);
  forecast.scale[0] = 1.0;
  double since = away;
  for (std::size_t k = 1; k < Forecast::levels; k++) {
    forecast.scale[k] = k < forecast.known ? forecast.scale[k - 1] * since / forecast.since[k] : 0.0;
    if (!(std::fabs(forecast.scale[k]) < 1e3)) forecast.known = std::min(forecast.known, k);  // middles that coincide
    const double next = away + forecast.since[k];
    forecast.since[k] = since;
    since = next;
  }
}

}  // namespace

Prediction::Prediction(Articulate& a, double h) : a_(a), h_(h), old_scale_(a.forecast.scale) {
  if (a.last_h == 0.0) a.forecast.known = 0;
  set_scale(a.forecast, a.last_h, h);
  order_ = best_order(a.forecast);
  rate_ = a.forecast.known > 0 ? 1.0 / a.last_h : 0.0;
}

void Prediction::batch(std::size_t b) {
  NodeBatch& n = a_.batches[b];
  const auto miss = [&](std::size_t k, const Vec3x4& by) { rotations_missed_[k] += norm2(by) * n.reach2; };
  const Vec3x4 next = extrapolate(a_.forecast.rates[b], n.a * rate_, old_scale_, a_.forecast.scale, order_, miss);
  n.a = (order_ == 0 ? start_spins(a_, b) : next) * h_;
}

void Prediction::row(std::size_t k) {
  Row& row = a_.rows[k];
  const auto miss = [&](std::size_t level, Vec3 by) { forces_missed_[level] += by * by; };
  const Vec3 next = extrapolate(a_.forecast.forces[k], row.f, old_scale_, a_.forecast.scale, order_, miss);
  if (!a_.expected.empty() && finite(a_.expected[k]))
    row.f = a_.expected[k];
  else if (a_.weak)
    row.f *= 0.98;  // forgets multipliers that the equations do not determine
  else if (order_ > 0)
    row.f = next;
}

void Prediction::end() {
  Forecast& forecast = a_.forecast;
  // Where nothing turns, the forces tell how smooth the motion is.
  const auto& missed = sum(rotations_missed_[0]) > 0.0 ? rotations_missed_ : forces_missed_;
  for (std::size_t k = 1; k < Forecast::levels; k++)
    forecast.missed[k] = k < forecast.known ? 0.5 * forecast.missed[k] + sum(missed[k]) : 0.0;
  forecast.known = std::min(forecast.known + 1, Forecast::levels);
  a_.expected.clear();
}

}  // namespace pantin
