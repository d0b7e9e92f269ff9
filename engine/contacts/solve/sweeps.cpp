// ContactBlock coordinate descent on the dual of a stage's problem,
//
//   Φ(γ, μ) = ½ |y0 + J'γ + T'μ|² + bias·γ,   γ_n ≥ 0,  |γ_t| ≤ friction γ_n,  μ free,
//
// contact by contact, then all ties at once; y = M^½ v, so that one row reads a velocity and gives an impulse. From sweep to
// sweep the whole change is carried on along conjugate directions (Silcowitz-Hansen, Niebe, Erleben 2010).
#include <algorithm>
#include <cmath>

#include "contacts/solve/search.hpp"
#include "contacts/solve/ties.hpp"

namespace pantin {

namespace {

constexpr std::uint32_t idle_sweeps = 2;  // that leave out a contact that stays open
constexpr double far = 1e3;               // times what is enough: that goes on

struct Sweeps {
  ContactIsland& island;
  SweepSpace& space = island.sweep_space;
  std::vector<Scaled>&free = space.free, &y = space.y;
  std::vector<ContactBlock>& blocks = space.blocks;
  std::vector<std::uint32_t>& order = space.order;
  std::vector<RollBlock>& rolls = space.rolls;
  std::vector<BodyLoad> loads = {};

  void take_velocities() {
    free.assign(island.bodies.size() + 1, {});
    for (std::size_t i = 0; i < island.bodies.size(); i++) {
      const IslandBody& b = island.bodies[i];
      free[i] = {b.v0 * std::sqrt(b.mass), transposed_times(b.root, b.inertia * b.w0)};
    }
    y = free;
  }
  void add_side(ContactBlock& block, const IslandContact& c, std::int32_t body, Vec3 arm, double& by, Mat3& spin,
                std::uint32_t& number) {
    spin = zero33();
    number = static_cast<std::uint32_t>(island.bodies.size());
    if (body < 0) return;
    number = static_cast<std::uint32_t>(body);
    const IslandBody& b = island.bodies[number];
    by = std::sqrt(b.inverse_mass);
    for (int k = 0; k < 3; k++) spin[k] = transposed_times(b.root, cross(arm, c.frame[k]));
    const auto add = [&](double& w, int i, int j) { w += (i == j ? by * by : 0.0) + dot(spin[i], spin[j]); };
    add(block.w00, 0, 0);
    add(block.w01, 0, 1);
    add(block.w02, 0, 2);
    add(block.w11, 1, 1);
    add(block.w12, 1, 2);
    add(block.w22, 2, 2);
  }
  void add_block(const IslandContact& c) {
    ContactBlock& block = blocks.emplace_back();
    block.frame = c.frame;
    block.friction = c.friction;
    block.compliance = c.compliance;
    block.bias = c.bias;
    block.impulse = c.start[0] > 0.0 ? c.start : zero3();
    add_side(block, c, c.a, c.ra, block.by_a, block.spin_a, block.a);
    add_side(block, c, c.b, c.rb, block.by_b, block.spin_b, block.b);
    const double det = block.w11 * block.w22 - block.w12 * block.w12;
    block.i11 = block.w22 / det;
    block.i12 = -block.w12 / det;
    block.i22 = block.w11 / det;
    const double mean = 0.5 * (block.w11 + block.w22), off = 0.5 * (block.w11 - block.w22);
    block.wt = mean + std::sqrt(off * off + block.w12 * block.w12);
    block.i00 = 1.0 / (block.w00 + block.compliance);
    block.it = 1.0 / block.wt;
  }
  void add_blocks() {
    order.clear();
    for (std::uint32_t k = 0; k < island.contacts.size(); k++) order.push_back(k);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
      return island.contacts[i].height < island.contacts[j].height;
    });
    blocks.clear();
    blocks.reserve(order.size());
    for (const std::uint32_t k : order) add_block(island.contacts[k]);
  }

  void add_rolls() {
    rolls.clear();
    if (island.rolls.empty()) return;
    std::vector<std::uint32_t> block_of(order.size());
    for (std::uint32_t k = 0; k < order.size(); k++) block_of[order[k]] = k;
    for (const IslandRoll& r : island.rolls) {
      const IslandContact& c = island.contacts[r.contact];
      RollBlock& block = rolls.emplace_back();
      block.contact = block_of[r.contact];
      const auto rows = [&](std::int32_t body, Mat3& spin) {
        spin = zero33();
        if (body < 0) return;
        for (int k = 0; k < 3; k++)
          spin[k] = transposed_times(island.bodies[static_cast<std::size_t>(body)].root, c.frame[k] * r.lever[k]);
      };
      rows(c.a, block.spin_a);
      rows(c.b, block.spin_b);
      block.impulse = r.start;
      block.wn = r.wn;
      block.wt = r.wt;
    }
  }
  void give(const RollBlock& r, Vec3 impulse) {
    y[blocks[r.contact].a].spin += r.spin_a * impulse;
    y[blocks[r.contact].b].spin -= r.spin_b * impulse;
  }
  /// Its law, others as they are.
  void visit(RollBlock& r) {
    const double most = blocks[r.contact].impulse[0];
    r.before = r.impulse;
    if (most == 0.0 && norm2(r.impulse) == 0.0) return;
    const Vec3 u = transposed_times(r.spin_a, y[blocks[r.contact].a].spin) -
                   transposed_times(r.spin_b, y[blocks[r.contact].b].spin);
    Vec3 now = zero3();
    if (r.wn > 0.0) now[0] = std::clamp(r.impulse[0] - u[0] / r.wn, -most, most);
    if (r.wt > 0.0) {
      const double t1 = r.impulse[1] - u[1] / r.wt, t2 = r.impulse[2] - u[2] / r.wt,
                   size = std::sqrt(t1 * t1 + t2 * t2), part = size > most ? most / size : 1.0;
      now[1] = t1 * part;
      now[2] = t2 * part;
    }
    give(r, now - r.impulse);
    r.impulse = now;
  }

  void add_scalars() {
    space.scalars.clear();
    for (const ScalarEnd& end : island.ends) {
      const IslandBody& b = island.bodies[end.body];
      space.scalars.push_back({end.body, end.force * std::sqrt(b.inverse_mass), transposed_times(b.root, end.moment)});
    }
    for (IslandScalar& s : island.scalars) s.impulse = s.is_bounded() ? std::clamp(s.start, s.low, s.high) : 0.0;
  }
  void give(const IslandScalar& s, double impulse) {
    for (std::uint32_t k = s.first_end; k < s.last_end; k++) {
      const ScalarBlock& end = space.scalars[k];
      y[end.body].centre += end.centre * impulse;
      y[end.body].spin += end.spin * impulse;
    }
  }
  /// One within bounds, others as they are; returns the change [m/s].
  double visit(IslandScalar& s) {
    double u = s.bias;
    for (std::uint32_t k = s.first_end; k < s.last_end; k++) {
      const ScalarBlock& end = space.scalars[k];
      u += dot(end.centre, y[end.body].centre) + dot(end.spin, y[end.body].spin);
    }
    const double by = std::clamp(s.impulse - u / s.w, s.low, s.high) - s.impulse;
    give(s, by);
    s.impulse += by;
    return std::fabs(by) * s.w;
  }

  Vec3 velocity(const ContactBlock& c) const {
    const Scaled &a = y[c.a], &b = y[c.b];
    const Vec3 centre = a.centre * c.by_a - b.centre * c.by_b;
    Mat3 rows;
    for (int k = 0; k < 3; k++) rows[k] = c.frame[k] * centre + c.spin_a[k] * a.spin - c.spin_b[k] * b.spin;
    rows = transpose(rows);
    return rows[0] + rows[1] + rows[2] + c.bias;
  }
  void give(const ContactBlock& c, Vec3 impulse) {
    Scaled &a = y[c.a], &b = y[c.b];
    const Vec3 p = c.frame * impulse;
    a.centre += p * c.by_a;
    b.centre -= p * c.by_b;
    a.spin += c.spin_a * impulse;
    b.spin -= c.spin_b * impulse;
  }
  /// Coulomb's law of one contact, others as they are; returns the largest change [m/s].
  double visit(ContactBlock& c) {
    const Vec3 u = velocity(c), old = c.impulse;
    const double n = std::max(0.0, old[0] - (u[0] + c.compliance * old[0]) * c.i00), dn = n - old[0],
                 bound = c.friction * n;
    if (dn == 0.0 && n == 0.0) return 0.0;
    const double u1 = u[1] + c.w01 * dn, u2 = u[2] + c.w02 * dn;
    double t1 = old[1] - (c.i11 * u1 + c.i12 * u2), t2 = old[2] - (c.i12 * u1 + c.i22 * u2);
    if (t1 * t1 + t2 * t2 > bound * bound) {
      t1 = old[1];
      t2 = old[2];
      for (int i = 0; i < 2; i++) {
        const double d1 = t1 - old[1], d2 = t2 - old[2];
        t1 -= (u1 + c.w11 * d1 + c.w12 * d2) * c.it;
        t2 -= (u2 + c.w12 * d1 + c.w22 * d2) * c.it;
        const double size = std::sqrt(t1 * t1 + t2 * t2);
        if (size <= bound) continue;
        const double part = bound / size;
        t1 *= part;
        t2 *= part;
      }
    }
    c.impulse = vec(n, t1, t2);
    const Vec3 by = c.impulse - old;
    give(c, by);
    return std::max(std::fabs(by[0]) * c.w00, std::max(std::fabs(by[1]), std::fabs(by[2])) * c.wt);
  }
  /// All ties at once, contacts as they are.
  void hold_ties() {
    if (!island.is_tied()) return;
    for (std::size_t i = 0; i < island.bodies.size(); i++) {
      IslandBody& b = island.bodies[i];
      b.v = y[i].centre * std::sqrt(b.inverse_mass);
      b.w = b.root * y[i].spin;
    }
    answer_of_ties(island, loads);
    for (std::size_t i = 0; i < loads.size(); i++) {
      y[i].centre += loads[i].force * std::sqrt(island.bodies[i].inverse_mass);
      y[i].spin += transposed_times(island.bodies[i].root, loads[i].moment);
    }
  }
  double square(const std::vector<Scaled>& of) const {
    Vec3 sum = zero3();
    for (const Scaled& s : of) sum += s.centre * s.centre + s.spin * s.spin;
    return sum[0] + sum[1] + sum[2];
  }
  /// Starts from what is nearest to the solution among multiples of the impulses at hand and what ties answer to them, from none
  /// to all of them.
  void start() {
    double constant = 0.0, soft = 0.0;
    for (const ContactBlock& c : blocks) {
      if (c.impulse[0] == 0.0) continue;
      give(c, c.impulse);
      constant += dot(c.bias, c.impulse);
      soft += c.compliance * c.impulse[0] * c.impulse[0];
    }
    for (const RollBlock& r : rolls) give(r, r.impulse);
    for (const IslandScalar& s : island.scalars) give(s, s.impulse);
    for (IslandTie& t : island.ties) t.impulse = zero3();
    hold_ties();
    for (const IslandTie& t : island.ties) constant -= dot(t.kept * t.wanted, t.impulse);
    for (const IslandScalar& s : island.scalars) constant += s.bias * s.impulse;
    for (std::size_t i = 0; i < y.size(); i++) {
      y[i].centre -= free[i].centre;
      y[i].spin -= free[i].spin;
      constant += dot(free[i].centre, y[i].centre) + dot(free[i].spin, y[i].spin);
    }
    const double whole = square(y) + soft, part = whole > 0.0 ? std::clamp(-constant / whole, 0.0, 1.0) : 0.0;
    for (ContactBlock& c : blocks) c.impulse *= part;
    for (RollBlock& r : rolls) r.impulse *= part;
    for (IslandTie& t : island.ties) t.impulse *= part;
    for (IslandScalar& s : island.scalars) s.impulse *= part;
    for (std::size_t i = 0; i < y.size(); i++) {
      y[i].centre = free[i].centre + y[i].centre * part;
      y[i].spin = free[i].spin + y[i].spin * part;
    }
  }
  double sweep(bool upward, bool all) {
    double most = 0.0;
    const auto one = [&](ContactBlock& c) {
      c.before = c.impulse;
      if (c.idle > 0 && !all) {
        c.idle--;
        return;
      }
      const double change_here = visit(c);
      if (change_here == 0.0 && c.impulse[0] == 0.0) c.idle = idle_sweeps;
      most = std::max(most, change_here);
    };
    if (upward)
      for (ContactBlock& c : blocks) one(c);
    else
      for (std::size_t k = blocks.size(); k-- > 0;) one(blocks[k]);
    for (RollBlock& r : rolls) visit(r);
    for (IslandScalar& s : island.scalars)
      if (s.is_bounded()) most = std::max(most, visit(s));
    hold_ties();
    return most;
  }
  void begin() {
    take_velocities();
    add_blocks();
    add_rolls();
    add_scalars();
    start();
    space.way.assign(y.size(), {});
    space.tie_way.assign(island.ties.size(), zero3());
    space.scalar_way.assign(island.scalars.size(), 0.0);
  }
  /// Notes where a sweep starts.
  void keep() {
    space.before = y;
    space.tie_before.clear();
    for (const IslandTie& t : island.ties) space.tie_before.push_back(t.impulse);
    space.scalar_before.clear();
    for (const IslandScalar& s : island.scalars) space.scalar_before.push_back(s.impulse);
  }
  double change_of_sweep() const {
    double sum = 0.0;
    for (const ContactBlock& c : blocks) {
      const Vec3 d = c.impulse - c.before;
      sum += d[0] * d[0] * c.w00 + (d[1] * d[1] + d[2] * d[2]) * c.wt;
    }
    for (const RollBlock& r : rolls) {
      const Vec3 d = r.impulse - r.before;
      sum += d[0] * d[0] * r.wn + (d[1] * d[1] + d[2] * d[2]) * r.wt;
    }
    for (std::size_t k = 0; k < island.scalars.size(); k++) {
      const IslandScalar& s = island.scalars[k];
      const double d = s.is_bounded() ? s.impulse - space.scalar_before[k] : 0.0;
      sum += d * d * s.w;
    }
    return sum;
  }
  /// Goes on by a part of the last direction; what the sweep changed and that is the next one.
  void carry_on(double part) {
    for (ContactBlock& c : blocks) {
      const Vec3 on = c.way * part;
      c.way = c.impulse - c.before + on;
      c.impulse += on;
    }
    for (RollBlock& r : rolls) {
      const Vec3 on = r.way * part;
      r.way = r.impulse - r.before + on;
      r.impulse += on;
    }
    for (std::size_t k = 0; k < island.ties.size(); k++) {
      const Vec3 on = space.tie_way[k] * part;
      space.tie_way[k] = island.ties[k].impulse - space.tie_before[k] + on;
      island.ties[k].impulse += on;
    }
    for (std::size_t k = 0; k < island.scalars.size(); k++) {
      const double on = space.scalar_way[k] * part;
      space.scalar_way[k] = island.scalars[k].impulse - space.scalar_before[k] + on;
      island.scalars[k].impulse += on;
    }
    for (std::size_t k = 0; k < y.size(); k++) {
      const Vec3 centre = space.way[k].centre * part, spin = space.way[k].spin * part;
      space.way[k] = {y[k].centre - space.before[k].centre + centre, y[k].spin - space.before[k].spin + spin};
      y[k].centre += centre;
      y[k].spin += spin;
    }
  }
};

}  // namespace

SearchReport sweep_search(ContactIsland& island, std::uint32_t most_sweeps, double enough, std::uint32_t at_all) {
  SearchReport report;
  Sweeps s{island};
  s.begin();
  double last_change = 0.0;
  std::uint32_t until = most_sweeps;
  while (report.iterations < until) {
    const bool upward = report.iterations % 2 == 0, last = ++report.iterations == until;
    s.keep();
    const double found = s.sweep(upward, last);
    if (found <= enough) break;
    if (last) {
      if (until >= at_all || found < far * enough) break;
      until += most_sweeps;
    }
    const double change = s.change_of_sweep(), part = last_change > 0.0 ? change / last_change : 0.0;
    s.carry_on(part > 1.0 ? 0.0 : part);
    last_change = change;
  }
  s.hold_ties();
  for (std::size_t k = 0; k < s.blocks.size(); k++) island.contacts[s.order[k]].impulse = s.blocks[k].impulse;
  for (std::size_t k = 0; k < s.rolls.size(); k++) island.rolls[k].impulse = s.rolls[k].impulse;
  apply_impulses(island);
  observe(island);
  report.residual = residual(island);
  return report;
}

}  // namespace pantin
