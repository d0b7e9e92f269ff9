#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace pantin::player {

/// Of files by their paths; never null.
using FileContents = std::shared_ptr<const std::map<std::string, std::string>>;

/// A state of a replay that can be gone to.
struct KeptPosition {
  std::uint64_t tick = 0;  ///< steps done before
  std::size_t act = 0;     ///< the next of the recording
  std::map<std::string, std::string> set;
  FileContents contents;
  std::shared_ptr<const SceneSnapshot> state;
};

/// Some places of one scene, close together near where one is and farther apart elsewhere.
class KeptPositions {
 public:
  /// Keeps a place; where there are more than `most`, at least 3, that is dropped which is missed least at its tick.
  void keep(KeptPosition place, std::size_t most);
  /// The last at or before a tick, or null.
  const KeptPosition* before(std::uint64_t tick) const;
  void clear() { positions_.clear(); }
  std::size_t size() const { return positions_.size(); }

 private:
  std::vector<KeptPosition> positions_;  ///< rising
};

}  // namespace pantin::player
