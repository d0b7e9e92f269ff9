#include "forces/tied_kick.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "articulates/solve/couplings.hpp"
#include "articulates/solve/drift.hpp"
#include "articulates/solve/matrix.hpp"
#include "articulates/solve/momenta.hpp"
#include "articulates/solve/node_batches.hpp"
#include "articulates/solve/project.hpp"
#include "articulates/solve/row_gaps.hpp"
#include "articulates/solve/state.hpp"
#include "constraints/row_rule.hpp"
#include "constraints/stiff.hpp"

namespace pantin {

namespace {

constexpr std::size_t most_directions = 64;
constexpr double redundant = 1e-8;  // compliance where rows of loops may say what others do: in space most do

double size_of(const Mat3& m) { return std::sqrt(norm2(m[0]) + norm2(m[1]) + norm2(m[2])); }

bool wants_motion(const Condition& c) { return norm2(c.wanted) > 0.0; }

/// Whether the rows of an articulate say which velocities are allowed.
bool forbids(const Articulate& a) { return !a.forbids_nothing && !a.fell_back && !a.torn && !is_open(a); }

/// Whether rows do work on what they tie: they draw together what is apart, or drive it.
bool draws(const Articulate& a) {
  const auto moves = [](const Condition& c) { return c.value_rate != 0.0 || norm2(c.velocity) > 0.0; };
  return a.attracts || std::any_of(a.conditions.begin(), a.conditions.end(), moves);
}

}  // namespace

TiedKick::TiedKick(World& world, VelocityForces& laws, std::size_t articulate, double dt, SideOfDrift side)
    : world_(world), laws_(laws), index_(articulate), dt_(dt), side_(side), a_(world.articulates[articulate].get()) {
  if (!side.drifted && a_->edited) {
    copy_ = std::make_unique<Articulate>(*a_);
    a_ = copy_.get();
    load(*a_, world, world.settings.gravity);
    make_start_consistent(*a_, world.settings.step, world.stage.from);
  } else if (!side.drifted) {
    for (Node& n : a_->nodes) load(n, world, world.settings.gravity);
  }
  ties_ = forbids(*a_);
  if (!a_->loop_free && !world.plane.flat()) epsilon_ = redundant;
}

TiedKick::~TiedKick() = default;

void TiedKick::push(std::size_t node, Vec3 impulse, Vec3 angular) {
  pantin::push(pushes_[node / batch_size], node % batch_size, impulse, angular);
}

void TiedKick::add(Motions& to, const NodeSite& site, Vec3 impulse) const {
  pantin::push(to[site.node / batch_size], site.node % batch_size, impulse, world_.plane.about(cross(site.r, impulse)));
}

Vec3 TiedKick::velocity_at(const Motions& of, const NodeSite& site) const {
  const BatchMotion& m = of[site.node / batch_size];
  const std::size_t lane = site.node % batch_size;
  return lane_of(m.v, lane) + cross(lane_of(m.w, lane), site.r);
}

Motions TiedKick::allowed(const Motions& impulses) {
  Motions all(impulses.size());
  Lanes free2 = lanes(0.0);
  for (std::size_t b = 0; b < all.size(); b++) {
    NodeBatch& n = a_->batches[b];
    n.p = impulses[b].p;
    n.L = impulses[b].L;
    free2 += norm2(n.p) * n.inverse_mass + dot(n.L, n.inverse_inertia_world * n.L);
  }
  asked_ = std::sqrt(sum(free2));
  if (ties_) answer(*a_);
  for (std::size_t b = 0; b < all.size(); b++) {
    const NodeBatch& n = a_->batches[b];
    all[b] = {n.p * n.inverse_mass, n.inverse_inertia_world * n.L, n.p, n.L};
  }
  // Rows that say what others do need more compliance: to forbid takes energy, where nothing is wanted.
  const bool wants = std::any_of(a_->conditions.begin(), a_->conditions.end(), wants_motion);
  if (!ties_ || wants || size_of(all) <= (1.0 + 1e-9) * asked_ || epsilon_ > 1e-5) return all;
  epsilon_ = 100.0 * std::max(epsilon_, a_->least_epsilon);
  drop_factor(*a_, FactorOf::projection);
  begin_answers(*a_, epsilon_);
  if (at_rest_)
    for (Condition& c : a_->conditions) c.wanted = zero3();
  return allowed(impulses);
}

Motions TiedKick::forces_of_laws(const Motions& by) const {
  Motions to(by.size());
  for (const NodeSite& s : sites) add(to, s, laws_.fields.slope[s.site] * velocity_at(by, s));
  for (const Pair& p : pairs) {
    const VelocityPair& law = laws_.pairs[p.pair];
    const Vec3 force = law.slope * (velocity_at(by, sites[p.b]) - velocity_at(by, sites[p.a]));
    add(to, sites[p.a], force);
    if (!law.one_sided) add(to, sites[p.b], force * -1.0);
  }
  return to;
}

Motions TiedKick::forces_of_laws_and_soft_rows(const Motions& by) const {
  Motions to = forces_of_laws(by);
  add_forces_of_soft_rows(to, by, 1.0);
  return to;
}

/// Rows that pull without forbidding, as the drift that follows will have them.
void TiedKick::find_soft_rows() {
  soft_.clear();
  for (std::size_t k = 0; k < a_->rows.size(); k++) {
    const Row& row = a_->rows[k];
    if (!is_soft(row)) continue;
    const Condition& c = condition(*a_, row);
    const auto end = [&](std::int32_t node, Vec3 arm) {
      const Node& n = a_->nodes[static_cast<std::size_t>(node)];
      return NodeSite{0, static_cast<std::size_t>(node), n.turns ? n.R0 * arm : zero3()};
    };
    const auto at = [&](const NodeSite& s) { return a_->nodes[s.node].x0 + s.r; };
    Soft soft{end(row.a, row.la), {}, row.b >= 0, k, row.f, zero33(), 0.0};
    if (soft.two) soft.b = end(row.b, row.lb);
    if (c.stiff) {
      const StiffPull pull = pull_at(*c.stiff, at(soft.a) - (soft.two ? at(soft.b) : c.position1));
      soft.force = pull.f;
      soft.slope = pull.by_position * (c.stiff->solve == Solve::at_end ? 2.0 * dt_ : dt_) + pull.by_rate;
      soft.stiffness = size_of(pull.by_position);
    } else if (norm(row.f) < c.max_force) {
      soft.slope = identity33() * -(2.0 * c.stiffness * dt_ + c.damping);
      soft.stiffness = c.stiffness;
    }
    soft_.push_back(soft);
  }
}

void TiedKick::add(Motions& to, const Soft& soft, Vec3 impulse) const {
  add(to, soft.a, impulse);
  if (soft.two) add(to, soft.b, impulse * -1.0);
}

/// What their forces change by with velocities.
void TiedKick::add_forces_of_soft_rows(Motions& to, const Motions& by, double times) const {
  for (const Soft& s : soft_) {
    const Vec3 u = velocity_at(by, s.a) - (s.two ? velocity_at(by, s.b) : zero3());
    add(to, s, s.slope * u * times);
  }
}

void TiedKick::hold(Condition& c, bool held) {
  if (c.held != held) drop_factor(*a_, FactorOf::projection);
  c.held = held;
}

void TiedKick::start(const std::vector<Vec3>& forces, bool alone, const std::vector<BodyLoad>& pressing) {
  forces_on_sites_ = forces;
  pressing_.clear();
  for (const Node& n : a_->nodes)
    if (!pressing.empty()) pressing_.push_back(pressing[n.is_body ? n.slot : world_.bodies.slots() + n.slot]);
  alone_ = alone;
  for (const Condition& c : a_->conditions) held_.push_back(c.held);
  find_known();
}

double TiedKick::fastest_damping() {
  constexpr std::size_t enough = 8;
  Motions right = v0_;
  pantin::add(right, driven_, -1.0);
  pantin::add(right, others_, 1.0);
  MotionSpace space;
  std::vector<Motions> all;
  const auto again = [&](const Motions& motions) { return allowed(motions); };
  space.add_direction(right, size_of(right), again);
  while (all.size() < space.directions.size()) {
    all.push_back(forces_of_laws(space.directions.back()));
    space.add_forces(all);
    if (all.size() == enough) break;
    Motions next = allowed(all.back());
    space.add_direction(std::move(next), asked_, again);
  }
  return space.fastest_decay();
}

double TiedKick::fastest_swing() const {
  std::vector<double> squares(a_->nodes.size(), 0.0);
  for (const Soft& s : soft_) {
    const double square = s.stiffness * mobility(*a_, a_->rows[s.row]);
    squares[s.a.node] += square;
    if (s.two) squares[s.b.node] += square;
  }
  return squares.empty() ? 0.0 : std::sqrt(*std::max_element(squares.begin(), squares.end()));
}

void TiedKick::choose_rule(double too_fast) {
  if (theta == 0.5) return;
  if (side_.before) find_soft_rows();
  if (!soft_.empty()) find_known();
  const double damping = fastest_damping();
  const bool slow = !crossed && std::fabs(dt_) * damping <= too_fast;
  if (slow) theta = 0.5;
  if (soft_.empty() || (!slow && damping >= 2.0 * fastest_swing())) return;
  soft_.clear();
  find_known();
}

/// Finds the least motion that what is prescribed asks for. False where it is so near to what the rows cannot do, as to
/// shorten what is straight, that no step moves so: then nothing is prescribed.
bool TiedKick::can_drive() {
  constexpr double most = 100.0;  // times as fast as prescribed
  driven_ = allowed(driven_);
  double fastest2 = 0.0, wanted2 = 0.0;
  for (const BatchMotion& m : driven_) fastest2 = std::max(fastest2, largest_lane(norm2(m.v)));
  for (const Condition& c : a_->conditions) wanted2 = std::max(wanted2, norm2(c.wanted));
  if (fastest2 <= most * most * wanted2) return true;
  driven_.assign(driven_.size(), {});
  for (Condition& c : a_->conditions) c.wanted = zero3();
  return false;
}

void TiedKick::find_known() {
  const std::size_t n = a_->batches.size();
  at_rest_ = false;
  if (ties_) begin_answers(*a_, epsilon_);
  Motions first(n), other(n);
  for (std::size_t b = 0; b < n; b++) {
    read_momenta(*a_, b);
    const NodeBatch& batch = a_->batches[b];
    first[b] = {batch.p * batch.inverse_mass, batch.inverse_inertia_world * batch.L, batch.p, batch.L};
    for (std::size_t lane = 0; lane < batch.count && !alone_; lane++) {
      const Node& node = a_->nodes[batch_size * b + lane];
      pantin::push(other[b], lane, world_.plane.along(node.force) * dt_, world_.plane.about(node.torque) * dt_);
    }
  }
  if (!side_.before) pantin::add(first, other, -1.0);  // the drift had it
  for (std::size_t i = 0; i < pressing_.size(); i++)
    pantin::push(other[i / batch_size], i % batch_size, pressing_[i].force, world_.plane.about(pressing_[i].moment));
  for (const Soft& s : soft_) add(other, s, s.force * dt_);
  for (std::size_t s = 0; s < sites.size(); s++) add(other, sites[s], forces_on_sites_[s] * dt_);
  driven_.assign(other.size(), {});
  const bool wants = ties_ && std::any_of(a_->conditions.begin(), a_->conditions.end(), wants_motion) && can_drive();
  const bool is_allowed =
      side_.before && !copy_ && !wants && (world_.stage.first || !ties_);  // what is wanted may leap
  v0_ = is_allowed ? std::move(first) : allowed(allowed(first));
  wanted_.clear();
  for (Condition& c : a_->conditions) wanted_.push_back(std::exchange(c.wanted, zero3()));
  at_rest_ = true;
  others_ = allowed(other);
}

void TiedKick::solve() {
  if (solve_with_slopes()) return;
  without_slopes = true;
  for (const NodeSite& s : sites) laws_.fields.slope[s.site] = zero33();
  for (const Pair& p : pairs) laws_.pairs[p.pair].slope = zero33();
  solve_with_slopes();
}

/// False where it has no solution in numbers; w is then none either.
bool TiedKick::solve_with_slopes() {
  Motions known = pushes_;
  for (const NodeSite& s : sites) {
    const Vec3 force = laws_.fields.force[s.site] - laws_.fields.slope[s.site] * laws_.at[s.site];
    add(known, s, force * dt_);
  }
  for (const Pair& p : pairs) {
    const VelocityPair& law = laws_.pairs[p.pair];
    const Vec3 impulse = (law.force - law.slope * law.at) * dt_;
    add(known, sites[p.a], impulse);
    if (!law.one_sided) add(known, sites[p.b], impulse * -1.0);
  }
  pantin::add(known, forces_of_laws_and_soft_rows(driven_), dt_);
  Motions right = v0_;
  pantin::add(right, driven_, -1.0);
  pantin::add(right, others_, theta);
  pantin::add(right, allowed(known), theta);
  w_ = right;
  if (!std::isfinite(product(right, right))) return false;
  w_ = driven_;
  MotionSpace space;
  const auto again = [&](const Motions& motions) { return allowed(motions); };
  const double size = space.add_direction(right, size_of(right), again), factor = dt_ * theta;
  double tolerance = 0.0;
  std::vector<Motions> all;
  Eigen::VectorXd y;
  while (!space.directions.empty()) {
    all.push_back(forces_of_laws_and_soft_rows(space.directions.back()));
    space.add_forces(all);
    const auto n = static_cast<Eigen::Index>(space.directions.size());
    const Eigen::MatrixXd A = Eigen::MatrixXd::Identity(n, n) - factor * space.galerkin;
    y = A.partialPivLu().solve(Eigen::VectorXd::Unit(n, 0) * size);
    if (space.directions.size() == most_directions) break;
    Motions next = allowed(all.back());
    const double more = space.add_direction(std::move(next), asked_, again);
    if (n == 1) {
      const double reach = std::fabs(factor) * std::sqrt(space.galerkin(0, 0) * space.galerkin(0, 0) + more * more);
      tolerance = std::clamp(0.05 * reach * reach * reach, 1e-14, 1e-8);
    }
    if (!(std::fabs(factor * more * y(n - 1)) > tolerance * size)) break;
  }
  for (Eigen::Index k = 0; k < y.size(); k++) pantin::add(w_, space.directions[static_cast<std::size_t>(k)], y(k));
  return std::isfinite(product(w_, w_));
}

Motions TiedKick::told_impulses(const std::vector<Vec3>& told) const {
  Motions all = pushes_;
  for (std::size_t s = 0; s < sites.size(); s++) add(all, sites[s], told[s] * dt_);
  for (const Pair& p : pairs) {
    const VelocityPair& law = laws_.pairs[p.pair];
    add(all, sites[p.a], law.impulse);
    if (!law.one_sided) add(all, sites[p.b], law.impulse * -1.0);
  }
  return all;
}

/// The rigid motion that has not the angular momentum which impulses of rows made, where their two points are apart.
Motions TiedKick::given_back() const {
  if (!ties_ || !acts_at_distance(*a_)) return {};
  Motions back(w_.size());
  Vec3 angular = zero3();
  for (std::size_t k = 0; k < a_->rows.size(); k++)
    if (a_->rows[k].lever == 0.0) angular += cross(a_->rows[k].d1, borne_[k]);
  const Vec3 X = centre_of_mass(*a_), spin = spin_for(*a_, X, angular * -1.0, 0.5 * product(w_, w_));
  for (std::size_t i = 0; i < a_->nodes.size(); i++) {
    const Node& n = a_->nodes[i];
    BatchMotion& to = back[i / batch_size];
    const Vec3 v = cross(spin, n.x0 - X), felt = n.turns ? transposed_times(n.R0, spin) * n.felt_axes : zero3();
    set_lane(to.v, i % batch_size, v);
    set_lane(to.w, i % batch_size, n.R0 * felt);
    pantin::push(to, i % batch_size, v * n.mass, n.R0 * (n.inertia * felt));
  }
  return back;
}

bool TiedKick::finish(const std::vector<Vec3>& told) {
  told_ = told;
  change_ = w_;
  pantin::add(change_, v0_, -1.0);
  if (theta == 0.5) pantin::add(change_, Motions(change_), 1.0);
  pantin::add(change_, others_, -1.0);
  if (!soft_.empty()) {
    Motions soft(w_.size());
    add_forces_of_soft_rows(soft, w_, -dt_);
    pantin::add(change_, allowed(soft), 1.0);
    Articulate& own = *world_.articulates[index_];
    own.expected.assign(own.rows.size(), vec(infinity, 0.0, 0.0));
    for (const Soft& s : soft_)
      own.expected[s.row] = s.force + s.slope * (velocity_at(w_, s.a) - (s.two ? velocity_at(w_, s.b) : zero3()));
  }
  borne_.assign(a_->rows.size(), zero3());
  if (ties_) {
    allowed(told_impulses(told));
    borne_ = a_->impulses;
  }
  back_ = given_back();
  const bool again = let_go();
  if (again) {
    find_known();
    return true;
  }
  for (std::size_t k = 0; k < held_.size(); k++) hold(a_->conditions[k], held_[k] != 0);
  return false;
}

/// Has rows let go that would have to do what they cannot, with what they did in the last step: of one side to pull, of a
/// limited force to give more; whether some did.
bool TiedKick::let_go() {
  bool some = false;
  for (Condition& c : a_->conditions) {
    if (!ties_ || !c.held || is_soft(row(*a_, c))) continue;
    const double time = std::fabs(dt_);
    const Vec3 borne = borne_[c.row] * (dt_ > 0.0 ? 1.0 : -1.0) + row(*a_, c).f * time;
    const double beyond = c.ranged              ? -dot(borne, stop(*a_, row(*a_, c)).inward)
                          : std::isinf(c.upper) ? 0.0
                                                : norm(borne) - c.upper * time;
    if (beyond <= 1e-12 * norm(borne)) continue;
    hold(c, false);
    some = true;
  }
  if (some) hold_with_heads(*a_);
  return some;
}

void TiedKick::change_momenta(Node& n, Vec3 v, Vec3 p, Vec3 L) {
  if (side_.drifted) {
    n.p0 += p;
    if (!n.turns) return;
    n.P0 += transposed_times(n.R0, L);
    n.spin0 = n.inverse_inertia * n.P0;
    return;
  }
  if (!n.is_body) {
    FreeMotion& m = world_.free_motion[n.slot];
    m.v += v;
    return;
  }
  Motion& m = world_.motion[n.slot];
  m.p += p;
  if (n.turns) m.angular += transposed_times(matrix(m.q), L);
}

/// The velocities may have changed a little since, as energy was returned: the change is made to give the same [J]. Returns
/// what it gives.
double TiedKick::scale_to(double given) {
  if (!side_.drifted) return given;
  Motions now(change_.size());
  for (std::size_t b = 0; b < now.size(); b++) {
    read_momenta(*a_, b);
    now[b].p = a_->batches[b].p;
    now[b].L = a_->batches[b].L;
  }
  const double size = product(change_, change_), along = product(change_, now), slope = size + along;
  const double by = (given - along - 0.5 * size) / slope;
  if (std::fabs(slope) < 0.1 * size || !(std::fabs(by) < 1e-3)) return along + 0.5 * size;
  pantin::add(change_, Motions(change_), by);
  if (!back_.empty()) pantin::add(back_, Motions(back_), by);
  return (1.0 + by) * along + 0.5 * (1.0 + by) * (1.0 + by) * size;
}

/// Adds it to the change; returns what it gives to the present velocities [J].
double TiedKick::add_given_back() {
  if (back_.empty()) return 0.0;
  Motions now(change_);
  for (std::size_t i = 0; i < a_->nodes.size(); i++) {
    Node n = world_.articulates[index_]->nodes[i];
    if (!side_.drifted) load(n, world_, world_.settings.gravity);
    pantin::push(now[i / batch_size], i % batch_size, n.p0, n.R0 * n.P0);
  }
  pantin::add(now, back_, 0.5);
  pantin::add(change_, back_, 1.0);
  return product(back_, now);
}

TiedWork TiedKick::apply(const std::vector<Vec3>& spared, double full) {
  TiedWork work;
  Articulate& own = *world_.articulates[index_];
  Motions mean = v0_;
  if (!side_.before) pantin::add(mean, others_, 1.0);
  pantin::add(mean, change_, 0.5);
  bool damps = !pairs.empty() || crossed;
  for (std::size_t s = 0; s < sites.size(); s++) damps = damps || norm2(told_[s] - spared[s]) > 0.0;
  for (std::size_t s = 0; s < sites.size(); s++) work.rest += dot(spared[s], velocity_at(mean, sites[s])) * dt_;
  for (std::size_t k = 0; k < wanted_.size(); k++) {
    const Condition& c = a_->conditions[k];
    (row(*a_, c).lever > 0.0 ? work.rows.angular_rows : work.rows.anchors) += dot(borne_[c.row], wanted_[k]);
  }
  const double by_laws = scale_to(product(mean, change_)) - work.rows.all();
  if (damps)
    work.damper = by_laws - work.rest;
  else if (draws(own))
    work.rows.anchors += by_laws - work.rest;
  work.rows.anchors += add_given_back();
  if (own.reaction.size() != borne_.size()) own.reaction.assign(borne_.size(), zero3());
  for (std::size_t k = 0; k < borne_.size(); k++) own.reaction[k] += borne_[k] / full;
  for (std::size_t i = 0; i < own.nodes.size(); i++) {
    const BatchMotion& batch = change_[i / batch_size];
    const std::size_t lane = i % batch_size;
    change_momenta(own.nodes[i], lane_of(batch.v, lane), lane_of(batch.p, lane), lane_of(batch.L, lane));
  }
  return work;
}

}  // namespace pantin
