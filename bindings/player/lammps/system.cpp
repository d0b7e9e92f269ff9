#include "player/lammps/system.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "forces/forces.hpp"
#include "measure/measure.hpp"
#include "player/lammps/formula.hpp"
#include "player/lammps/near_distances.hpp"
#include "player/lammps/refused.hpp"
#include "player/lammps/system_fields.hpp"

namespace pantin::player {
namespace {

constexpr std::size_t most_types = 300, most_pair_tables = 1000, most_bond_tables = 500;
constexpr std::size_t most_bond_points = std::size_t{1} << 23;

/// Attributes that laws at work read, but for the mass.
std::vector<std::string> attributes_read(const World& world) {
  std::set<std::string> names;
  each_force_element(world, [&](const ForceElement& row) {
    if (!row.enabled) return;
    for (const Input& input : inputs_of_law(*row.law))
      if (input.role == Role::attribute && input.name != "mass") names.insert(input.name);
    require(!names.contains("age") && !names.contains("lifetime"), place_of(row),
            ": it reads the age of particles, which LAMMPS has not; make it a number");
    if (row.law->touching) names.insert("radius");
  });
  return {names.begin(), names.end()};
}

/// Values that differ by less than this count as one: round-off of what was measured in the scene.
double merged(double value) {
  if (value == 0.0 || !std::isfinite(value)) return value;
  constexpr double digits = 1e10;
  const double size = std::pow(10.0, std::floor(std::log10(std::abs(value))));
  return std::round(value / size * digits) / digits * size;
}

/// Makes the system piece by piece.
class SystemMaker {
 public:
  SystemMaker(const World& world, double error) : world_(world) { made_.error = error; }

  LammpsSystem make() {
    made_.attributes = attributes_read(world_);
    list_atoms();
    near_.emplace(world_, made_);
    made_.nearest = near_->nearest();
    for (ConnectionId id : world_.connections.ids())
      if (world_.connections[id].enabled) note(world_.connections[id]);
    settle_exclusions();
    for (InteractionId id : world_.interactions.ids())
      if (world_.interactions[id].enabled) add(world_.interactions[id]);
    add_bonds();
    add_fields(world_, made_);
    note_sizes();
    return std::move(made_);
  }

 private:
  using Key = std::vector<double>;

  /// Connections of one law and equal values.
  struct BondKind {
    const Connection* first = nullptr;
    std::vector<double> lengths;  // [m]
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;
  };

  const World& world_;
  LammpsSystem made_;
  std::vector<std::uint32_t> atom_of_;  // (slots of particles)
  std::optional<NearDistances> near_;
  double kinetic_ = 0.0;  // [J] the largest of an atom
  std::map<const Law*, std::string> identities_;
  std::map<std::pair<std::string, Key>, std::size_t> pair_tables_;
  std::map<std::pair<std::string, Key>, BondKind> bond_kinds_;

  void list_atoms() {
    made_.atoms = world_.particles.ids();
    require(!made_.atoms.empty(), "there is no particle that LAMMPS could move");
    atom_of_.assign(world_.particles.slots(), 0);
    std::vector<std::uint32_t> body_number(world_.bodies.slots(), 0);
    for (BodyId id : world_.bodies.ids())
      if (world_.bodies[id].points.size() > 1) {
        made_.bodies.push_back(id);
        body_number[id.slot - 1] = static_cast<std::uint32_t>(made_.bodies.size());
      }
    const auto groups = fields_of_groups();
    std::map<std::pair<Key, std::vector<FieldId>>, int> known;
    for (ParticleId id : made_.atoms) {
      const Particle& particle = world_.particles[id];
      const Point& point = world_.points[particle.points[0]];
      atom_of_[id.slot - 1] = static_cast<std::uint32_t>(made_.type_of.size());
      made_.body_of.push_back(point.body ? body_number[point.body.slot - 1] : 0);
      AtomType type{particle.family, point.mass, {}, {}, 0};
      for (const std::string& name : made_.attributes) type.values.push_back(attribute(world_, id, name).value_or(0.0));
      if (const auto in = groups.find(id); in != groups.end()) type.of_group = in->second;
      Key key = {static_cast<double>(type.family.slot), merged(type.mass)};
      for (double value : type.values) key.push_back(merged(value));
      const auto [at, is_new] = known.try_emplace({key, type.of_group}, static_cast<int>(made_.types.size()) + 1);
      if (is_new) made_.types.push_back(std::move(type));
      require(made_.types.size() <= most_types, "there are more than ", most_types,
              " kinds of particles, by family, mass", told_attributes(),
              ": LAMMPS has a type for each; give these fewer values, as by rounding them");
      made_.type_of.push_back(at->second);
      made_.types[static_cast<std::size_t>(at->second) - 1].count++;
    }
    for (ParticleId id : made_.atoms)
      kinetic_ =
          std::max(kinetic_, 0.5 * world_.points[world_.particles[id].points[0]].mass * norm2(velocity(world_, id)));
    for (BodyId id : made_.bodies) made_.body_extent = std::max(made_.body_extent, extent(world_.bodies[id]));
  }

  std::string told_attributes() const {
    std::string all;
    for (const std::string& name : made_.attributes) all += " and '" + name + "'";
    return all;
  }

  double extent(const Body& body) const {
    double most = 0.0;
    for (PointId a : body.points)
      for (PointId b : body.points) most = std::max(most, norm(world_.points[a].position - world_.points[b].position));
    return most;
  }

  /// Of each particle in a group that fields act on.
  std::map<ParticleId, std::vector<FieldId>> fields_of_groups() const {
    std::map<ParticleId, std::vector<FieldId>> found;
    for (FieldId id : world_.fields.ids()) {
      const Field& field = world_.fields[id];
      if (!field.enabled || !field.group) continue;
      const Things things = things_of(world_, AnyId(field.group));
      std::set<ParticleId> members;
      for (BodyId body : things.bodies)
        for (PointId point : world_.bodies[body].points) members.insert(world_.points[point].particle);
      for (PointId point : things.free_points) members.insert(world_.points[point].particle);
      for (ParticleId member : members) found[member].push_back(id);
    }
    return found;
  }

  Box box() const { return {world_.settings.box.value_or(zero3())}; }

  /// Laws that a script wrote alike twice are one.
  std::string identity(const std::shared_ptr<const Law>& law) {
    const auto [at, is_new] = identities_.try_emplace(law.get(), "");
    if (!is_new) return at->second;
    const auto name_of = [](const Input& input) {
      return text(input.name, ':', static_cast<int>(input.role), ':', static_cast<int>(input.who));
    };
    try {
      at->second = formula(law->graph, law->force[0], FormulaFor::lepton, name_of);
      if (law->energy != no_expression)
        at->second += " " + formula(law->graph, law->energy, FormulaFor::lepton, name_of);
    } catch (const Error&) { at->second = text("law ", identities_.size()); }
    for (const Parameter& p : law->parameters) at->second += " " + p.name;
    return at->second;
  }

  /// The table of a law between two types, the first of them what the law calls a.
  std::size_t pair_table(const Interaction& row, const std::vector<double>& near, std::size_t a, std::size_t b) {
    const AtomType &first = made_.types[a], &second = made_.types[b];
    const auto value = [&](int who, const std::string& name) {
      return attribute_of(made_, who == 0 ? first : second, name);
    };
    double cutoff = row.law->cutoff;
    if (row.law->touching) cutoff = std::min(cutoff, value(0, "radius") + value(1, "radius"));
    Key key = row.parameters;
    for (const Input& input : inputs_of_law(*row.law))
      if (input.role == Role::attribute) key.push_back(merged(value(input.who, input.name)));
    key.push_back(cutoff);
    const auto [at, is_new] = pair_tables_.try_emplace({identity(row.law), key}, made_.pair_tables.size());
    if (!is_new) return at->second;
    require(made_.pair_tables.size() < most_pair_tables, place_of(row), ": it needs more than ", most_pair_tables,
            " tables, one for each two kinds of particles; round the values that it reads");
    LawOfDistance law(place_of(row), *row.law, row.parameters, value);
    TableWish wish;
    std::ranges::copy_if(near, std::back_inserter(wish.distances), [&](double r) { return r < 0.98 * cutoff; });
    if (wish.distances.empty()) wish.distances.push_back(0.9 * cutoff);
    wish.to = cutoff;
    wish.kinetic = kinetic_;
    wish.error = made_.error;
    LawTable table = make_table(law, wish);
    made_.pair_tables.push_back({text("PAIR", made_.pair_tables.size() + 1), place_of(row), std::move(table),
                                 law.has_energy(), lepton(*row.law, row.parameters, value)});
    return at->second;
  }

  /// The energy as a formula of r, or empty where it cannot be one.
  template <class ValueOf>
  static std::string lepton(const Law& law, const std::vector<double>& parameters, const ValueOf& value) {
    if (law.energy == no_expression) return "";
    try {
      return formula(law.graph, law.energy, FormulaFor::lepton, [&](const Input& input) {
        double x = 0.0;
        if (input.role == Role::attribute) x = value(input.who, input.name);
        for (std::size_t i = 0; input.role == Role::parameter && i < parameters.size(); i++)
          if (law.parameters[i].name == input.name) x = parameters[i];
        return x < 0.0 ? "(" + to_text(x) + ")" : to_text(x);
      });
    } catch (const Error&) { return ""; }
  }

  void add(const Interaction& row) {
    std::vector<PairCoefficient> list;
    std::set<std::pair<int, int>> taken;
    const std::vector<double> near = near_->of(row);
    for (std::size_t a = 0; a < made_.types.size(); a++)
      for (std::size_t b = 0; b < made_.types.size(); b++) {
        if (made_.types[a].family != row.a || made_.types[b].family != row.b) continue;
        const int low = static_cast<int>(std::min(a, b)) + 1, high = static_cast<int>(std::max(a, b)) + 1;
        if (taken.insert({low, high}).second) list.push_back({low, high, pair_table(row, near, a, b)});
      }
    if (list.empty()) return;
    const auto is_free = [&](const PairStyle& style) {
      return std::ranges::none_of(style.coefficients, [&](const PairCoefficient& c) {
        return taken.contains({c.a, c.b});
      });
    };
    auto style = std::ranges::find_if(made_.pair_styles, is_free);
    if (style == made_.pair_styles.end()) style = made_.pair_styles.insert(style, PairStyle{});
    style->coefficients.insert(style->coefficients.end(), list.begin(), list.end());
  }

  /// LAMMPS leaves the same pairs out of all laws. Those that leave out fewer may leave out as many where they act on none of
  /// these.
  void settle_exclusions() {
    for (InteractionId id : world_.interactions.ids())
      if (world_.interactions[id].enabled)
        made_.exclude = std::max(made_.exclude, world_.interactions[id].law->exclude);
    std::vector<std::vector<std::uint32_t>> bonded;
    for (InteractionId id : world_.interactions.ids()) {
      const Interaction& row = world_.interactions[id];
      if (!row.enabled || row.law->exclude == made_.exclude) continue;
      if (bonded.empty()) bonded = bonded_atoms();
      for (std::uint32_t a = 0; a < bonded.size(); a++)
        require(!acts_beyond(row, a, bonded), place_of(row), ": exclude = ", row.law->exclude, " here and ",
                made_.exclude, " elsewhere, and LAMMPS leaves the same pairs out of all laws; give all the same");
    }
  }

  std::vector<std::vector<std::uint32_t>> bonded_atoms() const {
    std::vector<std::vector<std::uint32_t>> list(made_.atoms.size());
    for (const auto& [key, kind] : bond_kinds_)
      for (const auto& [a, b] : kind.ends) {
        list[a].push_back(b);
        list[b].push_back(a);
      }
    return list;
  }

  FamilyId family_of(std::uint32_t atom) const { return world_.particles[made_.atoms[atom]].family; }

  /// Whether a law acts between an atom and one that others would leave out.
  bool acts_beyond(const Interaction& row, std::uint32_t atom,
                   const std::vector<std::vector<std::uint32_t>>& bonded) const {
    if (family_of(atom) != row.a) return false;
    std::vector<std::uint32_t> reached = {atom};
    std::size_t edge = 0;
    for (int away = 1; away <= made_.exclude; away++) {
      const std::size_t end = reached.size();
      for (; edge < end; edge++)
        for (std::uint32_t next : bonded[reached[edge]])
          if (std::ranges::find(reached, next) == reached.end()) {
            if (away > row.law->exclude && family_of(next) == row.b) return true;
            reached.push_back(next);
          }
    }
    return false;
  }

  const AtomType& type_at(ParticleId id) const {
    return made_.types[static_cast<std::size_t>(made_.type_of[atom_of_[id.slot - 1]]) - 1];
  }

  void note(const Connection& row) {
    Key key;
    for (double value : row.parameters) key.push_back(merged(value));
    for (const Input& input : inputs_of_law(*row.law))
      if (input.role == Role::attribute)
        key.push_back(merged(attribute_of(made_, type_at(row.particles[input.who]), input.name)));
    BondKind& kind = bond_kinds_[{identity(row.law), key}];
    if (!kind.first) kind.first = &row;
    const double length = norm(box().nearest(position(world_, row.particles[1]) - position(world_, row.particles[0])));
    require(length > 0.0, place_of(row), ": a connection of no length has no direction in LAMMPS");
    kind.lengths.push_back(length);
    kind.ends.emplace_back(atom_of_[row.particles[0].slot - 1], atom_of_[row.particles[1].slot - 1]);
  }

  void add_bonds() {
    require(bond_kinds_.size() <= most_bond_tables, "there are ", bond_kinds_.size(),
            " kinds of connections, by law and values of its parameters: LAMMPS has a table for each, at most ",
            most_bond_tables, "; give them fewer values, as lengths in steps");
    // LAMMPS has one way and one number of points for all bonds.
    std::size_t points = 256;
    bool straight = false;
    for (const auto& [key, kind] : bond_kinds_) {
      const LawTable table = bond_table(kind, points, false);
      check_stiffness(*kind.first, table);
      points = std::max(points, table.r.size());
      straight = straight || !table.spline;
    }
    for (bool even = false; !even;) {
      made_.bond_tables.clear();
      even = true;
      for (const auto& [key, kind] : bond_kinds_) {
        LawTable table = bond_table(kind, points, straight);
        even = even && table.r.size() == points;
        points = std::max(points, table.r.size());
        require(points * bond_kinds_.size() <= most_bond_points, place_of(*kind.first), ": tables of ",
                bond_kinds_.size(), " kinds of connections, each of ", points,
                " points, are too large; ask for a larger --error");
        add(kind, std::move(table));
      }
    }
    for (const auto& [key, kind] : bond_kinds_) {
      const int type = static_cast<int>(std::distance(bond_kinds_.begin(), bond_kinds_.find(key))) + 1;
      for (const auto& [a, b] : kind.ends) made_.bonds.push_back({type, a, b});
      made_.longest_bond = std::max(made_.longest_bond, std::ranges::max(kind.lengths));
    }
  }

  auto value_at(const Connection& row) const {
    return [this, &row](int who, const std::string& name) {
      return attribute_of(made_, type_at(row.particles[static_cast<std::size_t>(who)]), name);
    };
  }

  LawTable bond_table(const BondKind& kind, std::size_t points, bool straight) const {
    const Connection& row = *kind.first;
    require(!std::isfinite(row.law->cutoff) || row.law->remade, place_of(row),
            ": a connection whose law ends at a cutoff is none that LAMMPS has; give it no cutoff");
    LawOfDistance law(place_of(row), *row.law, row.parameters, value_at(row));
    TableWish wish{TableOver::distance, kind.lengths};
    wish.points = points;
    wish.straight = straight;
    wish.kinetic = kinetic_;
    wish.error = made_.error;
    return make_table(law, wish);
  }

  void add(const BondKind& kind, LawTable table) {
    const Connection& row = *kind.first;
    made_.bond_tables.push_back({text("BOND", made_.bond_tables.size() + 1), place_of(row), std::move(table),
                                 row.law->energy != no_expression, lepton(*row.law, row.parameters, value_at(row))});
  }

  /// What Pantin would solve with its articulate LAMMPS does in explicit steps, which diverge from 4 on.
  void check_stiffness(const Connection& row, const LawTable& table) const {
    const double h = world_.settings.step, rate2 = table.stiffness * (1.0 / type_at(row.particles[0]).mass +
                                                                      1.0 / type_at(row.particles[1]).mass);
    require(h * h * rate2 < 4.0, place_of(row), ": a spring of ", rounded(table.stiffness),
            " N/m is too stiff for LAMMPS' steps of ", h,
            " s, which are explicit; try --set scene.step=", rounded(1.0 / std::sqrt(rate2)));
  }

  /// What sums of energies and forces come to, whatever their signs.
  void note_sizes() {
    double usual = 0.0;
    for (const LammpsTable& t : made_.pair_tables) usual = std::max(usual, t.table.usual_energy);
    made_.energy_size = usual * near_->pairs();
    for (const LammpsBond& bond : made_.bonds)
      made_.energy_size += made_.bond_tables[static_cast<std::size_t>(bond.type) - 1].table.usual_energy;
    for (const auto* list : {&made_.pair_tables, &made_.bond_tables})
      for (const LammpsTable& t : *list) made_.usual_force = std::max(made_.usual_force, t.table.usual_force);
  }
};

}  // namespace

LammpsSystem lammps_system(const World& world, double error) { return SystemMaker(world, error).make(); }

std::vector<Vec3> boxes_away(const World& world, const LammpsSystem& system) {
  std::vector<Vec3> away(system.atoms.size(), zero3());
  if (!world.settings.box) return away;
  std::vector<std::int64_t> first(system.bodies.size() + 1, -1);
  for (std::size_t i = 0; i < away.size(); i++) {
    std::int64_t& leader = first[system.body_of[i]];
    if (system.body_of[i] > 0 && leader >= 0) {
      away[i] = away[static_cast<std::size_t>(leader)];
      continue;
    }
    leader = static_cast<std::int64_t>(i);
    const Vec3 x = position(world, system.atoms[i]), edge = *world.settings.box;
    for (int k = 0; k < 3; k++) away[i][k] = edge[k] * std::floor(x[k] / edge[k]);
  }
  return away;
}

double attribute_of(const LammpsSystem& system, const AtomType& type, const std::string& name) {
  if (name == "mass") return type.mass;
  const auto at = std::ranges::find(system.attributes, name) - system.attributes.begin();
  return type.values[static_cast<std::size_t>(at)];
}

std::vector<Input> inputs_of_law(const Law& law) {
  std::vector<Expr> outputs = law.force;
  if (law.energy != no_expression) outputs.push_back(law.energy);
  return law.graph.inputs_of(outputs);
}

std::string describe(const World& world, const LammpsSystem& system, const AtomType& type) {
  std::string all = type.family ? world.families[type.family].name : std::string("of no family");
  for (std::size_t i = 0; i < system.attributes.size(); i++)
    all += text(", ", system.attributes[i], " ", type.values[i]);
  return all;
}

}  // namespace pantin::player
