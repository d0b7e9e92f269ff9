#include "measure/query.hpp"

#include <algorithm>

#include "base/stable.hpp"
#include "laws/run/sites.hpp"
#include "world/checks.hpp"

namespace pantin {
namespace {

struct Oldest {
  std::string_view name;
  AnyId id;
  std::uint64_t serial = ~std::uint64_t{0};

  template <class Row>
  void look(const Store<Row>& store) {
    for (std::uint32_t s = 0; s < store.slots(); s++) {
      const Row& row = store.at_slot(s);
      if (!store.alive_at(s) || row.serial >= serial || row.name != name) continue;
      serial = row.serial;
      id = store.id_at(s);
    }
  }
};

template <class Use>
void each_store_of_things(const World& world, Use use) {
  use(world.bodies);
  use(world.particles);
  use(world.constraints);
  use(world.groups);
  use(world.families);
  use(world.connections);
  use(world.interactions);
  use(world.fields);
  use(world.emitters);
  use(world.shapes);
}

}  // namespace

AnyId find(const World& world, std::string_view name) {
  if (name.empty()) return {};
  Oldest oldest{name, {}};
  each_store_of_things(world, [&](const auto& store) { oldest.look(store); });
  return oldest.id;
}

AnyId find_numbered(const World& world, std::uint64_t serial) {
  AnyId found;
  each_store_of_things(world, [&](const auto& store) {
    for (std::uint32_t s = 0; s < store.slots(); s++)
      if (store.alive_at(s) && store.at_slot(s).serial == serial) found = store.id_at(s);
  });
  return found;
}

std::vector<ParticleId> particles(const World& world) {
  std::vector<ParticleId> list = world.particles.ids();
  std::erase_if(list, [&](ParticleId p) { return static_cast<bool>(world.particles[p].asleep_in); });
  return list;
}

std::vector<ParticleId> particles(const World& world, FamilyId family) {
  std::vector<ParticleId> list = particles(world);
  std::erase_if(list, [&](ParticleId p) { return world.particles[p].family != family; });
  return list;
}

std::vector<ParticleId> hinges(const World& world) {
  std::vector<ParticleId> list = world.particles.ids();
  std::erase_if(list, [&](ParticleId p) { return !world.particles[p].is_hinge(); });
  return list;
}

std::vector<ParticleId> near(const World& world, Vec3 at, double radius) {
  internal::require_finite("near", "at", at, "m");
  internal::require_not_negative("near", "radius", radius, "m");
  const Box box{world.settings.box.value_or(zero3())};
  std::vector<std::pair<double, ParticleId>> found;
  for (ParticleId p : particles(world))
    if (const double distance = norm(box.nearest(position(world, p) - at)); distance <= radius)
      found.push_back({distance, p});
  sort_stably(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<ParticleId> list;
  for (const auto& [distance, p] : found) list.push_back(p);
  return list;
}

std::vector<ParticleId> hinges_of(const World& world, BodyId body) {
  std::vector<ParticleId> list;
  for (PointId p : world.bodies[body].points) {
    const ParticleId ring = world.points[p].particle;
    if (world.particles[ring].is_hinge()) list.push_back(ring);
  }
  return list;
}

Vec3 hinge_force(const World& world, ParticleId particle, BodyId body) {
  const ParticleId hinge = awake(world, particle);
  const std::string name = describe(world, body);
  require(world.bodies.alive(body), "force: ", name);
  for (PointId p : world.particles[hinge].points)
    if (world.points[p].body == body) return world.points[p].row_force;
  throw Error(text("force: ", name, " is not in ", describe(world, hinge)));
}

}  // namespace pantin
