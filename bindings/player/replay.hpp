#pragma once
// Plays a recording again: the same scene, the same acts before the same steps, and so the same bits, which are checked.
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "lua/scene.hpp"
#include "player/options.hpp"
#include "player/recording.hpp"

namespace pantin::player {

class Replay {
 public:
  /// Opens the scene of the recording; throws what opening it throws.
  Replay(Recording recording, const RunOptions& options, std::string home);
  ~Replay();

  /// Does one step with what was done before it. False where the recording has no more. Errors of the script leave as
  /// they are where the recording does not go on after them.
  bool step();
  /// Makes `tick` the present one: back to the latest snapshot before it, or where a play goes on to the start, and on
  /// from there. Takes at most `most` steps at once: call again until it says true.
  bool go_to(std::uint64_t tick, std::uint64_t most);

  lua::Scene& scene() { return *scene_; }
  std::uint64_t tick() const { return tick_; }  ///< steps done
  std::uint64_t ticks() const { return recording_.ticks; }
  std::uint64_t checked() const { return checked_; }  ///< hashes that agreed
  /// "the replay parts from the recording between 2 s and 3 s": where the first hash did not agree; else empty.
  const std::string& mismatch() const { return mismatch_; }
  /// What may make it part: another version of the program, changed files; and what of the file could not be read.
  const std::vector<std::string>& remarks() const { return remarks_; }

 private:
  /// What the present state is of the recording.
  struct Place {
    std::uint64_t tick = 0;
    std::size_t act = 0;       ///< the next
    std::uint64_t opened = 0;  ///< how often the scene was opened anew by then
    double checked_time = 0.0;
    std::shared_ptr<const lua::SceneSnapshot> state;
  };

  void open();
  void go_to_start();
  void compare_files();
  void act(const RecordedAct& act);
  void check(const StateCheck& check);
  void change(const ParameterChange& change);
  void keep_place();

  Recording recording_;
  RunOptions options_;
  std::string home_;
  lua::SceneOptions scene_options_;
  std::map<std::string, std::uint64_t> files_;  ///< that the scene read
  std::unique_ptr<lua::Scene> scene_;
  std::set<std::uint64_t> needed_;  ///< states that will be put back
  std::map<std::uint64_t, std::shared_ptr<const lua::SceneSnapshot>> kept_;
  std::vector<Place> places_;  ///< rising, of the present scene
  std::uint64_t spacing_;      ///< [ticks] between them
  std::uint64_t tick_ = 0, opened_ = 0, checked_ = 0;
  std::size_t next_ = 0;
  double checked_time_ = 0.0;  ///< [s]
  std::string mismatch_;
  std::vector<std::string> remarks_;
};

/// `pantin replay FILE`: without a window, checking every hash. Returns the exit code.
int replay(const RunOptions& options, const std::string& file, const std::string& home);

}  // namespace pantin::player
