#pragma once
// How what is no plain struct is written into an archive and read again: containers of the engine, laws at work, articulates.
#include <algorithm>
#include <array>

#include "articulates/articulate.hpp"
#include "choreography/bonding.hpp"
#include "choreography/conditions.hpp"
#include "choreography/joins_that_met.hpp"
#include "constraints/kind.hpp"
#include "constraints/row_rule.hpp"
#include "constraints/stiff.hpp"
#include "edit/assemble.hpp"
#include "forces/forces.hpp"
#include "laws/check_read.hpp"
#include "laws/curve.hpp"
#include "laws/library.hpp"
#include "model/path.hpp"
#include "shapes/hull.hpp"
#include "shapes/mesh.hpp"
#include "snapshot/archive.hpp"
#include "trees/tree.hpp"
#include "world/world.hpp"

namespace pantin {

inline constexpr const char* wrong_forces = "what laws act on contradicts itself in it";

inline bool all_below(const std::vector<std::uint32_t>& list, std::size_t size) {
  return std::all_of(list.begin(), list.end(), [&](std::uint32_t i) { return i < size; });
}

inline void check_read(const Arranged& x, const Forces& forces) {
  bool good = x.position.size() == x.n && x.connection.size() == x.n && all_below(x.position, x.n) &&
              all_below(x.connection, x.n);
  for (const auto& list : x.sites) good = good && all_below(list, forces.sites.n);
  for (const auto& column : x.parameters) good = good && column.size() >= x.n + Sites::padding;
  for (const auto& phase : x.phases)
    for (const Arranged::Range& range : phase) good = good && range.begin <= range.end && range.end <= x.n;
  require(good, wrong_forces);
}

/// `of_all`, `tiled` as for NeighbourList::set_lists.
inline void check_phases(const std::vector<std::vector<Slab>>& phases, const std::vector<std::vector<char>>& of_all,
                         const std::vector<std::uint32_t>& tiled, const Forces& forces) {
  const std::size_t sites = forces.sites.n;
  const auto is_site = [&](std::uint32_t i) { return i <= sites; };  // the last: the dummy
  require(of_all.size() == phases.size() && std::all_of(tiled.begin(), tiled.end(), is_site), wrong_forces);
  for (std::size_t phase = 0; phase < phases.size(); phase++) {
    require(of_all[phase].size() == phases[phase].size(), wrong_forces);
    for (std::size_t k = 0; k < phases[phase].size(); k++) {
      const Slab& slab = phases[phase][k];
      const std::size_t listed = of_all[phase][k] != 0 ? tiled.size() : slab.own.size();
      bool good = std::all_of(slab.own.begin(), slab.own.end(), is_site);
      for (const NeighbourRow& row : slab.rows)
        good = good && row.site < sites && row.shift < 27 && row.begin <= listed && row.count <= listed - row.begin &&
               row.count % 4 == 0;
      require(good, wrong_forces);
    }
  }
}

/// The insides of classes.
struct StateFields {
  template <class A>
  static void visit_all(A& a, auto&... field) {
    (visit(a, field), ...);
  }

  /// Each slot is alive, or free once.
  template <class Row>
  static void check(const Store<Row>& store) {
    const std::size_t slots = store.slots_.size();
    std::vector<char> taken(slots);
    for (std::size_t slot = 0; slot < slots; slot++) taken[slot] = store.slots_[slot].alive ? 1 : 0;
    bool good = store.generations_.last_.size() >= slots && store.obituaries_.size() <= slots &&
                store.size_ == static_cast<std::size_t>(std::count(taken.begin(), taken.end(), 1));
    for (const std::uint32_t slot : store.free_) good = good && slot < slots && taken[slot]++ == 0;
    for (std::size_t slot = 0; good && slot < slots; slot++)
      good = taken[slot] == 1 && store.slots_[slot].generation <= store.generations_.last_[slot];
    require(good, "a list of things in it contradicts itself");
  }
  /// Rows of the dead are as new.
  template <class A, class Row>
  static void inside(A& a, Store<Row>& store) {
    visit_all(a, store.slots_, store.obituaries_, store.free_, store.generations_.last_, store.size_);
    if constexpr (A::reads) {
      check(store);
      store.rows_.assign(store.slots_.size(), Row{});
    }
    for (std::size_t slot = 0; slot < store.slots_.size(); slot++)
      if (store.slots_[slot].alive) visit(a, store.rows_[slot]);
  }
  template <class A>
  static void inside(A& a, SharedList& list) {
    visit_all(a, list.whole_, list.rest_);
  }
  template <class A>
  static void inside(A& a, Spline& s) {
    visit_all(a, s.x_, s.pieces_, s.start_, s.bins_per_x_, s.integral_);
  }
  static void check(const Spline& s) {
    const std::size_t points = s.x_.size();
    bool good = points >= 2 && s.pieces_.size() == points && s.integral_.size() == points && !s.start_.empty();
    for (const std::uint32_t piece : s.start_) good = good && piece < points;
    require(good, "a table in it contradicts itself");
  }
  static std::shared_ptr<Spline> new_spline() { return std::shared_ptr<Spline>(new Spline()); }
  template <class A>
  static void inside(A& a, Expressions& e) {
    visit_all(a, e.nodes_, e.inputs_, e.splines_, e.known_, e.constants_);
    if constexpr (A::reads) {
      const auto is_node = [&](const auto& known) {
        return known.second >= 0 && static_cast<std::size_t>(known.second) < e.nodes_.size();
      };
      require(std::all_of(e.known_.begin(), e.known_.end(), is_node) &&
                  std::all_of(e.constants_.begin(), e.constants_.end(), is_node),
              "a law in it contradicts itself");
    }
  }
  template <class A>
  static void inside(A& a, Skin& skin) {
    visit_all(a, skin.start_, skin.width_);
  }
  /// But for what is only used while they are arranged.
  template <class A>
  static void inside(A& a, Arranged& x) {
    visit_all(a, x.n, x.sites, x.position, x.connection, x.parameters, x.phases, x.ranges_);
    if constexpr (A::reads) check_read(x, *a.forces);
  }
  template <class A>
  static void inside(A& a, NeighbourList& x) {
    visit_all(a, x.phases_, x.pairs_, x.slots_, x.within_, x.cutoff_, x.reach_, x.least_distance2_, x.shifts_);
    std::vector<std::uint32_t> tiled;
    std::vector<std::vector<char>> of_all;
    if constexpr (!A::reads) {
      tiled = x.tiled();
      for (const std::vector<Slab>& phase : x.phases_)
        for (of_all.emplace_back(); const Slab& slab : phase)
          of_all.back().push_back(!tiled.empty() && slab.list == x.tiled().data() ? 1 : 0);
    }
    visit_all(a, tiled, of_all);
    if constexpr (A::reads) {
      check_phases(x.phases_, of_all, tiled, *a.forces);
      x.set_lists(tiled, of_all);
    }
  }

  /// Blocks are made anew when it runs.
  template <class A>
  static void inside(A& a, LawOnSites& on) {
    bool own_parameters = !on.uniform_.parameters;
    visit_all(a, own_parameters, on.names_, on.asked_);
    if constexpr (!A::reads) return;
    const std::vector<std::string>& names = a.forces->sites.names;
    require(on.names_.size() <= names.size() && std::equal(on.names_.begin(), on.names_.end(), names.begin()),
            wrong_forces);
    on.drop_blocks(own_parameters);
  }
  template <class A>
  static void inside(A& a, Pairs& x) {
    inside(a, static_cast<LawOnSites&>(x));
    visit_all(a, x.neighbours, x.radius_);
    if constexpr (A::reads) require(!x.law().touching || x.radius_ < a.forces->sites.attributes.size(), wrong_forces);
  }
  template <class A>
  static void inside(A& a, Fields& x) {
    inside(a, static_cast<LawOnSites&>(x));
    visit_all(a, x.members_);
    if constexpr (A::reads) require(all_below(x.members_, a.forces->sites.n), wrong_forces);
  }
  template <class A>
  static void inside(A& a, Bonds& x) {
    inside(a, static_cast<LawOnSites&>(x));
    visit_all(a, x.own_parameters_, x.bonds_, x.pull_, x.least2_);
    if constexpr (!A::reads) return;
    const auto count = static_cast<std::size_t>(x.law().count);
    for (std::size_t who = 0; who < count; who++) require(x.bonds_.sites[who].size() == x.bonds_.n, wrong_forces);
    require(x.own_parameters_ == !x.uniform_.parameters &&
                x.bonds_.parameters.size() == (x.own_parameters_ ? x.law().parameters.size() : 0) &&
                (x.pull_.size() == 0 || x.pull_.size() >= x.bonds_.n),
            wrong_forces);
  }
};

template <class A, class T>
requires requires(A& a, T& value) { StateFields::inside(a, value); }
void visit_own(A& a, T& value) { StateFields::inside(a, value); }

// Structs with a base. A test holds their lists against their sizes.

inline auto own_fields(WorldData& w) {
  return std::tie(w.settings, w.time, w.steps, w.step_origin, w.step_count, w.stage, w.instant, w.kick_error,
                  w.mean_error, w.error_span, w.sub_steps, w.contacts, w.choreography, w.hands, w.controls, w.mouse,
                  w.input, w.notices, w.breaks, w.log, w.probes, w.random, w.loose_bodies, w.loose_points,
                  w.loose_masses, w.given_by_laws, w.stiffness_unknown, w.ledger, w.nonconservative_work, w.work_check,
                  w.stats, w.error, w.worst, w.work, w.start_energy, w.largest_kinetic, w.worst_energy, w.mortals,
                  w.saved_points, w.saved_motion, w.slopes, w.last_actor, w.last_act, w.pushed, w.locked, w.unchecked,
                  w.integrator_from, w.trouble, w.failure);
}
inline auto own_fields(Articulate& a) {
  return std::tie(a.plane, a.nodes, a.rows, a.batches, a.ends, a.at_ends, a.row_blocks, a.couplings, a.hubs, a.saved,
                  a.first_row_block, a.rows_on, a.tiles, a.factor, a.right_side, a.f_saved, a.predictor, a.as_tree,
                  a.tree_sought, a.length, a.length_of_motion, a.total_mass, a.all_rigid, a.angular, a.loop_free,
                  a.soft_constraint, a.breakable, a.nonconservative, a.attracts, a.forbids_nothing, a.pulled, a.serial);
}
inline auto own_fields(Connection& c) {
  return std::tie(c.particles, c.count, c.positions, c.max_force, c.max_length, c.asked, c.solve, c.too_stiff,
                  c.tension);
}
inline auto own_fields(Interaction& i) { return std::tie(i.a, i.b, i.told_idle); }
inline auto own_fields(Field& f) { return std::tie(f.family, f.group, f.told_idle); }

inline Model& base_of(WorldData& w) { return w; }
inline ArticulateState& base_of(Articulate& a) { return a; }
template <class T>
requires std::is_base_of_v<ForceElement, T> ForceElement& base_of(T& element) { return element; }

template <class T>
concept HasBase = std::is_same_v<T, WorldData> || std::is_same_v<T, Articulate> || std::is_same_v<T, Connection> ||
    std::is_same_v<T, Interaction> || std::is_same_v<T, Field>;

template <class A, class T>
requires IsPlain<T> && HasBase<T>
void visit_own(A& a, T& value) {
  visit(a, base_of(value));
  std::apply([&](auto&... field) { (visit(a, field), ...); }, own_fields(value));
}

// What points at something.

inline constexpr std::array all_row_rules = {&rigid_row, &soft_row,  &rod_row,  &axis_row,  &turn_row,   &coupled_row,
                                             &stiff_row, &plane_row, &path_row, &align_row, &attract_row};

template <class A>
void visit_own(A& a, const RowRule*& rule) {
  auto index =
      static_cast<std::uint8_t>(std::find(all_row_rules.begin(), all_row_rules.end(), rule) - all_row_rules.begin());
  require(A::reads || index < all_row_rules.size(), "a fault of Pantin itself: all_row_rules misses a kind of row");
  visit(a, index);
  require(index < all_row_rules.size(), "it names a kind of row that there is not");
  rule = all_row_rules[index];
}
/// Of its constraint, once all is read.
template <class A>
void visit_own(A&, const Path*& path) {
  if constexpr (A::reads) path = nullptr;
}
/// Given anew before each step by its list.
template <class A>
void visit_own(A&, const std::uint32_t*& list) {
  if constexpr (A::reads) list = nullptr;
}
template <class A>
void visit_own(A& a, World*& world) {
  if constexpr (A::reads) world = a.world;
}
template <class A>
void visit_own(A& a, const World*& world) {
  if constexpr (A::reads) world = a.world;
}

/// Its curves come of the connection's law.
template <class A>
void visit_own(A& a, std::shared_ptr<StiffBond>& bond) {
  bool has = bond != nullptr;
  visit(a, has);
  if constexpr (A::reads) bond = has ? std::make_shared<StiffBond>() : nullptr;
  if (!has) return;
  StiffBond& b = *bond;
  StateFields::visit_all(a, b.connection, b.a, b.b, b.solve, b.energy0, b.least2, b.rate0, b.pulls, b.damping_known,
                         b.damping, b.settling, b.mean_rate);
  if constexpr (A::reads)
    if (a.world->connections.alive(b.connection))
      for (auto law = a.world->connections[b.connection].law; law; law = law->also) b.curves.emplace_back(*law);
}
/// None between two steps.
template <class A>
void visit_own(A&, std::vector<std::shared_ptr<TiedKick>>& list) {
  require(list.empty(), "a step is going on");
}

template <class A>
void visit_shared(A& a, Path& path) {
  std::vector<Vec3> positions = path.positions();
  bool smooth = path.smooth(), closed = path.closed();
  StateFields::visit_all(a, positions, smooth, closed);
}
inline void visit_new(Reader& a, std::shared_ptr<const Path>& pointer, std::shared_ptr<void>& known) {
  std::vector<Vec3> positions;
  bool smooth = false, closed = false;
  StateFields::visit_all(a, positions, smooth, closed);
  const auto made = std::make_shared<Path>(positions, smooth, closed);
  pointer = made;
  known = made;
}
inline void visit_new(Reader& a, std::shared_ptr<const Spline>& pointer, std::shared_ptr<void>& known) {
  const auto made = StateFields::new_spline();
  pointer = made;
  known = made;
  visit(a, *made);
  StateFields::check(*made);
}

// Laws at work.

template <class A>
void visit_acting(A& a, ActingElement& element, auto&... rest) {
  StateFields::visit_all(a, element.solved, element.energy, element.at_first, rest...);
}
template <class A, class Acting, class Make>
void visit_elements(A& a, std::vector<Acting>& list, Make make) {
  const std::size_t size = visit_size(a, list.size());
  for (std::size_t i = 0; i < size; i++) {
    std::shared_ptr<const Law> law;
    bool solved = false;
    if constexpr (!A::reads) law = list[i].law, solved = list[i].solved;
    StateFields::visit_all(a, law, solved);
    if constexpr (A::reads) {
      require(law != nullptr, "a law is missing");
      using Made = std::remove_reference_t<decltype(list[0])>;
      if constexpr (std::is_same_v<Made, ActingInteraction>)
        require(law->kind == LawKind::central || law->kind == LawKind::pair, wrong_forces);
      else
        require((law->kind == LawKind::point) == (std::is_same_v<Made, ActingField>), wrong_forces);
      list.push_back(make(law, solved));
    }
    if constexpr (std::is_same_v<Acting, ActingInteraction>)
      visit_acting(a, list[i], list[i].id, list[i].pairs, list[i].bonded);
    else if constexpr (std::is_same_v<Acting, ActingField>)
      visit_acting(a, list[i], list[i].id, list[i].fields);
    else
      visit_acting(a, list[i], list[i].ids, list[i].serials, list[i].bond_list, list[i].bonds);
  }
}
template <class A>
void visit_own(A& a, std::vector<ActingInteraction>& list) {
  visit_elements(a, list,
                 [&](const auto& law, bool) { return ActingInteraction({}, law, *a.forces, *a.world->workers); });
}
template <class A>
void visit_own(A& a, std::vector<ActingField>& list) {
  visit_elements(a, list, [&](const auto& law, bool) { return ActingField({}, law, *a.forces, *a.world->workers); });
}
template <class A>
void visit_own(A& a, std::vector<ActingConnections>& list) {
  visit_elements(a, list, [&](const auto& law, bool solved) {
    return ActingConnections(law, solved, *a.forces, *a.world->workers);
  });
}

// Functions: the engine's own, and those that somebody else keeps.

template <class Signature>
struct EngineFunctions {
  using Types = std::tuple<>;
};
template <>
struct EngineFunctions<void()> {
  using Types = std::tuple<TellMet>;
};
template <>
struct EngineFunctions<void(double)> {
  using Types = std::tuple<BondingAtWork>;
};
template <>
struct EngineFunctions<double()> {
  using Types = std::tuple<MeasureOf>;
};
template <>
struct EngineFunctions<Quat(double)> {
  using Types = std::tuple<TurnedAttitude>;
};

template <class A, class Signature>
void visit_own(A& a, std::function<Signature>& function) {
  using Types = typename EngineFunctions<Signature>::Types;
  constexpr std::uint8_t none = 0, of_outside = 255;
  std::uint8_t kind = function ? of_outside : none;
  const auto each_type = [&](auto use) {
    std::uint8_t number = 1;
    std::apply([&](auto... type) { (use(number++, type), ...); }, Types{});
  };
  if constexpr (!A::reads)
    each_type([&](std::uint8_t number, auto type) {
      if (function.template target<decltype(type)>()) kind = number;
    });
  visit(a, kind);
  if constexpr (A::reads) function = nullptr;
  each_type([&](std::uint8_t number, auto type) {
    if (number != kind) return;
    if constexpr (!A::reads) type = *function.template target<decltype(type)>();
    visit(a, type);
    if constexpr (A::reads) function = type;
  });
  if (kind != of_outside) return;
  auto& keeper = static_cast<FunctionKeeper<Signature>&>(*a.outside);
  if constexpr (A::reads)
    keeper.make(a, function);
  else
    keeper.keep(a, function);
}
template <class A>
void visit_own(A& a, std::function<std::shared_ptr<Law>(std::span<const double>)>& remade) {
  RemadeLaw by;
  bool has = static_cast<bool>(remade);
  visit(a, has);
  if constexpr (!A::reads)
    if (has) by = *remade.template target<RemadeLaw>();
  if (has) visit(a, by);
  if constexpr (A::reads) remade = nullptr;
  if constexpr (A::reads)
    if (has) remade = by;
}
template <class A>
void visit_own(A& a, std::shared_ptr<Called>& called) {
  bool has = called != nullptr;
  visit(a, has);
  if constexpr (A::reads)
    called = has ? a.outside->make_called(a) : nullptr;
  else if (has)
    a.outside->keep_called(a, called);
}

}  // namespace pantin
