// How contacts are solved, as a scene asks for.
#include <catch2/catch.hpp>
#include <cmath>

#include "contacts/solve/solve.hpp"
#include "edit/edit.hpp"
#include "measure/measure.hpp"
#include "step/step.hpp"

using namespace pantin;

namespace {

void add_box(World& world, Vec3 half, Vec3 at) {
  BodyDef body;
  body.shapes.emplace_back();
  body.shapes[0].geometry = BoxShape{half};
  body.at = at;
  body.mass = 1.0;
  add_body(world, body);
}

void add_floor(World& world) {
  ShapeDef def;
  def.geometry = HalfSpaceShape{};
  def.orientation = Quat{std::cos(M_PI / 4), -std::sin(M_PI / 4), 0, 0};
  add_shape(world, def);
}

void run_stack(World& world) {
  add_floor(world);
  for (int i = 0; i < 8; i++) add_box(world, vec(0.5, 0.5, 0.5), vec(0, 0.5 + i, 0));
  for (int i = 0; i < 120; i++) step(world);
}

void run_heap(World& world) {
  add_floor(world);
  for (int i = 0; i < 24; i++)
    add_box(world, vec(0.4, 0.3, 0.5), vec(0.3 * (i % 3), 0.7 + 0.8 * (i / 2), 0.25 * (i % 4)));
  for (int i = 0; i < 240; i++) step(world);
}

struct Three {
  World automatic, exact, fast;
  explicit Three(void run(World&)) {
    exact.settings.contact = ContactSearch::exact;
    fast.settings.contact = ContactSearch::fast;
    for (World* world : {&automatic, &exact, &fast}) run(*world);
  }
};

}  // namespace

TEST_CASE("contact search: a stack is solved exactly by itself, and by sweeps alone it is not") {
  const Three worlds(run_stack);
  CHECK(state_hash(worlds.automatic) == state_hash(worlds.exact));
  CHECK(worlds.exact.stats.unsolved_islands == 0);
  CHECK(worlds.exact.error.penetration < 1e-7);
  CHECK(worlds.fast.error.penetration > 1e-6);
  CHECK(worlds.fast.stats.unsolved_islands > 0);
}

TEST_CASE("contact search: in a heap Newton's search leaves less unsolved than sweeps, and takes more iterations",
          "[slow]") {
  const Three worlds(run_heap);
  CHECK(worlds.exact.stats.unsolved_islands < worlds.fast.stats.unsolved_islands);
  CHECK(worlds.exact.stats.contact_iterations > worlds.fast.stats.contact_iterations);
}

TEST_CASE("What strikes is not softened by how little pressed on it in the step before") {
  ContactIsland island;
  IslandBody body;
  body.mass = body.inverse_mass = 1.0;
  body.inertia = body.root = body.inverse_inertia = body.turning = identity33();
  body.v0 = vec(0, -1, 0);
  island.bodies = {body};
  IslandContact contact;
  contact.a = 0;
  contact.frame = {{vec(0, 1, 0), vec(0, 0, 1), vec(1, 0, 0)}};
  contact.compliance = 1e6;  // of a load that was next to nothing
  island.contacts = {contact};
  solve_island(island);
  CHECK(island.contacts[0].impulse[0] > 0.98);
}
