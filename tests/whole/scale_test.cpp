// Molecules and planets: the same chain in other units of length and mass moves in the same way.
#include <catch2/catch.hpp>
#include <cmath>

#include "step/step.hpp"
#include "support/cases.hpp"
#include "support/reference.hpp"
#include "support/watch.hpp"

using namespace pantin;

namespace {

/// Figures of chain(10) in units of its link's length, and of its largest kinetic energy.
struct Relative {
  double gap = 0.0;
  double energy = 0.0;  ///< with the return
  double energy_unreturned = 0.0;
  double end = 0.0;      ///< distance of the last link's centre from the reference at 1 s
  double kinetic = 0.0;  ///< largest, of mass · gravity · length
};

void make(World& world, cases::Chain& chain, double length, double mass, bool energy_return) {
  world.settings.gravity = vec(0, -9.81 * length, 0);
  world.settings.energy_return = energy_return;
  chain = cases::add_chain(world, {.links = 10, .length = length, .mass = mass});
}

Relative relative_figures(double length, double mass) {
  Relative figures;
  cases::Chain chain;
  World world, unreturned, short_run;
  make(world, chain, length, mass, true);
  const Watched course = watch(world, 5.0);
  CHECK(course.failure == "");
  CHECK(course.finite);
  CHECK(world.stats.fallback_steps == 0);
  figures.gap = course.gap / length;
  figures.energy = course.energy_error();
  figures.kinetic = course.kinetic / (mass * 9.81 * length * length);
  make(unreturned, chain, length, mass, false);
  figures.energy_unreturned = watch(unreturned, 5.0).energy_error();
  make(short_run, chain, length, mass, true);
  advance(short_run, 1.0);
  const reference::PlaneChain plane = reference::plane_chain(10);
  const Eigen::Vector2d position = reference::centre(plane, reference::advance(plane, 1.0, 100), 9);
  figures.end = norm(short_run.motion_of(chain.bodies.back()).x / length - vec(position.x(), position.y(), 0));
  return figures;
}

void same_figures(const Relative& a, const Relative& b) {
  CHECK(b.gap <= 1e-10);
  CHECK(b.energy <= 1e-9);
  CHECK(b.energy_unreturned <= 2 * a.energy_unreturned);
  CHECK(b.energy_unreturned >= a.energy_unreturned / 2);
  CHECK(b.end <= 2 * a.end);
  CHECK(b.end >= a.end / 2);
  CHECK(b.kinetic == Approx(a.kinetic).epsilon(1e-3));
}

}  // namespace

TEST_CASE("scale: links of a nanometre and of a thousand kilometres move as links of a metre do") {
  const Relative metre = relative_figures(1.0, 1.0);
  CHECK(metre.end <= 7e-5);
  CHECK(metre.energy_unreturned <= 5e-4);
  const double length = GENERATE(1e-9, 1e6);
  CAPTURE(length);
  same_figures(metre, relative_figures(length, 1.0));
}

TEST_CASE("scale: the mass of an atom or of a mountain changes nothing") {
  const Relative kilogram = relative_figures(1.0, 1.0);
  const double mass = GENERATE(1e-26, 1e12);
  CAPTURE(mass);
  same_figures(kilogram, relative_figures(1.0, mass));
}
