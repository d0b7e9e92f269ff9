#include "world/world.hpp"

namespace pantin {

void log_line(World& world, std::string kind, std::string text) {
  world.log.push_back({world.time, std::move(kind), std::move(text)});
}

}  // namespace pantin
