#pragma once
// Predicts the unknowns of a step by polynomials through those of the last ones, of the order that was least wrong of
// late, and of the first where the motion is too rough for others. The steps may be of any lengths: modified divided
// differences (Krogh 1969; Shampine and Gordon 1975).
#include <array>
#include <cstdint>
#include <vector>

#include "base/vectors4.hpp"

namespace pantin {

struct Predictor {
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

}  // namespace pantin
