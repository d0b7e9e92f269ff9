#pragma once
#include <atomic>
#include <chrono>
#include <deque>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>

#include "player/aim.hpp"
#include "player/browser.hpp"
#include "player/live_film.hpp"
#include "player/lost_things.hpp"
#include "player/open_window.hpp"
#include "player/options.hpp"
#include "player/pacing.hpp"
#include "player/panels/panels.hpp"
#include "player/recording.hpp"
#include "player/reload.hpp"
#include "player/saved_values.hpp"
#include "player/status.hpp"
#include "player/table.hpp"
#include "player/undo.hpp"
#include "scene/scene.hpp"
#include "view/edge_arrows.hpp"
#include "view/fingers.hpp"
#include "view/player_input.hpp"
#include "view/renderer.hpp"
#include "view/speaker.hpp"
#include "view/steering.hpp"

namespace pantin::player {

/// A scene in a window, with hands in it.
class Player {
 public:
  /// Opens the window and the scene in it, or the browser where the path is empty; throws what the scene throws, or
  /// NoWindow.
  Player(std::string path, const RunOptions& options, const std::string& home);

  /// One frame: input, the steps that are due, a picture. False once it is over.
  bool frame();

  const Scene& scene() const { return *scene_; }
  const std::deque<Said>& said() const { return said_; }
  /// What went wrong last, while the window shows it; else null.
  const Said* complaint() const;
  bool display_lost() const { return window_.lost(); }
  bool browsing() const { return browser_.shown(); }
  /// What hands or panels were told last.
  const std::string& told() const { return told_; }
  const Times& times() const { return times_; }
  /// A script's error, or a state that became non-finite, that nobody has restarted from.
  const std::string& failure() const { return failure_; }
  /// Opens another scene; where that fails, tells why, and the present one goes on: false.
  bool open(const std::string& path);
  /// Applies a value of a parameter, live or by opening the scene anew. False where the scene refuses it, which is told.
  bool set_parameter(const std::string& name, const SceneValue& value);
  /// Takes back what hands did last, or does it again; what cannot be done is told.
  void undo();
  void redo();
  /// Ends the recording, if there is one; throws Error where it could not be written.
  void end_recording();
  /// Ends the film, if there is one; where it could not be written, that is told.
  void end_film();
  /// The scene as it is now, without the lines and cards.
  void write_picture(const std::string& path);

 private:
  using Clock = std::chrono::steady_clock;
  /// What a scene was opened from.
  struct Opened {
    std::string path;
    SceneOptions options;
    std::shared_ptr<SavedFile> lasting;
    Reload::Read read;
  };

  std::string title() const;
  void act(const Actions& actions);
  void take_keys();
  Viewport viewport() const;
  void take_fingers(double elapsed);
  Actions take_hands(double elapsed);
  std::int32_t new_hand();
  bool presses_in_scene() const;
  bool goes_on_changing(const std::string& name) const;
  std::uint64_t keep_for_undo(const std::string& act, const StepInput& before);
  void go_back(bool (Undo::*way)(std::shared_ptr<Scene>&, Times&, StepInput&, std::string&));
  void put_in_place(const Scene& old);
  void go_back_to(const Opened& opened, const Scene& old);
  void note_opened();
  bool loses_by(std::string_view act) const;
  void replace(const std::string& act, const std::string& told);
  void do_at_once();
  void tell(const std::string& what);
  void tell_dropped();
  void forget_act_that_failed();
  void count_sent(const std::vector<Command>& commands);
  void tell_tool();
  std::string hint() const;
  void draw_tools();
  void mark_hands(Overlay& overlay) const;
  void choose_followed();
  bool take_key(const std::string& name);
  bool leave(bool step_by_step);
  void bring_back();
  void choose();
  void swallow_keys();
  void wait_for(const std::atomic<bool>& done, const std::string& what);
  void edit(const FieldEdit& edit);
  std::set<std::string> keys_of_scene() const;
  void give_keys_to_scene();
  void write_table();
  void toggle_film();
  void add_to_film();
  void wrote(const std::string& path);
  void log(const std::string& what, bool good);
  void leave_browser();
  void restart();
  /// As the scene wants to be seen.
  Camera own_camera() const;
  void begin_recording();
  /// Of a stranger's scene nothing is kept.
  std::shared_ptr<SavedFile> lasting_of(const std::string& path) const;
  void confine_window(const std::string& home);
  void record(const std::string& path);
  std::string recorded_path(const std::string& path) const;
  void stop_recording(const std::string& why);
  void reload();
  std::unique_ptr<Scene> load(const std::string& path, const SceneOptions& options, bool anew = false);
  void adopt(std::shared_ptr<Scene> fresh);
  bool take_over(const NextScene& next, const std::string& act);
  void open_neighbour(int places);
  void open_next();
  void play(const SoundCall& call);
  void fulfil(const Wishes& wishes);
  void complain(const std::string& why);
  Desk desk();
  void draw();
  void fit_window();
  void take_steps(double elapsed);
  void step_once();
  bool at_end() const;
  void fail_step(const std::string& why);
  void fail(const std::string& why);
  void save_picture();
  void save_state();
  void save_scene();
  void open_state();
  void fill(Overlay& overlay);

  std::string path_;
  RunOptions options_;
  SceneOptions scene_options_;
  Reload reload_;
  std::shared_ptr<Scene> scene_;
  std::unique_ptr<Recorder> recorder_;
  std::unique_ptr<LiveFilm> film_;  ///< while it is taken
  Window window_;
  Renderer renderer_;
  Overlay overlay_;  ///< of the last frame; kept so that nothing is allocated for the next
  Camera camera_;
  Follower follower_;
  PlayerInput hands_;
  Fingers fingers_;
  Gestures gestures_;
  Steering steering_;
  Speaker speaker_;
  std::shared_ptr<SavedFile> lasting_ = std::make_shared<SavedFile>();  ///< what the scene keeps for the next time
  Undo undo_;
  std::map<std::weak_ptr<Scene>, Opened, std::owner_less<>> opened_;  ///< the scenes that there are
  bool acted_ = false;  ///< something was done to the scene since it was opened, which is lost when it is again
  PaletteWish undo_wish_;
  std::string told_;  ///< what a tool did last, or why it did nothing
  Clock::time_point told_at_{};
  Clock::time_point adopted_ = Clock::now();  ///< when the scene was opened
  Clock::time_point changed_at_{};            ///< when a parameter was
  bool tried_ = false;                        ///< a hand did something since
  Clock::time_point tried_at_{};              ///< when first
  std::size_t log_read_ = 0;                  ///< lines of the world's log
  Clock::time_point asked_at_{};              ///< when it was last asked whether to quit
  LostThings lost_;
  EdgeArrows edge_arrows_;
  StepInput waiting_;       ///< what hands did since the last step
  StepInput before_hands_;  ///< the same before this frame
  struct LastAct {
    std::uint64_t number = 0;           ///< in `undo_`
    std::size_t sent = 0, dropped = 0;  ///< commands since it was begun, and those of them that could not be done
    bool failed() const { return sent > 0 && dropped >= sent; }
  };
  LastAct last_act_;
  Pacing pacing_;
  Status status_;
  Times times_;
  double earlier_ = 0.0;  ///< [s] of the scenes that were played before this one
  Clock::time_point last_ = Clock::now();
  Panels panels_;
  Browser browser_;
  std::vector<std::string> swallowed_;  ///< keys that were down when the browser was left, until they go up
  bool from_browser_ = false;           ///< Esc goes back to it
  std::string saved_;                   ///< file of the state that was saved last
  std::deque<Said> said_;               ///< the latest, oldest first
  Clock::time_point complained_{};      ///< when the last of them that is not good was said
  AnyId chosen_;
  std::uint64_t changes_ = 0;  ///< made to the scene between its steps
  double speed_ = 1.0;         ///< times the scene's pace
  double load_seconds_ = 0;    ///< [s] that opening the scene took
  bool paused_;
  bool help_ = false;
  Views views_;
  bool film_panels_ = false;  ///< films show panels, too
  bool over_ = false;         ///< the browser was left, and there is no scene
  bool single_step_ = false;
  std::string failure_;
};

}  // namespace pantin::player
