#pragma once
// What a build is going to make, worked out before anything is made.
#include <cstdint>
#include <memory>
#include <vector>

#include "shapes/hull.hpp"
#include "structures/build.hpp"

namespace pantin {

/// A body to be.
struct BuildPiece {
  enum class Kind : std::uint8_t { rigid, rod, plate };
  Kind kind = Kind::rigid;
  std::vector<std::uint32_t> vertices;
  std::vector<double> masses;  ///< [kg] of its vertices; empty: they are anchors, and `spread` is the body's own
  MassDistribution spread;     ///< in the structure's frame; with `masses` its mass and centre alone
  std::shared_ptr<const Hull> hull = nullptr;  ///< that it touches others with, in the structure's frame
};

struct BuildPlan {
  std::vector<BuildPiece> pieces;
  std::vector<std::vector<std::uint32_t>> pieces_of;  ///< (vertices) numbers of pieces, rising
  std::vector<double> shares;                         ///< [kg] (vertices)
  std::vector<std::uint32_t> ties;                    ///< edges to be tied by a law: not within a piece

  /// Whether some piece has all of these vertices.
  bool in_one_piece(std::span<const std::uint32_t> vertices) const;
};

/// Throws Error where a number is bad, or the structure lacks what the form is made of.
BuildPlan plan_build(const Structure& structure, const BuildDef& def);

}  // namespace pantin
