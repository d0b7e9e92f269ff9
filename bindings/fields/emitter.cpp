#include "fields/emitter.hpp"

#include <cmath>
#include <limits>

#include "fields/make.hpp"

namespace pantin::fields {
namespace {

const Emitter& row(const World& world, EmitterId id) { return world.emitters[id]; }

Value place(const World& world, EmitterId id) {
  const Emitter& e = row(world, id);
  if (e.point) return world.points.alive(e.point) ? Value(AnyId(e.point)) : Value();
  if (norm2(e.upper - e.lower) == 0.0) return e.lower;
  return Table{{"", e.lower}, {"", e.upper}};
}

Value lifetime(const World& world, EmitterId id) {
  const Emitter& e = row(world, id);
  if (e.shortest == e.longest) return e.shortest;
  return Lifetimes{e.shortest, e.longest};
}

double most(const World& world, EmitterId id) {
  const std::uint64_t max = row(world, id).max;
  return max == std::numeric_limits<std::uint64_t>::max() ? std::numeric_limits<double>::infinity()
                                                          : static_cast<double>(max);
}

std::vector<Property> emission() {
  return {
      property<EmitterId>(
          "at", "vec|vec[]|Point|Particle", "m",
          "where particles begin: a position, a box { vec, vec }, or a point that carries it",
          [](const World& w, EmitterId e) { return place(w, e); },
          [](World& w, EmitterId e, const EmitterPosition& at) { set_position(w, e, at); }),
      as_rate(property<EmitterId>(
          "rate", "number|fun(t: number): number", "1/s", "particles per second; read: of the last step",
          [](const World& w, EmitterId e) { return row(w, e).rate; },
          [](World& w, EmitterId e, const OfTime<double>& rate) {
            if (auto function = function_of(rate))
              set_rate(w, e, std::move(function));
            else
              set_rate(w, e, std::get<double>(rate));
          })),
      property<EmitterId>(
          "velocity", "vec", "m/s", "relative to the point that carries it",
          [](const World& w, EmitterId e) { return row(w, e).velocity; },
          [](World& w, EmitterId e, Vec3 v) { set_velocity(w, e, v); }),
      property<EmitterId>(
          "spread", "number", "rad", "half angle of the cone of velocities",
          [](const World& w, EmitterId e) { return row(w, e).spread; },
          [](World& w, EmitterId e, double spread) { set_spread(w, e, spread); }),
      property<EmitterId>(
          "lifetime", "number|{ min: number, max: number }", "s", "of its particles, or between which it is random",
          [](const World& w, EmitterId e) { return lifetime(w, e); },
          [](World& w, EmitterId e, const Lifetimes& l) { set_lifetimes(w, e, l.shortest, l.longest); }),
      or_infinity(property<EmitterId>(
          "max", "number", "1", "particles of it that may live at once",
          [](const World& w, EmitterId e) { return most(w, e); },
          [](World& w, EmitterId e, double max) { set_max(w, e, most_of_number(max)); })),
      property<EmitterId>(
          "enabled", "boolean", "", "whether it makes particles",
          [](const World& w, EmitterId e) { return row(w, e).enabled; },
          [](World& w, EmitterId e, bool on) { set_enabled(w, e, on); }),
      property<EmitterId>("family", "Family?", "", "of its particles",
                          [](const World& w, EmitterId e) { return row(w, e).family; }),
      property<EmitterId>("count", "integer", "", "how many of its particles live",
                          [](const World& w, EmitterId e) { return row(w, e).count; }),
      property<EmitterId>("made", "integer", "", "how many it has made",
                          [](const World& w, EmitterId e) { return row(w, e).made; }),
  };
}

}  // namespace

std::uint64_t most_of_number(double max) {
  require(max > 0.0 && max == std::trunc(max), "emitter: max must be a whole number > 0, got ", max);
  return max < 0x1p63 ? static_cast<std::uint64_t>(max) : std::numeric_limits<std::uint64_t>::max();
}

const Type& emitter_type() {
  static const Type type = {"Emitter", "emitter", "Makes particles at a rate.", emission(), &any_thing_type()};
  return type;
}

}  // namespace pantin::fields
