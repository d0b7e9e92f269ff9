// Block coordinate descent on the dual of an island's problem,
//
//   Φ(γ, μ) = ½ |y0 + J'γ + T'μ|² + bias·γ + ½ c γ_n² - wanted·μ,   γ_n ≥ 0,  |γ_t| ≤ friction γ_n,
//
// c the compliance, wanted of scalars -bias, μ free but for what bounds scalars: contact by contact, then all ties at once;
// y = M^½ v, so that one row reads a velocity and gives an impulse. From sweep to
// sweep the whole change is carried on along conjugate directions (Silcowitz-Hansen, Niebe, Erleben 2010).
#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "base/subnormals.hpp"
#include "contacts/solve/search.hpp"
#include "contacts/solve/ties.hpp"

namespace pantin {

namespace {

constexpr double far = 1e3;  // times what is enough: that goes on
constexpr std::uint8_t between = 2, parts = 3, worlds = 2;

struct Sweeps {
  ContactIsland& island;
  SweepSpace& space = island.sweep_space;
  std::vector<Scaled>&free = space.free, &y = space.y;
  std::vector<ContactBatch>& batches = space.batches;
  std::vector<std::uint32_t>& position = space.position;
  std::vector<RollBlock>& rolls = space.rolls;
  std::vector<BodyLoad> loads = {};
  double change_of_contacts = 0.0;  // [J] of the last sweep

  void take_velocities() {
    free.assign(island.bodies.size() + worlds, {});
    for (std::size_t i = 0; i < island.bodies.size(); i++) {
      const IslandBody& b = island.bodies[i];
      free[i] = {b.v0 * std::sqrt(b.mass), transposed_times(b.root, b.inertia * b.w0)};
    }
    y = free;
  }
  /// Of islands of many contacts, halves that two threads can sweep: by the way that they are widest.
  void divide() {
    constexpr std::size_t many = 3000;  // contacts: two halves take more sweeps than one whole
    space.half.assign(island.bodies.size(), 0);
    if (island.contacts.size() < many) return;
    Vec3 low = vec(infinity, infinity, infinity), high = low * -1.0;
    for (const IslandBody& b : island.bodies)
      for (int k = 0; k < 3; k++) {
        low[k] = std::min(low[k], b.x[k]);
        high[k] = std::max(high[k], b.x[k]);
      }
    int axis = 0;
    for (int k = 1; k < 3; k++)
      if (high[k] - low[k] > high[axis] - low[axis]) axis = k;
    std::vector<double>& along = space.along;
    along.clear();
    for (const IslandBody& b : island.bodies) along.push_back(b.x[axis]);
    const auto median = along.begin() + static_cast<std::ptrdiff_t>(along.size() / 2);
    std::nth_element(along.begin(), median, along.end());
    for (std::size_t i = 0; i < along.size(); i++) space.half[i] = island.bodies[i].x[axis] < *median ? 0 : 1;
    const auto lie_between = std::count_if(island.contacts.begin(), island.contacts.end(),
                                           [&](const IslandContact& c) { return part_of(c) == between; });
    if (4 * static_cast<std::size_t>(lie_between) > island.contacts.size()) space.half.assign(along.size(), 0);
  }
  std::uint32_t number(std::int32_t body) const { return static_cast<std::uint32_t>(body); }
  /// 0 or 1, the half that it is in; 2: between them.
  std::uint8_t part_of(const IslandContact& c) const {
    const std::uint8_t half = space.half[number(c.a)];
    return c.b < 0 || space.half[number(c.b)] == half ? half : between;
  }
  /// Puts contacts of a part, from the lowest up, each into the first batch with room after all that have its bodies. Each half
  /// has a world of its own, which stays 0.
  void arrange(std::uint8_t part) {
    const auto base = static_cast<std::uint32_t>(batches.size());
    const auto bodies = static_cast<std::uint32_t>(island.bodies.size());
    const std::uint32_t world = bodies + part % between;
    std::vector<std::uint32_t>&next = space.next_batch, &room = space.with_room, &occupied = space.occupied;
    next.assign(bodies, base);
    room.resize(base);
    room.push_back(base);
    for (const auto& [height, k] : space.by_height) {
      const IslandContact& c = island.contacts[k];
      if (part_of(c) != part) continue;
      std::uint32_t i = c.b < 0 ? next[number(c.a)] : std::max(next[number(c.a)], next[number(c.b)]);
      while (room[i] != i) i = room[i] = room[room[i]];
      if (i == batches.size()) {
        batches.emplace_back().a.fill(world);
        batches.back().b.fill(world);
        occupied.push_back(0);
        room.push_back(i + 1);
      }
      const std::uint32_t lane = occupied[i]++;
      batches[i].a[lane] = number(c.a);
      batches[i].b[lane] = c.b < 0 ? world : number(c.b);
      if (occupied[i] == batch_size) room[i] = i + 1;
      position[k] = static_cast<std::uint32_t>(batch_size) * i + lane;
      next[number(c.a)] = i + 1;
      if (c.b >= 0) next[number(c.b)] = i + 1;
    }
    space.end[part] = batches.size();
  }
  void arrange() {
    space.by_height.clear();
    for (std::uint32_t k = 0; k < island.contacts.size(); k++)
      space.by_height.emplace_back(island.contacts[k].height, k);
    std::sort(space.by_height.begin(), space.by_height.end());
    divide();
    space.occupied.clear();
    space.with_room.clear();
    batches.clear();
    position.resize(island.contacts.size());
    for (std::uint8_t part = 0; part < parts; part++) arrange(part);
  }
  void fill_lane(ContactBatch& batch, std::size_t lane, const IslandContact& c) {
    for (int k = 0; k < 3; k++) {
      set_lane(batch.frame[k], lane, c.frame[k]);
      set_lane(batch.spin_a[k], lane, cross(c.ra, c.frame[k]));
      if (c.b >= 0) set_lane(batch.spin_b[k], lane, cross(c.rb, c.frame[k]));
    }
    batch.friction[lane] = c.friction;
    batch.compliance[lane] = c.compliance;
    set_lane(batch.bias, lane, c.bias);
    if (c.start[0] > 0.0) set_lane(batch.impulse, lane, c.start);
  }
  /// From moments to what rows read of spins.
  void scale_side(const std::array<std::uint32_t, batch_size>& numbers, Lanes& by, Mat3x4& spin) {
    static const IslandBody world = [] {
      IslandBody body;
      body.inverse_mass = 0.0;
      return body;
    }();
    std::array<const IslandBody*, batch_size> bodies;
    for (std::size_t lane = 0; lane < batch_size; lane++) {
      bodies[lane] = numbers[lane] < island.bodies.size() ? &island.bodies[numbers[lane]] : &world;
      by[lane] = bodies[lane]->inverse_mass;
    }
    by = square_root(by);
    Mat3x4 root;
    for (int k = 0; k < 3; k++)
      root[k] = pack(bodies[0]->root[k], bodies[1]->root[k], bodies[2]->root[k], bodies[3]->root[k]);
    for (int k = 0; k < 3; k++) spin[k] = transposed_times(root, spin[k]);
  }
  void weigh(ContactBatch& c, std::uint32_t count) {
    const Lanes own = c.by_a * c.by_a + c.by_b * c.by_b;
    const auto w = [&](int i, int j) { return dot(c.spin_a[i], c.spin_a[j]) + dot(c.spin_b[i], c.spin_b[j]); };
    c.w00 = own + w(0, 0);
    c.w01 = w(0, 1);
    c.w02 = w(0, 2);
    c.w11 = own + w(1, 1);
    c.w12 = w(1, 2);
    c.w22 = own + w(2, 2);
    for (std::size_t lane = count; lane < batch_size; lane++) c.w00[lane] = c.w11[lane] = c.w22[lane] = 1.0;
    const Lanes by = 1.0 / (c.w11 * c.w22 - c.w12 * c.w12);
    c.i11 = c.w22 * by;
    c.i12 = -c.w12 * by;
    c.i22 = c.w11 * by;
    const Lanes mean = 0.5 * (c.w11 + c.w22), off = 0.5 * (c.w11 - c.w22);
    c.wt = mean + square_root(off * off + c.w12 * c.w12);
    c.i00 = 1.0 / (c.w00 + c.compliance);
    c.it = 1.0 / c.wt;
  }
  void add_batches() {
    arrange();
    for (std::size_t k = 0; k < island.contacts.size(); k++)
      fill_lane(batches[position[k] / batch_size], position[k] % batch_size, island.contacts[k]);
    for (std::size_t i = 0; i < batches.size(); i++) {
      ContactBatch& batch = batches[i];
      scale_side(batch.a, batch.by_a, batch.spin_a);
      scale_side(batch.b, batch.by_b, batch.spin_b);
      weigh(batch, space.occupied[i]);
    }
  }

  void add_rolls() {
    rolls.clear();
    if (island.rolls.empty()) return;
    for (const IslandRoll& r : island.rolls) {
      const IslandContact& c = island.contacts[r.contact];
      RollBlock& block = rolls.emplace_back();
      block.contact = position[r.contact];
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
  std::uint32_t body_a(const RollBlock& r) const { return batches[r.contact / batch_size].a[r.contact % batch_size]; }
  std::uint32_t body_b(const RollBlock& r) const { return batches[r.contact / batch_size].b[r.contact % batch_size]; }
  void give(const RollBlock& r, Vec3 impulse) {
    y[body_a(r)].spin += r.spin_a * impulse;
    y[body_b(r)].spin -= r.spin_b * impulse;
  }
  /// Its law, others as they are.
  void visit(RollBlock& r) {
    const double most = batches[r.contact / batch_size].impulse.x[r.contact % batch_size];
    r.before = r.impulse;
    if (most == 0.0 && norm2(r.impulse) == 0.0) return;
    const Vec3 u = transposed_times(r.spin_a, y[body_a(r)].spin) - transposed_times(r.spin_b, y[body_b(r)].spin);
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

  Vec3x4 packed(const std::array<std::uint32_t, batch_size>& of, Vec3 Scaled::*part) const {
    return pack(y[of[0]].*part, y[of[1]].*part, y[of[2]].*part, y[of[3]].*part);
  }
  void add(const std::array<std::uint32_t, batch_size>& to, Vec3 Scaled::*part, const Vec3x4& change) {
    const std::array<Vec3, batch_size> each = unpack(change);
    for (std::size_t lane = 0; lane < batch_size; lane++) y[to[lane]].*part += each[lane];
  }
  Vec3x4 velocity(const ContactBatch& c) const {
    const Vec3x4 centre = packed(c.a, &Scaled::centre) * c.by_a - packed(c.b, &Scaled::centre) * c.by_b;
    return transposed_times(c.frame, centre) + transposed_times(c.spin_a, packed(c.a, &Scaled::spin)) -
           transposed_times(c.spin_b, packed(c.b, &Scaled::spin)) + c.bias;
  }
  void give(const ContactBatch& c, const Vec3x4& impulse) {
    const Vec3x4 p = c.frame * impulse;
    add(c.a, &Scaled::centre, p * c.by_a);
    add(c.a, &Scaled::spin, c.spin_a * impulse);
    add(c.b, &Scaled::centre, p * -c.by_b);
    add(c.b, &Scaled::spin, c.spin_b * (impulse * -1.0));
  }
  /// From t towards where the law wants it, others as they are, within the bound: two projected steps.
  static void project(const ContactBatch& c, Lanes u1, Lanes u2, Lanes bound, Lanes& t1, Lanes& t2) {
    const Lanes old1 = t1, old2 = t2;
    for (int i = 0; i < 2; i++) {
      const Lanes d1 = t1 - old1, d2 = t2 - old2;
      t1 -= (u1 + c.w11 * d1 + c.w12 * d2) * c.it;
      t2 -= (u2 + c.w12 * d1 + c.w22 * d2) * c.it;
      const Lanes size = square_root(t1 * t1 + t2 * t2), part = size > bound ? bound / size : lanes(1.0);
      t1 *= part;
      t2 *= part;
    }
  }
  /// Coulomb's law of four contacts, others as they are.
  void visit(ContactBatch& c, Lanes& most, Lanes& change) {
    const Vec3x4 u = velocity(c), old = c.impulse;
    const Lanes zero = lanes(0.0), n = larger(old.x - (u.x + c.compliance * old.x) * c.i00, zero), dn = n - old.x,
                bound = c.friction * n;
    if (!any((n > zero) | (old.x != zero))) return;
    const Lanes u1 = u.y + c.w01 * dn, u2 = u.z + c.w02 * dn;
    Lanes t1 = old.y - (c.i11 * u1 + c.i12 * u2), t2 = old.z - (c.i12 * u1 + c.i22 * u2);
    const auto slides = t1 * t1 + t2 * t2 > bound * bound;
    if (any(slides)) {
      Lanes s1 = old.y, s2 = old.z;
      project(c, u1, u2, bound, s1, s2);
      t1 = slides ? s1 : t1;
      t2 = slides ? s2 : t2;
    }
    c.impulse = {n, t1, t2};
    const Vec3x4 by = c.impulse - old, square = by * by;
    give(c, by);
    most = larger(most, larger(square.x * c.w00 * c.w00, larger(square.y, square.z) * c.wt * c.wt));
    change += square.x * c.w00 + (square.y + square.z) * c.wt;
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
    Lanes by_bias = lanes(0.0), by_compliance = lanes(0.0);
    for (const ContactBatch& c : batches) {
      give(c, c.impulse);
      by_bias += dot(c.bias, c.impulse);
      by_compliance += c.compliance * c.impulse.x * c.impulse.x;
    }
    double constant = sum(by_bias);
    for (const RollBlock& r : rolls) give(r, r.impulse);
    for (const IslandScalar& s : island.scalars) give(s, s.impulse);
    for (IslandTie& t : island.ties) t.impulse = zero3();
    hold_ties();
    double by_softness = 0.0;
    for (const IslandTie& t : island.ties) {
      constant -= dot(t.kept * t.wanted, t.impulse);
      by_softness += t.softness * norm2(t.impulse);
    }
    for (const IslandScalar& s : island.scalars) constant += s.bias * s.impulse;
    for (std::size_t i = 0; i < y.size(); i++) {
      y[i].centre -= free[i].centre;
      y[i].spin -= free[i].spin;
      constant += dot(free[i].centre, y[i].centre) + dot(free[i].spin, y[i].spin);
    }
    const double whole = square(y) + sum(by_compliance) + by_softness,
                 part = whole > 0.0 ? std::clamp(-constant / whole, 0.0, 1.0) : 0.0;
    for (ContactBatch& c : batches) c.before = c.impulse = c.impulse * part;
    for (RollBlock& r : rolls) r.impulse *= part;
    for (IslandTie& t : island.ties) t.impulse *= part;
    for (IslandScalar& s : island.scalars) s.impulse *= part;
    for (std::size_t i = 0; i < y.size(); i++) {
      y[i].centre = free[i].centre + y[i].centre * part;
      y[i].spin = free[i].spin + y[i].spin * part;
    }
  }
  struct Swept {
    Lanes most = lanes(0.0), change = lanes(0.0);
  };
  /// Of one part; each contact first goes on by a part of its last direction.
  Swept sweep(std::uint8_t part, bool upward, double on) {
    Swept swept;
    const std::size_t first = part == 0 ? 0 : space.end[part - 1u], last = space.end[part];
    for (std::size_t k = first; k < last; k++) {
      ContactBatch& c = batches[upward ? k : first + last - 1 - k];
      const Vec3x4 by = c.conjugate * on;
      c.conjugate = c.impulse - c.before + by;
      c.impulse += by;
      c.before = c.impulse;
      visit(c, swept.most, swept.change);
    }
    return swept;
  }
  /// Largest change of a velocity at a contact [m/s].
  double sweep(bool upward, double on) {
    std::array<Swept, parts> swept;
    if (!upward) swept[between] = sweep(between, upward, on);
    const auto half = [&](std::size_t part, int) {
      const SubnormalsAreZero subnormals_are_zero;
      swept[part] = sweep(static_cast<std::uint8_t>(part), upward, on);
    };
    if (island.workers != nullptr && space.end[1] > space.end[0])
      island.workers->run(between, half);
    else
      for (const std::size_t part : {0u, 1u}) half(part, 0);
    if (upward) swept[between] = sweep(between, upward, on);
    Swept all = swept[0];
    for (const Swept& s : {swept[1], swept[between]}) {
      all.most = larger(all.most, s.most);
      all.change += s.change;
    }
    change_of_contacts = sum(all.change);
    for (RollBlock& r : rolls) visit(r);
    double found = std::sqrt(largest_lane(all.most));
    for (IslandScalar& s : island.scalars)
      if (s.is_bounded()) found = std::max(found, visit(s));
    hold_ties();
    return found;
  }
  void begin() {
    take_velocities();
    add_batches();
    add_rolls();
    add_scalars();
    start();
    space.conjugate.assign(y.size(), {});
    space.tie_conjugate.assign(island.ties.size(), zero3());
    space.scalar_conjugate.assign(island.scalars.size(), 0.0);
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
    double sum = change_of_contacts;
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
  /// Goes on by a part of the last direction, but for contacts; what the sweep changed and that is the next one.
  void carry_on(double part) {
    for (RollBlock& r : rolls) {
      const Vec3 on = r.conjugate * part;
      r.conjugate = r.impulse - r.before + on;
      r.impulse += on;
    }
    for (std::size_t k = 0; k < island.ties.size(); k++) {
      const Vec3 on = space.tie_conjugate[k] * part;
      space.tie_conjugate[k] = island.ties[k].impulse - space.tie_before[k] + on;
      island.ties[k].impulse += on;
    }
    for (std::size_t k = 0; k < island.scalars.size(); k++) {
      const double on = space.scalar_conjugate[k] * part;
      space.scalar_conjugate[k] = island.scalars[k].impulse - space.scalar_before[k] + on;
      island.scalars[k].impulse += on;
    }
    for (std::size_t k = 0; k < y.size(); k++) {
      const Vec3 centre = space.conjugate[k].centre * part, spin = space.conjugate[k].spin * part;
      space.conjugate[k] = {y[k].centre - space.before[k].centre + centre, y[k].spin - space.before[k].spin + spin};
      y[k].centre += centre;
      y[k].spin += spin;
    }
  }
};

}  // namespace

SearchReport sweep_search(ContactIsland& island, std::uint32_t most_sweeps, double enough, std::uint32_t most_of_all) {
  SearchReport report;
  Sweeps s{island};
  s.begin();
  double last_change = 0.0, on = 0.0;
  std::uint32_t until = most_sweeps;
  while (report.iterations < until) {
    const bool upward = report.iterations % 2 == 0, last = ++report.iterations == until;
    s.keep();
    const double found = s.sweep(upward, on);
    if (found <= enough) break;
    if (last) {
      if (until >= most_of_all || found < far * enough) break;
      until += most_sweeps;
    }
    const double change = s.change_of_sweep(), part = last_change > 0.0 ? change / last_change : 0.0;
    on = part > 1.0 ? 0.0 : part;
    s.carry_on(on);
    last_change = change;
  }
  s.hold_ties();
  for (std::size_t k = 0; k < s.position.size(); k++)
    island.contacts[k].impulse = lane_of(s.batches[s.position[k] / batch_size].impulse, s.position[k] % batch_size);
  for (std::size_t k = 0; k < s.rolls.size(); k++) island.rolls[k].impulse = s.rolls[k].impulse;
  apply_impulses(island);
  observe(island);
  report.residual = residual(island);
  return report;
}

}  // namespace pantin
