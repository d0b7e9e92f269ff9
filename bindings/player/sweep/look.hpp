#pragma once
// What is known of a scene before the first case of a sweep.
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "player/sweep/cases.hpp"
#include "scene/options.hpp"

namespace pantin::player {

/// Of one of its parameters.
struct ParameterLook {
  std::optional<double> min, max;
  bool integer = false;  ///< its default is a whole number without a point
};

struct SceneLook {
  std::map<std::string, ParameterLook> parameters;  ///< by name; empty where it cannot be opened so
  std::string unknown;                              ///< why what is set is none of it; empty: it is
  std::vector<std::string> lacks;                   ///< what hold_back told, of the process that looked
};

/// Opens the scene once, as its first case where that can be opened.
SceneLook look_at_scene(const std::vector<Axis>& axes, const std::string& path, const SceneOptions& limits);

/// As another process tells it. Throws Error where a text is none.
std::string text_of(const SceneLook& look);
SceneLook look_of(const std::string& text);

/// What is set is in the range of its parameter; ranges of whole numbers have whole numbers. Throws UsageError.
void settle_whole(std::vector<Axis>& axes, const SceneLook& look);

}  // namespace pantin::player
