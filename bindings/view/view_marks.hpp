#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "view/overlay.hpp"
#include "view/stage.hpp"
#include "view/views.hpp"
#include "world/world.hpp"

namespace pantin {

/// Where things have been of late, in simulated time.
class Trails {
 public:
  static constexpr std::size_t places = 64, most_things = 1024;

  /// Notes where things are now, if at least `interval` [s] have passed; a world that went back begins anew.
  void note(const World& world, double interval);
  void clear();
  void draw(const World& world, const Stage& stage, std::vector<Mark>& marks) const;

 private:
  struct Way {
    std::uint64_t serial = 0;
    std::array<Vec3, places> at;  // [m] a ring; the last is before `next`
    std::size_t count = 0, next = 0;
  };
  void add(std::size_t index, std::uint64_t serial, Vec3 at);

  std::vector<Way> ways_;
  double last_ = 0.0;  // [s]
};

/// Appends what the views show as marks: rings, forces, velocities and cells. `pace` as of the overlay.
void add_view_marks(const World& world, const Views& views, const Stage& stage, double pace, std::vector<Mark>& marks);

/// Appends a ring round a point that is alive.
void add_highlight(const World& world, PointId point, std::vector<Mark>& marks);

/// The text that tells a scale, for the upper right corner, below so many others.
Mark legend_mark(const std::string& text, int line);

}  // namespace pantin
