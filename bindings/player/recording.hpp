#pragma once
// Recordings: all that the outside did to a scene, before which step. A file of lines, each a JSON object. The first has
// "pantin" (the format's number), "version" (of the program), "scene", "set" and "files" (with the hashes of what was
// read); all others have "tick", the number of steps done before, counting every step that was ever done, and one of
//   "moves" and "commands"   the input of the coming step: hands, tools, keys, buttons (engine/world/input.hpp)
//   "parameter" and "value"  a parameter was changed
//   "edit", "field", "value" a field of a thing was written
//   "keep", "restore"        the state was kept under a number, or one put back: undo and redo
//   "restart"                the scene was opened anew
//   "time" and "hash"        of the state, once a simulated second
//   "end"                    the last step was done
// Numbers are written so that they are read back to the bit.
#include <cstdint>
#include <fstream>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "lua/scene.hpp"

namespace pantin::player {

struct RecordingHead {
  std::string version;                         ///< of the program
  std::string scene;                           ///< path, or a shipped scene's name
  std::map<std::string, std::string> set;      ///< as RunOptions::set
  std::map<std::string, std::uint64_t> files;  ///< that the scene read, with the hashes of their contents
};

struct ParameterChange {
  std::string name;
  lua::Value value;
};
/// A field of a thing was written.
struct FieldEdit {
  AnyId thing;
  std::string field;
  std::variant<double, bool, std::string, Vec3> value;
};
struct StateKept {
  std::uint64_t number = 0;
};
struct StateRestored {
  std::uint64_t number = 0;  ///< of the StateKept
};
struct Restarted {};
/// What the state was.
struct StateCheck {
  double time = 0.0;  ///< [s]
  std::uint64_t hash = 0;
};
struct RecordingEnd {};

struct RecordedAct {
  std::uint64_t tick = 0;  ///< steps done before
  std::variant<StepInput, ParameterChange, FieldEdit, StateKept, StateRestored, Restarted, StateCheck, RecordingEnd>
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

/// Throws Error where the file is none, or its first line cannot be understood.
Recording read_recording(const std::string& path);

/// Writes a recording while a scene is played. What was told is on disk once a second.
class Recorder {
 public:
  /// Throws Error where the file cannot be written.
  Recorder(const std::string& path, const RecordingHead& head);
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// The input of the coming step.
  void input(const StepInput& input);
  /// A step was done.
  void stepped(const World& world);
  void parameter(const std::string& name, const lua::Value& value);
  void edited(const FieldEdit& edit);
  void kept(std::uint64_t number);
  void restored(std::uint64_t number);
  void restarted();
  /// Ends the recording; throws Error where the file could not be written. Called again does nothing.
  void finish();

 private:
  void write(const RecordedAct& act);

  std::string path_;
  std::ofstream file_;
  std::uint64_t tick_ = 0;
  double second_ = 0.0;  ///< [s] whole ones that were told
  bool finished_ = false;
};

/// One act as a line of the file, and back; throws Error where the line is none.
std::string line_of(const RecordedAct& act);
RecordedAct act_of(const std::string& line);

}  // namespace pantin::player
