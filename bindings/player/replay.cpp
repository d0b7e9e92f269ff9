#include "player/replay.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lua/inspect.hpp"
#include "player/home.hpp"
#include "player/interrupt.hpp"
#include "player/message.hpp"
#include "player/progress.hpp"
#include "world/measure.hpp"

namespace pantin::player {
namespace {

constexpr std::size_t most_places = 120;

std::string text_of(const lua::Value& value) {
  if (const auto* number = std::get_if<double>(&value)) return to_text(*number);
  if (const auto* boolean = std::get_if<bool>(&value)) return *boolean ? "true" : "false";
  return std::get<std::string>(value);
}

}  // namespace

Replay::Replay(Recording recording, const RunOptions& options, std::string home)
    : recording_(std::move(recording)), options_(options), home_(std::move(home)) {
  for (const RecordedAct& act : recording_.acts)
    if (const auto* restored = std::get_if<StateRestored>(&act.what)) needed_.insert(restored->number);
  go_to_start();
  compare_files();
  if (recording_.head.version != program_version())
    remarks_.push_back(text("the recording was made by pantin ", recording_.head.version, ", and this is ",
                            program_version(), ": it may part from it"));
  if (!recording_.damage.empty()) remarks_.push_back(recording_.damage + "; what there is by then is played");
  spacing_ = std::max<std::uint64_t>(1, static_cast<std::uint64_t>(1.0 / scene_->world().settings.step));
}

Replay::~Replay() = default;

void Replay::open() {
  places_.clear();
  kept_.clear();
  files_.clear();
  scene_options_.on_read = [this](const lua::FileRead& file) { files_[file.path] = file.hash; };
  scene_ = lua::Scene::open(find_scene(recording_.head.scene, home_), scene_options_);
  checked_time_ = 0.0;
}

void Replay::go_to_start() {
  scene_options_ = lua_options(options_, home_);
  scene_options_.set = recording_.head.set;
  open();
  tick_ = opened_ = 0;
  next_ = 0;
}

void Replay::compare_files() {
  for (const auto& [path, hash] : recording_.head.files) {
    const auto found = files_.find(path);
    if (found == files_.end())
      remarks_.push_back(text(path, " was read by the recorded scene, and is not read now: the replay may part"));
    else if (found->second != hash)
      remarks_.push_back(text(path, " has changed since the recording was made: the replay may part from it"));
  }
}

void Replay::check(const StateCheck& check) {
  if (state_hash(scene_->world()) == check.hash)
    checked_++;
  else if (mismatch_.empty())
    mismatch_ = text("the replay parts from the recording between ", checked_time_, " s and ", check.time, " s");
  checked_time_ = check.time;
}

void Replay::change(const ParameterChange& change) {
  scene_options_.set[change.name] = text_of(change.value);
  if (!scene_->set_parameter(change.name, change.value)) {
    open();
    opened_++;
  }
}

void Replay::act(const RecordedAct& act) {
  if (const auto* input = std::get_if<StepInput>(&act.what)) scene_->world().input = *input;
  if (const auto* to = std::get_if<ParameterChange>(&act.what)) change(*to);
  if (const auto* edited = std::get_if<FieldEdit>(&act.what)) {
    lua::FieldReading value{edited->field.c_str(), "", "", true, {}, {}};
    std::visit([&](const auto& plain) { value.value = plain; }, edited->value);
    lua::write_field(*scene_, edited->thing, edited->field, value);
  }
  if (const auto* known = std::get_if<StateCheck>(&act.what)) check(*known);
  if (const auto* kept = std::get_if<StateKept>(&act.what); kept && needed_.contains(kept->number))
    kept_[kept->number] = scene_->take_snapshot();
  if (const auto* restored = std::get_if<StateRestored>(&act.what)) {
    const auto found = kept_.find(restored->number);
    require(found != kept_.end(), "replay: the recording goes back to state ", restored->number,
            ", which it has not kept");
    scene_->restore(*found->second);
  }
  if (std::holds_alternative<Restarted>(act.what)) {
    open();
    opened_++;
  }
}

void Replay::keep_place() {
  if (tick_ % spacing_ != 0 || (!places_.empty() && places_.back().tick >= tick_)) return;
  if (!scene_->why_not_restore().empty()) return;
  places_.push_back({tick_, next_, opened_, checked_time_, scene_->take_snapshot()});
  if (places_.size() <= most_places) return;
  spacing_ *= 2;
  std::erase_if(places_, [&](const Place& place) { return place.tick % spacing_ != 0; });
}

bool Replay::step() {
  while (next_ < recording_.acts.size() && recording_.acts[next_].tick <= tick_) act(recording_.acts[next_++]);
  if (tick_ >= recording_.ticks) return false;
  keep_place();
  try {
    scene_->step();
    require(scene_->world().failure.empty(), scene_->world().failure);
  } catch (const Error&) {
    // It failed when it was recorded, too, if the recording goes on at the same step.
    if (next_ < recording_.acts.size() && recording_.acts[next_].tick == tick_) return true;
    throw;
  }
  tick_++;
  return true;
}

bool Replay::go_to(std::uint64_t tick, std::uint64_t most) {
  tick = std::min(tick, recording_.ticks);
  if (tick < tick_) {
    const auto after = std::find_if(places_.begin(), places_.end(), [&](const Place& p) { return p.tick > tick; });
    if (after == places_.begin() || !scene_->why_not_restore().empty()) {
      go_to_start();
    } else {
      const Place& place = *(after - 1);
      scene_->restore(*place.state);
      tick_ = place.tick;
      next_ = place.act;
      checked_time_ = place.checked_time;
    }
  }
  while (tick_ < tick && most-- > 0)
    if (!step()) return true;
  return tick_ >= tick;
}

int replay(const RunOptions& options, const std::string& file, const std::string& home) {
  Interrupt interrupt;
  Replay replay(read_recording(file), options, home);
  for (const std::string& remark : replay.remarks()) say(remark);
  const double step = replay.scene().world().settings.step;
  Progress progress(static_cast<double>(replay.ticks()) * step);
  bool told = false;
  const auto past = [&] { return options.until && replay.scene().world().time >= *options.until - 0.5 * step; };
  while (!Interrupt::asked() && !past() && replay.step()) {
    progress.show(static_cast<double>(replay.tick()) * step);
    if (!told && !replay.mismatch().empty()) {
      say(replay.mismatch());
      told = true;
    }
  }
  if (!told && !replay.mismatch().empty()) say(replay.mismatch());
  say(text("replayed ", replay.tick(), " of ", replay.ticks(), " steps, to ", replay.scene().world().time,
           " s: ", replay.checked(), replay.mismatch().empty() ? " hashes, all as recorded" : " hashes as recorded"));
  return replay.mismatch().empty() ? 0 : 1;
}

}  // namespace pantin::player
