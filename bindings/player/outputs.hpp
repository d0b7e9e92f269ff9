#pragma once
#include <string>
#include <vector>

#include "player/options.hpp"
#include "player/output.hpp"
#include "player/pictures.hpp"
#include "player/table.hpp"
#include "scene/scene.hpp"

namespace pantin::player {

/// Everything that a run leaves behind: table, picture, films, summary. Made before the run, so that a place that cannot be
/// written to is known at once; without `keep`, nothing is left.
class Outputs {
 public:
  /// Throws UsageError.
  explicit Outputs(const RunOptions& options);

  /// The files of an ending (".csv").
  std::vector<std::string> temporaries(const std::string& ending) const;
  bool has(const std::string& ending) const { return !temporaries(ending).empty(); }
  /// Films among them.
  std::vector<std::string> films() const;

  void write_tables(const Times& times, const World& world) const;
  void write_summary(const Scene& scene, const std::string& failure = "") const;
  /// All are complete: they take their own names.
  void keep();

 private:
  std::vector<Output> files_;
  std::vector<Output> summary_;  ///< one or none
};

}  // namespace pantin::player
