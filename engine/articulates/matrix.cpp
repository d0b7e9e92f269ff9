// The matrix S of the rows: blocks Σ over shared nodes of s_i s_j (1/m - r_i^ W r̄_j^).
#include "articulates/midpoint.hpp"
#include "articulates/newton.hpp"

namespace pantin {

namespace {

/// s/m - left^ W (s right)^
Mat3 coupling(const Mat3& W, Vec3 left, Vec3 right, double inverse_mass) {
  Mat3 k = {{cross(W[1] * right[2] - W[2] * right[1], left), cross(W[2] * right[0] - W[0] * right[2], left),
             cross(W[0] * right[1] - W[1] * right[0], left)}};
  for (int i = 0; i < 3; i++) k[i][i] += inverse_mass;
  return k;
}

struct Pair {
  Vec3 left, right;
};

Pair arms(const Row& row, bool at_a, Arms right) {
  const Vec3 end = at_a ? row.ra1 : row.rb1, start = at_a ? row.ra0 : row.rb0;
  return {end, right == Arms::mean ? (end + start) * 0.5 : right == Arms::start ? start : end};
}

void add_meeting(Articulate& a, const Meeting& m, const Node& node, const Mat3& W, Arms right) {
  const Row &i = a.rows[m.row], &j = a.rows[m.column];
  const double sign = m.row_at_a == m.column_at_a ? 1.0 : -1.0, inverse_mass = sign * node.inverse_mass;
  const Pair at_i = arms(i, m.row_at_a, right), at_j = arms(j, m.column_at_a, right);
  const Mat3 k = coupling(W, at_i.left, at_j.right * sign, inverse_mass);
  if (m.row == m.column) {
    a.factor.diagonal[m.block] += i.kind == RowKind::rigid ? k : condition(a, i).M * k;
    return;
  }
  a.factor.lower[m.block] += i.kind == RowKind::rigid ? k : condition(a, i).M * k;
  const Mat3 l = coupling(W, at_j.left, at_i.right * sign, inverse_mass);
  a.factor.upper[m.block] += j.kind == RowKind::rigid ? l : condition(a, j).M * l;
}

Mat3 weight(const Node& n, Arms right, double h) {
  if (!n.turns) return zero33();
  if (right == Arms::mean) return weight(n, h);
  return inverse_inertia(n, right == Arms::start ? n.R0 : n.R1);
}

}  // namespace

Mat3 inverse_inertia(const Node& n, const Mat3& R) {
  const Vec3 i = n.inverse_inertia;
  return times_transposed(Mat3{{R[0] * i[0], R[1] * i[1], R[2] * i[2]}}, R);
}

bool factorise(Articulate& a, Arms right, double epsilon, double scale, double h) {
  a.factor.clear();
  for (std::size_t n = 0; n < a.nodes.size(); n++) {
    const Mat3 W = weight(a.nodes[n], right, h);
    for (std::uint32_t m = a.first_meeting[n]; m < a.first_meeting[n + 1]; m++)
      add_meeting(a, a.meetings[m], a.nodes[n], W, right);
  }
  for (std::size_t k = 0; k < a.rows.size(); k++) {
    Mat3& d = a.factor.diagonal[k];
    if (a.rows[k].kind != RowKind::rigid) d += condition(a, a.rows[k]).C * scale;
    const double compliance = a.rows[k].kind == RowKind::limited ? 0.0 : epsilon * trace(d) / 3.0;
    Vec3& floor = a.factor.floor[k];
    for (int i = 0; i < 3; i++) {
      d[i][i] += compliance;
      floor[i] = std::fabs(d[i][i]) * Factor::redundant;
    }
  }
  return a.factor.factorise();
}

double mobility(const Articulate& a, const Row& row) {
  const auto end = [](const Node& n, Vec3 l) {
    const double turning =
        dot(n.inverse_inertia, vec(l[1] * l[1] + l[2] * l[2], l[2] * l[2] + l[0] * l[0], l[0] * l[0] + l[1] * l[1]));
    return n.inverse_mass + turning / 3.0;
  };
  const double first = end(a.nodes[static_cast<std::size_t>(row.a)], row.la);
  return row.b < 0 ? first : first + end(a.nodes[static_cast<std::size_t>(row.b)], row.lb);
}

}  // namespace pantin
