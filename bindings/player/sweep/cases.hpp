#pragma once
// Which cases a sweep has: values of parameters, combined or drawn.
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/random.hpp"

namespace pantin::player {

/// The values that one parameter, field or the seed takes.
struct Axis {
  std::string name;
  std::vector<std::string> values;  ///< as `--set` takes them; empty: a range
  double from = 0.0, to = 0.0;
  std::uint64_t count = 0;   ///< of values from `from` to `to`, both with them; 0: not told, as a sample may leave it
  bool logarithmic = false;  ///< evenly in the logarithm
  bool whole = false;        ///< each is rounded to a whole number
  bool of_seeds = false;

  std::uint64_t size() const { return values.empty() ? count : values.size(); }
  /// Of a grid.
  std::string value(std::uint64_t index) const;
  /// At a part in [0, 1] of the way, which a sample drew.
  std::string value_at(double part) const;
  /// Whether a value of the range is its end to a thousandth of the way; of whole numbers, the first or the last.
  bool is_near_end(const std::string& value) const;

 private:
  double between(double part) const;
};

/// Reads "0.5" or "1/60".
std::optional<double> number_or_fraction(const std::string& text);

/// Reads "links=10:1000:20", "mass=1e-3:1e3:7:log", "ratio=1,1e3" or "ratio=5". Throws UsageError.
Axis read_axis(const std::string& setting);
/// Reads "1:100" (each whole number) or "1,5,9". Throws UsageError.
Axis read_seeds(const std::string& seeds);

/// In each dimension the parts of [0, 1) at which points are (dimensions, points): each strip of a point's width has one.
std::vector<std::vector<double>> latin_hypercube(std::size_t dimensions, std::uint64_t points, Random& random);

/// The cases by their numbers, from 0; none is kept.
class Cases {
 public:
  /// With a sample of so many, else the grid of all. Throws UsageError where there are too many, or a range has no count.
  Cases(std::vector<Axis> axes, std::uint64_t sample);
  /// Of a search: where on its axes each case is, `place` says.
  static Cases unplaced(std::vector<Axis> axes, std::uint64_t count);
  void place(std::uint64_t number, const std::vector<double>& parts);

  std::uint64_t count() const { return count_; }
  const std::vector<Axis>& axes() const { return axes_; }
  /// What is set in a case, in the order of the axes. The last axis changes from case to case.
  std::vector<std::pair<std::string, std::string>> settings(std::uint64_t number) const;

 private:
  Cases() = default;

  std::vector<Axis> axes_;
  std::vector<std::vector<double>> parts_;  ///< of a sample or a search: where on its axis each case is (axes, cases)
  std::uint64_t count_ = 1;
};

}  // namespace pantin::player
