// Where on a shape its picture lies: once over its box, or again and again.
#include "view/figure_pictures.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace pantin {

namespace {

constexpr int round_sides = 24, cap_rings = 6;  // of a capsule
constexpr double front = 0.25;                  // [turns] from where angles are counted to the middle of a picture

struct Papered {
  double u, v;  // to the right and up
};

/// On a surface as seen from outside, upright on what is not level: [m].
Papered across(Vec3 at, Vec3 facing) {
  int axis = 0;
  for (int i = 1; i < 3; i++)
    if (std::fabs(facing[i]) > std::fabs(facing[axis])) axis = i;
  const double side = facing[axis] < 0.0 ? -1.0 : 1.0;
  if (axis == 0) return {-side * at[2], static_cast<double>(at[1])};
  if (axis == 1) return {static_cast<double>(at[0]), -side * at[2]};
  return {side * at[0], static_cast<double>(at[1])};
}

/// Whole pictures of a length that fit round another, at least one.
double times_round(double length, double picture) {
  return picture > 0.0 ? std::fmax(1.0, std::round(length / picture)) : 1.0;
}

struct Paperer {
  Figure::Sheet& sheet;
  const Shape& shape;
  const Cover& cover = *shape.cover;
  Pose pose{shape.at, matrix(shape.orientation)};

  void put(Vec3 at, Vec3 normal, double u, double v) const {
    sheet.corners.push_back(
        {pose.to_world(at), pose.R * normal, shape.color, static_cast<float>(u), static_cast<float>(v)});
  }
  /// A part of the picture, from its left and its lower edge, that does not go over its edges.
  void put_once(Vec3 at, Vec3 normal, double u, double v) const {
    const PictureEdges e = edges_of(*cover.picture);
    const double left = static_cast<double>(e.left), right = static_cast<double>(e.right);
    const double upper = static_cast<double>(e.upper), lower = static_cast<double>(e.lower);
    put(at, normal, left + (right - left) * u, lower + (upper - lower) * v);
  }
  void put_flat(Vec3 at, Vec3 normal, Vec3 facing) const {
    const Papered spot = across(at, facing), a = across(cover.low, facing), b = across(cover.high, facing);
    const double u = spot.u - std::fmin(a.u, b.u), v = spot.v - std::fmin(a.v, b.v);
    if (cover.width > 0.0) return put(at, normal, u / cover.width, -v / height_of(cover));
    put_once(at, normal, u / std::fabs(b.u - a.u), v / std::fabs(b.v - a.v));
  }
  /// Round the third axis; `turned` is how far [turns], `along` [m] of `whole`.
  void put_round(Vec3 at, Vec3 normal, double turned, double along, double whole, double radius) const {
    const double u = (turned - front) * times_round(2.0 * std::numbers::pi * radius, cover.width);
    if (cover.width > 0.0) return put(at, normal, u, -along / height_of(cover));
    const PictureEdges e = edges_of(*cover.picture);
    const double upper = static_cast<double>(e.upper), lower = static_cast<double>(e.lower);
    put(at, normal, u, lower + (upper - lower) * along / whole);
  }

  void paper(const Figure& bare) const {
    const auto* cylinder = std::get_if<CylinderShape>(&shape.geometry);
    const bool level = std::holds_alternative<std::shared_ptr<const HeightField>>(shape.geometry);
    for (std::size_t i = 0; i + 2 < bare.corners.size(); i += 3) {
      std::array<Vec3, 3> at, normal;
      for (std::size_t k = 0; k < 3; k++) {
        at[k] = pose.to_local(bare.corners[i + k].at);
        normal[k] = transposed_times(pose.R, bare.corners[i + k].normal);
      }
      const Vec3 facing = level ? vec(0, 1, 0) : cross(at[1] - at[0], at[2] - at[0]);
      if (cylinder && std::fabs(facing[2]) < 0.5 * norm(facing)) {
        paper_side(at, normal, *cylinder);
      } else {
        for (std::size_t k = 0; k < 3; k++) put_flat(at[k], normal[k], facing);
      }
    }
  }
  void paper_side(const std::array<Vec3, 3>& at, const std::array<Vec3, 3>& normal, const CylinderShape& c) const {
    const auto turned = [&](std::size_t k) {
      return std::atan2(static_cast<double>(at[k][1]), static_cast<double>(at[k][0])) / (2.0 * std::numbers::pi);
    };
    for (std::size_t k = 0; k < 3; k++)
      put_round(at[k], normal[k], turned(0) + std::remainder(turned(k) - turned(0), 1.0), at[k][2] + c.half,
                2.0 * c.half, c.radius);
  }
  void paper_capsule(const CapsuleShape& c) const {
    struct Ring {
      double angle, from;  // [rad] from the axis, [m] of its cap's middle
    };
    std::vector<Ring> rings;
    for (const double end : {-1.0, 1.0})
      for (int k = 0; k <= cap_rings; k++)
        rings.push_back({std::numbers::pi * (0.25 * (1.0 - end) + 0.5 * (1.0 - k / double{cap_rings})), end * c.half});
    const auto corner = [&](std::size_t ring, int side) {
      const Ring& r = rings[ring];
      const double turned = side / double{round_sides}, a = 2.0 * std::numbers::pi * turned;
      const Vec3 n = vec(std::sin(r.angle) * std::cos(a), std::sin(r.angle) * std::sin(a), std::cos(r.angle));
      const double along = (std::numbers::pi - r.angle) * c.radius + (r.from + c.half);
      put_round(vec(0, 0, r.from) + n * c.radius, n, turned, along, std::numbers::pi * c.radius + 2.0 * c.half,
                c.radius);
    };
    for (std::size_t ring = 0; ring + 1 < rings.size(); ring++)
      for (int side = 0; side < round_sides; side++) {
        corner(ring, side), corner(ring, side + 1), corner(ring + 1, side + 1);
        corner(ring, side), corner(ring + 1, side + 1), corner(ring + 1, side);
      }
  }
  void paper_ball(const BallShape& ball, const Figure::Ellipsoid& ellipsoid) const {
    const double round = 2.0 * std::numbers::pi * ball.radius;
    sheet.globes.push_back({ellipsoid, static_cast<float>(times_round(round, cover.width)),
                            static_cast<float>(times_round(0.5 * round, height_of(cover)))});
  }
};

Figure::Sheet& sheet_with(Figure& figure, const std::shared_ptr<const Picture>& picture) {
  for (Figure::Sheet& sheet : figure.sheets)
    if (sheet.picture == picture) return sheet;
  return figure.sheets.emplace_back(Figure::Sheet{picture, {}, {}});
}

}  // namespace

PictureEdges edges_of(const Picture& picture) {
  const float wide = 0.5f / static_cast<float>(picture.columns), high = 0.5f / static_cast<float>(picture.rows);
  return {wide, 1.0f - wide, high, 1.0f - high};
}

double height_of(const Cover& cover) { return cover.width * cover.picture->rows / cover.picture->columns; }

void add_covered(Figure& figure, const Shape& shape, const Figure& bare) {
  const Paperer paperer{sheet_with(figure, shape.cover->picture), shape};
  if (const auto* ball = std::get_if<BallShape>(&shape.geometry)) return paperer.paper_ball(*ball, bare.ellipsoids[0]);
  if (const auto* capsule = std::get_if<CapsuleShape>(&shape.geometry)) return paperer.paper_capsule(*capsule);
  paperer.paper(bare);
}

}  // namespace pantin
