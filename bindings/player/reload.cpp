#include "player/reload.hpp"

#include <utility>

#include "lua/scene/open.hpp"
#include "player/options.hpp"
#include "player/saved_state.hpp"

namespace pantin::player {

std::unique_ptr<Scene> Reload::open(const std::string& path, SceneOptions options, bool anew) {
  const auto read = std::make_shared<Files>();
  options.changing = true;
  options.forgiving = !anew && !files_->empty();
  options.on_read = [this, read](const FileRead& file) {  // also while the scene is played
    (*read)[file.path] = file.content;
    watch_.add(file.path);
    if (on_read) on_read(file);
  };
  const bool saved = path.ends_with(state_ending);
  std::unique_ptr<Scene> scene = saved ? open_saved(path, "", options) : lua::open_scene(path, options);
  watch_.keep_only(*read);
  files_ = read;
  return scene;
}

void Reload::go_back_to(const Read& read) {
  for (const auto& [path, content] : *read) watch_.add(path);
  watch_.keep_only(*read);
  files_ = read;
}

std::optional<Reloaded> Reload::look(Scene& playing, const std::string& path, const SceneOptions& options,
                                     FileWatch::Clock::time_point now) {
  if (!watch_.changed(now)) return {};
  Reloaded reloaded;
  try {
    std::unique_ptr<Scene> fresh = open(path, options);
    reloaded.carried = fresh->go_on_from(playing);
    reloaded.scene = std::move(fresh);
  } catch (const std::exception& error) { reloaded.error = error.what(); }
  return reloaded;
}

StepInput carried_over(const StepInput& input, const CarriedOver& carried) {
  const auto move_hand = [&](std::int32_t& hand) {
    const auto found = carried.hands.find(hand);
    if (found != carried.hands.end()) hand = found->second;
    return found != carried.hands.end();
  };
  const auto there = [&](AnyId& id) {
    if (std::holds_alternative<std::monostate>(id)) return true;
    const auto found = carried.things.find(id);
    if (found == carried.things.end()) return false;
    id = found->second;
    return true;
  };
  const auto point_there = [&](PointId& point) {
    AnyId id = point ? AnyId(point) : AnyId{};
    if (!there(id)) return false;
    if (point) point = std::get<PointId>(id);
    return true;
  };
  StepInput result;
  for (HandMove move : input.moves)
    if (move_hand(move.hand)) result.moves.push_back(move);
  for (Command command : input.commands)
    if (move_hand(command.hand) && point_there(command.point) && point_there(command.other) && there(command.thing) &&
        there(command.other_thing))
      result.commands.push_back(command);
  return result;
}

}  // namespace pantin::player
