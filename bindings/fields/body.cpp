#include "edit/edit.hpp"
#include "fields/make.hpp"
#include "measure/query.hpp"

namespace pantin::fields {
namespace {

double mass_of_points(const World& world, BodyId body) {
  double sum = 0.0;
  for (PointId p : world.bodies[body].points) sum += world.points[p].mass;
  return sum;
}

/// About the frame's origin, in the frame's axes, of its masses in their places, [kg m²].
Mat3 inertia_of_points(const World& world, BodyId id) {
  const Body& body = world.bodies[id];
  Mat3 sum = zero33();
  const auto add = [&](Vec3 at, double mass) { sum += (identity33() * norm2(at) - outer(at, at)) * mass; };
  for (PointId p : body.points) add(world.points[p].position, world.points[p].mass);
  add(body.own_position, body.own_mass);
  return sum;
}

void write_mass(World& world, BodyId body, double mass) {
  require(mass > 0, "body: mass must be > 0 kg, got ", mass);
  const double points = mass_of_points(world, body);
  require(mass >= points, "body: mass must be at least that of its points, ", points, " kg, got ", mass);
  set_own_mass(world, body, mass - points);
}

std::vector<Property> motion() {
  return {
      property<BodyId>(
          "position", "vec", "m", "position of the centre of mass",
          [](const World& w, BodyId b) { return w.motion_of(b).x; },
          [](World& w, BodyId b, Vec3 at) { set_position(w, b, at); }),
      property<BodyId>(
          "velocity", "vec", "m/s", "velocity of the centre of mass",
          [](const World& w, BodyId b) {
            const Motion& m = w.motion_of(b);
            return m.p / m.mass;
          },
          [](World& w, BodyId b, Vec3 v) { set_velocity(w, b, v); }),
      property<BodyId>(
          "origin", "vec", "m", "position of its frame's origin", [](const World& w, BodyId b) { return origin(w, b); },
          [](World& w, BodyId b, Vec3 at) { set_origin(w, b, at); }),
      property<BodyId>(
          "orientation", "quat", "", "turns its frame to the world",
          [](const World& w, BodyId b) { return orientation(w, b); },
          [](World& w, BodyId b, const Quat& q) { set_orientation(w, b, q); }),
      property<BodyId>(
          "spin", "vec", "rad/s", "angular velocity, world axes",
          [](const World& w, BodyId b) { return angular_velocity(w.motion_of(b)); },
          [](World& w, BodyId b, Vec3 spin) { set_spin(w, b, spin); }),
      property<BodyId>("momentum", "vec", "kg m/s", "mass times velocity",
                       [](const World& w, BodyId b) { return w.motion_of(b).p; }),
      property<BodyId>("angular_momentum", "vec", "kg m²/s", "about its centre of mass, world axes",
                       [](const World& w, BodyId b) { return angular_momentum(w, b); }),
  };
}

std::vector<Property> make_up() {
  return {
      property<BodyId>(
          "mass", "number", "kg", "its points' and its own",
          [](const World& w, BodyId b) { return w.motion_of(b).mass; },
          [](World& w, BodyId b, double mass) { write_mass(w, b, mass); }),
      property<BodyId>(
          "inertia", "vec|Inertia", "kg m²",
          "its points' and its own about the frame's origin, in the frame's axes: vec of the diagonal, "
          "or a table. Tied, a body moves with no principal moment below 1e-4 of the largest, and a warning says so",
          [](const World& w, BodyId b) { return w.bodies[b].own_inertia + inertia_of_points(w, b); },
          [](World& w, BodyId b, const Mat3& wanted) { set_own_inertia(w, b, wanted - inertia_of_points(w, b)); }),
      property<BodyId>("points", "Point[]", "", "its points, in the order of making",
                       [](const World& w, BodyId b) { return w.bodies[b].points; }),
      property<BodyId>("hinges", "Particle[]", "", "the hinges that its points are in",
                       [](const World& w, BodyId b) { return hinges_of(w, b); }),
      property<BodyId>(
          "color", "color", "", "color of its first point; writing gives it to all",
          [](const World& w, BodyId b) {
            const auto& points = w.bodies[b].points;
            return points.empty() ? std::optional<Color>() : w.points[points[0]].color;
          },
          [](World& w, BodyId b, const Color& color) {
            for (PointId p : w.bodies[b].points) w.points[p].color = color;
          }),
  };
}

std::vector<Property> properties_of_body() {
  std::vector<Property> all = motion();
  for (Property& more : make_up()) all.push_back(std::move(more));
  return all;
}

}  // namespace

const Type& body_type() {
  static const Type type = {"Body", "body",
                            "Points at fixed relative positions: rigid. Its named points are fields: link.head.",
                            properties_of_body(), &any_thing_type()};
  return type;
}

}  // namespace pantin::fields
