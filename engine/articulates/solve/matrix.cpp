// The matrix S of the rows: blocks Σ over shared nodes of s_i s_j (1/m - r_i^ W r̄_j^).
#include "articulates/solve/matrix.hpp"
#include "articulates/fetch.hpp"

#include <algorithm>

#include "articulates/solve/couplings.hpp"
#include "articulates/solve/midpoint.hpp"
#include "articulates/solve/node_batches.hpp"
#include "constraints/row_rule.hpp"

namespace pantin {

namespace {

Vec3x4 right_arm(const RowEnds& end, Arms right) {
  return right == Arms::mean ? (end.r0 + end.r1) * 0.5 : right == Arms::start ? end.r0 : end.r1;
}

/// Rotation that a force of the row makes: W (s r̄^), of an angular row W lever.
Mat3x4 rotation_per_force(const Mat3x4& W, const RowEnds& end, Arms right) {
  Mat3x4 turn = times_hat(W, right_arm(end, right) * end.sign);
  for (int k = 0; k < 3; k++) turn[k] += W[k] * end.lever;
  return turn;
}

/// Of the nodes, in each direction: 1/m, but 0 across a plane.
Vec3x4 inverse_masses(const Articulate& a, const NodeBatch& n) {
  const Vec3 d = a.plane.directions();
  return {n.inverse_mass * d[0], n.inverse_mass * d[1], n.inverse_mass * d[2]};
}

/// What the force of a row does to another, by the rotation that it makes: s_i s_j/m - s_i r_i^ turn; of an angular row lever turn.
Mat3x4 response(const RowEnds& of, const RowEnds& by, const Mat3x4& turn, const Vec3x4& inverse_mass) {
  const Vec3x4 left = of.r1 * of.sign, straight = inverse_mass * (of.sign * by.sign);
  Mat3x4 K;
  for (int k = 0; k < 3; k++) K[k] = cross(turn[k], left) + turn[k] * of.lever;
  K[0].x += straight.x;
  K[1].y += straight.y;
  K[2].z += straight.z;
  return K;
}

void add(Mat3& block, bool first, const Row& row, const Articulate& a, const Mat3& k) {
  const Mat3 own = is_rigid(row) ? k : condition(a, row).M * k;
  block = first ? own : block + own;
}

/// The blocks of the rows that meet at the nodes of a batch.
void add_row_blocks(Articulate& a, std::size_t b, const Mat3x4& W, Arms right) {
  const NodeBatch& n = a.batches[b];
  const auto ends = ends_of(a, n).first(ends_with_blocks(a, b));
  const Vec3x4 inverse_mass = inverse_masses(a, n);
  for (std::size_t j = 0; j < ends.size(); j++) {
    const Mat3x4 turn = rotation_per_force(W, ends[j], right);
    for (std::size_t i = 0; i < ends.size(); i++) {
      const auto blocks = unpack(response(ends[i], ends[j], turn, inverse_mass));
      for (std::size_t lane = 0; lane < n.count; lane++) {
        const RowBlock* m = row_block(a, b, lane, i, j);
        if (m == nullptr) continue;
        const Row& row = a.rows[ends[i].row[lane]];
        if (i < j)
          add(a.factor.upper[m->block], m->first_upper, row, a, blocks[lane]);
        else
          add((i == j ? a.factor.diagonal : a.factor.lower)[m->block], m->first_lower, row, a, blocks[lane]);
      }
    }
  }
}

/// The blocks of the rows of a hub with its variables: s u + w x s r1 (of an angular row lever w) in the equations of the rows,
/// u - Σ s/m f = 0 and w - Σ W (s r̄ x f) = 0 in those of the variables.
void add_hub(Articulate& a, const Hub& hub, const Mat3x4& W, Arms right) {
  const std::size_t lane = hub.node % batch_size;
  const NodeBatch& n = a.batches[hub.node / batch_size];
  const bool turns = a.nodes[hub.node].is_body;
  const auto ends = ends_of(a, n);
  const Mat3x4 one = {{{lanes(1), lanes(0), lanes(0)}, {lanes(0), lanes(1), lanes(0)}, {lanes(0), lanes(0), lanes(1)}}};
  for (std::size_t i = 0; i < hub.blocks.size(); i++) {
    const std::uint32_t block = hub.blocks[i];
    const double sign = ends[i].sign[lane];
    const Row& row = a.rows[ends[i].row[lane]];
    add(a.factor.upper[block], true, row, a, identity33() * sign);
    a.factor.lower[block] = diagonal(a.plane.directions()) * (-sign * n.inverse_mass[lane]);
    if (!turns) continue;
    add(a.factor.upper[block + 1], true, row, a, unpack(response(ends[i], ends[i], one, zero3x4()))[lane]);
    a.factor.lower[block + 1] = unpack(rotation_per_force(W, ends[i], right))[lane] * -1.0;
  }
  for (std::uint32_t k : hub.only_on_hubs) a.factor.diagonal[k] = zero33();
  for (std::uint32_t k = hub.variable; k <= hub.variable + (turns ? 1 : 0); k++) {
    a.factor.diagonal[k] = identity33();
    a.factor.whole[k] = vec(1, 1, 1);
  }
}

/// A pivot that is hardly more than the compliance is of a row that says what others do: in Newton's matrix it is left out.
double redundant(const Articulate& a, const System& system) {
  if (a.loop_free) return 1e-16;
  return system.right == Arms::mean ? std::max(4.0 * system.epsilon, 1e-12) : 1e-12;
}

/// Adds the compliance to the diagonal block of a row, and keeps its size.
void finish_diagonal(Articulate& a, std::uint32_t k, const System& system) {
  const Row& row = a.rows[k];
  Mat3& d = a.factor.diagonal[k];
  const double own = trace(d) / 3.0;
  if (!is_rigid(row)) d += condition(a, row).C * system.times_C;
  double compliance = system.epsilon * trace(d) / 3.0;
  if (!a.hubs.empty()) {
    // A hub gives nothing to the diagonal. A row between hubs has the compliance for a pivot: less would lose more digits.
    const double all = mobility(a, row);
    compliance = all * (own < 1e-8 * all ? std::max(system.epsilon, 1e-8) : system.epsilon);
  }
  if (is_soft(row)) compliance = 0.0;
  const double counted = is_soft(row)
                             ? 1e-12 / redundant(a, system)
                             : 1.0;  // so that a soft row is redundant below 1e-12, whatever the limit of others
  for (int i = 0; i < 3; i++) {
    d[i][i] += compliance;
    a.factor.whole[k][i] = std::fabs(d[i][i]) * counted;
  }
}

/// Hands the rows the change of d1 that the nodes' own residuals make.
void move_ends(Articulate& a, const NodeBatch& n) {
  const Vec3x4 turn = rotation(n, n.own_d_cayley);
  for (const RowEnds& end : ends_of(a, n)) scatter_to_rows(a, end, cross(turn, end.r1) * end.sign + turn * end.lever);
}
const Coupling* coupling_of_head(const Articulate& a, std::uint32_t k) {
  for (const Coupling& coupling : a.couplings)
    if (coupling.head == k) return &coupling;
  return nullptr;
}

void set_right_side(Articulate& a, std::uint32_t k, const System& system) {
  const Row& row = a.rows[k];
  Vec3 side = row.residual;
  if (system.right == Arms::mean) {
    side += is_rigid(row) ? gather_for_row(a, k) : condition(a, row).M * gather_for_row(a, k);
    if (is_coupled(row))
      if (const Coupling* coupling = coupling_of_head(a, k))
        side += into_head(a, *coupling, [&](const Row& other) { return gather_for_row(a, condition(a, other).row); });
  }
  a.right_side[k] = side * system.times_residual;
}

Mat3x4 angular_mobility(const Articulate& a, std::size_t b, const System& system) {
  if (!system.may_turn) return congruent(rotations(a, b, &Node::R0), zero3x4());
  if (system.right == Arms::mean) return angular_mobility(a.batches[b], system.h);
  const Mat3x4 R = rotations(a, b, system.right == Arms::start ? &Node::R0 : &Node::R1);
  return congruent(R, a.batches[b].inverse_inertia);
}

const RowEnds& end_of(const Articulate& a, std::size_t node, std::uint32_t row) {
  const NodeBatch& n = a.batches[node / batch_size];
  const auto found = std::find_if(a.ends.begin() + n.first_end, a.ends.begin() + n.last_end,
                                  [&](const RowEnds& end) { return end.row[node % batch_size] == row; });
  return *found;
}

/// What its other rows add to the blocks of a coupling's head, once all their
/// nodes are known.
void add_coupled_blocks(Articulate& a, const Coupling& coupling, const System& system) {
  for (std::uint32_t block : coupling.cleared) a.factor.lower[block] = a.factor.upper[block] = zero33();
  for (const CoupledBlock& m : coupling.blocks) {
    const std::size_t batch = m.node / batch_size;
    const RowEnds &of = end_of(a, m.node, m.row), &by = end_of(a, m.node, m.column);
    const Mat3x4 turn = rotation_per_force(angular_mobility(a, batch, system), by, system.right);
    const Mat3 k = unpack(response(of, by, turn, inverse_masses(a, a.batches[batch])))[m.node % batch_size];
    Mat3& block = m.column == coupling.head ? a.factor.diagonal[m.block]
                  : m.upper                 ? a.factor.upper[m.block]
                                            : a.factor.lower[m.block];
    block += condition(a, a.rows[m.row]).into_head * k;
  }
  for (const HeadBlock& m : coupling.head_blocks) {
    Mat3& block = m.row > coupling.head ? a.factor.lower[m.block] : a.factor.upper[m.block];
    block += condition(a, a.rows[m.row]).from_head * system.times_C;
  }
}

/// Σ r̄ ±f'
Mat3x4 moments(Articulate& a, const NodeBatch& n) {
  Mat3x4 B = {{zero3x4(), zero3x4(), zero3x4()}};
  for (const RowEnds& end : ends_of(a, n)) {
    const Vec3x4 arm = right_arm(end, Arms::mean) * end.sign,
                 f = fetch(end, [&](std::uint32_t k) { return a.rows[k].f; });
    B[0] += arm * f.x;
    B[1] += arm * f.y;
    B[2] += arm * f.z;
  }
  return B;
}

}  // namespace

bool factorise(Articulate& a, const System& system) {
  bool weak = false;
  drop_factor(a, FactorOf::projection);
  const double least = redundant(a, system);
  Tile done;
  clear_hubs(a);
  auto hub = a.hubs.begin();
  const std::uint32_t* to = a.factor.target.data();
  for (const Tile& tile : a.tiles) {
    for (; done.batches < tile.batches; done.batches++) {
      Fetch::some();
      NodeBatch& n = a.batches[done.batches];
      if (system.right == Arms::mean) {
        a.plane.flat() ? invert_flat_jacobian(n, moments(a, n), system.h, a.plane.normal)
                       : invert_jacobian(n, moments(a, n), system.h);
        move_ends(a, n);
      }
      const Mat3x4 W = angular_mobility(a, done.batches, system);
      add_row_blocks(a, done.batches, W, system.right);
      for (; hub != a.hubs.end() && hub->node / batch_size == done.batches; ++hub) add_hub(a, *hub, W, system.right);
    }
    for (; done.rows < tile.rows; done.rows++) {
      if (is_coupled(a.rows[done.rows]))
        if (const Coupling* coupling = coupling_of_head(a, done.rows)) add_coupled_blocks(a, *coupling, system);
      finish_diagonal(a, done.rows, system);
      set_right_side(a, done.rows, system);
    }
    for (; done.columns < tile.columns; done.columns++) {
      weak = a.factor.eliminate(done.columns, to, least) || weak;
      a.factor.substitute_forward(done.columns, a.right_side.data());
    }
  }
  return weak;
}

void clear_hubs(Articulate& a) {
  std::fill(a.right_side.begin() + static_cast<std::ptrdiff_t>(a.rows.size()), a.right_side.end(), zero3());
}

void solve_hubs(Articulate& a) {
  for (std::uint32_t k = a.factor.rows; k-- > a.rows.size();) a.factor.substitute_back(k, a.right_side.data());
}

void reuse_factor(Articulate& a, const System& system) {
  Tile done;
  clear_hubs(a);
  for (const Tile& tile : a.tiles) {
    for (; done.batches < tile.batches; done.batches++) {
      Fetch::some();
      move_ends(a, a.batches[done.batches]);
    }
    for (; done.rows < tile.rows; done.rows++) set_right_side(a, done.rows, system);
    for (; done.columns < tile.columns; done.columns++) a.factor.substitute_forward(done.columns, a.right_side.data());
  }
}

double mobility(const Articulate& a, const Row& row) {
  if (row.lever > 0.0) {
    const auto turning = [&](std::int32_t node, Vec3 axis) {
      const Vec3 inverse = a.nodes[static_cast<std::size_t>(node)].inverse_inertia;
      return row.rule->about_axis ? dot(inverse, axis * axis) : trace(diagonal(inverse)) / 3.0;
    };
    const double first = turning(row.a, row.la);
    return (row.b < 0 ? first : first + turning(row.b, row.lb)) * row.lever * row.lever;
  }
  const auto end = [](const Node& n, Vec3 l) {
    const double turning =
        dot(n.inverse_inertia, vec(l[1] * l[1] + l[2] * l[2], l[2] * l[2] + l[0] * l[0], l[0] * l[0] + l[1] * l[1]));
    return n.inverse_mass + turning / 3.0;
  };
  const double first = end(a.nodes[static_cast<std::size_t>(row.a)], row.la);
  return row.b < 0 ? first : first + end(a.nodes[static_cast<std::size_t>(row.b)], row.lb);
}

}  // namespace pantin
