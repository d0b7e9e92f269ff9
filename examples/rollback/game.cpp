#include "game.hpp"

#include "base/random.hpp"
#include "edit/edit.hpp"
#include "step/step.hpp"

namespace rollback {

using namespace pantin;

namespace {

constexpr double push_force = 40.0;  // [N]

BodyId add_shaped(World& world, const Geometry& geometry, Vec3 at) {
  ShapeDef shape;
  shape.geometry = geometry;
  shape.material.density = 200.0;
  BodyDef body;
  body.shapes = {shape};
  body.at = at;
  return add_body(world, body);
}

void add_wall(World& world, Vec3 half, Vec3 at) {
  ShapeDef wall;
  wall.geometry = BoxShape{half};
  wall.at = at;
  add_shape(world, wall);
}

}  // namespace

Game::Game() {
  world_.settings.step = 1.0 / 60.0;
  add_wall(world_, vec(5, 0.5, 5), vec(0, -0.5, 0));
  for (const double side : {-1.0, 1.0}) {
    add_wall(world_, vec(0.5, 1, 5), vec(5.5 * side, 1, 0));
    add_wall(world_, vec(5, 1, 0.5), vec(0, 1, 5.5 * side));
  }
  for (int i = 0; i < 30; i++)
    add_shaped(world_, BoxShape{vec(0.25, 0.25, 0.25)}, vec(i % 5 - 2, 0.25 + 0.5 * (i / 15), i / 5 % 3 - 1));
  for (std::size_t player = 0; player < 2; player++)
    balls_[player] = add_shaped(world_, BallShape{0.4}, vec(player == 0 ? -3.5 : 3.5, 0.4, 0));
}

void Game::play(const Inputs& inputs) {
  for (std::size_t player = 0; player < 2; player++) {
    const auto held = [&](int bit) { return (inputs[player] >> bit & 1) != 0 ? 1.0 : 0.0; };
    const Vec3 force = vec(held(1) - held(0), 0, held(3) - held(2)) * push_force;
    if (norm2(force) > 0.0) push(world_, balls_[player], force);
  }
  step(world_);
}

Input whim(int player, std::uint32_t frame) {
  const std::uint32_t held_for = player == 0 ? 17 : 23;
  Random random{static_cast<std::uint64_t>(player) + 1, frame / held_for};
  return static_cast<Input>(random.bits() & 15u);
}

}  // namespace rollback
