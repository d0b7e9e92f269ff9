#include "laws/curve.hpp"

#include <algorithm>

#include "base/check.hpp"

namespace pantin {

namespace {

bool comes_before(const std::shared_ptr<const Course>& course, std::string_view name) { return course->name < name; }

}  // namespace

const Course* Courses::find(std::string_view name) const {
  const auto found = std::lower_bound(list.begin(), list.end(), name, comes_before);
  return found != list.end() && (*found)->name == name ? found->get() : nullptr;
}

std::shared_ptr<const Course> make_course(std::string name, const Expressions& graph, std::span<const Expr> outputs) {
  assume(outputs.size() == (name == "color" ? 4u : 1u));
  for (const Input& input : graph.inputs_of(outputs))
    require(input == course_age || input == course_lifetime, name, ": it may depend on age and lifetime alone");
  return std::make_shared<const Course>(Course{std::move(name), lower(graph, outputs)});
}

std::shared_ptr<const Courses> with(const Courses* courses, std::shared_ptr<const Course> course) {
  auto result = courses ? std::make_shared<Courses>(*courses) : std::make_shared<Courses>();
  std::erase_if(result->list, [&](const auto& other) { return other->name == course->name; });
  const auto at = std::lower_bound(result->list.begin(), result->list.end(), course->name, comes_before);
  result->list.insert(at, std::move(course));
  return result;
}

std::shared_ptr<const Courses> without(const std::shared_ptr<const Courses>& courses, std::string_view name) {
  if (!courses || !courses->find(name)) return courses;
  if (courses->list.size() == 1) return nullptr;
  auto result = std::make_shared<Courses>(*courses);
  std::erase_if(result->list, [&](const auto& other) { return other->name == name; });
  return result;
}

}  // namespace pantin
