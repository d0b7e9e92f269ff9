// Scripts: each builds a scene that takes some steps, or ends in Error.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "base/check.hpp"
#include "lua/scene/open.hpp"
#include "scene/scene.hpp"
#include "world/world.hpp"

using namespace pantin;

namespace {

const char* const home = std::getenv("PANTIN_HOME");

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  SceneOptions options;
  options.script_limit = 0.5;
  options.memory_limit = std::size_t{256} << 20;
  options.home = home;
  try {
    const auto scene =
        lua::open_scene_text({reinterpret_cast<const char*>(data), size}, "scene.lua", options.home, options);
    for (int i = 0; i < 4 && scene->world().failure.empty(); i++) scene->step();
  } catch (const Error&) {}
  return 0;
}
