#include "edit/edit.hpp"
#include "fields/make.hpp"

namespace pantin::fields {
namespace {

std::vector<Property> properties_of_point() {
  return {
      property<PointId>(
          "position", "vec", "m", "position in the world; written only where the point is free",
          [](const World& w, PointId p) { return position(w, p); },
          [](World& w, PointId p, Vec3 at) { set_position(w, p, at); }),
      property<PointId>(
          "velocity", "vec", "m/s", "velocity in the world; written only where the point is free",
          [](const World& w, PointId p) { return velocity(w, p); },
          [](World& w, PointId p, Vec3 v) { set_velocity(w, p, v); }),
      property<PointId>(
          "mass", "number", "kg", "mass; 0 only in a body, as an anchor",
          [](const World& w, PointId p) { return w.points[p].mass; },
          [](World& w, PointId p, double mass) { set_mass(w, p, mass); }),
      property<PointId>(
          "color", "color", "", "of the point", [](const World& w, PointId p) { return w.points[p].color; },
          [](World& w, PointId p, const Color& color) { w.points[p].color = color; }),
      property<PointId>(
          "radius", "number", "m", "drawn size; 0: the window chooses",
          [](const World& w, PointId p) { return w.points[p].radius; },
          [](World& w, PointId p, double radius) {
            require(radius >= 0, "point: radius must be >= 0 m, got ", radius);
            w.points[p].radius = radius;
          }),
      property<PointId>("body", "Body?", "", "the body it belongs to, or nil",
                        [](const World& w, PointId p) { return w.points[p].body; }),
      property<PointId>("particle", "Particle", "", "the particle it is in now: its own, or a hinge",
                        [](const World& w, PointId p) { return w.points[p].particle; }),
  };
}

}  // namespace

const Type& point_type() {
  static const Type type = {"Point", "point",
                            "A point mass. It belongs to at most one body, and always to one particle.",
                            properties_of_point(), &any_thing_type()};
  return type;
}

}  // namespace pantin::fields
