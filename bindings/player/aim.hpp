#pragma once
#include <optional>

#include "scene/scene.hpp"
#include "view/camera.hpp"
#include "view/stage.hpp"

namespace pantin::player {

/// The camera that a scene wishes for, or one that sees the whole stage; `aspect` is width/height.
Camera aim(const Scene& scene, const Stage& stage, double aspect);

/// A camera that looks as `now` does and sees what `aimed` does, where the scene's size is another by more than a tenth.
Camera fit_to_size(const Camera& now, const Camera& aimed, double size_before, double size);

/// Moves a camera to where the scene wishes it when that changes, and along with the thing that the scene wants it to
/// follow, or that was chosen since.
class Follower {
 public:
  /// Over a time [s] of who watches; stage and aspect as `aim` has them.
  void move(const Scene& scene, const Stage& stage, double aspect, double seconds, Camera& camera);
  /// Monostate: nothing at all.
  void choose(AnyId thing);

 private:
  std::optional<AnyId> chosen_;
  void go(const Camera& goal, double part, Camera& camera);
  void follow(const Scene& scene, double part, Camera& camera);

  std::optional<Vec3> last_;          ///< [m] where the thing was
  std::optional<CameraWish> wished_;  ///< when it was last looked at
  std::optional<Camera> goal_;        ///< where the camera goes, while it is not there
};

}  // namespace pantin::player
