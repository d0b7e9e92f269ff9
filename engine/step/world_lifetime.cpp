// Here, since what a world owns is known whole only to the step.
#include "articulates/solve/sub_steps.hpp"
#include "base/parallel.hpp"
#include "contacts/find.hpp"
#include "contacts/gather.hpp"
#include "forces/forces.hpp"
#include "step/reject.hpp"
#include "trees/tree.hpp"
#include "world/world.hpp"

namespace pantin {

World::World() : workers(std::make_unique<Workers>()) {}
World::~World() = default;

}  // namespace pantin
