#include "articulates/solve/prediction.hpp"

#include <algorithm>

#include "articulates/solve/node_batches.hpp"

namespace pantin {

namespace {

/// Takes the newest value into a table of differences, and returns what its first `order` levels make of the next one.
template <class T, class Miss>
T extrapolate(std::array<T, Predictor::levels>& table, T value, const std::array<double, Predictor::levels>& old_scale,
              const std::array<double, Predictor::levels>& scale, std::size_t order, Miss miss) {
  T next = value * 0.0;
  for (std::size_t k = 0; k < Predictor::levels; k++) {
    const T before = table[k];
    table[k] = value;
    miss(k, value);
    if (k < order) next += value * scale[k];
    value -= before * old_scale[k];
  }
  return next;
}

/// The order that would have missed least; where the steps are too long for the motion, the last values serve best.
std::size_t best_order(const Predictor& predictor) {
  const std::size_t known = predictor.known;
  if (known <= 2) return known;
  if (predictor.rough) return 1;
  const auto first = predictor.missed.begin() + 1,
             last = predictor.missed.begin() + static_cast<std::ptrdiff_t>(std::min(known, Predictor::levels));
  return static_cast<std::size_t>(std::min_element(first, last) - predictor.missed.begin());
}

/// Places the middle of a step of `h` after one of `last_h`.
void set_scale(Predictor& predictor, double last_h, double h) {
  const double away = 0.5 * (last_h + h);
  predictor.scale[0] = 1.0;
  double since = away;
  for (std::size_t k = 1; k < Predictor::levels; k++) {
    predictor.scale[k] = k < predictor.known ? predictor.scale[k - 1] * since / predictor.since[k] : 0.0;
    if (!(std::fabs(predictor.scale[k]) < 1e3))
      predictor.known = std::min(predictor.known, k);  // middles that coincide
    const double next = away + predictor.since[k];
    predictor.since[k] = since;
    since = next;
  }
}

}  // namespace

Prediction::Prediction(Articulate& a, double h) : a_(a), h_(h), old_scale_(a.predictor.scale) {
  if (a.last_h == 0.0) a.predictor.known = 0;
  set_scale(a.predictor, a.last_h, h);
  order_ = best_order(a.predictor);
  rate_ = a.predictor.known > 0 ? 1.0 / a.last_h : 0.0;
}

void Prediction::batch(std::size_t b) {
  NodeBatch& n = a_.batches[b];
  const auto miss = [&](std::size_t k, const Vec3x4& by) { rotations_missed_[k] += norm2(by) * n.reach2; };
  const Vec3x4 next =
      extrapolate(a_.predictor.rates[b], n.cayley * rate_, old_scale_, a_.predictor.scale, order_, miss);
  n.cayley = (order_ == 0 ? start_spins(a_, b) : next) * h_;
}

void Prediction::row(std::size_t k) {
  Row& row = a_.rows[k];
  const auto miss = [&](std::size_t level, Vec3 by) { forces_missed_[level] += by * by; };
  const Vec3 next = extrapolate(a_.predictor.forces[k], row.f, old_scale_, a_.predictor.scale, order_, miss);
  if (!a_.expected.empty() && finite(a_.expected[k]))
    row.f = a_.expected[k];
  else if (a_.weak)
    row.f *= 0.98;  // forgets multipliers that the equations do not determine
  else if (order_ > 0)
    row.f = next;
}

void Prediction::end() {
  Predictor& predictor = a_.predictor;
  // Where nothing turns, the forces tell how smooth the motion is.
  const auto& missed = sum(rotations_missed_[0]) > 0.0 ? rotations_missed_ : forces_missed_;
  for (std::size_t k = 1; k < Predictor::levels; k++)
    predictor.missed[k] = k < predictor.known ? 0.5 * predictor.missed[k] + sum(missed[k]) : 0.0;
  predictor.known = std::min(predictor.known + 1, Predictor::levels);
  a_.expected.clear();
}

}  // namespace pantin
