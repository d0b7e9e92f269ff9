#pragma once
// Where in a unit cube a function is largest that takes long to ask, by as many askings at once as there are processors.
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace pantin::player {

/// From 0 to 1 in each dimension.
using CubePoint = std::vector<double>;

/// A Latin hypercube, then local searches side by side, each from the best point of it that no other is near to and, where
/// that has converged, from the next: Nelder and Mead's (1965) and Powell's BOBYQA (2009) in turn, of NLopt. Which points
/// are asked follows from the values alone, whatever the order in which they come.
class Search {
 public:
  /// `points`, at least 1, is how many may be asked. Points with an equal `key` are one, and asked once by each search.
  Search(std::size_t dimensions, std::uint64_t points, std::function<std::string(const CubePoint&)> key);

  struct Asked {
    std::uint64_t number = 0;  ///< below `points`
    CubePoint at;
  };
  /// A point whose value is wanted. None: none until another value is told, or, where all are told, none any more.
  std::optional<Asked> ask();
  /// What is not finite is worse than all others.
  void tell(std::uint64_t number, double value);

  /// The library and its version, on which the points depend.
  static std::string library();

 private:
  using Costs = std::map<std::string, double>;  ///< by the points' keys
  struct Climb {
    std::vector<CubePoint> points;  ///< that it asked, but for those of the sample
    Costs known;                    ///< of these
  };
  void begin_climbs();
  CubePoint start_of(std::size_t climb, std::size_t start) const;
  std::optional<CubePoint> next_of(std::size_t climb) const;

  std::size_t dimensions_;
  std::uint64_t points_;
  std::function<std::string(const CubePoint&)> key_;
  std::vector<CubePoint> sample_;
  std::vector<double> costs_;           ///< of the sample
  std::uint64_t asked_ = 0, told_ = 0;  ///< of the sample
  Costs known_;                         ///< the same
  double step_ = 0.0;                   ///< with which local searches begin, and how far apart they do
  std::vector<CubePoint> starts_;       ///< of the sample, the best first
  std::vector<Climb> climbs_;
  std::deque<std::size_t> ready_;  ///< climbs that wait for no value
};

}  // namespace pantin::player
