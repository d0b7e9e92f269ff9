#pragma once
// From one world to another that a changed scene file made: what is the same thing goes on where it is.
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "world/world.hpp"

namespace pantin {

/// A thing as the scene file made it.
struct MadeThing {
  AnyId id;
  std::size_t sort = 0;  ///< things of one sort are matched: free particles, hinges, rods …
  std::string name;
  std::uint64_t looks = 0;               ///< of a body's shapes, their kinds and sizes
  std::vector<PointId> points;           ///< of a body or a free particle, in their order
  std::vector<std::string> point_names;  ///< of these
};

/// All that a scene file made, in the order of making; some of it may have gone since.
struct Made {
  std::vector<MadeThing> things;
  struct OfEvent {
    EventId id;
    EventKind kind = EventKind::once;
    std::shared_ptr<EventState> state;
  };
  std::vector<OfEvent> events;
  std::size_t hands = 0;
};
/// Call once the file has been run.
Made made(const World& world);

/// What a thing of the old world is in the new one; what has no counterpart is not in it.
using Counterparts = std::map<AnyId, AnyId>;

/// What became of things and hands.
struct CarriedOver {
  Counterparts things;
  std::map<std::int32_t, std::int32_t> hands;  ///< of the outside
};

/// Makes a world that has not moved yet go on where an older one is. Things are matched by name, else by sort and order of
/// making, where bodies came or went first those whose shapes are alike: they take over position, motion and age; what of
/// them was removed or cut is removed or cut. Time goes on: events that are past count as fired, plays begin now. Hands that
/// no script moves come along and hold what they held. All else, masses, shapes, laws, settings, is the new world's own;
/// what constraints want elsewhere is drawn there in their time constants.
CarriedOver carry_over(const World& old, const Made& before, World& fresh, const Made& now);

}  // namespace pantin
