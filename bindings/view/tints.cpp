#include "view/tints.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "articulates/articulate.hpp"
#include "contacts/touching.hpp"

namespace pantin {

namespace {

constexpr Color grey = {0.62f, 0.61f, 0.59f, 1.0f};
constexpr double hottest = 3.0;                       // times the mean temperature
constexpr double least_log = -17.0, most_log = -5.0;  // of errors relative to the size of the scene

/// Colours that differ for numbers that follow each other: hues by the golden ratio.
Color distinct(std::uint64_t number) {
  const double hue = 6.0 * std::fmod(0.07 + 0.6180339887498949 * static_cast<double>(number % 1000003), 1.0);
  const auto channel = [&](double shift) {
    const double k = std::fmod(hue + shift, 6.0);
    return static_cast<float>(0.86 - 0.56 * std::clamp(std::min(k, 4.0 - k), 0.0, 1.0));
  };
  return {channel(5.0), channel(3.0), channel(1.0), 1.0f};
}

/// 0 blue, 1/2 light, 1 red.
Color heat(double part) {
  constexpr Color cold = {0.13f, 0.33f, 0.72f, 1.0f}, mild = {0.93f, 0.86f, 0.62f, 1.0f},
                  hot = {0.83f, 0.14f, 0.11f, 1.0f};
  const double p = part >= 0.0 ? std::min(part, 1.0) : 0.0;
  const Color &a = p < 0.5 ? cold : mild, &b = p < 0.5 ? mild : hot;
  const auto t = static_cast<float>(p < 0.5 ? 2.0 * p : 2.0 * p - 1.0);
  return {a.r + (b.r - a.r) * t, a.g + (b.g - a.g) * t, a.b + (b.b - a.b) * t, 1.0f};
}

/// The motion of the whole, which is no heat.
struct Common {
  Vec3 momentum = zero3();
  double mass = 0.0;
  Vec3 velocity() const { return mass > 0.0 ? momentum / mass : zero3(); }
};

}  // namespace

Color Tint::of(const Color& own) const {
  Color c = color.value_or(own);
  c.a = own.a;
  if (!dim) return c;
  const float level = 0.1f + 0.17f * (c.r + c.g + c.b) / 3.0f;
  const auto faded = [&](float channel) { return level + 0.1f * channel; };
  return {faded(c.r), faded(c.g), faded(c.b), c.a};
}

std::optional<Color> Tints::read(const std::vector<Color>& list, std::uint32_t slot) {
  if (slot >= list.size() || !(list[slot].a > 0.0f)) return {};
  return list[slot];
}

void Tints::update(const World& world, const Views& views, double size) {
  legend_.clear();
  sleeping_bodies_.clear();
  sleeping_particles_.clear();
  if (views.on(View::asleep)) find_sleepers(world);
  on_ = views.on(View::families) || views.on(View::articulates) || views.on(View::islands) ||
        views.on(View::temperature) || views.on(View::errors);
  bodies_.clear();
  particles_.clear();
  if (!on_) return;
  bodies_.assign(world.bodies.slots(), grey);
  particles_.assign(world.particles.slots(), Color{0.0f, 0.0f, 0.0f, 0.0f});
  if (views.on(View::families)) by_family(world);
  if (views.on(View::articulates)) by_articulate(world);
  if (views.on(View::islands)) by_island(world);
  if (views.on(View::temperature)) by_temperature(world);
  if (views.on(View::errors)) by_error(world, size);
}

void Tints::by_family(const World& world) {
  for (std::uint32_t s = 0; s < world.particles.slots(); s++) {
    if (!world.particles.alive_at(s)) continue;
    const Particle& particle = world.particles.at_slot(s);
    const Color color = particle.family ? distinct(particle.family.slot) : grey;
    particles_[s] = color;
    if (!particle.family) continue;
    for (const PointId point : particle.points)
      if (const BodyId body = world.points[point].body) bodies_[body.slot - 1] = color;
  }
}

void Tints::by_articulate(const World& world) {
  for (std::uint32_t s = 0; s < world.particles.slots(); s++)
    if (world.particles.alive_at(s) && !world.particles.at_slot(s).is_hinge()) particles_[s] = grey;
  for (const auto& articulate : world.articulates) {
    const Color color = distinct(articulate->serial);
    for (const Node& node : articulate->nodes) {
      if (node.is_body)
        bodies_[node.slot] = color;
      else if (world.points.alive_at(node.slot))
        particles_[world.points.at_slot(node.slot).particle.slot - 1] = color;
    }
  }
}

void Tints::by_island(const World& world) {
  joined_.resize(world.bodies.slots());
  for (std::uint32_t s = 0; s < joined_.size(); s++) joined_[s] = s;
  const auto first_of = [&](std::uint32_t s) {
    while (joined_[s] != s) s = joined_[s] = joined_[joined_[s]];
    return s;
  };
  const auto join = [&](std::uint32_t a, std::uint32_t b) {
    a = first_of(a);
    b = first_of(b);
    joined_[std::max(a, b)] = std::min(a, b);
  };
  for (const auto& articulate : world.articulates) {
    const Node* last = nullptr;
    for (const Node& node : articulate->nodes) {
      if (!node.is_body) continue;
      if (last) join(last->slot, node.slot);
      last = &node;
    }
  }
  const auto there = [&](std::uint32_t slot) { return world.bodies.alive_at(slot); };
  const auto color = [&](std::uint32_t slot) { bodies_[slot] = distinct(first_of(slot)); };
  for (const Contact& c : world.contacts.list)
    if (c.body_b >= 0 && !is_point(c.body_a) && presses(c)) join(c.body_a, static_cast<std::uint32_t>(c.body_b));
  for (const Contact& c : world.contacts.list)
    if (presses(c) && !is_point(c.body_a) && there(c.body_a)) {
      color(c.body_a);
      if (c.body_b >= 0) color(static_cast<std::uint32_t>(c.body_b));
    }
  for (const auto& articulate : world.articulates)
    for (const Node& node : articulate->nodes) {
      if (node.is_body && there(node.slot)) color(node.slot);
    }
}

void Tints::find_sleepers(const World& world) {
  sleeping_bodies_.assign(world.bodies.slots(), 0);
  sleeping_particles_.assign(world.particles.slots(), 0);
  for (std::uint32_t s = 0; s < world.contacts.bodies.size() && s < sleeping_bodies_.size(); s++)
    if (world.bodies.alive_at(s) && world.contacts.bodies[s].rest.asleep) sleeping_bodies_[s] = 1;
  for (const auto& articulate : world.articulates) {
    if (!articulate->rest.asleep) continue;
    for (const Node& node : articulate->nodes)
      if (node.is_body)
        sleeping_bodies_[node.slot] = 1;
      else if (world.points.alive_at(node.slot))
        sleeping_particles_[world.points.at_slot(node.slot).particle.slot - 1] = 1;
    for (const Row& row : articulate->rows)
      if (world.points.alive(row.member)) sleeping_particles_[world.points[row.member].particle.slot - 1] = 1;
  }
}

void Tints::by_temperature(const World& world) {
  Common all;
  for (std::uint32_t s = 0; s < world.bodies.slots(); s++) {
    if (!world.bodies.alive_at(s)) continue;
    all.momentum += world.motion[s].p;
    all.mass += world.motion[s].mass;
  }
  const auto is_free = [&](std::uint32_t s) { return world.points.alive_at(s) && !world.points.at_slot(s).body; };
  for (std::uint32_t s = 0; s < world.points.slots(); s++) {
    if (!is_free(s)) continue;
    all.momentum += world.free_motion[s].v * world.points.at_slot(s).mass;
    all.mass += world.points.at_slot(s).mass;
  }
  const Vec3 common = all.velocity();
  const double k = world.settings.boltzmann;
  const double of_place = world.plane.flat() ? 2.0 : 3.0, of_turn = world.plane.flat() ? 1.0 : 3.0;  // freedoms
  const auto of_body = [&](std::uint32_t s) {
    const Motion& m = world.motion[s];
    const Vec3 v = m.mass > 0.0 ? m.p / m.mass - common : zero3();
    return (m.mass * norm2(v) + dot(m.angular, inverse_inertia(m) * m.angular)) / ((of_place + of_turn) * k);
  };
  const auto of_point = [&](std::uint32_t s) {
    return world.points.at_slot(s).mass * norm2(world.free_motion[s].v - common) / (of_place * k);
  };
  double sum = 0.0, count = 0.0;
  for (std::uint32_t s = 0; s < world.bodies.slots(); s++)
    if (world.bodies.alive_at(s)) sum += of_body(s), count++;
  for (std::uint32_t s = 0; s < world.points.slots(); s++)
    if (is_free(s)) sum += of_point(s), count++;
  const double most = count > 0.0 && sum > 0.0 ? hottest * sum / count : 1.0;
  for (std::uint32_t s = 0; s < world.bodies.slots(); s++)
    if (world.bodies.alive_at(s)) bodies_[s] = heat(of_body(s) / most);
  for (std::uint32_t s = 0; s < world.points.slots(); s++)
    if (is_free(s)) particles_[world.points.at_slot(s).particle.slot - 1] = heat(of_point(s) / most);
  char line[80];
  std::snprintf(line, sizeof line, "temperature: blue 0, red %.3g %s", most, k == 1.0 ? "J" : "K");
  legend_ = line;
}

void Tints::by_error(const World& world, double size) {
  const auto color = [&](double error) {
    return heat((std::log10(std::fmax(error / size, 1e-30)) - least_log) / (most_log - least_log));
  };
  for (const auto& articulate : world.articulates) {
    const Color open = color(articulate->gaps.unaccepted);
    for (const Row& row : articulate->rows) {
      if (row.condition >= 0 || !world.points.alive(row.member)) continue;
      Color& ring = particles_[world.points[row.member].particle.slot - 1];
      const Color now = color(norm(row.d1));
      if (!(ring.a > 0.0f) || now.r > ring.r) ring = now;
    }
    for (const Node& node : articulate->nodes)
      if (node.is_body) bodies_[node.slot] = open;
  }
  char line[80];
  std::snprintf(line, sizeof line, "errors: blue %.0e m, red %.0e m", size * std::pow(10.0, least_log),
                size * std::pow(10.0, most_log));
  legend_ = line;
}

}  // namespace pantin
