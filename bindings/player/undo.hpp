#pragma once
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "player/table.hpp"
#include "scene/scene.hpp"
#include "view/palette.hpp"

namespace pantin::player {

/// The latest acts of hands, edits and changes of parameters, each with the scene, the times of its steps and what waited for the next step, as they were
/// before; they are taken back by putting that back.
class Undo {
 public:
  /// An act begins. Where the scene cannot be put back, nothing is kept; throws Error where it cannot be kept.
  void begin(Scene& scene, const Times& times, const StepInput& waiting, const std::string& act);
  /// The act that can be taken back, or empty.
  std::string_view last() const;
  /// Takes the last act back, or does it again, and tells what became of that. True where the scene was put back.
  bool undo(Scene& scene, Times& times, StepInput& waiting, std::string& told);
  bool redo(Scene& scene, Times& times, StepInput& waiting, std::string& told);
  /// Another scene was opened.
  void clear();
  /// For as long as this and the scene stay as they are.
  UndoState state(const Scene& scene) const;

  /// Told each state by its number: that it is kept now, or put back.
  std::function<void(std::uint64_t number, bool put_back)> on_state;

 private:
  struct Entry {
    std::string act;
    std::shared_ptr<const SceneSnapshot> scene;
    Times times;
    StepInput waiting;
    std::uint64_t number = 0;  ///< of the state
  };
  using Entries = std::deque<Entry>;
  Entry keep(Scene& scene, const Times& times, const StepInput& waiting, const std::string& act);
  bool move(Scene& scene, Times& times, StepInput& waiting, Entries& from, Entries& to, const char* does,
            std::string& told);

  Entries past_;              ///< before each act, oldest first
  std::uint64_t states_ = 0;  ///< that were kept
  Entries future_;            ///< after each act that was undone, oldest last
};

}  // namespace pantin::player
