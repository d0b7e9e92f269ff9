#include "forces/curves.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace pantin {

namespace {

/// Runs a curve for particles.
class Runner {
 public:
  explicit Runner(const Curve& curve)
      : machine_(curve.program),
        age_(machine_.input(curve_age)),
        lifetime_(machine_.input(curve_lifetime)),
        outputs_(curve.program.outputs.size()) {
    machine_.run_uniform();
  }

  /// `positions`: which of `slots` to run for, and where the results go.
  void run(const World& world, double time, std::span<const std::uint32_t> positions,
           std::span<const std::uint32_t> slots, std::span<double* const> columns) {
    for (std::size_t first = 0; first < positions.size(); first += Machine::block) {
      const auto block = positions.subspan(first, std::min<std::size_t>(Machine::block, positions.size() - first));
      for (std::size_t k = 0; k < block.size(); k++) {
        const Particle& particle = world.particles.at_slot(slots[block[k]]);
        if (age_ >= 0) machine_.column(age_)[k] = std::clamp(time - particle.born, 0.0, particle.lifetime);
        if (lifetime_ >= 0) machine_.column(lifetime_)[k] = particle.lifetime;
      }
      machine_.run(static_cast<int>(block.size()));
      for (std::size_t output = 0; output < outputs_; output++) {
        const double* values = machine_.output(static_cast<int>(output));
        for (std::size_t k = 0; k < block.size(); k++) columns[output][block[k]] = values[k];
      }
    }
  }

 private:
  Machine machine_;
  int age_, lifetime_;
  std::size_t outputs_;
};

const Curve* find_curve(const World& world, ParticleId id, std::string_view name) {
  const Particle& particle = world.particles[id];
  return particle.curves ? particle.curves->find(name) : nullptr;
}

float channel(double x) { return static_cast<float>(x > 0.0 ? std::fmin(x, 1.0) : 0.0); }

}  // namespace

std::optional<double> curve_value(const World& world, ParticleId particle, std::string_view name, double time) {
  const Curve* curve = find_curve(world, particle, name);
  if (!curve) return {};
  const std::uint32_t position = 0, slot = particle.slot - 1;
  double value = 0.0;
  double* const column = &value;
  Runner(*curve).run(world, time, {&position, 1}, {&slot, 1}, {&column, 1});
  return value;
}

Color present_color(const World& world, ParticleId id) {
  const Particle& particle = world.particles[id];
  if (!find_curve(world, id, "color")) return particle.color.value_or(world.points[particle.points[0]].color);
  double c[4];
  double* const columns[] = {&c[0], &c[1], &c[2], &c[3]};
  const std::uint32_t slot = id.slot - 1;
  follow_curves(world, "color", world.time, {&slot, 1}, columns);
  return {channel(c[0]), channel(c[1]), channel(c[2]), channel(c[3])};
}

double present_radius(const World& world, ParticleId id) {
  const Particle& particle = world.particles[id];
  return curve_value(world, id, "radius", world.time)
      .value_or(particle.radius.value_or(world.points[particle.points[0]].radius));
}

Look look_of(const World& world, const Particle& particle) {
  if (particle.look) return *particle.look;
  return particle.family ? world.families[particle.family].look.value_or(Look::ball) : Look::ball;
}

void follow_curves(const World& world, std::string_view name, double time, std::span<const std::uint32_t> slots,
                   std::span<double* const> columns) {
  struct Followers {
    const Curve* curve;
    std::vector<std::uint32_t> positions;
  };
  std::vector<Followers> groups;
  std::unordered_map<const Curves*, std::size_t> known;  // only looked up: its order reaches nothing
  const Curves* last = nullptr;
  std::size_t group = 0;
  for (std::uint32_t i = 0; i < slots.size(); i++) {
    if (slots[i] >= world.particles.slots() || !world.particles.alive_at(slots[i])) continue;
    const Curves* curves = world.particles.at_slot(slots[i]).curves.get();
    if (!curves) continue;
    if (curves != last) {
      const auto [found, is_new] = known.try_emplace(curves, groups.size());
      if (is_new) groups.push_back({curves->find(name), {}});
      group = found->second;
      last = curves;
    }
    if (groups[group].curve) groups[group].positions.push_back(i);
  }
  for (const Followers& g : groups)
    if (g.curve) Runner(*g.curve).run(world, time, g.positions, slots, columns);
}

}  // namespace pantin
