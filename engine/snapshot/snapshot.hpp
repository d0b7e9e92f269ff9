#pragma once
// The state of a world, kept in memory: all that the next steps come of. Taking it changes no bit of the run; after a
// restore the run goes on to the bits to which it went on from the snapshot the first time, whatever happened since.
#include <memory>
#include <string>

#include "world/world.hpp"

namespace pantin {

/// A copy of all rows, unknown forces, predictions, neighbour rows, events, counters, random numbers and the log. Functions
/// that rows hold (targets, actions, probes) are copied as values; what they refer to is not.
class Snapshot {
 public:
  double time() const;          ///< [s]; throws Error where nothing was taken
  std::uint64_t steps() const;  ///< done; the same

 private:
  struct Held;
  std::shared_ptr<Held> held_;
  const Held& held() const;
  friend Snapshot take_snapshot(const World& world);
  friend void take_snapshot(const World& world, Snapshot& into);
  friend void restore(World& world, const Snapshot& snapshot);
  friend std::string why_not_restore(const World& world, const Snapshot& snapshot);
};

/// Between two steps, or where scripts run inside of one.
Snapshot take_snapshot(const World& world);
/// The same into a snapshot that is no longer wanted: where no copy of it is left, its memory is used again, which is faster.
void take_snapshot(const World& world, Snapshot& into);

/// Between two steps. Of the same world, which functions and laws of its rows may refer to: handles of what was removed since
/// are alive again; handles of what was made since are dead, for ever. Handles of events are told how their events now are.
/// Threads, callbacks and the profile stay as they are. Throws Error where `why_not_restore` gives a reason.
void restore(World& world, const Snapshot& snapshot);

/// Why a world cannot be put back: a play goes on, now or in the snapshot, and cannot be wound back; or the snapshot is of
/// another world, or empty. Empty where it can.
std::string why_not_restore(const World& world, const Snapshot& snapshot);
/// The same before a snapshot is known: a play goes on now.
std::string why_not_restore(const World& world);
bool can_restore(const World& world);

}  // namespace pantin
