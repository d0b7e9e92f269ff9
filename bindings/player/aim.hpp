#pragma once
#include <optional>

#include "scene/scene.hpp"
#include "view/camera.hpp"
#include "view/stage.hpp"

namespace pantin::player {

/// The camera that a scene wishes for, or one that sees the whole stage; `aspect` is width/height.
Camera aim(const Scene& scene, const Stage& stage, double aspect);

/// Moves a camera along with the thing that the scene wants it to follow, or that was chosen since.
class Follower {
 public:
  void move(const Scene& scene, Camera& camera);
  /// Monostate: nothing at all.
  void choose(AnyId thing);

 private:
  std::optional<AnyId> chosen_;
  std::optional<Vec3> last_;  ///< [m]
};

}  // namespace pantin::player
