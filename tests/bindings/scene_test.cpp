// What the program makes of a scene without Lua.
#include <catch2/catch.hpp>

#include "edit/edit.hpp"
#include "lua/scene/open.hpp"
#include "player/aim.hpp"
#include "scene/scene.hpp"
#include "snapshot/snapshot.hpp"
#include "step/step.hpp"

using namespace pantin;

namespace {

struct KeptWorld : SceneSnapshot {
  Snapshot world;
};

/// A particle that falls.
class Falling final : public Scene {
 public:
  Falling() {
    ParticleDef def;
    def.at = vec(0, 10, 0);
    particle = add_particle(world_, def);
  }

  World& world() override { return world_; }
  const World& world() const override { return world_; }
  void step() override { pantin::step(world_); }
  const std::string& file() const override { return title_; }
  const std::string& title() const override { return title_; }
  std::optional<double> duration() const override { return 1.0; }
  double pace() const override { return 1.0; }
  CameraWish camera() const override { return {vec(0, 5, 20), vec(0, 5, 0), particle}; }
  bool finished() const override { return world_.time >= 1.0; }
  const std::vector<SceneParameter>& parameters() const override { return parameters_; }
  bool set_parameter(const std::string&, const SceneValue&) override { return false; }
  std::vector<std::string> keys() const override { return {}; }
  const std::vector<std::string>& buttons() const override { return buttons_; }
  const std::map<std::string, SceneValue>& results() const override { return results_; }
  const std::vector<Drawing>& drawings() const override { return drawings_; }
  std::shared_ptr<const SceneSnapshot> take_snapshot() override {
    auto kept = std::make_shared<KeptWorld>();
    kept->world = pantin::take_snapshot(world_);
    return kept;
  }
  void restore(const SceneSnapshot& snapshot) override {
    pantin::restore(world_, dynamic_cast<const KeptWorld&>(snapshot).world);
  }
  std::string state() override { throw Error("it is not written"); }
  CarriedOver go_on_from(Scene& old) override { return carry_over(old.world(), {}, world_, {}); }

  ParticleId particle;

 private:
  World world_;
  std::string title_ = "Falling";
  std::vector<SceneParameter> parameters_;
  std::vector<std::string> buttons_;
  std::map<std::string, SceneValue> results_;
  std::vector<Drawing> drawings_;
};

}  // namespace

TEST_CASE("a scene may be something else than a Lua script") {
  Falling falling;
  Scene& scene = falling;
  const auto start = scene.take_snapshot();
  while (!scene.finished()) scene.step();
  CHECK(position(scene.world(), falling.particle)[1] < 6.0);
  log_line(scene.world(), "warning", "it fell far");
  CHECK(scene.warnings() == std::vector<std::string>{"it fell far"});
  CHECK(scene.notices().empty());
  const Camera camera = player::aim(scene, find_stage(scene.world()), 16.0 / 9.0);
  CHECK(norm(camera.eye() - vec(0, 5, 20)) < 1e-9);
  CHECK(scene.why_not_restore().empty());
  scene.restore(*start);
  CHECK(position(scene.world(), falling.particle)[1] == 10.0);
}

TEST_CASE("a Lua script does not go on from a scene that is none") {
  Falling falling;
  const auto script = lua::open_scene_text("scene:particle {}", "scene.lua", "", {});
  CHECK_THROWS_WITH(script->go_on_from(falling), "this scene is not a Lua script");
}
