#include "view/making.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/shortened.hpp"
#include "contacts/find.hpp"
#include "edit/assemble.hpp"
#include "measure/measure.hpp"
#include "structures/polyhedra.hpp"
#include "view/draw_list.hpp"
#include "view/pick.hpp"
#include "view/stroke.hpp"

namespace pantin {

namespace {

/// What a usual thing of the scene weighs [kg].
double usual_mass(const World& world) {
  const Things all = everything(world);
  const std::size_t count = all.bodies.size() + all.free_points.size();
  const double mean = count > 0 ? mass(world, all) / static_cast<double>(count) : 1.0;
  return mean > 0.0 && std::isfinite(mean) ? mean : 1.0;
}

/// A place at the height at which things are, in the plane of the world if it has one.
std::optional<Vec3> usual_height(const World& world) {
  const Things all = everything(world);
  if (!all.bodies.empty()) return world.motion_of(all.bodies[0]).x;
  if (!all.free_points.empty()) return position(world, all.free_points[0]);
  return {};
}

enum Makes : std::size_t { rod, ball, box, wheel, tetrahedron, octahedron, dodecahedron };

std::vector<Vec3> vertices_of(std::size_t variant) {
  switch (variant) {
    case tetrahedron: return shapes::tetrahedron(1.0).vertices;
    case octahedron: return shapes::octahedron(1.0).vertices;
    case dodecahedron: return shapes::dodecahedron(1.0).vertices;
    default: return shapes::icosahedron(1.0).vertices;
  }
}

/// What is built by hand has numbers that can be read: to some hundredth of the unit, a power of ten [m].
double round_step(double unit) { return std::pow(10.0, std::floor(std::log10(0.02 * unit))); }
Vec3 rounded(Vec3 x, double step) {
  const double per_step = std::round(1.0 / step);
  for (int i = 0; i < 3; i++)
    x[i] = step < 1.0 ? std::round(x[i] * per_step) / per_step : std::round(x[i] / step) * step;
  return x;
}

/// [m] What a pixel shows of the plane, or else of that depth.
Vec3 place_shown(const Viewport& viewport, double x, double y, double depth) {
  return viewport.place(x, y, depth_of_plane(viewport, x, y).value_or(depth));
}

std::vector<Vec3> corners_of(Vec3 half) {
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; i++) corners.push_back(half * vec(i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0));
  return corners;
}

/// Half the edges of a box that is dragged from corner to corner: as deep as it is narrow.
Vec3 half_of_box(Vec3 way, double least) {
  Vec3 half = 0.5 * vec(std::fabs(way[0]), std::fabs(way[1]), std::fabs(way[2]));
  int depth = 0;
  for (int i = 1; i < 3; i++)
    if (half[i] < half[depth]) depth = i;
  const double a = std::fmax(half[(depth + 1) % 3], least), b = std::fmax(half[(depth + 2) % 3], least);
  half[(depth + 1) % 3] = a;
  half[(depth + 2) % 3] = b;
  half[depth] = std::fmin(a, b);
  return half;
}

/// [m] How far a body's shapes are from a place along a direction, either way; no body: 0.
double half_width(const World& world, BodyId body, Vec3 at, Vec3 along) {
  double most = 0.0;
  if (!body) return most;
  for (const ShapeId id : world.bodies[body].shapes) {
    const Bounds box = bounds_of(world.shapes[id].geometry, pose_of(world, world.shapes[id]));
    most = std::max({most, dot(box.high - at, along), dot(at - box.low, along)});
  }
  return most;
}

/// Across the plane, or along the axis of the ground that is seen along most.
Vec3 axle_of(const Viewport& viewport) {
  if (viewport.world.plane.flat()) return viewport.world.plane.about(vec(1, 1, 1));
  const Vec3 along = viewport.camera.forward();
  return std::fabs(along[0]) > std::fabs(along[2]) ? vec(1, 0, 0) : vec(0, 0, 1);
}

/// From the press to the cursor [m], along the picture.
Vec3 way_of(const Viewport& viewport, const MakingDrag& drag) {
  return viewport.place(drag.x, drag.y, drag.depth) - viewport.place(drag.x0, drag.y0, drag.depth);
}

BodyId body_of(const World& world, const MakingDrag& drag) {
  return world.points.alive(drag.point) ? world.points[drag.point].body : drag.body;
}

double step_of(const Viewport& viewport, const MakingDrag& drag) {
  return drag.snaps ? grid_of(viewport) : round_step(viewport.stage.unit);
}

/// Each returns its mass by that of a usual thing.
double make_rod(const Viewport& viewport, const MakingDrag& drag, Command& c) {
  const World& world = viewport.world;
  const bool touches = !world.shapes.empty();
  const double unit = viewport.stage.unit;
  c.position = drag.start;
  c.point = world.points.alive(drag.point) ? drag.point : PointId{};
  if (touches) c.radius = 0.05 * unit;
  if (touches && !c.point && drag.body) c.thing = drag.body;
  if (touches && !c.point) c.position = rounded(c.position, step_of(viewport, drag));
  if (drag.click) {
    c.points = {zero3(), viewport.camera.right() * unit};
    return 1.0;
  }
  Vec3 to = place_shown(viewport, drag.x, drag.y, drag.depth);
  const Held end = pick_held(viewport, drag.x, drag.y);
  if (end.point && end.point != drag.point) {
    c.other = end.point;
    to = position(world, end.point);
  } else if (touches && end.body && end.body != drag.body) {
    c.other_thing = end.body;
  }
  if (touches && !c.other) to = rounded(to, step_of(viewport, drag));
  c.points = {zero3(), shortened(to - c.position, std::fmax(largest(to), largest(c.position)))};
  return norm(c.points[1]) / unit;
}

double make_box(const Viewport& viewport, const MakingDrag& drag, Command& c) {
  const double unit = viewport.stage.unit, step = step_of(viewport, drag);
  const Vec3 from = place_shown(viewport, drag.x0, drag.y0, drag.depth);
  const Vec3 to = drag.click ? from + 0.5 * unit * (viewport.camera.right() + viewport.camera.up())
                             : place_shown(viewport, drag.x, drag.y, drag.depth);
  const Vec3 way_to = rounded(rounded(to, step) - rounded(from, step), step);
  c.position = rounded(0.5 * (rounded(from, step) + rounded(to, step)), 0.1 * step);
  c.amount = half_of_box(way_to, step);
  c.points = corners_of(c.amount);
  return c.amount[0] * c.amount[1] * c.amount[2] / std::pow(0.25 * unit, 3.0);
}

double make_round(const Viewport& viewport, const MakingDrag& drag, Command& c) {
  const double unit = viewport.stage.unit, step = step_of(viewport, drag);
  const bool is_round = drag.variant == ball || drag.variant == wheel, touches = !viewport.world.shapes.empty();
  const double usual = is_round ? 0.25 * unit : 0.5 * unit, length = drag.click ? usual : norm(way_of(viewport, drag));
  const double radius = std::fmax(touches ? rounded(vec(length, 0, 0), step)[0] : length, step);
  c.position = viewport.place(drag.x0, drag.y0, drag.depth);
  if (drag.variant == wheel && (drag.point || drag.body)) {
    c.position = touches && drag.body ? rounded(drag.start, step) : drag.start;
    c.point = viewport.world.points.alive(drag.point) ? drag.point : PointId{};
    if (!c.point) c.thing = drag.body;
    if (drag.body) c.position = viewport.world.plane.beside(c.position, viewport.world.motion_of(drag.body).x);
  } else if (touches) {
    c.position = rounded(c.position, step);
  }
  c.points = {zero3()};
  if (is_round) c.radius = radius;
  if (drag.variant == wheel) {
    const double beyond = half_width(viewport.world, body_of(viewport.world, drag), c.position, axle_of(viewport));
    const double half = std::fmax(0.2 * radius, beyond + 0.1 * radius);
    c.amount = axle_of(viewport) * (touches ? rounded(vec(half, 0, 0), 0.01 * step)[0] : half);
    constexpr int spokes = 12;
    const Vec3 across = cross(axle_of(viewport), vec(0, 1, 0)), other = cross(across, axle_of(viewport));
    for (int i = 0; i < spokes && norm2(across) > 0.0; i++) {
      const double angle = 6.283185307179586 * i / spokes;
      c.points.push_back((across * std::cos(angle) + other * std::sin(angle)) * radius);
    }
  } else if (!is_round) {
    c.points = vertices_of(drag.variant);
    const double scale = radius / norm(c.points[0]);
    for (Vec3& p : c.points) p *= scale;
  }
  return std::pow(radius / usual, 3.0);
}

/// Of a piece of a stroke those that lie farthest from the line between its ends (Douglas and Peucker 1973); the end may be the
/// stroke's first again.
void keep_corners(const std::vector<Vec3>& stroke, std::size_t from, std::size_t to, double least,
                  std::vector<bool>& kept) {
  const Vec3 a = stroke[from], way = stroke[to % stroke.size()] - a;
  std::size_t far = from;
  double most = least;
  for (std::size_t i = from + 1; i < to; i++) {
    const Vec3 off = stroke[i] - a;
    const double along = norm2(way) > 0.0 ? std::clamp(dot(off, way) / norm2(way), 0.0, 1.0) : 0.0;
    const double missed = norm(off - way * along);
    if (missed > most) far = i, most = missed;
  }
  if (far == from) return;
  kept[far] = true;
  keep_corners(stroke, from, far, least, kept);
  keep_corners(stroke, far, to, least, kept);
}

}  // namespace

std::optional<double> depth_of_plane(const Viewport& viewport, double x, double y) {
  return depth_of_plane(viewport, x, y, usual_height(viewport.world).value_or(zero3()));
}

std::optional<double> depth_of_plane(const Viewport& viewport, double x, double y, Vec3 through) {
  const int normal = viewport.world.plane.normal;
  if (normal < 0) return {};
  const Vec3 near = viewport.place(x, y, 1.0), far = viewport.place(x, y, 2.0);
  const double depth = 1.0 + (through[normal] - near[normal]) / (far[normal] - near[normal]);
  return std::isfinite(depth) && depth > 0.0 ? std::optional(depth) : std::nullopt;
}

Vec3 place_pointed_at(const Viewport& viewport, double x, double y) {
  const Vec3 place = place_shown(viewport, x, y, viewport.camera.distance);
  return viewport.world.plane.beside(place, usual_height(viewport.world).value_or(zero3()));
}

double grid_of(const Viewport& viewport) { return 10.0 * round_step(viewport.stage.unit); }

Vec3 place_to_make(const Viewport& viewport, double x, double y, bool snaps) {
  const double depth = dot(viewport.camera.target - viewport.camera.eye(), viewport.camera.forward());
  return rounded(place_shown(viewport, x, y, depth), snaps ? grid_of(viewport) : round_step(viewport.stage.unit));
}

Vec3 mirror_of(const Viewport& viewport) {
  const Vec3 right = viewport.world.plane.along(viewport.camera.right());
  Vec3 normal = zero3();
  int most = 0;
  for (int i = 1; i < 3; i++)
    if (std::fabs(right[i]) > std::fabs(right[most])) most = i;
  normal[most] = 1.0;
  return normal;
}

Vec3 hinge_axis(const Viewport& viewport) {
  if (viewport.world.plane.flat()) return zero3();
  const Vec3 along = viewport.camera.forward();
  int most = 2;
  for (int i = 0; i < 3; i++)
    if (std::fabs(along[i]) > std::fabs(along[most])) most = i;
  Vec3 axis = zero3();
  axis[most] = 1.0;
  return axis;
}

std::vector<Vec3> corners_of_stroke(const Viewport& viewport, const std::vector<Vec3>& stroke) {
  constexpr double missed = 4.0;  // [px]
  if (stroke.size() < 3) return stroke;
  const auto seen = viewport.project(stroke[0]);
  const double least = missed * (seen ? seen->pixel : 0.0);
  std::size_t far = 0;
  for (std::size_t i = 1; i < stroke.size(); i++)
    if (norm(stroke[i] - stroke[0]) > norm(stroke[far] - stroke[0])) far = i;
  std::vector<bool> kept(stroke.size(), false);
  kept[0] = kept[far] = true;
  keep_corners(stroke, 0, far, least, kept);
  keep_corners(stroke, far, stroke.size(), least, kept);
  std::vector<Vec3> corners;
  for (std::size_t i = 0; i < stroke.size(); i++)
    if (kept[i]) corners.push_back(stroke[i]);
  return corners;
}

Command made_of_outline(const Viewport& viewport, std::vector<Vec3> outline) {
  const World& world = viewport.world;
  const double step = round_step(viewport.stage.unit);
  const Vec3 axis = world.plane.flat() ? world.plane.about(vec(1, 1, 1)) : hinge_axis(viewport);
  Command c;
  c.kind = Command::Kind::make;
  c.form = MadeForm::polygon;
  for (const Vec3 at : outline) c.position += at / static_cast<double>(outline.size());
  c.position = rounded(c.position, step);
  c.position = world.plane.beside(c.position, usual_height(world).value_or(zero3()));
  for (const Vec3 at : outline) {
    const Vec3 way = rounded(at - c.position, step);
    c.points.push_back(way - axis * dot(way, axis));
  }
  c.amount = axis * rounded(vec(std::fmax(0.25 * viewport.stage.unit, step), 0, 0), step)[0];
  return c;
}

Command made_by_drag(const Viewport& viewport, const MakingDrag& drag) {
  Command c;
  c.kind = Command::Kind::make;
  const World& world = viewport.world;
  const bool touches = !world.shapes.empty();
  double part = 1.0;  // of its usual size
  if (drag.variant == rod)
    part = make_rod(viewport, drag, c);
  else if (drag.variant == box)
    part = make_box(viewport, drag, c);
  else
    part = make_round(viewport, drag, c);
  if (const auto height = usual_height(world); !world.points.alive(c.point))
    c.position = world.plane.beside(c.position, height.value_or(zero3()));
  if (drag.variant == rod) c.points[1] = world.plane.along(c.points[1]);
  if (drag.variant == rod) c.amount = hinge_axis(viewport);
  if (!touches) {
    c.mass = usual_mass(world) * part;
    c.amount = zero3();
    return c;
  }
  static constexpr std::array<MadeForm, 4> forms = {MadeForm::rod, MadeForm::ball, MadeForm::box, MadeForm::wheel};
  c.form = drag.variant < forms.size() ? forms[drag.variant] : MadeForm::hull;
  return c;
}

}  // namespace pantin
