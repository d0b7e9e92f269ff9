#include "snapshot/world_state.hpp"

#include <algorithm>

#include "articulates/build/build.hpp"
#include "base/hash.hpp"
#include "contacts/find.hpp"
#include "contacts/gather.hpp"
#include "forces/solved.hpp"
#include "snapshot/check_read.hpp"
#include "snapshot/state_fields.hpp"

namespace pantin {
namespace {

template <class A>
void visit_articulates(A& a, World& world) {
  const std::size_t size = visit_size(a, world.articulates.size());
  if constexpr (A::reads) world.articulates.clear();
  for (std::size_t i = 0; i < size; i++) {
    if constexpr (A::reads) world.articulates.push_back(std::make_unique<Articulate>());
    visit(a, *world.articulates[i]);
  }
}

template <class A>
void visit_forces(A& a, World& world) {
  bool has = world.forces != nullptr;
  visit(a, has);
  if constexpr (A::reads) world.forces = has ? std::make_unique<Forces>() : nullptr;
  if (!has) return;
  a.forces = world.forces.get();
  visit(a, *world.forces);
}

/// What stages of touch keep from one to the other is for the present step alone; but it is there.
template <class A>
void visit_touch(A& a, World& world) {
  bool has = world.touch_space != nullptr;
  visit(a, has);
  if constexpr (A::reads) world.touch_space = has ? std::make_unique<TouchSpace>() : nullptr;
}

/// Where shapes were, for all of them; things that were made since go nowhere yet.
void check_shapes(ShapesThen& then, const World& world) {
  if (!then.known) return;
  require(then.shapes.size() >= world.shapes.slots(), "where its shapes were contradicts itself");
  const auto is_there = [&](const BroadPhase::Pair& pair) {
    return std::max(pair.first, pair.second) < world.shapes.slots() && world.shapes.alive_at(pair.first) &&
           world.shapes.alive_at(pair.second) && world.shapes.at_slot(pair.first).body;
  };
  require(std::all_of(then.rebounding.begin(), then.rebounding.end(), is_there),
          "its shapes that rebound contradict themselves");
  then.going.resize(std::max(then.going.size(), std::size_t{world.bodies.slots()} + world.points.slots()));
}

template <class A>
void visit_all_of(A& a, World& world) {
  a.world = &world;
  visit(a, static_cast<WorldData&>(world));
  visit_articulates(a, world);
  visit_forces(a, world);
  visit_touch(a, world);
}

/// Laws of solved connections are told what they read, as when a snapshot is restored.
void tell_solved(World& world) {
  if (world.topology_changed || world.force_elements_changed) return;
  std::vector<Rest> rests;
  for (const auto& articulate : world.articulates) rests.push_back(articulate->rest);
  set_solved_inputs(world, false);
  for (std::size_t i = 0; i < rests.size(); i++) world.articulates[i]->rest = rests[i];
}

/// A kick may ask for them before the next step's conditions are loaded.
void give_paths(World& world) {
  for (const auto& articulate : world.articulates)
    for (Condition& c : articulate->conditions)
      if (world.constraints.alive(c.constraint))
        if (const auto* data = std::get_if<PathData>(&world.constraints[c.constraint].own)) c.path = data->path.get();
}

}  // namespace

void visit_world(Writer& to, World& world) {
  visit_all_of(to, world);
  ShapesThen shapes;
  keep_shapes(world.contact_finder.get(), world, shapes);
  visit(to, shapes);
}

void visit_world(Reader& from, World& world) {
  world.contact_finder.reset();
  visit_all_of(from, world);
  ShapesThen shapes;
  visit(from, shapes);
  for (const auto& articulate : world.articulates) lay_out_again(*articulate);
  check_read(from, world);
  check_shapes(shapes, world);
  put_back(world.contact_finder, world, shapes);
  give_paths(world);
  tell_solved(world);
}

void visit_law(Writer& to, std::shared_ptr<const Law>& law) { visit(to, law); }
void visit_law(Reader& from, std::shared_ptr<const Law>& law) { visit(from, law); }

std::uint64_t layout_of_state() {
  constexpr std::uint64_t version = 5;
  Hash hash;
  for (const std::uint64_t part :
       {version,           sizeof(WorldData), sizeof(Articulate), sizeof(Forces),     sizeof(Row),
        sizeof(Condition), sizeof(Node),      sizeof(NodeBatch),  sizeof(Constraint), sizeof(Contact),
        sizeof(Event),     sizeof(Law),       sizeof(Particle),   sizeof(Body),       sizeof(Motion),
        sizeof(Shape),     sizeof(ShapeNow),  sizeof(Emitter),    sizeof(Receiver),   sizeof(ActingConnections)})
    hash.add(part);
  return hash.value;
}

}  // namespace pantin
