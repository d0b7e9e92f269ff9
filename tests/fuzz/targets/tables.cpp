// Tables of numbers: rows of one length, or Error.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "base/check.hpp"
#include "lua/scene/open.hpp"
#include "scene/scene.hpp"

using namespace pantin;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr const char* script = R"(
    local rows = read_table "some.csv"
    for _, row in ipairs(rows) do
      if #row ~= #rows[1] then scene:result("wrong", true) end
      for _, x in ipairs(row) do if math.type(x) ~= "float" then scene:result("wrong", true) end end
    end
  )";
  SceneOptions options;
  options.read = [&](const std::string&, std::size_t) {
    return std::string(reinterpret_cast<const char*>(data), size);
  };
  bool wrong = false;
  try {
    wrong = lua::open_scene_text(script, "scene.lua", ".", options)->results().contains("wrong");
  } catch (const Error&) {}
  if (wrong) std::abort();
  return 0;
}
