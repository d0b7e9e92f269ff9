#pragma once
// Temporal sequencing: what is set to happen at a time, again and again, over a time, or once something holds.
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/check.hpp"
#include "base/store.hpp"
#include "model/group.hpp"

namespace pantin {

struct World;

/// Thrown by what an event asks or calls when that needs something that was removed: a when or a play is dropped.
struct Gone : Error {
  using Error::Error;
};

enum class EventState : std::uint8_t { waiting, fired, dropped, cancelled };

/// once: at `time`. every: at `time` + k · `period`, k = 1, 2, …, exactly. over: in each step from `time` to `until`.
/// when: in the step at whose beginning its condition begins to hold. play: goes on at `time`, and then after each of
/// its waits. What is due at a time runs at the beginning of the first step whose own time is not before it.
enum class EventKind : std::uint8_t { once, every, over, when, play };

/// Something measured, that is to get above or below a limit.
struct Measured {
  std::function<double()> measure;  ///< not empty
  double limit = 0.0;               ///< of the measure's unit
  bool above = true;                ///< else below
  double mean = 0.0;                ///< [s] >= 0; averaged over so long, and not told before
  bool again = false;               ///< at each crossing, not only at the first
  double hysteresis = 0.0;          ///< >= 0; so far back beyond the limit before it may cross again
  std::vector<AnyId> of;            ///< what is measured: when one of them is gone, the event is dropped
};

/// What a play waits for.
struct Wait {
  double delay = 0.0;           ///< [s] >= 0 from when it was due, where there is no `until`; 0: the next step
  std::function<bool()> until;  ///< asked in each step from the next on
};

/// Something set to happen.
struct Event {
  EventKind kind = EventKind::once;
  double time = 0.0;    ///< [s] see EventKind; of a when it is set by add_event
  double period = 0.0;  ///< [s] > 0, of an every
  double until = 0.0;   ///< [s] > time, of an over
  AnyId target;         ///< not applied when this is gone; monostate: none
  std::function<void()> action;
  std::function<void(double)> progress;       ///< of an over, in place of `action`: 0 … 1 when the step begins
  std::function<std::optional<Wait>()> goes;  ///< of a play: to its next wait, or to its end
  Measured condition;                         ///< of a when
  std::string label;                          ///< "scene.lua:12", for the log

  // Set by the choreography.
  std::uint64_t fired = 0;            ///< how often so far
  std::shared_ptr<EventState> state;  ///< outlives the row, which goes when all is done
  std::uint64_t serial = 0;
  std::function<bool()> waits_for;                ///< of a play
  bool queued = false;                            ///< stands in the queue
  bool watched = false, listed = false;           ///< is looked at in each step; stands in the list of those
  bool held = false;                              ///< of a when: held when it was asked last
  std::deque<std::pair<double, double>> samples;  ///< of a when with a mean: time [s] and value
};

using EventId = Handle<Event>;

/// A line of the world's log.
struct LogLine {
  double time = 0.0;  ///< [s]
  std::string kind;   ///< "dropped", "warning", "notice"
  std::string text;
};

/// One event, for whoever shows what was, is and will be.
struct TimelineEntry {
  EventKind kind = EventKind::once;
  EventState state = EventState::waiting;
  double time = 0.0;               ///< [s] when it ended; of one that waits when it is due next, of a when NaN
  double from = 0.0, until = 0.0;  ///< [s] of an over
  double period = 0.0;             ///< [s] of an every
  std::uint64_t fired = 0;         ///< how often so far
  std::string label, target;       ///< "scene.lua:12"; "body 'arm'", or empty
  std::uint64_t serial = 0;        ///< order of adding
};

/// The queue: events in the order of their time, then of adding.
struct Choreography {
  struct Due {
    double time;  ///< [s]
    std::uint64_t serial;
    EventId event;
  };
  Store<Event> events;
  std::vector<Due> heap;           ///< binary heap, earliest first
  std::vector<EventId> watching;   ///< looked at in each step: whens, plays that wait for something, overs that began
  std::deque<TimelineEntry> past;  ///< the latest `most_told` that ended, oldest first
  double reached = std::numeric_limits<double>::lowest();  ///< [s] what was due up to then has fired
};
constexpr std::size_t most_told = 1000;

}  // namespace pantin
