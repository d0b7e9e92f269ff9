#include "world/choreography.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "world/editing.hpp"

namespace pantin {
namespace {

constexpr std::uint64_t most_at_once = 1'000'000;  // events of one call: more is an event that sets itself again

bool later(const Choreography::Due& a, const Choreography::Due& b) {
  return a.time != b.time ? a.time > b.time : a.serial > b.serial;
}

void queue(Choreography& c, const Choreography::Due& due) {
  c.heap.push_back(due);
  std::push_heap(c.heap.begin(), c.heap.end(), later);
}

/// Takes what was cancelled out of the queue once it is most of it.
void tidy(Choreography& c) {
  if (c.heap.size() <= 2 * c.events.size() + 64) return;
  std::erase_if(c.heap, [&](const Choreography::Due& due) { return !c.events.alive(due.event); });
  std::make_heap(c.heap.begin(), c.heap.end(), later);
}

std::string name_of(const Event& event) {
  return event.label.empty() ? text("event ", event.serial) : text("event ", event.label);
}

/// "scene.lua:12: ", where the event is known to come from.
std::string place_of(const Choreography& c, EventId id) {
  return c.events.alive(id) && !c.events[id].label.empty() ? c.events[id].label + ": " : "choreography: ";
}

void finish(World& world, EventId id, EventState state) {
  Choreography& c = world.choreography;
  *c.events[id].state = state;
  const std::string what = name_of(c.events[id]);
  c.events.remove(id, {what, world.time, state == EventState::cancelled ? editing::culprit(world) : "its end"});
}

/// Why a target is gone.
std::string story(const World& world, const AnyId& target) {
  const auto* group = std::get_if<GroupId>(&target);
  if (group && world.groups.alive(*group)) return text("no member of ", describe(world, target), " lives any more");
  return describe(world, target);
}

bool has_target(const Event& event) { return !std::holds_alternative<std::monostate>(event.target); }

void fire(World& world, const Choreography::Due& due) {
  Choreography& c = world.choreography;
  Event& event = c.events[due.event];
  if (has_target(event) && !alive(world, event.target)) {
    log_line(world, "dropped", text(name_of(event), ", due at ", due.time, " s: ", story(world, event.target)));
    return finish(world, due.event, EventState::dropped);
  }
  event.fired++;
  // A copy: the action may cancel its own event. All is settled before it runs, for it may throw.
  const std::function<void()> action = event.action;
  if (event.period > 0.0)
    queue(c, {event.first + static_cast<double>(event.fired) * event.period, event.serial, due.event});
  else
    finish(world, due.event, EventState::fired);
  action();
}

}  // namespace

EventId add_event(World& world, Event event) {
  editing::require_unlocked(world, "event");
  editing::require_finite("event", "time", event.first, "s");
  editing::require_not_negative("event", "period", event.period, "s");
  require(with_round_off(event.first) >= world.time, "event: its time must not be past, got ", event.first,
          " s, and it is ", world.time, " s now");
  require(static_cast<bool>(event.action), "event: it has no action");
  require(event.period == 0.0 || with_round_off(event.first) < event.first + event.period,
          "event: its period must be long enough to tell two times apart, got ", event.period, " s");
  if (has_target(event) && !alive(world, event.target) && !std::holds_alternative<GroupId>(event.target))
    throw Error(text("event: ", describe(world, event.target)));
  event.state = std::make_shared<EventState>(EventState::waiting);
  event.fired = 0;
  event.serial = world.next_serial++;
  const double first = event.first;
  const std::uint64_t serial = event.serial;
  const EventId id = world.choreography.events.add(std::move(event));
  queue(world.choreography, {first, serial, id});
  return id;
}

void cancel(World& world, EventId event) {
  editing::require_unlocked(world, "cancel");
  if (!world.choreography.events.alive(event)) return;
  finish(world, event, EventState::cancelled);
  tidy(world.choreography);
}

void fire_events(World& world, double time) {
  auto& heap = world.choreography.heap;
  const double reached = with_round_off(time);
  for (std::uint64_t count = 0; !heap.empty() && heap.front().time <= reached; count++) {
    require(count < most_at_once, place_of(world.choreography, heap.front().event), most_at_once,
            " events in one step; does one set itself again without a delay, or is a period far below the step?");
    std::pop_heap(heap.begin(), heap.end(), later);
    const Choreography::Due due = heap.back();
    heap.pop_back();
    if (world.choreography.events.alive(due.event)) fire(world, due);
  }
}

}  // namespace pantin
