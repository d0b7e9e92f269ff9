#pragma once
#include "articulates/articulate.hpp"

namespace pantin {

/// Sets `f` of the rows and `a` of the batches, which are begun, to what a step of `h` [s] starts from. Without history the
/// forces are the last ones, and `a` goes with the spins at the start.
class Prediction {
 public:
  Prediction(Articulate& articulate, double h);
  void row(std::size_t row);
  void batch(std::size_t batch);
  /// Once all rows and batches are predicted.
  void end();

 private:
  Articulate& a_;
  double h_;
  std::array<double, Predictor::levels> old_scale_;
  std::size_t order_ = 0;
  double rate_ = 0.0;
  std::array<Lanes, Predictor::levels> rotations_missed_{}, forces_missed_{};
};

}  // namespace pantin
