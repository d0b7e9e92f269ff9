// Proximal steps: with impulses γ at hand and R = ρ diag(wn, wt, wt), velocities are those of least
//
//   ½ |v - v0|²_M + Σ ½ |P(γ - R⁻¹(u + s n))|²_R,   s = friction |u_t| + c γ_n as they were,
//
// P the projection on the cone of friction in the norm of R; then γ = P. With the shift s the law of the cone is Coulomb's
// (De Saxcé 1992; Acary, Cadoux 2013). Each problem is strictly convex, its slope linear by parts: Newton's steps with a search
// along the line always come to its end.
#include <algorithm>
#include <cmath>

#include "contacts/solve/best_impulses.hpp"
#include "contacts/solve/search.hpp"
#include "contacts/solve/ties.hpp"

namespace pantin {

namespace {

constexpr double rho_at_first = 2.5e-2, rho_of_even = 1e-3,
                 rho_of_uneven = 1e-5;        // ρ: at first, and of even and uneven masses
constexpr double harder = 0.2, falls = 0.25;  // ρ times that where the residual does not fall to this
constexpr std::uint32_t most_steps = 60,
                        most_proximal_patience = 3;  // of one problem; rounds in which the residual may not halve
constexpr double part_of_motion = 0.02,
                 loosest = 100.0;  // of the fastest body's speed; of what is enough: that may be left
constexpr int most_on_line = 12;
constexpr double flat = 0.1;  // of the first slope: where the search along a line ends

double size_of(double a, double b) { return std::sqrt(a * a + b * b); }

struct Proximal {
  ContactIsland& island;
  double rho = rho_at_first;
  BestImpulses from = {};  // γ
  std::vector<double> shift = {}, most_roll = {};
  std::vector<Mat3> slopes = {}, roll_slopes = {};  // -dP/du, world axes
  std::vector<double> scalar_slopes = {};
  std::vector<BodyLoad> load = {}, change = {};
  std::vector<Vec3> du = {}, roll_du = {};  // by the change, as u
  std::vector<double> scalar_du = {};

  void begin_round() {
    from.keep(island);
    shift.clear();
    most_roll.clear();
    for (const IslandContact& c : island.contacts)
      shift.push_back(c.friction * size_of(c.u[1], c.u[2]) + c.compliance * c.impulse[0]);
    for (const IslandRoll& r : island.rolls) most_roll.push_back(std::fmax(0.0, island.contacts[r.contact].impulse[0]));
  }

  /// The impulse of a contact at velocity u [m/s], and its slope where that is asked for.
  Vec3 project(const IslandContact& c, Vec3 u, Vec3 g, double s, Mat3* slope) const {
    const double rn = rho * c.wn, rt = rho * c.wt, other = c.friction * rt / rn;
    const double yn = g[0] - (u[0] + s) / rn, y1 = g[1] - u[1] / rt, y2 = g[2] - u[2] / rt, yt = size_of(y1, y2);
    if (yt <= c.friction * yn) {
      if (slope)
        *slope = outer(c.frame[0], c.frame[0]) * (1.0 / rn) +
                 (outer(c.frame[1], c.frame[1]) + outer(c.frame[2], c.frame[2])) * (1.0 / rt);
      return vec(yn, y1, y2);
    }
    if (!(yn > -other * yt)) {
      if (slope) *slope = zero33();
      return zero3();
    }
    const double f = 1.0 / (1.0 + c.friction * other), n = f * (yn + other * yt), t = c.friction * n;
    const double d1 = y1 / yt, d2 = y2 / yt;
    if (slope) {
      const Vec3 way = c.frame[0] + (c.frame[1] * d1 + c.frame[2] * d2) * c.friction,
                 across = c.frame[2] * d1 - c.frame[1] * d2;
      *slope = outer(way, way) * (f / rn) + outer(across, across) * (t / (yt * rt));
    }
    return vec(n, t * d1, t * d2);
  }
  /// The same of a roll, its bound as the round found it.
  Vec3 project(const IslandRoll& r, Vec3 u, Vec3 g, double most, Mat3* slope) const {
    const Mat3& frame = island.contacts[r.contact].frame;
    Vec3 impulse = zero3();
    if (slope) *slope = zero33();
    if (r.wn > 0.0) {
      const double by = 1.0 / (rho * r.wn), y = g[0] - u[0] * by;
      impulse[0] = std::clamp(y, -most, most);
      if (slope && std::fabs(y) < most) *slope += outer(frame[0], frame[0]) * (r.lever[0] * r.lever[0] * by);
    }
    if (r.wt == 0.0) return impulse;
    const double by = 1.0 / (rho * r.wt), y1 = g[1] - u[1] * by, y2 = g[2] - u[2] * by, y = size_of(y1, y2);
    const double part = y > most ? most / y : 1.0, stiffness = r.lever[1] * r.lever[1] * part * by;
    impulse[1] = y1 * part;
    impulse[2] = y2 * part;
    if (!slope) return impulse;
    const Vec3 along = y > 0.0 ? (frame[1] * y1 + frame[2] * y2) * (1.0 / y) : frame[1],
               across = cross(frame[0], along);
    *slope += outer(across, across) * stiffness;
    if (y <= most) *slope += outer(along, along) * stiffness;
    return impulse;
  }
  double project(const IslandScalar& s, double u, double from_impulse, double& slope) const {
    const double by = s.is_bounded() ? 1.0 / (rho * s.w) : tie_stiffness / s.w, y = from_impulse - u * by;
    slope = s.is_bounded() && y > s.low && y < s.high ? by : 0.0;
    return std::clamp(y, s.low, s.high);
  }
  /// Impulses at the velocities at hand, and how they change with these.
  void project_all() {
    for (std::size_t k = 0; k < from.ties.size(); k++) island.ties[k].impulse = from.ties[k];
    observe(island);
    for (std::size_t k = 0; k < slopes.size(); k++) {
      IslandContact& c = island.contacts[k];
      c.impulse = project(c, c.u, from.contacts[k], shift[k], &slopes[k]);
    }
    for (std::size_t k = 0; k < roll_slopes.size(); k++) {
      IslandRoll& r = island.rolls[k];
      r.impulse = project(r, r.u, from.rolls[k], most_roll[k], &roll_slopes[k]);
    }
    for (std::size_t k = 0; k < from.ties.size(); k++) {
      IslandTie& t = island.ties[k];
      t.impulse = from.ties[k] - t.u * stiffness_of(t);
    }
    for (std::size_t k = 0; k < scalar_slopes.size(); k++) {
      IslandScalar& s = island.scalars[k];
      s.impulse = project(s, s.u, from.scalars[k], scalar_slopes[k]);
    }
    unbalanced(island, load);
  }

  void read_changes() {
    for (std::size_t i = 0; i < change.size(); i++) {
      island.bodies[i].dv = change[i].force;
      island.bodies[i].dw = change[i].moment;
    }
    for (std::size_t k = 0; k < du.size(); k++) {
      const IslandContact& c = island.contacts[k];
      du[k] = to_frame(c, relative(c, island.bodies, &IslandBody::dv, &IslandBody::dw));
    }
    for (std::size_t k = 0; k < roll_du.size(); k++) roll_du[k] = velocity_of(island, island.rolls[k], &IslandBody::dw);
    for (std::size_t k = 0; k < scalar_du.size(); k++)
      scalar_du[k] = velocity_of(island, island.scalars[k], &IslandBody::dv, &IslandBody::dw);
  }
  /// [J] Slope along the change of what is least, so far along it. Masses and ties have straight ones.
  double slope_at(double part, double start, double bend) const {
    double sum = start + bend * part;
    for (std::size_t k = 0; k < du.size(); k++) {
      const IslandContact& c = island.contacts[k];
      sum -= dot(project(c, c.u + du[k] * part, from.contacts[k], shift[k], nullptr), du[k]);
    }
    for (std::size_t k = 0; k < roll_du.size(); k++) {
      const IslandRoll& r = island.rolls[k];
      sum -= dot(project(r, r.u + roll_du[k] * part, from.rolls[k], most_roll[k], nullptr), roll_du[k]);
    }
    double unused = 0.0;
    for (std::size_t k = 0; k < scalar_du.size(); k++) {
      const IslandScalar& s = island.scalars[k];
      sum -= project(s, s.u + scalar_du[k] * part, from.scalars[k], unused) * scalar_du[k];
    }
    return sum;
  }
  void go(double part) {
    for (IslandBody& b : island.bodies) {
      b.v += b.dv * part;
      b.w += b.dw * part;
    }
    project_all();
  }
  /// To where the slope along the change vanishes: it rises all the way. Returns how far that is; 0 where it falls nowhere.
  double search_line() const {
    double start = 0.0, bend = 0.0, first = 0.0;
    for (std::size_t i = 0; i < load.size(); i++) {
      const IslandBody& b = island.bodies[i];
      start += b.mass * dot(b.v - b.v0, b.dv) + dot(b.w - b.w0, b.inertia * b.dw);
      bend += b.mass * norm2(b.dv) + dot(b.dw, b.inertia * b.dw);
      first -= dot(load[i].force, b.dv) + dot(load[i].moment, b.dw);
    }
    for (const IslandTie& t : island.ties) {
      const Vec3 by = velocity_of(t, island.bodies, &IslandBody::dv, &IslandBody::dw);
      start -= dot(t.impulse, by);
      bend += norm2(by) * stiffness_of(t);
    }
    if (!(first < 0.0)) return 0.0;
    double at = 0.0, low = 0.0, low_slope = first, high = infinity, high_slope = 0.0, next = 1.0;
    for (int i = 0; i < most_on_line; i++) {
      at = next;
      const double slope = slope_at(at, start, bend);
      if (std::fabs(slope) <= flat * std::fabs(first)) break;
      (slope < 0.0 ? low : high) = at;
      (slope < 0.0 ? low_slope : high_slope) = slope;
      if (high == infinity) {
        next = 2.0 * at;
        continue;
      }
      const double width = high - low, secant = low - low_slope * width / (high_slope - low_slope);
      next = i % 3 == 2 ? low + 0.5 * width : std::clamp(secant, low + 0.01 * width, high - 0.01 * width);
    }
    return at;
  }
  /// [m/s] Largest speed that loads not yet balanced would give.
  double unmoved() const {
    double most = 0.0;
    for (std::size_t i = 0; i < load.size(); i++) {
      const IslandBody& b = island.bodies[i];
      most = std::fmax(most, norm(load[i].force) * b.inverse_mass + norm(b.inverse_inertia * load[i].moment) * b.reach);
    }
    return most;
  }
  /// One convex problem, to speeds of `enough`. Returns how many steps it took.
  std::uint32_t solve_round(double enough) {
    slopes.resize(island.contacts.size());
    roll_slopes.resize(island.rolls.size());
    scalar_slopes.resize(island.scalars.size());
    change.resize(island.bodies.size());
    du.resize(island.contacts.size());
    roll_du.resize(island.rolls.size());
    scalar_du.resize(island.scalars.size());
    project_all();
    for (std::uint32_t step = 0; step < most_steps; step++) {
      if (unmoved() <= enough) return step;
      factorise(island, island.all, slopes, roll_slopes, scalar_slopes, true);
      solve(island, island.all, load, change);
      read_changes();
      const double part = search_line();
      if (part == 0.0) return step;
      go(part);
    }
    return most_steps;
  }
};

double least_rho(const ContactIsland& island) {
  double lightest = infinity, heaviest = 0.0;
  for (const IslandBody& b : island.bodies) {
    lightest = std::fmin(lightest, b.mass);
    heaviest = std::fmax(heaviest, b.mass);
  }
  return std::clamp(lightest / heaviest, rho_of_uneven, rho_of_even);
}

double fastest(const ContactIsland& island) {
  double most = 0.0;
  for (const IslandBody& b : island.bodies) most = std::fmax(most, norm(b.v));
  return most;
}

}  // namespace

SearchReport proximal_search(ContactIsland& island, std::uint32_t most_rounds) {
  SearchReport report;
  apply_impulses(island);
  observe(island);
  double now = residual(island);
  BestImpulses best;
  best.keep(island, now);
  Patience patience{most_proximal_patience, now};
  Proximal proximal{island};
  const double least = least_rho(island);
  set_base(island, island.all);
  const auto enough = [&] {
    return std::fmax(island.tolerance, std::fmin(loosest * island.enough, part_of_motion * fastest(island)));
  };
  while (report.iterations < most_rounds && now > enough()) {
    report.iterations++;
    proximal.begin_round();
    report.factorisations += proximal.solve_round(std::fmax(0.1 * island.tolerance, 0.1 * now));
    apply_impulses(island);
    observe(island);
    const double before = now;
    now = residual(island);
    if (!std::isfinite(now)) break;
    if (now < best.residual) best.keep(island, now);
    if (patience.ends(now)) break;
    if (now > falls * before) proximal.rho = std::fmax(least, harder * proximal.rho);
  }
  if (!(now <= best.residual)) best.put_back(island);
  report.residual = best.residual;
  return report;
}

}  // namespace pantin
