#include "view/appearance.hpp"

#include <cmath>

#include "forces/curves.hpp"

namespace pantin {

void Appearance::update(const World& world) {
  slots_.clear();
  position_.assign(world.particles.slots(), 0);
  for (std::uint32_t s = 0; s < world.particles.slots(); s++)
    if (world.particles.alive_at(s) && world.particles.at_slot(s).curves) {
      slots_.push_back(s);
      position_[s] = static_cast<std::uint32_t>(slots_.size());
    }
  radii_.assign(slots_.size(), std::nan(""));
  for (std::vector<double>& channel : channels_) channel.assign(slots_.size(), std::nan(""));
  if (slots_.empty()) return;
  double* const radius = radii_.data();
  follow_curves(world, "radius", world.time, slots_, {&radius, 1});
  double* const color[] = {channels_[0].data(), channels_[1].data(), channels_[2].data(), channels_[3].data()};
  follow_curves(world, "color", world.time, slots_, color);
}

std::optional<double> Appearance::radius(std::uint32_t slot) const {
  if (position_[slot] == 0 || std::isnan(radii_[position_[slot] - 1])) return {};
  return radii_[position_[slot] - 1];
}

std::optional<Color> Appearance::color(std::uint32_t slot) const {
  if (position_[slot] == 0 || std::isnan(channels_[0][position_[slot] - 1])) return {};
  const auto channel = [&](std::size_t k) {
    const double x = channels_[k][position_[slot] - 1];
    return static_cast<float>(x > 0.0 ? std::fmin(x, 1.0) : 0.0);
  };
  return Color{channel(0), channel(1), channel(2), channel(3)};
}

}  // namespace pantin
