// What the player does when a file was saved, and what it tells a recording.
#include "player/message.hpp"
#include "player/player.hpp"

namespace pantin::player {
void Player::begin_recording() {
  if (path_.ends_with(state_ending))
    complain("what goes on from a state is not recorded");
  else
    record(options_.record);
}

std::string Player::recorded_path(const std::string& path) const { return path_as_recorded(path, scene_options_.home); }

void Player::record(const std::string& path) {
  RecordingHead head{program_version(), recorded_path(path_), scene_options_.set, {}, lasting_->written()};
  for (const auto& [file, content] : reload_.files()) head.files[recorded_path(file)] = content;
  recorder_ = std::make_unique<Recorder>(path, std::move(head));
  reload_.on_read = [this](const FileRead& file) {
    if (recorder_) recorder_->file(recorded_path(file.path), file.content);
  };
  undo_.on_state = [this](std::uint64_t number, bool put_back) {
    if (recorder_) put_back ? recorder_->restored(number) : recorder_->kept(number);
  };
}

void Player::stop_recording(const std::string& why) {
  if (!recorder_) return;
  complain("the recording ends here: " + why);
  try {
    end_recording();
  } catch (const Error& error) { complain(error.what()); }
}

void Player::end_recording() {
  if (recorder_) recorder_->finish();
  recorder_.reset();
}

void Player::reload() {
  std::optional<Reloaded> reloaded = reload_.look(*scene_, path_, scene_options_);
  if (!reloaded) return;
  if (!reloaded->scene) return complain(reloaded->error);
  if (loses_by("reload")) replace("reload", "the scene goes on with the saved file");
  if (recorder_) recorder_->gone_on();
  const CarriedOver& carried = reloaded->carried;
  waiting_ = carried_over(waiting_, carried);
  hands_.carry_over(carried.hands, [&](PointId point) {
    const auto found = carried.things.find(point);
    return found == carried.things.end() ? PointId{} : std::get<PointId>(found->second);
  });
  const auto chosen = carried.things.find(chosen_);
  chosen_ = chosen == carried.things.end() ? AnyId{} : chosen->second;
  scene_ = std::move(reloaded->scene);
  note_opened();
  acted_ = false;
  changes_++;
  log_read_ = scene_->world().log.size();
  follower_ = {};
  times_ = {};
  failure_.clear();
  complained_ = {};
  renderer_.open(scene_->world());
  window_.set_title(title() + " - Pantin");
  status_.note("the file was saved: the scene goes on with it");
}

}  // namespace pantin::player
