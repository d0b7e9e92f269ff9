#pragma once
// Whether what a law was traced to does what its function does.
#include <map>
#include <span>
#include <string>
#include <vector>

#include "lua/law/fallback.hpp"

namespace pantin::lua {

/// Made-up pairs or particles: distances from small to large and near the cutoff, motion in all directions, attributes of
/// both signs and 0. The same in every run.
class Samples {
 public:
  static constexpr int count = 32;

  Samples(const CalledLaw& called, double time);
  /// Exchanges a and b.
  void exchange();
  /// Columns in the order of the law's inputs_wanted; valid while this lives and is not exchanged.
  Called::Block block();

 private:
  void fill(const LawFunction& law);

  std::vector<Input> wanted_;
  std::map<Input, std::vector<double>> columns_;
  std::vector<const double*> inputs_;
  std::vector<double> parameters_;
  double time_;
};

/// What the function of a law gives for each of a block, and what its expressions give.
struct Outcome {
  std::vector<std::vector<double>> called;    ///< (outputs × block)
  std::vector<std::string> failures;          ///< (block) "" where the function came through
  std::vector<std::vector<double>> computed;  ///< (outputs × block); empty of a law that is not traced
  std::vector<std::vector<double>> terms;     ///< (outputs × block) size of the largest term of `computed`
};

/// `law`: the expressions, or null.
Outcome outcome(CalledLaw& called, const Law* law, const Called::Block& block);

/// A sentence about where function and expressions differ by more than 1e-9 of the largest term, or "".
std::string disagreement(CalledLaw& called, const Law& law, const Called::Block& block);

/// A sentence about where the law is not the same for exchanged particles, or "". `law`: the expressions, or null.
std::string asymmetry(CalledLaw& called, const Law* law, double time);

/// Whether the function gives something else at one of these times [s] than at another, on any sample.
bool depends_on_time(CalledLaw& called, std::span<const double> times);

}  // namespace pantin::lua
