// Box2D 2.4, in the plane z = 0 and in single precision. What is a box or a capsule there has its outline here.
#include <box2d/box2d.h>

#include "peers/peer.hpp"
#include "peers/piles.hpp"

namespace pantin::peers {

namespace {

float single(double x) { return static_cast<float>(x); }
double wide(float x) { return static_cast<double>(x); }
b2Vec2 flat(const Eigen::Vector3d& v) { return {single(v.x()), single(v.y())}; }

class FlatRig : public Rig {
 public:
  FlatRig(const Mechanism& pile, double step) : pile_(pile), step_(single(step)) {
    world_.SetAllowSleeping(false);
    for (const SolidDef& solid : pile.solids) add(solid);
    for (const BallJoint& joint : pile.joints) add(joint);
    for (const Wall& wall : pile.walls) add(wall);
  }

  void step() override { world_.Step(step_, 8, 3); }  // as its manual says

  void read(std::vector<SolidState>& state) override {
    state.resize(bodies_.size());
    for (std::size_t i = 0; i < bodies_.size(); i++) {
      const b2Body& body = *bodies_[i];
      const b2Vec2 x = body.GetPosition(), v = body.GetLinearVelocity();
      const Eigen::Quaterniond turned(Eigen::AngleAxisd(wide(body.GetAngle()), Eigen::Vector3d::UnitZ()));
      state[i] = {{wide(x.x), wide(x.y), 0.0},
                  turned * pile_.solids[i].turn,
                  {wide(v.x), wide(v.y), 0.0},
                  {0.0, 0.0, wide(body.GetAngularVelocity())}};
    }
  }

  std::size_t contacts() const override {
    std::size_t count = 0;
    for (const b2Contact* c = world_.GetContactList(); c; c = c->GetNext())
      if (c->IsTouching()) count += static_cast<std::size_t>(c->GetManifold()->pointCount);
    return count;
  }

 private:
  void add(const SolidDef& solid) {
    b2BodyDef def;
    def.type = b2_dynamicBody;
    def.position = flat(solid.at);
    b2Body& body = *world_.CreateBody(&def);
    const Eigen::Vector3d& s = solid.size;
    if (solid.form == Form::box) {
      add_outline(body, solid.turn * Eigen::Vector3d(s.x(), 0, 0), solid.turn * Eigen::Vector3d(0, s.y(), 0));
    } else if (solid.form == Form::ball) {
      add_circle(body, s.x(), {0, 0, 0});
    } else {
      const Eigen::Vector3d along = solid.turn * Eigen::Vector3d(0, 0, s.z());
      add_circle(body, s.x(), along);
      add_circle(body, s.x(), -along);
      add_outline(body, along, s.x() * Eigen::Vector3d::UnitZ().cross(along).normalized());
    }
    const Eigen::Vector3d axis = solid.turn.conjugate() * Eigen::Vector3d::UnitZ();
    b2MassData mass;
    mass.mass = single(solid.mass);
    mass.center.SetZero();
    mass.I = single(axis.dot(solid.moments.cwiseProduct(axis)));
    body.SetMassData(&mass);
    bodies_.push_back(&body);
  }

  /// A parallelogram about the centre, from there to the middles of two of its edges.
  static void add_outline(b2Body& body, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const b2Vec2 corners[] = {flat(a + b), flat(b - a), flat(-a - b), flat(a - b)};
    b2PolygonShape shape;
    shape.Set(corners, 4);
    add_shape(body, shape);
  }

  static void add_circle(b2Body& body, double radius, const Eigen::Vector3d& at) {
    b2CircleShape shape;
    shape.m_radius = single(radius);
    shape.m_p = flat(at);
    add_shape(body, shape);
  }

  static void add_shape(b2Body& body, const b2Shape& shape) {
    b2FixtureDef def;
    def.shape = &shape;
    def.density = 1.0f;
    def.friction = single(friction);
    body.CreateFixture(&def);
  }

  void add(const BallJoint& joint) {
    const auto i = static_cast<std::size_t>(joint.a), j = static_cast<std::size_t>(joint.b);
    const SolidDef& a = pile_.solids[i];
    b2RevoluteJointDef def;
    def.Initialize(bodies_[i], bodies_[j], flat(a.at + a.turn * joint.at_a));
    world_.CreateJoint(&def);
  }

  void add(const Wall& wall) {
    const Eigen::Vector3d middle = wall.offset * wall.normal,
                          along = 1000.0 * Eigen::Vector3d::UnitZ().cross(wall.normal);
    b2BodyDef none;
    b2EdgeShape edge;
    edge.SetTwoSided(flat(middle - along), flat(middle + along));
    add_shape(*world_.CreateBody(&none), edge);
  }

  const Mechanism& pile_;
  float step_;
  b2World world_{{0.0f, single(-gravity)}};
  std::vector<b2Body*> bodies_;
};

}  // namespace

std::vector<Setting> settings() { return {}; }

std::vector<Setting> pile_settings() {
  Setting setting;
  setting.name = "8 and 3 iterations";
  setting.make = [](const Mechanism& pile, double step) { return std::make_unique<FlatRig>(pile, step); };
  setting.in_plane = true;
  return {setting};
}

}  // namespace pantin::peers
