#include "world/record.hpp"

namespace pantin::internal {

std::string culprit(const World& world) {
  std::string name = world.who ? world.who() : "";
  return name.empty() ? "the program" : name;
}

void acted(World& world) {
  world.last_actor = culprit(world);
  world.last_act = world.time;
}

Obituary obituary(const World& world, std::string what) { return {std::move(what), world.time, culprit(world)}; }

void notice(World& world, Notice::Kind kind, const AnyId& thing, std::string story, std::int32_t hand) {
  world.notices.push_back({kind, thing, hand, std::move(story)});
}

}  // namespace pantin::internal
