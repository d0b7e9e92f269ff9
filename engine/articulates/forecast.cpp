#include "articulates/forecast.hpp"

#include <algorithm>

#include "articulates/batches.hpp"

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

void predict(Articulate& a, double h) {
  Forecast& forecast = a.forecast;
  if (a.last_h == 0.0) forecast.known = 0;
  const std::array<double, Forecast::levels> old_scale = forecast.scale;
  set_scale(forecast, a.last_h, h);
  const std::size_t order = a.weak ? std::min<std::size_t>(forecast.known, 1) : best_order(forecast);
  const double rate = forecast.known > 0 ? 1.0 / a.last_h : 0.0;
  std::array<Lanes, Forecast::levels> missed{};
  for (std::size_t b = 0; b < a.batches.size(); b++) {
    NodeBatch& n = a.batches[b];
    const auto miss = [&](std::size_t k, const Vec3x4& by) { missed[k] += norm2(by) * n.reach2; };
    const Vec3x4 next = extrapolate(forecast.rates[b], n.a * rate, old_scale, forecast.scale, order, miss);
    n.a_saved = (order == 0 ? start_spins(a, b) : next) * h;
  }
  const bool turning = sum(missed[0]) > 0.0;  // else the forces tell how smooth the motion is
  for (std::size_t k = 0; k < a.rows.size(); k++) {
    Row& row = a.rows[k];
    const auto miss = [&](std::size_t level, Vec3 by) {
      if (!turning) missed[level] += by * by;
    };
    const Vec3 next = extrapolate(forecast.forces[k], row.f, old_scale, forecast.scale, order, miss);
    // Forgets multipliers that the equations do not determine.
    row.f_saved = a.weak ? row.f * 0.95 : order == 0 ? row.f : next;
  }
  for (std::size_t k = 1; k < Forecast::levels; k++)
    forecast.missed[k] = k < forecast.known ? 0.5 * forecast.missed[k] + sum(missed[k]) : 0.0;
  forecast.known = std::min(forecast.known + 1, Forecast::levels);
}

}  // namespace pantin
