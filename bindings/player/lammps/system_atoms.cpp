#include "player/lammps/system.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "forces/forces.hpp"
#include "measure/measure.hpp"
#include "player/lammps/refused.hpp"

namespace pantin::player {
namespace {

constexpr std::size_t most_types = 300;

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

std::string told_attributes(const LammpsSystem& system) {
  std::string all;
  for (const std::string& name : system.attributes) all += " and '" + name + "'";
  return all;
}

double extent(const World& world, const Body& body) {
  double most = 0.0;
  for (PointId a : body.points)
    for (PointId b : body.points) most = std::max(most, norm(world.points[a].position - world.points[b].position));
  return most;
}

/// Of each particle in a group that fields act on.
std::map<ParticleId, std::vector<FieldId>> fields_of_groups(const World& world) {
  std::map<ParticleId, std::vector<FieldId>> found;
  for (FieldId id : world.fields.ids()) {
    const Field& field = world.fields[id];
    if (!field.enabled || !field.group) continue;
    const Things things = things_of(world, AnyId(field.group));
    std::set<ParticleId> members;
    for (BodyId body : things.bodies)
      for (PointId point : world.bodies[body].points) members.insert(world.points[point].particle);
    for (PointId point : things.free_points) members.insert(world.points[point].particle);
    for (ParticleId member : members) found[member].push_back(id);
  }
  return found;
}

}  // namespace

LammpsSystem lammps_atoms(const World& world) {
  LammpsSystem made;
  made.attributes = attributes_read(world);
  made.atoms = world.particles.ids();
  require(!made.atoms.empty(), "there is no particle that LAMMPS could move");
  std::vector<std::uint32_t> body_number(world.bodies.slots(), 0);
  for (BodyId id : world.bodies.ids())
    if (world.bodies[id].points.size() > 1) {
      made.bodies.push_back(id);
      made.body_extent = std::max(made.body_extent, extent(world, world.bodies[id]));
      body_number[id.slot - 1] = static_cast<std::uint32_t>(made.bodies.size());
    }
  const auto groups = fields_of_groups(world);
  std::map<std::pair<std::vector<double>, std::vector<FieldId>>, int> known;
  for (ParticleId id : made.atoms) {
    const Particle& particle = world.particles[id];
    const Point& point = world.points[particle.points[0]];
    made.body_of.push_back(point.body ? body_number[point.body.slot - 1] : 0);
    AtomType type{particle.family, point.mass, {}, {}, 0};
    for (const std::string& name : made.attributes) type.values.push_back(attribute(world, id, name).value_or(0.0));
    if (const auto in = groups.find(id); in != groups.end()) type.of_group = in->second;
    std::vector<double> key = {static_cast<double>(type.family.slot), merged(type.mass)};
    for (double value : type.values) key.push_back(merged(value));
    const auto [at, is_new] = known.try_emplace({key, type.of_group}, static_cast<int>(made.types.size()) + 1);
    if (is_new) made.types.push_back(std::move(type));
    require(made.types.size() <= most_types, "there are more than ", most_types, " kinds of particles, by family, mass",
            told_attributes(made), ": LAMMPS has a type for each; give these fewer values, as by rounding them");
    made.type_of.push_back(at->second);
    made.types[static_cast<std::size_t>(at->second) - 1].count++;
  }
  return made;
}

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

double merged(double value) {
  if (value == 0.0 || !std::isfinite(value)) return value;
  constexpr double digits = 1e10;
  const double size = std::pow(10.0, std::floor(std::log10(std::abs(value))));
  return std::round(value / size * digits) / digits * size;
}

std::string describe(const World& world, const LammpsSystem& system, const AtomType& type) {
  std::string all = type.family ? world.families[type.family].name : std::string("of no family");
  for (std::size_t i = 0; i < system.attributes.size(); i++)
    all += text(", ", system.attributes[i], " ", type.values[i]);
  return all;
}

}  // namespace pantin::player
