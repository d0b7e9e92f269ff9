#include "edit/divide.hpp"

#include <algorithm>

#include "articulates/solve/state.hpp"
#include "contacts/find.hpp"
#include "model/cover.hpp"
#include "model/weigh.hpp"
#include "shapes/distance.hpp"
#include "shapes/mass.hpp"

namespace pantin::internal {

namespace {

std::vector<MassPoint> masses_of(const World& world, const std::vector<PointId>& points) {
  std::vector<MassPoint> masses;
  for (PointId p : points) masses.push_back({world.points[p].position, world.points[p].mass});
  return masses;
}

/// What weighs of some shapes of a body: sensors only where it has nothing else.
std::vector<Filled> filled(const World& world, BodyId body, const std::vector<PartShape>& shapes) {
  const std::vector<ShapeId>& all = world.bodies[body].shapes;
  const bool sensors = std::all_of(all.begin(), all.end(), [&](ShapeId s) { return world.shapes[s].sensor; });
  std::vector<Filled> list;
  for (const PartShape& part : shapes) {
    const Shape& s = world.shapes[part.of];
    if (s.sensor && !sensors) continue;
    const Vec3 at = s.at + rotate(s.orientation, part.at);
    list.push_back({part.piece.value_or(s.geometry), at, s.orientation, s.material.density * part.denser});
  }
  return list;
}

/// Own masses of the parts.
std::vector<OwnMass> own_masses(const World& world, BodyId body, const std::vector<Part>& parts) {
  const std::vector<ShapeId>& all = world.bodies[body].shapes;
  std::vector<OwnMass> list(parts.size());
  const bool first_has_all =
      parts[0].shapes.size() == all.size() && std::none_of(parts[0].shapes.begin(), parts[0].shapes.end(),
                                                           [](const PartShape& s) { return s.piece.has_value(); });
  if (first_has_all || !is_filled(world, body)) {
    list[0] = own_mass_of(world.bodies[body]);
    return list;
  }
  for (std::size_t i = 0; i < parts.size(); i++)
    if (const auto shapes = filled(world, body, parts[i].shapes); !shapes.empty()) list[i] = mass_of(shapes);
  return list;
}

/// Axes of hinges go with the points that the hinges hold.
void take_axes(World& world, BodyId body, BodyId fresh) {
  for (PointId p : world.bodies[fresh].points)
    for (ConstraintId id : world.particles[world.points[p].particle].axes) {
      Constraint& c = world.constraints[id];
      BodyId& end = c.body_a == body ? c.body_a : c.body_b;
      if (end != body) continue;
      end = fresh;
      std::erase(world.bodies[body].constraints, id);
      world.bodies[fresh].constraints.push_back(id);
    }
}

/// What ties the rotation of a body that becomes several, and which of them it will tie.
struct Tie {
  ConstraintId id;
  std::size_t part;
};

/// [m] from a part to a position of the world: from its shapes, where it has some; 0 within.
double distance_to_part(const World& world, const Part& part, Vec3 at) {
  double least = infinity;
  for (const PartShape& s : part.shapes) {
    const Shape& shape = world.shapes[s.of];
    const Geometry& geometry = s.piece ? *s.piece : shape.geometry;
    Pose pose = pose_of(world, shape);
    pose.x = pose.to_world(s.at);
    least = std::min(least, distance_to(geometry, pose, at));
  }
  for (PointId p : part.points) least = std::min(least, norm(position(world, p) - at));
  return least;
}

/// Whether a point of a part is hinged to a body.
bool is_hinged(const World& world, const Part& part, BodyId other) {
  return std::any_of(part.points.begin(), part.points.end(), [&](PointId p) {
    const std::vector<PointId>& ring = world.particles[world.points[p].particle].points;
    return std::any_of(ring.begin(), ring.end(), [&](PointId q) { return world.points[q].body == other; });
  });
}

/// A weld goes with the part at its position, what ties two bodies with the part that is hinged to the other one. Others stay
/// with the body, or end with it.
std::vector<Tie> ties_of(const World& world, BodyId body, const std::vector<Part>& parts) {
  std::vector<Tie> ties;
  for (ConstraintId id : world.bodies[body].constraints) {
    const Constraint& c = world.constraints[id];
    const bool is_a = c.body_a == body;
    const BodyId other = is_a ? c.body_b : c.body_a;
    if (c.ring() || !c.coupled().empty()) continue;
    if (c.is<WeldData>()) {
      const Vec3 arm = is_a ? c.as<WeldData>().arm_a : c.as<WeldData>().arm_b;
      const Vec3 at = origin(world, body) + rotate(orientation(world, body), arm);
      const auto nearest = std::min_element(parts.begin(), parts.end(), [&](const Part& a, const Part& b) {
        return distance_to_part(world, a, at) < distance_to_part(world, b, at);
      });
      ties.push_back({id, static_cast<std::size_t>(nearest - parts.begin())});
      continue;
    }
    if (!other) continue;
    for (std::size_t i = 0; i < parts.size(); i++)
      if (is_hinged(world, parts[i], other)) {
        ties.push_back({id, i});
        break;
      }
  }
  return ties;
}

void take_ties(World& world, BodyId body, BodyId fresh, const std::vector<Tie>& ties, std::size_t part) {
  for (const Tie& tie : ties) {
    if (tie.part != part) continue;
    Constraint& c = world.constraints[tie.id];
    (c.body_a == body ? c.body_a : c.body_b) = fresh;
    std::erase(world.bodies[body].constraints, tie.id);
    world.bodies[fresh].constraints.push_back(tie.id);
  }
}

/// A piece shows what of the picture the whole showed there.
std::shared_ptr<const Cover> moved_cover(Cover cover, Vec3 by) {
  cover.low += by;
  cover.high += by;
  return std::make_shared<const Cover>(std::move(cover));
}

/// Shapes of the body, or copies of them that are pieces.
void take_shapes(World& world, BodyId body, BodyId to, const std::vector<PartShape>& shapes) {
  for (const PartShape& part : shapes) {
    ShapeId id = part.of;
    if (part.piece) {
      Shape row = world.shapes[id];
      row.at += rotate(row.orientation, part.at);
      row.geometry = *part.piece;
      if (row.cover) row.cover = moved_cover(*row.cover, -part.at);
      world.bodies[to].sprite.reset();
      row.material.density *= part.denser;
      row.serial = world.next_serial++;
      id = world.shapes.add(std::move(row));
    } else if (to == body) {
      continue;
    } else {
      std::erase(world.bodies[body].shapes, id);
    }
    world.shapes[id].body = to;
    world.bodies[to].shapes.push_back(id);
  }
}

/// A part of a moving body on its own.
Motion part_of(const Weighed& w, const World& world, BodyId body, Vec3 spin) {
  const Motion& old = world.motion_of(body);
  const Quat frame = orientation(world, body);
  Motion m;
  m.mass = w.mass;
  m.inertia = w.moments;
  m.freedom = w.freedom;
  m.q = world.plane.about(normalised(frame * w.axes));
  m.x = origin(world, body) + rotate(frame, w.centre);
  m.p = (old.p / old.mass + cross(spin, m.x - old.x)) * m.mass;
  m.angular = m.inertia * turning_part(m, spin);
  return m;
}

/// Whether hulls take the place of something round.
bool has_facets(const std::vector<Part>& parts) {
  return std::any_of(parts.begin(), parts.end(), [](const Part& part) {
    return std::any_of(part.shapes.begin(), part.shapes.end(), [](const PartShape& s) { return s.denser != 1.0; });
  });
}

/// What the parts of a body miss of its angular momentum, because hulls in what is round have other moments, goes into all of
/// them as one spin about their common centre.
void share_spin(const Plane& plane, const Motion& whole, std::vector<Motion>& parts) {
  double mass = 0.0;
  Vec3 centre = zero3();
  for (const Motion& m : parts) mass += m.mass, centre += m.x * m.mass;
  centre = centre / mass;
  Vec3 missing = rotate(whole.q, whole.angular);
  Mat3 inertia = zero33();
  for (const Motion& m : parts) {
    const Vec3 d = m.x - centre;
    const Mat3 R = matrix(m.q);
    missing -= plane.about(cross(d, m.p)) + rotate(m.q, m.angular);
    inertia += (identity33() * norm2(d) - outer(d, d)) * m.mass + times_transposed(R * diagonal(m.inertia), R);
  }
  const int n = std::max(plane.normal, 0);
  const Vec3 spin = plane.flat() ? missing / inertia[n][n] : inverse(inertia) * missing;
  for (Motion& m : parts) {
    m.p += cross(spin, m.x - centre) * m.mass;
    m.angular += m.inertia * turning_part(m, spin);
  }
}

/// What the parts of a body miss of its angular momentum, because an inertia is lifted, goes into their spins, and what these
/// cannot take into their motion about each other. `arm` [m] is how far they are from the frame's origin.
void keep_momenta(const Plane& plane, const Motion& whole, const std::string& call, const std::string& who, double arm,
                  std::vector<Motion>& parts) {
  Motion &a = parts.front(), &b = parts.back();
  Vec3 others = zero3();
  for (std::size_t i = 1; i < parts.size(); i++) others += parts[i].p;
  a.p = whole.p - others;
  Vec3 missing = rotate(whole.q, whole.angular);
  double least = 1e-13 * norm(missing);
  for (const Motion& m : parts) {
    missing -= plane.about(cross(m.x - whole.x, m.p)) + rotate(m.q, m.angular);
    least += (1e-13 * norm(m.x - whole.x) + round_off * (norm(m.x) + arm)) * norm(m.p);
  }
  for (Motion& m : parts) {
    const Vec3 part = turning_part(m, missing);
    m.angular += part;
    missing -= rotate(m.q, part);
  }
  const Vec3 d = plane.along(a.x - b.x);
  if (norm2(d) > 0.0) {
    const Vec3 impulse = cross(missing, d) / norm2(d);
    a.p += impulse;
    b.p -= impulse;
    missing -= cross(d, impulse);
  }
  require(norm(missing) <= least, call, ": ", who, " spins about the line through its two parts, and these, of which ",
          "neither can turn about it, cannot carry its angular momentum");
}

}  // namespace

double distance_to(const Geometry& shape, const Pose& pose, Vec3 at) {
  const double tiny = 1e-9 * thickness_of(shape);
  return std::max(0.0, separation(shape, pose, BallShape{tiny}, {at}).distance + tiny);
}

PartShape piece_of(ShapeId of, const Hull& hull, double denser) {
  const Vec3 centre = solid_mass(std::make_shared<const Hull>(hull)).centre;
  return {of, moved(hull, -centre), centre, denser};
}

bool is_filled(const World& world, BodyId id) {
  constexpr double round = 1e-9;
  const Body& body = world.bodies[id];
  if (body.shapes.empty() || !(body.own_mass > 0.0)) return false;
  std::vector<PartShape> shapes;
  for (ShapeId s : body.shapes) shapes.push_back({s});
  const OwnMass sum = mass_of(filled(world, id, shapes));
  const double moment = trace(sum.inertia), size = std::sqrt(moment / sum.mass);
  for (int i = 0; i < 3; i++)
    if (largest(sum.inertia[i] - body.own_inertia[i]) > round * moment) return false;
  return std::fabs(sum.mass - body.own_mass) <= round * sum.mass &&
         norm(sum.position - body.own_position) <= round * (size + norm(sum.position));
}

std::vector<BodyId> divide(World& world, BodyId body, const std::vector<Part>& parts, bool keeps,
                           const std::string& call) {
  const Body& row = world.bodies[body];
  const Vec3 normal = normal_in(world, orientation(world, body)), spin = angular_velocity(world.motion_of(body));
  const std::vector<OwnMass> own = own_masses(world, body, parts);
  std::vector<Motion> motions;
  double arm = 0.0;
  for (std::size_t i = 0; i < parts.size(); i++) {
    const Weighed w =
        weigh(text(call, ": ", parts[i].called), masses_of(world, parts[i].points), own[i], row.axes, normal);
    arm = std::fmax(arm, norm(w.centre));
    motions.push_back(part_of(w, world, body, spin));
  }
  if (has_facets(parts)) share_spin(world.plane, world.motion_of(body), motions);
  keep_momenta(world.plane, world.motion_of(body), call, describe(world, body), arm, motions);

  const std::string who = describe(world, body);
  acted(world);
  disturb_sites(world);
  mark_edited(world, body);
  disturb(world, body);
  const double before = energy_of(world, body);
  const Vec3 at = origin(world, body);
  const Quat frame = orientation(world, body);
  const std::vector<ShapeId> shapes = row.shapes;
  const std::vector<Tie> ties = ties_of(world, body, parts);
  world.bodies[body].points.clear();
  std::vector<BodyId> bodies;
  for (std::size_t i = 0; i < parts.size(); i++) {
    const bool is_old = keeps && i == 0;
    bodies.push_back(is_old ? body : make_body(world, "", at, frame, parts[i].points));
    if (is_old) world.bodies[body].points = parts[i].points;
  }
  double after = 0.0;
  for (std::size_t i = 0; i < parts.size(); i++) {
    const BodyId id = bodies[i];
    if (id != body) take_axes(world, body, id);
    if (id != body) take_ties(world, body, id, ties, i);
    take_shapes(world, body, id, parts[i].shapes);
    Body& part = world.bodies[id];
    part.own_mass = own[i].mass;
    part.own_inertia = own[i].inertia;
    part.own_position = own[i].position;
  }
  for (ShapeId id : shapes) {
    const bool cut = std::none_of(parts.begin(), parts.end(), [&](const Part& part) {
      return std::any_of(part.shapes.begin(), part.shapes.end(),
                         [&](const PartShape& s) { return s.of == id && !s.piece; });
    });
    if (cut) erase_shape(world, id, culprit(world));
  }
  if (!keeps) {
    for (ConstraintId id : world.bodies[body].constraints)
      log_line(world, "notice", text(call, ": ", describe(world, id), " ended: none of the parts of ", who, " has it"));
    erase_body(world, body, culprit(world));
  }
  for (std::size_t i = 0; i < parts.size(); i++) {
    const BodyId id = bodies[i];
    update_mass(world, id);
    if (world.motion_of(id).freedom == Freedom::point) drop_rotations(world, id);
    set_momenta(world, id, motions[i].p, rotate(motions[i].q, motions[i].angular));
    if (id != body) mark_edited(world, id);
    after += energy_of(world, id);
  }
  world.places_changed = true;
  post(world, Source::edit, after - before);
  return bodies;
}

}  // namespace pantin::internal
