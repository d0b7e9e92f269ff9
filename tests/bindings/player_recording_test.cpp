// Recordings, driven by a script instead of a person, and played again.
#include <sys/stat.h>
#include <catch2/catch.hpp>

#include "bindings/recorded_person.hpp"

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

player::RunOptions run_options() {
  player::RunOptions o;
  o.threads = 1;
  return o;
}

/// Minutes of play with edits, undone ones, changed parameters, a saved file and restarts; gives the hash at the end.
std::uint64_t play(const Folder& folder, int seconds) {
  write_file(folder / "scene.lua", scene_text);
  RecordedPerson person(folder / "scene.lua", folder / "play.rec");
  for (int second = 0; second < seconds; second++) {
    person.play(1.0);
    if (second % 5 == 4) person.set("gravity", 5.0 + second % 7);
    if (second % 11 == 3) person.edit("velocity", vec(0, 0.1 * second, 0));
    if (second % 17 == 9) person.save(scene_text + std::string("scene.title = 'saved'"));
    if (second == 1) person.hand_comes();
    if (second == seconds / 2) person.set("links", 9);
    if (second == seconds / 3) person.restart();
  }
  person.finish();
  return person.hash();
}

std::size_t to_end(Replay& replay) {
  std::size_t steps = 0;
  while (replay.step()) steps++;
  return steps;
}

/// Records a scene that is left alone for so many steps, and gives the hashes of all its states.
std::vector<std::uint64_t> leave_alone(const Folder& folder, const std::string& text, int steps) {
  write_file(folder / "scene.lua", text);
  RecordedPerson person(folder / "scene.lua", folder / "play.rec");
  std::vector<std::uint64_t> hashes = {person.hash()};
  for (int i = 0; i < steps; i++) {
    person.step_alone();
    hashes.push_back(person.hash());
  }
  person.finish();
  return hashes;
}

}  // namespace

TEST_CASE("recording: minutes of play with edits are played again to the bit") {
  Folder folder;
  const std::uint64_t hash = play(folder, 120);
  Replay replay(player::read_recording(folder / "play.rec"), run_options(), sources::folder());
  CHECK(to_end(replay) >= 119 * 240);
  CHECK(replay.mismatch() == "");
  CHECK(replay.checked() >= 119);
  CHECK(replay.scene().title() == "saved");
  CHECK(state_hash(replay.scene().world()) == hash);
}

TEST_CASE("recording: one may go to any step of it and back, and is there in the first state") {
  Folder folder;
  play(folder, 20);
  Replay replay(player::read_recording(folder / "play.rec"), run_options(), sources::folder());
  std::map<std::uint64_t, std::uint64_t> hashes;
  while (replay.step()) hashes[replay.tick()] = state_hash(replay.scene().world());
  for (const std::uint64_t tick : {4700u, 4699u, 4698u, 4000u, 30u, 4100u, 1000u, 999u, 2500u, 2750u, 4750u}) {
    while (!replay.go_to(tick, 100)) {}
    CHECK(replay.tick() == tick);
    CHECK(state_hash(replay.scene().world()) == hashes.at(tick));
  }
  CHECK(replay.mismatch() == "");
}

TEST_CASE("recording: it goes on over scenes that open each other, and one may go to any step of all of them") {
  Folder folder;
  write_file(folder / "scene.lua", scene_text);
  write_file(folder / "next.lua",
             "local v = scene:param('v', 1) local stage = scene:param('stage', 'one')\n"
             "scene.title, scene.step = stage, 1 / 480 for i = 1, 3 do\n"
             "scene:particle { at = vec(i, 0, 0), velocity = vec(0, v, math.random()) } end");
  RecordedPerson person(folder / "scene.lua", folder / "play.rec");
  double played = 0.0;
  const auto part = [&] {
    person.play(1.2);
    played += person.world().time;
    return person.hash();
  };
  std::vector<std::uint64_t> hashes = {part()};
  person.open(folder / "next.lua", {{"v", "5"}});
  hashes.push_back(part());
  person.open(folder / "next.lua", {{"stage", "two"}});
  person.restart();
  hashes.push_back(part());
  person.finish();
  Replay replay(player::read_recording(folder / "play.rec"), run_options(), sources::folder());
  to_end(replay);
  CHECK(replay.mismatch() == "");
  CHECK(replay.checked() >= 3);
  CHECK(replay.played() == Approx(played));
  CHECK(replay.duration() == Approx(3.6));
  for (const auto& [tick, time] :
       {std::pair(144u, 0.6), std::pair(288u, 1.2), std::pair(528u, 1.7), std::pair(1440u, 3.6)}) {
    CHECK(replay.time_at(tick) == Approx(time));
    CHECK(replay.tick_at(time) == tick);
  }
  const auto look = [&](std::uint64_t tick, std::size_t place, const std::string& title) {
    while (!replay.go_to(tick, 100)) {}
    CHECK(state_hash(replay.scene().world()) == hashes.at(place));
    CHECK(replay.place() == place);
    CHECK(replay.scene().title() == title);
    CHECK(replay.path() == folder / (place == 0 ? "scene.lua" : "next.lua"));
  };
  for (int i = 0; i < 2; i++) {
    look(1440, 2, "two");
    look(864, 1, "one");
    look(288, 0, "");
  }
  CHECK(replay.mismatch() == "");
}

TEST_CASE("recording: a step back is exact where the script counts in a variable of its own, and where it waits") {
  const std::string thrown = "local p = scene:particle{ at = vec(0, 1, 0), velocity = vec(1, 3, 0) } local n = 0 ";
  const std::string text = GENERATE(
      as<std::string>(), "scene:on('step', function() n = n + 1 p.velocity = vec(math.sin(n), 0, 0) end)",
      "scene:play(function(wait) while true do wait(0.1) n = n + 1 p.velocity = vec(0, n % 3, 0) end end)",
      "scene:play(function(wait) wait(1) n = 5 end) scene:every(0.25, function() p.velocity = vec(n, n, 1) end)",
      "scene:every(0.125, function() p.velocity = vec(0, math.random(), 0) end)");
  Folder folder;
  const std::vector<std::uint64_t> hashes = leave_alone(folder, thrown + text, 720);
  Replay replay(player::read_recording(folder / "play.rec"), run_options(), sources::folder());
  for (const std::uint64_t tick : {700u, 699u, 698u, 300u, 299u, 710u, 1u, 0u, 400u, 720u, 719u}) {
    while (!replay.go_to(tick, 50)) {}
    CHECK(replay.tick() == tick);
    CHECK(state_hash(replay.scene().world()) == hashes.at(tick));
  }
  CHECK(replay.mismatch() == "");
}

TEST_CASE("recording: scene.store is what it was, where it was undone and wherever one goes") {
  Folder folder;
  write_file(folder / "scene.lua", R"(
    local p = scene:particle { at = vec(0, 1, 0) }
    for i = 1, 5 do scene:particle { at = vec(i, 0, 0) } end
    scene.store.steps = 0
    scene.store.made = { places = {} }
    scene:on("step", function()
      local store = scene.store
      store.steps = store.steps + 1
      if store.steps % 10 == 0 then table.insert(store.made.places, p.alive and p.position or vec(0, 0, 0)) end
      if p.alive then p.velocity = vec(math.sin(store.steps), #store.made.places % 7, 0) end
      scene:result("steps", store.steps)
      scene:result("places", #store.made.places)
    end))");
  RecordedPerson person(folder / "scene.lua", folder / "play.rec", 5);
  std::map<std::uint64_t, std::map<std::string, SceneValue>> known;
  for (std::uint64_t tick = 1; tick <= 1920; tick++) {
    person.step();
    if (tick % 240 == 0) known[tick] = person.scene().results();
  }
  const std::uint64_t hash = person.hash();
  person.finish();
  Replay replay(player::read_recording(folder / "play.rec"), run_options(), sources::folder());
  to_end(replay);
  CHECK(replay.mismatch() == "");
  CHECK(state_hash(replay.scene().world()) == hash);
  CHECK(replay.scene().results() == known.at(1920));
  CHECK(std::get<double>(known.at(1920).at("steps")) < 1920);  // some were undone
  for (const std::uint64_t tick : {1440u, 480u, 1200u, 1680u}) {
    while (!replay.go_to(tick, 50)) {}
    CHECK(replay.scene().results() == known.at(tick));
  }
}

TEST_CASE("recording: a replay that parts from it says where that began, and says it once") {
  Folder folder;
  write_file(folder / "scene.lua", "scene:body{ name = 'b', mass = 1, inertia = vec(1, 1, 1) }");
  {
    RecordedPerson person(folder / "scene.lua", folder / "play.rec");
    for (int i = 0; i < 1200; i++) {
      person.step_alone();
      if (i == 700) person.edit("velocity", vec(1, 0, 0));
    }
    person.finish();
  }
  std::string text = read_file(folder / "play.rec");
  const std::size_t edited = text.find("[1.0,0.0,0.0]");
  REQUIRE(edited != std::string::npos);
  text.replace(edited + 1, 3, "1.1");
  write_file(folder / "changed.rec", text);
  Replay replay(player::read_recording(folder / "changed.rec"), run_options(), sources::folder());
  to_end(replay);
  CHECK(replay.mismatch() == "the replay parts from the recording between 2 s and 3 s");
  CHECK(replay.checked() == 2);
  for (const std::uint64_t tick : {100u, 1100u, 600u, 1200u}) {
    while (!replay.go_to(tick, 100)) {}
    CHECK(replay.mismatch() == "the replay parts from the recording between 2 s and 3 s");
    CHECK(replay.checked() == 2);
  }
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

TEST_CASE("recording: a line that would take it far into the future is damage, and what is before it is played") {
  Folder folder;
  play(folder, 4);
  std::string text = read_file(folder / "play.rec");
  const std::string tick = "{\"tick\":500,";
  text.replace(text.find(tick), tick.size(), "{\"tick\":18446744073709551615,");
  write_file(folder / "far.rec", text);
  const Recording recording = player::read_recording(folder / "far.rec");
  CHECK_THAT(recording.damage, Contains("far.rec:") && Contains("too far from that of the line above"));
  Replay replay(recording, run_options(), sources::folder());
  CHECK(to_end(replay) <= 500);
}

TEST_CASE("recording: cut off anywhere, a message is all that comes of it") {
  Folder folder;
  play(folder, 2);
  const std::string text = read_file(folder / "play.rec");
  const std::size_t head = text.find('\n');
  for (std::size_t cut = head + 1; cut < text.size(); cut += 997) {
    write_file(folder / "cut.rec", text.substr(0, cut));
    const Recording recording = player::read_recording(folder / "cut.rec");
    CHECK(recording.damage != "");
    CHECK(recording.ticks <= 480);
  }
  write_file(folder / "cut.rec", text.substr(0, head / 2));
  CHECK_THROWS_WITH(player::read_recording(folder / "cut.rec"), Contains("cut.rec:1: this is no recording"));
}

TEST_CASE("recording: it holds the files of the scene as they were, and tells that they have changed") {
  Folder folder;
  std::filesystem::create_directory(folder.path / "parts");
  write_file(folder / "parts/ball.lua", "return function() scene:particle{ at = vec(0, 3, 0) } end");
  const std::string name = "\xe9 is no UTF-8";
  const std::string scene = "scene.title = '" + name + "' require('parts.ball')() " +
                            "scene:at(0.5, function() require('late')() end) require 'wind'";
  write_file(folder / "late.lua", "return function() scene:particle{ at = vec(1, 3, 0) } end");
  const std::vector<std::uint64_t> hashes = leave_alone(folder, scene, 480);
  write_file(folder / "scene.lua", "error 'changed'");
  std::filesystem::remove_all(folder.path / "parts");
  std::filesystem::remove(folder.path / "late.lua");
  Replay replay(player::read_recording(folder / "play.rec"), run_options(), sources::folder());
  CHECK(to_end(replay) == 480);
  CHECK(replay.mismatch() == "");
  CHECK(replay.scene().title() == name);
  CHECK(state_hash(replay.scene().world()) == hashes.back());
  REQUIRE(replay.remarks().size() == 1);
  CHECK_THAT(replay.remarks()[0],
             Contains("scene.lua has changed since the recording was made: what it was then is played"));
}

TEST_CASE("recording: a step that failed fails again, and what came after is done") {
  Folder folder;
  write_file(folder / "scene.lua",
             "local p = scene:particle{} scene:on('key', function() p.velocity = vec(0, 1, 0) error('oh') end)");
  std::uint64_t hash = 0;
  {
    RecordedPerson person(folder / "scene.lua", folder / "play.rec");
    for (int i = 0; i < 300; i++) person.step_alone(i == 100 || i == 250 ? "k" : "");
    hash = person.hash();
    person.finish();
  }
  Replay replay(player::read_recording(folder / "play.rec"), run_options(), sources::folder());
  std::vector<std::uint64_t> failed;
  while (replay.step())
    if (!replay.failure().empty()) failed.push_back(replay.tick());
  CHECK(failed == std::vector<std::uint64_t>{100, 249});
  CHECK(replay.mismatch() == "");
  CHECK(replay.tick() == 298);
  CHECK(state_hash(replay.scene().world()) == hash);
}

TEST_CASE("recording: what was refused is refused again") {
  Folder folder;
  write_file(folder / "scene.lua", R"(
    local p = scene:body{ mass = 1, inertia = vec(1, 1, 1) }
    scene:param("wind", 1, { on_change = function(w) p.velocity = vec(w, 0, 0) error("no") end }))");
  std::uint64_t hash = 0;
  {
    RecordedPerson person(folder / "scene.lua", folder / "play.rec");
    for (int i = 0; i < 300; i++) {
      if (i == 50) CHECK_THROWS_WITH(person.set("wind", 3), Contains("no"));
      if (i == 90) CHECK_THROWS_WITH(person.edit("mass", vec(1, 2, 3)), Contains("mass"));
      person.step_alone();
    }
    hash = person.hash();
    person.finish();
  }
  Replay replay(player::read_recording(folder / "play.rec"), run_options(), sources::folder());
  to_end(replay);
  CHECK(replay.mismatch() == "");
  CHECK(state_hash(replay.scene().world()) == hash);
}

TEST_CASE("recording: another version and what is none are told") {
  Folder folder;
  const player::RecordingHead head{"0.0.1", folder / "scene.lua", {}, {{folder / "scene.lua", "scene:particle{}"}}};
  { Recorder recorder(folder / "old.rec", head); }
  const Replay replay(player::read_recording(folder / "old.rec"), run_options(), sources::folder());
  REQUIRE(replay.remarks().size() == 1);
  CHECK_THAT(replay.remarks()[0], Contains("was made by pantin 0.0.1"));
  CHECK_THROWS_WITH(player::read_recording(folder / "nowhere"), Contains("there is no such file"));
  write_file(folder / "text", "hello\n");
  CHECK_THROWS_WITH(player::read_recording(folder / "text"), Contains("text:1: this is no recording"));
  REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0);
  CHECK_THROWS_WITH(player::read_recording(folder / "pipe"), Contains("no file that can be replayed"));
  write_file(folder / "next", "{\"pantin\":4}\n");
  CHECK_THROWS_WITH(player::read_recording(folder / "next"), Contains("it has the format 4"));
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
  c.other_thing = BodyId{3, 2};
  c.form = MadeForm::wheel;
  c.position = vec(0.1, 0.2, 0.3);
  c.amount = vec(1e-17, 0, -2);
  c.points = {vec(1, 2, 3), vec(1.0 / 7.0, 0, 0)};
  c.max_force = infinity;
  c.mass = 0.7;
  c.radius = 0.01;
  c.energy = -3;
  c.value = -1.0 / 3.0;
  c.name = "ü \"quoted\"";
  input.commands = {c};
  const player::RecordedAct act = player::act_of(player::line_of({12, input}));
  CHECK(act.tick == 12);
  const StepInput& read = std::get<StepInput>(act.what);
  CHECK(same(read.moves.at(0).position, input.moves[0].position));
  const Command& r = read.commands.at(0);
  CHECK((r.kind == c.kind && r.hand == 3 && r.point == c.point && r.other == c.other && r.thing == c.thing));
  CHECK((same(r.position, c.position) && same(r.amount, c.amount) && same(r.points.at(1), c.points[1])));
  CHECK(r.value == c.value);
  CHECK((r.max_force == c.max_force && r.mass == c.mass && r.radius == c.radius && r.energy == c.energy));
  CHECK((r.name == c.name && r.other_thing == c.other_thing && r.form == c.form));
}

TEST_CASE("recording: what was done between two steps comes back as that") {
  Command c;
  c.kind = Command::Kind::remove;
  c.thing = BodyId{3, 2};
  const player::RecordedAct act = player::act_of(player::line_of({12, player::DoneAtOnce{{c, c}}}));
  const auto& done = std::get<player::DoneAtOnce>(act.what);
  REQUIRE(done.commands.size() == 2);
  CHECK((done.commands[1].kind == c.kind && done.commands[1].thing == c.thing));
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
  CHECK_THAT(good.err, Contains(" steps, to ") && Contains("all as recorded"));
  const Finished held = use({"replay", "play.rec", "--headless", "--untrusted"});
  CHECK(held.code == 0);
  CHECK(held.err == good.err);
  const std::string whole = read_file(folder / "play.rec");
  write_file(folder / "cut.rec", whole.substr(0, whole.rfind('\n', whole.size() - 2) + 1));
  const Finished cut = use({"replay", "cut.rec", "--headless"});
  CHECK(cut.code == 1);
  CHECK_THAT(cut.err, Contains("cut.rec: it has no end") && Contains("all as recorded"));
  const Finished none = use({"replay", "scene.lua"});
  CHECK(none.code == 1);
  CHECK_THAT(none.err, Contains("scene.lua:1: this is no recording"));
}

TEST_CASE("recording: texts come back to the byte, whether they are UTF-8 or not") {
  const std::string name = "\xff \xc3\xa9 \xe2\x86\x92";
  const player::RecordingHead head{"0.1", name, {{name, name}}, {{name, name}}, {{name, name}}};
  const player::RecordingHead head_again = player::head_of(player::line_of(head));
  CHECK((head_again.scene == name && head_again.set == head.set && head_again.files == head.files));
  CHECK(head_again.saved == head.saved);
  const auto again = [](const auto& what) {
    return std::get<std::decay_t<decltype(what)>>(player::act_of(player::line_of({1, what})).what);
  };
  Command command;
  command.name = name;
  CHECK(again(player::DoneAtOnce{{command}}).commands.at(0).name == name);
  const auto change = again(player::ParameterChange{name, name});
  CHECK((change.name == name && change.value == SceneValue(name)));
  const auto edit = again(player::FieldEdit{BodyId{1, 1}, name, name});
  CHECK((edit.field == name && std::get<std::string>(edit.value) == name));
}

TEST_CASE("recording: where a whole number belongs no other is taken") {
  for (const char* number : {"1e300", "1.5", "-1", "true", "\"1\"", "18446744073709551616", "null"}) {
    INFO(number);
    CHECK_THROWS(player::act_of(text("{\"tick\":", number, ",\"end\":true}")));
    CHECK_THROWS(player::act_of(text("{\"tick\":1,\"keep\":", number, "}")));
    CHECK_THROWS(
        player::act_of(text("{\"tick\":1,\"edit\":[\"body\",", number, ",1],\"field\":\"mass\",\"value\":1}")));
  }
  for (const char* number : {"1e300", "1.5", "4294967296", "true"})
    CHECK_THROWS(player::act_of(text("{\"tick\":1,\"moves\":[[", number, ",0,0,0,true]]}")));
  Folder folder;
  play(folder, 2);
  std::string content = read_file(folder / "play.rec");
  const std::string tick = "{\"tick\":240,";
  content.replace(content.find(tick), tick.size(), "{\"tick\":1e300,");
  write_file(folder / "odd.rec", content);
  CHECK_THAT(player::read_recording(folder / "odd.rec").damage, Contains("odd.rec:") && Contains("no whole number"));
}

TEST_CASE("recording: files that it names are read only where they may be what they were") {
  Folder folder;
  write_file(folder / "scene.lua", "scene:particle{}");
  write_file(folder / "huge", "");
  std::filesystem::resize_file(folder / "huge", std::uintmax_t{1} << 40);  // of nothing, but more than any memory
  const player::RecordingHead head{player::program_version(),
                                   folder / "scene.lua",
                                   {},
                                   {{folder / "scene.lua", "scene:particle{}"},
                                    {folder / "huge", "x"},
                                    {"/proc/kmsg", ""},  // which waits for what is to come
                                    {"/dev/zero", "x"}}};
  { Recorder recorder(folder / "play.rec", head); }
  const Replay replay(player::read_recording(folder / "play.rec"), run_options(), sources::folder());
  REQUIRE(replay.remarks().size() == 1);
  CHECK_THAT(replay.remarks()[0], Contains("huge has changed"));
}
