// What follows the age of particles: giving it to them.
#include "edit/editing.hpp"
#include "forces/curves.hpp"

namespace pantin {

using namespace internal;

namespace {

void require_name(std::string_view call, const Family& family, std::string_view name) {
  require(name == "color" || name == "radius" || family.find(name) >= 0, call, ": it has no '", name,
          "' that could follow its age");
}

}  // namespace

void set_course(World& world, ParticleId id, std::shared_ptr<const Course> course) {
  require_unlocked(world, course->name);
  Particle& particle = world.particles[awake(world, id)];
  require_name(describe(world, id), particle.family ? world.families[particle.family] : Family{}, course->name);
  if (course->name != "color") disturb_forces(world);
  particle.courses = with(particle.courses.get(), std::move(course));
}

std::shared_ptr<const Courses> internal::courses_of(std::string_view call, const Family& family,
                                                    const std::shared_ptr<const Courses>& own, bool radius_given,
                                                    bool color_given, std::span<const AttributeDef> given) {
  std::shared_ptr<const Courses> result = family.courses;
  if (radius_given) result = without(result, "radius");
  if (color_given) result = without(result, "color");
  for (const AttributeDef& attribute : given) result = without(result, attribute.name);
  if (!own) return result;
  for (const auto& course : own->list) {
    require_name(call, family, course->name);
    result = with(result.get(), course);
  }
  return result;
}

}  // namespace pantin
