#pragma once
#include <span>
#include <vector>

#include "laws/law.hpp"
#include "laws/program.hpp"

namespace pantin {

/// A central law along a single pair, with its derivatives: what Newton's iteration asks of it.
class PairCurve {
 public:
  static constexpr int most = 8;  ///< distances at once

  struct Value {
    double pull = 0.0;          ///< [N/m] tension / distance
    double by_distance2 = 0.0;  ///< [N/m³] its derivatives
    double by_approach = 0.0;   ///< [N s/m³]
    double energy = 0.0;        ///< [J] 0 where the law has none
  };

  /// Whether a law can be told so: central, traced, two-sided and without noise.
  static bool possible(const Law& law);
  /// A possible law.
  explicit PairCurve(const Law& law);

  bool has_energy() const { return has_energy_; }
  bool depends_on_velocity() const { return approach_ >= 0; }  ///< depends on how fast the distance changes
  /// Attributes, parameters and time that the law reads; to be set before `run`.
  std::span<const Input> inputs() const { return inputs_; }
  bool set(std::size_t input, double value);  ///< whether it was another

  /// Of n <= most pairs, at distance² [m²] > 0 that changes by `rate` [m/s].
  void run(int n, const double* distance2, double rate);
  Value at(int k) const;

 private:
  bool has_energy_;
  Machine machine_;
  std::vector<Input> inputs_;
  std::vector<int> positions_;  // (inputs) in the machine
  std::vector<double> values_;  // (inputs) last set; NaN: never
  int distance2_, approach_;
  bool changed_ = true;
};

}  // namespace pantin
