#pragma once
// Between the nodes and rows of an articulate and the batches that the solver works on.
#include <span>

#include "articulates/articulate.hpp"
#include "articulates/solve/midpoint.hpp"

namespace pantin {

/// Makes the batches of an articulate that is otherwise laid out.
void lay_out_batches(Articulate& articulate);

inline std::span<RowEnds> ends_of(Articulate& a, const NodeBatch& batch) {
  return {a.ends.data() + batch.first_end, batch.last_end - batch.first_end};
}
/// How many ends of a batch meet others there: those of hubs do not.
std::size_t ends_with_blocks(const Articulate& articulate, std::size_t batch);
/// Where ends i and j of a node in a lane meet; null where it has not as many.
inline RowBlock* row_block(Articulate& a, std::size_t batch, std::size_t lane, std::size_t i, std::size_t j) {
  const std::size_t later = i < j ? j : i, earlier = i < j ? i : j, node = batch_size * batch + lane;
  if (node >= a.nodes.size()) return nullptr;
  const std::size_t position = a.first_row_block[node] + later * (later + 1) / 2 + earlier;
  return position < a.first_row_block[node + 1] ? &a.row_blocks[position] : nullptr;
}

/// What ends tell their rows.
inline void scatter_to_rows(Articulate& a, const RowEnds& end, const Vec3x4& what) {
  const auto each = unpack(what);
  for (std::size_t lane = 0; lane < batch_size; lane++) a.at_ends[end.to[lane]] = each[lane];
}
/// What both ends of row k told it, with their signs.
inline Vec3 gather_for_row(const Articulate& a, std::size_t k) {
  return a.rows[k].b >= 0 ? a.at_ends[2 * k] + a.at_ends[2 * k + 1] : a.at_ends[2 * k];
}
/// What the rows of ends have, side by side: what(k) is a Vec3 of row k.
template <class What>
Vec3x4 fetch(const RowEnds& end, What what) {
  return pack(what(end.row[0]), what(end.row[1]), what(end.row[2]), what(end.row[3]));
}

/// R0 or R1 of the nodes.
Mat3x4 rotations(const Articulate& articulate, std::size_t batch, Mat3 Node::*R);
/// Of the nodes begun so far: the largest square of a speed [m²/s²], and the largest coordinate [m].
struct Largest {
  Lanes speed2 = lanes(0.0), position = lanes(0.0);
};
/// Prepares a step of `h` [s] from the nodes' starts, but for `cayley`.
void begin(Articulate& articulate, std::size_t batch, double h, Largest& largest);
/// Spins at the start, world axes [rad/s].
Vec3x4 start_spins(const Articulate& articulate, std::size_t batch);
/// Sets arms at the start or end from the nodes, and hands their rows the positions.
void place_at_start(Articulate& articulate, std::size_t batch);
void place_at_end(Articulate& articulate, std::size_t batch);
/// Tells the nodes x1, q1, R1 and cayley.
void tell_positions(Articulate& articulate, std::size_t batch);
/// Makes the end of a solved step of `h` [s] the nodes' start, and leaves their ends behind; returns the work of pushes and
/// twists [J].
Lanes commit(Articulate& articulate, std::size_t batch, double h, Vec3 gravity);

/// Reads the momenta of the nodes' starts, and tells them.
void read_momenta(Articulate& articulate, std::size_t batch);
void tell_momenta(Articulate& articulate, std::size_t batch);
/// Kinetic energies of the momenta [J].
inline Lanes kinetic_energy(const NodeBatch& n) {
  return (norm2(n.p) * n.inverse_mass + dot(n.L, n.inverse_inertia_world * n.L)) * 0.5;
}
/// Adds impulses [N s] to the momenta, at the arms of the end: impulse(k) is that of row k.
template <class Impulse>
void add_impulses(Articulate& a, NodeBatch& n, Impulse impulse) {
  RowLoad load{zero3x4(), zero3x4()};
  for (const RowEnds& end : ends_of(a, n)) add_load(load, end, fetch(end, impulse), end.r1);
  n.p += load.force;
  n.L += load.torque;
}

}  // namespace pantin
