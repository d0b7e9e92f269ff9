// What hinges made over gaps, joins and cuts leave of the momenta of a free mechanism: all.
#include <catch2/catch.hpp>

#include "base/random.hpp"
#include "edit/assemble.hpp"
#include "edit/constrain.hpp"
#include "measure/measure.hpp"
#include "measure/query.hpp"
#include "step/step.hpp"
#include "support/cases.hpp"

using namespace pantin;

namespace {

/// A few bodies in a row, thrown and spinning, some hinged at once, others to be drawn together.
struct Thrown {
  World world;
  Random random;
  std::vector<BodyId> bodies;
  std::vector<ParticleId> hinges;
  int made = 0, joined = 0, cut_ = 0;

  explicit Thrown(std::uint64_t seed) : random{seed, 0} {
    world.settings.gravity = zero3();
    world.settings.tolerance = 0.2;
    const int count = 2 + static_cast<int>(random.uniform() * 4);
    for (int i = 0; i < count; i++) {
      BodyDef def;
      def.mass = 0.2 + 3.0 * random.uniform();
      def.inertia = diagonal(vec(0.5 + 0.3 * random.uniform(), 0.5 + 0.3 * random.uniform(), 0.6) * (0.1 * def.mass));
      def.at = vec(i, 0, 0) + some(0.02);
      def.velocity = some(2.0);
      def.spin = some(4.0);
      def.points.resize(2);
      def.points[0].at = vec(-0.5, 0, 0) + some(0.02);
      def.points[1].at = vec(0.5, 0, 0) + some(0.02);
      bodies.push_back(add_body(world, def));
    }
  }
  Vec3 some(double most) {
    return vec(random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5) * (2.0 * most);
  }
  PointId point(std::size_t body, std::size_t i) { return world.bodies[bodies[body]].points[i]; }

  /// Between one body and the next.
  void tie(std::size_t i) {
    const PointId ends[] = {point(i, 1), point(i + 1, 0)};
    const double gap = norm(position(world, ends[0]) - position(world, ends[1]));
    if (gap < 0.08) {
      hinges.push_back(add_hinge(world, ends));
      made++;
      return;
    }
    JoinDef def;
    def.time_constant = 0.02 + 0.05 * random.uniform();
    if (random.uniform() < 0.3) def.max_force = 200.0;
    add_join(world, ends[0], ends[1], def);
    joined++;
  }
  void cut_one() {
    if (hinges.empty()) return;
    const auto k = static_cast<std::size_t>(random.uniform() * static_cast<double>(hinges.size()));
    if (world.particles.alive(hinges[k])) cut(world, hinges[k]);
    hinges.erase(hinges.begin() + static_cast<std::ptrdiff_t>(k));
    cut_++;
  }
};

/// Sum of the sizes of what the momenta are sums of.
double size_of_momenta(const World& world, const std::vector<BodyId>& bodies) {
  double size = 0.0;
  for (BodyId id : bodies) {
    const Motion& m = world.motion_of(id);
    size += norm(m.p) * std::fmax(1.0, norm(m.x)) + norm(m.angular);
  }
  return size;
}

}  // namespace

TEST_CASE("hinges made over gaps, joins and cuts keep momentum and angular momentum of what is free") {
  int made = 0, joined = 0, cuts = 0;
  double worst_p = 0.0, worst_angular = 0.0;
  for (std::uint64_t seed = 1; seed <= 1000; seed++) {
    Thrown scene(seed);
    World& world = scene.world;
    const Things all = everything(world);
    const Vec3 p = momentum(world, all), L = angular_momentum(world, all);
    double size = size_of_momenta(world, scene.bodies);
    for (int i = 0; i < 24; i++) {
      if (i % 8 == 7) scene.cut_one();
      if (i % 4 == 0 && static_cast<std::size_t>(i / 4) + 1 < scene.bodies.size())
        scene.tie(static_cast<std::size_t>(i / 4));
      step(world);
      REQUIRE(world.failure == "");
      size = std::fmax(size, size_of_momenta(world, scene.bodies));
      worst_p = std::fmax(worst_p, norm(momentum(world, all) - p) / size);
      const double off = norm(angular_momentum(world, all) - L) / size;
      CAPTURE(seed, i);
      if (off > 1e-12) CHECK(off <= 1e-12);
      worst_angular = std::fmax(worst_angular, off);
    }
    made += scene.made;
    joined += scene.joined;
    cuts += scene.cut_;
  }
  CAPTURE(made, joined, cuts);
  CHECK(made > 300);
  CHECK(joined > 300);
  CHECK(cuts > 300);
  CHECK(worst_p <= 1e-12);
  CHECK(worst_angular <= 1e-12);
}
