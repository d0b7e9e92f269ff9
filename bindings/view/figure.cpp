#include "view/figure.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "edit/edit.hpp"
#include "view/hull.hpp"

namespace pantin {

namespace {

constexpr double thin = 1e-4;        // of its length: points nearer than this to a line or plane lie in it
constexpr double bar_part = 0.055;   // radius of a bar, of its length
constexpr double plate_part = 0.02;  // half the thickness of a plate, of its size

// The places of a body's points, and of its own mass where it has some.
struct Places {
  std::vector<Vec3> at;
  Vec3 centre = zero3();
  Mat3 axes = identity33();  // columns: directions of falling extent
  Vec3 extent = zero3();     // [m] along them
  Vec3 lower = zero3();      // [m] along them, from the centre
  int dimension = 0;         // 0 a place, 1 a line, 2 a plane, 3 a volume
};

Places measure(const World& world, const Body& body) {
  Places p;
  for (const PointId id : body.points) p.at.push_back(world.points[id].position);
  if (body.own_mass > 0.0 || p.at.empty()) p.at.push_back(body.own_position);
  for (const Vec3 v : p.at) p.centre += v / static_cast<double>(p.at.size());
  Mat3 spread = zero33();
  double size = 0.0;
  for (const Vec3 v : p.at) size = std::max(size, largest(v - p.centre));
  if (!(size > 0.0)) return p;
  for (const Vec3 v : p.at) spread += outer((v - p.centre) / size, (v - p.centre) / size);
  const Mat3 rising = principal_axes(spread, identity33()).axes;
  p.axes = {{rising[2], rising[1], cross(rising[2], rising[1])}};
  for (int i = 0; i < 3; i++) {
    double low = 0.0, high = 0.0;
    for (const Vec3 v : p.at) {
      low = std::min(low, dot(v - p.centre, p.axes[i]));
      high = std::max(high, dot(v - p.centre, p.axes[i]));
    }
    p.lower[i] = low;
    p.extent[i] = high - low;
  }
  p.dimension = p.extent[1] <= thin * p.extent[0] ? 1 : p.extent[2] <= thin * p.extent[0] ? 2 : 3;
  return p;
}

// Half axes of the even ellipsoid of the body's own mass and inertia: a_i² = 5/(2 m) (I_j + I_k - I_i).
Figure::Ellipsoid own_ellipsoid(const Body& body, const Color& color) {
  Figure::Ellipsoid ellipsoid;
  ellipsoid.color = color;
  if (!(body.own_mass > 0.0) || !(trace(body.own_inertia) > 0.0)) return ellipsoid;
  const double scale = trace(body.own_inertia);
  const Principal own = principal_axes(body.own_inertia * (1.0 / scale), identity33());
  double half[3], moment[3];
  for (int i = 0; i < 3; i++) {
    moment[i] = own.moments[i] * scale;
    const double square = 2.5 / body.own_mass * (trace(body.own_inertia) - 2.0 * moment[i]);
    half[i] = std::sqrt(std::max(square, 0.0));
  }
  const double most = std::max({half[0], half[1], half[2]});
  // The axis of symmetry is the one whose moment lies farther from the middle one.
  const int axis = moment[2] - moment[1] >= moment[1] - moment[0] ? 2 : 0;
  const int order[3] = {(axis + 2) % 3, axis, (axis + 1) % 3};
  for (int i = 0; i < 3; i++) ellipsoid.axes[i] = own.axes[order[i]] * std::max(half[order[i]], 0.02 * most);
  return ellipsoid;
}

void add_triangle(Figure& figure, Vec3 a, Vec3 b, Vec3 c, const Color& color) {
  const Vec3 normal = direction(cross(b - a, c - a));
  for (const Vec3 v : {a, b, c}) figure.corners.push_back({v, normal, color});
}

void make_plate(Figure& figure, const Places& places, const Color& color) {
  std::vector<Vec3> at = places.at;
  if (places.dimension == 2) {
    const Vec3 half = places.axes[2] * (plate_part * places.extent[0]);
    for (const Vec3 v : places.at) at.push_back(v + half);
    for (std::size_t i = 0; i < places.at.size(); i++) at[i] -= half;
  }
  for (const auto& f : convex_hull(at)) add_triangle(figure, at[f[0]], at[f[1]], at[f[2]], color);
  figure.joints.assign(figure.joints.size(), 0.03 * places.extent[0]);
}

// A capsule along the points, with a ball for each mass on it.
void make_line(Figure& figure, const World& world, const Body& body, const Places& places, const Stage& stage,
               const Figure::Ellipsoid& ellipsoid) {
  const Color& color = ellipsoid.color;
  const Vec3 from = places.centre + places.axes[0] * places.lower[0];
  const double length = places.extent[0];
  double radius = bar_part * std::min(length, 2.0 * stage.unit);
  double wide = 0.0;
  for (int i = 0; i < 3; i++)
    wide = std::max(wide, norm(ellipsoid.axes[i] - places.axes[0] * dot(ellipsoid.axes[i], places.axes[0])));
  const bool round = wide > 0.18 * length;
  if (wide > 0.0 && !round) radius = std::clamp(wide * std::sqrt(0.8), 0.03 * length, 0.1 * length);
  double most = body.own_mass;
  for (const PointId id : body.points) most = std::max(most, world.points[id].mass);
  const bool weighted = !(trace(body.own_inertia) > 0.0);
  if (round || weighted) radius *= 0.6;
  if (round) figure.ellipsoids.push_back(ellipsoid);
  figure.bars.push_back({from, from + places.axes[0] * length, radius, color});
  const auto ball = [&](Vec3 at, double mass, double given, Color of_point) {
    if (given > 0.0) figure.balls.push_back({at, given, of_point});
    if (!(given > 0.0) && weighted && mass > 0.0)
      figure.balls.push_back({at, 3.2 * radius * std::cbrt(mass / most), of_point});
  };
  for (std::size_t i = 0; i < body.points.size(); i++) {
    const Point& p = world.points[body.points[i]];
    const std::size_t before = figure.balls.size();
    ball(p.position, p.mass, p.radius, p.color);
    figure.joints[i] = figure.balls.size() > before ? 0.78 * figure.balls.back().radius : radius;
  }
  ball(body.own_position, body.own_mass, 0.0, color);
}

}  // namespace

namespace {

void add_points(Figure& figure, const World& world, const Body& body) {
  for (const PointId p : body.points)
    if (world.points[p].radius > 0.0)
      figure.balls.push_back({world.points[p].position, world.points[p].radius, world.points[p].color});
}

void make_solid(Figure& figure, const World& world, const Body& body, const Stage& stage) {
  double thinnest = 0.2 * stage.unit;
  for (const ShapeId id : body.shapes) {
    add_shape(figure, world.shapes[id]);
    thinnest = std::min(thinnest, thickness_of(world.shapes[id].geometry));
  }
  figure.joints.assign(figure.joints.size(), 0.4 * thinnest);
  add_points(figure, world, body);
}

}  // namespace

Figure make_figure(const World& world, BodyId id, const Stage& stage) {
  const Body& body = world.bodies[id];
  Figure figure;
  figure.joints.assign(body.points.size(), 0.0);
  figure.sprite = body.sprite;
  if (!body.shapes.empty()) {
    make_solid(figure, world, body, stage);
    return figure;
  }
  const Color color = body.points.empty() ? BodyDef().color : world.points[body.points[0]].color;
  const Places places = measure(world, body);
  const Figure::Ellipsoid ellipsoid = own_ellipsoid(body, color);
  if (places.dimension >= 2) {
    make_plate(figure, places, color);
    add_points(figure, world, body);
  } else if (places.dimension == 1) {
    make_line(figure, world, body, places, stage, ellipsoid);
  } else if (norm(ellipsoid.axes[0]) > 0.0) {
    figure.ellipsoids.push_back(ellipsoid);
    figure.joints.assign(figure.joints.size(), 0.1 * norm(ellipsoid.axes[0]));
  } else {
    const double given = body.points.empty() ? 0.0 : world.points[body.points[0]].radius;
    figure.balls.push_back({places.centre, given > 0.0 ? given : 0.12 * stage.unit, color});
    figure.joints.assign(figure.joints.size(), 0.78 * figure.balls.back().radius);
  }
  return figure;
}

Figure make_figure(const World& world, ShapeId id) {
  Figure figure;
  add_shape(figure, world.shapes[id]);
  return figure;
}

const Figure& Figures::of(const World& world, BodyId id, const Stage& stage) {
  const Body& body = world.bodies[id];
  Hash hash;
  hash.add((std::uint64_t{id.generation} << 32) | body.points.size());
  hash.add(body.own_mass);
  hash.add(body.own_position);
  for (int i = 0; i < 3; i++) hash.add(body.own_inertia[i]);
  for (const PointId p : body.points) {
    const Point& point = world.points[p];
    hash.add(point.position);
    hash.add(point.mass);
    hash.add(point.radius);
    for (const float c : {point.color.r, point.color.g, point.color.b, point.color.a})
      hash.add(std::uint64_t{std::bit_cast<std::uint32_t>(c)});
  }
  hash.add(std::uint64_t{reinterpret_cast<std::uintptr_t>(body.sprite.get())});
  for (const ShapeId s : body.shapes) add_to(hash, world.shapes[s]);
  if (bodies_.size() < world.bodies.slots()) bodies_.resize(world.bodies.slots());
  Figure& figure = bodies_[id.slot - 1];
  if (figure.hash != hash.value) {
    figure = make_figure(world, id, stage);
    figure.hash = hash.value;
  }
  return figure;
}

const Figure& Figures::of(const World& world, ShapeId id) {
  Hash hash;
  hash.add(std::uint64_t{id.generation});
  add_to(hash, world.shapes[id]);
  if (shapes_.size() < world.shapes.slots()) shapes_.resize(world.shapes.slots());
  Figure& figure = shapes_[id.slot - 1];
  if (figure.hash != hash.value) {
    figure = make_figure(world, id);
    figure.hash = hash.value;
  }
  return figure;
}

void Figures::clear() {
  bodies_.clear();
  shapes_.clear();
}

}  // namespace pantin
