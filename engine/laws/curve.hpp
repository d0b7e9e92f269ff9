#pragma once
// What of a particle follows its age: "radius", "color" or an attribute as a function of age and lifetime.
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "laws/program.hpp"

namespace pantin {

/// The inputs of a course: age and lifetime [s] of the particle; an endless lifetime is infinite.
inline const Input course_age{Role::attribute, 0, 0, "age"}, course_lifetime{Role::attribute, 0, 0, "lifetime"};

struct Course {
  std::string name;  ///< "radius", "color", or an attribute
  Program program;   ///< outputs: the value [m, of a radius]; red, green, blue and opacity of a color
};

/// The courses of a particle, which all particles of a kind share.
struct Courses {
  std::vector<std::shared_ptr<const Course>> list;  ///< sorted by name
  const Course* find(std::string_view name) const;
};

/// `outputs`, of age and lifetime, as a course; one for a number, four for a color. Throws Error where they depend on
/// anything else.
std::shared_ptr<const Course> make_course(std::string name, const Expressions& graph, std::span<const Expr> outputs);
/// The courses with one put in or replaced, or with one taken out; null where none is left.
std::shared_ptr<const Courses> with(const Courses* courses, std::shared_ptr<const Course> course);
std::shared_ptr<const Courses> without(const std::shared_ptr<const Courses>& courses, std::string_view name);

}  // namespace pantin
