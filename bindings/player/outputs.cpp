#include "player/outputs.hpp"

#include <algorithm>

#include "player/hdf5_table.hpp"
#include "player/summary.hpp"
#include "scene/errors.hpp"

namespace pantin::player {

Outputs::Outputs(const RunOptions& options, const std::string& read) : rows_(options.table) {
  const auto refuse_twice = [](const std::string& one, const std::string& path) {
    if (same_file(one, path))
      throw UsageError(one == path ? text(path, " is given as an output twice")
                                   : text(one, " and ", path, " are the same file"));
  };
  const auto add = [&](std::vector<Output>& list, const std::string& path) {
    keep_apart(path, read);
    if (!options.record.empty()) refuse_twice(options.record, path);
    for (const std::vector<Output>* others : {&files_, &summary_, &state_})
      for (const Output& other : *others) refuse_twice(other.path(), path);
    if (path.ends_with(hdf5_ending)) need_hdf5();
    list.emplace_back(path);
  };
  if (!options.record.empty()) {
    keep_apart(options.record, read);
    Output(options.record).drop();  // whether it can be written is known now
  }
  for (const std::string& path : options.outputs) add(files_, path);
  if (!options.summary.empty()) add(summary_, options.summary);
  if (!options.save_to.empty()) add(state_, options.save_to);
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

void Outputs::write_tables(const Times& times, const World& world) {
  for (Output& file : files_)
    if (file.path().ends_with(".csv") || file.path().ends_with(hdf5_ending))
      complete(file, [&] { file.write(table_content(file.path(), probe_columns(times, world.probes, rows_))); });
}

void Outputs::write_summary(const Scene& scene, const std::string& failure) {
  for (Output& file : summary_) complete(file, [&] { file.write(summary(scene, failure)); });
}

void Outputs::write_state(Scene& scene) {
  for (Output& file : state_) complete(file, [&] { file.write(scene.state()); });
}

void Outputs::drop(Output& file, const std::string& why) {
  if (failure_.empty()) failure_ = in_own_names(why);
  file.drop();
}

Output& Outputs::of(const std::string& temporary) {
  return *std::find_if(files_.begin(), files_.end(), [&](const Output& file) { return file.temporary() == temporary; });
}

std::string Outputs::in_own_names(std::string message) const {
  for (const Output& file : files_) message = file.in_own_name(message);
  for (const Output& file : summary_) message = file.in_own_name(message);
  for (const Output& file : state_) message = file.in_own_name(message);
  return message;
}

void Outputs::keep() {
  for (std::vector<Output>* list : {&files_, &summary_, &state_})
    for (Output& file : *list) complete(file, [&] { file.keep(); });
  require(failure_.empty(), failure_);
}

}  // namespace pantin::player
