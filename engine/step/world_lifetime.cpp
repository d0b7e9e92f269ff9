// Here, since what a world owns is known whole only to the step.
#include <atomic>

#include "articulates/solve/sub_steps.hpp"
#include "base/parallel.hpp"
#include "contacts/find.hpp"
#include "contacts/gather.hpp"
#include "forces/forces.hpp"
#include "step/reject.hpp"
#include "trees/tree.hpp"
#include "world/world.hpp"

namespace pantin {

namespace {
std::atomic<std::uint64_t> worlds_made{0};
}  // namespace

World::World() : number(++worlds_made), workers(std::make_unique<Workers>()) {}
World::~World() = default;

}  // namespace pantin
