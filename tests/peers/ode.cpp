// Open Dynamics Engine: its direct solver (dWorldStep) and its iterative one (dWorldQuickStep).
#include <ode/ode.h>

#include "peers/peer.hpp"
#include "peers/piles.hpp"

namespace pantin::peers {

namespace {

class OdeRig : public Rig {
 public:
  OdeRig(const Mechanism& mechanism, double step, int iterations) : step_(step), iterations_(iterations) {
    static const int ready = dInitODE2(0);
    static_cast<void>(ready);
    world_ = dWorldCreate();
    dWorldSetGravity(world_, 0, -gravity, 0);
    dWorldSetERP(world_, 0.2);
    if (mechanism.walls.empty()) dWorldSetCFM(world_, 0);
    if (iterations > 0) dWorldSetQuickStepNumIterations(world_, iterations);
    for (const SolidDef& solid : mechanism.solids) add(solid);
    for (const BallJoint& joint : mechanism.joints) add(mechanism, joint);
    for (const Wall& w : mechanism.walls) dCreatePlane(space_, w.normal.x(), w.normal.y(), w.normal.z(), w.offset);
  }
  ~OdeRig() override {
    dJointGroupDestroy(touching_);
    dSpaceDestroy(space_);
    dWorldDestroy(world_);
  }

  void step() override {
    if (dSpaceGetNumGeoms(space_) > 0) find_contacts();
    if (iterations_ > 0)
      dWorldQuickStep(world_, step_);
    else
      dWorldStep(world_, step_);
  }

  void read(std::vector<SolidState>& state) override {
    state.resize(bodies_.size());
    for (std::size_t i = 0; i < bodies_.size(); i++) {
      const dReal* q = dBodyGetQuaternion(bodies_[i]);
      state[i].position = vector(dBodyGetPosition(bodies_[i]));
      state[i].turn = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized();
      state[i].velocity = vector(dBodyGetLinearVel(bodies_[i]));
      state[i].spin = vector(dBodyGetAngularVel(bodies_[i]));
    }
  }

  std::size_t contacts() const override { return contacts_; }

 private:
  static Eigen::Vector3d vector(const dReal* v) { return {v[0], v[1], v[2]}; }

  void add(const SolidDef& solid) {
    const dBodyID body = dBodyCreate(world_);
    dMass mass;
    dMassSetParameters(&mass, solid.mass, 0, 0, 0, solid.moments.x(), solid.moments.y(), solid.moments.z(), 0, 0, 0);
    dBodySetMass(body, &mass);
    dBodySetPosition(body, solid.at.x(), solid.at.y(), solid.at.z());
    const Eigen::Quaterniond q = solid.turn;
    const dQuaternion turn = {q.w(), q.x(), q.y(), q.z()};
    dBodySetQuaternion(body, turn);
    dBodySetFiniteRotationMode(body, 1);
    dBodySetMaxAngularSpeed(body, dInfinity);
    if (const dGeomID shape = shape_of(solid)) dGeomSetBody(shape, body);
    bodies_.push_back(body);
  }

  dGeomID shape_of(const SolidDef& solid) const {
    const Eigen::Vector3d& s = solid.size;
    switch (solid.form) {
      case Form::none: return nullptr;
      case Form::ball: return dCreateSphere(space_, s.x());
      case Form::box: return dCreateBox(space_, 2 * s.x(), 2 * s.y(), 2 * s.z());
      case Form::capsule: return dCreateCapsule(space_, s.x(), 2 * s.z());
    }
    return nullptr;
  }

  void find_contacts() {
    dJointGroupEmpty(touching_);
    contacts_ = 0;
    dSpaceCollide(space_, this, [](void* self, dGeomID a, dGeomID b) { static_cast<OdeRig*>(self)->meet(a, b); });
  }

  void meet(dGeomID a, dGeomID b) {
    const dBodyID first = dGeomGetBody(a), second = dGeomGetBody(b);
    if (first && second && dAreConnectedExcluding(first, second, dJointTypeContact)) return;
    constexpr int most = 8;
    dContact found[most] = {};
    const int count = dCollide(a, b, most, &found[0].geom, sizeof(dContact));
    for (int i = 0; i < count; i++) {
      found[i].surface.mode = dContactApprox1;
      found[i].surface.mu = friction;
      dJointAttach(dJointCreateContact(world_, touching_, &found[i]), first, second);
    }
    contacts_ += static_cast<std::size_t>(count);
  }

  void add(const Mechanism& mechanism, const BallJoint& joint) {
    const SolidDef& b = mechanism.solids[static_cast<std::size_t>(joint.b)];
    const Eigen::Vector3d at = b.at + b.turn * joint.at_b;
    const dJointID ball = dJointCreateBall(world_, nullptr);
    dJointAttach(ball, bodies_[static_cast<std::size_t>(joint.b)],
                 joint.a < 0 ? nullptr : bodies_[static_cast<std::size_t>(joint.a)]);
    dJointSetBallAnchor(ball, at.x(), at.y(), at.z());
  }

  double step_;
  int iterations_;
  dWorldID world_ = nullptr;
  dSpaceID space_ = dHashSpaceCreate(nullptr);
  dJointGroupID touching_ = dJointGroupCreate(0);
  std::size_t contacts_ = 0;
  std::vector<dBodyID> bodies_;
};

Setting ode(const char* name, int iterations) {
  return {name,
          [iterations](const Mechanism& m, double step) { return std::make_unique<OdeRig>(m, step, iterations); }};
}

}  // namespace

std::vector<Setting> settings() { return {ode("direct", 0), ode("50 iterations", 50)}; }

std::vector<Setting> pile_settings() {
  Setting direct = ode("direct", 0);
  direct.can = [](const Mechanism& pile) { return pile.solids.size() <= 30; };  // its time grows with the cube
  return {ode("20 iterations", 20), direct};
}

}  // namespace pantin::peers
