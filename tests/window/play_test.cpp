// A real window on a virtual screen, and a real mouse: X events from the server, not pushed ones.
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdio>
#include <memory>
#include <sstream>
#include <thread>

#include "lua/scene/open.hpp"
#include "measure/query.hpp"
#include "player/aim.hpp"
#include "scene/scene.hpp"
#include "support/process.hpp"
#include "support/sources.hpp"
#include "view/stage.hpp"

using namespace pantin;
using namespace pantin::support;

namespace {

constexpr int width = 720, height = 404;
const std::string chain = sources::folder() + "/scripts/scenes/chain.lua", links = "6";

void pause(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

/// A screen that nobody sees.
class Screen {
 public:
  Screen() {
    int ends[2];
    REQUIRE(pipe(ends) == 0);
    server_ = std::make_unique<Process>(Process::Options{
        {"Xvfb", "-displayfd", std::to_string(ends[1]), "-screen", "0", "1280x720x24", "-nolisten", "tcp", "-noreset"},
        {},
        "",
        ends[1]});
    close(ends[1]);
    std::string number;
    for (char c = 0; read(ends[0], &c, 1) == 1 && c != '\n';) number += c;
    close(ends[0]);
    INFO(server_->err());
    REQUIRE_FALSE(number.empty());
    display = ":" + number;
  }
  std::string display;
  /// It goes away.
  void close_down() { server_.reset(); }

 private:
  std::unique_ptr<Process> server_;
};

/// `pantin play` of the chain on a screen, with what a hand can do to it.
class Play {
 public:
  Play(const Screen& screen, const Folder& folder, const std::string& until)
      : environment_({"DISPLAY=" + screen.display, "SDL_VIDEODRIVER", "WAYLAND_DISPLAY", "LIBGL_ALWAYS_SOFTWARE=1",
                      "PANTIN_HOME=" + sources::folder()}),
        process_(
            {{sources::program(), "play", "chain", "--set", "links=" + links, "--paused", "--until", until, "--out",
              "tip.csv", "--record", "play.rec", "--size", std::to_string(width) + "x" + std::to_string(height)},
             environment_,
             folder.path,
             -1}),
        record_(folder / "play.rec") {
    // It is called so once its scene is open; and a search fails, or finds what is gone at once, while windows come and go.
    const std::vector<std::string> search = {"xdotool", "search", "--onlyvisible", "--name",
                                             "^Virtual chain - Pantin$"};
    std::string before;
    for (int i = 0; i < 150 && window_.empty(); i++) {
      pause(0.2);
      const Finished found = finish({search, environment_, "", -1});
      const std::string window = found.out.substr(0, found.out.find('\n'));
      if (window == before) window_ = window;
      before = window;
    }
    INFO(process_.err());
    REQUIRE_FALSE(window_.empty());
    pause(0.5);  // until the first frame is drawn
  }

  void hand(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "xdotool");
    Finished done = finish({arguments, environment_, "", -1});
    INFO(done.err);
    REQUIRE(done.code == 0);
  }
  void move(double x, double y) {
    hand({"mousemove", "--window", window_, std::to_string(static_cast<int>(x)), std::to_string(static_cast<int>(y))});
  }
  /// Moves evenly for a second: by one command, since on a busy machine twenty may take longer than the scene is played.
  void drag(double from_x, double from_y, double to_x, double to_y) {
    std::vector<std::string> steps;
    for (int i = 1; i <= 20; i++) {
      const int x = static_cast<int>(from_x + i / 20.0 * (to_x - from_x)),
                y = static_cast<int>(from_y + i / 20.0 * (to_y - from_y));
      steps.insert(steps.end(),
                   {"mousemove", "--window", window_, std::to_string(x), std::to_string(y), "sleep", "0.05"});
    }
    hand(std::move(steps));
  }
  /// Until so many more seconds of the scene were played: the recording tells a hash after each.
  void wait_for_seconds(int seconds) {
    const int wanted = hashes() + seconds;
    for (int i = 0; i < 600 && hashes() < wanted; i++) pause(0.1);
    INFO(process_.err());
    REQUIRE(hashes() >= wanted);
  }
  void end(int wanted = 0) {
    std::optional<int> code = process_.wait(90.0);
    INFO(process_.err());
    REQUIRE(code == wanted);
  }

 private:
  int hashes() const {
    const std::string text = read_file(record_);
    int count = 0;
    for (std::size_t at = 0; (at = text.find("\"hash\"", at)) != text.npos; at++) count++;
    return count;
  }

  std::vector<std::string> environment_;
  Process process_;
  std::string record_;
  std::string window_;
};

/// Where the window shows a position of the scene at its start.
Projected pixel(const Scene& scene, Vec3 position) {
  Camera camera = player::aim(scene, find_stage(scene.world()), static_cast<double>(width) / height);
  std::optional<Projected> result = camera.project(position, width, height);
  REQUIRE(result);
  REQUIRE((result->x > 0 && result->x < width && result->y > 0 && result->y < height));
  return *result;
}

struct Row {
  double time, height;
};
std::vector<Row> read_tip(const Folder& folder) {
  std::istringstream table(read_file(folder / "tip.csv"));
  std::string line;
  std::getline(table, line);
  REQUIRE(line.starts_with("time,tip height"));
  std::vector<Row> rows;
  while (std::getline(table, line)) {
    Row row{};
    REQUIRE(std::sscanf(line.c_str(), "%lf,%lf", &row.time, &row.height) == 2);
    rows.push_back(row);
  }
  return rows;
}

double lowest(const std::vector<Row>& rows) {
  double result = rows.at(0).height;
  for (const Row& row : rows) result = std::min(result, row.height);
  return result;
}

bool can_play() {
  bool can = have_program("Xvfb") && have_program("xdotool");
  if (!can) WARN("Xvfb or xdotool is not installed: the window is not tested");
  return can;
}

std::unique_ptr<Scene> open_chain() {
  SceneOptions options;
  options.home = sources::folder();
  options.set["links"] = links;
  return lua::open_scene(chain, options);
}

/// The position of the chain's free end: the furthest from the nail.
Vec3 tip_place(const World& world) {
  Vec3 tip = zero3();
  for (ParticleId particle : particles(world))
    if (Vec3 at = position(world, particle); at[0] > tip[0]) tip = at;
  return tip;
}

}  // namespace

TEST_CASE("window: the chain's end is held by the mouse", "[window]") {
  if (!can_play()) return;
  Screen screen;
  Folder folder;
  std::unique_ptr<Scene> scene = open_chain();
  Vec3 tip = tip_place(scene->world());
  Projected start = pixel(*scene, tip);
  Projected end = pixel(*scene, tip + vec(-1, 0, 0));

  Play play(screen, folder, "2.5");
  play.move(start.x, start.y);
  play.hand({"mousedown", "1"});
  pause(0.2);
  play.hand({"key", "space"});
  play.drag(start.x, start.y, end.x, end.y);
  play.end();

  // Left alone, the end falls by most of the chain's length; held, it stays where the pointer is.
  std::vector<Row> held = read_tip(folder);
  REQUIRE(held.size() == 600);
  CHECK(held.back().time == Approx(2.5));
  CHECK(held.back().height == Approx(tip[1]).margin(1.0));
  CHECK(lowest(held) > tip[1] - 2.0);
  Finished alone =
      finish({{sources::program(), "run", "chain", "--set", "links=" + links, "--until", "2.5", "--out", "tip.csv"},
              {"PANTIN_HOME=" + sources::folder()},
              folder.path,
              -1});
  REQUIRE(alone.code == 0);
  CHECK(lowest(read_tip(folder)) < tip[1] - 5.0);
}

TEST_CASE("window: a hinge is cut under the pointer", "[window]") {
  if (!can_play()) return;
  Screen screen;
  Folder folder;
  std::unique_ptr<Scene> scene = open_chain();
  std::vector<ParticleId> joints = hinges(scene->world());
  REQUIRE_FALSE(joints.empty());
  Projected middle = pixel(*scene, position(scene->world(), joints[joints.size() / 2]));
  Vec3 tip = tip_place(scene->world());
  double length = tip[0];

  Play play(screen, folder, "2");
  play.move(middle.x, middle.y);
  pause(0.2);
  play.hand({"key", "x"});
  pause(0.2);
  play.hand({"key", "space"});
  play.end();
  // Falling freely for 2 s, 20 m, the end is below all that a whole chain could reach.
  CHECK(read_tip(folder).back().height < tip[1] - length - 5.0);
}

TEST_CASE("window: the cutting tool strokes through the chain", "[window]") {
  if (!can_play()) return;
  Screen screen;
  Folder folder;
  std::unique_ptr<Scene> scene = open_chain();
  std::vector<ParticleId> joints = hinges(scene->world());
  Projected middle = pixel(*scene, position(scene->world(), joints[joints.size() / 2]));
  Vec3 tip = tip_place(scene->world());

  Play play(screen, folder, "2");
  play.move(middle.x, middle.y + 60);  // keys go to the window under the pointer
  pause(0.2);
  play.hand({"key", "2"});
  pause(0.2);
  play.hand({"mousedown", "1"});
  for (int i = 1; i <= 3; i++) {
    play.move(middle.x, middle.y + 60 - 25 * i);
    pause(0.1);
  }
  play.hand({"mouseup", "1"});
  pause(0.2);
  double lowest_uncut = tip[1] - tip[0] - 5.0;
  SECTION("and it falls") {
    play.hand({"key", "space"});
    play.end();
    CHECK(read_tip(folder).back().height < lowest_uncut);
  }
  SECTION("and that is undone") {
    play.hand({"key", "ctrl+z"});
    pause(0.2);
    play.hand({"key", "space"});
    play.end();
    CHECK(lowest(read_tip(folder)) > lowest_uncut);
  }
}

TEST_CASE("window: a button answers to a quick click", "[window]") {
  if (!can_play()) return;
  Screen screen;
  Folder folder;
  std::unique_ptr<Scene> scene = open_chain();
  Vec3 tip = tip_place(scene->world());

  Play play(screen, folder, "2");
  play.move(50, 57);  // on "let go"
  pause(0.3);
  play.hand({"click", "1"});
  pause(0.3);
  play.hand({"key", "space"});
  play.end();
  CHECK(read_tip(folder).back().height < tip[1] - tip[0] - 5.0);
}

TEST_CASE("window: when its display goes away, what was asked for is written", "[window]") {
  if (!can_play()) return;
  Screen screen;
  Folder folder;
  Play play(screen, folder, "60");
  play.hand({"key", "space"});
  play.wait_for_seconds(1);
  screen.close_down();
  play.end(1);
  CHECK(read_tip(folder).size() > 5);
}

TEST_CASE("window: the scene is filmed from key to key", "[window]") {
  if (!can_play() || !have_program("ffmpeg") || !have_program("ffprobe")) return;
  Screen screen;
  Folder folder;
  Play play(screen, folder, "60");
  play.hand({"key", "space"});
  play.wait_for_seconds(1);
  play.hand({"key", "F9"});
  play.wait_for_seconds(2);
  play.hand({"key", "F9"});
  play.hand({"key", "q"});
  play.end();
  const Finished probed = finish({{"ffprobe", "-v", "error", "-count_frames", "-show_entries",
                                   "stream=width,height,nb_read_frames", "-of", "csv=p=0", folder / "pantin-0001.mp4"},
                                  {},
                                  "",
                                  -1});
  INFO(probed.out << probed.err);
  int w = 0, h = 0, frames = 0;
  REQUIRE(std::sscanf(probed.out.c_str(), "%d,%d,%d", &w, &h, &frames) == 3);
  CHECK((w == width && h == height));
  CHECK(frames > 10);
}
