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

/// What the views show as marks: rings, forces, velocities, contacts and cells. One is kept, so that nothing is allocated once its
/// lists have grown.
class ViewMarks {
 public:
  /// Appends them; `pace` as of the overlay.
  void add(const World& world, const Views& views, const Stage& stage, double pace, std::vector<Mark>& marks);
  /// What the length of forces means, in words; empty where none are shown.
  const std::string& legend() const { return legend_; }

 private:
  void add_forces(const World& world, const Views& views, const Stage& stage, std::vector<Mark>& marks);
  void add_cells(const World& world, std::vector<Mark>& marks);

  std::string legend_;
  std::vector<Vec3> positions_;  // of the members of the family whose cells are shown
  std::vector<std::uint32_t> members_;
  std::vector<std::array<std::int32_t, 3>> cells_;
};

/// Appends a ring round a point that is alive.
void add_highlight(const World& world, PointId point, std::vector<Mark>& marks);

}  // namespace pantin
