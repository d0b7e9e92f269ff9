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

/// The latest acts of hands, edits, changes of parameters, and what put another scene in the place of one; each with the
/// scene, the times of its steps and what waited for the next step, as they were before; they are taken back by putting
/// that back. A scene that another took the place of is kept as it is.
class Undo {
 public:
  /// An act begins: its number. Where the scene cannot be put back, nothing is kept, and that is 0; throws Error where it
  /// cannot be kept.
  std::uint64_t begin(const std::shared_ptr<Scene>& scene, const Times& times, const StepInput& waiting,
                      const std::string& act);
  /// Another scene takes the place of this one, which must not change from now on.
  void replace(const std::shared_ptr<Scene>& scene, const Times& times, const StepInput& waiting,
               const std::string& act);
  /// An act did nothing: where it is the last, it is none, and what could be done again before it can be.
  void forget(std::uint64_t act);
  /// The act that can be taken back, or empty.
  std::string_view last() const;
  /// Takes the last act back, or does it again, and tells what became of that. True where the scene was put back, or
  /// another was put in its place.
  bool undo(std::shared_ptr<Scene>& scene, Times& times, StepInput& waiting, std::string& told);
  bool redo(std::shared_ptr<Scene>& scene, Times& times, StepInput& waiting, std::string& told);
  /// Another scene was opened.
  void clear();
  /// For as long as this and the scene stay as they are.
  UndoState state(const std::shared_ptr<Scene>& scene) const;

  /// Told each state by its number: that it is kept now, or put back.
  std::function<void(std::uint64_t number, bool put_back)> on_state;

 private:
  struct Entry {
    std::string act;
    std::shared_ptr<Scene> scene;
    std::shared_ptr<const SceneSnapshot> state;  ///< null where another scene took its place
    Times times;
    StepInput waiting;
    std::uint64_t number = 0;  ///< of the state
  };
  using Entries = std::deque<Entry>;
  Entry keep(const std::shared_ptr<Scene>& scene, bool replaced, const Times& times, const StepInput& waiting,
             const std::string& act);
  bool move(std::shared_ptr<Scene>& scene, Times& times, StepInput& waiting, Entries& from, Entries& to,
            const char* does, std::string& told);

  Entries past_;              ///< before each act, oldest first
  std::uint64_t states_ = 0;  ///< that were kept
  Entries future_;            ///< after each act that was undone, oldest last
  Entries future_before_;     ///< the same before the last act was begun
};

}  // namespace pantin::player
