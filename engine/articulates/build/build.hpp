#pragma once
// How an articulate is made, and made anew after an edit with what the last steps taught.
#include <memory>
#include <span>
#include <vector>

#include "articulates/articulate.hpp"
#include "articulates/build/edges.hpp"
#include "articulates/build/tied_things.hpp"

namespace pantin {

using Articulates = std::vector<std::unique_ptr<Articulate>>;

/// Builds the articulate of a connected set of things, in the order of their serials, and tells the model their nodes.
/// Those of `before`, which the model's `articulate` and `node` still name, hand their history on.
std::unique_ptr<Articulate> build_articulate(Model& model, std::span<const Thing> things, const Articulates& before);

/// Finds anew what follows from the nodes and rows of one that was read from a file. Throws Error where it contradicts itself.
void lay_out_again(Articulate& articulate);

/// Whether nothing of what its articulate holds of a thing has changed: its mass, and the rows that it is in.
bool is_as_built(const Model& model, const Articulate& articulate, Thing thing);

/// Whether a row is that of an edge; the numbers of nodes do not count.
bool is_row_of(const Articulate& articulate, const Row& row, const Edge& edge);

/// The row lists of nodes; `Ends` has nodes a and b, b = -1: the world.
template <class Ends>
RowLists rows_of_nodes(std::size_t nodes, const std::vector<Ends>& rows) {
  RowLists lists;
  lists.first.assign(nodes + 1, 0);
  for (const Ends& row : rows) {
    lists.first[static_cast<std::size_t>(row.a) + 1]++;
    if (row.b >= 0) lists.first[static_cast<std::size_t>(row.b) + 1]++;
  }
  for (std::size_t n = 0; n < nodes; n++) lists.first[n + 1] += lists.first[n];
  lists.rows.resize(lists.first[nodes]);
  std::vector<std::uint32_t> next(lists.first.begin(), lists.first.end() - 1);
  for (std::uint32_t k = 0; k < rows.size(); k++) {
    lists.rows[next[static_cast<std::size_t>(rows[k].a)]++] = k;
    if (rows[k].b >= 0) lists.rows[next[static_cast<std::size_t>(rows[k].b)]++] = k;
  }
  return lists;
}

/// Finds which blocks of the matrix rows meet in, and what a sweep may do when.
void find_row_blocks(Articulate& articulate);
void find_tiles(Articulate& articulate);

/// Finds the lengths of an articulate and its nodes, what it has of rows, whether it has loops, and about which axes
/// nodes turn freely.
void find_dimensions(Articulate& articulate, const Model& model);

/// The length of what has none of its own (free particles that meet, or that planes alone hold), at the start of each step [s]: how far a
/// node goes in 256 steps, remembered as long; at least what gravity moves in one, and 1e-6 of its distance from the origin,
/// which is round-off. 1 m for what rests there.
void find_length_of_motion(Articulate& articulate, const Model& model, Vec3 gravity, double step);
/// At least as far as its nodes would go in a step [s] from what they are kicked to: where they are held, nothing else tells what
/// is much for them.
void grow_length_of_motion(Articulate& articulate, double step);

}  // namespace pantin
