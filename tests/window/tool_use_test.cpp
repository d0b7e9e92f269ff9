// Whatever a tool does from press to release is one act, which one undo takes back and one redo does again, to the bit.
#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "measure/measure.hpp"
#include "measure/query.hpp"
#include "view/camera.hpp"
#include "view/tools.hpp"
#include "window/played.hpp"

using namespace pantin;

namespace {

/// Two boxes on a floor, and above them three links that hang on a nail, paused; seen from the front.
struct ToolBench : Played {
  static constexpr int width = 640, height = 480;  ///< [px]

  Vec3 eye;

  explicit ToolBench(bool flat, Vec3 from = vec(0, 2, 10)) : Played(text(flat, from), paused()), eye(from) {}
  static std::string text(bool flat, Vec3 from) {
    return std::string(flat ? "scene.plane = 'xy'" : "") + "scene.camera = { at = vec(" + std::to_string(from[0]) +
           "," + std::to_string(from[1]) + "," + std::to_string(from[2]) + "), look_at = vec(0, 2, 0) }" + R"(
      scene.step = 1 / 60
      scene.gravity = vec(0, -9.81, 0)
      scene:floor {}
      scene:box { at = vec(-2, 0.5, 0), size = 1 }
      scene:box { at = vec(2, 0.5, 0), size = 1 }
      local previous
      for i = 1, 3 do
        local link = scene:box { at = vec(i - 2, 4, 0), size = vec(1, 0.1, 0.1),
          points = { a = vec(-0.5, 0, 0), b = vec(0.5, 0, 0) } }
        if previous then scene:hinge(previous.b, link.a) else scene:nail(link.a) end
        previous = link
      end
    )";
  }
  static player::RunOptions paused() {
    player::RunOptions options;
    options.size = {width, height};
    options.paused = true;
    return options;
  }
  Projected seen(Vec3 position) const {
    Camera camera;
    camera.look(eye, vec(0, 2, 0));
    return camera.project(position, width, height).value();
  }
  /// The tool by its key, which pressed again takes the next of its variants.
  void take(ToolKind kind, std::size_t variant) {
    const auto key_of = [](ToolKind of) { return static_cast<SDL_Keycode>(SDLK_1 + static_cast<int>(of)); };
    pushed::tap(key_of(kind == ToolKind::drag ? ToolKind::cut : ToolKind::drag));
    for (std::size_t i = 0; i <= variant; i++) pushed::tap(key_of(kind));
    frames(1);
  }
  /// A press, a way in parts, and a release, with steps between.
  void stroke(const std::vector<Vec3>& way, int steps_at_each) {
    const Projected from = seen(way[0]);
    Projected at = from;
    pushed::move(from.x, from.y);
    frames(1);
    pushed::button(true, from.x, from.y);
    frames(1);
    for (const Vec3 next : way) {
      at = seen(next);
      pushed::move(at.x, at.y);
      frames(1);
      steps(steps_at_each);
    }
    pushed::button(false, at.x, at.y);
    frames(1);
  }
  /// A state is as it was, and has what it had.
  struct State {
    std::uint64_t hash;
    std::size_t bodies, hinges, constraints, connections, steps;
    bool operator==(const State&) const = default;
  };
  State state() const {
    const World& now = world();
    return {state_hash(now),        now.bodies.size(),      hinges(now).size(),
            now.constraints.size(), now.connections.size(), static_cast<std::size_t>(now.steps)};
  }
};

/// What one hand does with a tool: strokes, of which one with a single place is a click.
struct ToolAct {
  ToolKind kind;
  std::size_t variant = 0;
  std::vector<std::vector<Vec3>> strokes;
};

const Vec3 left_box = vec(-2, 0.5, 0), right_box = vec(2, 0.5, 0), first_joint = vec(-0.5, 4, 0),
           free_end = vec(1.5, 4, 0);

std::vector<ToolAct> acts_of(ToolKind kind, std::size_t variant) {
  const auto one = [&](const std::vector<Vec3>& way) { return ToolAct{kind, variant, {way}}; };
  switch (kind) {
    case ToolKind::drag: return {one({free_end, vec(2, 3, 0), vec(2.5, 2.5, 0)}), one({left_box, vec(-2, 2, 0)})};
    case ToolKind::cut:
      return {one({vec(-0.5, 4.3, 0), vec(-0.5, 3.7, 0)}),
              one({vec(-0.5, 4.3, 0), vec(-0.5, 3.7, 0), vec(0.5, 3.7, 0), vec(0.5, 4.3, 0)})};
    case ToolKind::join:
      return {one({left_box, vec(0, 1.5, 0), right_box}), one({right_box, vec(1.6, 3, 0), free_end})};
    case ToolKind::nail: return {one({free_end}), one({vec(-1.5, 4, 0)}), one({left_box})};
    case ToolKind::push: return {one({right_box, vec(3, 1, 0)}), one({free_end, vec(2, 3, 0)})};
    case ToolKind::spin: return {one({vec(1, 4, 0), vec(2, 3.5, 0)})};
    case ToolKind::remove:
      return {one({left_box}), one({left_box, vec(-1, 0.5, 0), vec(1, 0.5, 0), right_box}), one({vec(1, 4, 0)})};
    case ToolKind::make:
      if (ToolChoice{kind, variant}.is_polygon())
        return {{kind, variant, {{vec(-1, 2, 0)}, {vec(1, 2, 0)}, {vec(0, 3, 0)}, {vec(-1, 2, 0)}}},
                one({vec(-1, 2, 0), vec(1, 2, 0), vec(0, 3, 0), vec(-0.9, 2.1, 0)})};
      return {one({vec(-0.5, 2, 0), vec(0.5, 2.7, 0)}), one({vec(0, 2, 0)}), one({right_box, vec(2.4, 1.6, 0)})};
    case ToolKind::heat: break;  // acts by the time that it is held
  }
  return {};
}

/// What is done is undone, done again and undone.
void undo_and_redo(ToolBench& bench, const ToolBench::State& before) {
  const ToolBench::State after = bench.state();
  bench.with_control(SDLK_z);
  CHECK(bench.state() == before);
  bench.with_control(SDLK_y);
  CHECK(bench.state() == after);
  bench.with_control(SDLK_z);
  CHECK(bench.state() == before);
  CHECK(bench.player->failure().empty());
}

void do_and_undo(ToolBench& bench, const ToolAct& act) {
  const int steps_at_each = act.kind == ToolKind::drag ? 2 : 0;  // a drag pulls in steps alone
  bench.take(act.kind, act.variant);
  const ToolBench::State before = bench.state();
  for (const std::vector<Vec3>& way : act.strokes) bench.stroke(way, steps_at_each);
  CHECK(bench.state() != before);  // at once
  bench.steps(3);
  undo_and_redo(bench, before);
}

}  // namespace

TEST_CASE("window: an undo takes back one act of any tool, and a redo does it again", "[window]") {
  const bool flat = GENERATE(true, false);
  ToolBench bench(flat);
  bench.steps(3);  // there is something to go back past
  for (const Tool& tool : tools())
    for (std::size_t variant = 0; variant < std::max<std::size_t>(tool.variants.size(), 1); variant++) {
      const std::vector<ToolAct> acts = acts_of(tool.kind, variant);
      for (std::size_t i = 0; i < acts.size(); i++) {
        INFO(tool.name << " " << variant << ", act " << i << ", flat " << flat);
        do_and_undo(bench, acts[i]);
      }
    }
}

TEST_CASE("window: an undo takes back all that heating or cooling did while it was held", "[window]") {
  const std::size_t variant = GENERATE(std::size_t{0}, std::size_t{1});
  ToolBench bench(true);
  bench.steps(3);
  bench.take(ToolKind::heat, variant);
  const Projected at = bench.seen(first_joint);
  pushed::move(at.x, at.y);
  bench.frames(1);
  pushed::button(true, at.x, at.y);
  bench.frames(1);
  pushed::tap(SDLK_SPACE);
  bench.frames(8);
  pushed::tap(SDLK_SPACE);
  bench.frames(1);
  pushed::button(false, at.x, at.y);
  bench.frames(1);
  const ToolBench::State after = bench.state();
  bench.with_control(SDLK_z);
  const ToolBench::State before = bench.state();
  REQUIRE(before.steps < after.steps);
  bench.with_control(SDLK_y);
  CHECK(bench.state() == after);
  bench.with_control(SDLK_z);
  CHECK(bench.state() == before);
  ToolBench twin(true);
  twin.steps(static_cast<int>(before.steps));
  CHECK(twin.state() == before);  // nothing of it is left
  twin.steps(static_cast<int>(after.steps - before.steps));
  CHECK_FALSE(twin.state() == after);
}

TEST_CASE("window: things of different thickness in a plane are tied by hand, at the height where they are",
          "[window]") {
  ToolBench bench(true);
  for (std::size_t variant = 0; variant < tools()[static_cast<std::size_t>(ToolKind::join)].variants.size();
       variant++) {
    bench.take(ToolKind::join, variant);
    bench.stroke({right_box, vec(1.8, 3, 0), vec(1.2, 4, 0)}, 0);  // the middle of the last link
  }
  CHECK(bench.world().log.empty());
  for (const PointId id : bench.world().points.ids()) CHECK(position(bench.world(), id)[2] == 0.0);
}

TEST_CASE("window: ties from one point of a body end in the scene's plane, where the pointer is", "[window]") {
  ToolBench bench(true, vec(3, 4, 9));
  const Vec3 ends[] = {vec(0, 2, 0), vec(-1, 1.5, 0), vec(1, 3, 0)};
  for (std::size_t variant = 1; variant <= 3; variant++)
    for (const Vec3& end : ends) {
      bench.take(ToolKind::join, variant);
      bench.stroke({vec(1.5, 4, 0), end}, 0);  // the chain's tip
      CHECK(bench.world().log.empty());
      for (const ConstraintId id : bench.world().constraints.ids())
        if (const Constraint& tie = bench.world().constraints[id];
            tie.serial + 1 == bench.world().next_serial && tie.kind == ConstraintKind::rod)
          CHECK(norm(tie.position.now - end) < 0.02);
    }
}
