#pragma once
// Predicts the unknowns of a step by polynomials through those of the last ones, of the order that was least wrong of
// late, and of the first where the motion is too rough for others. The steps may be of any lengths: modified divided
// differences (Krogh 1969; Shampine and Gordon 1975).
#include <array>
#include <cstdint>
#include <vector>

#include "base/batch.hpp"

namespace pantin {

struct Forecast {
  static constexpr std::size_t levels = 7;
  using OfRow = std::array<Vec3, levels>;
  using OfBatch = std::array<Vec3x4, levels>;
  std::size_t known = 0;  // how many last steps
  bool rough = false;     // the last prediction was far off
  // ψ_i: [s] from the middle of the last step but i to that of the last; and by what the next step multiplies level i
  std::array<double, levels> since{}, scale{};
  std::array<double, levels> missed{};  // by how much each order missed the rotations of late, squared
  std::vector<OfRow> forces;            // (rows) differences of rising order, [N]
  std::vector<OfBatch> rates;           // (batches) the same of a/h, [1/s]
};

struct Articulate;

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
  std::array<double, Forecast::levels> old_scale_;
  std::size_t order_ = 0;
  double rate_ = 0.0;
  std::array<Lanes, Forecast::levels> rotations_missed_{}, forces_missed_{};
};

}  // namespace pantin
