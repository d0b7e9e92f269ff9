#pragma once
#include <memory>
#include <span>
#include <vector>

#include "articulates/articulate.hpp"
#include "model/model.hpp"

namespace pantin {

/// Finds anew what the edits since the last call touched: articulates that an edit made dirty are taken apart and their
/// things, with the untied things that were touched, are gathered into articulates or found loose. Articulates stay in
/// the order of their smallest serial.
void find_articulates(Model& model, std::vector<std::unique_ptr<Articulate>>& articulates,
                      std::vector<std::uint32_t>& loose_bodies, std::vector<std::uint32_t>& loose_points);

/// A body or a free point, as the search sees it.
struct Thing {
  std::uint32_t slot;
  bool is_body;
  bool operator==(const Thing&) const = default;
};
/// Builds the articulate of a connected set of things, in the order of their serials.
std::unique_ptr<Articulate> build_articulate(const Model& model, std::span<const Thing> things);

}  // namespace pantin
