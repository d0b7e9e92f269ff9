#include <cmath>

#include "edit/edit.hpp"
#include "fields/contacts.hpp"
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

std::optional<Color> color_of(const World& world, BodyId id) {
  const Body& body = world.bodies[id];
  if (!body.shapes.empty()) return world.shapes[body.shapes[0]].color;
  return body.points.empty() ? std::optional<Color>() : world.points[body.points[0]].color;
}

std::vector<Property> motion() {
  return {
      property<BodyId>(
          "position", "vec", "m",
          "position of the centre of mass; what it is hinged to stays where it is, and the next step draws both "
          "together: `Group:move` moves all of it",
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
          "color", "color", "", "color of its first shape, or point; writing gives it to all",
          [](const World& w, BodyId b) { return color_of(w, b); },
          [](World& w, BodyId b, const Color& color) {
            for (PointId p : w.bodies[b].points) w.points[p].color = color;
            for (ShapeId s : w.bodies[b].shapes) w.shapes[s].color = color;
          }),
  };
}

/// Of its shapes.
template <class Write>
void write_material(World& world, BodyId body, const char* name, const Write& write) {
  require(!world.locked, "body: ", name,
          " cannot be written while the world steps; write it in an event or a step callback");
  require(!world.bodies[body].shapes.empty(), "body: ", name, " is of its shapes, and it has none");
  for (const ShapeId shape : world.bodies[body].shapes) write(shape);
}

std::optional<double> friction(const World& world, BodyId body) {
  const auto& shapes = world.bodies[body].shapes;
  return shapes.empty() ? std::optional<double>() : world.shapes[shapes[0]].material.friction;
}

std::optional<double> restitution(const World& world, BodyId body) {
  const auto& shapes = world.bodies[body].shapes;
  return shapes.empty() ? std::optional<double>() : world.shapes[shapes[0]].material.restitution;
}

void write_friction(World& world, BodyId body, double friction) {
  require(friction >= 0.0 && std::isfinite(friction), "body: friction must be a finite number >= 0, got ", friction);
  write_material(world, body, "friction", [&](ShapeId shape) { set_friction(world, shape, friction); });
}

void write_restitution(World& world, BodyId body, double restitution) {
  require(restitution >= 0.0 && restitution <= 1.0, "body: restitution must be from 0 to 1, got ", restitution);
  write_material(world, body, "restitution", [&](ShapeId shape) { set_restitution(world, shape, restitution); });
}

std::optional<std::string> layer_of_body(const World& world, BodyId body) {
  const auto& shapes = world.bodies[body].shapes;
  const std::uint32_t layer = shapes.empty() ? 0 : world.shapes[shapes[0]].layer;
  return layer == 0 ? std::optional<std::string>() : world.layers.names[layer - 1];
}

void write_layer(World& world, BodyId body, const std::optional<std::string>& layer) {
  require(!world.bodies[body].shapes.empty(), "body: layer is of its shapes, and it has none");
  for (const ShapeId shape : world.bodies[body].shapes) set_layer(world, shape, layer.value_or(""));
}

std::vector<Property> touch() {
  return {
      property<BodyId>(
          "friction", "number?", "1", "of its first shape, nil without one; writing gives it to all",
          [](const World& w, BodyId b) { return friction(w, b); },
          [](World& w, BodyId b, double v) { write_friction(w, b, v); }),
      property<BodyId>(
          "restitution", "number?", "1", "of its first shape, nil without one; writing gives it to all",
          [](const World& w, BodyId b) { return restitution(w, b); },
          [](World& w, BodyId b, double v) { write_restitution(w, b, v); }),
      property<BodyId>(
          "layer", "string?", "", "of its first shape, nil without one; writing gives it to all",
          [](const World& w, BodyId b) { return layer_of_body(w, b); },
          [](World& w, BodyId b, const std::optional<std::string>& layer) { write_layer(w, b, layer); }),
      property<BodyId>("colliders", "Collider[]", "", "its shapes, in the order of making",
                       [](const World& w, BodyId b) { return w.bodies[b].shapes; }),
      property<BodyId>("contacts", "Contact[]", "", "where its shapes touch others, after the last step",
                       [](const World& w, BodyId b) { return contacts_of(w, b.slot - 1); }),
  };
}

std::vector<Property> properties_of_body() {
  std::vector<Property> all = motion();
  for (auto some : {make_up(), touch()})
    for (Property& more : some) all.push_back(std::move(more));
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
