#include "view/edge_arrows.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pantin {

namespace {

constexpr int most_out = 6, sectors = 16;
constexpr std::size_t most_particles = 200;                   // more of them are matter
constexpr double whole_turn = 6.283185307179586;              // [rad]
constexpr double beside = 30.0, above = 60.0, below = 110.0;  // [px] that arrows keep from the edges, where panels are
constexpr double arrow_length = 22.0, arrow_width = 3.0;      // [px]

struct Sector {
  double x = 0.0, y = 0.0;  ///< sum of the directions in it
  int count = 0;
};

/// Where a way from the picture's middle leaves what the edges keep free.
Vec3 at_edge(const Viewport& viewport, double x, double y) {
  const double from_x = 0.5 * viewport.width, from_y = 0.5 * viewport.height;
  const double wide = std::fmax(from_x - beside, 1.0), high = std::fmax(from_y - (y > 0.0 ? below : above), 1.0);
  const double along = std::fmin(wide / std::fmax(std::fabs(x), 1e-9), high / std::fmax(std::fabs(y), 1e-9));
  return vec(from_x + along * x, from_y + along * y, 0.0);
}

Mark on_picture(Mark::Kind kind, Vec3 from, Vec3 to, double size) {
  Mark mark;
  mark.kind = kind;
  mark.on_screen = true;
  mark.from = from;
  mark.to = to;
  mark.size = size;
  return mark;
}

void add_arrow(const Viewport& viewport, const Sector& sector, std::vector<Mark>& marks) {
  const double length = std::hypot(sector.x, sector.y), x = sector.x / length, y = sector.y / length;
  const Vec3 tip = at_edge(viewport, x, y), way = vec(x, y, 0.0);
  marks.push_back(on_picture(Mark::Kind::arrow, tip - way * arrow_length, tip, arrow_width));
  if (sector.count == 1) return;
  marks.push_back(on_picture(Mark::Kind::text, tip - way * (2.0 * arrow_length), zero3(), 14.0));
  marks.back().text = std::to_string(sector.count);
}

}  // namespace

void EdgeArrows::add(const Viewport& viewport, std::int32_t articulate, Vec3 place) {
  const Vec3 middle = 0.5 * (viewport.stage.lower + viewport.stage.upper);
  if (!finite(place) || norm(place - middle) > far_away * viewport.stage.size) return;
  const auto index = static_cast<std::size_t>(articulate);
  Found alone = Found::nothing;
  Found& found = index < of_articulates_.size() ? of_articulates_[index] : alone;
  if (found == Found::seen) return;
  const auto at = viewport.project(place);
  if (at && at->x >= 0.0 && at->x <= viewport.width && at->y >= 0.0 && at->y <= viewport.height) {
    found = Found::seen;
  } else if (found == Found::nothing) {
    found = Found::out;
    out_.push_back({articulate, place});
  }
}

void EdgeArrows::mark(const Viewport& viewport, std::vector<Mark>& marks) {
  const World& world = viewport.world;
  if (viewport.stage.empty || world.settings.box || viewport.width <= 0 || viewport.height <= 0) return;
  of_articulates_.assign(world.articulates.size(), Found::nothing);
  out_.clear();
  for (std::uint32_t s = 0; s < world.bodies.slots(); s++)
    if (world.bodies.alive_at(s)) add(viewport, world.motion[s].articulate, world.motion[s].x);
  if (world.particles.size() <= most_particles)
    for (std::uint32_t s = 0; s < world.points.slots(); s++)
      if (world.points.alive_at(s) && !world.points.at_slot(s).body)
        add(viewport, world.points.at_slot(s).articulate, world.free_motion[s].x);

  std::array<Sector, sectors> found;
  int count = 0;
  for (const auto& [articulate, place] : out_) {
    const auto index = static_cast<std::size_t>(articulate);
    if (index < of_articulates_.size() && of_articulates_[index] == Found::seen) continue;
    const Vec3 way = place - viewport.camera.eye();
    const double x = dot(way, viewport.camera.right()), y = -dot(way, viewport.camera.up()), length = std::hypot(x, y);
    if (!(length > 0.0)) continue;
    const double turn = std::atan2(y, x) / whole_turn + 1.0;
    Sector& sector = found[static_cast<std::size_t>(std::lround(turn * sectors)) % sectors];
    sector.x += x / length;
    sector.y += y / length;
    sector.count++;
    count++;
  }
  if (count > most_out) return;
  for (const Sector& sector : found)
    if (sector.count > 0) add_arrow(viewport, sector, marks);
}

}  // namespace pantin
