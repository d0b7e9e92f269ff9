#include "player/controls.hpp"

#include <algorithm>

#include "scene/controls.hpp"

namespace pantin::player {
namespace {

bool of_pad(const std::string& name) { return name.starts_with(pad_prefix); }

double held(const Gestures& gestures, const std::string& name) {
  if (of_pad(name)) {
    const auto found = gestures.pad.find(name);
    return found == gestures.pad.end() ? 0.0 : found->second;
  }
  const bool down = std::ranges::count(gestures.held, name) > 0 || std::ranges::count(gestures.keys, name) > 0;
  return down ? 1.0 : 0.0;
}

void tell(StepInput& waiting, const std::string& name, double known, double value) {
  const auto told = std::ranges::find_if(
      waiting.commands, [&](const Command& c) { return c.kind == Command::Kind::control && c.name == name; });
  if (told != waiting.commands.end()) {
    if (value != 0.0) told->value = value;  // what is let go meanwhile is told once the step has seen it
    return;
  }
  if (value == known) return;
  Command command;
  command.kind = Command::Kind::control;
  command.name = name;
  command.value = value;
  waiting.commands.push_back(command);
}

/// A stick of which the scene reads an axis, or its button, is no hand.
void take_sticks(const std::vector<std::string>& wanted, Gestures& gestures) {
  const auto takes = [&](std::string_view side) {
    return std::ranges::any_of(wanted, [&](const std::string& name) {
      return of_pad(name) && std::string_view(name).substr(pad_prefix.size()).starts_with(std::string(side) + "_");
    });
  };
  const bool left = takes("left"), right = takes("right");
  std::erase_if(gestures.sticks,
                [&](const auto& stick) { return (stick.first - first_stick) % 2 == 0 ? left : right; });
}

}  // namespace

void give_controls(const Scene& scene, bool heard, Gestures& gestures, StepInput& waiting) {
  const std::vector<std::string> wanted = scene.controls();
  const std::map<std::string, double>& known = scene.world().controls;
  gestures.of_scene.clear();
  if (wanted.empty() && known.empty()) return;
  for (const std::string& name : wanted) {
    const auto at = known.find(name);
    tell(waiting, name, at == known.end() ? 0.0 : at->second, heard ? held(gestures, name) : 0.0);
  }
  for (const auto& [name, value] : known)
    if (std::ranges::count(wanted, name) == 0) tell(waiting, name, value, 0.0);
  std::ranges::copy_if(wanted, std::back_inserter(gestures.of_scene), of_pad);
  take_sticks(wanted, gestures);
}

}  // namespace pantin::player
