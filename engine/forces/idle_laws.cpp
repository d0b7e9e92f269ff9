// Laws that do nothing to what they are to act on: by the mass of points that have none, or on bodies without points.
#include <algorithm>
#include <numeric>

#include "forces/forces_parts.hpp"

namespace pantin {

namespace {

/// Whether the law is none at all where its particle `who` has no mass.
bool goes_by_mass(const Law& law, std::uint8_t who) {
  if (law.called) return false;
  const Input mass{Role::attribute, who, 0, "mass"};
  Expressions graph = law.graph;
  return std::all_of(law.force.begin(), law.force.end(), [&](Expr force) {
    const Expr without = graph.replaced(force, mass, graph.constant(0.0));
    return graph.is_constant(without) && graph[without].value == 0.0;
  });
}

/// The first body of those that the sites are of whose sites have no mass together, or null.
BodyId massless_body(const World& world, const Forces& f, std::span<const std::uint32_t> sites,
                     const AlignedVector<double>& mass) {
  std::vector<double> sums(f.receivers.size(), -1.0);  // -1: not among them
  for (std::uint32_t site : sites) {
    if (f.attached_of[site] == Forces::none) continue;
    double& sum = sums[f.attached[f.attached_of[site]].receiver];
    sum = std::fmax(sum, 0.0) + mass[site];
  }
  for (std::size_t i = 0; i < sums.size(); i++)
    if (sums[i] == 0.0 && f.receivers[i].is_body) return world.bodies.id_at(f.receivers[i].slot);
  return {};
}

template <class Acting, class Row>
void look(World& world, const Acting& acting, Row& row, const AlignedVector<double>& mass) {
  const Forces& f = *world.forces;
  std::vector<std::uint32_t> all(f.sites.n);
  std::iota(all.begin(), all.end(), 0u);
  for (std::uint8_t who = 0; who < acting.law->count && !row.told_idle; who++) {
    if (!goes_by_mass(*acting.law, who)) continue;
    const BodyId body = massless_body(world, f, acting.sites_of(world, f, who, all), mass);
    if (!body) continue;
    row.told_idle = true;
    log_line(
        world, "warning",
        text(law_in_place(row), ": it goes by the mass of points, and those of ", describe(world, body),
             " that it acts on have none, so it does nothing to it; give the mass of the body to its points, as in "
             "points = { { at = vec(0, 0, 0), mass = 1 } }"));
  }
}

/// The first of the bodies in a group, or in those that it holds, that has no point; or null.
BodyId body_without_points(const World& world, GroupId group) {
  for (const AnyId& member : all_members(world, group))
    if (const auto* body = std::get_if<BodyId>(&member); body && world.bodies[*body].points.empty()) return *body;
  return {};
}

/// The same of what a field is to act on; of one on all of the scene where there is nothing that it acts on.
BodyId body_without_points(const World& world, const Field& field) {
  if (field.family) return {};
  if (field.group) return world.groups.alive(field.group) ? body_without_points(world, field.group) : BodyId{};
  return world.particles.size() > 0 ? BodyId{} : world.bodies.ids().front();
}

void tell_without_points(World& world) {
  if (world.bodies.size() == 0) return;
  for (const FieldId id : world.fields.ids()) {
    Field& field = world.fields[id];
    if (field.told_idle || !field.enabled) continue;
    const BodyId body = body_without_points(world, field);
    if (!body) continue;
    field.told_idle = true;
    log_line(world, "warning",
             text(law_in_place(field), ": laws act on particles, and ", describe(world, body),
                  " has no points, so it does nothing to it; give it one, as in points = { vec(0, 0, 0) }"));
  }
}

}  // namespace

void tell_idle(World& world) {
  tell_without_points(world);
  if (!world.forces) return;
  const Forces& f = *world.forces;
  const auto& names = f.sites.names;
  const auto column = static_cast<std::size_t>(std::find(names.begin(), names.end(), "mass") - names.begin());
  if (column == names.size()) return;
  const auto& mass = f.sites.attributes[column];
  if (std::none_of(f.attached.begin(), f.attached.end(), [&](const Attached& a) { return mass[a.site] == 0.0; }))
    return;
  for (const ActingField& acting : f.fields) look(world, acting, world.fields[acting.id], mass);
  for (const ActingInteraction& acting : f.interactions) look(world, acting, world.interactions[acting.id], mass);
}

}  // namespace pantin
