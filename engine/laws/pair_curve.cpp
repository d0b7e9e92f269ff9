#include "laws/pair_curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "laws/derivative.hpp"
#include "laws/kernels.hpp"

namespace pantin {

namespace {

const Input of_distance2{Role::distance2, 0, 0, {}}, of_approach{Role::approach, 0, 0, {}};

Program program_of(const Law& law) {
  Expressions graph = law.graph;
  const Expr pull = law.force[0];
  std::vector<Expr> outputs = {pull, derivative(graph, pull, of_distance2), derivative(graph, pull, of_approach)};
  if (law.energy != no_expression) outputs.push_back(law.energy);
  graph.put_in_order(outputs);
  return lower(graph, outputs);
}

}  // namespace

bool PairCurve::possible(const Law& law) {
  if (law.kind != LawKind::central || law.called || law.one_sided) return false;
  return !law.graph.depends_on(law.force[0], Role::noise);
}

PairCurve::PairCurve(const Law& law)
    : has_energy_(law.energy != no_expression), machine_(program_of(law), kernels::padding) {
  std::vector<Expr> outputs = law.force;
  if (has_energy_) outputs.push_back(law.energy);
  for (const Input& input : law.graph.inputs_of(outputs)) {
    const int position = machine_.input(input);
    if (position < 0 || input == of_distance2 || input == of_approach) continue;
    inputs_.push_back(input);
    positions_.push_back(position);
    values_.push_back(std::numeric_limits<double>::quiet_NaN());
  }
  distance2_ = machine_.input(of_distance2);
  approach_ = machine_.input(of_approach);
}

bool PairCurve::set(std::size_t input, double value) {
  if (std::exchange(values_[input], value) == value) return false;
  machine_.fill(positions_[input], value);
  changed_ = true;
  return true;
}

void PairCurve::run(int n, const double* distance2, double rate) {
  if (changed_) machine_.run_uniform();
  changed_ = false;
  if (distance2_ >= 0) {
    double* column = machine_.column(distance2_);
    std::copy_n(distance2, n, column);
    std::fill(column + n, column + kernels::padding, distance2[n - 1]);
  }
  if (approach_ >= 0) {
    double* column = machine_.column(approach_);
    for (int k = 0; k < kernels::padding; k++) column[k] = std::sqrt(distance2[std::min(k, n - 1)]) * rate;
  }
  machine_.run(n);
}

PairCurve::Value PairCurve::at(int k) const {
  return {machine_.output(0)[k], machine_.output(1)[k], machine_.output(2)[k],
          has_energy_ ? machine_.output(3)[k] : 0.0};
}

}  // namespace pantin
