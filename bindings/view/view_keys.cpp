#include "view/view_keys.hpp"

namespace pantin {

namespace {

struct CameraKey {
  const char* key;
  void (*turn)(Camera&);
  const char* help;
};

const CameraKey camera_keys[] = {
    {"u", [](Camera& c) { c.look_freely(); }, "see in perspective"},
    {"i", [](Camera& c) { c.look_along(Side::front); }, "see from the front, without perspective"},
    {"o", [](Camera& c) { c.look_along(Side::right); }, "see from the right side"},
    {"p", [](Camera& c) { c.look_along(Side::top); }, "see from the top"},
};

}  // namespace

void take_view_keys(const Gestures& gestures, Views& views, Camera& camera) {
  if (gestures.control) return;
  for (const std::string& key : gestures.keys) {
    for (const NamedView& named : view_table())
      if (key == named.key) views.toggle(named.view);
    for (const CameraKey& turning : camera_keys)
      if (key == turning.key) turning.turn(camera);
  }
}

const std::vector<std::pair<std::string, std::string>>& view_key_help() {
  static const auto list = [] {
    std::vector<std::pair<std::string, std::string>> all;
    for (const CameraKey& turning : camera_keys) all.emplace_back(turning.key, turning.help);
    all.emplace_back("double click", "follow a thing; beside all things, follow none");
    for (const NamedView& named : view_table())
      all.emplace_back(named.key, std::string(named.name) + ": " + named.help);
    return all;
  }();
  return list;
}

}  // namespace pantin
