#include <catch2/catch.hpp>
#include <cmath>

#include "base/parallel.hpp"
#include "edit/edit.hpp"
#include "measure/measure.hpp"
#include "step/step.hpp"

using namespace pantin;

namespace {

/// A block of boxes that touch, on a ground, all a little turned: one island of more than 3000 contacts.
void add_block(World& world) {
  ShapeDef ground;
  ground.geometry = BoxShape{vec(50, 1, 50)};
  ground.at = vec(0, -1, 0);
  add_shape(world, ground);
  for (int i = 0; i < 720; i++) {
    ShapeDef box;
    box.geometry = BoxShape{vec(0.5, 0.5, 0.5)};
    BodyDef body;
    body.shapes = {box};
    body.at = vec(0.999 * (i % 12), 0.5 + 0.999 * (i / 96), 0.999 * (i / 12 % 8));
    body.orientation = Quat{std::cos(0.004), 0, std::sin(0.004), 0};
    body.velocity = vec(0.3 * (i % 3), -0.1, 0);
    add_body(world, body);
  }
}

}  // namespace

TEST_CASE("A large island is swept to the same bits by one thread and by more, with and without exact searches") {
  const ContactSearch search = GENERATE(ContactSearch::automatic, ContactSearch::fast);
  std::uint64_t hashes[3];
  for (int threads = 1; threads <= 3; threads++) {
    World world;
    world.settings.step = 1.0 / 120.0;
    world.settings.contact = search;
    world.workers = std::make_unique<Workers>(threads);
    add_block(world);
    for (int i = 0; i < 3; i++) step(world);
    REQUIRE(world.failure == "");
    CHECK(world.contacts.list.size() > 3000);
    hashes[threads - 1] = state_hash(world);
  }
  CHECK(hashes[0] == hashes[1]);
  CHECK(hashes[0] == hashes[2]);
}
