#include "scene/headway.hpp"

#include <algorithm>

namespace pantin {
namespace {

constexpr double patience = 100.0;  // times the whole

}  // namespace

Headway::Headway(const World& world) : begin_(world.time), farthest_(world.time) {}

void Headway::check(const World& world, double until) {
  wasted_ = world.time > farthest_ ? 0.0 : wasted_ + world.settings.step;
  farthest_ = std::max(farthest_, world.time);
  require(wasted_ <= patience * (until - begin_),
          "the scene goes back in time again and again, and comes no farther than ", farthest_, " s of ", until,
          " s: scene:finish() ends it, and --until says how far it is to come");
}

}  // namespace pantin
