#pragma once
// From contacts to the problems that are solved: what touches, and all that ties it, is an island.
#include <span>
#include <vector>

#include "contacts/bodies.hpp"
#include "contacts/contact.hpp"
#include "contacts/solve/island.hpp"
#include "contacts/stages.hpp"

namespace pantin {

/// Where the parts of an island's problem come from.
struct TouchIsland {
  ContactIsland problem;
  std::vector<std::uint32_t> slots;        ///< (bodies) of Model::motion, or of free points where `points` says so
  std::vector<char> points;                ///< (bodies) whether it is a free point of an articulate
  std::vector<BodyState> states;           ///< (bodies)
  std::vector<std::size_t> contacts;       ///< (contacts) index in Contacts::list
  std::vector<std::uint32_t> articulates;  ///< that are in it
  std::vector<std::array<std::uint32_t, 2>> rows;  ///< (ties) articulate and its row
  std::vector<BodyLoad> pulls;                     ///< (bodies) [N], [N m] of soft rows in the last step
  std::vector<BodyLoad> law_pulls;                 ///< (bodies) what of that is of laws

  void clear();  ///< keeps memory
};

/// Islands, whose memory lasts from stage to stage.
struct TouchSpace {
  std::vector<TouchIsland> islands;
  std::vector<std::int32_t> index;  ///< (slots of bodies) in its island, or -1
};

/// Islands of the contacts that are `used`, in the order of the smallest number of what they hold; tied things with their rows
/// as they are now. Velocities are set, biases and starts are not.
std::span<TouchIsland> gather(TouchSpace& space, Model& model, const Articulates& articulates, const Contacts& contacts,
                              const TouchSettings& settings, const std::vector<char>& used);

}  // namespace pantin
