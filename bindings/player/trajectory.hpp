#pragma once
#include <fstream>
#include <string>

#include "player/frame_clock.hpp"
#include "world/world.hpp"

namespace pantin::player {

/// The particles of one moment as a frame of an extended .xyz file: a row for each that is not part of a hinge, and one for
/// each hinge, in the order of making. Columns: species (its family, else "particle", "point" of a body, or "hinge"), place
/// [m], in a periodic box the image in it, velocity [m/s], mass [kg], radius [m] (0: none given), color, id. Numbers
/// read back as the same doubles.
std::string xyz_frame(const World& world);

/// Writes those frames to a file as the world goes on.
class Trajectory {
 public:
  /// `rate` frames in a second of play; `pace` as the scene's. Throws Error.
  Trajectory(std::string path, double rate, double pace);
  const std::string& path() const { return path_; }
  /// Adds the frames that are due; call it at the start and after each step.
  void add_frames(const World& world);
  /// Throws Error where not all could be written.
  void finish();

 private:
  std::string path_;
  std::ofstream file_;
  FrameClock clock_;
};

}  // namespace pantin::player
