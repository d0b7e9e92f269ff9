// A shape in use: of a body, or standing in the world.
#include "contacts/find.hpp"
#include "edit/edit.hpp"
#include "fields/make.hpp"

namespace pantin::fields {
namespace {

std::optional<std::string> layer_name(const World& world, ShapeId id) {
  const std::uint32_t layer = world.shapes[id].layer;
  return layer == 0 ? std::optional<std::string>() : world.layers.names[layer - 1];
}

std::vector<Property> properties_of_collider() {
  return {
      property<ShapeId>("body", "Body?", "", "whose it is; nil: it stands in the world",
                        [](const World& w, ShapeId s) { return w.shapes[s].body; }),
      property<ShapeId>("position", "vec", "m", "of its origin, in the world",
                        [](const World& w, ShapeId s) { return pose_of(w, w.shapes[s]).x; }),
      property<ShapeId>(
          "friction", "number", "1", "of two that touch the root of the product counts (default `0.5`)",
          [](const World& w, ShapeId s) { return w.shapes[s].material.friction; },
          [](World& w, ShapeId s, double v) { set_friction(w, s, v); }),
      property<ShapeId>(
          "restitution", "number", "1", "0 to 1; of two that touch the larger counts (default `0`)",
          [](const World& w, ShapeId s) { return w.shapes[s].material.restitution; },
          [](World& w, ShapeId s, double v) { set_restitution(w, s, v); }),
      property<ShapeId>(
          "rolling", "number", "m",
          "moment by normal force against rolling; of two that touch the larger counts (default `0`)",
          [](const World& w, ShapeId s) { return w.shapes[s].material.rolling; },
          [](World& w, ShapeId s, double v) { set_rolling(w, s, v); }),
      property<ShapeId>(
          "spinning", "number", "m",
          "moment by normal force against spinning on the spot; of two that touch the larger counts (default `0`)",
          [](const World& w, ShapeId s) { return w.shapes[s].material.spinning; },
          [](World& w, ShapeId s, double v) { set_spinning(w, s, v); }),
      property<ShapeId>(
          "surface_velocity", "vec", "m/s",
          "of its surface against its body, as of a belt; along the axes of the body, with which it turns, or of the "
          "world for what stands in it (default `vec(0, 0, 0)`)",
          [](const World& w, ShapeId s) { return w.shapes[s].material.surface_velocity; },
          [](World& w, ShapeId s, Vec3 v) { set_surface_velocity(w, s, v); }),
      property<ShapeId>(
          "layer", "string?", "", "that scene:collide speaks of; nil: none",
          [](const World& w, ShapeId s) { return layer_name(w, s); },
          [](World& w, ShapeId s, const std::optional<std::string>& layer) { set_layer(w, s, layer.value_or("")); }),
      property<ShapeId>(
          "sensor", "boolean", "", "tells what it touches, and pushes nothing (default `false`)",
          [](const World& w, ShapeId s) { return w.shapes[s].sensor; },
          [](World& w, ShapeId s, bool on) { set_sensor(w, s, on); }),
      property<ShapeId>(
          "size", "number?", "m", "of a plane: across which it is drawn, though it has no end; nil: as far as is seen",
          [](const World& w, ShapeId s) { return w.shapes[s].extent; },
          [](World& w, ShapeId s, std::optional<double> size) { set_extent(w, s, size); }),
      property<ShapeId>(
          "color", "color", "", "how it is drawn", [](const World& w, ShapeId s) { return w.shapes[s].color; },
          [](World& w, ShapeId s, const Color& color) { w.shapes[s].color = color; }),
  };
}

}  // namespace

const Type& collider_type() {
  static const Type type = {"Collider", "collider", "A shape in use: of a body, or standing in the world, as a floor.",
                            properties_of_collider(), &any_thing_type()};
  return type;
}

}  // namespace pantin::fields
