// MuJoCo: ball joints in reduced coordinates, loops closed by its soft equality constraint at its stiffest. Contacts are as
// soft as it has them by default: stiffer ones make ragdolls unstable.
#include <mujoco/mujoco.h>

#include <cstdio>
#include <cstring>
#include <stdexcept>

#include "peers/peer.hpp"
#include "peers/piles.hpp"

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
  ModelText(const Mechanism& mechanism, double step, const char* integrator)
      : mechanism_(mechanism), stiffest_("solref='" + numbers({2.0 * step, 1.0}) + "'") {
    const std::size_t n = mechanism.solids.size();
    hanging_.resize(n + 1);
    std::vector<const BallJoint*> joint_of(n, nullptr);
    for (const BallJoint& joint : mechanism.joints)
      if (!joint.closes_loop) joint_of[static_cast<std::size_t>(joint.b)] = &joint;
    for (std::size_t i = 0; i < n; i++)
      hanging_[joint_of[i] ? static_cast<std::size_t>(joint_of[i]->a + 1) : 0].push_back({i, joint_of[i]});
    const bool touching = !mechanism.walls.empty();
    main_ = "<mujoco><compiler inertiafromgeom='false' angle='radian' coordinate='local'/><size " + sizes(touching) +
            "/><option timestep='" + numbers({step}) + "' integrator='" + integrator + "' gravity='" +
            numbers({0, -gravity, 0}) + "' solver='Newton' " +
            (touching ? "><flag" : "iterations='200' tolerance='1e-14'><flag contact='disable'") +
            " limit='disable' frictionloss='disable' passive='disable' actuation='disable'/></option><worldbody>" +
            walls() + bodies(0, 0) + "</worldbody>" + loops() + "</mujoco>";
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

  /// Room, of which it takes the square of njmax.
  std::string sizes(bool touching) const {
    const std::size_t n = 3 * mechanism_.solids.size() + 6;
    std::size_t stack = 200000 + n * (n + 1) / 2 * 40 + 4000 * n, contacts = 50;
    for (const SolidDef& solid : mechanism_.solids) contacts += solid.form == Form::ball ? 6 : 10;
    if (touching) stack += 2000 * contacts;
    return "njmax='" + std::to_string(touching ? 4 * contacts : 400) + "' nconmax='" +
           std::to_string(touching ? contacts : 1) + "' nstack='" + std::to_string(stack) + "'";
  }

  std::string walls() const {
    std::string all;
    for (const Wall& wall : mechanism_.walls)
      all += "<geom type='plane' size='0 0 1' pos='" + numbers(Eigen::Vector3d(wall.offset * wall.normal)) +
             "' zaxis='" + numbers(wall.normal) + "' " + surface() + "/>";
    return all;
  }

  std::string surface() const { return "condim='3' friction='" + numbers({friction, 0, 0}) + "'"; }

  std::string shape(const SolidDef& solid) const {
    switch (solid.form) {
      case Form::none: return "";
      case Form::ball: return "<geom type='sphere' size='" + numbers({solid.size.x()}) + "' " + surface() + "/>";
      case Form::box: return "<geom type='box' size='" + numbers(solid.size) + "' " + surface() + "/>";
      case Form::capsule:
        return "<geom type='capsule' size='" + numbers({solid.size.x(), solid.size.z()}) + "' " + surface() + "/>";
    }
    return "";
  }

  /// What hangs in a body, 0 being the world, and in it what hangs there.
  std::string bodies(std::size_t parent, std::size_t depth) {
    if (depth > 0 && depth % deep == 0 && !hanging_[parent].empty()) {
      const std::size_t part = parts_.size();
      parts_.emplace_back();
      parts_[part] = "<mujocoinclude>" + bodies(parent, depth + 1) + "</mujocoinclude>";
      return "<include file='" + part_name(part) + "'/>";
    }
    std::string all;
    for (const auto& [i, joint] : hanging_[parent]) all += body(i, joint) + bodies(i + 1, depth + 1) + "</body>";
    return all;
  }

  std::string body(std::size_t i, const BallJoint* joint) const {
    const SolidDef& solid = mechanism_.solids[i];
    Eigen::Vector3d at = solid.at;
    Eigen::Quaterniond turn = solid.turn;
    if (joint && joint->a >= 0) {
      const SolidDef& parent = mechanism_.solids[static_cast<std::size_t>(joint->a)];
      at = parent.turn.conjugate() * (at - parent.at);
      turn = parent.turn.conjugate() * turn;
    }
    return "<body pos='" + numbers(at) + "' quat='" + numbers({turn.w(), turn.x(), turn.y(), turn.z()}) + "' name='b" +
           std::to_string(i) + "'><inertial pos='0 0 0' mass='" + numbers({solid.mass}) + "' diaginertia='" +
           numbers(solid.moments) + "'/>" +
           (joint ? "<joint type='ball' pos='" + numbers(joint->at_b) + "'/>" : "<freejoint/>") + shape(solid);
  }

  std::string loops() const {
    std::string all;
    for (const BallJoint& joint : mechanism_.joints)
      if (joint.closes_loop)
        all += "<equality><connect body1='b" + std::to_string(joint.a) + "' body2='b" + std::to_string(joint.b) +
               "' anchor='" + numbers(joint.at_a) + "' " + stiffest_ +
               " solimp='0.9999 0.9999 0.001 0.5 2'/></equality>";
    return all;
  }

  struct Hanging {
    std::size_t solid;
    const BallJoint* joint;  ///< null: it is free
  };

  const Mechanism& mechanism_;
  std::string stiffest_;
  std::vector<std::vector<Hanging>> hanging_;  ///< (solids + 1) in the world, then in each solid
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
    for (std::size_t i = 0; i < mechanism.solids.size(); i++)
      bodies_.push_back(mj_name2id(model_.get(), mjOBJ_BODY, ("b" + std::to_string(i)).c_str()));
    mj_forward(model_.get(), data_.get());
  }

  std::size_t contacts() const override { return static_cast<std::size_t>(data_->ncon); }

  void step() override { mj_step(model_.get(), data_.get()); }

  void read(std::vector<SolidState>& state) override {
    mj_kinematics(model_.get(), data_.get());
    mj_comPos(model_.get(), data_.get());
    mj_comVel(model_.get(), data_.get());
    state.resize(bodies_.size());
    for (std::size_t k = 0; k < state.size(); k++) {
      const int i = bodies_[k];
      double v[6];
      mj_objectVelocity(model_.get(), data_.get(), mjOBJ_BODY, i, v, 0);
      const double* const x = data_->xpos + 3 * i;
      const double* const q = data_->xquat + 4 * i;
      state[k] = {{x[0], x[1], x[2]},
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
  std::vector<int> bodies_;
};

Setting mujoco(const char* integrator) {
  return {integrator,
          [integrator](const Mechanism& m, double step) { return std::make_unique<MujocoRig>(m, step, integrator); }};
}

}  // namespace

std::vector<Setting> settings() { return {mujoco("Euler"), mujoco("RK4")}; }

std::vector<Setting> pile_settings() {
  Setting newton = mujoco("Euler");
  newton.name = "Newton";
  newton.can = [](const Mechanism& pile) { return pile.solids.size() <= 300; };  // it takes the square in room
  return {newton};
}

}  // namespace pantin::peers
