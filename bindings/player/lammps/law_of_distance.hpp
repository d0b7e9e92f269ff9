#pragma once
// A central law of a pair as values at distances.
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "laws/law.hpp"

namespace pantin::player {

struct LoweredLaw;

/// A law with all that it reads but the distance. Throws Error, which names the law by `name`, for a law that is no function
/// of distance alone.
class LawOfDistance {
 public:
  static constexpr double resolution = 1e-12;  ///< distances that differ by less, relative to themselves, are one

  struct Value {
    double energy = 0.0;  ///< [J] 0 of a law without
    double force = 0.0;   ///< [N] pushes apart where positive
    double slope = 0.0;   ///< [N/m] of the force by distance
  };

  LawOfDistance(const std::string& name, const Law& law, std::span<const double> parameters,
                const std::function<double(int who, const std::string& attribute)>& attribute);

  const std::string& name() const { return name_; }
  bool has_energy() const { return has_energy_; }
  /// (r) values at distances [m] > 0.
  std::vector<Value> at(std::span<const double> r);
  /// Distances [m] within a range at which one branch of the law goes over into another, rising.
  std::vector<double> kinks(double from, double to);

 private:
  std::string name_;
  bool has_energy_;
  Machine machine_;
  int distance2_;
  std::size_t conditions_;  ///< differences that change their sign where branches meet, after the other outputs

  LawOfDistance(const LoweredLaw& lowered, const std::string& name, const Law& law, std::span<const double> parameters,
                const std::function<double(int who, const std::string& attribute)>& attribute);
  void run(std::span<const double> r, const std::function<void(std::size_t)>& read);
  std::vector<std::vector<double>> conditions_at(std::span<const double> r);
};

}  // namespace pantin::player
