// What laws read by name of the particles that they act on.
#include <algorithm>
#include <limits>
#include <numeric>

#include "forces/curves.hpp"
#include "forces/forces_parts.hpp"
#include "world/checks.hpp"

namespace pantin {

namespace {

std::optional<double> stored_attribute(const World& world, ParticleId id, std::string_view name) {
  const Particle& particle = world.particles[awake(world, id)];
  if (name == "mass") return mass(world, id);
  if (name == "radius") return particle.radius.value_or(world.points[particle.points[0]].radius);
  if (name == "age") return world.time - particle.born;
  if (name == "lifetime") return particle.lifetime;
  if (!particle.family) return {};
  const std::ptrdiff_t found = world.families[particle.family].find(name);
  if (found < 0) return {};
  return particle.values[static_cast<std::size_t>(found)];
}

}  // namespace

std::optional<double> attribute(const World& world, ParticleId id, std::string_view name) {
  if (const auto value = curve_value(world, awake(world, id), name, world.time)) return value;
  return stored_attribute(world, id, name);
}

namespace {

/// Throws where a law would read what one of its particles, in the role `who`, has not.
void require_attributes(const World& world, const Sites& sites, const Law& law, std::span<const std::uint32_t> where,
                        std::size_t who) {
  for (const Input& input : inputs_of(law)) {
    if (input.role != Role::attribute || input.who != who) continue;
    for (std::uint32_t site : where) {
      require(sites.particle[site] != Forces::none, law.name, ": it reads '", input.name, "', which the position ",
              internal::to_text(sites.x[site]),
              " m of the world has not; tie a particle, or make it a parameter of the law");
      if (law.called) continue;  // it tells by itself what it reads
      const ParticleId id = world.particles.id_at(sites.particle[site]);
      require(attribute(world, id, input.name).has_value(), law.name, ": it reads '", input.name, "', which ",
              describe(world, id), " has not; give it a family with this attribute");
    }
  }
}

}  // namespace

std::vector<Input> inputs_of(const Law& law) {
  if (law.called) return law.inputs_wanted;
  std::vector<Expr> outputs = law.force;
  if (law.energy != no_expression) outputs.push_back(law.energy);
  return law.graph.inputs_of(outputs);
}

void fill_attributes(const World& world, Forces& forces, std::span<const std::uint32_t> some) {
  Sites& sites = forces.sites;
  forces.followed.resize(sites.names.size(), 0);
  for (std::size_t c = 0; c < sites.names.size(); c++)
    for (std::uint32_t i : some) {
      sites.attributes[c][i] = std::numeric_limits<double>::quiet_NaN();
      if (sites.particle[i] == Forces::none) continue;
      const auto value = stored_attribute(world, world.particles.id_at(sites.particle[i]), sites.names[c]);
      if (value) sites.attributes[c][i] = *value;
      const Curves* curves = world.particles.at_slot(sites.particle[i]).curves.get();
      if (curves && curves->find(sites.names[c])) forces.followed[c] = 1;
    }
}

void check_attributes(const World& world, const Forces& forces, std::span<const std::uint32_t> some) {
  each_element(forces, [&](const ActingElement& a) {
    for (std::size_t who = 0; who < static_cast<std::size_t>(a.law->count); who++)
      require_attributes(world, forces.sites, *a.law, a.sites_of(world, forces, who, some), who);
  });
}

}  // namespace pantin
