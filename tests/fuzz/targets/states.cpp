// States of scenes, with a checksum that is right: each is refused or goes on, and what goes on can be saved again.
#include <cstddef>
#include <cstdint>
#include <string>

#include "base/check.hpp"
#include "lua/scene/open.hpp"
#include "scene/scene.hpp"
#include "support/sealed_state.hpp"
#include "world/world.hpp"

using namespace pantin;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  SceneOptions options;
  options.script_limit = 0.5;
  options.memory_limit = std::size_t{1} << 30;
  try {
    const std::string state = sealed({reinterpret_cast<const char*>(data), size});
    const auto scene = lua::open_state(state, "some.pantin", options);
    for (int i = 0; i < 4 && scene->world().failure.empty(); i++) scene->step();
    if (scene->world().failure.empty()) scene->state();
  } catch (const Error&) {}
  return 0;
}
