// Here, since what a world owns is known whole only to the step.
#include "articulates/sub_steps.hpp"
#include "base/parallel.hpp"
#include "world/attempt.hpp"
#include "world/forces.hpp"
#include "world/world.hpp"

namespace pantin {

World::World() : workers(std::make_unique<Workers>()) {}
World::~World() = default;

}  // namespace pantin
