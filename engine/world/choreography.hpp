#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/store.hpp"
#include "model/group.hpp"

namespace pantin {

struct World;

enum class EventState : std::uint8_t { waiting, fired, dropped, cancelled };

/// Something set to happen at a time. A repeating one is due at `first + k * period`, k = 0, 1, …, exactly.
struct Event {
  double first = 0.0;       ///< [s]
  double period = 0.0;      ///< [s] 0: once
  std::uint64_t fired = 0;  ///< how often so far
  AnyId target;             ///< not applied when this is gone; monostate: none
  std::function<void()> action;
  std::string label;                  ///< "scene.lua:12", for the log
  std::shared_ptr<EventState> state;  ///< set by add_event; outlives the row, which goes when all is done
  std::uint64_t serial = 0;
};

using EventId = Handle<Event>;

/// A line of the world's log.
struct LogLine {
  double time = 0.0;  ///< [s]
  std::string kind;   ///< "dropped", "warning", "notice"
  std::string text;
};

/// The queue: events in the order of their time, then of adding.
struct Choreography {
  struct Due {
    double time;  ///< [s]
    std::uint64_t serial;
    EventId event;
  };
  Store<Event> events;
  std::vector<Due> heap;  ///< binary heap, earliest first
};

/// `first` [s] must not be past, `period` [s] 0 or > 0, `action` not empty.
EventId add_event(World& world, Event event);
/// Nothing happens when it is done already.
void cancel(World& world, EventId event);
/// Fires what is due up to `time` [s]. An event whose target is gone is dropped and logged with who removed it.
void fire_events(World& world, double time);

}  // namespace pantin
