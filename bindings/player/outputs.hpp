#pragma once
#include <exception>
#include <string>
#include <vector>

#include "player/options.hpp"
#include "player/output.hpp"
#include "player/pictures.hpp"
#include "player/table.hpp"
#include "scene/errors.hpp"
#include "scene/scene.hpp"

namespace pantin::player {

/// Everything that a run leaves behind: table, picture, films, summary. Made before the run, so that a place that cannot be
/// written to is known at once; without `keep`, nothing is left.
class Outputs {
 public:
  /// None may be what is read: the scene's file, or a state's. Throws UsageError.
  Outputs(const RunOptions& options, const std::string& read);

  /// The files of an ending (".csv").
  std::vector<std::string> temporaries(const std::string& ending) const;
  bool any() const { return !files_.empty() || !summary_.empty() || !state_.empty(); }
  bool has(const std::string& ending) const { return !temporaries(ending).empty(); }
  /// Films among them.
  std::vector<std::string> films() const;

  void write_tables(const Times& times, const World& world);
  void write_summary(const Scene& scene, const std::string& failure = "");
  /// The state, where one is to be saved.
  void write_state(Scene& scene);
  /// It is not to be kept: its time did not come.
  void drop_state() { state_.clear(); }
  /// A message about temporary files, in the names that they are to have.
  std::string in_own_names(std::string message) const;
  /// Does what writes a temporary file; where that throws the file is none of those that are kept.
  template <class F>
  void complete(const std::string& temporary, F&& f) {
    complete(of(temporary), f);
  }
  /// All that are complete take their own names. Throws Error for the first that is not.
  void keep();

 private:
  template <class F>
  void complete(Output& file, F&& f) {
    try {
      f();
    } catch (const std::exception& error) { drop(file, error.what()); }
  }
  void drop(Output& file, const std::string& why);
  Output& of(const std::string& temporary);

  TableRows rows_;
  std::string failure_;  ///< the first
  std::vector<Output> files_;
  std::vector<Output> summary_;  ///< one or none
  std::vector<Output> state_;    ///< one or none
};

}  // namespace pantin::player
