#pragma once
#include "articulates/build/build.hpp"

namespace pantin {

/// What the last steps taught about things that an edit gathers into one articulate: unknowns and their predictions.
class History {
 public:
  /// Call before the model is told new nodes.
  History(const Model& model, std::span<const Thing> things, const Articulates& before);

  struct Match {
    const Articulate* articulate = nullptr;
    const Row* row = nullptr;
    std::size_t index() const { return static_cast<std::size_t>(row - articulate->rows.data()); }
  };
  /// The row that an edge made between the same nodes, or null. The nodes of the edge are things.
  Match row(const Edge& edge) const;
  /// Sets what an articulate, not its nodes and rows, knows.
  void inherit(Articulate& articulate) const;
  /// Sets what its batches know, of `things` (nodes).
  void inherit(Articulate& articulate, std::span<const std::uint32_t> things) const;

 private:
  struct Origin {
    const Articulate* articulate = nullptr;
    std::uint32_t index = 0;
  };
  std::vector<Origin> nodes_;  // (things)
};

}  // namespace pantin
