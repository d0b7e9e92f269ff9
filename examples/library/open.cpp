// Opens a scene in Lua, sets a parameter of it, and lets a program's own code look at what moves.
#include <cstdio>
#include <exception>
#include <pantin/lua.hpp>

int main(int count, char** arguments) try {
  if (count != 3) return std::puts("usage: open SCENE.lua SHARE, as: open chain.lua /usr/share/pantin"), 2;
  pantin::SceneOptions options;
  options.home = arguments[2];  // share/pantin: what scenes share
  options.set["links"] = "7";
  const auto scene = pantin::lua::open_scene(arguments[1], options);
  while (scene->world().time < 1.0) scene->step();
  const pantin::World& world = scene->world();
  std::printf("%s: %zu bodies, energy %.6f J\n", scene->title().c_str(), world.bodies.ids().size(),
              pantin::energy(world).total());
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());  // of a script's error, its file and line first
  return 1;
}
