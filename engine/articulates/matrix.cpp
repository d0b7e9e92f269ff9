// The matrix S of the rows: blocks Σ over shared nodes of s_i s_j (1/m - r_i^ W r̄_j^).
#include "articulates/midpoint.hpp"
#include "articulates/newton.hpp"
#include "articulates/strand.hpp"

namespace pantin {

namespace {

/// s/m - left^ W (s right)^
Mat3 coupling(const Mat3& W, Vec3 left, Vec3 right, double inverse_mass) {
  Mat3 k = {{cross(W[1] * right[2] - W[2] * right[1], left), cross(W[2] * right[0] - W[0] * right[2], left),
             cross(W[0] * right[1] - W[1] * right[0], left)}};
  for (int i = 0; i < 3; i++) k[i][i] += inverse_mass;
  return k;
}

/// The same where one of the rows, or both, is a couple: lever W (s right)^, -left^ W s lever, or both.
Mat3 coupling_of_couples(const Mat3& W, const Row& i, Vec3 left, const Row& j, Vec3 right, double sign) {
  Mat3 k = j.lever > 0.0 ? W * (j.lever * sign) : W * hat(right * sign);
  if (i.lever > 0.0) return k * i.lever;
  for (int n = 0; n < 3; n++) k[n] = cross(k[n], left);
  return k;
}

struct Pair {
  Vec3 left, right;
};

Pair arms(const Row& row, bool at_a, Arms right) {
  const Vec3 end = at_a ? row.ra1 : row.rb1, start = at_a ? row.ra0 : row.rb0;
  return {end, right == Arms::mean ? (end + start) * 0.5 : right == Arms::start ? start : end};
}

void add(Mat3& block, const Meeting& m, const Row& row, const Articulate& a, const Mat3& k) {
  const Mat3 part = row.kind == RowKind::rigid ? k : condition(a, row).M * k;
  block = m.first ? part : block + part;
}

void add_meeting(Articulate& a, const Meeting& m, const Node& node, const Mat3& W, Arms right) {
  const Row &i = a.rows[m.row], &j = a.rows[m.column];
  const double sign = m.row_at_a == m.column_at_a ? 1.0 : -1.0, inverse_mass = sign * node.inverse_mass;
  const Pair at_i = arms(i, m.row_at_a, right), at_j = arms(j, m.column_at_a, right);
  if (i.lever > 0.0 || j.lever > 0.0) {
    const Mat3 k = coupling_of_couples(W, i, at_i.left, j, at_j.right, sign);
    if (m.row == m.column) return add(a.factor.diagonal[m.block], m, i, a, k);
    add(a.factor.lower[m.block], m, i, a, k);
    return add(a.factor.upper[m.block], m, j, a, coupling_of_couples(W, j, at_j.left, i, at_i.right, sign));
  }
  const Mat3 k = coupling(W, at_i.left, at_j.right * sign, inverse_mass);
  if (m.row == m.column) return add(a.factor.diagonal[m.block], m, i, a, k);
  add(a.factor.lower[m.block], m, i, a, k);
  add(a.factor.upper[m.block], m, j, a, coupling(W, at_j.left, at_i.right * sign, inverse_mass));
}

/// Adds the compliance to the diagonal block of a row, and says which pivots will count as redundant.
void finish_diagonal(Articulate& a, std::uint32_t k, const System& system) {
  const Row& row = a.rows[k];
  Mat3& d = a.factor.diagonal[k];
  if (row.kind != RowKind::rigid) d += condition(a, row).C * system.scale;
  const double compliance = is_soft(row) ? 0.0 : system.epsilon * trace(d) / 3.0;
  for (int i = 0; i < 3; i++) {
    d[i][i] += compliance;
    a.factor.floor[k][i] = std::fabs(d[i][i]) * Factor::redundant;
  }
}

/// Change of d1 that the nodes' own residuals make.
Vec3 moved(const Articulate& a, const Row& row) {
  const Vec3 turned_a = a.nodes[static_cast<std::size_t>(row.a)].phi,
             turned_b = row.b >= 0 ? a.nodes[static_cast<std::size_t>(row.b)].phi : zero3();
  if (row.lever > 0.0) return (turned_a - turned_b) * row.lever;
  const Vec3 first = cross(turned_a, row.ra1);
  return row.b >= 0 ? first - cross(turned_b, row.rb1) : first;
}

const Strand* strand_of_head(const Articulate& a, std::uint32_t k) {
  for (const Strand& strand : a.strands)
    if (strand.head == k) return &strand;
  return nullptr;
}

void set_right_side(Articulate& a, std::uint32_t k, const System& system) {
  const Row& row = a.rows[k];
  Vec3 side = row.residual;
  if (system.right == Arms::mean) {
    side += row.kind == RowKind::rigid ? moved(a, row) : condition(a, row).M * moved(a, row);
    if (row.kind == RowKind::strand)
      if (const Strand* strand = strand_of_head(a, k))
        side += into_head(a, *strand, [&](const Row& segment) { return moved(a, segment); });
  }
  a.right_side[k] = side * system.right_scale;
}

Mat3 weight(const Node& n, Arms right, double h) {
  if (!n.turns) return zero33();
  if (right == Arms::mean) return weight(n, h);
  return inverse_inertia(n, right == Arms::start ? n.R0 : n.R1);
}

/// The parts of a string's head that its other segments make, once all their
/// nodes are known.
void add_strand(Articulate& a, const Strand& strand, const System& system) {
  for (std::uint32_t block : strand.cleared) a.factor.lower[block] = a.factor.upper[block] = zero33();
  for (const StrandMeeting& m : strand.meetings) {
    const Row &i = a.rows[m.segment], &j = a.rows[m.column];
    const Node& node = a.nodes[m.node];
    const Mat3 W = weight(node, system.right, system.h);
    const double sign = m.segment_at_a == m.column_at_a ? 1.0 : -1.0;
    const Pair at_i = arms(i, m.segment_at_a, system.right), at_j = arms(j, m.column_at_a, system.right);
    const Mat3 k = j.lever > 0.0 ? coupling_of_couples(W, i, at_i.left, j, at_j.right, sign)
                                 : coupling(W, at_i.left, at_j.right * sign, sign * node.inverse_mass);
    Mat3& block = m.column == strand.head ? a.factor.diagonal[m.block]
                  : m.upper               ? a.factor.upper[m.block]
                                          : a.factor.lower[m.block];
    block += condition(a, i).into_head * k;
  }
  for (const StrandLink& link : strand.links) {
    Mat3& block = link.segment > strand.head ? a.factor.lower[link.block] : a.factor.upper[link.block];
    block += condition(a, a.rows[link.segment]).from_head * system.scale;
  }
}

}  // namespace

Mat3 inverse_inertia(const Node& n, const Mat3& R) {
  const Vec3 i = n.inverse_inertia;
  return times_transposed(Mat3{{R[0] * i[0], R[1] * i[1], R[2] * i[2]}}, R);
}

bool factorise(Articulate& a, const System& system) {
  bool weak = false;
  Wave done;
  const std::uint32_t* to = a.factor.target.data();
  for (const Wave& wave : a.waves) {
    for (; done.nodes < wave.nodes; done.nodes++) {
      Node& n = a.nodes[done.nodes];
      if (system.right == Arms::mean && n.turns) {
        invert_jacobian(n, system.h);
        n.da = n.J_inverse * n.E * -1.0;
        n.phi = rotation(n, n.da);
      }
      const Mat3 W = weight(n, system.right, system.h);
      for (std::uint32_t m = a.first_meeting[done.nodes]; m < a.first_meeting[done.nodes + 1]; m++)
        add_meeting(a, a.meetings[m], n, W, system.right);
    }
    for (; done.rows < wave.rows; done.rows++) {
      if (a.rows[done.rows].kind == RowKind::strand)
        if (const Strand* strand = strand_of_head(a, done.rows)) add_strand(a, *strand, system);
      finish_diagonal(a, done.rows, system);
      set_right_side(a, done.rows, system);
    }
    for (; done.columns < wave.columns; done.columns++) {
      weak = a.factor.eliminate(done.columns, to) || weak;
      a.factor.substitute_forward(done.columns, a.right_side.data());
    }
  }
  return weak;
}

void reuse_factor(Articulate& a, const System& system) {
  Wave done;
  for (const Wave& wave : a.waves) {
    for (; done.nodes < wave.nodes; done.nodes++) {
      Node& n = a.nodes[done.nodes];
      if (n.turns) n.phi = rotation(n, n.da);
    }
    for (; done.rows < wave.rows; done.rows++) set_right_side(a, done.rows, system);
    for (; done.columns < wave.columns; done.columns++) a.factor.substitute_forward(done.columns, a.right_side.data());
  }
}

double mobility(const Articulate& a, const Row& row) {
  if (row.lever > 0.0) {
    double turning = trace(diagonal(a.nodes[static_cast<std::size_t>(row.a)].inverse_inertia));
    if (row.b >= 0) turning += trace(diagonal(a.nodes[static_cast<std::size_t>(row.b)].inverse_inertia));
    return turning * row.lever * row.lever / 3.0;
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
