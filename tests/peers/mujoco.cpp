// MuJoCo: ball joints in reduced coordinates, loops closed by its soft equality constraint at its stiffest.
#include <mujoco/mujoco.h>

#include <cstdio>
#include <cstring>
#include <stdexcept>

#include "peers/peer.hpp"

namespace pantin::peers {

namespace {

[[noreturn]] void fail(const char* message) { throw std::runtime_error(message); }

std::string numbers(std::initializer_list<double> list) {
  std::string result;
  char digits[32];
  for (const double x : list) {
    std::snprintf(digits, sizeof digits, "%s%.17g", result.empty() ? "" : " ", x);
    result += digits;
  }
  return result;
}
std::string numbers(const Eigen::Vector3d& v) { return numbers({v.x(), v.y(), v.z()}); }

/// Bodies hang in each other, and the parser reads no more than 100 of them deep: longer chains go on in other files.
constexpr std::size_t deep = 60;

class ModelText {
 public:
  ModelText(const Mechanism& mechanism, double step, const char* integrator) : mechanism_(mechanism) {
    main_ =
        "<mujoco><compiler inertiafromgeom='false' angle='radian' coordinate='local'/><size njmax='400' nconmax='1' "
        "nstack='" +
        std::to_string(stack()) + "'/><option timestep='" + numbers({step}) + "' integrator='" + integrator +
        "' gravity='" + numbers({0, -gravity, 0}) +
        "' solver='Newton' iterations='200' tolerance='1e-14'><flag contact='disable' limit='disable' "
        "frictionloss='disable' passive='disable' actuation='disable'/></option><worldbody>" +
        bodies(0) + "</worldbody>" + loops(step) + "</mujoco>";
  }

  mjModel* load() {
    const auto files = std::make_unique<mjVFS>();
    mj_defaultVFS(files.get());
    add(*files, "main.xml", main_);
    for (std::size_t i = 0; i < parts_.size(); i++) add(*files, part_name(i), parts_[i]);
    char error[1000] = "";
    mjModel* const model = mj_loadXML("main.xml", files.get(), error, sizeof error);
    mj_deleteVFS(files.get());
    if (!model) fail(error);
    return model;
  }

 private:
  static std::string part_name(std::size_t i) { return "part" + std::to_string(i) + ".xml"; }

  static void add(mjVFS& files, const std::string& name, const std::string& text) {
    if (mj_makeEmptyFileVFS(&files, name.c_str(), static_cast<int>(text.size())) != 0) fail("cannot make a file");
    std::memcpy(files.filedata[files.nfile - 1], text.data(), text.size());
  }

  std::size_t stack() const {
    const std::size_t n = 3 * mechanism_.solids.size() + 6;
    return 200000 + n * (n + 1) / 2 * 40 + 4000 * n;
  }

  /// Bodies from the i-th on, each in the one before.
  std::string bodies(std::size_t i) {
    std::string opened, closed;
    for (; i < mechanism_.solids.size(); i++) {
      if (!opened.empty() && i % deep == 0) {
        const std::size_t part = parts_.size();
        parts_.emplace_back();
        parts_[part] = "<mujocoinclude>" + bodies(i) + "</mujocoinclude>";
        opened += "<include file='" + part_name(part) + "'/>";
        break;
      }
      opened += body(i);
      closed += "</body>";
    }
    return opened + closed;
  }

  std::string body(std::size_t i) const {
    const SolidDef& solid = mechanism_.solids[i];
    const BallJoint& joint = mechanism_.joints[i];
    Eigen::Vector3d at = solid.at;
    Eigen::Quaterniond turn = solid.orientation();
    if (joint.a >= 0) {
      const SolidDef& parent = mechanism_.solids[static_cast<std::size_t>(joint.a)];
      at = parent.orientation().conjugate() * (at - parent.at);
      turn = parent.orientation().conjugate() * turn;
    }
    return "<body pos='" + numbers(at) + "' quat='" + numbers({turn.w(), turn.x(), turn.y(), turn.z()}) + "' name='b" +
           std::to_string(i) + "'><inertial pos='0 0 0' mass='" + numbers({solid.mass}) + "' diaginertia='" +
           numbers(solid.moments) + "'/><joint type='ball' pos='" + numbers(joint.at_b) + "'/>";
  }

  std::string loops(double step) const {
    std::string all;
    for (const BallJoint& joint : mechanism_.joints)
      if (joint.closes_loop)
        all += "<equality><connect body1='b" + std::to_string(joint.a) + "' body2='b" + std::to_string(joint.b) +
               "' anchor='" + numbers(joint.at_a) + "' solref='" + numbers({2.0 * step, 1.0}) +
               "' solimp='0.9999 0.9999 0.001 0.5 2'/></equality>";
    return all;
  }

  const Mechanism& mechanism_;
  std::string main_;
  std::vector<std::string> parts_;
};

class MujocoRig : public Rig {
 public:
  MujocoRig(const Mechanism& mechanism, double step, const char* integrator) {
    mju_user_error = mju_user_warning = [](const char* message) { fail(message); };
    model_.reset(ModelText(mechanism, step, integrator).load());
    data_.reset(mj_makeData(model_.get()));
    if (!data_) fail("no memory");
    mj_forward(model_.get(), data_.get());
  }

  void step() override { mj_step(model_.get(), data_.get()); }

  void read(std::vector<SolidState>& state) override {
    mj_kinematics(model_.get(), data_.get());
    mj_comPos(model_.get(), data_.get());
    mj_comVel(model_.get(), data_.get());
    state.resize(static_cast<std::size_t>(model_->nbody - 1));
    for (int i = 1; i < model_->nbody; i++) {
      double v[6];
      mj_objectVelocity(model_.get(), data_.get(), mjOBJ_BODY, i, v, 0);
      const double* const x = data_->xpos + 3 * i;
      const double* const q = data_->xquat + 4 * i;
      state[static_cast<std::size_t>(i - 1)] = {{x[0], x[1], x[2]},
                                                Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized(),
                                                {v[3], v[4], v[5]},
                                                {v[0], v[1], v[2]}};
    }
  }

 private:
  struct Delete {
    void operator()(mjModel* model) const { mj_deleteModel(model); }
    void operator()(mjData* data) const { mj_deleteData(data); }
  };
  std::unique_ptr<mjModel, Delete> model_;
  std::unique_ptr<mjData, Delete> data_;
};

Setting mujoco(const char* integrator) {
  return {integrator,
          [integrator](const Mechanism& m, double step) { return std::make_unique<MujocoRig>(m, step, integrator); }};
}

}  // namespace

std::vector<Setting> settings() { return {mujoco("Euler"), mujoco("RK4")}; }

}  // namespace pantin::peers
