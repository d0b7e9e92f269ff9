// Row H of the hard cases: hinges cut and rejoined while all moves.
#include <catch2/catch.hpp>
#include <memory>

#include "edit/assemble.hpp"
#include "step/step.hpp"
#include "support/cases.hpp"
#include "support/endure.hpp"

using namespace pantin;

namespace {

/// Every ten steps the next hinge is cut, and joined again at once.
Scene mended_chain(int links, bool closed) {
  return [=](World& world) {
    const auto chain = std::make_shared<cases::Chain>(closed ? cases::add_ring(world, links)
                                                             : cases::add_chain(world, {.links = links}));
    return [&world, chain, links] {
      if (world.steps % 10 != 0) return;
      const auto i = static_cast<std::size_t>(world.steps / 10) * 7 % static_cast<std::size_t>(links - 1);
      const ParticleId hinge = world.points[chain->tails[i]].particle;
      cut(world, hinge);
      add_hinge(world, std::vector{chain->tails[i], chain->heads[i + 1]});
    };
  };
}

/// Every ten steps the next hinge is cut, and what the last cut let go of is drawn together again.
Scene parted_chain(int links) {
  return [=](World& world) {
    const auto chain = std::make_shared<cases::Chain>(cases::add_chain(world, {.links = links}));
    const auto last = std::make_shared<std::size_t>(~std::size_t{0});
    return [&world, chain, last, links] {
      if (world.steps % 10 != 0) return;
      const auto joined = [&](std::size_t i) {
        return world.particles[world.points[chain->tails[i]].particle].is_hinge();
      };
      const auto i = static_cast<std::size_t>(world.steps / 10) * 7 % static_cast<std::size_t>(links - 1);
      if (joined(i)) cut(world, world.points[chain->tails[i]].particle);
      if (*last < chain->tails.size() && !joined(*last)) add_join(world, chain->tails[*last], chain->heads[*last + 1]);
      *last = i;
    };
  };
}

}  // namespace

TEST_CASE("hard H: a chain and a ring whose hinges are cut and rejoined every ten steps do not feel it") {
  const auto check = [](const World&, const Endured& run) {
    CHECK(run.fallbacks == 0);
    CHECK(run.gap <= 1e-10);
    CHECK(run.energy <= 1e-9);
  };
  for (const double step : step_lengths) {
    endure_at({&step, 1}, "H chain of 20", 600 * step, 1.0, mended_chain(20, false), check);
    endure_at({&step, 1}, "H ring of 24", 600 * step, 1.0, mended_chain(24, true), check);
  }
}

TEST_CASE("hard H: a chain whose links part for ten steps and are drawn together again, over and over") {
  for (const double step : step_lengths) endure_at({&step, 1}, "H parted chain", 300 * step, 1.0, parted_chain(12));
}
