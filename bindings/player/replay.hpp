#pragma once
// Plays a recording again: the same scene, the same acts before the same steps, and so the same bits, which are checked.
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "player/kept_places.hpp"
#include "player/options.hpp"
#include "player/recording.hpp"
#include "scene/scene.hpp"

namespace pantin::player {

class Replay {
 public:
  /// Opens the scene of the recording; throws what opening it throws. Where nobody sees it, there is no going back fast.
  Replay(Recording recording, const RunOptions& options, const std::string& home);
  ~Replay();

  /// Does one step with what was done before it. False where the recording has no more. An error of the script leaves as it
  /// is where the recorded step had none.
  bool step();
  /// Makes `tick` the present one, in the state of the first time: from the nearest snapshot before it, or from the start
  /// where there is none, or where the scene is not wholly in its snapshots. Takes at most `most` steps at once: call again
  /// until it says true.
  bool go_to(std::uint64_t tick, std::uint64_t most);

  Scene& scene() { return *scene_; }
  std::uint64_t tick() const { return tick_; }  ///< steps done
  std::uint64_t ticks() const { return recording_.ticks; }
  double time_at(std::uint64_t tick) const;                      ///< [s] of the recording
  std::uint64_t tick_at(double time) const;                      ///< the nearest
  double time() const { return time_at(tick_); }                 ///< [s] of the recording
  double duration() const { return time_at(recording_.ticks); }  ///< [s] the same
  /// [s] Of this scene and those before it, as they tell it.
  double played() const { return earlier_ + scene_->world().time; }
  std::uint64_t openings() const { return openings_; }  ///< how often `scene` has become another
  std::uint64_t place() const { return place_; }        ///< of the scene among those that were opened one after another
  const std::string& path() const { return path_; }     ///< of the scene
  const std::vector<RecordedAct>& acts() const { return recording_.acts; }
  std::uint64_t checked() const { return checked_; }  ///< hashes that agreed
  /// "the replay parts from the recording between 2 s and 3 s": where the first hash did not agree; else empty.
  const std::string& mismatch() const { return mismatch_; }
  std::uint64_t agreed() const { return agreed_; }  ///< tick up to which all hashes did
  /// The error that the last step ended in, as it did when it was recorded; or empty.
  const std::string& failure() const { return failure_; }
  /// Whether the end of the recording is missing, or could not be read.
  bool is_cut_off() const { return !recording_.damage.empty(); }
  /// What may make it part: another version of the program; files that were changed since; and what could not be read.
  const std::vector<std::string>& remarks() const { return remarks_; }

 private:
  struct Kept {
    std::shared_ptr<Scene> scene;
    std::shared_ptr<const SceneSnapshot> state;  ///< null where another scene took its place
  };
  /// Of one scene.
  struct Stretch {
    std::uint64_t tick = 0;  ///< at which it begins
    double time = 0.0;       ///< [s] the same
    double step = 0.0;       ///< [s]
  };
  void find_stretches();
  void start();
  void open();
  void open_other(const SceneOpened& opened);
  void go_on();
  void adopt(std::shared_ptr<Scene> fresh);
  void look_at_files(const std::string& home);
  bool act();
  void do_act(const RecordedAct& act);
  void do_last();
  void keep(const StateKept& kept);
  void put_back(const StateRestored& restored);
  void edit(const FieldEdit& edit);
  void find(const FileFound& file);
  void check(const StateCheck& check);
  void change(const ParameterChange& change);
  void compare();
  void keep_place();
  void jump(std::uint64_t tick);

  Recording recording_;
  std::string path_;
  SceneOptions options_;
  FileContents contents_;  ///< of the files, as they are at the present tick
  std::shared_ptr<Scene> scene_;
  std::set<std::uint64_t> needed_;  ///< states that will be put back
  std::map<std::uint64_t, Kept> kept_;
  KeptPositions positions_;  ///< of the present scene
  std::vector<Stretch> stretches_;
  std::vector<std::uint64_t> hashes_;  ///< (ticks) of states, as they were
  double since_position_ = 0.0;        ///< [s] of computing, since a place was kept or gone to
  double earlier_ = 0.0;               ///< [s] of the scenes before this one
  double place_cost_ = 0.0;            ///< [s] of keeping the last
  std::size_t next_ = 0;               ///< act
  std::size_t judged_ = 0;             ///< acts whose hashes were compared
  std::uint64_t tick_ = 0, openings_ = 0, place_ = 0, checked_ = 0, agreed_ = 0;
  bool seen_;             ///< somebody may go back
  bool straight_ = true;  ///< no place was gone to since the start
  bool exact_ = true;     ///< going to places has come to the states of the first time
  bool astray_ = false;   ///< it has not
  std::string mismatch_, failure_;
  std::vector<std::string> remarks_;
};

/// `pantin replay FILE`: in a window, or without one where there is no display or none is wanted; every hash that is come by
/// is checked. Returns the exit code.
int replay(RunOptions options, const std::string& file, const std::string& home);

}  // namespace pantin::player
