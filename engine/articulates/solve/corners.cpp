#include "articulates/solve/corners.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "articulates/solve/moment.hpp"
#include "articulates/solve/project.hpp"
#include "articulates/solve/state.hpp"
#include "articulates/solve/wanted_velocities.hpp"

namespace pantin {

namespace {

constexpr double round_off = 1e-12;  // of the largest number in a path

double corner_of(const Condition& c, bool ahead) { return ahead ? c.run.to : c.run.from; }

/// [m] How far a point is past a corner of its path; below 0: before it.
double past(const Condition& c, bool ahead) {
  const double corner = corner_of(c, ahead);
  if (c.path == nullptr || c.run.is_corner() || std::isinf(corner)) return -infinity;
  const double way = norm(c.path->position(c.angle0, c.run) - c.path->position(corner, c.run));
  return (c.angle0 > corner) == ahead ? way : -way;
}

/// [m/s] How fast.
double rate_past(const Articulate& a, const Condition& c, bool ahead) {
  const Row& r = row(a, c);
  const Node& n = a.nodes[static_cast<std::size_t>(r.a)];
  const Vec3 v = n.p0 * n.inverse_mass + (n.turns ? n.R0 * cross(n.spin0, r.la) : zero3());
  return dot(v, c.path->tangent(c.angle0, c.run)) * (ahead ? 1.0 : -1.0);
}

/// Some direction across another, in the scene's plane where it has one.
Vec3 some_across(Vec3 v, const Plane& plane) {
  const Vec3 beside = std::fabs(v[0]) < 0.5 ? vec(1, 0, 0) : vec(0, 1, 0);
  return direction(cross(plane.flat() ? plane.about(vec(1, 1, 1)) : beside, v));
}

/// A direction on the way from one to another, by the part of the angle between them.
Vec3 on_the_way(Vec3 from, Vec3 to, double angle, double part, const Plane& plane) {
  const Vec3 across = to - from * dot(from, to);
  const Vec3 u = norm(across) > 1e-9 ? direction(across) : some_across(from, plane);
  return from * std::cos(part * angle) + u * std::sin(part * angle);
}

struct CornerTurn {
  Condition* condition;
  PathRun run;
  double corner, angle;
  Vec3 from, to;
};

std::vector<CornerTurn> turns_of(Articulate& a) {
  std::vector<CornerTurn> turns;
  for (Condition& c : a.conditions)
    for (const bool ahead : {false, true}) {
      if (c.path == nullptr || !(past(c, ahead) >= -10.0 * round_off * c.extent)) continue;
      const double corner = corner_of(c, ahead);
      const PathRun next = c.path->next_run(c.run, ahead);
      const Vec3 from = c.path->tangent(corner, c.run), to = c.path->tangent(corner, next);
      turns.push_back({&c, next, corner, std::atan2(norm(cross(from, to)), dot(from, to)), from, to});
      break;
    }
  return turns;
}

/// Changes the sign of what is forbidden.
void reflect(Articulate& a, const DriftSettings& settings, double at, DriftReport& report) {
  const std::vector<Node> before = a.nodes;
  stand_still(a, settings.step, at);
  const WantedVelocities wanted(a, settings.step, at);
  const ImpulseWork work = make_consistent(a, 0.5 * settings.full);
  for (std::size_t k = 0; k < a.nodes.size(); k++) {
    Node& n = a.nodes[k];
    n.p0 = n.p0 * 2.0 - before[k].p0;
    n.P0 = n.P0 * 2.0 - before[k].P0;
    n.spin0 = n.inverse_inertia * n.P0;
  }
  add_impulses_exerted(a);
  report.tell(work, 2.0);
}

}  // namespace

bool has_sharp_corners(const Articulate& a) {
  return std::any_of(a.conditions.begin(), a.conditions.end(), [](const Condition& c) {
    return c.path != nullptr && !c.run.is_corner() && (std::isfinite(c.run.from) || std::isfinite(c.run.to));
  });
}

PartStart::PartStart(const Articulate& a, const DriftReport& report) : state_(a), nodes_(a.nodes), report_(report) {
  for (const Row& row : a.rows) {
    forces_.push_back(row.f);
    offsets_.push_back(row.offset);
  }
}

void PartStart::put_back(Articulate& a, DriftReport& report) const {
  static_cast<ArticulateState&>(a) = state_;
  a.nodes = nodes_;
  for (std::size_t k = 0; k < a.rows.size(); k++) a.rows[k].offset = offsets_[k];
  a.factor_of = FactorOf::none;
  a.last_h = 0.0;
  report = report_;
}

void PartStart::put_back_forces(Articulate& a, DriftReport& report, double h) const {
  for (std::size_t k = 0; k < a.nodes.size(); k++) {
    Node& n = a.nodes[k];
    n.p0 = nodes_[k].p0 + n.force * h;
    n.P0 = nodes_[k].P0 + transposed_times(n.R0, n.torque) * h;
    n.spin0 = n.inverse_inertia * n.P0;
  }
  for (std::size_t k = 0; k < a.rows.size(); k++) a.rows[k].f = forces_[k];
  a.last_h = 0.0;
  report = report_;
}

CornerSearch::CornerSearch(const Articulate& a, double h) : h_(h) {
  add_passed(a);
  high_ = farthest(a, 1.0);
}

void CornerSearch::add_passed(const Articulate& a) {
  for (std::size_t k = 0; k < a.conditions.size(); k++)
    for (const bool ahead : {false, true}) {
      const Condition& c = a.conditions[k];
      if (!(past(c, ahead) > round_off * c.extent)) continue;
      const auto same = [&](const Passed& p) { return p.condition == k && p.ahead == ahead; };
      if (std::any_of(passed_.begin(), passed_.end(), same)) continue;
      passed_.push_back({k, ahead});
      tolerance_ = std::max(tolerance_, round_off * c.extent);
    }
}

CornerSearch::Moment CornerSearch::farthest(const Articulate& a, double part) const {
  Moment most{part, -infinity, 0.0};
  for (const Passed& p : passed_) {
    const Condition& c = a.conditions[p.condition];
    const double way = past(c, p.ahead);
    if (way > most.past) most = {part, way, rate_past(a, c, p.ahead) * h_};
  }
  return most;
}

void CornerSearch::begin(const Articulate& a) { low_ = farthest(a, 0.0); }

bool CornerSearch::at_start() const {
  constexpr double nearest_part = 1e-3;
  return low_.past >= -tolerance_ && high_.part < nearest_part;
}

/// Of the cubic with these values and rates at both ends; where that is none, of the straight line.
double CornerSearch::cubic_root() const {
  const double d = high_.past - low_.past, straight = -low_.past / d;
  const double c2 = 3.0 * d - 2.0 * low_.rate - high_.rate, c3 = low_.rate + high_.rate - 2.0 * d;
  double s = straight;
  for (int i = 0; i < 20; i++)
    s -= (low_.past + s * (low_.rate + s * (c2 + s * c3))) / (low_.rate + s * (2.0 * c2 + s * 3.0 * c3));
  return s > 0.0 && s < 1.0 ? s : straight;
}

double CornerSearch::next() {
  double part = 0.25 * high_.part;  // of what was at the corner: where is it not?
  if (low_.past < -tolerance_) {
    part = tries_ == 0 ? cubic_root() : last_.part - last_.past / last_.rate;
    if (!(part > low_.part && part < high_.part)) part = 0.5 * (low_.part + high_.part);
  }
  return last_.part = part;
}

void CornerSearch::tell(const Articulate& a) {
  tries_++;
  add_passed(a);
  last_ = farthest(a, last_.part);
  (last_.past > 0.0 ? high_ : low_) = last_;
}

namespace {

void set_tangents(const Articulate& a, const std::vector<CornerTurn>& turns, double part) {
  for (const CornerTurn& t : turns) t.condition->turning = on_the_way(t.from, t.to, t.angle, part, a.plane);
}

/// Turns from one part (0 … 1) of the way to another: by halves, as long as some are left, where what is left across the tangent
/// then has energy.
void turn_between(Articulate& a, const DriftSettings& settings, double at, const std::vector<CornerTurn>& turns,
                  double from, double to, int& halvings_left, DriftReport& report) {
  constexpr double most_lost = 1e-8;  // of the energy
  constexpr double narrowest = 0.5e-3;
  const std::vector<Node> nodes = a.nodes;
  const std::vector<Vec3> exerted = a.exerted;
  const DriftReport told = report;
  const double symmetric_energy = a.symmetric_energy, middle = 0.5 * (from + to);
  set_tangents(a, turns, middle);
  reflect(a, settings, at, report);
  const double kinetic = kinetic_energy(a);
  set_tangents(a, turns, to);
  begin_part_at(a, settings, at, report);
  if (symmetric_energy - a.symmetric_energy <= most_lost * kinetic || to - from < narrowest || halvings_left == 0)
    return;
  halvings_left--;
  a.nodes = nodes;
  a.exerted = exerted;
  a.symmetric_energy = symmetric_energy;
  report = told;
  turn_between(a, settings, at, turns, from, middle, halvings_left, report);
  turn_between(a, settings, at, turns, middle, to, halvings_left, report);
}

/// Whether it would only go to and fro over its corner as long as the step is.
bool is_slow(const Articulate& a, const CornerTurn& t, const DriftSettings& settings) {
  return std::fabs(rate_past(a, *t.condition, true)) <= 2.0 * norm(settings.gravity) * std::fabs(settings.full);
}

}  // namespace

void turn_at_corners(Articulate& a, const DriftSettings& settings, double at, bool last, DriftReport& report) {
  constexpr double most_at_once = 0.5;  // [rad]
  begin_part_at(a, settings, at, report);
  const std::vector<CornerTurn> turns = turns_of(a);
  double steps = 0.0;
  int halvings_left = 60;
  for (const CornerTurn& t : turns) {
    Condition& c = *t.condition;
    c.returned = std::exchange(c.turned_at, t.corner) == t.corner;
    last = last || (c.returned && is_slow(a, t, settings));
    steps = std::max(steps, std::ceil(t.angle / most_at_once));
  }
  for (double i = 0.0; i < steps && !last; i++)
    turn_between(a, settings, at, turns, i / steps, (i + 1.0) / steps, halvings_left, report);
  for (const CornerTurn& t : turns) {
    Condition& c = *t.condition;
    c.turning = zero3();
    c.run = !last ? t.run : c.returned ? PathRun{t.corner, t.corner} : PathRun{};
    c.angle0 = c.angle1 = t.corner;
  }
  if (last) report.limit += make_consistent_at(a, settings, at, report);
}

}  // namespace pantin
