#include "player/outputs.hpp"

#include <filesystem>
#include <set>

#include "player/summary.hpp"
#include "scene/errors.hpp"

namespace pantin::player {

Outputs::Outputs(const RunOptions& options) {
  std::set<std::string> seen;
  auto add = [&](std::vector<Output>& list, const std::string& path) {
    if (!seen.insert(std::filesystem::absolute(path).lexically_normal()).second)
      throw UsageError(text(path, " is given as an output twice"));
    list.emplace_back(path);
  };
  for (const std::string& path : options.outputs) add(files_, path);
  if (!options.summary.empty()) add(summary_, options.summary);
}

std::vector<std::string> Outputs::temporaries(const std::string& ending) const {
  std::vector<std::string> paths;
  for (const Output& file : files_)
    if (file.path().ends_with(ending)) paths.push_back(file.temporary());
  return paths;
}

std::vector<std::string> Outputs::films() const {
  std::vector<std::string> paths;
  for (const Output& file : files_)
    if (Film::can_write(file.path())) paths.push_back(file.temporary());
  return paths;
}

void Outputs::write_tables(const Times& times, const World& world) const {
  for (const Output& file : files_)
    if (file.path().ends_with(".csv")) file.write(probe_table(times, world.probes));
}

void Outputs::write_summary(const Scene& scene, const std::string& failure) const {
  for (const Output& file : summary_) file.write(summary(scene, failure));
}

void Outputs::keep() {
  for (Output& file : files_) file.keep();
  for (Output& file : summary_) file.keep();
}

}  // namespace pantin::player
