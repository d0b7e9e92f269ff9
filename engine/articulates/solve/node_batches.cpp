#include "articulates/solve/node_batches.hpp"

#include <algorithm>

namespace pantin {

namespace {

Node make_idle() {
  Node n{};
  n.R0 = identity33();
  n.inertia = n.inverse_inertia = vec(1, 1, 1);
  n.mass = n.inverse_mass = 1.0;
  return n;
}
const Node idle = make_idle();

/// The node in a lane; where there is none, one at rest.
const Node& node_in(const Articulate& a, std::size_t batch, std::size_t lane) {
  const std::size_t n = batch_size * batch + lane;
  return n < a.nodes.size() ? a.nodes[n] : idle;
}

/// Copies something of the nodes side by side: what(node) is a Vec3.
template <class What>
Vec3x4 pack_nodes(const Articulate& a, std::size_t b, What what) {
  return pack(what(node_in(a, b, 0)), what(node_in(a, b, 1)), what(node_in(a, b, 2)), what(node_in(a, b, 3)));
}

void set_end(const Articulate& a, RowEnds& end, std::size_t lane, std::uint32_t k, std::size_t node) {
  const Row& row = a.rows[k];
  const bool at_a = row.a == static_cast<std::int32_t>(node), angular = row.lever > 0.0;
  const double sign = at_a ? 1.0 : -1.0;
  end.row[lane] = k;
  end.to[lane] = 2 * k + (at_a ? 0 : 1);
  end.sign[lane] = angular ? 0.0 : sign;
  end.lever[lane] = row.lever * sign;
  if (!angular && a.nodes[node].turns) set_lane(end.l, lane, at_a ? row.la : row.lb);
}

void set_constants(const Articulate& a, NodeBatch& n, std::size_t b) {
  n.count = static_cast<std::uint32_t>(std::min(batch_size, a.nodes.size() - batch_size * b));
  n.first_row = node_in(a, b, 0).first_row;
  const Vec3 one = vec(1, 1, 1);
  n.inertia = pack_nodes(a, b, [&](const Node& node) { return node.turns ? node.inertia : one; });
  n.inverse_inertia = pack_nodes(a, b, [&](const Node& node) { return node.turns ? node.inverse_inertia : zero3(); });
  for (std::size_t lane = 0; lane < batch_size; lane++) {
    const Node& node = node_in(a, b, lane);
    n.inverse_mass[lane] = node.inverse_mass;
    n.reach2[lane] = node.turns ? node.reach * node.reach : 0.0;
  }
}

/// Orientations and rotation matrices at the end.
struct Turned {
  Quatx4 q;
  Mat3x4 R;
};

/// cay(a) turns the starts.
Turned turned(const Articulate& a, std::size_t b) {
  const NodeBatch& n = a.batches[b];
  const Lanes w = square_root(n.c);
  const Vec3x4 u = n.cayley * (w * 0.5);
  const Node *n0 = &node_in(a, b, 0), *n1 = &node_in(a, b, 1), *n2 = &node_in(a, b, 2), *n3 = &node_in(a, b, 3);
  const Quat &q0 = n0->q0, &q1 = n1->q0, &q2 = n2->q0, &q3 = n3->q0;
  const Quatx4 start = {
      {q0.w, q1.w, q2.w, q3.w}, {q0.x, q1.x, q2.x, q3.x}, {q0.y, q1.y, q2.y, q3.y}, {q0.z, q1.z, q2.z, q3.z}};
  const Quatx4 end = Quatx4{w, u.x, u.y, u.z} * start;
  return {end, matrix(end)};
}
Quat lane_of(const Quatx4& q, std::size_t lane) { return {q.w[lane], q.x[lane], q.y[lane], q.z[lane]}; }

/// Marks the row blocks that are the first to reach their block of the factor, as the matrix is filled.
void find_first_to_reach(Articulate& a) {
  std::vector<char> diagonal(a.rows.size(), 0), lower(a.factor.below.size(), 0), upper(lower);
  const auto visit = [](char& reached) {
    const bool first = reached == 0;
    reached = 1;
    return first;
  };
  for (std::size_t b = 0; b < a.batches.size(); b++) {
    const std::size_t ends = ends_with_blocks(a, b);
    for (std::size_t j = 0; j < ends; j++)
      for (std::size_t i = 0; i < ends; i++)
        for (std::size_t lane = 0; lane < batch_size; lane++)
          if (RowBlock* m = row_block(a, b, lane, i, j))
            (i < j ? m->first_upper : m->first_lower) = visit((i == j ? diagonal : i < j ? upper : lower)[m->block]);
  }
}

}  // namespace

void lay_out_batches(Articulate& a) {
  a.at_ends.assign(2 * a.rows.size() + 1, zero3());
  a.batches.assign((a.nodes.size() + batch_size - 1) / batch_size, NodeBatch{});
  a.ends.clear();
  for (std::size_t b = 0; b < a.batches.size(); b++) {
    a.batches[b].first_end = static_cast<std::uint32_t>(a.ends.size());
    for (std::size_t lane = 0; lane < batch_size; lane++) {
      const std::size_t node = batch_size * b + lane;
      if (node >= a.nodes.size()) break;
      for (std::size_t i = 0; i < a.rows_on[node].size(); i++) {
        if (a.batches[b].first_end + i == a.ends.size()) {
          a.ends.emplace_back();
          a.ends.back().row.fill(0);
          a.ends.back().to.fill(static_cast<std::uint32_t>(2 * a.rows.size()));
        }
        set_end(a, a.ends[a.batches[b].first_end + i], lane, a.rows_on[node][i], node);
      }
    }
    a.batches[b].last_end = static_cast<std::uint32_t>(a.ends.size());
    set_constants(a, a.batches[b], b);
  }
  a.predictor.rates.resize(a.batches.size());
  find_first_to_reach(a);
}

std::size_t ends_with_blocks(const Articulate& a, std::size_t batch) {
  std::size_t most = 0;
  for (std::size_t n = batch_size * batch; n < std::min(batch_size * (batch + 1), a.nodes.size()); n++)
    if (a.first_row_block[n] < a.first_row_block[n + 1]) most = std::max(most, a.rows_on[n].size());
  return most;
}

Mat3x4 rotations(const Articulate& a, std::size_t b, Mat3 Node::*R) {
  Mat3x4 packed;
  for (int k = 0; k < 3; k++) packed[k] = pack_nodes(a, b, [&](const Node& n) { return (n.*R)[k]; });
  return packed;
}

void begin(Articulate& a, std::size_t b, double h, Largest& largest) {
  NodeBatch& n = a.batches[b];
  const Mat3x4 R0 = rotations(a, b, &Node::R0);
  const Vec3x4 force = pack_nodes(a, b, [](const Node& node) { return node.force; });
  const Vec3x4 p0 = pack_nodes(a, b, [](const Node& node) { return node.p0; });
  const Vec3x4 x0 = pack_nodes(a, b, [](const Node& node) { return node.x0; });
  n.x_free = x0 + (p0 * 2.0 + force * h) * (n.inverse_mass * (0.5 * h));
  n.sway = n.inverse_mass * (0.5 * h * h);
  n.L0 = R0 * pack_nodes(a, b, [](const Node& node) { return node.P0; });
  n.L_free = n.L0 + pack_nodes(a, b, [](const Node& node) { return node.torque; }) * h;
  n.inertia_rate = congruent(R0, n.inertia * (2.0 / h));
  if (a.last_h != h) n.J_inverse = congruent(R0, n.inverse_inertia * (0.5 * h));
  for (RowEnds& end : ends_of(a, n)) end.r0 = R0 * end.l;
  largest.speed2 = larger(norm2(p0) * n.inverse_mass * n.inverse_mass, largest.speed2);
  for (const Lanes& x : {x0.x, x0.y, x0.z}) largest.position = larger(larger(x, -x), largest.position);
}

Vec3x4 start_spins(const Articulate& a, std::size_t b) {
  return rotations(a, b, &Node::R0) * pack_nodes(a, b, [](const Node& node) { return node.spin0; });
}

void place_at_start(Articulate& a, std::size_t b) {
  const Mat3x4 R0 = rotations(a, b, &Node::R0);
  const Vec3x4 x0 = pack_nodes(a, b, [](const Node& node) { return node.x0; });
  for (RowEnds& end : ends_of(a, a.batches[b])) {
    end.r0 = R0 * end.l;
    scatter_to_rows(a, end, x0 + end.r0);
  }
}

void place_at_end(Articulate& a, std::size_t b) {
  const Mat3x4 R1 = rotations(a, b, &Node::R1);
  const Vec3x4 x1 = pack_nodes(a, b, [](const Node& node) { return node.x1; });
  for (RowEnds& end : ends_of(a, a.batches[b])) {
    end.r1 = R1 * end.l;
    scatter_to_rows(a, end, x1 + end.r1);
  }
}

void tell_positions(Articulate& a, std::size_t b) {
  const NodeBatch& n = a.batches[b];
  const Turned end = turned(a, b);
  const auto x1 = unpack(n.x1), cayley = unpack(n.cayley);
  const auto R1 = unpack(end.R);
  for (std::size_t lane = 0; lane < n.count; lane++) {
    Node& node = a.nodes[batch_size * b + lane];
    node.x1 = x1[lane];
    if (!node.turns) continue;
    node.cayley = cayley[lane];
    node.q1 = lane_of(end.q, lane);
    node.R1 = R1[lane];
  }
}

Lanes commit(Articulate& a, std::size_t b, double h, Vec3 gravity) {
  const NodeBatch& n = a.batches[b];
  const Turned end = turned(a, b);
  const Vec3x4 force = pack_nodes(a, b, [](const Node& node) { return node.force; });
  const Vec3x4 push = pack_nodes(a, b, [&](const Node& node) { return node.force - gravity * node.mass; });
  const Vec3x4 way = n.x1 - pack_nodes(a, b, [](const Node& node) { return node.x0; });
  const Lanes work = dot(push, way) + dot(pack_nodes(a, b, [](const Node& node) { return node.torque; }), n.cayley);
  const Vec3x4 principal = transposed_times(end.R, n.L1);
  const auto x1 = unpack(n.x1), change = unpack((n.row_force + force) * h), P = unpack(principal),
             spin = unpack(principal * n.inverse_inertia);
  const auto R1 = unpack(end.R);
  for (std::size_t lane = 0; lane < n.count; lane++) {
    Node& node = a.nodes[batch_size * b + lane];
    node.x0 = x1[lane];
    node.p0 += change[lane];
    if (!node.turns) continue;
    node.q0 = lane_of(end.q, lane);
    node.R0 = R1[lane];
    node.P0 = P[lane];
    node.spin0 = spin[lane];
  }
  return work;
}

void read_momenta(Articulate& a, std::size_t b) {
  NodeBatch& n = a.batches[b];
  const Mat3x4 R = rotations(a, b, &Node::R0);
  n.p = pack_nodes(a, b, [](const Node& node) { return node.p0; });
  n.L = R * pack_nodes(a, b, [](const Node& node) { return node.P0; });
  n.inverse_inertia_world = congruent(R, n.inverse_inertia);
}

void tell_momenta(Articulate& a, std::size_t b) {
  const NodeBatch& n = a.batches[b];
  const Vec3x4 principal = transposed_times(rotations(a, b, &Node::R0), n.L);
  const auto p = unpack(n.p), P = unpack(principal), spin = unpack(principal * n.inverse_inertia);
  for (std::size_t lane = 0; lane < n.count; lane++) {
    Node& node = a.nodes[batch_size * b + lane];
    node.p0 = p[lane];
    if (!node.turns) continue;
    node.P0 = P[lane];
    node.spin0 = spin[lane];
  }
}

}  // namespace pantin
