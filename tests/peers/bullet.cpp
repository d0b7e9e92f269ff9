// Bullet in double precision: rigid bodies with sequential impulses, and its multi-body in reduced coordinates.
#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>
#include <BulletDynamics/Featherstone/btMultiBodyPoint2Point.h>
#include <btBulletDynamicsCommon.h>

#include "peers/peer.hpp"
#include "peers/piles.hpp"

namespace pantin::peers {

namespace {

btVector3 bullet(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
btQuaternion bullet(const Eigen::Quaterniond& q) { return {q.x(), q.y(), q.z(), q.w()}; }
Eigen::Vector3d vector(const btVector3& v) { return {v.x(), v.y(), v.z()}; }
Eigen::Quaterniond turn(const btQuaternion& q) { return Eigen::Quaterniond(q.w(), q.x(), q.y(), q.z()).normalized(); }

void set_up(btDynamicsWorld& world, int iterations) {
  world.setGravity(btVector3(0, -gravity, 0));
  btContactSolverInfo& info = world.getSolverInfo();
  info.m_numIterations = iterations;
  info.m_globalCfm = 0;
  info.m_damping = 1;
  info.m_leastSquaresResidualThreshold = 0;
  info.m_maxGyroscopicForce = 1e30;
  info.m_warmstartingFactor = 0.85;
}

class RigidRig : public Rig {
 public:
  RigidRig(const Mechanism& mechanism, double step, int iterations)
      : step_(step), dispatcher_(&configuration_), world_(&dispatcher_, &broadphase_, &solver_, &configuration_) {
    set_up(world_, iterations);
    for (const SolidDef& solid : mechanism.solids) add(solid);
    for (const BallJoint& joint : mechanism.joints) add(joint);
    for (const Wall& wall : mechanism.walls) add(wall);
  }
  ~RigidRig() override {
    for (const auto& joint : joints_) world_.removeConstraint(joint.get());
    for (const auto& body : bodies_) world_.removeRigidBody(body.get());
    for (const auto& wall : walls_) world_.removeRigidBody(wall.get());
  }

  void step() override { world_.stepSimulation(step_, 0); }

  void read(std::vector<SolidState>& state) override {
    state.resize(bodies_.size());
    for (std::size_t i = 0; i < bodies_.size(); i++) {
      const btTransform& pose = bodies_[i]->getWorldTransform();
      state[i] = {vector(pose.getOrigin()), turn(pose.getRotation()), vector(bodies_[i]->getLinearVelocity()),
                  vector(bodies_[i]->getAngularVelocity())};
    }
  }

  std::size_t contacts() const override {
    std::size_t count = 0;
    for (int i = 0; i < dispatcher_.getNumManifolds(); i++)
      count += static_cast<std::size_t>(dispatcher_.getManifoldByIndexInternal(i)->getNumContacts());
    return count;
  }

 private:
  btCollisionShape* shape_of(const SolidDef& solid) {
    if (solid.form == Form::none) return &shape_;
    if (solid.form == Form::ball)
      shapes_.push_back(std::make_unique<btSphereShape>(solid.size.x()));
    else if (solid.form == Form::box)
      shapes_.push_back(std::make_unique<btBoxShape>(bullet(solid.size)));
    else
      shapes_.push_back(std::make_unique<btCapsuleShapeZ>(solid.size.x(), 2 * solid.size.z()));
    return shapes_.back().get();
  }

  void add(const SolidDef& solid) {
    btRigidBody::btRigidBodyConstructionInfo info(solid.mass, nullptr, shape_of(solid), bullet(solid.moments));
    info.m_friction = std::sqrt(friction);  // of two it takes the product
    info.m_startWorldTransform = btTransform(bullet(solid.turn), bullet(solid.at));
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    btRigidBody& body = *bodies_.back();
    body.setActivationState(DISABLE_DEACTIVATION);
    body.setFlags(BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY);
    if (solid.form == Form::none)
      world_.addRigidBody(&body, 0, 0);
    else
      world_.addRigidBody(&body);
  }

  void add(const Wall& wall) {
    shapes_.push_back(std::make_unique<btStaticPlaneShape>(bullet(wall.normal), wall.offset));
    btRigidBody::btRigidBodyConstructionInfo info(0, nullptr, shapes_.back().get());
    info.m_friction = std::sqrt(friction);
    walls_.push_back(std::make_unique<btRigidBody>(info));
    world_.addRigidBody(walls_.back().get());
  }

  void add(const BallJoint& joint) {
    btRigidBody& b = *bodies_[static_cast<std::size_t>(joint.b)];
    if (joint.a < 0)
      joints_.push_back(std::make_unique<btPoint2PointConstraint>(b, bullet(joint.at_b)));
    else
      joints_.push_back(std::make_unique<btPoint2PointConstraint>(*bodies_[static_cast<std::size_t>(joint.a)], b,
                                                                  bullet(joint.at_a), bullet(joint.at_b)));
    world_.addConstraint(joints_.back().get(), true);
  }

  double step_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_;
  btSphereShape shape_{0.01};
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_, walls_;
  std::vector<std::unique_ptr<btTypedConstraint>> joints_;
};

class MultiRig : public Rig {
 public:
  MultiRig(const Mechanism& mechanism, double step, bool runge_kutta)
      : step_(step),
        dispatcher_(&configuration_),
        world_(&dispatcher_, &broadphase_, &solver_, &configuration_),
        bodies_(static_cast<int>(mechanism.solids.size()), 0, btVector3(0, 0, 0), true, false) {
    set_up(world_, 50);
    bodies_.setBasePos(btVector3(0, 0, 0));
    bodies_.setWorldToBaseRot(btQuaternion(0, 0, 0, 1));
    for (const BallJoint& joint : mechanism.joints)
      if (!joint.closes_loop) add_link(mechanism, joint);
    bodies_.finalizeMultiDof();
    bodies_.setLinearDamping(0);
    bodies_.setAngularDamping(0);
    bodies_.setUseGyroTerm(true);
    bodies_.setCanSleep(false);
    bodies_.setMaxCoordinateVelocity(1e30);
    bodies_.setMaxAppliedImpulse(1e30);
    bodies_.setHasSelfCollision(false);
    bodies_.useRK4Integration(runge_kutta);
    bodies_.useGlobalVelocities(false);
    for (const BallJoint& joint : mechanism.joints)
      if (!joint.closes_loop) turn_link(mechanism, joint);
    world_.addMultiBody(&bodies_, 0, 0);
    for (const BallJoint& joint : mechanism.joints)
      if (joint.closes_loop) close_loop(joint);
    bodies_.forwardKinematics(rotations_, positions_);
    bodies_.updateCollisionObjectWorldTransforms(rotations_, positions_);
  }
  ~MultiRig() override {
    if (loop_) world_.removeMultiBodyConstraint(loop_.get());
    for (const auto& collider : colliders_) world_.removeCollisionObject(collider.get());
    world_.removeMultiBody(&bodies_);
  }

  void step() override { world_.stepSimulation(step_, 0); }

  void read(std::vector<SolidState>& state) override {
    const int n = bodies_.getNumLinks();
    bodies_.forwardKinematics(rotations_, positions_);
    spins_.resize(n + 1);
    velocities_.resize(n + 1);
    bodies_.compTreeLinkVelocities(&spins_[0], &velocities_[0]);
    state.resize(static_cast<std::size_t>(n));
    for (int i = 0; i < n; i++) {
      const btTransform& pose = bodies_.getLink(i).m_cachedWorldTransform;
      state[static_cast<std::size_t>(i)] = {vector(pose.getOrigin()), turn(pose.getRotation()),
                                            vector(pose.getBasis() * velocities_[i + 1]),
                                            vector(pose.getBasis() * spins_[i + 1])};
    }
  }

 private:
  void add_link(const Mechanism& mechanism, const BallJoint& joint) {
    const SolidDef& solid = mechanism.solids[static_cast<std::size_t>(joint.b)];
    bodies_.setupSpherical(joint.b, solid.mass, bullet(solid.moments), joint.a, btQuaternion(0, 0, 0, 1),
                           bullet(joint.at_a), bullet(Eigen::Vector3d(-joint.at_b)), true);
  }

  void turn_link(const Mechanism& mechanism, const BallJoint& joint) {
    const auto orientation = [&](int i) {
      return i < 0 ? Eigen::Quaterniond::Identity() : mechanism.solids[static_cast<std::size_t>(i)].turn;
    };
    const Eigen::Quaterniond q = orientation(joint.a).conjugate() * orientation(joint.b);
    const double coordinates[4] = {q.x(), q.y(), q.z(), q.w()};
    bodies_.setJointPosMultiDof(joint.b, coordinates);
  }

  /// Without colliders Bullet makes no island of the links, and leaves their constraints out.
  void close_loop(const BallJoint& joint) {
    for (int i = -1; i < bodies_.getNumLinks(); i++) {
      colliders_.push_back(std::make_unique<btMultiBodyLinkCollider>(&bodies_, i));
      btMultiBodyLinkCollider& collider = *colliders_.back();
      collider.setCollisionShape(&shape_);
      collider.setActivationState(DISABLE_DEACTIVATION);
      world_.addCollisionObject(&collider, 0, 0);
      if (i < 0)
        bodies_.setBaseCollider(&collider);
      else
        bodies_.getLink(i).m_collider = &collider;
    }
    loop_ = std::make_unique<btMultiBodyPoint2Point>(&bodies_, joint.a, &bodies_, joint.b, bullet(joint.at_a),
                                                     bullet(joint.at_b));
    loop_->setMaxAppliedImpulse(1e30);
    world_.addMultiBodyConstraint(loop_.get());
    loop_->finalizeMultiDof();
  }

  double step_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btMultiBodyConstraintSolver solver_;
  btMultiBodyDynamicsWorld world_;
  btSphereShape shape_{0.01};
  btMultiBody bodies_;
  std::vector<std::unique_ptr<btMultiBodyLinkCollider>> colliders_;
  std::unique_ptr<btMultiBodyConstraint> loop_;
  btAlignedObjectArray<btQuaternion> rotations_;
  btAlignedObjectArray<btVector3> positions_, spins_, velocities_;
};

Setting rigid(const char* name, int iterations) {
  return {name,
          [iterations](const Mechanism& m, double step) { return std::make_unique<RigidRig>(m, step, iterations); }};
}

Setting multi(const char* name, bool runge_kutta) {
  return {name,
          [runge_kutta](const Mechanism& m, double step) { return std::make_unique<MultiRig>(m, step, runge_kutta); }};
}

}  // namespace

std::vector<Setting> settings() {
  return {rigid("10 iterations", 10), rigid("50 iterations", 50), multi("multibody", false),
          multi("multibody RK4", true)};
}

std::vector<Setting> pile_settings() { return {rigid("10 iterations", 10), rigid("100 iterations", 100)}; }

}  // namespace pantin::peers
