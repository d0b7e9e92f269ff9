#include "contacts/solve/matrix.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace pantin {

namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>;

std::uint32_t number(std::int32_t body) { return static_cast<std::uint32_t>(body); }

/// Each pair of bodies once, both ways, sorted.
template <class Things>
void add_pairs(const Things& things, std::vector<Pair>& pairs) {
  for (const auto& t : things) {
    if (t.b < 0) continue;
    pairs.emplace_back(number(t.a), number(t.b));
    pairs.emplace_back(number(t.b), number(t.a));
  }
}

RowLists neighbours_of_rows(const ContactIsland& island, bool touching) {
  std::vector<Pair> pairs;
  if (touching) add_pairs(island.contacts, pairs);
  add_pairs(island.ties, pairs);
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  RowLists lists;
  lists.first.push_back(0);
  std::size_t next = 0;
  const auto bodies = static_cast<std::uint32_t>(island.bodies.size());
  for (std::uint32_t body = 0; body < bodies; body++) {
    const std::size_t first = next;
    while (next < pairs.size() && pairs[next].first == body) next++;
    for (std::uint32_t part = 0; part < 2; part++) {
      bool own = false;
      for (std::size_t i = first; i < next; i++) {
        if (!own && pairs[i].second > body) lists.rows.push_back(2 * body + 1 - part), own = true;
        lists.rows.push_back(2 * pairs[i].second);
        lists.rows.push_back(2 * pairs[i].second + 1);
      }
      if (!own) lists.rows.push_back(2 * body + 1 - part);
      lists.first.push_back(static_cast<std::uint32_t>(lists.rows.size()));
    }
  }
  return lists;
}

PairBlocks blocks_of(const ContactIsland& island, const IslandPair& pair) {
  PairBlocks blocks;
  if (pair.b < 0) return blocks;
  for (std::size_t i = 0; i < 4; i++) {
    const std::uint32_t a = island.position[2 * number(pair.a) + i / 2],
                        b = island.position[2 * number(pair.b) + i % 2];
    blocks.block[i] = island.factor.block(std::max(a, b), std::min(a, b));
    blocks.a_below[i] = a > b;
  }
  return blocks;
}

/// arm^ K
Mat3 turned_by(Vec3 arm, const Mat3& K) { return {{cross(arm, K[0]), cross(arm, K[1]), cross(arm, K[2])}}; }

/// Where the matrix is put together: the diagonal, below it and above it.
struct Sums {
  std::vector<Mat3>&diagonal, &lower, &upper;

  /// Adds the entry (row, column) and its opposite, which share a block of the pattern.
  void add(std::uint32_t block, bool below, const Mat3& entry, const Mat3& opposite) {
    lower[block] += below ? entry : opposite;
    upper[block] += below ? opposite : entry;
  }
};

/// Adds what a body's spin (a) and its centre (l) have with themselves.
void add_own(const ContactIsland& island, Sums to, std::int32_t body, const Mat3& ll, const Mat3& al, const Mat3& la,
             const Mat3& aa) {
  const std::uint32_t l = island.position[2 * number(body)], a = island.position[2 * number(body) + 1];
  to.diagonal[l] += ll;
  to.diagonal[a] += aa;
  to.add(island.own[number(body)], a > l, al, la);
}

/// Adds J' K J of a stiffness between two points: of a body with J = [1, -r^ T], T its `turning`. K need not be symmetric.
void add_points(const ContactIsland& island, Sums to, const IslandPair& p, const PairBlocks& blocks, const Mat3& K) {
  const auto before = [](const Mat3& T, Vec3 r, const Mat3& k) { return T * turned_by(r, k); };  // T r^ k
  const auto behind = [&](const Mat3& k, Vec3 r, const Mat3& T) { return transpose(before(T, r, transpose(k))); };
  const Mat3 &Ta = island.bodies[number(p.a)].turning, Ka = before(Ta, p.ra, K), aK = behind(K, p.ra, Ta);
  add_own(island, to, p.a, K, Ka, aK, behind(Ka, p.ra, Ta));
  if (p.b < 0) return;
  const Mat3 &Tb = island.bodies[number(p.b)].turning, Kb = before(Tb, p.rb, K), bK = behind(K, p.rb, Tb);
  add_own(island, to, p.b, K, Kb, bK, behind(Kb, p.rb, Tb));
  const Mat3 entries[4] = {K, bK, Ka, behind(Ka, p.rb, Tb)}, opposites[4] = {K, Kb, aK, behind(Kb, p.ra, Ta)};
  for (std::size_t i = 0; i < 4; i++)
    to.add(blocks.block[i], blocks.a_below[i], entries[i] * -1.0, opposites[i] * -1.0);
}

/// The same of a stiffness between two spins.
void add_turns(const ContactIsland& island, Sums to, const IslandPair& t, const PairBlocks& blocks, const Mat3& K) {
  const Mat3& Ta = island.bodies[number(t.a)].turning;
  add_own(island, to, t.a, zero33(), zero33(), zero33(), Ta * K * transpose(Ta));
  if (t.b < 0) return;
  const Mat3& Tb = island.bodies[number(t.b)].turning;
  add_own(island, to, t.b, zero33(), zero33(), zero33(), Tb * K * transpose(Tb));
  const Mat3 both = Ta * K * transpose(Tb) * -1.0;
  to.add(blocks.block[3], blocks.a_below[3], both, transpose(both));
}

std::size_t updates_of(const RowLists& columns) {
  std::size_t updates = 0;
  for (std::size_t k = 0; k + 1 < columns.first.size(); k++) {
    const std::size_t count = columns.first[k + 1] - columns.first[k];
    updates += count * (count + 1) / 2;
  }
  return updates;
}

bool lay_out_matrix(ContactIsland& island, bool touching, std::size_t most_updates) {
  const RowLists neighbours = neighbours_of_rows(island, touching);
  const std::size_t blocks = neighbours.rows.size() / 2, rows = 2 * island.bodies.size();
  if (blocks * blocks / (2 * rows) > most_updates) return false;  // the least that so many can be, evenly spread
  Elimination order = minimum_degree(neighbours);
  if (updates_of(order.columns) > most_updates) return false;
  island.touching = touching;
  island.position.resize(2 * island.bodies.size());
  for (std::uint32_t k = 0; k < order.order.size(); k++) island.position[order.order[k]] = k;
  island.factor = lay_out(std::move(order.columns));
  island.own.resize(island.bodies.size());
  for (std::size_t i = 0; i < island.own.size(); i++) {
    const std::uint32_t l = island.position[2 * i], a = island.position[2 * i + 1];
    island.own[i] = island.factor.block(std::max(l, a), std::min(l, a));
  }
  island.contact_blocks.clear();
  if (touching)
    for (const IslandContact& c : island.contacts) island.contact_blocks.push_back(blocks_of(island, c));
  island.tie_blocks.clear();
  for (const IslandTie& t : island.ties) island.tie_blocks.push_back(blocks_of(island, t));
  return true;
}

}  // namespace

void lay_out_ties(ContactIsland& island) { lay_out_matrix(island, false, std::numeric_limits<std::size_t>::max()); }
bool lay_out_all(ContactIsland& island, std::size_t most_updates) {
  const bool laid_out = island.factor.rows != 0 && island.touching;
  return laid_out || lay_out_matrix(island, true, most_updates);
}

void set_base(ContactIsland& island, double tie_stiffness) {
  island.base_diagonal.assign(island.factor.rows, zero33());
  island.base_lower.assign(island.factor.below.size(), zero33());
  island.base_upper.assign(island.factor.below.size(), zero33());
  for (std::size_t i = 0; i < island.bodies.size(); i++) {
    const IslandBody& b = island.bodies[i];
    island.base_diagonal[island.position[2 * i]] = identity33() * b.mass;
    island.base_diagonal[island.position[2 * i + 1]] = b.inertia;
  }
  const Sums base{island.base_diagonal, island.base_lower, island.base_upper};
  for (std::size_t k = 0; k < island.ties.size(); k++) {
    const IslandTie& t = island.ties[k];
    const Mat3 K = t.kept * (tie_stiffness / t.w);
    if (t.lever > 0.0)
      add_turns(island, base, t, island.tie_blocks[k], K * (t.lever * t.lever));
    else
      add_points(island, base, t, island.tie_blocks[k], K);
  }
}

void factorise(ContactIsland& island, std::span<const Mat3> stiffness, std::span<const Mat3> roll_stiffness) {
  Factor& f = island.factor;
  std::copy(island.base_diagonal.begin(), island.base_diagonal.end(), f.diagonal.begin());
  std::copy(island.base_lower.begin(), island.base_lower.end(), f.lower.begin());
  std::copy(island.base_upper.begin(), island.base_upper.end(), f.upper.begin());
  for (std::size_t k = 0; k < stiffness.size(); k++)
    add_points(island, {f.diagonal, f.lower, f.upper}, island.contacts[k], island.contact_blocks[k], stiffness[k]);
  for (std::size_t k = 0; k < roll_stiffness.size(); k++) {
    const std::uint32_t c = island.rolls[k].contact;
    add_turns(island, {f.diagonal, f.lower, f.upper}, island.contacts[c], island.contact_blocks[c], roll_stiffness[k]);
  }
  for (std::size_t i = 0; i < f.diagonal.size(); i++)
    f.whole[i] = vec(f.diagonal[i][0][0], f.diagonal[i][1][1], f.diagonal[i][2][2]);
  const std::uint32_t* to = f.target.data();
  for (std::uint32_t k = 0; k < f.rows; k++) f.eliminate(k, to, 0.0);
}

void solve(ContactIsland& island, std::span<const BodyLoad> load, std::span<BodyLoad> change) {
  std::vector<Vec3>& y = island.right_side;
  y.resize(island.factor.rows);
  for (std::size_t i = 0; i < load.size(); i++) {
    y[island.position[2 * i]] = load[i].force;
    y[island.position[2 * i + 1]] = island.bodies[i].turning * load[i].moment;
  }
  for (std::uint32_t k = 0; k < island.factor.rows; k++) island.factor.substitute_forward(k, y.data());
  for (std::uint32_t k = island.factor.rows; k-- > 0;) island.factor.substitute_back(k, y.data());
  for (std::size_t i = 0; i < change.size(); i++)
    change[i] = {y[island.position[2 * i]], y[island.position[2 * i + 1]]};
}

}  // namespace pantin
