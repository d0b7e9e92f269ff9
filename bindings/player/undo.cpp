#include "player/undo.hpp"

#include <utility>

#include "snapshot/snapshot.hpp"

namespace pantin::player {
namespace {

constexpr std::size_t most_acts = 32, most_scenes = 8;

/// Scenes that lie in a row of acts, each of which has its own.
std::size_t scenes_in(const auto& entries) {
  std::size_t scenes = entries.empty() ? 0 : 1;
  for (std::size_t i = 1; i < entries.size(); i++) scenes += entries[i].scene != entries[i - 1].scene ? 1u : 0u;
  return scenes;
}

std::string_view name_of_last(const auto& entries) { return entries.empty() ? std::string_view() : entries.back().act; }

std::string obstacle(const Scene& scene) {
  const std::string why = scene.why_not_restore();
  return why.empty() ? "" : "undo does not work here: " + why + "; r starts it again";
}

}  // namespace

std::uint64_t Undo::begin(const std::shared_ptr<Scene>& scene, const Times& times, const StepInput& waiting,
                          const std::string& act) {
  future_before_ = std::exchange(future_, {});
  if (!scene->why_not_restore().empty()) {
    past_.clear();
    return 0;
  }
  past_.push_back(keep(scene, false, times, waiting, act));
  if (past_.size() > most_acts) past_.pop_front();
  return past_.back().number;
}

void Undo::replace(const std::shared_ptr<Scene>& scene, const Times& times, const StepInput& waiting,
                   const std::string& act) {
  future_before_.clear();
  future_.clear();
  past_.push_back(keep(scene, true, times, waiting, act));
  while (past_.size() > most_acts || scenes_in(past_) > most_scenes) past_.pop_front();
}

void Undo::forget(std::uint64_t act) {
  if (past_.empty() || past_.back().number != act) return;
  past_.pop_back();
  future_ = std::exchange(future_before_, {});
}

Undo::Entry Undo::keep(const std::shared_ptr<Scene>& scene, bool replaced, const Times& times, const StepInput& waiting,
                       const std::string& act) {
  Entry entry{act, scene, replaced ? nullptr : scene->take_snapshot(), times, waiting, ++states_};
  if (on_state) on_state(entry.number, false);
  return entry;
}

bool Undo::undo(std::shared_ptr<Scene>& scene, Times& times, StepInput& waiting, std::string& told) {
  return move(scene, times, waiting, past_, future_, "undo", told);
}

bool Undo::redo(std::shared_ptr<Scene>& scene, Times& times, StepInput& waiting, std::string& told) {
  return move(scene, times, waiting, future_, past_, "redo", told);
}

std::string_view Undo::last() const { return name_of_last(past_); }

void Undo::clear() {
  past_.clear();
  future_.clear();
  future_before_.clear();
}

UndoState Undo::state(const std::shared_ptr<Scene>& scene) const {
  UndoState state{name_of_last(past_), name_of_last(future_), {}};
  const auto another = [&](const Entries& entries) { return !entries.empty() && entries.back().scene != scene; };
  if (!can_restore(scene->world()) && !another(past_) && !another(future_))
    state.obstacle = [&at = *scene] { return obstacle(at); };
  return state;
}

bool Undo::move(std::shared_ptr<Scene>& scene, Times& times, StepInput& waiting, Entries& from, Entries& to,
                const char* does, std::string& told) {
  const bool another = !from.empty() && from.back().scene != scene;
  told.clear();
  if (!another) told = obstacle(*scene);
  if (told.empty() && from.empty()) told = std::string("nothing to ") + does;
  if (!told.empty()) return false;
  try {
    const Entry entry = from.back();
    Entry now = keep(scene, another, times, waiting, entry.act);
    if (!another) scene->restore(*entry.state);
    scene = entry.scene;
    if (on_state) on_state(entry.number, true);
    from.pop_back();
    future_before_.clear();
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
