#pragma once
// Somebody who plays with both hands and all tools while it is recorded, from a fixed series of numbers.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "choreography/commands.hpp"
#include "choreography/hands.hpp"
#include "fields/property.hpp"
#include "measure/measure.hpp"
#include "measure/query.hpp"
#include "player/recording.hpp"
#include "player/reload.hpp"
#include "player/replay.hpp"
#include "player/undo.hpp"
#include "support/process.hpp"
#include "support/sources.hpp"

namespace pantin {

class RecordedPerson {
 public:
  /// `record` is written; parts of a second in which each thing is done. `set` is as on the command line.
  RecordedPerson(const std::string& scene_path, const std::string& record, std::uint64_t seed = 7,
                 const std::map<std::string, std::string>& set = {})
      : path_(scene_path), state_(seed) {
    options_.set = set;
    options_.home = sources::folder();
    scene_ = reload_.open(path_, options_);
    const auto named = [this](const std::string& file) { return player::path_as_recorded(file, options_.home); };
    player::RecordingHead head{player::program_version(), named(path_), set, {}};
    for (const auto& [file, content] : reload_.files()) head.files[named(file)] = content;
    recorder_ = std::make_unique<player::Recorder>(record, head);
    reload_.on_read = [this, named](const FileRead& file) { recorder_->file(named(file.path), file.content); };
    undo_.on_state = [this](std::uint64_t number, bool put_back) {
      put_back ? recorder_->restored(number) : recorder_->kept(number);
    };
    const Bounds box = bounds(world(), everything(world()));
    middle_ = 0.5 * (box.low + box.high);
    reach_ = 0.6 * norm(box.high - box.low);
  }

  World& world() { return scene_->world(); }
  Scene& scene() { return *scene_; }
  std::uint64_t hash() { return state_hash(world()); }

  void play(double seconds) {
    const auto steps = static_cast<int>(seconds / world().settings.step);
    for (int i = 0; i < steps; i++) {
      if (world().bodies.size() + world().particles.size() < 3) restart();
      step();
    }
  }
  void step() {
    const double t = 0.004 * static_cast<double>(done_++);
    StepInput input;
    for (std::int32_t hand = 0; hand < 2; hand++) {
      const double phase = 1.7 * hand;
      input.moves.push_back(
          {hand, middle_ + reach_ * vec(std::sin(0.9 * t + phase), std::cos(1.3 * t + phase), 0.1 * std::sin(0.3 * t)),
           true});
    }
    if (chance(0.02)) {
      undo_.begin(scene_, times_, input, "act");
      input.commands.push_back(command());
    }
    if (done_ % 173 == 0) do_at_once();
    if (!take(input)) return;
    if (chance(0.002)) go_back(false);
    if (chance(0.002)) go_back(true);
  }
  /// As while it is paused.
  void do_at_once() {
    Command made;
    made.kind = Command::Kind::make;
    made.position = middle_ + reach_ * vec(0.5, 0.001 * static_cast<double>(done_), 0);
    made.points = {zero3()};
    made.mass = 0.5;
    made.radius = 0.05;
    recorder_->done_at_once({made});
    carry_out(world(), std::vector{made});
  }
  /// A step in which at most a key is pressed.
  void step_alone(const std::string& key = "") {
    StepInput input;
    Command command;
    command.name = key;
    if (!key.empty()) input.commands.push_back(command);
    take(input);
  }
  void go_back(bool again) {
    std::string told;
    StepInput waiting;  // is lost: hands move on
    again ? undo_.redo(scene_, times_, waiting, told) : undo_.undo(scene_, times_, waiting, told);
    take_parameters(*scene_, options_.set);
  }
  void restart() {
    undo_.replace(scene_, times_, {}, "restart");
    scene_ = reload_.open(path_, options_);
    recorder_->restarted();
  }
  /// Another scene, as one opens it that is over.
  void open(const std::string& path, const std::map<std::string, std::string>& set) {
    undo_.clear();
    path_ = path;
    options_.set = set;
    scene_ = reload_.open(path_, options_, true);
    recorder_->opened({player::path_as_recorded(path_, options_.home), set, {}, world().settings.step});
  }
  void set(const std::string& name, double value) {
    options_.set[name] = to_text(value);
    const auto& parameters = scene_->parameters();
    const bool live = std::ranges::find(parameters, name, &SceneParameter::name)->live;
    if (!live) undo_.replace(scene_, times_, {}, "change");
    recorder_->parameter(name, value);
    if (live)
      scene_->set_parameter(name, value);
    else
      scene_ = reload_.open(path_, options_);
  }
  /// Saves a file of the scene, which goes on with it.
  void save(const std::string& text) {
    support::write_file(path_, text);
    const auto now = std::filesystem::file_time_type::clock::now();
    std::filesystem::last_write_time(path_, now + std::chrono::seconds(++saved_));
    for (int i = 0; i < 4; i++) {
      clock_ += std::chrono::milliseconds(60);
      std::optional<player::Reloaded> seen = reload_.look(*scene_, path_, options_, clock_);
      if (!seen) continue;
      REQUIRE(seen->error == "");
      undo_.clear();
      scene_ = std::move(seen->scene);
      return recorder_->gone_on();
    }
    FAIL("the file was not seen");
  }
  void edit(const std::string& field, Vec3 value) {
    const player::FieldEdit edited{world().bodies.ids().front(), field, value};
    recorder_->edited(edited);
    fields::write(world(), edited.thing, field, edited.value);
  }
  void hand_comes() {
    recorder_->hand_came();
    add_hand(world());
  }
  void finish() { recorder_->finish(); }

 private:
  /// False where the step failed; the scene starts again then.
  bool take(const StepInput& input) {
    recorder_->input(input);
    world().input = input;
    std::string failure;
    try {
      scene_->step();
      failure = world().failure;
    } catch (const Error& error) { failure = error.what(); }
    if (failure.empty()) return recorder_->stepped(world()), true;
    recorder_->failed();
    restart();
    return false;
  }
  double number() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state_ >> 11) * 0x1p-53;
  }
  bool chance(double part) { return number() < part; }
  std::size_t below(std::size_t n) {
    return std::min(n - 1, static_cast<std::size_t>(number() * static_cast<double>(n)));
  }

  AnyId any_thing() {
    const std::vector<ParticleId> particles = world().particles.ids();
    const std::vector<ConnectionId> connections = world().connections.ids();
    if (!connections.empty() && chance(0.5)) return connections[below(connections.size())];
    if (!particles.empty()) return particles[below(particles.size())];
    return {};
  }
  Command command() {
    const std::vector<PointId> points = world().points.ids();
    Command c;
    c.kind = static_cast<Command::Kind>(below(command_names.size()));
    c.hand = static_cast<std::int32_t>(below(2));
    c.name = "k";
    c.point = points[below(points.size())];
    c.other = points[below(points.size())];
    c.thing = any_thing();
    c.position = middle_ + reach_ * vec(number() - 0.5, number() - 0.5, 0);
    c.amount = 0.3 * vec(number() - 0.5, number() - 0.5, number() - 0.5);
    if (c.kind == Command::Kind::make) {
      c.points = {zero3(), vec(0.5, 0, 0)};
      c.mass = 0.5;
      c.point = c.other = {};
      if (!world().shapes.empty()) c.form = static_cast<MadeForm>(below(form_names.size() - 2));
    }
    if (c.kind == Command::Kind::tie) {
      c.points = {c.position};
      c.name = std::array{"rod", "rope", "spring"}[below(3)];
    }
    c.radius = c.kind == Command::Kind::make ? 0.05 : 0.5;
    c.energy = 0.1;
    c.value = c.kind == Command::Kind::control ? number() : 0.0;
    return c;
  }

  std::string path_;
  SceneOptions options_;
  player::Reload reload_;
  std::shared_ptr<Scene> scene_;
  std::unique_ptr<player::Recorder> recorder_;
  player::Undo undo_;
  player::Times times_;
  player::FileWatch::Clock::time_point clock_{};
  Vec3 middle_ = zero3();
  double reach_ = 1.0;
  std::uint64_t state_, done_ = 0;
  int saved_ = 0;
};

}  // namespace pantin
