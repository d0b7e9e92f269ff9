#include "forces/acting_elements.hpp"

#include <algorithm>
#include <numeric>

#include "forces/forces_parts.hpp"

namespace pantin {

namespace {

std::vector<std::uint32_t> sites_of_family(const Sites& sites, FamilyId family, std::span<const std::uint32_t> some) {
  std::vector<std::uint32_t> list;
  for (std::uint32_t i : some)
    if (sites.family[i] == family.slot - 1) list.push_back(i);
  return list;
}

}  // namespace

std::string ActingElement::name(const World& world) const {
  const ForceElement& of = *row(world);
  return of.name.empty() ? law->name : of.name;
}
std::vector<double> ActingElement::parameters(const World& world) const {
  return present_parameters(world, *law, row(world)->parameters);
}

ActingInteraction::ActingInteraction(InteractionId of, std::shared_ptr<const Law> by, const Forces& forces,
                                     const Workers& workers)
    : ActingElement(std::move(by)),
      id(of),
      pairs(law, forces.sites.names, workers),
      bonded(pantin::bonded(forces, law->exclude)) {}
const ForceElement* ActingInteraction::row(const World& world) const { return &world.interactions[id]; }
std::vector<std::uint32_t> ActingInteraction::sites_of(const World& world, const Forces& forces, std::size_t who,
                                                       std::span<const std::uint32_t> some) const {
  const Interaction& of = world.interactions[id];
  return sites_of_family(forces.sites, who == 0 ? of.a : of.b, some);
}

ActingField::ActingField(FieldId of, std::shared_ptr<const Law> by, const Forces& forces, const Workers& workers)
    : ActingElement(std::move(by)), id(of), fields(law, forces.sites.names, workers) {}
const ForceElement* ActingField::row(const World& world) const { return &world.fields[id]; }
std::vector<std::uint32_t> ActingField::sites_of(const World& world, const Forces& forces, std::size_t /*who*/,
                                                 std::span<const std::uint32_t> some) const {
  const Field& of = world.fields[id];
  if (of.family) return sites_of_family(forces.sites, of.family, some);
  std::vector<std::uint32_t> list;
  if (!of.group) {
    for (std::uint32_t i : some)
      if (forces.sites.particle[i] != Forces::none) list.push_back(i);
    return list;
  }
  for (ParticleId p : particles_of(world, AnyId(of.group))) {
    const std::uint32_t site = forces.site_of[awake(world, p).slot - 1];
    if (std::binary_search(some.begin(), some.end(), site)) list.push_back(site);
  }
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  return list;
}

namespace {

/// The law with its energy alone.
std::shared_ptr<const Law> energy_alone(const Law& law) {
  auto told = std::make_shared<Law>(law);
  told->force = {told->graph.constant(0.0)};
  told->also = nullptr;
  return told;
}

}  // namespace

ActingConnections::ActingConnections(std::shared_ptr<const Law> by, bool are_solved, const Forces& forces,
                                     const Workers& workers)
    : ActingElement(std::move(by)), bonds(are_solved ? energy_alone(*law) : law, forces.sites.names, workers) {
  solved = are_solved;
  bond_list.count = law->count;
  bond_list.parameters.resize(law->parameters.size());
}
const ForceElement* ActingConnections::row(const World& world) const {
  return ids.empty() ? nullptr : &world.connections[ids[0]];
}
std::string ActingConnections::name(const World& /*world*/) const { return law->name; }
std::vector<double> ActingConnections::parameters(const World& /*world*/) const { return {}; }
std::vector<std::uint32_t> ActingConnections::sites_of(const World& /*world*/, const Forces& /*forces*/,
                                                       std::size_t who, std::span<const std::uint32_t> some) const {
  std::vector<std::uint32_t> list;
  for (std::size_t k = who; k < bond_list.sites.size(); k += static_cast<std::size_t>(bond_list.count))
    if (std::binary_search(some.begin(), some.end(), bond_list.sites[k])) list.push_back(bond_list.sites[k]);
  return list;
}

std::string law_in_place(const ForceElement& row) {
  const bool own = row.law->name.find(':') != std::string::npos;
  return own || row.made_at.empty() ? row.law->name : row.made_at + ": " + row.law->name;
}

std::string law_at_work(const World& world, const ActingElement& acting) {
  const ForceElement* row = acting.row(world);
  return row == nullptr ? acting.law->name : law_in_place(*row);
}

std::vector<double> present_parameters(const World& world, const Law& law, const std::vector<double>& given) {
  std::vector<double> values = given;
  for (std::size_t i = 0; i < values.size(); i++) {
    if (!given_by_world(law.parameters[i].name)) continue;
    values[i] = law.parameters[i].name == "step" ? world.stage.full : world.settings.boltzmann;
  }
  return values;
}

double run_law(const World& world, Forces& f, ActingElement& a, const Instant& instant, bool with_energy) {
  const auto parameters = a.parameters(world);
  if (with_energy) return a.on().add_forces_and_energy(f.sites, box_of(world), instant, parameters, *world.workers);
  a.on().add_forces(f.sites, box_of(world), instant, parameters, *world.workers);
  return 0.0;
}

void arrange(const World& world, Forces& f) {
  std::vector<std::uint32_t> all(f.sites.n);
  std::iota(all.begin(), all.end(), 0u);
  for (ActingConnections& c : f.connections) c.bonds.arrange(c.bond_list, f.sites);
  for (ActingField& a : f.fields) a.fields.arrange(a.sites_of(world, f, 0, all));
}

}  // namespace pantin
