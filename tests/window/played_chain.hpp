#pragma once
// A player of a chain of links that hangs on a nail, seen from the front.
#include <string>

#include "view/camera.hpp"
#include "window/played.hpp"

namespace pantin {

struct PlayedChain : Played {
  static constexpr int width = 960, height = 540;  ///< [px]

  using Played::Played;

  /// Its scene; `links` is a number in Lua. The last link is `previous`.
  static std::string text(const std::string& links = "6") {
    return R"(
      scene.camera = { at = vec(3, 2, 14), look_at = vec(3, 2, 0) }
      local previous
      for i = 1, )" +
           links + R"( do
        local link = scene:body { at = vec(i - 0.5, 4, 0), mass = 1, inertia = vec(0.01, 0.1, 0.1),
          points = { head = vec(-0.5, 0, 0), tail = vec(0.5, 0, 0) } }
        if previous then scene:hinge(previous.tail, link.head) else scene:nail(link.head) end
        previous = link
      end
    )";
  }
  Projected seen(Vec3 position) const {
    Camera camera;
    camera.look(vec(3, 2, 14), vec(3, 2, 0));
    return camera.project(position, width, height).value();
  }
};

}  // namespace pantin
