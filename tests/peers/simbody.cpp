// Simbody: reduced coordinates; integrators of fixed steps, and Runge-Kutta-Merson that keeps an accuracy.
#include <Simbody.h>

#include <cmath>
#include <stdexcept>

#include "peers/peer.hpp"

namespace pantin::peers {

namespace {

enum class Method { verlet, merson };

SimTK::Vec3 simtk(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
SimTK::Rotation simtk(const Eigen::Quaterniond& q) {
  return SimTK::Rotation(SimTK::Quaternion(q.w(), q.x(), q.y(), q.z()));
}
Eigen::Vector3d vector(const SimTK::Vec3& v) { return {v[0], v[1], v[2]}; }

class SimbodyRig : public Rig {
 public:
  /// `accuracy` 0: steps of a fixed length.
  SimbodyRig(const Mechanism& mechanism, double step, Method method, double accuracy)
      : step_(step), accuracy_(accuracy), matter_(system_), forces_(system_), bodies_(mechanism.solids.size()) {
    system_.setUseUniformBackground(true);
    SimTK::Force::Gravity(forces_, matter_, -SimTK::YAxis, gravity);
    for (const BallJoint& joint : mechanism.joints) add(mechanism, joint);
    SimTK::State state = system_.realizeTopology();
    for (const BallJoint& joint : mechanism.joints)
      if (!joint.closes_loop)
        body(joint.b).setQToFitRotation(
            state, simtk(orientation(mechanism, joint.a).conjugate() * orientation(mechanism, joint.b)));
    system_.realize(state, SimTK::Stage::Velocity);
    make_integrator(method);
    integrator_->initialize(state);
  }

  void step() override {
    steps_++;
    const double time = static_cast<double>(steps_) * step_;
    if (accuracy_ > 0.0) {
      integrator_->stepTo(time);
      return;
    }
    while (integrator_->stepTo(SimTK::Infinity) != SimTK::Integrator::TimeHasAdvanced)
      if (integrator_->isSimulationOver()) throw std::runtime_error("stopped by itself");
    if (std::fabs(integrator_->getTime() - time) > 1e-6 * time) throw std::runtime_error("left the fixed step");
  }

  void read(std::vector<SolidState>& state) override {
    const SimTK::State& now = integrator_->getState();
    system_.realize(now, SimTK::Stage::Velocity);
    state.resize(bodies_.size());
    for (std::size_t i = 0; i < bodies_.size(); i++) {
      const SimTK::Transform& pose = bodies_[i].getBodyTransform(now);
      const SimTK::SpatialVec& velocity = bodies_[i].getBodyVelocity(now);
      const SimTK::Quaternion q = pose.R().convertRotationToQuaternion();
      state[i] = {vector(pose.p()), Eigen::Quaterniond(q[0], q[1], q[2], q[3]), vector(velocity[1]),
                  vector(velocity[0])};
    }
  }

 private:
  SimTK::MobilizedBody& body(int i) { return bodies_[static_cast<std::size_t>(i)]; }

  static Eigen::Quaterniond orientation(const Mechanism& mechanism, int i) {
    return i < 0 ? Eigen::Quaterniond::Identity() : mechanism.solids[static_cast<std::size_t>(i)].turn;
  }

  void add(const Mechanism& mechanism, const BallJoint& joint) {
    if (joint.closes_loop) {
      SimTK::Constraint::Ball(body(joint.a), simtk(joint.at_a), body(joint.b), simtk(joint.at_b));
      return;
    }
    const SolidDef& solid = mechanism.solids[static_cast<std::size_t>(joint.b)];
    const SimTK::Inertia inertia(solid.moments.x(), solid.moments.y(), solid.moments.z());
    const SimTK::Body::Rigid rigid(SimTK::MassProperties(solid.mass, SimTK::Vec3(0), inertia));
    SimTK::MobilizedBody& parent =
        joint.a < 0 ? static_cast<SimTK::MobilizedBody&>(matter_.updGround()) : body(joint.a);
    body(joint.b) = SimTK::MobilizedBody::Ball(parent, SimTK::Transform(simtk(joint.at_a)), rigid,
                                               SimTK::Transform(simtk(joint.at_b)));
  }

  void make_integrator(Method method) {
    if (method == Method::verlet)
      integrator_ = std::make_unique<SimTK::VerletIntegrator>(system_, step_);
    else
      integrator_ = std::make_unique<SimTK::RungeKuttaMersonIntegrator>(system_);
    if (accuracy_ > 0.0) {
      integrator_->setAccuracy(accuracy_);
      integrator_->setConstraintTolerance(std::min(accuracy_, 1e-6));
      integrator_->setAllowInterpolation(false);
    } else {
      integrator_->setFixedStepSize(step_);
      integrator_->setAccuracy(1e-6);
      integrator_->setConstraintTolerance(1e-9);
      integrator_->setReturnEveryInternalStep(true);
    }
  }

  double step_, accuracy_;
  long steps_ = 0;
  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_;
  SimTK::GeneralForceSubsystem forces_;
  std::vector<SimTK::MobilizedBody> bodies_;
  std::unique_ptr<SimTK::Integrator> integrator_;
};

Setting simbody(const std::string& name, Method method, double accuracy = 0.0) {
  Setting setting;
  setting.name = name;
  setting.make = [=](const Mechanism& m, double step) {
    return std::make_unique<SimbodyRig>(m, step, method, accuracy);
  };
  setting.chooses_steps = accuracy > 0.0;
  return setting;
}

}  // namespace

std::vector<Setting> settings() {
  std::vector<Setting> all = {simbody("Verlet", Method::verlet), simbody("Merson", Method::merson)};
  for (const int digits : {2, 3, 4, 6, 8})
    all.push_back(simbody("Merson, accuracy 1e-" + std::to_string(digits), Method::merson, std::pow(10.0, -digits)));
  return all;
}

std::vector<Setting> pile_settings() { return {}; }

}  // namespace pantin::peers
