#include "contacts/gather.hpp"

#include <algorithm>
#include <cmath>

#include "articulates/solve/matrix.hpp"
#include "articulates/solve/project.hpp"
#include "articulates/solve/state.hpp"
#include "base/sets.hpp"
#include "constraints/stiff.hpp"
#include "contacts/motor_bounds.hpp"

namespace pantin {

namespace {

constexpr double calm_way = 2e-3;   // of the reach, in a drift: of a calm island
constexpr double calm_speed = 0.1;  // of what falls by about its reach
constexpr double calm_fall = 0.2;   // of the speed of a drift's fall, which is farther than tiny things are large
constexpr double tolerance_of_fall = 1e-5;  // of the speed that gravity gives in a step: what rests would lose it else
constexpr double finest = 1e-3;             // of what it is else: more would be round-off where next to nothing falls
constexpr double swings_in_step = 0.05;     // of what it ties, (ωh/2)²: a spring that a drift's end finds elsewhere

IslandBody body_of(const BodyState& s, Vec3 velocity, double reach) {
  IslandBody b;
  b.mass = s.mass;
  b.inverse_mass = 1.0 / s.mass;
  Vec3 inertia = s.inertia, turning = vec(1, 1, 1);
  for (int i = 0; i < 3; i++) {
    if (s.inverse_inertia[i] > 0.0) continue;
    inertia[i] = s.mass;  // of no effect
    turning[i] = 0.0;
    b.turns_about_all = false;
  }
  b.inertia = congruent(s.R, inertia);
  for (int i = 0; i < 3; i++) b.root[i] = s.R[i] * std::sqrt(s.inverse_inertia[i]);
  b.inverse_inertia = times_transposed(b.root, b.root);
  if (!b.turns_about_all) b.turning = congruent(s.R, turning);
  b.reach = reach;
  b.v0 = velocity;
  b.w0 = s.w;
  b.x = s.x;
  return b;
}

Mat3 frame_of(Vec3 n) {
  const Vec3 other = std::fabs(n[0]) < 0.6 ? vec(1, 0, 0) : vec(0, 1, 0);
  const Vec3 t1 = direction(other - n * dot(n, other));
  return {{n, t1, cross(n, t1)}};
}

/// Builds islands, thing by thing.
struct Builder {
  Model& model;
  const Articulates& articulates;
  const Contacts& contacts;
  const TouchSettings& settings;
  std::vector<std::int32_t>& index;

  std::int32_t add(TouchIsland& to, std::uint32_t thing) {
    const std::size_t number = number_of(model, thing);
    if (number < index.size() && index[number] >= 0) return index[number];
    const BodyState s = state_of(model, articulates, thing, settings.drifted);
    double reach = 0.0;
    if (!is_point(thing))
      for (const ShapeId shape : model.bodies.at_slot(thing).shapes)
        reach = std::max(reach, reach_of(model.shapes[shape].geometry));
    const auto place = static_cast<std::int32_t>(to.things.size());
    to.problem.bodies.push_back(body_of(s, s.v, reach));
    to.things.push_back(thing);
    to.states.push_back(s);
    to.pulls.emplace_back();
    if (number < index.size()) index[number] = place;
    return place;
  }
  void add_articulate(TouchIsland& to, std::uint32_t number) {
    Articulate& a = *articulates[number];
    if (!settings.drifted) {
      bound_motors(a, model, articulates, contacts.list, to.contacts, settings);
      load(a, model, settings.gravity);
    }
    for (Condition& c : a.conditions) c.gives_way = is_bounded(c);
    place_velocity_constraints(a, settings.step, settings.at, settings.wanted_at);
    std::vector<std::int32_t> places;
    to.first_nodes.push_back(static_cast<std::uint32_t>(to.things.size()));
    for (const Node& n : a.nodes) places.push_back(add(to, n.is_body ? n.slot : point_thing(n.slot)));
    std::vector<IslandTie> ties;
    for (const Row& row : a.rows) {
      IslandTie& t = ties.emplace_back();
      t.a = places[static_cast<std::size_t>(row.a)];
      t.b = row.b < 0 ? -1 : places[static_cast<std::size_t>(row.b)];
      t.lever = row.lever;
      if (row.condition >= 0) {
        const Condition& c = condition(a, row);
        t.kept = is_rigid(row) ? identity33() : c.kept;
        t.wanted = c.wanted;
      }
    }
    for (std::size_t b = 0; b < a.batches.size(); b++)
      for (const RowEnds& end :
           std::span(a.ends).subspan(a.batches[b].first_end, a.batches[b].last_end - a.batches[b].first_end))
        for (std::size_t lane = 0; lane < batch_size; lane++) {
          if (end.to[lane] >= 2 * a.rows.size()) continue;
          IslandTie& t = ties[end.row[lane]];
          (end.to[lane] % 2 == 0 ? t.ra : t.rb) = lane_of(end.r1, lane);
        }
    const bool taut = settings.foresees && is_taut(a);
    for (std::uint32_t k = 0; k < ties.size(); k++) {
      if (is_soft(a.rows[k])) foresee_pull(to, number, k, ties[k], taut);
      if (trace(ties[k].kept) == 0.0 || is_coupled(a.rows[k])) continue;
      to.problem.ties.push_back(ties[k]);
      to.rows.push_back({number, k});
    }
    for (ScalarRow& row : scalar_rows(a, settings.step, settings.wanted_at)) {
      IslandScalar& s = to.problem.scalars.emplace_back();
      s.first_end = static_cast<std::uint32_t>(to.problem.ends.size());
      for (const ScalarRow::End& end : row.ends)
        to.problem.ends.push_back(
            {static_cast<std::uint32_t>(places[static_cast<std::size_t>(end.node)]), end.force, end.moment});
      s.last_end = static_cast<std::uint32_t>(to.problem.ends.size());
      to.scalars.push_back({number, std::move(row)});
    }
  }
  /// Whether its springs pulled as those of a net do, and hardly pushed.
  static bool is_taut(const Articulate& a) {
    constexpr double hardly = 0.1;
    double pulled = 0.0, pushed = 0.0;
    for (const Row& row : a.rows) {
      if (!is_soft(row) || !pulls_by_law(row)) continue;
      const double by = -dot(row.f, direction(row.d1));
      (by > 0.0 ? pulled : pushed) += std::fabs(by);
    }
    return pushed < hardly * pulled;
  }
  /// A soft row pulls as it did last. A spring that would swing fast for the step draws back in it, as far as it is moved: along
  /// its length, and in what is taut across it.
  void foresee_pull(TouchIsland& to, std::uint32_t number, std::uint32_t k, IslandTie tie, bool taut) {
    Articulate& a = *articulates[number];
    const Row& row = a.rows[k];
    if (!pulls_by_law(row)) return add_load(to.pulls, tie, row.f);
    StiffBond& bond = *condition(a, row).stiff;
    const RowContext context{settings.h, mobility(a, row)};
    const DrawnInStep drawn =
        settings.foresees && norm2(row.d1) > 0.0 ? drawn_in_step(bond, row.d1, context) : DrawnInStep{};
    const auto swings = [&](double by) { return by * context.mobility > swings_in_step; };
    const bool any = swings(drawn.along) || (taut && swings(drawn.across));
    tie.pull = any || norm2(row.f) == 0.0 ? pull_at(bond, row.d1).f : row.f;
    add_load(to.pulls, tie, tie.pull);
    const Mat3 along = outer(direction(row.d1), direction(row.d1));
    const auto draws_back = [&](double by, const Mat3& kept) {
      if (!swings(by)) return;
      tie.kept = kept;
      tie.softness = 1.0 / by;
      to.problem.ties.push_back(tie);
      to.rows.push_back({number, k});
    };
    draws_back(drawn.along, along);
    if (taut) draws_back(drawn.across, identity33() - along);
  }
  void add_contact(TouchIsland& to, const Contact& from) {
    IslandContact& c = to.problem.contacts.emplace_back();
    c.a = add(to, from.body_a);
    c.ra = from.at - to.states[static_cast<std::size_t>(c.a)].x;
    if (from.body_b >= 0) {
      c.b = add(to, static_cast<std::uint32_t>(from.body_b));
      c.rb = from.at - to.states[static_cast<std::size_t>(c.b)].x;
    }
    c.frame = frame_of(from.normal);
    c.friction = from.friction;
    c.height = -dot(settings.gravity, from.at);
    c.restitution = from.restitution;
    if (from.rolling > 0.0 || from.spinning > 0.0) {
      IslandRoll& roll = to.problem.rolls.emplace_back();
      roll.contact = static_cast<std::uint32_t>(to.problem.contacts.size() - 1);
      roll.lever = vec(from.spinning, from.rolling, from.rolling);
    }
  }
};

}  // namespace

std::size_t island_number(const Model& model, std::size_t articulates, std::uint32_t thing) {
  const std::uint32_t slot = slot_of(thing);
  const std::int32_t articulate =
      is_point(thing) ? model.points.at_slot(slot).articulate : model.motion[slot].articulate;
  if (articulate >= 0) return static_cast<std::size_t>(articulate);
  return articulates + number_of(model, thing);
}

void TouchIsland::clear() {
  problem.clear();
  things.clear();
  states.clear();
  contacts.clear();
  articulates.clear();
  first_nodes.clear();
  rows.clear();
  scalars.clear();
  held.clear();
  pulls.clear();
  placed.clear();
  rolled.clear();
  missed = solved = false;
  given.clear();
  answered = {};
  heat.clear();
  placed_work = 0.0;
  report = {};
}

std::span<TouchIsland> gather(std::vector<TouchIsland>& space, std::vector<std::int32_t>& index, Workers& workers,
                              Model& model, const Articulates& articulates, const Contacts& contacts,
                              const TouchSettings& settings, const std::vector<char>& used) {
  const std::size_t tied = articulates.size();
  const std::size_t all = model.bodies.slots() + (model.solids ? model.points.slots() : 0);
  Sets sets(tied + all);
  for (std::size_t k = 0; k < used.size(); k++) {
    const Contact& c = contacts.list[k];
    if (used[k] && c.body_b >= 0)
      sets.join(island_number(model, tied, c.body_a), island_number(model, tied, static_cast<std::uint32_t>(c.body_b)));
  }
  std::vector<std::size_t> roots;
  for (std::size_t k = 0; k < used.size(); k++)
    if (used[k]) roots.push_back(sets.find(island_number(model, tied, contacts.list[k].body_a)));
  std::sort(roots.begin(), roots.end());
  roots.erase(std::unique(roots.begin(), roots.end()), roots.end());
  if (space.size() < roots.size()) space.resize(roots.size());
  const std::span<TouchIsland> islands = std::span(space).first(roots.size());
  for (TouchIsland& island : islands) island.clear();
  const auto island_of = [&](std::size_t number) -> TouchIsland* {
    const std::size_t root = sets.find(number);
    const auto found = std::lower_bound(roots.begin(), roots.end(), root);
    return found != roots.end() && *found == root ? &islands[static_cast<std::size_t>(found - roots.begin())] : nullptr;
  };
  index.assign(all, -1);
  for (std::uint32_t i = 0; i < tied; i++)
    if (TouchIsland* island = island_of(i)) island->articulates.push_back(i);
  for (std::size_t k = 0; k < used.size(); k++)
    if (used[k]) island_of(island_number(model, tied, contacts.list[k].body_a))->contacts.push_back(k);
  Builder builder{model, articulates, contacts, settings, index};
  share_islands(workers, islands, [&](TouchIsland& island) {
    for (const std::uint32_t i : island.articulates) builder.add_articulate(island, i);
    double size = infinity;
    for (const std::size_t k : island.contacts) {
      builder.add_contact(island, contacts.list[k]);
      size = std::min(size, contacts.list[k].size);
    }
    island.problem.workers = &workers;
    const double g = norm(settings.gravity), tolerance = contact_tolerance * size / settings.h;
    island.problem.tolerance =
        g > 0.0 ? std::clamp(tolerance_of_fall * g * settings.h, finest * tolerance, tolerance) : tolerance;
    island.problem.enough = swept_tolerance * size / settings.h;
    double mass = 0.0, reach = 0.0;
    for (const IslandBody& b : island.problem.bodies) mass += b.mass, reach += b.mass * b.reach;
    const double length = std::max(size, reach / mass);
    island.problem.calm =
        std::max({calm_way * length / settings.h, calm_speed * std::sqrt(g * length), calm_fall * g * settings.h});
  });
  return islands;
}

}  // namespace pantin
