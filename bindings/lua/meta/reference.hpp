#pragma once
#include <string>
#include <vector>

namespace pantin::lua {

/// The reference of the scene's functions and fields as Markdown, made from the annotations, so that the two say the
/// same: assets/pages/reference.md.
std::string reference();

/// What one wants to do, and the entries that do it: "Scene:nail", "Scene.gravity" or a type.
struct ReferenceTask {
  const char* wanted;
  std::vector<std::string> entries;
};
struct ReferenceTasks {
  const char* title;
  std::vector<ReferenceTask> tasks;
};
/// What the reference begins with.
const std::vector<ReferenceTasks>& reference_tasks();

/// What the examples of calls run after: those of scenes, and those of tests.
extern const char* const example_scene;
extern const char* const example_test;

/// A call of the annotations, and its example.
struct Example {
  std::string call;  ///< "Scene:nail"
  std::string lines;
  bool of_test;  ///< runs after example_test
};
/// Of every call.
std::vector<Example> reference_examples();

}  // namespace pantin::lua
