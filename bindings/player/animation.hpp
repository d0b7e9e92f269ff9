#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "player/frame_clock.hpp"
#include "player/mesh.hpp"
#include "view/draw_list.hpp"

namespace pantin::player {

/// What a world's things looked like and where they were in each frame, for a binary glTF 2.0 file (.glb): a node with a
/// mesh for each body, shape of the world, hinge, free particle, nail, rod, string and tie, of its own name or its kind and number. Metres,
/// seconds of play, y up. What is not there all the time has a size of 0 before and after; radii follow the age, colors are
/// those of the first frame, as glTF knows no others.
class Animation {
 public:
  /// `rate` frames in a second of play; `pace` as the scene's.
  Animation(const World& world, double rate, double pace);
  /// Adds the frames that are due; call it at the start and after each step.
  void add_frames(const World& world);
  /// Throws Error where it cannot be written.
  void write(const std::string& path, const std::string& title) const;

 private:
  /// A thing in the frames in which it was there.
  struct Node {
    std::string name;
    std::size_t mesh = 0;
    std::uint64_t first = 0;  // frame
    std::vector<std::array<float, 3>> positions, sizes;
    std::vector<std::array<float, 4>> turns;  // x, y, z, w
  };
  /// Where in the kinds of things, which of them, and which look of it.
  using Key = std::array<std::uint64_t, 3>;
  enum Kind : std::uint64_t { body, hinge, particle, knob, bar, string, tie, ground };
  class File;

  void add_frame(const World& world);
  void add_bodies(const World& world);
  void add_ground(const World& world);
  void add_particles(const World& world);
  void add_constraints(const World& world);
  void add_ties(const World& world);
  /// The node of what was there in the last frame, or null.
  Node* node_of(const Key& key);
  void add(const Key& key, const std::string& name, std::size_t mesh, Vec3 at, Quat turn, Vec3 size);
  void add_stick(const Key& key, const std::string& name, Vec3 from, Vec3 to, double radius, const Color& color);
  template <class Make>
  std::size_t mesh(const Key& look, Make make);
  std::size_t ball(const Color& color);

  FrameClock clock_;
  Stage stage_;
  ConstraintLook look_;
  Figures figures_;
  Appearance appearance_;
  std::vector<double> joints_;  // [m] (slots of particles) radius that a hinge should exceed
  std::vector<Mesh> meshes_;
  std::map<Key, std::size_t> looks_;  // which mesh
  std::vector<Node> nodes_;
  std::map<Key, std::size_t> present_;  // the latest node of each thing
};

}  // namespace pantin::player
