#pragma once
// Recordings: all that the outside did to a scene, before which step. A file of lines, each a JSON object. The first has
// "pantin" (the format's number), "version" (of the program), "scene", "set" and "files" (the contents of what was read, so
// that the recording stays what it was when they are changed), and "saved" where the scene found values in `scene.saved`;
// all others have "tick", the number of steps done before,
// counting every step that was ever done, and one of
//   "moves" and "commands"   the input of the coming step: hands, tools, keys, buttons (engine/world/input.hpp)
//   "at_once"                commands that were carried out before that step, as the scene was paused
//   "hand"                   a hand came
//   "parameter" and "value"  a parameter was changed
//   "edit", "field", "value" a field of a thing was written
//   "keep", "restore"        the state was kept under a number, or one put back: undo and redo; one of a scene that another
//                            took the place of is that scene again, as it was left
//   "restart"                the scene was opened anew
//   "open" and "set"         another scene was opened, or the same with other parameters, and "step" [s] is as long as one
//                            of its steps; "saved" as in the first line
//   "file" and "content"     a file was read that was not, or was another
//   "reload"                 the scene was opened anew, and went on where it was
//   "failed"                 the coming step ended in an error
//   "time" and "hash"        of the state, once a simulated second
//   "end"                    the last step was done
// Numbers are written so that they are read back to the bit.
// Of texts that need not be UTF-8 each byte is a character.
#include <cstdint>
#include <fstream>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "fields/value.hpp"
#include "scene/options.hpp"
#include "world/world.hpp"

namespace pantin::player {

struct RecordingHead {
  std::string version;                       ///< of the program
  std::string scene;                         ///< path, see `path_as_recorded`
  std::map<std::string, std::string> set;    ///< as RunOptions::set
  std::map<std::string, std::string> files;  ///< that the scene read, with their contents
  SavedValues saved = {};                    ///< what `scene.saved` began with
};

/// What hands did while the scene was paused.
struct DoneAtOnce {
  std::vector<Command> commands;
};
struct HandCame {};
struct ParameterChange {
  std::string name;
  SceneValue value;
};
/// A property of a thing was written, as a number, a truth, a text or a vec.
struct FieldEdit {
  AnyId thing;
  std::string field;
  fields::Value value;
};
struct StateKept {
  std::uint64_t number = 0;
};
struct StateRestored {
  std::uint64_t number = 0;  ///< of the StateKept
};
struct Restarted {};
/// The scene took the place of the one before it.
struct SceneOpened {
  std::string scene;                       ///< path, see `path_as_recorded`
  std::map<std::string, std::string> set;  ///< as RunOptions::set
  SavedValues saved = {};                  ///< what `scene.saved` began with
  double step = 0.0;                       ///< [s]
};
struct FileFound {
  std::string path, content;
};
struct GoneOn {};
struct StepFailed {};
/// What the state was.
struct StateCheck {
  double time = 0.0;  ///< [s]
  std::uint64_t hash = 0;
};
struct RecordingEnd {};

struct RecordedAct {
  std::uint64_t tick = 0;  ///< steps done before
  std::variant<StepInput, DoneAtOnce, HandCame, ParameterChange, FieldEdit, StateKept, StateRestored, Restarted,
               SceneOpened, FileFound, GoneOn, StepFailed, StateCheck, RecordingEnd>
      what;
};

struct Recording {
  RecordingHead head;
  std::vector<RecordedAct> acts;  ///< in their order
  std::uint64_t ticks = 0;        ///< steps that it tells of
  std::string damage;             ///< not empty: what of the file could not be read; the acts are those before
};

/// Of this program.
std::string program_version();
/// Of what comes with the program below "pantin:", so that a recording is the same wherever that is; of others the whole.
std::string path_as_recorded(const std::string& path, const std::string& home);

/// Throws Error where the file is none, or its first line cannot be understood.
Recording read_recording(const std::string& path);

/// Writes a recording while a scene is played. What was told is on disk once a second.
class Recorder {
 public:
  /// Throws Error where the file cannot be written.
  Recorder(const std::string& path, RecordingHead head);
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// The input of the coming step.
  void input(const StepInput& input);
  /// These were carried out between two steps.
  void done_at_once(const std::vector<Command>& commands);
  /// A step was done.
  void stepped(const World& world);
  /// It ended in an error.
  void failed();
  void hand_came();
  void parameter(const std::string& name, const SceneValue& value);
  void edited(const FieldEdit& edit);
  void kept(std::uint64_t number);
  void restored(std::uint64_t number);
  void restarted();
  void opened(SceneOpened scene);
  /// A file was read, by its path as recorded.
  void file(const std::string& path, const std::string& content);
  /// The scene goes on with what its files are now.
  void gone_on();
  /// Ends the recording; throws Error where the file could not be written. Called again does nothing.
  void finish();

 private:
  void write(const RecordedAct& act);

  std::string path_;
  std::ofstream file_;
  std::map<std::string, std::string> contents_;  ///< of files, that were told
  std::uint64_t tick_ = 0;
  double second_ = 0.0;  ///< [s] whole ones that were told
  bool finished_ = false;
};

/// The first line of the file, and back; throws Error where the line is none.
std::string line_of(const RecordingHead& head);
RecordingHead head_of(const std::string& line);
/// One act as a line of the file, and back; throws Error where the line is none.
std::string line_of(const RecordedAct& act);
RecordedAct act_of(const std::string& line);

}  // namespace pantin::player
