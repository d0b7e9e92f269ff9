// Rates of a tree: its hinges' forces by elimination from the ends to the middle, and back.
#include "trees/tree.hpp"

#include <algorithm>
#include <array>
#include <cstring>

namespace pantin {

namespace {

using Symmetric4 = TreeWorkspace::Symmetric4;
using Two = TreeWorkspace::Two;
using Outside = TreeWorkspace::Outside;
using Joint = TreeWorkspace::Joint;

/// K = 1/m - r^ W r^
[[gnu::always_inline]] inline Symmetric4 point_mobility(const Symmetric4& W, const Vec3x4& r, Lanes inverse_mass) {
  const Vec3x4 a0 = cross({W.xx, W.xy, W.xz}, r), a1 = cross({W.xy, W.yy, W.yz}, r), a2 = cross({W.xz, W.yz, W.zz}, r);
  return {inverse_mass - (r.y * a2.x - r.z * a1.x), r.z * a1.y - r.y * a2.y, r.z * a1.z - r.y * a2.z,
          inverse_mass - (r.z * a0.y - r.x * a2.y), r.x * a2.z - r.z * a0.z, inverse_mass - (r.x * a1.z - r.y * a0.z)};
}

/// K = 1/m - r^ W s^, by rows
[[gnu::always_inline]] inline void cross_mobility(const Symmetric4& W, const Vec3x4& r, const Vec3x4& s,
                                                  Lanes inverse_mass, Lanes* k) {
  const Vec3x4 a0 = cross({W.xx, W.xy, W.xz}, s), a1 = cross({W.xy, W.yy, W.yz}, s), a2 = cross({W.xz, W.yz, W.zz}, s);
  k[0] = inverse_mass - (r.y * a2.x - r.z * a1.x);
  k[1] = r.z * a1.y - r.y * a2.y;
  k[2] = r.z * a1.z - r.y * a2.z;
  k[3] = r.x * a2.x - r.z * a0.x;
  k[4] = inverse_mass - (r.z * a0.y - r.x * a2.y);
  k[5] = r.x * a2.z - r.z * a0.z;
  k[6] = r.y * a0.x - r.x * a1.x;
  k[7] = r.y * a0.y - r.x * a1.y;
  k[8] = inverse_mass - (r.x * a1.z - r.y * a0.z);
}

[[gnu::always_inline]] inline Vec3x4 times(const Symmetric4& s, const Vec3x4& v) {
  return {s.xx * v.x + s.xy * v.y + s.xz * v.z, s.xy * v.x + s.yy * v.y + s.yz * v.z,
          s.xz * v.x + s.yz * v.y + s.zz * v.z};
}

/// R of orientations that are not of unit length.
[[gnu::always_inline]] inline Mat3x4 rotation(const Quatx4& q) {
  const Lanes s = 2.0 / (q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  const Lanes x = q.x * s, y = q.y * s, z = q.z * s;
  const Lanes xx = q.x * x, yy = q.y * y, zz = q.z * z, xy = q.x * y, xz = q.x * z, yz = q.y * z, wx = q.w * x,
              wy = q.w * y, wz = q.w * z;
  return {
      {{1.0 - (yy + zz), xy + wz, xz - wy}, {xy - wz, 1.0 - (xx + zz), yz + wx}, {xz + wy, yz - wx, 1.0 - (xx + yy)}}};
}

/// What four nodes do without hinges, and how their hinges' points yield.
void find_free_accelerations(const Tree::Batch& c, const Vec3x4& gravity, const Rotation4& y, Rotation4& rate,
                             TreeWorkspace::Batch& n) {
  const Mat3x4 R = rotation(y.q);
  const Vec3x4 &w = y.w, J = c.inverse_inertia;
  const Vec3x4 u = R[0] * J.x, v = R[1] * J.y, t = R[2] * J.z;
  const Symmetric4 W = {u.x * R[0].x + v.x * R[1].x + t.x * R[2].x, u.x * R[0].y + v.x * R[1].y + t.x * R[2].y,
                        u.x * R[0].z + v.x * R[1].z + t.x * R[2].z, u.y * R[0].y + v.y * R[1].y + t.y * R[2].y,
                        u.y * R[0].z + v.y * R[1].z + t.y * R[2].z, u.z * R[0].z + v.z * R[1].z + t.z * R[2].z};
  const Vec3x4 spin = transposed_times(R, w);
  const Vec3x4 alpha = u * (c.inertia_differences.x * spin.y * spin.z) +
                       v * (c.inertia_differences.y * spin.z * spin.x) +
                       t * (c.inertia_differences.z * spin.x * spin.y);
  const Vec3x4 r_in = R * c.in, r_out = R * c.out;
  // α x r + ω x (ω x r) as a matrix
  const Lanes xx = w.x * w.x, yy = w.y * w.y, zz = w.z * w.z, xy = w.x * w.y, yz = w.y * w.z, zx = w.z * w.x;
  const Mat3x4 turning = {{{-(yy + zz), xy + alpha.z, zx - alpha.y},
                           {xy - alpha.z, -(zz + xx), yz + alpha.x},
                           {zx + alpha.y, yz - alpha.x, -(xx + yy)}}};
  n.a_in = gravity + turning * r_in;
  n.a_out = gravity + turning * r_out;
  n.R = R;
  n.r_in = r_in;
  n.r_out = r_out;
  n.alpha = alpha;
  n.W = W;
  n.K_in = point_mobility(W, r_in, c.inverse_mass);
  n.K_out = point_mobility(W, r_out, c.inverse_mass);
  cross_mobility(W, r_out, r_in, c.inverse_mass, n.K_cross);
  const Quatx4& q = y.q;
  rate.q = {(w.x * q.x + w.y * q.y + w.z * q.z) * -0.5, (w.x * q.w + w.y * q.z - w.z * q.y) * 0.5,
            (w.y * q.w + w.z * q.x - w.x * q.z) * 0.5, (w.z * q.w + w.x * q.y - w.y * q.x) * 0.5};
}

/// A pair's half of four lanes.
Two half(const Lanes& of, std::size_t pair) {
  Two two;
  std::memcpy(&two, reinterpret_cast<const char*>(&of) + sizeof(Two) * (pair % 2), sizeof(Two));
  return two;
}
void set_half(Lanes& of, std::size_t pair, Two two) {
  std::memcpy(reinterpret_cast<char*>(&of) + sizeof(Two) * (pair % 2), &two, sizeof(Two));
}

using Vector2 = TreeWorkspace::Vector2;
Vector2 operator+(const Vector2& a, const Vector2& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vector2 operator*(const Vector2& a, Two s) { return {a.x * s, a.y * s, a.z * s}; }
Vector2 half(const Vec3x4& v, std::size_t pair) { return {half(v.x, pair), half(v.y, pair), half(v.z, pair)}; }
Two inner(const Vector2& a, const Vector2& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
/// Symmetric: xx, xy, xz, yy, yz, zz.
Vector2 times(const Two* s, const Vector2& v) {
  return {s[0] * v.x + s[1] * v.y + s[2] * v.z, s[1] * v.x + s[3] * v.y + s[4] * v.z,
          s[2] * v.x + s[4] * v.y + s[5] * v.z};
}

/// What is outside of the outer hinges of a pair of links.
Outside outside_of(const TreeWorkspace& workspace, const Tree::Pair& pair) {
  const Outside &first = workspace.outside[pair.outer[0] / 2], &second = workspace.outside[pair.outer[1] / 2];
  if (pair.outer_is_pair) return first;
  const std::size_t a = pair.outer[0] % 2, b = pair.outer[1] % 2;
  Outside o;
  for (std::size_t k = 0; k < 6; k++) o.C[k] = Two{first.C[k][a], second.C[k][b]};
  for (std::size_t k = 0; k < 3; k++) o.beta[k] = Two{first.beta[k][a], second.beta[k][b]};
  return o;
}

/// Eliminates the outer hinges of a pair of links, and tells what is outside of their inner ones.
void eliminate_links(const TreeWorkspace::Batch& n, std::size_t p, const Outside& outer, Joint& j, Outside& o) {
  const Two xx = half(n.K_out.xx, p) + outer.C[0], xy = half(n.K_out.xy, p) + outer.C[1],
            xz = half(n.K_out.xz, p) + outer.C[2], yy = half(n.K_out.yy, p) + outer.C[3],
            yz = half(n.K_out.yz, p) + outer.C[4], zz = half(n.K_out.zz, p) + outer.C[5];
  // The inverse is that of cofactors times d, which comes late: what waits for it is as little as can be.
  const Two cofactors[6] = {yy * zz - yz * yz, xz * yz - xy * zz, xy * yz - xz * yy,
                            xx * zz - xz * xz, xy * xz - xx * yz, xx * yy - xy * xy};
  const Two d = 1.0 / (xx * cofactors[0] + xy * cofactors[1] + xz * cofactors[2]);
  const Vector2 a = half(n.a_out, p), rho = {a.x - outer.beta[0], a.y - outer.beta[1], a.z - outer.beta[2]};
  const Lanes* B = n.K_cross;
  const Vector2 b0{half(B[0], p), half(B[3], p), half(B[6], p)}, b1{half(B[1], p), half(B[4], p), half(B[7], p)},
      b2{half(B[2], p), half(B[5], p), half(B[8], p)};
  const Vector2 c0 = times(cofactors, b0), c1 = times(cofactors, b1), c2 = times(cofactors, b2),
                s = times(cofactors, rho);
  o.C[0] = half(n.K_in.xx, p) - inner(b0, c0) * d;
  o.C[1] = half(n.K_in.xy, p) - inner(b0, c1) * d;
  o.C[2] = half(n.K_in.xz, p) - inner(b0, c2) * d;
  o.C[3] = half(n.K_in.yy, p) - inner(b1, c1) * d;
  o.C[4] = half(n.K_in.yz, p) - inner(b1, c2) * d;
  o.C[5] = half(n.K_in.zz, p) - inner(b2, c2) * d;
  o.beta[0] = half(n.a_in.x, p) - inner(b0, s) * d;
  o.beta[1] = half(n.a_in.y, p) - inner(b1, s) * d;
  o.beta[2] = half(n.a_in.z, p) - inner(b2, s) * d;
  j = {c0 * d, c1 * d, c2 * d, s * d};
}

void eliminate_leaves(const TreeWorkspace::Batch& n, std::size_t p, Outside& o) {
  const Symmetric4& K = n.K_in;
  const Lanes* all[6] = {&K.xx, &K.xy, &K.xz, &K.yy, &K.yz, &K.zz};
  for (std::size_t k = 0; k < 6; k++) o.C[k] = half(*all[k], p);
  const Vector2 a = half(n.a_in, p);
  o.beta[0] = a.x;
  o.beta[1] = a.y;
  o.beta[2] = a.z;
}

Mat3 matrix(const Two* C, std::size_t lane) {
  return {{vec(C[0][lane], C[1][lane], C[2][lane]), vec(C[1][lane], C[3][lane], C[4][lane]),
           vec(C[2][lane], C[4][lane], C[5][lane])}};
}
Vec3 vector(const Two* v, std::size_t lane) { return vec(v[0][lane], v[1][lane], v[2][lane]); }
Mat3 at(const Symmetric4& s, std::size_t lane) {
  return {{vec(s.xx[lane], s.xy[lane], s.xz[lane]), vec(s.xy[lane], s.yy[lane], s.yz[lane]),
           vec(s.xz[lane], s.yz[lane], s.zz[lane])}};
}
Mat3 at(const Mat3x4& m, std::size_t lane) { return {{lane_of(m[0], lane), lane_of(m[1], lane), lane_of(m[2], lane)}}; }
/// a b^
Mat3 times_hat(const Mat3& a, Vec3 b) {
  return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}
/// a^ b
Mat3 hat_times(Vec3 a, const Mat3& b) { return {{cross(a, b[0]), cross(a, b[1]), cross(a, b[2])}}; }

/// By how much a force and a torque at the centre of a node move it and turn it, and what it does without any.
struct Mobility {
  Mat3 moves, couples, turns;  // a = moves f + couples τ, α = couples' f + turns τ
  Vec3 acceleration, alpha;    // [m/s²], [rad/s²]
};

/// A branch with all that hangs on it.
void eliminate_branch(const Tree& tree, TreeWorkspace& workspace, const Tree::Branch& branch, Vec3 gravity, Vec3 w) {
  const TreeWorkspace::Batch& n = workspace.batches[branch.slot / batch_size];
  const std::size_t lane = branch.slot % batch_size;
  const Mat3 R = at(n.R, lane);
  Mobility m{identity33() * tree.batches[branch.slot / batch_size].inverse_mass[lane], zero33(), at(n.W, lane), gravity,
             lane_of(n.alpha, lane)};
  for (std::uint32_t k = branch.first; k < branch.last; k++) {
    const Outside& o = workspace.outside[tree.arms[k].outer / 2];
    const std::size_t side = tree.arms[k].outer % 2;
    TreeWorkspace::Arm& arm = workspace.arms[k];
    const Vec3 r = R * tree.arms[k].l;
    arm.r = r;
    arm.U_force = m.moves + times_hat(m.couples, r);
    arm.U_torque = transpose(m.couples) + times_hat(m.turns, r);
    arm.D_inverse = inverse(arm.U_force - hat_times(r, arm.U_torque) + matrix(o.C, side));
    arm.rho = m.acceleration + cross(m.alpha, r) + w * dot(w, r) - r * norm2(w) - vector(o.beta, side);
    const Mat3 force = arm.U_force * arm.D_inverse, torque = arm.U_torque * arm.D_inverse;
    m.acceleration -= force * arm.rho;
    m.alpha -= torque * arm.rho;
    m.moves -= times_transposed(force, arm.U_force);
    m.couples -= times_transposed(force, arm.U_torque);
    m.turns -= times_transposed(torque, arm.U_torque);
  }
  const Vec3 r = lane_of(n.r_in, lane);
  const Mat3 K = m.moves + times_hat(m.couples, r) - hat_times(r, transpose(m.couples) + times_hat(m.turns, r));
  const Vec3 a = m.acceleration + cross(m.alpha, r) + w * dot(w, r) - r * norm2(w);
  Outside& o = workspace.outside[branch.slot / 2];
  const std::size_t side = branch.slot % 2;
  const double C[6] = {K[0][0], K[1][0], K[2][0], K[1][1], K[2][1], K[2][2]};
  for (std::size_t k = 0; k < 6; k++) o.C[k][side] = C[k];
  for (int k = 0; k < 3; k++) o.beta[k][side] = a[k];
}

/// Tells a node the force at its inner hinge.
void set_inner_force(TreeWorkspace& workspace, const Tree& tree, std::uint32_t slot, Vec3 f) {
  if (slot != tree.world_slot) set_lane(workspace.batches[slot / batch_size].f_in, slot % batch_size, f);
}

/// Forces at the outer hinges of a branch, once that at its inner one is known.
void substitute_branch(const Tree& tree, TreeWorkspace& workspace, const Tree::Branch& branch) {
  TreeWorkspace::Batch& n = workspace.batches[branch.slot / batch_size];
  const std::size_t lane = branch.slot % batch_size;
  const Vec3 f_in = lane_of(n.f_in, lane);
  Vec3 force = f_in, torque = cross(lane_of(n.r_in, lane), f_in), outer = zero3();
  for (std::uint32_t k = branch.last; k-- > branch.first;) {
    TreeWorkspace::Arm& arm = workspace.arms[k];
    arm.f = arm.D_inverse * (arm.rho + transposed_times(arm.U_force, force) + transposed_times(arm.U_torque, torque));
    const Vec3 turning = cross(arm.r, arm.f);
    force -= arm.f;
    torque -= turning;
    outer -= turning;
    set_inner_force(workspace, tree, tree.arms[k].outer, arm.f);
  }
  set_lane(n.torque, lane, outer);
}

void eliminate(const Tree& tree, TreeWorkspace& workspace, Vec3 gravity, const Rotation4* state) {
  for (std::size_t p = 0; p < tree.pairs.size(); p++) {
    const Tree::Pair& pair = tree.pairs[p];
    const TreeWorkspace::Batch& n = workspace.batches[p / 2];
    if (pair.kind == Tree::Kind::link) {
      eliminate_links(n, p, outside_of(workspace, pair), workspace.joints[p], workspace.outside[p]);
    } else if (pair.kind == Tree::Kind::leaf) {
      eliminate_leaves(n, p, workspace.outside[p]);
    } else {
      for (const std::uint32_t branch : pair.outer)
        if (branch != Tree::none)
          eliminate_branch(tree, workspace, tree.branches[branch], gravity,
                           lane_of(state[p / 2].w, tree.branches[branch].slot % batch_size));
    }
  }
}

/// Forces at the outer hinges of a pair of links.
void substitute_links(const Tree& tree, TreeWorkspace& workspace, std::size_t p) {
  const Tree::Pair& pair = tree.pairs[p];
  TreeWorkspace::Batch& n = workspace.batches[p / 2];
  const Joint& j = workspace.joints[p];
  const Vector2 f = half(n.f_in, p);
  const Vector2 out = j.alone + j.by_x * f.x + j.by_y * f.y + j.by_z * f.z;
  const auto put = [&](Vec3x4& v, std::size_t q) {
    set_half(v.x, q, out.x);
    set_half(v.y, q, out.y);
    set_half(v.z, q, out.z);
  };
  put(n.f_out, p);
  if (pair.outer_is_pair && pair.outer[0] != tree.world_slot)
    return put(workspace.batches[pair.outer[0] / batch_size].f_in, pair.outer[0] / 2);
  for (std::size_t k = 0; k < 2; k++)
    set_inner_force(workspace, tree, pair.outer[k], vec(out.x[k], out.y[k], out.z[k]));
}

/// The force at the hinge in the middle, on the first of its nodes; then outwards.
void substitute(const Tree& tree, TreeWorkspace& workspace) {
  const std::uint32_t first = tree.middle[0], second = tree.middle[1];
  const Outside &p = workspace.outside[first / 2], &q = workspace.outside[second / 2];
  const Vec3 f = inverse(matrix(p.C, first % 2) + matrix(q.C, second % 2)) *
                 (vector(q.beta, second % 2) - vector(p.beta, first % 2));
  set_inner_force(workspace, tree, first, f);
  set_inner_force(workspace, tree, second, f * -1.0);
  for (std::size_t i = tree.pairs.size(); i-- > 0;) {
    const Tree::Pair& pair = tree.pairs[i];
    if (pair.kind == Tree::Kind::link) substitute_links(tree, workspace, i);
    if (pair.kind != Tree::Kind::branch) continue;
    for (const std::uint32_t branch : pair.outer)
      if (branch != Tree::none) substitute_branch(tree, workspace, tree.branches[branch]);
  }
}

}  // namespace

void make_room(const Tree& tree, TreeWorkspace& workspace) {
  const std::size_t count = tree.batches.size();
  workspace.batches.resize(count);
  for (TreeWorkspace::Batch& b : workspace.batches) b.f_in = b.f_out = b.torque = zero3x4();
  workspace.outside.assign(tree.pairs.size() + 1, Outside{});
  workspace.joints.resize(tree.pairs.size());
  workspace.arms.resize(tree.arms.size());
  workspace.stage_state.resize(count);
  workspace.end.resize(count);
}

void find_rates(const Tree& tree, TreeWorkspace& workspace, Vec3 gravity, const Rotation4* state, Rotation4* rates) {
  const Vec3x4 g = pack(gravity, gravity, gravity, gravity);
  const std::size_t count = tree.batches.size();
  for (std::size_t b = 0; b < count; b++)
    find_free_accelerations(tree.batches[b], g, state[b], rates[b], workspace.batches[b]);
  eliminate(tree, workspace, gravity, state);
  substitute(tree, workspace);
  for (std::size_t b = 0; b < count; b++) {
    const TreeWorkspace::Batch& n = workspace.batches[b];
    rates[b].w = n.alpha + times(n.W, cross(n.r_in, n.f_in) - cross(n.r_out, n.f_out) + n.torque);
  }
}

double largest_own_rate2(const Tree& tree, const TreeWorkspace& workspace) {
  Lanes most = lanes(0.0);
  for (std::size_t b = 0; b < tree.batches.size(); b++) {
    const TreeWorkspace::Batch& n = workspace.batches[b];
    most = larger(most, square_root(norm2(n.f_in)) * tree.batches[b].turn_per_force_in +
                            square_root(norm2(n.f_out)) * tree.batches[b].turn_per_force_out);
  }
  double rate2 = largest_lane(most);
  for (const Tree::Branch& branch : tree.branches) {
    const std::size_t b = branch.slot / batch_size, lane = branch.slot % batch_size;
    double sum = norm(lane_of(workspace.batches[b].f_in, lane)) * tree.batches[b].turn_per_force_in[lane];
    for (std::uint32_t k = branch.first; k < branch.last; k++)
      sum += norm(workspace.arms[k].f) * tree.arms[k].turn_per_force;
    rate2 = std::max(rate2, sum);
  }
  return rate2;
}

}  // namespace pantin
