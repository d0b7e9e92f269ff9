#include "contacts/clipping.hpp"

#include <algorithm>

namespace pantin {

namespace {

enum : std::uint32_t { crossing = 201, rim_crossing, rim_point };

/// Which is called the same whichever of the two was clipped by the other.
std::uint32_t crossing_of(std::uint32_t edge, std::uint32_t other) {
  return name_of(crossing, std::min(edge, other), std::max(edge, other));
}

/// A side of a face is told from edges of what is clipped.
std::uint32_t side_name(std::uint32_t edge) { return edge | 0x80000000u; }

/// Keeps what is not on the side of a plane through x that `outwards` points to.
void clip_by_plane(Loop& loop, Vec3 x, Vec3 outwards, std::uint32_t side, double near) {
  Loop rest;
  rest.closed = loop.closed;
  double out = loop.count > 0 ? dot(outwards, loop.corners[0].x - x) : 0.0;
  for (std::uint32_t i = 0; i < loop.count; i++) {
    const Corner& from = loop.corners[i];
    const bool last = i + 1 == loop.count;
    const Corner& to = loop.corners[last ? 0 : i + 1];
    const double next_out = dot(outwards, to.x - x);
    if (out <= near) rest.add({from.x, from.name, out >= -near && next_out > near ? side : from.edge});
    if ((!last || loop.closed) && ((out < -near && next_out > near) || (out > near && next_out < -near)))
      rest.add({from.x + (to.x - from.x) * (out / (out - next_out)), crossing_of(from.edge, side),
                out > 0.0 ? from.edge : side});
    out = next_out;
  }
  loop = rest;
}

/// The points of a rim that a closed loop is over, at its height. What is clipped looks against the disc: its corners run
/// clockwise there.
void add_rim_points(const Loop& loop, Vec3 normal, const Feature& disc, double near, Loop& kept) {
  const double slope = dot(normal, disc.normal);
  if (slope == 0.0) return;
  const double turn = slope < 0.0 ? -1.0 : 1.0;
  for (std::uint32_t i = 0; i < disc.loop.count; i++) {
    const Vec3 x = disc.loop.corners[i].x;
    bool within = true;
    for (std::uint32_t k = 0; within && k < loop.count; k++) {
      const Vec3 from = loop.corners[k].x, to = loop.corners[k + 1 < loop.count ? k + 1 : 0].x;
      const Vec3 outwards = direction(cross(to - from, disc.normal) * turn);
      within = dot(outwards, x - from) < -near;
    }
    if (!within) continue;
    const double height = dot(normal, loop.corners[0].x - x) / slope;
    kept.add({x + disc.normal * height, name_of(rim_point, i, 0), 0});
  }
}

void clip_by_rim(Loop& loop, Vec3 normal, const Feature& disc, double near) {
  Loop kept;
  kept.closed = false;
  const auto flat = [&](Vec3 x) {
    const Vec3 d = x - disc.centre;
    return d - disc.normal * dot(disc.normal, d);
  };
  for (std::uint32_t i = 0; i < loop.count; i++) {
    const Corner& from = loop.corners[i];
    const Vec3 start = flat(from.x);
    if (norm(start) <= disc.radius + near) kept.add(from);
    if (i + 1 == loop.count && !loop.closed) break;
    const Corner& to = loop.corners[i + 1 < loop.count ? i + 1 : 0];
    const Vec3 way = flat(to.x) - start;
    const double length = norm(way);
    if (length <= near) continue;
    const double middle = -dot(start, way) / length;
    const double off = norm2(start + way * (middle / length)), reach = disc.radius * disc.radius - off;
    if (!(reach > 0.0)) continue;
    const double half = std::sqrt(reach);
    for (std::uint32_t k = 0; k < 2; k++) {
      const double at = k == 0 ? middle - half : middle + half;
      if (at <= near || at >= length - near) continue;
      kept.add({from.x + (to.x - from.x) * (at / length), name_of(rim_crossing, from.edge, k), 0});
    }
  }
  if (loop.closed) add_rim_points(loop, normal, disc, near, kept);
  loop = kept;
}

}  // namespace

void clip(Loop& loop, Vec3 normal, const Feature& face, double near) {
  if (face.kind == Feature::Kind::disc) return clip_by_rim(loop, normal, face, near);
  for (std::uint32_t i = 0; i < face.loop.count && loop.count > 0; i++) {
    const Corner &from = face.loop.corners[i], &to = face.loop.corners[i + 1 < face.loop.count ? i + 1 : 0];
    clip_by_plane(loop, from.x, direction(cross(to.x - from.x, face.normal)), side_name(from.edge), near);
  }
}

}  // namespace pantin
