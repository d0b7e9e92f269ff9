#include "player/replay.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <utility>

#include "choreography/commands.hpp"
#include "choreography/hands.hpp"
#include "fields/property.hpp"
#include "lua/scene/open.hpp"
#include "measure/measure.hpp"
#include "scene/files.hpp"

namespace pantin::player {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double shortest_interval = 0.02;  // [s] of computing between places
constexpr double interval_to_cost = 20.0;   // of places

constexpr std::size_t most_kept = 100, fewest_places = 8;
constexpr std::size_t most_points = 40000;  // in all of them, of some 5 kB each

constexpr const char* home_as_recorded = "pantin:";

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

}  // namespace

Replay::Replay(Recording recording, const RunOptions& options, const std::string& home)
    : recording_(std::move(recording)), options_(scene_options(options, home_as_recorded)), seen_(!options.headless) {
  for (const RecordedAct& act : recording_.acts)
    if (const auto* restored = std::get_if<StateRestored>(&act.what)) needed_.insert(restored->number);
  options_.changing = true;
  options_.save = [](const std::string&, const std::string&) {};  // it was written when it was recorded
  options_.read = [this](const std::string& path, std::size_t) -> std::optional<std::string> {
    const auto found = contents_->find(std::filesystem::path(path).lexically_normal());
    if (found == contents_->end()) return {};
    return found->second;
  };
  start();
  look_at_files(home);
  if (recording_.head.version != program_version())
    remarks_.push_back(text("the recording was made by pantin ", recording_.head.version, ", and this is ",
                            program_version(), ": it may part from it"));
  if (!recording_.damage.empty()) remarks_.push_back(recording_.damage + "; what there is by then is played");
}

Replay::~Replay() = default;

void Replay::find_stretches() {
  stretches_ = {{0, 0.0, scene_->world().settings.step}};
  for (const RecordedAct& act : recording_.acts)
    if (const auto* opened = std::get_if<SceneOpened>(&act.what))
      stretches_.push_back({act.tick, time_at(act.tick), opened->step});
}

double Replay::time_at(std::uint64_t tick) const {
  const auto after = std::ranges::upper_bound(stretches_, tick, {}, &Stretch::tick);
  const Stretch& s = *std::prev(after);
  return s.time + static_cast<double>(tick - s.tick) * s.step;
}

std::uint64_t Replay::tick_at(double time) const {
  const auto after = std::ranges::upper_bound(stretches_, std::max(time, 0.0), {}, &Stretch::time);
  const Stretch& s = *std::prev(after);
  return s.tick + static_cast<std::uint64_t>(std::llround((std::max(time, 0.0) - s.time) / s.step));
}

void Replay::start() {
  contents_ = std::make_shared<const std::map<std::string, std::string>>(recording_.head.files);
  open_other({recording_.head.scene, recording_.head.set, recording_.head.saved});
  place_ = 0;
  earlier_ = 0.0;
  if (stretches_.empty()) find_stretches();
  tick_ = 0;
  next_ = 0;
  astray_ = false;
  failure_.clear();
  const std::uint64_t hash = state_hash(scene_->world());
  if (hashes_.empty()) hashes_.push_back(hash);
  if (ticks() == 0) do_last();
}

void Replay::open_other(const SceneOpened& opened) {
  if (scene_) earlier_ += scene_->world().time;
  path_ = opened.scene;
  options_.set = opened.set;
  options_.saved = std::make_shared<SavedValues>(opened.saved);
  options_.forgiving = false;
  kept_.clear();
  place_++;
  open();
}

void Replay::open() {
  adopt(lua::open_scene(path_, options_));
  options_.forgiving = true;
  straight_ = true;
  since_position_ = shortest_interval;
}

void Replay::go_on() {
  std::unique_ptr<Scene> fresh = lua::open_scene(path_, options_);
  fresh->go_on_from(*scene_);
  adopt(std::move(fresh));
}

void Replay::adopt(std::shared_ptr<Scene> fresh) {
  positions_.clear();  // snapshots must not outlive their scene
  scene_ = std::move(fresh);
  openings_++;
}

void Replay::look_at_files(const std::string& home) {
  for (const auto& [path, content] : recording_.head.files) {
    const bool comes_along = path.starts_with(home_as_recorded);
    const std::string file = comes_along ? home + path.substr(std::string(home_as_recorded).size()) : path;
    if (holds_other(file, content))
      remarks_.push_back(text(file, " has changed since the recording was made: what it was then is played"));
  }
}

void Replay::check(const StateCheck& check) {
  if (next_ <= judged_) return;
  if (state_hash(scene_->world()) == check.hash) {
    checked_++;
    if (mismatch_.empty()) agreed_ = tick_;
  } else if (!straight_) {
    astray_ = true;
    return;
  } else if (mismatch_.empty()) {
    mismatch_ = text("the replay parts from the recording between ", time_at(agreed_), " s and ", time(), " s");
  }
  judged_ = next_;
}

/// What was refused when it was recorded is refused again.
void Replay::change(const ParameterChange& change) {
  const auto before = options_.set;
  options_.set[change.name] = setting_text(change.value);
  try {
    if (!scene_->set_parameter(change.name, change.value)) open();
  } catch (const Error&) { options_.set = before; }
}

void Replay::edit(const FieldEdit& edit) {
  try {
    fields::write(scene_->world(), edit.thing, edit.field, edit.value);
  } catch (const Error&) {}  // as when it was recorded
}

void Replay::find(const FileFound& file) {
  std::map<std::string, std::string> changed = *contents_;
  changed[file.path] = file.content;
  contents_ = std::make_shared<const std::map<std::string, std::string>>(std::move(changed));
}

void Replay::keep(const StateKept& kept) {
  if (!needed_.contains(kept.number)) return;
  Kept& state = kept_[kept.number];
  state = {scene_, nullptr};
  try {
    state.state = scene_->take_snapshot();
  } catch (const Error&) {}  // what cannot be kept was gone back to as a whole
}

void Replay::put_back(const StateRestored& restored) {
  const auto found = kept_.find(restored.number);
  require(found != kept_.end(), "replay: the recording goes back to state ", restored.number,
          ", which it has not kept");
  const Kept& kept = found->second;
  if (kept.scene != scene_)
    adopt(kept.scene);
  else
    scene_->restore(*kept.state);
  take_parameters(*scene_, options_.set);
}

void Replay::do_act(const RecordedAct& act) {
  if (const auto* input = std::get_if<StepInput>(&act.what)) scene_->world().input = *input;
  if (const auto* done = std::get_if<DoneAtOnce>(&act.what)) carry_out(scene_->world(), done->commands);
  if (std::holds_alternative<HandCame>(act.what)) add_hand(scene_->world());
  if (const auto* to = std::get_if<ParameterChange>(&act.what)) change(*to);
  if (const auto* edited = std::get_if<FieldEdit>(&act.what)) edit(*edited);
  if (const auto* known = std::get_if<StateCheck>(&act.what)) check(*known);
  if (const auto* kept = std::get_if<StateKept>(&act.what)) keep(*kept);
  if (const auto* restored = std::get_if<StateRestored>(&act.what)) put_back(*restored);
  if (const auto* file = std::get_if<FileFound>(&act.what)) find(*file);
  if (std::holds_alternative<GoneOn>(act.what)) go_on();
  if (std::holds_alternative<Restarted>(act.what)) open();
  if (const auto* opened = std::get_if<SceneOpened>(&act.what)) open_other(*opened);
}

/// Does what was done before the coming step. True where that is said to fail.
bool Replay::act() {
  while (!astray_ && next_ < recording_.acts.size() && recording_.acts[next_].tick <= tick_) {
    const RecordedAct& next = recording_.acts[next_++];
    if (std::holds_alternative<StepFailed>(next.what)) return true;
    do_act(next);
  }
  return false;
}

bool Replay::step() {
  keep_place();
  const auto begin = Clock::now();
  const bool fails = act();
  if (astray_) return compare(), true;
  if (!fails && tick_ >= ticks()) return false;
  failure_.clear();
  try {
    scene_->step();
    failure_ = scene_->world().failure;
  } catch (const Error& error) { failure_ = error.what(); }
  since_position_ += seconds_since(begin);
  if (fails && failure_.empty() && mismatch_.empty())
    mismatch_ = text("the replay parts from the recording at ", time(), " s: the recorded step failed there");
  if (fails) return true;
  if (!failure_.empty()) throw Error(std::exchange(failure_, {}));
  tick_++;
  compare();
  if (tick_ >= ticks()) do_last();
  return true;
}

/// What was done after the last step, as somebody who builds while it is paused does.
void Replay::do_last() {
  while (next_ < recording_.acts.size() && !std::holds_alternative<StepFailed>(recording_.acts[next_].what))
    do_act(recording_.acts[next_++]);
}

/// What a script keeps in its variables does not come back with a snapshot. Where that shows, all is done from the start, as
/// it was the first time; from then on always.
void Replay::compare() {
  if (!astray_) {
    const std::uint64_t hash = state_hash(scene_->world());
    if (tick_ >= hashes_.size())
      hashes_.push_back(hash);
    else if (straight_)
      hashes_[tick_] = hash;
    else
      astray_ = hashes_[tick_] != hash;
  }
  if (!astray_) return;
  exact_ = false;
  start();
}

void Replay::keep_place() {
  if (!seen_ || !exact_ || since_position_ < std::max(shortest_interval, interval_to_cost * place_cost_)) return;
  if (!scene_->why_not_restore().empty()) return;
  const auto begin = Clock::now();
  const std::size_t points = scene_->world().points.size();
  positions_.keep({tick_, next_, options_.set, contents_, scene_->take_snapshot()},
                  std::clamp(most_points / (points + 1), fewest_places, most_kept));
  place_cost_ = seconds_since(begin);
  since_position_ = 0.0;
}

/// To the best place for a tick, if there is a better one than the present.
void Replay::jump(std::uint64_t tick) {
  const KeptPosition* place = exact_ && scene_->why_not_restore().empty() ? positions_.before(tick) : nullptr;
  if (place && tick >= tick_ && place->tick <= tick_) return;
  if (!place) {
    if (tick < tick_) start();
    return;
  }
  try {
    scene_->restore(*place->state);
  } catch (const Error&) {  // the script would not have it
    exact_ = false;
    return start();
  }
  tick_ = place->tick;
  next_ = place->act;
  options_.set = place->set;
  contents_ = place->contents;
  straight_ = false;
  since_position_ = 0.0;
}

bool Replay::go_to(std::uint64_t tick, std::uint64_t most) {
  tick = std::min(tick, ticks());
  jump(tick);
  while (tick_ < tick && most-- > 0)
    if (!step()) return true;
  return tick_ >= tick;
}

}  // namespace pantin::player
