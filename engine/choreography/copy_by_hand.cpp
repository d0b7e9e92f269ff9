#include "choreography/copy_by_hand.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "base/bounds.hpp"
#include "base/shortened.hpp"
#include "edit/common.hpp"
#include "edit/constrain.hpp"
#include "measure/query.hpp"
#include "measure/reach.hpp"
#include "model/cover.hpp"
#include "shapes/hull.hpp"
#include "shapes/mass.hpp"

namespace pantin {

using namespace internal;

namespace {

/// Takes places, directions and turns of the world to where the copy has them.
class Image {
 public:
  Image(Vec3 from, Vec3 to, Vec3 mirror) : from_(from), to_(to), mirrored_(norm2(mirror) > 0.0) {
    if (mirrored_) normal_ = direction(mirror);
  }
  bool mirrored() const { return mirrored_; }
  Vec3 along(Vec3 v) const { return mirrored_ ? v - normal_ * (2.0 * dot(v, normal_)) : v; }
  /// Of an axis or a spin.
  Vec3 about(Vec3 v) const { return mirrored_ ? along(v) * -1.0 : v; }
  Vec3 place(Vec3 at) const {
    const Vec3 there = to_ + along(at - from_);
    return shortened(there, std::fmax(largest(there), largest(at)));
  }
  Quat turn(const Quat& q) const {
    const Quat half{0.0, normal_[0], normal_[1], normal_[2]};
    return mirrored_ ? normalised(half * q * conjugate(half)) : q;
  }
  Mat3 inertia(const Mat3& m) const {
    Mat3 out;
    for (int i = 0; i < 3; i++) {
      Vec3 unit = zero3();
      unit[i] = 1.0;
      out[i] = along(m * along(unit));
    }
    return out;
  }

 private:
  Vec3 from_, to_, normal_ = zero3();
  bool mirrored_;
};

class Copying {
 public:
  Copying(World& world, const Image& image) : world_(world), image_(image) {}

  /// All of them, or none.
  void copy(const Things& things) {
    try {
      for (const BodyId id : things.bodies) copy_body(id);
      for (const PointId id : things.free_points) copy_particle(id);
      copy_hinges();
      copy_constraints();
      copy_connections();
    } catch (const Error&) {
      for (const BodyId id : bodies_made_) remove(world_, id);
      for (const ParticleId id : particles_made_) remove(world_, id);
      throw;
    }
  }

 private:
  void copy_family(const Particle& particle, FamilyId& family, std::vector<AttributeDef>& attributes) const {
    family = particle.family;
    if (!family) return;
    const auto& names = world_.families[family].attributes;
    for (std::size_t i = 0; i < names.size(); i++) attributes.push_back({names[i].name, particle.values[i]});
  }

  void copy_body(BodyId id) {
    const Body row = world_.bodies[id];
    const Motion motion = world_.motion_of(id);
    BodyDef def;
    def.orientation = image_.turn(orientation(world_, id));
    def.at = image_.place(origin(world_, id));
    def.velocity = image_.along(motion.p / motion.mass);
    def.spin = image_.about(angular_velocity(motion));
    if (!fills(row)) def.mass = row.own_mass;
    def.inertia = image_.inertia(row.own_inertia);
    def.sprite = row.sprite;
    for (const PointId point : row.points) {
      const Point& of = world_.points[point];
      PointDef& made = def.points.emplace_back();
      made.at = image_.along(of.position);
      made.mass = of.mass;
      made.radius = of.radius;
      made.color = of.color;
      made.name = of.name;
      copy_family(world_.particles[of.own], made.family, made.attributes);
    }
    for (const ShapeId shape : row.shapes) def.shapes.push_back(shape_of(world_.shapes[shape]));
    const BodyId made = add_body(world_, def);
    bodies_made_.push_back(made);
    bodies_[id] = made;
    for (std::size_t i = 0; i < row.points.size(); i++) points_[row.points[i]] = world_.bodies[made].points[i];
  }

  /// Whether its own mass is that of its shapes by their density, so that none is to be given.
  bool fills(const Body& body) const {
    double filled = 0.0;
    for (const ShapeId id : body.shapes) {
      const Shape& shape = world_.shapes[id];
      if (!shape.sensor) filled += shape.material.density * solid_mass(shape.geometry).volume;
    }
    const bool weighed =
        std::ranges::any_of(body.points, [&](PointId point) { return world_.points[point].mass > 0.0; });
    return !weighed && std::fabs(filled - body.own_mass) <= 1e-12 * filled;
  }

  std::shared_ptr<const Cover> cover_of(Cover cover) const {
    Bounds box;
    box.add(image_.along(cover.low));
    box.add(image_.along(cover.high));
    cover.low = box.low;
    cover.high = box.high;
    return std::make_shared<const Cover>(std::move(cover));
  }

  ShapeDef shape_of(const Shape& of) const {
    ShapeDef def;
    def.geometry = of.geometry;
    if (const auto* hull = std::get_if<std::shared_ptr<const Hull>>(&of.geometry); hull && image_.mirrored()) {
      std::vector<Vec3> vertices;
      for (const Vec3 at : (*hull)->vertices) vertices.push_back(image_.along(at));
      def.geometry = make_hull(vertices);
    }
    def.at = image_.along(of.at);
    def.orientation = image_.turn(of.orientation);
    def.material = of.material;
    def.material.surface_velocity = image_.along(of.material.surface_velocity);
    def.layer = of.layer > 0 ? world_.layers.names[of.layer - 1] : "";
    def.sensor = of.sensor;
    def.color = of.color;
    if (of.cover) def.cover = cover_of(*of.cover);
    return def;
  }

  void copy_particle(PointId id) {
    const Point of = world_.points[id];
    const FreeMotion motion = world_.motion_of(id);
    ParticleDef def;
    def.at = image_.place(motion.x);
    def.velocity = image_.along(motion.v);
    def.mass = of.mass;
    def.radius = of.radius;
    def.color = of.color;
    def.look = world_.particles[of.own].look;
    copy_family(world_.particles[of.own], def.family, def.attributes);
    const ParticleId made = add_particle(world_, def);
    particles_made_.push_back(made);
    points_[id] = world_.particles[made].points[0];
  }

  std::optional<Vec3> axis_between(const Particle& ring, BodyId a, BodyId b) const {
    for (const ConstraintId id : ring.axes) {
      const Constraint& c = world_.constraints[id];
      if ((c.body_a == a && c.body_b == b) || (c.body_a == b && c.body_b == a))
        return image_.about(rotate(orientation(world_, c.body_a), c.axis_a));
    }
    return {};
  }

  void copy_hinges() {
    for (const ParticleId id : hinges(world_)) {
      const Particle ring = world_.particles[id];
      if (!points_.contains(ring.points[0])) continue;
      for (std::size_t i = 1; i < ring.points.size(); i++) {
        HingeDef def;
        def.collide = ring.collide;
        std::size_t with = 0;
        const BodyId mine = world_.points[ring.points[i]].body;
        for (std::size_t k = 0; k < i && !def.axis; k++) {
          const BodyId other = world_.points[ring.points[k]].body;
          if (mine && other) def.axis = axis_between(ring, other, mine);
          if (def.axis) with = k;
        }
        const std::array pair = {points_.at(ring.points[with]), points_.at(ring.points[i])};
        add_hinge(world_, pair, def);
      }
    }
  }

  void copy_constraints() {
    for (const ConstraintId id : world_.constraints.ids()) {
      const Constraint c = world_.constraints[id];
      bool mine = !c.ring() && c.hand < 0, any = false;
      c.each_point([&](PointId p) { (points_.contains(p) ? any : mine) = points_.contains(p); });
      c.each_body([&](BodyId b) { (bodies_.contains(b) ? any : mine) = bodies_.contains(b); });
      if (mine && any) add_constraint(world_, image_of(id, c));
    }
  }

  PointId copy_of(PointId id) const { return id ? points_.at(id) : id; }
  BodyId copy_of(BodyId id) const { return id ? bodies_.at(id) : id; }

  Constraint image_of(ConstraintId id, Constraint c) const {
    require(!c.position.of_time && !c.number.of_time && !c.turn.of_time, "copy: ", describe(world_, id),
            " is led by a function");
    require(!c.is<PathData>(), "copy: ", describe(world_, id), " is on a path, which stays where it is");
    c.a = copy_of(c.a);
    c.b = copy_of(c.b);
    c.body_a = copy_of(c.body_a);
    c.body_b = copy_of(c.body_b);
    if (c.a && !c.b) c.position.now = image_.place(c.position.now);
    c.turn.now = image_.turn(c.turn.now);
    c.axis_a = image_.about(c.axis_a);
    c.axis_b = image_.about(c.axis_b);
    c.bend = {};
    c.force = c.torque = zero3();
    c.tension = 0.0;
    c.name.clear();
    if (c.is<WeldData>()) c.own = WeldData{image_.along(c.as<WeldData>().arm_a), image_.along(c.as<WeldData>().arm_b)};
    if (c.is<StringData>())
      for (Passage& p : c.as<StringData>().passages)
        p = p.point ? Passage{copy_of(p.point)} : Passage{PointId{}, image_.place(p.position)};
    if (c.is<CouplingData>())
      for (CoupledValue& v : c.as<CouplingData>().values) v = image_of(v);
    if (c.is<JoinData>()) c.own = JoinData{progress_of(id, *c.progress())};
    return c;
  }

  CoupledValue image_of(CoupledValue v) const {
    const bool turns = static_cast<bool>(v.body_a);
    if (!turns) v.position = v.body_b ? image_.along(v.position) : image_.place(v.position);
    v.point_a = copy_of(v.point_a);
    v.point_b = copy_of(v.point_b);
    v.body_a = copy_of(v.body_a);
    v.body_b = copy_of(v.body_b);
    v.axis_a = image_.about(v.axis_a);
    v.axis_b = turns ? image_.about(v.axis_b) : image_.along(v.axis_b);
    v.turn = image_.turn(v.turn);
    return v;
  }

  std::shared_ptr<JoinProgress> progress_of(ConstraintId id, const JoinProgress& of) const {
    require(!of.on_met && !of.holder, "copy: ", describe(world_, id), " is led by a script");
    auto progress = std::make_shared<JoinProgress>();
    progress->hinge_name = of.hinge_name;
    progress->hinge_axis = image_.about(of.hinge_axis);
    progress->label = of.label;
    return progress;
  }

  void copy_connections() {
    for (const ConnectionId id : world_.connections.ids()) {
      const Connection tie = world_.connections[id];
      ConnectionDef def;
      bool mine = false;
      for (std::uint32_t i = 0; i < tie.count; i++) {
        const ParticleId end = tie.particles[i] ? awake(world_, tie.particles[i]) : ParticleId{};
        const PointId point = end ? world_.particles[end].points[0] : PointId{};
        const auto copied = points_.find(point);
        mine = mine || copied != points_.end();
        def.ends.push_back(copied != points_.end() ? End{world_.points[copied->second].particle}
                                                   : End{ParticleId{}, end ? zero3() : image_.place(tie.positions[i])});
      }
      if (!mine) continue;
      def.parameters = tie.parameters;
      def.max_force = tie.max_force;
      def.max_length = tie.max_length;
      def.solve = tie.asked;
      add_connection(world_, tie.law, def);
    }
  }

  World& world_;
  const Image& image_;
  std::map<BodyId, BodyId> bodies_;
  std::map<PointId, PointId> points_;
  std::vector<BodyId> bodies_made_;
  std::vector<ParticleId> particles_made_;
};

/// The body that is meant, or the point; throws Error where it is gone.
AnyId thing_meant(const World& world, const Command& c) {
  if (const auto* body = std::get_if<BodyId>(&c.thing); body && !c.point) {
    require(world.bodies.alive(*body), name_of(c.kind), ": ", world.bodies.story(*body));
    return *body;
  }
  require(world.points.alive(c.point), name_of(c.kind), ": ", world.points.story(c.point));
  if (const BodyId body = world.points[c.point].body) return body;
  return c.point;
}

}  // namespace

Things whole_of(const World& world, const Command& c) {
  const AnyId meant = thing_meant(world, c);
  if (const auto* body = std::get_if<BodyId>(&meant)) return tied_to(world, *body, true);
  return tied_to(world, std::get<PointId>(meant), true);
}

void copy_by_hand(World& world, const Command& c) {
  require_finite("copy", "position", c.position, "m");
  require_finite("copy", "the mirror's normal", c.amount, "");
  const Things things = whole_of(world, c);
  const AnyId meant = thing_meant(world, c);
  const auto* body = std::get_if<BodyId>(&meant);
  const Vec3 from = body ? world.motion_of(*body).x : position(world, std::get<PointId>(meant));
  const Image image(from, world.plane.flat() ? world.plane.beside(c.position, from) : c.position, c.amount);
  Copying(world, image).copy(things);
}

void remove_whole(World& world, const Command& c) {
  const Things things = whole_of(world, c);
  for (const BodyId id : things.bodies) remove(world, id);
  for (const PointId id : things.free_points) remove(world, world.points[id].own);
}

}  // namespace pantin
