#include "scene/scene.hpp"

#include <algorithm>
#include <string_view>

#include "snapshot/snapshot.hpp"

namespace pantin {

bool CameraWish::operator==(const CameraWish& other) const {
  const auto same = [](const std::optional<Vec3>& a, const std::optional<Vec3>& b) {
    return a.has_value() == b.has_value() && (!a || norm2(*a - *b) == 0.0);
  };
  return same(at, other.at) && same(look_at, other.look_at) && follow == other.follow && zoom == other.zoom &&
         ease == other.ease;
}
namespace {

std::vector<std::string> texts(const std::vector<LogLine>& log, std::string_view kind) {
  std::vector<std::string> texts;
  for (const LogLine& line : log)
    if (line.kind == kind) texts.push_back(line.text);
  return texts;
}

}  // namespace

std::vector<std::string> Scene::notices() const { return texts(world().log, "notice"); }

std::vector<std::string> Scene::warnings() const {
  std::vector<std::string> warnings = texts(world().log, "warning");
  const auto& log = world().log;
  const auto is_dropped = [](const LogLine& line) { return line.kind == "dropped"; };
  const auto first = std::find_if(log.begin(), log.end(), is_dropped);
  const auto count = std::count_if(log.begin(), log.end(), is_dropped);
  if (count == 1) warnings.push_back("1 event was dropped: " + first->text);
  if (count > 1) warnings.push_back(text(count, " events were dropped, the first: ", first->text));
  return warnings;
}

const std::string& Scene::broken_off() const {
  static const std::string none;
  return none;
}

std::string Scene::why_not_restore() const { return pantin::why_not_restore(world()); }

std::string setting_text(const SceneValue& value) {
  if (const auto* number = std::get_if<double>(&value)) return to_text(*number);
  if (const auto* boolean = std::get_if<bool>(&value)) return *boolean ? "true" : "false";
  return std::get<std::string>(value);
}

void take_parameters(const Scene& scene, std::map<std::string, std::string>& set) {
  for (const SceneParameter& p : scene.parameters())
    if (p.value != p.initial || set.contains(p.name)) set[p.name] = setting_text(p.value);
}

}  // namespace pantin
