// Open Dynamics Engine: its direct solver (dWorldStep) and its iterative one (dWorldQuickStep).
#include <ode/ode.h>

#include "peers/peer.hpp"

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
    dWorldSetCFM(world_, 0);
    if (iterations > 0) dWorldSetQuickStepNumIterations(world_, iterations);
    for (const SolidDef& solid : mechanism.solids) add(solid);
    for (const BallJoint& joint : mechanism.joints) add(mechanism, joint);
  }
  ~OdeRig() override { dWorldDestroy(world_); }

  void step() override {
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

 private:
  static Eigen::Vector3d vector(const dReal* v) { return {v[0], v[1], v[2]}; }

  void add(const SolidDef& solid) {
    const dBodyID body = dBodyCreate(world_);
    dMass mass;
    dMassSetParameters(&mass, solid.mass, 0, 0, 0, solid.moments.x(), solid.moments.y(), solid.moments.z(), 0, 0, 0);
    dBodySetMass(body, &mass);
    dBodySetPosition(body, solid.at.x(), solid.at.y(), solid.at.z());
    const Eigen::Quaterniond q = solid.orientation();
    const dQuaternion turn = {q.w(), q.x(), q.y(), q.z()};
    dBodySetQuaternion(body, turn);
    dBodySetFiniteRotationMode(body, 1);
    dBodySetMaxAngularSpeed(body, dInfinity);
    bodies_.push_back(body);
  }

  void add(const Mechanism& mechanism, const BallJoint& joint) {
    const SolidDef& b = mechanism.solids[static_cast<std::size_t>(joint.b)];
    const Eigen::Vector3d at = b.at + b.orientation() * joint.at_b;
    const dJointID ball = dJointCreateBall(world_, nullptr);
    dJointAttach(ball, bodies_[static_cast<std::size_t>(joint.b)],
                 joint.a < 0 ? nullptr : bodies_[static_cast<std::size_t>(joint.a)]);
    dJointSetBallAnchor(ball, at.x(), at.y(), at.z());
  }

  double step_;
  int iterations_;
  dWorldID world_ = nullptr;
  std::vector<dBodyID> bodies_;
};

Setting ode(const char* name, int iterations) {
  return {name,
          [iterations](const Mechanism& m, double step) { return std::make_unique<OdeRig>(m, step, iterations); }};
}

}  // namespace

std::vector<Setting> settings() { return {ode("direct", 0), ode("50 iterations", 50)}; }

}  // namespace pantin::peers
