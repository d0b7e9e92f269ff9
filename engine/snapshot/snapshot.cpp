#include "snapshot/snapshot.hpp"

#include <optional>
#include <utility>
#include <vector>

#include "articulates/articulate.hpp"
#include "contacts/find.hpp"
#include "edit/common.hpp"
#include "forces/forces.hpp"
#include "forces/solved.hpp"

namespace pantin {

struct Snapshot::Held {
  std::uint64_t world = 0;  // its number
  WorldData data;
  std::vector<Articulate> articulates;
  std::optional<Forces> forces;
  ShapesThen shapes;
};

namespace {

/// Handles of events outlive their rows; what they tell is kept beside these.
void tell_events(const Store<Event>& before, const Store<Event>& now) {
  for (EventId id : before.ids())
    if (!now.alive(id)) *before[id].state = EventState::cancelled;
  for (EventId id : now.ids()) *now[id].state = EventState::waiting;
}

const Event* play_in(const WorldData& world) {
  const auto& events = world.choreography.events;
  const Event* first = nullptr;
  for (std::uint32_t s = 0; s < events.slots(); s++)
    if (const Event& event = events.at_slot(s); events.alive_at(s) && event.kind == EventKind::play)
      if (!first || event.serial < first->serial) first = &event;
  return first;
}

std::string name_of(const Event& play) { return play.label.empty() ? "a play" : play.label; }

constexpr const char* advice = "), which cannot be wound back";

}  // namespace

const Snapshot::Held& Snapshot::held() const {
  require(held_ != nullptr, "snapshot: it is empty; take_snapshot(world) makes one");
  return *held_;
}

double Snapshot::time() const { return held().data.time; }
std::uint64_t Snapshot::steps() const { return held().data.steps; }

Snapshot take_snapshot(const World& world) {
  Snapshot snapshot;
  take_snapshot(world, snapshot);
  return snapshot;
}

void take_snapshot(const World& world, Snapshot& into) {
  require(!world.locked, "snapshot: none can be taken while the world steps; take it in an event or a step callback");
  if (!into.held_ || into.held_.use_count() > 1) into.held_ = std::make_shared<Snapshot::Held>();
  Snapshot::Held& held = *into.held_;
  held.world = world.number;
  held.data = world;
  held.articulates.resize(world.articulates.size());
  for (std::size_t i = 0; i < held.articulates.size(); i++) held.articulates[i] = *world.articulates[i];
  keep_shapes(world.contact_finder.get(), world, held.shapes);
  held.forces.reset();
  if (world.forces) held.forces.emplace(*world.forces);
}

bool can_restore(const World& world) { return !play_in(world); }

std::string why_not_restore(const World& world) {
  const Event* play = play_in(world);
  return play ? text("the scene's script waits (", name_of(*play), advice) : "";
}

std::string why_not_restore(const World& world, const Snapshot& snapshot) {
  if (!snapshot.held_) return "the snapshot is empty";
  if (snapshot.held_->world != world.number) return "the snapshot is of another world";
  const std::string now = why_not_restore(world);
  if (!now.empty()) return now;
  const Event* then = play_in(snapshot.held_->data);
  return then ? text("the scene's script waited at ", snapshot.time(), " s (", name_of(*then), advice) : "";
}

void restore(World& world, const Snapshot& snapshot) {
  internal::require_unlocked(world, "restore");
  require(!world.stepping, "restore: a step is under way; restore between two steps");
  const std::string why = why_not_restore(world, snapshot);
  require(why.empty(), "restore: ", why);
  const Snapshot::Held& held = *snapshot.held_;
  tell_events(world.choreography.events, held.data.choreography.events);
  static_cast<WorldData&>(world) = held.data;
  put_back(world.contact_finder, world, held.shapes);
  world.articulates.resize(held.articulates.size());
  for (std::size_t i = 0; i < held.articulates.size(); i++)
    if (world.articulates[i])
      *world.articulates[i] = held.articulates[i];
    else
      world.articulates[i] = std::make_unique<Articulate>(held.articulates[i]);
  world.forces = held.forces ? std::make_unique<Forces>(*held.forces) : nullptr;
  const bool found_anew = world.topology_changed || world.force_elements_changed;
  if (found_anew) return;
  set_solved_inputs(world, false);  // copies of solved connections share what this sets, which wakes
  for (std::size_t i = 0; i < held.articulates.size(); i++) world.articulates[i]->rest = held.articulates[i].rest;
}

}  // namespace pantin
