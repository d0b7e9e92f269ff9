#pragma once
// The problem that a pass of touch solves: velocities of bodies, given those without impulses of contacts and ties.
//
//   M (v - v0) = Σ G' γ + Σ T' μ
//   contacts:  u = G v + bias in the frame (n, t1, t2);  0 ≤ γ_n ⊥ u_n ≥ 0;  |γ_t| ≤ friction γ_n, against u_t where it slides
//   rolls:     impulse r, moment lever r, slip lever (ω_a - ω_b): |r_n| ≤ γ_n and |r_t| ≤ γ_n of their contact, against the slip
//   ties:      kept (T v - wanted) = 0, as articulates have them
//   scalars:   u = Σ J v + bias over any number of bodies; low ≤ μ ≤ high, u = 0 between, ≥ 0 at low, ≤ 0 at high
//
// v stands for the velocity of the centre and the spin, in world axes; forces act on body a, opposite ones on b. w is the
// diagonal of the Delassus operator G M⁻¹ G': how much a unit impulse changes its own velocity [1/kg].
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "articulates/factor.hpp"
#include "base/lanes.hpp"
#include "contacts/solve/sweeps.hpp"

namespace pantin {

class Workers;

struct IslandBody {
  double mass = 1.0, inverse_mass = 1.0;
  Mat3 inertia = identity33(),
       inverse_inertia = zero33();  ///< [kg m²] and its inverse, world axes; 0 where it cannot turn
  Mat3 root = zero33();             ///< inverse_inertia = root root'
  Mat3 turning = identity33();      ///< projects on the axes that it can turn about:
  bool turns_about_all = true;      ///< on all
  double reach = 0.0;               ///< [m] makes a speed of a spin, where residuals are measured
  Vec3 v0 = zero3(), w0 = zero3();  ///< [m/s], [rad/s] without impulses
  Vec3 v = zero3(), w = zero3();
  Vec3 dv = zero3(), dw = zero3();  ///< of a search: its next step
  Vec3 x = zero3();                 ///< [m] of the centre: large islands are swept in two halves
};

/// Between a body and another, or the world (b = -1).
struct IslandPair {
  std::int32_t a = 0, b = -1;
  Vec3 ra = zero3(), rb = zero3();  ///< [m] arms from the centres
};

struct IslandContact : IslandPair {
  Mat3 frame;  ///< columns n (from b to a), t1, t2
  double friction = 0.0;
  double wn = 0.0, wt = 0.0;  ///< [1/kg] w along n; the larger of those along t1 and t2
  double compliance = 0.0;  ///< [1/kg] u_n in the law counts with compliance γ_n: loads of rigid bodies become unique
  double height = 0.0;      ///< [m²/s²] -g·x: sweeps go up and down
  Vec3 bias = zero3();      ///< [m/s] in the frame, as all that follow
  Vec3 start = zero3();     ///< [N s] where the search for γ begins
  Vec3 other_start = zero3();  ///< [N s] taken instead of it, of all contacts, where that is nearer
  Vec3 impulse = zero3();      ///< [N s] γ
  Vec3 u = zero3();            ///< [m/s]
  double restitution = 0.0;
  double rebound = 0.0;           ///< [m/s] of the first impact, where that is known; else 0
  Vec3 impact_impulse = zero3();  ///< [N s] of the rounds of impacts
};

/// Friction at a contact against spins: an impulse of 1 N s turns with its lever, and slip is lever × spin.
struct IslandRoll {
  std::uint32_t contact = 0;
  Vec3 lever = zero3();                     ///< [m] of spinning about n, of rolling about t1 and t2: the same of both
  double wn = 0.0, wt = 0.0;                ///< [1/kg] about n; the sum of those about t1 and t2
  Vec3 start = zero3(), impulse = zero3();  ///< [N s] in the contact's frame
  Vec3 u = zero3();                         ///< [m/s]
};

struct IslandTie : IslandPair {
  double lever = 0.0;  ///< [m] of an angular one, which sees spins alone; 0: ties points
  Mat3 kept = identity33();
  double w = 0.0;                  ///< [1/kg]
  double softness = 0.0;           ///< [1/kg] of a spring: what it wants less by, for an impulse
  Vec3 pull = zero3();             ///< [N] that such a one has without it
  Vec3 wanted = zero3();           ///< [m/s] world axes, as all that follow
  Vec3 turning = zero3();          ///< [m/s] what of it, of the opposite sign, makes up for turning and does no work
  Vec3 start = zero3();            ///< [N s]
  Vec3 impulse = zero3();          ///< [N s] μ
  Vec3 u = zero3();                ///< [m/s] kept (T v - wanted)
  Vec3 earlier_impulse = zero3();  ///< [N s] given before contacts are solved: by ties alone, by impacts
};

/// What a unit impulse of a scalar does to one body [1], [m], about its centre, world axes.
struct ScalarEnd {
  std::uint32_t body;
  Vec3 force = zero3(), moment = zero3();
};

/// One number of velocities: of a coupling over several bodies, or of what holds within bounds.
struct IslandScalar {
  std::uint32_t first_end = 0, last_end = 0;   ///< in ContactIsland::ends, each of another body
  double low = -infinity, high = infinity;     ///< [N s] bounds of the impulse
  double bias = 0.0;                           ///< [m/s]
  double w = 0.0;                              ///< [1/kg]
  double start = 0.0, impulse = 0.0, u = 0.0;  ///< [N s], [N s], [m/s]
  double earlier_impulse = 0.0;                ///< [N s] as of ties

  bool is_bounded() const { return low > -infinity || high < infinity; }
  /// As near as a search comes to it.
  bool is_at_bound() const {
    constexpr double near = 1e-6;
    const double range = high - low, within = std::isfinite(range) ? near * range : 0.0;
    return is_bounded() && (impulse <= low + within || impulse >= high - within);
  }
};

/// What impulses do to a body: [N s], [N m s] about its centre, world axes.
struct BodyLoad {
  Vec3 force = zero3(), moment = zero3();
};

/// Where blocks of a pair are in the factor: (row of a, row of b) for linear and angular parts.
struct PairBlocks {
  std::array<std::uint32_t, 4> block{};
  std::array<bool, 4> a_below{};  ///< a's row comes after b's in the elimination
};

/// The matrix M + Σ G' D G + Σ T' k T, or that of ties alone: rows 2i of the centre of body i and 2i + 1 of its spin.
struct Layout {
  std::size_t bodies = 0;                                      ///< for which it was laid out; 0: for none,
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;  ///< and for these of them, both ways, rising,
  std::size_t most_updates = 0;  ///< in no more of them than this: with fewer it may be too dense
  Factor factor;
  std::vector<std::uint32_t> position;  ///< (2 bodies) in the order of elimination
  std::vector<std::uint32_t> own;       ///< (bodies) block of the two rows of a body
  std::vector<PairBlocks> contact_blocks, tie_blocks;
  std::vector<PairBlocks> scalar_blocks;                    ///< of each two ends of each scalar
  std::vector<Mat3> base_diagonal, base_lower, base_upper;  ///< of masses and ties
  std::vector<Vec3> right_side;
};

struct ContactIsland {
  std::vector<IslandBody> bodies;
  std::vector<IslandContact> contacts;
  std::vector<IslandRoll> rolls;  ///< of some of them, in their order
  std::vector<IslandTie> ties;
  std::vector<IslandScalar> scalars;
  std::vector<ScalarEnd> ends;       ///< of the scalars
  double tolerance = 1e-8;           ///< [m/s] to which velocities at contacts are solved
  double enough = 1e-4;              ///< [m/s] change of velocities by a sweep after which there is no other
  double calm = infinity;            ///< [m/s] mean velocity below which an exact search is worth while
  Layout ties_alone, all;            ///< of the matrices that were factorised last
  bool ties_prepared = false;        ///< the first of them is of these ties
  std::vector<BodyLoad> tie_change;  ///< [m/s], [rad/s] scratch of what ties answer
  std::vector<BodyLoad> applied;     ///< scratch of what impulses do
  SweepSpace sweep_space;
  Workers* workers = nullptr;  ///< who share the sweeps of many contacts; null: nobody

  void clear();  ///< keeps memory
  bool is_tied() const { return !ties.empty() || !scalars.empty(); }
  bool has_springs() const {
    return std::any_of(ties.begin(), ties.end(), [](const IslandTie& t) { return t.softness > 0.0; });
  }
};

inline Vec3 to_frame(const IslandContact& c, Vec3 world) { return transposed_times(c.frame, world); }
inline Vec3 to_world(const IslandContact& c, Vec3 local) { return c.frame * local; }
/// [N m s] world axes, on a, of an impulse of a roll.
inline Vec3 moment_of(const ContactIsland& island, const IslandRoll& r, Vec3 impulse) {
  return island.contacts[r.contact].frame * (r.lever * impulse);
}

/// Velocity of a's point relative to b's, world axes, of velocities `v` and spins `w` of the bodies.
inline Vec3 relative(const IslandPair& p, const std::vector<IslandBody>& bodies, Vec3 IslandBody::*v,
                     Vec3 IslandBody::*w) {
  const IslandBody& a = bodies[static_cast<std::size_t>(p.a)];
  Vec3 u = a.*v + cross(a.*w, p.ra);
  if (p.b < 0) return u;
  const IslandBody& b = bodies[static_cast<std::size_t>(p.b)];
  return u - b.*v - cross(b.*w, p.rb);
}
inline Vec3 relative_spin(const IslandTie& t, const std::vector<IslandBody>& bodies, Vec3 IslandBody::*w) {
  const Vec3 wa = bodies[static_cast<std::size_t>(t.a)].*w;
  return (t.b < 0 ? wa : wa - bodies[static_cast<std::size_t>(t.b)].*w) * t.lever;
}
inline Vec3 velocity_of(const IslandTie& t, const std::vector<IslandBody>& bodies, Vec3 IslandBody::*v,
                        Vec3 IslandBody::*w) {
  return t.kept * (t.lever > 0.0 ? relative_spin(t, bodies, w) : relative(t, bodies, v, w));
}

inline std::span<const ScalarEnd> ends_of(const ContactIsland& island, const IslandScalar& s) {
  return std::span(island.ends).subspan(s.first_end, s.last_end - s.first_end);
}
inline double velocity_of(const ContactIsland& island, const IslandScalar& s, Vec3 IslandBody::*v,
                          Vec3 IslandBody::*w) {
  double sum = 0.0;
  for (const ScalarEnd& end : ends_of(island, s)) {
    const IslandBody& b = island.bodies[end.body];
    sum += dot(end.force, b.*v) + dot(end.moment, b.*w);
  }
  return sum;
}

inline Vec3 velocity_of(const ContactIsland& island, const IslandRoll& r, Vec3 IslandBody::*w) {
  const IslandContact& c = island.contacts[r.contact];
  const Vec3 wa = island.bodies[static_cast<std::size_t>(c.a)].*w;
  return r.lever * to_frame(c, c.b < 0 ? wa : wa - island.bodies[static_cast<std::size_t>(c.b)].*w);
}

/// Adds what impulses do to the bodies: of contacts and rolls, of ties and scalars.
void add_contact_loads(const ContactIsland& island, std::vector<BodyLoad>& loads);
void add_tie_loads(const ContactIsland& island, std::vector<BodyLoad>& loads);
void add_load(std::vector<BodyLoad>& loads, const IslandTie& tie, Vec3 impulse);  ///< world axes
void add_load(const ContactIsland& island, std::vector<BodyLoad>& loads, const IslandScalar& scalar, double impulse);
/// Velocities without impulses, and with those at hand.
void start_without_impulses(ContactIsland& island);
void apply_impulses(ContactIsland& island);
/// Sets u of contacts and of ties from the velocities.
void observe(ContactIsland& island);
/// Sets wn, wt and w, and begins the search where last time's impulses are.
void prepare(ContactIsland& island);
/// Sets w of ties and scalars alone.
void weigh_ties(ContactIsland& island);

/// How far a contact is from Coulomb's law with impulse γ at velocity u [m/s]: with x = w γ, the distance of x from the
/// projection of x - u on what is allowed.
double coulomb_residual(const IslandContact& contact);
/// The same of a scalar's law.
double scalar_residual(const IslandScalar& scalar);
/// The same of friction against spins.
double roll_residual(const ContactIsland& island, const IslandRoll& roll);
/// Largest of all contacts, and of what ties should forbid [m/s].
double residual(const ContactIsland& island);
/// Kinetic energy of the velocities [J].
double kinetic_energy(const ContactIsland& island);

/// Whether no body is much lighter than another: what acts on heavy ones would throw it about, were it not the same to the last digit.
bool is_even(const ContactIsland& island);

}  // namespace pantin
