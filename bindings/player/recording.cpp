#include "player/recording.hpp"

#include <cmath>
#include <filesystem>
#include <utility>

#include "measure/measure.hpp"

namespace fs = std::filesystem;

namespace pantin::player {

/// Between two lines: a recording has one each second, of steps of 10 ns at least.
constexpr std::uint64_t most_ticks = 100'000'000;

std::string program_version() { return PANTIN_VERSION; }

std::string path_as_recorded(const std::string& path, const std::string& home) {
  const auto whole = [](const std::string& name) { return fs::absolute(name).lexically_normal(); };
  const fs::path below = whole(path).lexically_relative(whole(home));
  const bool comes_along = !below.empty() && *below.begin() != "..";
  return comes_along ? "pantin:/" + below.string() : whole(path).string();
}

Recording read_recording(const std::string& path) {
  std::error_code unknown;
  require(!fs::exists(path, unknown) || fs::is_regular_file(path, unknown), path,
          ": this is no file that can be replayed");
  std::ifstream file(path, std::ios::binary);
  require(static_cast<bool>(file), path, ": there is no such file, or it cannot be read");
  Recording recording;
  std::string line;
  std::getline(file, line);
  try {
    recording.head = head_of(line);
  } catch (const std::exception& error) {
    throw Error(text(path, ":1: this is no recording that can be replayed: ", error.what()));
  }
  bool ended = false;
  for (int number = 2; std::getline(file, line); number++) {
    RecordedAct act;
    try {
      require(!file.eof(), "it is cut off in the middle");
      act = act_of(line);
      require(recording.acts.empty() || act.tick >= recording.acts.back().tick, "its tick, ", act.tick,
              ", is before that of the line above");
      const std::uint64_t last = recording.acts.empty() ? 0 : recording.acts.back().tick;
      require(act.tick - last <= most_ticks, "its tick, ", act.tick, ", is too far from that of the line above");
    } catch (const std::exception& error) {
      recording.damage = text(path, ":", number, ": ", error.what());
      return recording;
    }
    recording.ticks = act.tick + (std::holds_alternative<StepInput>(act.what) ? 1 : 0);
    ended = std::holds_alternative<RecordingEnd>(act.what);
    recording.acts.push_back(std::move(act));
  }
  if (!ended) recording.damage = text(path, ": it has no end: the program that wrote it was stopped");
  return recording;
}

Recorder::Recorder(const std::string& path, RecordingHead head) : path_(path) {
  const std::string first = line_of(head);
  file_.open(path, std::ios::binary);
  require(static_cast<bool>(file_), path, ": this file cannot be written");
  file_ << first << '\n' << std::flush;
  contents_ = std::move(head.files);
}

Recorder::~Recorder() {
  try {
    finish();
  } catch (const Error&) {}  // it was called before where somebody listens
}

void Recorder::write(const RecordedAct& act) { file_ << player::line_of(act) << '\n'; }

void Recorder::input(const StepInput& input) {
  if (!input.moves.empty() || !input.commands.empty()) write({tick_, input});
}

void Recorder::done_at_once(const std::vector<Command>& commands) { write({tick_, DoneAtOnce{commands}}); }

void Recorder::stepped(const World& world) {
  tick_++;
  const double second = std::floor(world.time + 0.5 * world.settings.step);
  if (second == second_) return;
  second_ = second;
  write({tick_, StateCheck{world.time, state_hash(world)}});
  file_.flush();
}

void Recorder::failed() { write({tick_, StepFailed{}}); }
void Recorder::hand_came() { write({tick_, HandCame{}}); }
void Recorder::parameter(const std::string& name, const SceneValue& value) {
  write({tick_, ParameterChange{name, value}});
}
void Recorder::edited(const FieldEdit& edit) { write({tick_, edit}); }
void Recorder::kept(std::uint64_t number) { write({tick_, StateKept{number}}); }
void Recorder::restored(std::uint64_t number) { write({tick_, StateRestored{number}}); }
void Recorder::restarted() {
  second_ = 0.0;
  write({tick_, Restarted{}});
}

void Recorder::opened(SceneOpened scene) {
  second_ = 0.0;
  write({tick_, std::move(scene)});
}

void Recorder::file(const std::string& path, const std::string& content) {
  const auto [told, is_new] = contents_.try_emplace(path, content);
  if (!is_new && told->second == content) return;
  told->second = content;
  write({tick_, FileFound{path, content}});
}

void Recorder::gone_on() { write({tick_, GoneOn{}}); }

void Recorder::finish() {
  if (std::exchange(finished_, true)) return;
  write({tick_, RecordingEnd{}});
  file_.close();
  require(static_cast<bool>(file_), path_, ": the recording could not be written to its end; is the disk full?");
}

}  // namespace pantin::player
