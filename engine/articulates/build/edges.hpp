#pragma once
// What ties a body or a free point to others, as rows still to be made.
#include <vector>

#include "articulates/articulate.hpp"
#include "articulates/build/tied_things.hpp"

namespace pantin {

/// A row that a hinge, a constraint or a solved connection wants; its nodes as the model tells them at present.
struct Edge {
  const RowRule* rule = &rigid_row;
  bool angular = false;
  bool may_break = false;
  std::uint32_t index = 0;      // which row of its constraint
  std::int32_t a = -1, b = -1;  // nodes; b = -1: the world
  PointId member, star_point;   // of a hinge
  ConstraintId constraint;
  ConnectionId connection;
  Solve solve = Solve::explicitly;  // how the connection acts
  Vec3 la = zero3(), lb = zero3();  // arms, or axes, in principal axes
};

/// Each edge is `listed` by one of the things that it concerns, so that all things list all edges once.
enum class EdgesOf : std::uint8_t { listed, all };
/// Adds the edges of a thing.
void find_edges(const Model& model, Thing thing, EdgesOf which, std::vector<Edge>& edges);

/// The body of a point, or the point itself.
Thing owner(const Model& model, PointId point);
/// Order of making.
std::uint64_t serial_of(const Model& model, Thing thing);
/// Index of a thing in its articulate.
std::int32_t& node_of(Model& model, Thing thing);
std::int32_t node_of(const Model& model, Thing thing);

}  // namespace pantin
