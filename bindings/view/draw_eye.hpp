#pragma once
// What those who fill a draw list share.
#include <algorithm>

#include "view/draw_list.hpp"

namespace pantin {

// Of what is shown; the shaders take the root again.
inline float linear(float c) {
  const float part = std::clamp(c, 0.0f, 1.0f);
  return part * part;
}
inline Rgb linear(const Color& c) { return {linear(c.r), linear(c.g), linear(c.b)}; }
inline Rgb mix(Rgb a, Rgb b, float part) {
  return {a.r + (b.r - a.r) * part, a.g + (b.g - a.g) * part, a.b + (b.b - a.b) * part};
}
inline Float3 floats(Vec3 v) { return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])}; }

inline void include(DrawList& s, Float3 p, float r) {
  s.lower = {std::min(s.lower.x, p.x - r), std::min(s.lower.y, p.y - r), std::min(s.lower.z, p.z - r)};
  s.upper = {std::max(s.upper.x, p.x + r), std::max(s.upper.y, p.y + r), std::max(s.upper.z, p.z + r)};
}

struct DrawListMaker::Eye {
  Vec3 at, forward, right, up;
  double unit;   // [m]
  double pixel;  // size of a pixel at distance 1

  double pixel_at(Vec3 p) const { return pixel * std::max(dot(p - at, forward), 1e-3 * unit); }  // [m]
  Float3 place(Vec3 p) const { return floats((p - at) / unit); }
  // A radius [m], but at least some pixels wide where it is.
  float radius(double r, Vec3 p, double least) const {
    return static_cast<float>(std::max(r / unit, least * pixel * std::max(dot(p - at, forward) / unit, 0.0)));
  }
  void ball(DrawList& s, Vec3 p, double r, double least, Rgb color, DrawList::Style style, Rgb second,
            float opacity = 1.0f) const {
    const float radius_of = radius(r, p, least);
    s.balls.push_back({place(p), radius_of, color, static_cast<float>(style), second, opacity});
    include(s, place(p), radius_of);
  }
  void bar(DrawList& s, Vec3 a, Vec3 b, double r, double least, Rgb color, bool unlit = false,
           float opacity = 1.0f) const {
    const float radius_of = radius(r, dot(a - at, forward) < dot(b - at, forward) ? a : b, least);
    s.bars.push_back({place(a), radius_of, place(b), unlit ? 1.0f : 0.0f, color, opacity});
    if (unlit) return;
    include(s, place(a), radius_of);
    include(s, place(b), radius_of);
  }
};

/// The outline of an ellipsoid's shadow: the ellipse to which the light projects its half axes.
void shade_ellipsoid(DrawList& draw_list, const DrawList::Ellipsoid& ellipsoid, float level);

/// Pictures instead of squares; `middle` [m] is that of the floor, `unit` [m] that of the draw list.
void cover_floor(DrawList& draw_list, DrawList::Floor& floor, const Cover& cover, Vec3 middle, const Mat3& axes,
                 double unit);

/// Of what has a picture of its own.
inline constexpr Color untinted = {1.0f, 1.0f, 1.0f, 1.0f};

}  // namespace pantin
