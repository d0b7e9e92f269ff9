#include "edit/constrain.hpp"
#include "fields/contacts.hpp"
#include "fields/look.hpp"
#include "fields/make.hpp"
#include "forces/curves.hpp"

namespace pantin::fields {
namespace {

/// What a particle answers for: itself, or the hinge it sleeps in.
const Particle& ring(const World& world, ParticleId particle) { return world.particles[awake(world, particle)]; }

/// The point of a particle of one point, which is not in a hinge.
PointId only_point(const World& world, ParticleId particle, const char* name) {
  require(!ring(world, particle).is_hinge(), "particle: ", name,
          " of a hinge belongs to its points; change theirs or their bodies'");
  return world.particles[particle].points[0];
}

std::vector<BodyId> bodies_of(const World& world, ParticleId particle) {
  std::vector<BodyId> bodies;
  for (PointId p : ring(world, particle).points)
    if (const BodyId body = world.points[p].body) bodies.push_back(body);
  return bodies;
}

std::vector<Property> motion_and_mass() {
  return {
      property<ParticleId>(
          "position", "vec", "m", "position in the world; written only of a free particle",
          [](const World& w, ParticleId p) { return position(w, p); },
          [](World& w, ParticleId p, Vec3 at) { set_position(w, only_point(w, p, "position"), at); }),
      property<ParticleId>(
          "velocity", "vec", "m/s", "velocity in the world; written only of a free particle",
          [](const World& w, ParticleId p) { return velocity(w, p); },
          [](World& w, ParticleId p, Vec3 v) { set_velocity(w, only_point(w, p, "velocity"), v); }),
      property<ParticleId>(
          "mass", "number", "kg", "mass; of a hinge its points' sum, which is not written",
          [](const World& w, ParticleId p) { return mass(w, awake(w, p)); },
          [](World& w, ParticleId p, double mass) { set_mass(w, only_point(w, p, "mass"), mass); }),
  };
}

/// Of all its points.
Table contacts_of_particle(const World& world, ParticleId particle) {
  Table all;
  for (const PointId p : ring(world, particle).points)
    if (!world.points[p].body)
      for (auto& contact : contacts_of(world, point_thing(p.slot - 1))) all.push_back(std::move(contact));
  return all;
}

std::vector<Property> family_and_life() {
  return {
      property<ParticleId>(
          "family", "Family?", "", "its family, whose attributes are fields of it: p.charge",
          [](const World& w, ParticleId p) { return ring(w, p).family; },
          [](World& w, ParticleId p, std::optional<FamilyId> family) {
            set_family(w, p, family.value_or(FamilyId()));
          }),
      or_infinity(property<ParticleId>(
          "lifetime", "number", "s",
          "goes at the beginning of the first step at which its age has reached this; a hinge is cut; math.huge: never",
          [](const World& w, ParticleId p) { return ring(w, p).lifetime; },
          [](World& w, ParticleId p, double life) { set_lifetime(w, awake(w, p), life); })),
      property<ParticleId>("contacts", "Contact[]", "", "where it touches shapes and others, if its family is solid",
                           [](const World& w, ParticleId p) { return contacts_of_particle(w, p); }),
      property<ParticleId>("age", "number", "s", "time since it was made",
                           [](const World& w, ParticleId p) { return w.time - ring(w, p).born; }),
  };
}

std::vector<Property> looks() {
  return {
      property<ParticleId>(
          "color", "color|fun(age: number, life: number): color", "",
          "or a function of age and lifetime [s]; overrides its points'",
          [](const World& w, ParticleId p) { return present_color(w, awake(w, p)); },
          [](World& w, ParticleId p, const OrOfAge<Color>& given) {
            if (const Color* color = std::get_if<Color>(&given)) return set_color(w, awake(w, p), *color);
            set_curve(w, p, std::get<OfAge>(given));
          }),
      property<ParticleId>(
          "radius", "number|fun(age: number, life: number): number", "m",
          "or a function of age and lifetime [s]; overrides its points'",
          [](const World& w, ParticleId p) { return present_radius(w, awake(w, p)); },
          [](World& w, ParticleId p, const OrOfAge<double>& given) {
            if (const double* radius = std::get_if<double>(&given)) return set_radius(w, awake(w, p), *radius);
            set_curve(w, p, std::get<OfAge>(given));
          }),
      property<ParticleId>(
          "look", "Look", "",
          "\"ball\", \"glow\" (a soft disc of light) or \"streak\" (a line of light along its velocity)",
          [](const World& w, ParticleId p) { return name_of(look_of(w, ring(w, p))); },
          [](World& w, ParticleId p, const std::string& name) {
            set_look(w, awake(w, p), look_of_name(name, "particle"));
          }),
  };
}

std::vector<Property> of_hinges() {
  return {
      property<ParticleId>("points", "Point[]", "", "its points, in the order of joining",
                           [](const World& w, ParticleId p) { return ring(w, p).points; }),
      property<ParticleId>("bodies", "Body[]", "", "the bodies of its points",
                           [](const World& w, ParticleId p) { return bodies_of(w, p); }),
      called("hinge", property<ParticleId>(
                          "enabled", "boolean", "", "of a hinge: whether its points stay together (default `true`)",
                          [](const World& w, ParticleId p) { return ring(w, p).enabled; },
                          [](World& w, ParticleId p, bool on) { set_enabled(w, awake(w, p), on); })),
      called("hinge", property<ParticleId>(
                          "collide", "boolean", "", "of a hinge: whether its bodies touch each other (default `false`)",
                          [](const World& w, ParticleId p) { return ring(w, p).collide; },
                          [](World& w, ParticleId p, bool on) { set_collide(w, p, on); })),
      called("hinge",
             of_parts({"force", "torque"},
                      property<ParticleId>(
                          "breaks_at", "Breaking", "", "of a hinge: load at which it breaks (default `{}`)",
                          [](const World& w, ParticleId p) { return ring(w, p).breaks_at; },
                          [](World& w, ParticleId p, const Breaking& b) { set_breaks_at(w, awake(w, p), b); }))),
      property<ParticleId>("is_hinge", "boolean", "", "whether it joins two points or more",
                           [](const World& w, ParticleId p) { return ring(w, p).is_hinge(); }),
  };
}

std::vector<Property> properties_of_particle() {
  std::vector<Property> all;
  for (const auto& some : {motion_and_mass(), family_and_life(), looks(), of_hinges()})
    all.insert(all.end(), some.begin(), some.end());
  return all;
}

}  // namespace

const Type& particle_type() {
  static const Type type = {
      "Particle", "particle",
      "A ring of one or more points. One point: an ordinary particle. More: a hinge, whose points coincide.",
      properties_of_particle(), &any_thing_type()};
  return type;
}

}  // namespace pantin::fields
