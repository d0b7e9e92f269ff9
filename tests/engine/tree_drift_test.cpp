// Articulates that are moved by their trees: against an independent reference, and as they change sides.
#include <catch2/catch.hpp>
#include <functional>

#include "articulates/articulate.hpp"
#include "base/parallel.hpp"
#include "choreography/hands.hpp"
#include "edit/constrain.hpp"
#include "measure/measure.hpp"
#include "snapshot/snapshot.hpp"
#include "step/step.hpp"
#include "support/cases.hpp"
#include "support/random_tree.hpp"
#include "support/watch.hpp"

using namespace pantin;

namespace {

void make_adaptive(World& world, double accuracy = 1e-8) {
  world.settings.integrator = Integrator::adaptive;
  world.settings.accuracy = accuracy;
}

bool by_tree(const World& world) {
  return std::all_of(world.articulates.begin(), world.articulates.end(), [](const auto& a) { return a->by_tree; });
}

/// Momentum, angular momentum and energy of all that is free and in no gravity.
struct Kept {
  Vec3 momentum, angular;
  double energy;
};
Kept kept(const World& world) {
  Kept k{zero3(), zero3(), mechanical_energy(world).total()};
  for (const auto& a : world.articulates)
    for (const Node& n : a->nodes) {
      const Vec3 x = n.is_body ? world.motion[n.slot].x : world.free_motion[n.slot].x;
      const Vec3 p = n.is_body ? world.motion[n.slot].p : world.free_motion[n.slot].v * n.mass;
      k.momentum += p;
      k.angular += cross(x, p);
      if (n.is_body) k.angular += rotate(world.motion[n.slot].q, world.motion[n.slot].angular);
    }
  return k;
}
double change(const Kept& a, const Kept& b) {
  return std::max({norm(a.momentum - b.momentum) / (1.0 + norm(a.momentum)),
                   norm(a.angular - b.angular) / (1.0 + norm(a.angular)),
                   std::fabs(a.energy - b.energy) / (1.0 + std::fabs(a.energy))});
}

}  // namespace

TEST_CASE("tree_drift: random trees end where the reference has them, to the accuracy that is asked") {
  Random random{7};
  for (const int parts : {2, 3, 5, 9, 17, 40, 200})
    for (const bool nailed : {true, false}) {
      cases::RandomTree tree = cases::make_random_tree(random, {parts, nailed, parts == 40 ? 12 : 0});
      const double time = parts > 100 ? 0.1 : 0.3;
      const reference::Hinged all = cases::hinged(tree);
      const reference::State exact = reference::advance(all, time, parts > 100 ? 10 : 12);
      for (const double accuracy : {1e-4, 1e-7, 1e-10}) {
        CAPTURE(parts, nailed, accuracy);
        World world;
        make_adaptive(world, accuracy);
        world.settings.step = 0.01;
        cases::add(world, tree);
        advance(world, time);
        CHECK(world.failure == "");
        CHECK(by_tree(world));
        CHECK(world.stats.newton_iterations == 0);
        CHECK(cases::distance(world, tree, exact) <= 5.0 * accuracy * time + 1e-12 * parts);
        CHECK(largest_gap(world) <= 1e-12);
      }
    }
}

TEST_CASE("tree_drift: the ledger has all of the energy, and what steps change of it on a line of its own") {
  World world;
  make_adaptive(world, 1e-3);
  keep_ledger(world);
  cases::add_chain(world);
  const Watched course = watch(world, 5.0);
  const Ledger& l = world.ledger;
  CHECK(world.failure == "");
  CHECK(by_tree(world));
  CHECK(l.unexplained <= 1e-11 * l.posted);
  CHECK(l.given[static_cast<std::size_t>(Source::projection)] == 0.0);
  const double inexact = l.given[static_cast<std::size_t>(Source::integrator)];
  CHECK(inexact == Approx(mechanical_energy(world).total() - world.start_energy).margin(1e-9));
  CHECK(std::fabs(inexact) > 0.0);
  CHECK(course.energy_error() <= 1e-3);
  CHECK(course.gap <= 1e-12);
}

TEST_CASE("tree_drift: the energy is kept as the accuracy is asked") {
  for (const double accuracy : {1e-4, 1e-7, 1e-10}) {
    World world;
    make_adaptive(world, accuracy);
    cases::add_chain(world);
    CAPTURE(accuracy);
    CHECK(watch(world, 5.0).energy_error() <= 10.0 * accuracy);
  }
}

TEST_CASE("tree_drift: forces of hinges are those of the implicit step") {
  const auto force = [](bool adaptive) {
    World world;
    if (adaptive) make_adaptive(world);
    world.settings.step = 1.0 / 2000;
    const cases::Chain chain = cases::add_chain(world, {.links = 4});
    advance(world, 0.4);
    std::vector<Vec3> list = {world.constraints[chain.pin].force};
    for (const PointId head : chain.heads) list.push_back(world.points[head].row_force);
    return list;
  };
  const std::vector<Vec3> tree = force(true), implicit = force(false);
  for (std::size_t i = 0; i < tree.size(); i++) {
    CAPTURE(i);
    CHECK(norm(tree[i] - implicit[i]) <= 1e-3 * (1.0 + norm(implicit[i])));
  }
}

TEST_CASE("tree_drift: momentum and energy do not jump as a tree changes sides") {
  Random random{11};
  for (const int parts : {2, 7, 30}) {
    cases::RandomTree tree = cases::make_random_tree(random, {parts, false, 0});
    CAPTURE(parts);
    World world;
    make_adaptive(world, 1e-12);
    world.settings.gravity = zero3();
    world.settings.step = 1.0 / 240;
    cases::add(world, tree);
    step(world);
    REQUIRE(by_tree(world));
    for (int i = 0; i < 6; i++) {
      // Off and on again: by the implicit step with fixed steps, then by the tree.
      const Kept before = kept(world);
      world.settings.integrator = i % 2 == 0 ? Integrator::verlet : Integrator::adaptive;
      world.settings.accuracy = i % 2 == 0 ? std::optional<double>() : 1e-12;
      step(world);
      CHECK(by_tree(world) == (i % 2 == 1));
      if (i % 2 == 1) CHECK(change(kept(world), before) <= 1e-12);
      if (i % 2 == 0) CHECK(change(kept(world), before) <= 1e-11);  // the implicit step's own
      for (int k = 0; k < 10; k++) step(world);
    }
  }
}

TEST_CASE("tree_drift: kicks, hands, cuts and loops in mid-flight") {
  World world;
  make_adaptive(world, 1e-9);
  keep_ledger(world);
  const cases::Chain chain = cases::add_chain(world, {.links = 6});
  const std::int32_t hand = add_hand(world, [](double time) { return vec(4 + time, 0.5, 0.5); });
  const auto run = [&](double until, bool tree) {
    advance(world, until);
    CHECK(world.failure == "");
    CHECK(by_tree(world) == tree);
    CHECK(largest_gap(world) <= 1e-11);
  };
  run(0.2, true);
  set_velocity(world, chain.bodies[3], vec(0, 2, 1));
  run(0.4, true);
  grab(world, hand, chain.tails[4], 200.0);
  run(0.6, false);
  release(world, hand);
  run(0.8, true);
  cut(world, chain.hinges[2]);
  run(1.0, true);
  CHECK(world.articulates.size() == 2);
  add_nail(world, chain.tails[2]);  // a loop
  advance(world, 1.2);
  CHECK(world.failure == "");
  CHECK_FALSE(world.articulates[0]->by_tree);
  CHECK(world.articulates[1]->by_tree);
  CHECK(world.ledger.unexplained <= 1e-10 * world.ledger.posted);
}

TEST_CASE("tree_drift: what is no tree of hinges, or is acted on, stays with the implicit step") {
  const auto goes_by_tree = [](const std::function<void(World&, const cases::Chain&)>& tie) {
    World world;
    make_adaptive(world, 1e-4);
    const cases::Chain chain = cases::add_chain(world, {.links = 3});
    tie(world, chain);
    advance(world, 0.1);
    CHECK(world.failure == "");
    CHECK(by_tree(world) == (world.stats.newton_iterations == 0));
    return by_tree(world);
  };
  CHECK(goes_by_tree([](World&, const cases::Chain&) {}));
  CHECK_FALSE(goes_by_tree([](World& world, const cases::Chain& chain) { add_nail(world, chain.tails.back()); }));
  CHECK_FALSE(
      goes_by_tree([](World& world, const cases::Chain& chain) { add_rod(world, chain.tails.back(), vec(3, 3, 0)); }));
  CHECK_FALSE(goes_by_tree([](World& world, const cases::Chain& chain) {
    FollowDef follow;
    follow.max_force = 10.0;
    follow.target = [](double t) { return vec(3, t, 0); };
    add_follow(world, chain.tails.back(), follow);
  }));
  CHECK_FALSE(
      goes_by_tree([](World& world, const cases::Chain& chain) { add_shape(world, chain.bodies[2], ShapeDef{}); }));
  CHECK(goes_by_tree([](World& world, const cases::Chain&) {
    ShapeDef floor;
    floor.geometry = HalfSpaceShape{};
    floor.at = vec(0, 0, -100);
    add_shape(world, floor);  // which no body of the chain can touch
  }));
}

TEST_CASE("tree_drift: a tree that becomes too stiff goes over to the implicit step, and comes back") {
  World world;
  make_adaptive(world, 1e-4);
  world.settings.step = 1.0 / 60;
  const cases::Chain chain = cases::add_chain(world, {.links = 5});
  advance(world, 0.5);
  CHECK(by_tree(world));
  BodyDef heavy;
  heavy.at = position(world, chain.tails.back()) + vec(0, -0.5, 0);
  heavy.mass = 1e6;
  heavy.inertia = diagonal(vec(1e5, 1e5, 1e5));
  heavy.velocity = zero3();
  heavy.points = {{}};
  heavy.points[0].at = vec(0, 0.5, 0);
  const BodyId ball = add_body(world, heavy);
  const PointId end = cases::point_of(world, ball, 0);
  const ParticleId hinge = add_hinge(world, std::array{chain.tails.back(), end});
  advance(world, 1.5);
  CHECK(world.failure == "");
  CHECK_FALSE(by_tree(world));
  CHECK(largest_gap(world) <= 1e-9);
  cut(world, hinge);
  remove(world, ball);
  advance(world, 3.0);
  CHECK(by_tree(world));
}

TEST_CASE("tree_drift: an accuracy that no steps reach is told") {
  World world;
  make_adaptive(world, 1e-17);
  cases::add_chain(world, {.links = 3});
  advance(world, 0.05);
  CHECK(world.failure == "");
  CHECK(world.stats.unreached > 0);
}

TEST_CASE("tree_drift: without accuracy only \"adaptive\" moves by trees") {
  const auto moved = [](Integrator integrator, std::optional<double> accuracy) {
    World world;
    world.settings.integrator = integrator;
    world.settings.accuracy = accuracy;
    cases::add_chain(world);
    advance(world, 0.05);
    return by_tree(world);
  };
  CHECK(moved(Integrator::adaptive, {}));
  CHECK(moved(Integrator::verlet, 1e-5));
  CHECK_FALSE(moved(Integrator::verlet, {}));
}

TEST_CASE("tree_drift: the same bits for any number of threads, and after a snapshot") {
  const auto hash = [](int threads, bool wound_back) {
    World world;
    world.workers = std::make_unique<Workers>(threads);
    make_adaptive(world, 1e-6);
    for (int i = 0; i < 20; i++) cases::add_chain(world, {.links = 3 + i, .start = vec(0, 0, i)});
    advance(world, 0.1);
    const Snapshot then = take_snapshot(world);
    if (wound_back) {
      advance(world, 0.2);
      restore(world, then);
    }
    advance(world, 0.3);
    CHECK(world.failure == "");
    return state_hash(world);
  };
  const std::uint64_t alone = hash(1, false);
  CHECK(hash(2, false) == alone);
  CHECK(hash(1, true) == alone);
}

TEST_CASE("tree_drift: what hangs at rest stays at rest, and sleeps") {
  World world;
  make_adaptive(world, 1e-4);
  const cases::Chain chain = cases::add_chain(world, {.links = 1});
  BodyDef rod;
  rod.at = vec(5, -0.5, 0);
  rod.orientation = {std::sqrt(0.5), 0, 0, -std::sqrt(0.5)};
  const BodyId first = cases::add_rod_body(world, 1.0, 1.0, rod);
  rod.at = vec(5, -1.5, 0);
  const BodyId second = cases::add_rod_body(world, 1.0, 1.0, rod);
  const auto end = [&](BodyId body, std::size_t k) { return cases::point_of(world, body, k); };
  add_nail(world, end(first, 0));
  add_hinge(world, std::array{end(first, 1), end(second, 0)});
  advance(world, 5.0);
  CHECK(norm(world.motion_of(second).x - vec(5, -1.5, 0)) <= 1e-8);
  const auto asleep = [](const auto& a) { return a->rest.asleep; };
  CHECK(std::count_if(world.articulates.begin(), world.articulates.end(), asleep) == 1);
  CHECK(norm(world.motion_of(chain.bodies[0]).p) > 0.1);
}

TEST_CASE(
    "tree_drift: a tree goes on from where another integrator has left it, and a hinge breaks at its mean force") {
  World world;
  world.settings.integrator = Integrator::adaptive;
  const cases::Chain chain = cases::add_chain(world, {.links = 4});
  advance(world, 0.2);
  world.settings.integrator = Integrator::euler;
  advance(world, 0.4);
  const Vec3 x = world.motion_of(chain.bodies[3]).x, v = velocity(world, chain.tails[3]);
  world.settings.integrator = Integrator::adaptive;
  step(world);
  CHECK(by_tree(world));
  CHECK(norm(world.motion_of(chain.bodies[3]).x - x) <= 2.0 * norm(v) * world.settings.step);
  set_breaks_at(world, chain.hinges[1], Breaking{30.0});
  advance(world, 1.0);
  CHECK(world.articulates.size() == 2);
  CHECK(by_tree(world));
}
