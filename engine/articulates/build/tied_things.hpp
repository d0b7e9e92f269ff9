#pragma once
#include <memory>
#include <vector>

#include "articulates/articulate.hpp"
#include "model/model.hpp"

namespace pantin {

/// A body or a free point, as the search sees it.
struct Thing {
  std::uint32_t slot;
  bool is_body;
  bool operator==(const Thing&) const = default;
};

/// What became of the inertia of bodies that were tied or got loose.
struct InertiaChanges {
  double energy = 0.0;         ///< [J] that this gave
  std::vector<BodyId> lifted;  ///< move with more than their own
};

/// Finds anew what the edits since the last call concerned: articulates in which an edited thing is no longer tied as it
/// was are taken apart, and their things, with the untied things that were edited, are gathered into articulates or
/// found loose. Articulates stay in the order of their smallest serial.
InertiaChanges find_tied_things(Model& model, std::vector<std::unique_ptr<Articulate>>& articulates,
                                std::vector<std::uint32_t>& loose_bodies, std::vector<std::uint32_t>& loose_points);

}  // namespace pantin
