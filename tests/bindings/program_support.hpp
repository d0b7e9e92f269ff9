#pragma once
// The built program, started in a folder of its own.
#include <algorithm>
#include <string>
#include <vector>

#include "support/process.hpp"
#include "support/sources.hpp"

namespace pantin::support {

inline Process::Options options(std::vector<std::string> arguments, const std::string& folder) {
  arguments.insert(arguments.begin(), sources::program());
  return {arguments, {"PANTIN_HOME=" + sources::folder(), "DISPLAY", "WAYLAND_DISPLAY"}, folder, -1};
}

inline Finished use(const Folder& folder, std::vector<std::string> arguments) {
  return finish(options(std::move(arguments), folder.path));
}

inline std::size_t lines(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

inline const char* const swing = R"(
scene.title = "Swing"
local mass = scene:param("mass", 1, { min = 0.1, max = 10 })
local bob = scene:particle { at = vec(1, 0, 0), mass = mass }
scene:rod(bob, vec(0, 0, 0))
scene:probe("height", function() return bob.position.y end)
scene:result("mass", mass)
)";

}  // namespace pantin::support
