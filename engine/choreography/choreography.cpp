#include "choreography/choreography.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "choreography/conditions.hpp"
#include "choreography/resume.hpp"
#include "world/checks.hpp"
#include "world/record.hpp"

namespace pantin {
namespace {

constexpr std::uint64_t most_at_once = 1'000'000;  // events of one call: more is an event that sets itself again

bool later(const Choreography::Due& a, const Choreography::Due& b) {
  return a.time != b.time ? a.time > b.time : a.serial > b.serial;
}

void queue(Choreography& c, double time, EventId id) {
  Event& event = c.events[id];
  event.queued = true;
  c.heap.push_back({time, event.serial, id});
  std::push_heap(c.heap.begin(), c.heap.end(), later);
}

/// From the next step on it is looked at in each.
void watch(Choreography& c, EventId id) {
  Event& event = c.events[id];
  event.watched = true;
  if (!event.listed) c.watching.push_back(id);
  event.listed = true;
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

bool has_target(const Event& event) { return !std::holds_alternative<std::monostate>(event.target); }

TimelineEntry entry_of(const World& world, const Event& event, double time) {
  return {event.kind,  *event.state, time,
          event.time,  event.until,  event.period,
          event.fired, event.label,  has_target(event) ? describe(world, event.target) : "",
          event.serial};
}

void finish(World& world, EventId id, EventState state) {
  Choreography& c = world.choreography;
  *c.events[id].state = state;
  const std::string what = name_of(c.events[id]);
  c.past.push_back(entry_of(world, c.events[id], world.time));
  if (c.past.size() > most_told) c.past.pop_front();
  c.events.remove(id, {what, world.time, state == EventState::cancelled ? internal::culprit(world) : "its end"});
}

/// Why a target is gone.
std::string story(const World& world, const AnyId& target) {
  const auto* group = std::get_if<GroupId>(&target);
  if (!group || !world.groups.alive(*group)) return describe(world, target);
  const auto& members = world.groups[*group].members;
  const std::string last = members.empty() ? "" : ": " + describe(world, members.back());
  return text("no member of ", describe(world, target), " lives any more", last);
}

void drop(World& world, EventId id, const std::string& when, const std::string& why) {
  log_line(world, "dropped", text(name_of(world.choreography.events[id]), when, ": ", why));
  finish(world, id, EventState::dropped);
}

/// When an event that waits for a time is due next, [s].
double next_due(const Event& event) {
  return event.kind == EventKind::every ? event.time + static_cast<double>(event.fired + 1) * event.period : event.time;
}

// Each of these settles all before it calls what the event does, for that may throw, or cancel its own event.

void fire_once(World& world, EventId id) {
  Event& event = world.choreography.events[id];
  event.fired++;
  const std::function<void()> action = event.action;
  if (event.kind == EventKind::every)
    queue(world.choreography, next_due(event), id);
  else if (!event.condition.again)
    finish(world, id, EventState::fired);
  action();
}

void go_over(World& world, EventId id, double time) {
  Event& event = world.choreography.events[id];
  const double part = (time - event.time) / (event.until - event.time);
  const bool ends = with_round_off(time) >= event.until;
  const std::function<void(double)> progress = event.progress;
  event.fired++;
  watch(world.choreography, id);
  if (ends) finish(world, id, EventState::fired);
  progress(ends ? 1.0 : std::fmax(part, 0.0));
}

/// A play that fails is over.
std::optional<Wait> go_on(World& world, EventId id) {
  const std::function<std::optional<Wait>()> goes = world.choreography.events[id].goes;
  try {
    return goes();
  } catch (const Gone& gone) {
    if (world.choreography.events.alive(id)) drop(world, id, "", gone.what());
  } catch (...) {
    if (world.choreography.events.alive(id)) finish(world, id, EventState::dropped);
    throw;
  }
  return {};
}

void play(World& world, EventId id, double due, double time) {
  Choreography& c = world.choreography;
  c.events[id].fired++;
  c.events[id].watched = false;
  const std::optional<Wait> wait = go_on(world, id);
  if (!c.events.alive(id)) return;  // it was dropped, or cancelled itself
  if (!wait) return finish(world, id, EventState::fired);
  Event& event = c.events[id];
  event.waits_for = wait->until;
  const bool in_time = with_round_off(due) >= time;  // then waits of whole steps add up without round-off
  event.time = (in_time ? time : due) + wait->delay;
  if (wait->until || !(wait->delay > 0.0))
    watch(c, id);
  else
    queue(c, event.time, id);
}

bool asked(World& world, EventId id) {
  Event& event = world.choreography.events[id];
  if (event.kind == EventKind::play) {
    const Lock lock(world);
    return !event.waits_for || event.waits_for();
  }
  if (event.kind != EventKind::when) return true;
  for (const AnyId& thing : event.condition.of)
    if (!still_there(world, thing)) throw Gone(text("what it watches is gone: ", describe(world, thing)));
  return begins_to_hold(world, id);
}

/// Whether what a watched event waits for holds now. One that cannot be asked any more is dropped.
bool holds(World& world, EventId id) {
  try {
    return asked(world, id);
  } catch (const Gone& gone) { drop(world, id, "", gone.what()); }
  return false;
}

void fire(World& world, const Choreography::Due& due, double time) {
  Choreography& c = world.choreography;
  const EventId id = due.event;
  c.events[id].queued = false;
  if (!holds(world, id)) return;
  Event& event = c.events[id];
  if (has_target(event) && !alive(world, event.target))
    return drop(world, id, text(", due at ", event.kind == EventKind::over ? event.time : due.time, " s"),
                story(world, event.target));
  if (event.kind == EventKind::over) return go_over(world, id, time);
  if (event.kind == EventKind::play) return play(world, id, due.time, time);
  fire_once(world, id);
}

/// What is looked at in each step takes its place at the end of this one.
void queue_watched(Choreography& c, double time) {
  std::erase_if(c.watching,
                [&](EventId id) { return !c.events.alive(id) || !(c.events[id].listed = c.events[id].watched); });
  for (EventId id : c.watching)
    if (!c.events[id].queued) queue(c, time, id);
}

void check_kind(const World& world, const Event& event) {
  const bool acts = event.kind == EventKind::over   ? static_cast<bool>(event.progress)
                    : event.kind == EventKind::play ? static_cast<bool>(event.goes)
                                                    : static_cast<bool>(event.action);
  require(acts, "event: it has no action");
  if (event.kind == EventKind::every) {
    internal::require_positive("event", "period", event.period, "s");
    require(with_round_off(event.time) < event.time + event.period,
            "event: its period must be long enough to tell two times apart, got ", event.period, " s");
  }
  if (event.kind == EventKind::over) {
    internal::require_finite("event", "end", event.until, "s");
    require(event.until > event.time, "event: its end must be after its beginning at ", event.time, " s, got ",
            event.until, " s");
  }
  if (event.kind == EventKind::when) check(world, event.condition);
}

}  // namespace

EventId add_event(World& world, Event event) {
  internal::require_unlocked(world, "event");
  if (event.kind == EventKind::when) event.time = world.time;
  internal::require_finite("event", "time", event.time, "s");
  require(with_round_off(event.time) >= world.time, "event: its time must not be past, got ", event.time,
          " s, and it is ", world.time, " s now");
  check_kind(world, event);
  if (has_target(event) && !alive(world, event.target) && !std::holds_alternative<GroupId>(event.target))
    throw Error(text("event: ", describe(world, event.target)));
  event.state = std::make_shared<EventState>(EventState::waiting);
  event.fired = 0;
  event.queued = event.watched = event.listed = event.held = false;
  event.serial = world.next_serial++;
  Choreography& c = world.choreography;
  const EventId id = c.events.add(std::move(event));
  if (c.events[id].kind == EventKind::when)
    watch(c, id);
  else
    queue(c, next_due(c.events[id]), id);
  return id;
}

void end_event(World& world, EventId event, EventState state) {
  if (world.choreography.events.alive(event)) finish(world, event, state);
}

void begin_at(World& world, double time, double fired) {
  world.time = world.step_origin = time;
  world.step_count = 0;
  Choreography& c = world.choreography;
  c.reached = fired;
  const double reached = with_round_off(fired);
  c.heap.clear();
  for (EventId id : c.events.ids()) {
    Event& event = c.events[id];
    event.queued = false;
    if (event.kind == EventKind::play) event.time = time;
    if (event.kind == EventKind::every && event.time < reached)
      event.fired = static_cast<std::uint64_t>((reached - event.time) / event.period);
    const bool past = (event.kind == EventKind::once && event.time <= reached) ||
                      (event.kind == EventKind::over && event.until <= reached);
    if (past)
      finish(world, id, EventState::fired);
    else if (!event.watched)
      queue(c, next_due(event), id);
  }
}

void cancel(World& world, EventId event) {
  internal::require_unlocked(world, "cancel");
  if (!world.choreography.events.alive(event)) return;
  finish(world, event, EventState::cancelled);
  tidy(world.choreography);
}

void fire_due(World& world, double time) {
  Choreography& c = world.choreography;
  queue_watched(c, time);
  const double reached = with_round_off(time);
  for (std::uint64_t count = 0; !c.heap.empty() && c.heap.front().time <= reached; count++) {
    require(count < most_at_once, place_of(c, c.heap.front().event), most_at_once,
            " events in one step; does one set itself again without a delay, or is a period far below the step?");
    std::pop_heap(c.heap.begin(), c.heap.end(), later);
    const Choreography::Due due = c.heap.back();
    c.heap.pop_back();
    if (c.events.alive(due.event)) fire(world, due, time);
  }
}

std::vector<TimelineEntry> timeline(const World& world) {
  const Choreography& c = world.choreography;
  std::vector<TimelineEntry> list(c.past.begin(), c.past.end());
  std::vector<Choreography::Due> coming;
  for (const Choreography::Due& due : c.heap)
    if (c.events.alive(due.event) && !c.events[due.event].watched) coming.push_back(due);
  const std::size_t most = std::min(most_told, coming.size());
  const auto end = coming.begin() + static_cast<std::ptrdiff_t>(most);
  std::partial_sort(coming.begin(), end, coming.end(), [](const auto& a, const auto& b) { return later(b, a); });
  for (auto due = coming.begin(); due != end; due++) list.push_back(entry_of(world, c.events[due->event], due->time));
  for (EventId id : c.watching) {
    if (!c.events.alive(id) || !c.events[id].watched || list.size() >= 3 * most_told) continue;
    const bool over = c.events[id].kind == EventKind::over;
    list.push_back(entry_of(world, c.events[id], over ? world.time : std::numeric_limits<double>::quiet_NaN()));
  }
  return list;
}

}  // namespace pantin
