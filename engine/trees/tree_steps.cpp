#include "trees/tree_steps.hpp"

#include <algorithm>
#include <limits>
#include <type_traits>
#include <utility>

#include "trees/dop853.hpp"

namespace pantin {

namespace {

constexpr std::size_t numbers = sizeof(Rotation4) / sizeof(Lanes);

Lanes* flat(TreeState& s) { return reinterpret_cast<Lanes*>(s.data()); }
const Lanes* flat(const TreeState& s) { return reinterpret_cast<const Lanes*>(s.data()); }

/// to_i = from_i + h Σ_j table[r][j] k_ji; nothing is spent on coefficients that are 0.
template <const auto& table, std::size_t r, std::size_t... j>
void combine(const Lanes* from, const Lanes* k, double h, std::size_t n, Lanes* to, std::index_sequence<j...>) {
  const double c[] = {h * table[r][j]...};
  for (std::size_t i = 0; i < n; i++) {
    Lanes sum = from[i];
    const auto add = [&]<std::size_t s>(std::integral_constant<std::size_t, s>) {
      if constexpr (table[r][s] != 0.0) sum += k[s * n + i] * c[s];
    };
    (add(std::integral_constant<std::size_t, j>{}), ...);
    to[i] = sum;
  }
}
template <const auto& table, std::size_t r>
void combine(const Lanes* from, const Lanes* k, double h, std::size_t n, Lanes* to) {
  combine<table, r>(from, k, h, n, to, std::make_index_sequence<dop853::all_stages>{});
}

/// A step being tried, or the polynomial of one that was taken.
struct Stages {
  const Tree& tree;
  TreeWorkspace& workspace;
  Vec3 gravity;
  std::size_t n;

  Lanes* k(std::size_t s) const { return workspace.k.data() + s * n; }
  void evaluate(const TreeState& at, std::size_t s) const {
    find_rates(tree, workspace, gravity, at.data(), reinterpret_cast<Rotation4*>(k(s)));
  }
  template <std::size_t s>
  void stage(const TreeState& start, double h) const {
    combine<dop853::a, s>(flat(start), k(0), h, n, flat(workspace.stage_state));
    evaluate(workspace.stage_state, s);
  }
  template <std::size_t... s>
  void stages(const TreeState& start, double h, std::index_sequence<s...>) const {
    (stage<s + 1>(start, h), ...);
  }
};

/// Small turns of a node [rad], or displacements [m], in world axes, four in the lanes: as each of the two estimates of the
/// error makes them at once, and as its wrong spins will in as long. Lanes: order 5 by turns, order 5 by spins times h, order 3
/// by both.
using Errors = Vec3x4;

/// Rows to columns.
std::array<Lanes, batch_size> transposed(Lanes a, Lanes b, Lanes c, Lanes d) {
  const Lanes ab = __builtin_shufflevector(a, b, 0, 4, 2, 6), cd = __builtin_shufflevector(c, d, 0, 4, 2, 6);
  const Lanes ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7), cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  return {__builtin_shufflevector(ab, cd, 0, 1, 4, 5), __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5),
          __builtin_shufflevector(ab, cd, 2, 3, 6, 7), __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7)};
}

/// What makes a turn of a wrong orientation.
Vec3x4 turn_of(const Quatx4& e, const Quatx4& q) {
  return {(e.x * q.w - e.w * q.x + e.z * q.y - e.y * q.z) * 2.0, (e.y * q.w - e.w * q.y + e.x * q.z - e.z * q.x) * 2.0,
          (e.z * q.w - e.w * q.z + e.y * q.x - e.x * q.y) * 2.0};
}

/// How wrong the rotations at the end of a step are.
void find_rotation_errors(const Stages& s, const TreeState& end, double h) {
  TreeWorkspace& w = s.workspace;
  w.rotation_errors.resize(batch_size * end.size());
  AlignedVector<Rotation4>& other = w.stage_state;
  w.error_estimate.resize(end.size());
  std::fill_n(flat(other), s.n, lanes(0.0));
  combine<dop853::error, 0>(flat(other), s.k(0), h, s.n, flat(w.error_estimate));
  combine<dop853::error, 1>(flat(other), s.k(0), h, s.n, flat(other));
  for (std::size_t b = 0; b < end.size(); b++) {
    const Vec3x4 five = turn_of(w.error_estimate[b].q, end[b].q), three = turn_of(other[b].q, end[b].q),
                 five_later = w.error_estimate[b].w * h, three_later = other[b].w * h;
    const auto x = transposed(five.x, five_later.x, three.x, three_later.x),
               y = transposed(five.y, five_later.y, three.y, three_later.y),
               z = transposed(five.z, five_later.z, three.z, three_later.z);
    for (std::size_t lane = 0; lane < batch_size; lane++)
      w.rotation_errors[batch_size * b + lane] = {x[lane], y[lane], z[lane]};
  }
}

/// a x b of four and one
Vec3x4 cross(const Vec3x4& a, Vec3 b) { return pantin::cross(a, {lanes(b[0]), lanes(b[1]), lanes(b[2])}); }

/// Largest displacements of a point by such turns; no number where one of them is none.
Lanes largest_displacements(const Tree& tree, TreeWorkspace& workspace) {
  const auto R_times = [&](std::uint32_t slot, Vec3 l) {
    const Mat3x4& R = workspace.batches[slot / batch_size].R;
    const std::size_t lane = slot % batch_size;
    return lane_of(R[0], lane) * l[0] + lane_of(R[1], lane) * l[1] + lane_of(R[2], lane) * l[2];
  };
  workspace.displacement_errors.assign(tree.nodes, zero3x4());
  Vec3x4 mean = zero3x4();
  for (const Tree::Placement& p : tree.placements) {
    Errors d = cross(workspace.rotation_errors[p.child_slot], R_times(p.child_slot, p.child_arm)) * -1.0;
    if (p.parent >= 0)
      d += workspace.displacement_errors[static_cast<std::size_t>(p.parent)] +
           cross(workspace.rotation_errors[p.parent_slot], R_times(p.parent_slot, p.parent_arm));
    workspace.displacement_errors[static_cast<std::size_t>(p.child)] = d;
    if (!tree.anchored) mean += d * tree.masses[static_cast<std::size_t>(p.child)];
  }
  mean = mean * (1.0 / tree.mass);
  Lanes most = lanes(0.0), unsound = lanes(0.0);
  for (std::size_t k = 0; k < tree.nodes; k++) {
    const Lanes d = square_root(norm2(workspace.displacement_errors[k] - mean)) +
                    square_root(norm2(workspace.rotation_errors[tree.slots[k]])) * tree.extents[k];
    most = larger(most, d);
    unsound += d * 0.0;
  }
  return most + unsound;
}

/// How wrong the step from `start` to workspace.end is [m]: both estimates together (Hairer, Norsett and Wanner 1993, II.10).
double try_step(const Stages& s, const TreeState& start, double h) {
  s.stages(start, h, std::make_index_sequence<dop853::stages - 1>{});
  combine<dop853::a, dop853::stages>(flat(start), s.k(0), h, s.n, flat(s.workspace.end));
  find_rotation_errors(s, s.workspace.end, h);
  const Lanes wrong = largest_displacements(s.tree, s.workspace);
  const double a = wrong[0] + wrong[1], b = wrong[2] + wrong[3];
  return a > 0.0 ? a * a / std::sqrt(a * a + 0.01 * b * b) : a;
}

void normalise(Rotation4& y) {
  Quatx4& q = y.q;
  const Lanes s = 1.0 / square_root(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  q = {q.w * s, q.x * s, q.y * s, q.z * s};
}

/// The coefficients of the polynomial over the last step (Hairer, Norsett and Wanner 1993, II.6).
void find_polynomial(const Stages& s, TreeCourse& course) {
  auto& p = course.coefficients;
  const double h = course.h;
  s.stage<13>(p[0], h);
  s.stage<14>(p[0], h);
  s.stage<15>(p[0], h);
  for (std::size_t k = 1; k < p.size(); k++) p[k].resize(course.end.size());
  const Lanes *from = flat(p[0]), *to = flat(course.end), *first = s.k(0), *last = s.k(12);
  for (std::size_t i = 0; i < s.n; i++) {
    const Lanes change = to[i] - from[i];
    flat(p[1])[i] = change;
    flat(p[2])[i] = first[i] * h - change;
    flat(p[3])[i] = change * 2.0 - (first[i] + last[i]) * h;
  }
  for (std::size_t k = 4; k < p.size(); k++) std::fill_n(flat(p[k]), s.n, lanes(0.0));
  combine<dop853::dense, 0>(flat(p[4]), s.k(0), h, s.n, flat(p[4]));
  combine<dop853::dense, 1>(flat(p[5]), s.k(0), h, s.n, flat(p[5]));
  combine<dop853::dense, 2>(flat(p[6]), s.k(0), h, s.n, flat(p[6]));
  combine<dop853::dense, 3>(flat(p[7]), s.k(0), h, s.n, flat(p[7]));
}

/// Finds the rates at the end of the course.
void find_end_rates(const Stages& s, TreeCourse& course) {
  find_rates(s.tree, s.workspace, s.gravity, course.end.data(), course.end_rates.data());
  course.own_rate2 = largest_own_rate2(s.tree, s.workspace);
}

/// By how much the length of a step may change for an error that is `relative` times the wanted one.
double change_of_length(double relative) {
  constexpr double least = 0.2, most = 2.0, caution = 0.8;
  const double root8 = std::sqrt(std::sqrt(std::sqrt(std::fmax(relative, 1e-12))));
  return std::clamp(caution / root8, least, most);
}

/// Of a step, [m].
double round_off(const Tree& tree) {
  return std::numeric_limits<double>::epsilon() * *std::max_element(tree.extents.begin(), tree.extents.end());
}

/// Takes one step from the end of the course; false where that does not stay finite.
bool take_step(const Stages& s, TreeCourse& course, double most, const StepControl& control, TreeCost& cost) {
  double h = std::min({course.next > 0.0 ? course.next : infinity, stable_length(course.own_rate2), most});
  h = std::max(h, control.shortest);
  std::copy_n(flat(course.end_rates), s.n, s.k(0));
  double grow = 2.0;
  for (;;) {
    const double error = try_step(s, course.end, h), rate = error / h;
    cost.evaluations += dop853::stages - 1;
    const bool finite = std::isfinite(rate), good = rate <= control.error_rate;
    if (!good && h > control.shortest * 1.0001) {
      cost.rejected++;
      h = std::max(control.shortest, h * (finite ? change_of_length(rate / control.error_rate) : 0.2));
      grow = 1.0;
      continue;
    }
    if (!finite) return false;
    const double told = std::max(rate, round_off(s.tree) / h);
    if (told > control.error_rate) cost.missed = std::max(cost.missed, told);
    course.next = h * std::min(grow, change_of_length(rate / control.error_rate));
    break;
  }
  course.h = h;
  std::swap(course.coefficients[0], course.end);
  course.end.resize(s.n / numbers);
  for (std::size_t b = 0; b < course.end.size(); b++) {
    course.end[b] = s.workspace.end[b];
    normalise(course.end[b]);
  }
  find_end_rates(s, course);
  cost.evaluations++;
  cost.taken++;
  return true;
}

}  // namespace

double stable_length(double own_rate2) { return own_rate2 > 0.0 ? 5.5 / std::sqrt(own_rate2) : infinity; }

void begin_course(const Tree& tree, TreeWorkspace& workspace, TreeCourse& course, Vec3 gravity, TreeCost& cost) {
  make_room(tree, workspace);
  course.end_rates.resize(course.end.size());
  course.ahead = 0.0;
  find_end_rates({tree, workspace, gravity, numbers * tree.batches.size()}, course);
  cost.evaluations++;
}

bool advance(const Tree& tree, TreeWorkspace& workspace, TreeCourse& course, double time, Vec3 gravity,
             const StepControl& control, TreeCost& cost) {
  const Stages s{tree, workspace, gravity, numbers * tree.batches.size()};
  bool stepped = false;
  if (course.ahead < time) {
    make_room(tree, workspace);
    workspace.k.resize(dop853::all_stages * s.n);
  }
  while (course.ahead < time) {
    // An edit in every step would have all that is past it for nothing.
    const double most = course.fresh ? time : control.longest;
    if (!take_step(s, course, most, control, cost)) {
      course.fresh = true;
      return false;
    }
    course.ahead += course.h;
    course.fresh = false;
    stepped = true;
  }
  course.ahead -= time;
  if (stepped && course.ahead > 0.0) {
    std::copy_n(flat(course.end_rates), s.n, s.k(12));
    find_polynomial(s, course);
    cost.evaluations += 3;
  }
  return true;
}

void read_present(const TreeCourse& course, TreeState& state) {
  state.resize(course.end.size());
  if (course.ahead == 0.0) {
    std::copy_n(course.end.data(), course.end.size(), state.data());
    return;
  }
  const double x = 1.0 - course.ahead / course.h, y = 1.0 - x;
  const auto& p = course.coefficients;
  const std::size_t n = numbers * course.end.size();
  for (std::size_t i = 0; i < n; i++) {
    Lanes sum = flat(p[7])[i] * x;
    for (std::size_t k = 7; k-- > 1;) sum = (sum + flat(p[k])[i]) * (k % 2 == 0 ? y : x);
    flat(state)[i] = sum + flat(p[0])[i];
  }
  for (Rotation4& t : state) normalise(t);
}

}  // namespace pantin
