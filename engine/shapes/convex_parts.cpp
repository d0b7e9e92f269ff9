#include "shapes/convex_parts.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>

#include "base/check.hpp"

namespace pantin {
namespace {

constexpr double straight = 1e-9;  // relative: a turn by less is none

using Outline = std::vector<Vec3>;

/// Twice the area of a triangle, positive where it turns left about the normal.
double turn(Vec3 a, Vec3 b, Vec3 c, Vec3 normal) { return dot(cross(b - a, c - b), normal); }

bool turns_left(Vec3 a, Vec3 b, Vec3 c, Vec3 normal) {
  return turn(a, b, c, normal) > straight * norm(b - a) * norm(c - b);
}

double area(const Outline& loop, Vec3 normal) {
  double sum = 0.0;
  for (std::size_t i = 2; i < loop.size(); i++) sum += 0.5 * turn(loop[0], loop[i - 1], loop[i], normal);
  return sum;
}

Outline without_straight_corners(Outline loop, Vec3 normal) {
  for (std::size_t i = 0; i < loop.size() && loop.size() >= 3;) {
    const std::size_t n = loop.size();
    const Vec3 a = loop[(i + n - 1) % n], b = loop[i], c = loop[(i + 1) % n];
    const bool is_straight = std::fabs(turn(a, b, c, normal)) <= straight * norm(b - a) * norm(c - b);
    if (is_straight)
      loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(i)), i = 0;
    else
      i++;
  }
  return loop;
}

bool is_convex_outline(const Outline& loop, Vec3 normal) {
  const std::size_t n = loop.size();
  for (std::size_t i = 0; i < n; i++)
    if (!turns_left(loop[i], loop[(i + 1) % n], loop[(i + 2) % n], normal)) return false;
  return true;
}

/// Also where they touch.
bool cross_each_other(Vec3 a, Vec3 b, Vec3 c, Vec3 d, Vec3 normal) {
  const auto between = [&](Vec3 p, Vec3 q, Vec3 r) { return dot(r - p, r - q) <= 0.0; };
  const double c_side = turn(a, b, c, normal), d_side = turn(a, b, d, normal);
  const double a_side = turn(c, d, a, normal), b_side = turn(c, d, b, normal);
  if (((c_side > 0.0) != (d_side > 0.0)) && ((a_side > 0.0) != (b_side > 0.0))) return true;
  return (c_side == 0.0 && between(a, b, c)) || (d_side == 0.0 && between(a, b, d)) ||
         (a_side == 0.0 && between(c, d, a)) || (b_side == 0.0 && between(c, d, b));
}

void require_simple(const Outline& loop, Vec3 normal) {
  const std::size_t n = loop.size();
  for (std::size_t i = 0; i < n; i++)
    for (std::size_t k = i + 2; k < n; k++)
      require((k + 1) % n == i || !cross_each_other(loop[i], loop[i + 1], loop[k], loop[(k + 1) % n], normal),
              "the outline crosses itself");
}

bool is_ear(const Outline& loop, std::size_t i, Vec3 normal) {
  const std::size_t n = loop.size();
  const Vec3 a = loop[(i + n - 1) % n], b = loop[i], c = loop[(i + 1) % n];
  if (!turns_left(a, b, c, normal)) return false;
  for (std::size_t k = 0; k + 3 < n; k++) {
    const Vec3 p = loop[(i + 2 + k) % n];
    if (turn(a, b, p, normal) >= 0.0 && turn(b, c, p, normal) >= 0.0 && turn(c, a, p, normal) >= 0.0) return false;
  }
  return true;
}

std::vector<Outline> triangles_of(Outline loop, Vec3 normal) {
  std::vector<Outline> triangles;
  while (loop.size() > 3) {
    std::size_t ear = 0;
    while (ear < loop.size() && !is_ear(loop, ear, normal)) ear++;
    require(ear < loop.size(), "the outline crosses itself, or nearly");
    const std::size_t n = loop.size();
    triangles.push_back({loop[(ear + n - 1) % n], loop[ear], loop[(ear + 1) % n]});
    loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  triangles.push_back(std::move(loop));
  return triangles;
}

bool is_same(Vec3 a, Vec3 b) { return norm2(a - b) == 0.0; }

/// Both as one where they share an edge and it is convex.
std::optional<Outline> together(const Outline& a, const Outline& b, Vec3 normal) {
  for (std::size_t i = 0; i < a.size(); i++)
    for (std::size_t k = 0; k < b.size(); k++) {
      if (!is_same(a[i], b[(k + 1) % b.size()]) || !is_same(a[(i + 1) % a.size()], b[k])) continue;
      Outline sum;
      for (std::size_t j = 0; j < a.size(); j++) sum.push_back(a[(i + 1 + j) % a.size()]);
      for (std::size_t j = 2; j < b.size(); j++) sum.push_back(b[(k + j) % b.size()]);
      if (is_convex_outline(sum, normal)) return sum;
    }
  return {};
}

bool put_two_together(std::vector<Outline>& parts, Vec3 normal) {
  for (std::size_t i = 0; i < parts.size(); i++)
    for (std::size_t k = i + 1; k < parts.size(); k++)
      if (auto sum = together(parts[i], parts[k], normal)) {
        parts[i] = std::move(*sum);
        parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(k));
        return true;
      }
  return false;
}

}  // namespace

std::vector<std::vector<Vec3>> convex_parts(std::span<const Vec3> outline, Vec3 normal) {
  Outline loop = without_straight_corners({outline.begin(), outline.end()}, normal);
  require(loop.size() >= 3, "the outline has no area");
  require_simple(loop, normal);
  if (area(loop, normal) < 0.0) std::reverse(loop.begin() + 1, loop.end());
  if (is_convex_outline(loop, normal)) return {loop};
  std::vector<Outline> parts = triangles_of(std::move(loop), normal);
  while (put_two_together(parts, normal)) {}
  return parts;
}

}  // namespace pantin
