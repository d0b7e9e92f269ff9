// Recordings, driven by a script instead of a person, and played again.
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>

#include "bindings/lua_support.hpp"
#include "player/recording.hpp"
#include "player/replay.hpp"
#include "support/process.hpp"
#include "world/measure.hpp"

using namespace pantin;
using namespace pantin::support;
using Catch::Contains;
using player::Recorder;
using player::Recording;
using player::Replay;

namespace {

const char* const scene_text = R"(
  local links = scene:param("links", 12, { min = 1, max = 50 })
  scene:param("gravity", 9.81, { on_change = function(g) scene.gravity = vec(0, -g, 0) end })
  local last
  for i = 1, links do
    local link = scene:body{ mass = 1, inertia = vec(0.0017, 0.0842, 0.0842), at = vec(i - 0.5, 4, 0),
      points = { head = vec(-0.5, 0, 0), tail = vec(0.5, 0, 0) } }
    if last then scene:hinge(last.tail, link.head) else scene:nail(link.head) end
    last = link
  end
  for i = 1, 30 do scene:particle{ at = vec(i % 6, 6 + i // 6, math.random()) } end
  scene:on("key", function() scene:particle{ at = vec(math.random(), 8, 0) } end)
)";

/// What a person might do, from a fixed series of numbers, in a scene that is recorded.
struct Person {
  Person(const std::string& record, const std::string& file) : scene(lua::Scene::open(file, options())), path(file) {
    recorder = std::make_unique<Recorder>(record, player::RecordingHead{player::program_version(), file, {}, {}});
  }
  static lua::SceneOptions options() {
    lua::SceneOptions o = lua_tests::options();
    o.memory_limit = std::size_t{256} << 20;
    return o;
  }
  double number() {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state >> 11) * 0x1p-53;
  }
  std::size_t below(std::size_t n) {
    return std::min(n - 1, static_cast<std::size_t>(number() * static_cast<double>(n)));
  }

  void add_command(StepInput& input) {
    const World& world = scene->world();
    const std::vector<PointId> points = world.points.ids();
    Command c;
    c.hand = static_cast<std::int32_t>(below(2));
    c.kind = static_cast<Command::Kind>(below(12));
    c.name = "k";
    c.point = points[below(points.size())];
    c.other = points[below(points.size())];
    const std::vector<ParticleId> particles = world.particles.ids();
    c.thing = particles[below(particles.size())];
    c.place = vec(6 * number(), 6 * number(), 0);
    c.amount = vec(number(), number(), number()) * 0.3;
    if (c.kind == Command::Kind::make) c.points = {zero3(), vec(0.5, 0, 0)};
    c.mass = c.kind == Command::Kind::make ? 0.5 : 0.0;
    c.radius = 0.5;
    c.energy = 0.1;
    input.commands.push_back(c);
  }
  void step() {
    const double t = static_cast<double>(done++) / 240;
    StepInput input;
    for (std::int32_t hand = 0; hand < 2; hand++)
      input.moves.push_back({hand, vec(4 + 3 * std::sin(t + hand), 4 + 2 * std::cos(1.3 * t), hand), true});
    if (number() < 0.02) add_command(input);
    recorder->input(input);
    scene->world().input = input;
    scene->step();
    REQUIRE(scene->world().failure == "");
    recorder->stepped(scene->world());
  }
  void set(const char* name, double value) {
    if (!scene->set_parameter(name, value)) {
      lua::SceneOptions o = options();
      o.set = {{name, to_text(value)}};
      scene = lua::Scene::open(path, o);
    }
    recorder->parameter(name, value);
  }

  std::unique_ptr<lua::Scene> scene;
  std::string path;
  std::unique_ptr<Recorder> recorder;
  std::uint64_t state = 7, done = 0;
};

player::RunOptions run_options() {
  player::RunOptions o;
  o.threads = 1;
  return o;
}

/// Minutes of play with edits, undone ones, changed parameters and a restart; gives the hash at the end.
std::uint64_t play(const Folder& folder, int seconds) {
  write_file(folder / "scene.lua", scene_text);
  Person person(folder / "play.rec", folder / "scene.lua");
  std::shared_ptr<const lua::SceneSnapshot> kept;
  for (int second = 0; second < seconds; second++) {
    if (second % 7 == 3) {
      kept = person.scene->take_snapshot();
      person.recorder->kept(static_cast<std::uint64_t>(second));
    }
    for (int i = 0; i < 240; i++) person.step();
    if (second % 7 == 3 && second % 2 == 0) {
      person.scene->restore(*kept);
      person.recorder->restored(static_cast<std::uint64_t>(second));
    }
    if (second % 5 == 4) person.set("gravity", 5.0 + second);
    if (second == seconds / 2) {
      kept.reset();
      person.set("links", 9);
    }
    if (second == seconds / 3) {
      kept.reset();
      person.scene = lua::Scene::open(person.path, Person::options());
      person.recorder->restarted();
    }
  }
  person.recorder->finish();
  return state_hash(person.scene->world());
}

std::size_t to_end(Replay& replay) {
  std::size_t steps = 0;
  while (replay.step()) steps++;
  return steps;
}

}  // namespace

TEST_CASE("recording: minutes of play with edits are played again to the bit") {
  Folder folder;
  const std::uint64_t hash = play(folder, 120);
  Replay replay(player::read_recording(folder / "play.rec"), run_options(), sources::folder());
  CHECK(to_end(replay) == 120 * 240);
  CHECK(replay.mismatch() == "");
  CHECK(replay.checked() >= 119);
  CHECK(replay.remarks().empty());
  CHECK(state_hash(replay.scene().world()) == hash);
}

TEST_CASE("recording: one may go to any step of it and back") {
  Folder folder;
  play(folder, 20);
  Replay replay(player::read_recording(folder / "play.rec"), run_options(), sources::folder());
  std::map<std::uint64_t, std::uint64_t> hashes;
  while (replay.step()) hashes[replay.tick()] = state_hash(replay.scene().world());
  for (const std::uint64_t tick : {4700u, 4000u, 30u, 4100u, 1000u, 999u, 2500u, 4799u}) {
    while (!replay.go_to(tick, 100)) {}
    CHECK(replay.tick() == tick);
    CHECK(state_hash(replay.scene().world()) == hashes.at(tick));
  }
  CHECK(replay.mismatch() == "");
}

TEST_CASE("recording: a replay that parts from it says where that began") {
  Folder folder;
  play(folder, 6);
  std::string text = read_file(folder / "play.rec");
  const std::size_t moved = text.find("{\"tick\":700,");
  REQUIRE(moved != std::string::npos);
  const std::size_t number = text.find("[[0,", moved) + 4;
  text.replace(number, text.find(',', number) - number, "9.5");
  write_file(folder / "changed.rec", text);
  Replay replay(player::read_recording(folder / "changed.rec"), run_options(), sources::folder());
  to_end(replay);
  CHECK_THAT(replay.mismatch(), Contains("between 0 s and 1 s") || Contains("between"));
  CHECK(replay.checked() >= 2);
}

TEST_CASE("recording: one that is cut off in the middle is played as far as it goes, and says so") {
  Folder folder;
  play(folder, 4);
  const std::string text = read_file(folder / "play.rec");
  const std::size_t cut = text.find("{\"tick\":500,") + 20;
  write_file(folder / "cut.rec", text.substr(0, cut));
  const Recording recording = player::read_recording(folder / "cut.rec");
  CHECK_THAT(recording.damage, Contains("cut.rec:") && Contains("cut off in the middle"));
  Replay replay(recording, run_options(), sources::folder());
  CHECK(to_end(replay) == 500);
  CHECK(replay.mismatch() == "");
  REQUIRE(replay.remarks().size() == 1);
  CHECK_THAT(replay.remarks()[0], Contains("what there is by then is played"));
}

TEST_CASE("recording: another version, changed files and what is none are told") {
  Folder folder;
  write_file(folder / "scene.lua", "scene:particle{}");
  const player::RecordingHead head{"0.0.1", folder / "scene.lua", {}, {{folder / "scene.lua", 1}, {"gone.lua", 2}}};
  { Recorder recorder(folder / "old.rec", head); }
  const Replay replay(player::read_recording(folder / "old.rec"), run_options(), sources::folder());
  REQUIRE(replay.remarks().size() == 3);
  CHECK_THAT(replay.remarks()[0], Contains("gone.lua was read by the recorded scene") || Contains("has changed since"));
  CHECK_THAT(replay.remarks()[2], Contains("was made by pantin 0.0.1"));
  CHECK_THROWS_WITH(player::read_recording(folder / "nowhere"), Contains("there is no such file"));
  write_file(folder / "text", "hello\n");
  CHECK_THROWS_WITH(player::read_recording(folder / "text"), Contains("text:1: this is no recording"));
  write_file(folder / "next", "{\"pantin\":2}\n");
  CHECK_THROWS_WITH(player::read_recording(folder / "next"), Contains("it has the format 2"));
}

TEST_CASE("recording: every command comes back as it was written") {
  StepInput input;
  input.moves = {{3, vec(0.1, -1e-300, 1.0 / 3.0), true}};
  Command c;
  c.kind = Command::Kind::make;
  c.hand = 3;
  c.point = {4, 7};
  c.other = {9, 1};
  c.thing = ConnectionId{5, 6};
  c.place = vec(0.1, 0.2, 0.3);
  c.amount = vec(1e-17, 0, -2);
  c.points = {vec(1, 2, 3), vec(1.0 / 7.0, 0, 0)};
  c.max_force = infinity;
  c.mass = 0.7;
  c.radius = 0.01;
  c.energy = -3;
  c.name = "ü \"quoted\"";
  input.commands = {c};
  const player::RecordedAct act = player::act_of(player::line_of({12, input}));
  CHECK(act.tick == 12);
  const StepInput& read = std::get<StepInput>(act.what);
  CHECK(same(read.moves.at(0).position, input.moves[0].position));
  const Command& r = read.commands.at(0);
  CHECK((r.kind == c.kind && r.hand == 3 && r.point == c.point && r.other == c.other && r.thing == c.thing));
  CHECK((same(r.place, c.place) && same(r.amount, c.amount) && same(r.points.at(1), c.points[1])));
  CHECK((r.max_force == c.max_force && r.mass == c.mass && r.radius == c.radius && r.energy == c.energy));
  CHECK(r.name == c.name);
}

TEST_CASE("recording: the program plays one again") {
  Folder folder;
  play(folder, 2);
  const auto use = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), sources::program());
    return finish({arguments, {"PANTIN_HOME=" + sources::folder(), "DISPLAY", "WAYLAND_DISPLAY"}, folder.path, -1});
  };
  const Finished good = use({"replay", "play.rec"});
  CHECK(good.code == 0);
  CHECK_THAT(good.err, Contains("replayed 480 of 480 steps") && Contains("all as recorded"));
  const Finished none = use({"replay", "scene.lua"});
  CHECK(none.code == 1);
  CHECK_THAT(none.err, Contains("scene.lua:1: this is no recording"));
}
