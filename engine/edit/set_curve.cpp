// What follows the age of particles: giving it to them.
#include "edit/common.hpp"
#include "forces/curves.hpp"

namespace pantin {

using namespace internal;

namespace {

void require_name(std::string_view call, const Family& family, std::string_view name) {
  require(name == "color" || name == "radius" || family.find(name) >= 0, call, ": it has no '", name,
          "' that could follow its age");
}

}  // namespace

void set_curve(World& world, ParticleId id, std::shared_ptr<const Curve> curve) {
  require_unlocked(world, curve->name);
  Particle& particle = world.particles[awake(world, id)];
  const Family family = particle.family ? world.families[particle.family] : Family{};
  require_name(describe(world, id), family, curve->name);
  require(!(family.solid && curve->name == "radius"), describe(world, id), ": as one of the solid family '",
          family.name, "' it touches, and its radius cannot follow its age");
  if (curve->name != "color") disturb_forces(world);
  particle.curves = with(particle.curves.get(), std::move(curve));
}

std::shared_ptr<const Curves> internal::curves_of(std::string_view call, const Family& family,
                                                  const std::shared_ptr<const Curves>& own, bool radius_given,
                                                  bool color_given, std::span<const AttributeDef> given) {
  std::shared_ptr<const Curves> result = family.curves;
  if (radius_given) result = without(result, "radius");
  if (color_given) result = without(result, "color");
  for (const AttributeDef& attribute : given) result = without(result, attribute.name);
  if (!own) return result;
  for (const auto& curve : own->list) {
    require_name(call, family, curve->name);
    result = with(result.get(), curve);
  }
  return result;
}

}  // namespace pantin
