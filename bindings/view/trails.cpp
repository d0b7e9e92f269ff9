#include <algorithm>

#include "view/draw_list.hpp"
#include "view/view_marks.hpp"

namespace pantin {

void Trails::clear() {
  ways_.clear();
  last_ = 0.0;
}

void Trails::add(std::size_t index, std::uint64_t serial, Vec3 at) {
  Way& way = ways_[index];
  if (way.serial != serial || !finite(at)) way.count = way.next = 0;
  way.serial = serial;
  if (!finite(at)) return;
  way.at[way.next] = at;
  way.next = (way.next + 1) % places;
  way.count = std::min(way.count + 1, places);
}

void Trails::note(const World& world, double interval) {
  if (world.time < last_) clear();
  if (!ways_.empty() && world.time < last_ + interval) return;
  last_ = world.time;
  const std::size_t bodies = std::min<std::size_t>(world.bodies.slots(), most_things);
  const std::size_t points = std::min<std::size_t>(world.points.slots(), most_things);
  ways_.resize(bodies + points);
  for (std::uint32_t s = 0; s < bodies; s++)
    if (world.bodies.alive_at(s)) add(s, world.bodies.at_slot(s).serial, world.motion[s].x);
  for (std::uint32_t s = 0; s < points; s++)
    if (world.points.alive_at(s) && !world.points.at_slot(s).body)
      add(bodies + s, world.points.at_slot(s).serial, world.free_motion[s].x);
}

void Trails::draw(const World& world, const Stage& stage, std::vector<Mark>& marks) const {
  const double longest = 0.5 * stage.size;  // [m] of a stretch: what jumps leaves no line
  for (const Way& way : ways_) {
    for (std::size_t i = 1; i < way.count; i++) {
      const std::size_t to = (way.next + places - i) % places, from = (to + places - 1) % places;
      const Vec3 a = way.at[from], b = way.at[to];
      if (norm(b - a) > longest) continue;
      const Vec3 shift = image_shift(world, b);
      Mark mark;
      mark.from = a + shift;
      mark.to = b + shift;
      mark.size = 1.5;
      const float old = 1.0f - static_cast<float>(i) / static_cast<float>(places);
      mark.color = Color{0.93f, 0.45f, 0.13f, 0.85f * old};
      marks.push_back(std::move(mark));
    }
  }
}

}  // namespace pantin
