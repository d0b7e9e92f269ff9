// One body that becomes two, or many.
#include <algorithm>
#include <cmath>
#include <tuple>
#include <unordered_set>

#include "base/interruptible.hpp"
#include "base/random.hpp"
#include "contacts/find.hpp"
#include "edit/assemble.hpp"
#include "edit/divide.hpp"
#include "shapes/cut.hpp"
#include "shapes/distance.hpp"
#include "shapes/mass.hpp"

namespace pantin {

using namespace internal;

namespace {

constexpr double flush = 1e-9;          // of the thickness: how far beside a plane a shape may be that is not cut
constexpr double across = 1.0 - 1e-14;  // cosine of the angle at which a cylinder is cut into cylinders

/// By how much a hull of a shape has to be denser to weigh as much.
double denser_of(const Geometry& shape, const std::shared_ptr<const Hull>& hull) {
  const bool is_polyhedron =
      std::holds_alternative<BoxShape>(shape) || std::holds_alternative<std::shared_ptr<const Hull>>(shape);
  return is_polyhedron ? 1.0 : solid_mass(shape).volume / solid_mass(hull).volume;
}

/// "shape 2 of body 'car'"
std::string name_of(const World& world, BodyId body, std::size_t shape) {
  return text("shape ", shape + 1, " of ", describe(world, body));
}

/// The points that stay; throws Error where the call makes no sense.
std::vector<PointId> rest_of(const World& world, BodyId body, std::span<const PointId> points) {
  require(!points.empty(), "split: no points were given, so there is nothing to split off");
  const std::string who = describe(world, body);
  std::unordered_set<PointId> taken;
  for (std::size_t i = 0; i < points.size(); i++) {
    require(world.points.alive(points[i]), "split: point ", i + 1, ": ", world.points.story(points[i]));
    if (world.points[points[i]].body != body)
      throw Error(text("split: ", describe(world, points[i]), " is not of ", who));
    if (!taken.insert(points[i]).second) throw Error(text("split: ", describe(world, points[i]), " is given twice"));
  }
  std::vector<PointId> rest;
  for (PointId p : world.bodies[body].points)
    if (!taken.contains(p)) rest.push_back(p);
  require(!rest.empty(), "split: these are all points of ", who, "; it must keep one");
  return rest;
}

/// [m] from a shape to the nearest of some points; 0 in it, and where that is less than it is told to.
double distance_to_points(const World& world, const Shape& shape, const std::vector<PointId>& points) {
  const Pose pose = pose_of(world, shape);
  double least = infinity;
  for (PointId p : points)
    least = std::min(least, distance_to(shape.geometry, pose, world.plane.beside(position(world, p), pose.x)));
  return std::max(0.0, least - 1e-6 * thickness_of(shape.geometry));
}

/// A shape goes with the points that are in it, or nearest.
void assign_shapes(const World& world, BodyId body, Part& stays, Part& goes) {
  const std::vector<ShapeId>& shapes = world.bodies[body].shapes;
  for (std::size_t i = 0; i < shapes.size(); i++) {
    const Shape& shape = world.shapes[shapes[i]];
    const double here = distance_to_points(world, shape, stays.points),
                 there = distance_to_points(world, shape, goes.points);
    require(
        shape.sensor || here > 0.0 || there > 0.0, "split: ", name_of(world, body, i),
        " has points of both parts in it, so it can go with neither; give a plane, { through = vec, normal = vec }, "
        "which cuts it");
    (here <= there ? stays : goes).shapes.push_back({shapes[i]});
  }
}

/// A plane of the world; what goes is on the side that the normal [unit length] points to.
struct Side {
  Vec3 through, normal;
};

/// Puts a shape on its side of a plane, or cuts it.
void cut_shape(const World& world, BodyId body, std::size_t i, const Side& side, Part& stays, Part& goes) {
  const ShapeId id = world.bodies[body].shapes[i];
  const Shape& shape = world.shapes[id];
  const Pose pose = pose_of(world, shape);
  const Vec3 n = transposed_times(pose.R, side.normal);
  const double offset = dot(side.normal, side.through - pose.x), round = rounding_of(shape.geometry);
  const double high = dot(n, support_of_core(shape.geometry, n)) + round - offset;
  const double low = dot(n, support_of_core(shape.geometry, -n)) - round - offset;
  const double near = flush * thickness_of(shape.geometry);
  if (high <= near || low >= -near || shape.sensor) {
    const bool is_front = shape.sensor ? offset < 0.0 : high > near;
    (is_front ? goes : stays).shapes.push_back({id});
    return;
  }
  const auto* cylinder = std::get_if<CylinderShape>(&shape.geometry);
  if (cylinder && std::fabs(n[2]) >= across) {
    const double z = offset * n[2], above = 0.5 * (cylinder->half - z), below = 0.5 * (cylinder->half + z);
    const PartShape top{id, CylinderShape{cylinder->radius, above}, vec(0, 0, z + above)},
        bottom{id, CylinderShape{cylinder->radius, below}, vec(0, 0, z - below)};
    goes.shapes.push_back(n[2] > 0.0 ? top : bottom);
    stays.shapes.push_back(n[2] > 0.0 ? bottom : top);
    return;
  }
  const auto hull = polyhedron_of(shape.geometry);
  const double denser = denser_of(shape.geometry, hull);
  const auto back = behind(hull, n, offset), front = behind(hull, -n, -offset);
  if (!back || !front) {
    (front ? goes : stays).shapes.push_back({id});
    return;
  }
  stays.shapes.push_back(piece_of(id, *back, denser));
  goes.shapes.push_back(piece_of(id, *front, denser));
}

BodyId split_in_two(World& world, BodyId body, const std::vector<Part>& parts, std::string name) {
  const BodyId fresh = divide(world, body, parts, true, "split").back();
  world.bodies[fresh].name = std::move(name);
  return fresh;
}

/// Own mass must be the shapes', so that each piece has its share.
void require_filled(const World& world, BodyId body, const char* call) {
  require(!(world.bodies[body].own_mass > 0.0) || is_filled(world, body), call, ": the mass or inertia of ",
          describe(world, body), " was set to something else than its shapes have, so no part has a share of it");
}

}  // namespace

BodyId split(World& world, BodyId body, std::span<const PointId> points, std::string name) {
  require_unlocked(world, "split");
  require(world.bodies.alive(body), "split: ", world.bodies.story(body));
  Part stays{"what is left of it", rest_of(world, body, points), {}};
  Part goes{"what is split off", {points.begin(), points.end()}, {}};
  assign_shapes(world, body, stays, goes);
  return split_in_two(world, body, {stays, goes}, std::move(name));
}

BodyId split(World& world, BodyId body, Vec3 through, Vec3 normal, std::string name) {
  require_unlocked(world, "split");
  require(world.bodies.alive(body), "split: ", world.bodies.story(body));
  require_finite("split", "through", through, "m");
  require_finite("split", "normal", normal, "");
  require(norm(normal) > 0.0, "split: normal must have a length > 0");
  require_in_plane(world, "split", "normal", normal, "");
  require_filled(world, body, "split");
  const Side side{through, direction(normal)};
  Part stays{"what is behind the plane", {}, {}}, goes{"what is in front of the plane", {}, {}};
  for (PointId p : world.bodies[body].points)
    (dot(side.normal, position(world, p) - through) > 0.0 ? goes : stays).points.push_back(p);
  for (std::size_t i = 0; i < world.bodies[body].shapes.size(); i++) cut_shape(world, body, i, side, stays, goes);
  for (const Part* part : {&stays, &goes})
    require(!part->points.empty() || !part->shapes.empty(), "split: the plane leaves all of ", describe(world, body),
            " on one side");
  return split_in_two(world, body, {stays, goes}, std::move(name));
}

namespace {

/// Positions in a hull, evenly spread: a tetrahedron by its volume, and a position in that.
class Inside {
 public:
  Inside(const Hull& hull, Random& random) : hull_(hull), random_(random) {
    for (const Hull::Face& face : hull.faces)
      for (std::uint32_t i = 1; i + 1 < face.count; i++) {
        const Vec3 a = corner(face, 0), b = corner(face, i), c = corner(face, i + 1);
        sum_ += dot(a - apex(), cross(b - apex(), c - apex()));
        list_.push_back({{a, b, c}, sum_});
      }
  }
  Vec3 position() {
    const double wanted = random_.uniform() * sum_;
    const auto at = std::find_if(list_.begin(), list_.end() - 1, [&](const Tetrahedron& t) { return t.upto > wanted; });
    std::array<double, 3> u{};
    for (double& x : u) x = random_.uniform();
    std::sort(u.begin(), u.end());
    return apex() * u[0] + at->corner[0] * (u[1] - u[0]) + at->corner[1] * (u[2] - u[1]) + at->corner[2] * (1.0 - u[2]);
  }

 private:
  struct Tetrahedron {
    std::array<Vec3, 3> corner;
    double upto;  // [m³] six times the volume of all up to it
  };
  Vec3 apex() const { return hull_.vertices[0]; }
  Vec3 corner(const Hull::Face& face, std::uint32_t i) const { return hull_.vertices[hull_.loops[face.first + i]]; }

  const Hull& hull_;
  Random& random_;
  std::vector<Tetrahedron> list_;
  double sum_ = 0.0;
};

/// The position in a hull that is nearest to one [m].
Vec3 nearest_in(const std::shared_ptr<const Hull>& hull, Vec3 at) {
  const double tiny = 1e-9 * hull->thickness;
  const Separation s = separation(hull, {}, BallShape{tiny}, {at});
  return s.distance > 0.0 ? s.on_a : at;
}

/// A shape to be broken, in its own axes.
struct Broken {
  ShapeId id;
  Pose pose;  ///< in the world
  std::shared_ptr<const Hull> hull;
  std::size_t pieces = 1;
  double volume;  ///< [m³]
  double denser;  ///< by which its pieces are
};

std::vector<Broken> shapes_to_break(const World& world, BodyId body) {
  std::vector<Broken> list;
  const std::vector<ShapeId>& shapes = world.bodies[body].shapes;
  for (std::size_t i = 0; i < shapes.size(); i++) {
    const Shape& shape = world.shapes[shapes[i]];
    if (shape.sensor) continue;
    const auto hull = polyhedron_of(shape.geometry);
    list.push_back(
        {shapes[i], pose_of(world, shape), hull, 1, solid_mass(hull).volume, denser_of(shape.geometry, hull)});
  }
  require(!list.empty(), "shatter: ", describe(world, body),
          " has no shape that could break into pieces; without `pieces` its points become particles");
  return list;
}

/// Each shape has one piece at least, more by its volume.
void share_pieces(std::vector<Broken>& shapes, std::size_t pieces) {
  for (std::size_t n = shapes.size(); n < pieces; n++) {
    const auto per_piece = [](const Broken& s) { return s.volume / static_cast<double>(s.pieces); };
    std::max_element(shapes.begin(), shapes.end(), [&](const Broken& a, const Broken& b) {
      return per_piece(a) < per_piece(b);
    })->pieces++;
  }
}

std::vector<Vec3> sites_in(const World& world, const Broken& shape, const ShatterDef& def, Random& random) {
  Inside inside(*shape.hull, random);
  const Vec3 middle = solid_mass(shape.hull).centre;
  std::vector<Vec3> sites;
  for (std::size_t i = 0; i < shape.pieces; i++) {
    Vec3 site = inside.position();
    if (def.at) {
      const Vec3 near = nearest_in(shape.hull, shape.pose.to_local(world.plane.beside(*def.at, shape.pose.x)));
      site = near + (site - near) * random.uniform();
    }
    const Vec3 flat = world.plane.beside(shape.pose.to_world(site), shape.pose.to_world(middle));
    sites.push_back(shape.pose.to_local(flat));
  }
  return sites;
}

/// How far a position is outside of a hull, below 0 in it [m]; outside only a bound.
double outside(const Hull& hull, Vec3 at) {
  double most = -infinity;
  for (const Hull::Face& face : hull.faces) most = std::max(most, dot(face.normal, at) - face.offset);
  return most;
}

}  // namespace

std::vector<BodyId> shatter(World& world, BodyId body, const ShatterDef& def) {
  require_unlocked(world, "shatter");
  require(world.bodies.alive(body), "shatter: ", world.bodies.story(body));
  require(def.pieces >= 2 && def.pieces <= 1000, "shatter: pieces must be from 2 to 1000, got ", def.pieces);
  if (def.at) require_finite("shatter", "at", *def.at, "m");
  std::vector<Broken> shapes = shapes_to_break(world, body);
  require(def.pieces >= shapes.size(), "shatter: ", describe(world, body), " has ", shapes.size(),
          " shapes, so there must be as many pieces, got ", def.pieces);
  require(world.bodies[body].own_mass > 0.0, "shatter: the mass of ", describe(world, body),
          " is that of its points alone, so a piece without one would have none");
  require_filled(world, body, "shatter");
  share_pieces(shapes, def.pieces);
  Random random{def.seed, 0};
  std::vector<Part> parts;
  std::vector<Pose> poses;
  for (const Broken& shape : shapes)
    for (const auto& cell : voronoi_cells(shape.hull, sites_in(world, shape, def, random))) {
      if (!cell) continue;
      parts.push_back({text("piece ", parts.size() + 1), {}, {piece_of(shape.id, *cell, shape.denser)}});
      poses.push_back(shape.pose);
    }
  Interruptible loop;
  for (PointId p : world.bodies[body].points) {
    std::pair<double, std::size_t> nearest{infinity, 0};
    for (std::size_t i = 0; i < parts.size(); i++) {
      const PartShape& shape = parts[i].shapes[0];
      const Vec3 at = world.plane.beside(position(world, p), poses[i].x);
      const auto& hull = std::get<std::shared_ptr<const Hull>>(*shape.piece);
      loop.count(hull->faces.size());
      nearest = std::min(nearest, {outside(*hull, poses[i].to_local(at) - shape.at), i});
    }
    parts[nearest.second].points.push_back(p);
  }
  return divide(world, body, parts, false, "shatter");
}

}  // namespace pantin
