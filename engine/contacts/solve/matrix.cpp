#include "contacts/solve/matrix.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "articulates/build/elimination.hpp"
#include "contacts/solve/ties.hpp"

namespace pantin {

namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>;

std::uint32_t number(std::int32_t body) { return static_cast<std::uint32_t>(body); }

/// Each pair of bodies once, both ways, sorted.
template <class Things>
void add_pairs(const Things& things, std::vector<Pair>& pairs) {
  Pair last{};
  for (const auto& t : things) {
    if (t.b < 0 || last == Pair{number(t.a), number(t.b)}) continue;
    last = {number(t.a), number(t.b)};
    pairs.push_back(last);
    pairs.emplace_back(number(t.b), number(t.a));
  }
}

std::vector<Pair> pairs_of(const ContactIsland& island, bool touching) {
  std::vector<Pair> pairs;
  if (touching) add_pairs(island.contacts, pairs);
  add_pairs(island.ties, pairs);
  for (const IslandScalar& s : island.scalars)
    for (const ScalarEnd& one : ends_of(island, s))
      for (const ScalarEnd& other : ends_of(island, s))
        if (one.body != other.body) pairs.emplace_back(one.body, other.body);
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

RowLists neighbours_of(const std::vector<Pair>& pairs, std::uint32_t bodies) {
  RowLists lists;
  lists.first.push_back(0);
  std::size_t next = 0;
  for (std::uint32_t body = 0; body < bodies; body++) {
    for (; next < pairs.size() && pairs[next].first == body; next++) lists.rows.push_back(pairs[next].second);
    lists.first.push_back(static_cast<std::uint32_t>(lists.rows.size()));
  }
  return lists;
}

/// Of both rows of each body, one after the other, from the columns of bodies.
RowLists columns_of_rows(const RowLists& bodies) {
  RowLists columns;
  columns.first.push_back(0);
  for (std::uint32_t k = 0; k + 1 < bodies.first.size(); k++)
    for (std::uint32_t part = 0; part < 2; part++) {
      if (part == 0) columns.rows.push_back(2 * k + 1);
      for (const std::uint32_t below : bodies[k]) {
        columns.rows.push_back(2 * below);
        columns.rows.push_back(2 * below + 1);
      }
      columns.first.push_back(static_cast<std::uint32_t>(columns.rows.size()));
    }
  return columns;
}

PairBlocks blocks_of(const Layout& layout, const IslandPair& pair) {
  PairBlocks blocks;
  if (pair.b < 0) return blocks;
  for (std::size_t i = 0; i < 4; i++) {
    const std::uint32_t a = layout.position[2 * number(pair.a) + i / 2],
                        b = layout.position[2 * number(pair.b) + i % 2];
    blocks.block[i] = layout.factor.block(std::max(a, b), std::min(a, b));
    blocks.a_below[i] = a > b;
  }
  return blocks;
}

/// arm^ K
Mat3 arm_cross(Vec3 arm, const Mat3& K) { return {{cross(arm, K[0]), cross(arm, K[1]), cross(arm, K[2])}}; }

/// Where the matrix is put together: the diagonal, below it and above it.
struct Sums {
  const ContactIsland& island;
  const Layout& layout;
  std::vector<Mat3>&diagonal, &lower, &upper;
  bool symmetric = false;  // nothing is put above the diagonal

  /// Adds the entry (row, column) and its opposite, which share a block of the pattern.
  void add(std::uint32_t block, bool below, const Mat3& entry, const Mat3& opposite) {
    lower[block] += below ? entry : opposite;
    if (!symmetric) upper[block] += below ? opposite : entry;
  }
};

/// Adds what a body's spin (a) and its centre (l) have with themselves.
void add_own(Sums to, std::int32_t body, const Mat3& ll, const Mat3& al, const Mat3& la, const Mat3& aa) {
  const std::uint32_t l = to.layout.position[2 * number(body)], a = to.layout.position[2 * number(body) + 1];
  to.diagonal[l] += ll;
  to.diagonal[a] += aa;
  to.add(to.layout.own[number(body)], a > l, al, la);
}

/// Stiffnesses between points of one pair of bodies, all together: with arms r from a's centre, J = [1, -r^] of a.
struct PairSums {
  Mat3 ll = zero33(), al = zero33(), la = zero33(), aa = zero33();  // Σ K, Σ r^ K, Σ K r^', Σ r^ K r^'

  void add(Vec3 r, const Mat3& K, bool symmetric) {
    const Mat3 rK = arm_cross(r, K);
    ll += K;
    al += rK;
    if (!symmetric) la += transpose(arm_cross(r, transpose(K)));
    aa += transpose(arm_cross(r, transpose(rK)));
  }
};

/// Adds J' K J of all stiffnesses of a pair, whose arms of b are `between` [m] longer than those of a.
void add_sums(Sums to, const IslandPair& p, const PairBlocks& blocks, PairSums s) {
  Vec3 between = p.rb - p.ra;
  if (to.symmetric) s.la = transpose(s.al);
  const auto before = [](const IslandBody& b, const Mat3& m) { return b.turns_about_all ? m : b.turning * m; };
  const auto behind = [](const Mat3& m, const IslandBody& b) { return b.turns_about_all ? m : m * b.turning; };
  const auto longer = [&](const Mat3& m) { return transpose(arm_cross(between, transpose(m))); };
  const IslandBody& a = to.island.bodies[number(p.a)];
  const Mat3 al = before(a, s.al), la = behind(s.la, a);
  add_own(to, p.a, s.ll, al, la, behind(before(a, s.aa), a));
  if (p.b < 0) return;
  const IslandBody& b = to.island.bodies[number(p.b)];
  const Mat3 bl = s.al + arm_cross(between, s.ll), lb = s.la + longer(s.ll);
  const Mat3 ab = s.aa + longer(s.al), ba = s.aa + arm_cross(between, s.la), bb = ab + arm_cross(between, lb);
  const Mat3 of_b = before(b, bl), to_b = behind(lb, b);
  add_own(to, p.b, s.ll, of_b, to_b, behind(before(b, bb), b));
  const Mat3 entries[4] = {s.ll, to_b, al, behind(before(a, ab), b)},
             opposites[4] = {s.ll, of_b, la, behind(before(b, ba), a)};
  for (std::size_t i = 0; i < 4; i++)
    to.add(blocks.block[i], blocks.a_below[i], entries[i] * -1.0, opposites[i] * -1.0);
}

/// The same of one stiffness.
void add_points(Sums to, const IslandPair& p, const PairBlocks& blocks, const Mat3& K) {
  PairSums sums;
  sums.add(p.ra, K, to.symmetric);
  add_sums(to, p, blocks, sums);
}

/// Whether both are of one pair of bodies at one place.
bool are_alike(const IslandPair& one, const IslandPair& other) {
  if (one.a != other.a || one.b != other.b) return false;
  const Vec3 between = one.rb - one.ra;
  return one.b < 0 || norm2(other.rb - other.ra - between) <= 1e-16 * norm2(between);
}

/// The same of stiffnesses of contacts, those of a pair that follow each other at once; what is open has none.
void add_contacts(Sums to, std::span<const PairBlocks> blocks, std::span<const Mat3> stiffness) {
  const std::vector<IslandContact>& contacts = to.island.contacts;
  for (std::size_t k = 0; k < stiffness.size();) {
    PairSums sums;
    bool any = false;
    const std::size_t first = k;
    for (; k < stiffness.size() && are_alike(contacts[first], contacts[k]); k++) {
      const Mat3& K = stiffness[k];
      if (K[0][0] + K[1][1] + K[2][2] == 0.0) continue;
      sums.add(contacts[k].ra, K, to.symmetric);
      any = true;
    }
    if (any) add_sums(to, contacts[first], blocks[first], sums);
  }
}

/// The same of a stiffness between two spins.
void add_turns(Sums to, const IslandPair& t, const PairBlocks& blocks, const Mat3& K) {
  const Mat3& Ta = to.island.bodies[number(t.a)].turning;
  add_own(to, t.a, zero33(), zero33(), zero33(), Ta * K * transpose(Ta));
  if (t.b < 0) return;
  const Mat3& Tb = to.island.bodies[number(t.b)].turning;
  add_own(to, t.b, zero33(), zero33(), zero33(), Tb * K * transpose(Tb));
  const Mat3 both = Ta * K * transpose(Tb) * -1.0;
  to.add(blocks.block[3], blocks.a_below[3], both, transpose(both));
}

/// The same of a stiffness of one number of velocities; `blocks` of each two of its ends.
void add_scalar(Sums to, std::span<const ScalarEnd> ends, std::span<const PairBlocks> blocks, double stiffness) {
  std::size_t pair = 0;
  for (std::size_t i = 0; i < ends.size(); i++) {
    const auto turned = [&](const ScalarEnd& end) { return to.island.bodies[end.body].turning * end.moment; };
    const Vec3 f = ends[i].force * stiffness, m = turned(ends[i]) * stiffness;
    const Vec3 own = turned(ends[i]);
    add_own(to, static_cast<std::int32_t>(ends[i].body), outer(f, ends[i].force), outer(m, ends[i].force),
            outer(f, own), outer(m, own));
    for (std::size_t j = i + 1; j < ends.size(); j++, pair++) {
      const Vec3 of[2] = {f, m}, with[2] = {ends[j].force, turned(ends[j])};
      for (std::size_t k = 0; k < 4; k++) {
        const Mat3 entry = outer(of[k / 2], with[k % 2]);
        to.add(blocks[pair].block[k], blocks[pair].a_below[k], entry, transpose(entry));
      }
    }
  }
}

std::span<const PairBlocks> blocks_of(const Layout& layout, std::size_t& next, const IslandScalar& s) {
  const std::size_t ends = s.last_end - s.first_end, first = next;
  next += ends * (ends - 1) / 2;
  return std::span(layout.scalar_blocks).subspan(first, next - first);
}

std::size_t updates_of(const RowLists& columns) {
  std::size_t updates = 0;
  for (std::size_t k = 0; k + 1 < columns.first.size(); k++) {
    const std::size_t count = columns.first[k + 1] - columns.first[k];
    updates += count * (count + 1) / 2;
  }
  return updates;
}

/// Lays out the factor; false where it would be too dense.
bool lay_out_factor(Layout& layout, std::vector<Pair>&& pairs, std::size_t bodies, std::size_t most_updates) {
  const std::size_t rows = 2 * bodies, blocks = bodies + 2 * pairs.size();
  layout.bodies = 0;
  if (blocks * blocks / (2 * rows) > most_updates) return false;  // the least that so many can be, evenly spread
  const Elimination order =
      minimum_degree(neighbours_of(pairs, static_cast<std::uint32_t>(bodies)), 0, most_updates / 4);
  if (order.order.empty()) return false;
  RowLists columns = columns_of_rows(order.columns);
  if (updates_of(columns) > most_updates) return false;
  layout.position.resize(rows);
  for (std::uint32_t k = 0; k < order.order.size(); k++)
    for (std::uint32_t part = 0; part < 2; part++) layout.position[2 * order.order[k] + part] = 2 * k + part;
  layout.factor = lay_out(std::move(columns));
  layout.own.resize(bodies);
  for (std::size_t i = 0; i < bodies; i++) {
    const std::uint32_t l = layout.position[2 * i], a = layout.position[2 * i + 1];
    layout.own[i] = layout.factor.block(std::max(l, a), std::min(l, a));
  }
  layout.pairs = std::move(pairs);
  layout.bodies = bodies;
  layout.most_updates = most_updates;
  return true;
}

bool lay_out_matrix(const ContactIsland& island, bool touching, std::size_t most_updates, Layout& layout) {
  std::vector<Pair> pairs = pairs_of(island, touching);
  const bool serves =
      layout.bodies == island.bodies.size() && layout.pairs == pairs && layout.most_updates <= most_updates;
  if (!serves && !lay_out_factor(layout, std::move(pairs), island.bodies.size(), most_updates)) return false;
  layout.contact_blocks.clear();
  if (touching)
    for (const IslandContact& c : island.contacts) layout.contact_blocks.push_back(blocks_of(layout, c));
  layout.tie_blocks.clear();
  for (const IslandTie& t : island.ties) layout.tie_blocks.push_back(blocks_of(layout, t));
  layout.scalar_blocks.clear();
  for (const IslandScalar& s : island.scalars) {
    const std::span<const ScalarEnd> ends = ends_of(island, s);
    for (std::size_t i = 0; i < ends.size(); i++)
      for (std::size_t j = i + 1; j < ends.size(); j++)
        layout.scalar_blocks.push_back(blocks_of(
            layout, IslandPair{static_cast<std::int32_t>(ends[i].body), static_cast<std::int32_t>(ends[j].body)}));
  }
  return true;
}

}  // namespace

void lay_out_ties(ContactIsland& island) {
  lay_out_matrix(island, false, std::numeric_limits<std::size_t>::max(), island.ties_alone);
}
bool lay_out_all(ContactIsland& island, std::size_t most_updates) {
  return lay_out_matrix(island, true, most_updates, island.all);
}

void set_base(const ContactIsland& island, Layout& layout) {
  layout.base_diagonal.assign(layout.factor.rows, zero33());
  layout.base_lower.assign(layout.factor.below.size(), zero33());
  layout.base_upper.assign(layout.factor.below.size(), zero33());
  for (std::size_t i = 0; i < island.bodies.size(); i++) {
    const IslandBody& b = island.bodies[i];
    layout.base_diagonal[layout.position[2 * i]] = identity33() * b.mass;
    layout.base_diagonal[layout.position[2 * i + 1]] = b.inertia;
  }
  const Sums base{island, layout, layout.base_diagonal, layout.base_lower, layout.base_upper};
  for (std::size_t k = 0; k < island.ties.size(); k++) {
    const IslandTie& t = island.ties[k];
    const Mat3 K = t.kept * stiffness_of(t);
    if (t.lever > 0.0)
      add_turns(base, t, layout.tie_blocks[k], K * (t.lever * t.lever));
    else
      add_points(base, t, layout.tie_blocks[k], K);
  }
  std::size_t next = 0;
  for (const IslandScalar& s : island.scalars) {
    const std::span<const PairBlocks> blocks = blocks_of(layout, next, s);
    if (!s.is_bounded()) add_scalar(base, ends_of(island, s), blocks, tie_stiffness / s.w);
  }
}

void factorise(const ContactIsland& island, Layout& layout, std::span<const Mat3> stiffness,
               std::span<const Mat3> roll_stiffness, std::span<const double> scalar_stiffness, bool symmetric) {
  Factor& f = layout.factor;
  std::copy(layout.base_diagonal.begin(), layout.base_diagonal.end(), f.diagonal.begin());
  std::copy(layout.base_lower.begin(), layout.base_lower.end(), f.lower.begin());
  if (!symmetric) std::copy(layout.base_upper.begin(), layout.base_upper.end(), f.upper.begin());
  const Sums sums{island, layout, f.diagonal, f.lower, f.upper, symmetric};
  add_contacts(sums, layout.contact_blocks, stiffness);
  for (std::size_t k = 0; k < roll_stiffness.size(); k++) {
    const std::uint32_t c = island.rolls[k].contact;
    add_turns(sums, island.contacts[c], layout.contact_blocks[c], roll_stiffness[k]);
  }
  std::size_t next = 0;
  for (std::size_t k = 0; k < scalar_stiffness.size(); k++) {
    const IslandScalar& s = island.scalars[k];
    const std::span<const PairBlocks> blocks = blocks_of(layout, next, s);
    if (s.is_bounded()) add_scalar(sums, ends_of(island, s), blocks, scalar_stiffness[k]);
  }
  for (std::size_t i = 0; i < f.diagonal.size(); i++)
    f.whole[i] = vec(f.diagonal[i][0][0], f.diagonal[i][1][1], f.diagonal[i][2][2]);
  const std::uint32_t* to = f.target.data();
  if (symmetric)
    for (std::uint32_t k = 0; k < f.rows; k++) f.eliminate_symmetric(k, to);
  else
    for (std::uint32_t k = 0; k < f.rows; k++) f.eliminate(k, to, 0.0);
}

void solve(const ContactIsland& island, Layout& layout, std::span<const BodyLoad> load, std::span<BodyLoad> change) {
  std::vector<Vec3>& y = layout.right_side;
  y.resize(layout.factor.rows);
  for (std::size_t i = 0; i < load.size(); i++) {
    y[layout.position[2 * i]] = load[i].force;
    y[layout.position[2 * i + 1]] = island.bodies[i].turning * load[i].moment;
  }
  for (std::uint32_t k = 0; k < layout.factor.rows; k++) layout.factor.substitute_forward(k, y.data());
  for (std::uint32_t k = layout.factor.rows; k-- > 0;) layout.factor.substitute_back(k, y.data());
  for (std::size_t i = 0; i < change.size(); i++)
    change[i] = {y[layout.position[2 * i]], y[layout.position[2 * i + 1]]};
}

}  // namespace pantin
