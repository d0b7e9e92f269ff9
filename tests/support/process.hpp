#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace pantin::support {

/// A folder of its own under the temporary one; gone at the end.
class Folder {
 public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string operator/(const std::string& name) const { return path / name; }
  /// Names of the files in it, sorted.
  std::vector<std::string> files() const;
  std::filesystem::path path;
};

std::string read_file(const std::string& path);
void write_file(const std::string& path, const std::string& text);

/// A program that runs beside the test. It is killed if it still runs at the end.
class Process {
 public:
  struct Options {
    std::vector<std::string> arguments;    ///< the program first
    std::vector<std::string> environment;  ///< "NAME=value" sets, "NAME" unsets
    std::string folder;                    ///< to run in; empty: here
    int pass_descriptor = -1;              ///< given on to the program under the same number
  };
  explicit Process(const Options& options);
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// The exit code (128 + signal), or nothing if it still runs after `seconds`.
  std::optional<int> wait(double seconds);
  void signal(int number);
  int id() const { return id_; }
  std::string out() const { return read_file(folder_ / "out"); }
  std::string err() const { return read_file(folder_ / "err"); }

 private:
  Folder folder_;
  int id_ = -1;
  std::optional<int> code_;
};

struct Finished {
  int code = -1;  ///< -1: did not end in time
  std::string out, err;
};
/// Runs a program to its end, at most ten minutes: the machine may be busy.
Finished finish(const Process::Options& options);

/// Whether the shell would find a program.
bool have_program(const std::string& name);

}  // namespace pantin::support
