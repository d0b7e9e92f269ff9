#include "player/undo.hpp"

#include <utility>

#include "snapshot/snapshot.hpp"

namespace pantin::player {
namespace {

constexpr std::size_t most_acts = 32;

std::string_view name_of_last(const auto& entries) { return entries.empty() ? std::string_view() : entries.back().act; }

std::string obstacle(const Scene& scene) {
  const std::string why = scene.why_not_restore();
  return why.empty() ? "" : "undo does not work here: " + why + "; r starts it again";
}

}  // namespace

void Undo::begin(Scene& scene, const Times& times, const StepInput& waiting, const std::string& act) {
  future_.clear();
  if (!scene.why_not_restore().empty()) return past_.clear();
  past_.push_back(keep(scene, times, waiting, act));
  if (past_.size() > most_acts) past_.pop_front();
}

Undo::Entry Undo::keep(Scene& scene, const Times& times, const StepInput& waiting, const std::string& act) {
  Entry entry{act, scene.take_snapshot(), times, waiting, ++states_};
  if (on_state) on_state(entry.number, false);
  return entry;
}

bool Undo::undo(Scene& scene, Times& times, StepInput& waiting, std::string& told) {
  return move(scene, times, waiting, past_, future_, "undo", told);
}

bool Undo::redo(Scene& scene, Times& times, StepInput& waiting, std::string& told) {
  return move(scene, times, waiting, future_, past_, "redo", told);
}

std::string_view Undo::last() const { return name_of_last(past_); }

void Undo::clear() {
  past_.clear();
  future_.clear();
}

UndoState Undo::state(const Scene& scene) const {
  UndoState state{name_of_last(past_), name_of_last(future_), {}};
  if (!can_restore(scene.world())) state.obstacle = [&scene] { return obstacle(scene); };
  return state;
}

bool Undo::move(Scene& scene, Times& times, StepInput& waiting, Entries& from, Entries& to, const char* does,
                std::string& told) {
  told = obstacle(scene);
  if (told.empty() && from.empty()) told = std::string("nothing to ") + does;
  if (!told.empty()) return false;
  try {
    const Entry entry = from.back();
    Entry now = keep(scene, times, waiting, entry.act);
    scene.restore(*entry.scene);
    if (on_state) on_state(entry.number, true);
    from.pop_back();
    times = entry.times;
    waiting = entry.waiting;
    told = does + (": " + entry.act);
    to.push_back(std::move(now));
  } catch (const Error& error) {
    told = error.what();
    return false;
  }
  return true;
}

}  // namespace pantin::player
