#pragma once
#include <vector>

#include "articulates/articulate.hpp"

namespace pantin {

/// Ends of strings that are at their anchors in a fallback step: while a string pulls more than such an end does, it stays there,
/// as if it had no end to its mass; else it moves on, and its string goes with it.
class EndsAtAnchors {
 public:
  explicit EndsAtAnchors(Articulate& a) : a_(a) {}

  /// Takes those that are at their anchors, or come to them within h [s], and puts them there.
  void take(double h);
  bool none() const { return ends_.empty(); }
  /// Whether some came from elsewhere.
  bool met() const { return met_; }
  /// From here on nothing moves them.
  void fix();
  /// After velocities were made consistent: lets go of those that pull more than their string did; whether some do.
  bool let_go();
  void rest();
  /// Gives them their masses again, at rest.
  void release();

 private:
  struct End {
    std::uint32_t row;
    double inverse_mass;
  };
  Node& node_of(std::uint32_t row) { return a_.nodes[static_cast<std::size_t>(a_.rows[row].a)]; }
  void set_inverse_mass(std::uint32_t row, double inverse_mass);

  Articulate& a_;
  std::vector<End> ends_;
  bool met_ = false;
};

}  // namespace pantin
