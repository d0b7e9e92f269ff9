// `pantin replay FILE`.
#include "player/confine.hpp"
#include "player/interrupt.hpp"
#include "player/message.hpp"
#include "player/progress.hpp"
#include "player/replay.hpp"
#include "player/replay_window.hpp"
#include "scene/errors.hpp"

namespace pantin::player {
namespace {

int replay_in_window(const RunOptions& options, const std::string& file, const std::string& home) {
  Interrupt interrupt;
  ReplayWindow window(file, options, home);
  for (const std::string& remark : window.replay().remarks()) say(remark);
  while (window.frame()) {}
  if (window.display_lost()) say("the display went away: the replay ends here");
  const std::string& mismatch = window.replay().mismatch();
  if (!mismatch.empty()) say(mismatch);
  return mismatch.empty() && !window.replay().is_cut_off() && window.failure().empty() && !window.display_lost() ? 0
                                                                                                                 : 1;
}

int replay_unseen(RunOptions options, const std::string& file, const std::string& home) {
  options.headless = true;
  if (options.untrusted) confine(reach_of(options, file, home));
  Interrupt interrupt;
  Replay replay(read_recording(file), options, home);
  for (const std::string& remark : replay.remarks()) say(remark);
  Progress progress(0.0);
  bool told = false;
  const auto past = [&] {
    return options.until && replay.played() >= *options.until - 0.5 * replay.scene().world().settings.step;
  };
  while (!Interrupt::asked() && !past() && replay.step()) {
    progress.show(replay.time(), replay.duration());
    if (!replay.failure().empty()) say(text("as it was recorded: ", replay.failure()));
    if (!std::exchange(told, !replay.mismatch().empty()) && !replay.mismatch().empty()) say(replay.mismatch());
  }
  if (!told && !replay.mismatch().empty()) say(replay.mismatch());
  say(text("replayed ", replay.tick(), " of ", replay.ticks(), " steps, to ", replay.scene().world().time,
           " s: ", replay.checked(), replay.mismatch().empty() ? " hashes, all as recorded" : " hashes as recorded"));
  return replay.mismatch().empty() && !replay.is_cut_off() ? 0 : 1;
}

}  // namespace

int replay(RunOptions options, const std::string& file, const std::string& home) {
  options.record.clear();  // it is read
  if (options.headless) return replay_unseen(options, file, home);
  try {
    if (const Display display; display.seen()) return replay_in_window(options, file, home);
  } catch (const NoWindow& error) { say(text(error.what(), ": replaying without a window")); }
  return replay_unseen(options, file, home);
}

}  // namespace pantin::player
