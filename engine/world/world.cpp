#include "world/world.hpp"

#include "articulates/sub_steps.hpp"
#include "base/parallel.hpp"
#include "world/attempt.hpp"
#include "world/forces.hpp"

namespace pantin {

World::World() : workers(std::make_unique<Workers>()) {}
World::~World() = default;

void log_line(World& world, std::string kind, std::string text) {
  world.log.push_back({world.time, std::move(kind), std::move(text)});
}

}  // namespace pantin
