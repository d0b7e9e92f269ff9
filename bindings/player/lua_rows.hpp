#pragma once
// Rows of alike things as the loops that a person would have written.
#include <array>
#include <string>
#include <vector>

#include "player/lua_of_body.hpp"

namespace pantin::player {

/// Alike bodies at equal distances, to the bit.
class RowOfBodies {
 public:
  static constexpr std::size_t least = 3;  ///< that are worth a loop

  explicit RowOfBodies(const LuaOfBody& first);
  /// False: it is not the next of them.
  bool take(const LuaOfBody& next);
  std::size_t size() const { return bodies_.size(); }
  /// The loop that makes them; where there is a table, they are [1], [2] … of it.
  std::vector<std::string> lines(const std::string& table) const;

 private:
  /// A coordinate, as a text in `i`, which counts from 0.
  struct Coordinate {
    double first = 0.0, step = 0.0;
    double divisor = 1.0;  // of both, where they are short decimals, whose sums are not to the bit
    double at(std::size_t i) const { return (first + step * static_cast<double>(i)) / divisor; }
    std::string text() const;
  };
  using Ways = std::array<std::vector<Coordinate>, 3>;
  Ways ways_to(const LuaOfBody& second) const;

  std::vector<LuaOfBody> bodies_;
  Ways ways_;  // that lead to all of them; the first is the plainest
};

/// Lines in which only numbers in brackets count up, as "bodies[3]:remove()", as loops.
std::vector<std::string> with_loops(const std::vector<std::string>& lines);

}  // namespace pantin::player
