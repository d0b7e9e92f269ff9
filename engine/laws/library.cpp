#include "laws/library.hpp"

#include <algorithm>
#include <cmath>

#include "base/check.hpp"
#include "base/functions.hpp"
#include "laws/law_maker.hpp"

namespace pantin {

using Given = LibraryParameter::Given;
using Range = LibraryParameter::Range;

namespace {

std::string with_unit(const LibraryParameter& parameter) {
  const std::string unit = parameter.unit;
  return unit == "1" ? parameter.name : text(parameter.name, " [", unit, "]");
}

std::string unit_after(const LibraryParameter& parameter) {
  const std::string unit = parameter.unit;
  return unit == "1" ? "" : " " + unit;
}

constexpr const char* axes[] = {"_x", "_y", "_z"};

}  // namespace

LawMaker::LawMaker(const LibraryLaw& law, const LawArguments& given) : arguments(given) {
  def.name = law.name;
  check_known(law);
  for (const LibraryParameter& parameter : law.parameters) {
    if (parameter.is_vector) {
      add_vector(parameter);
    } else {
      add_number(parameter);
    }
  }
  const bool is_of_pairs = law.kind == LawKind::central || law.kind == LawKind::pair;
  require(is_of_pairs || !arguments.cutoff, law.name, ": only laws of pairs have a cutoff");
  require(is_of_pairs || !arguments.one_sided, law.name, ": only laws of pairs can be one-sided");
  if (arguments.cutoff) {
    require(std::isfinite(*arguments.cutoff) && *arguments.cutoff > 0.0, law.name, ": cutoff must be > 0 m, got ",
            *arguments.cutoff);
    def.cutoff = *arguments.cutoff;
  }
  def.shift = arguments.shift;
  def.one_sided = arguments.one_sided;
  def.exclude = arguments.exclude;
}

void LawMaker::check_known(const LibraryLaw& law) const {
  std::string names;
  for (const LibraryParameter& p : law.parameters) {
    if (p.given != Given::world) names += (names.empty() ? "" : ", ") + with_unit(p);
  }
  const auto check = [&](const std::string& name, bool is_vector) {
    const auto found = std::find_if(law.parameters.begin(), law.parameters.end(), [&](const LibraryParameter& p) {
      return name == p.name && p.given != Given::world;
    });
    require(found != law.parameters.end(), law.name, " has no parameter \"", name, "\"; it has ",
            names.empty() ? "none" : names);
    require(found->is_vector == is_vector, law.name, ": ", with_unit(*found), " must be a ",
            found->is_vector ? "vec" : "number");
  };
  for (const auto& argument : arguments.numbers) check(argument.first, false);
  for (const auto& argument : arguments.vectors) check(argument.first, true);
}

void LawMaker::add_number(const LibraryParameter& parameter) {
  Parameter made{parameter.name, parameter.value, parameter.unit, false, parameter.range};
  const auto found = arguments.numbers.find(parameter.name);
  if (found != arguments.numbers.end()) {
    made.value = found->second;
    check_parameter("", def.name, {&made, 1}, {&made.value, 1}, 0);
  } else {
    require(parameter.given != Given::required, def.name, ": ", with_unit(parameter), " is missing");
    made.present = parameter.given == Given::present;
  }
  def.parameters.push_back(std::move(made));
}

void LawMaker::add_vector(const LibraryParameter& parameter) {
  const auto found = arguments.vectors.find(parameter.name);
  require(found != arguments.vectors.end() || parameter.given != Given::required, def.name, ": ", with_unit(parameter),
          ", a vec, is missing");
  const Vec3 value = found == arguments.vectors.end() ? zero3() : found->second;
  const bool fits = finite(value) && (parameter.range == Range::any || norm2(value) > 0.0);
  require(fits, def.name, ": ", parameter.name, " must be a finite vec", parameter.range == Range::any ? "" : ", not 0",
          unit_after(parameter), "; got (", value[0], ", ", value[1], ", ", value[2], ")");
  for (int k = 0; k < 3; k++)
    def.parameters.push_back({parameter.name + std::string(axes[k]), value[k], parameter.unit, false, parameter.range});
}

Parameter* LawMaker::find(const std::string& name) {
  const auto found = std::find_if(def.parameters.begin(), def.parameters.end(),
                                  [&](const Parameter& parameter) { return parameter.name == name; });
  assume(found != def.parameters.end());
  return &*found;
}

double LawMaker::value(const std::string& name) const {
  return std::find_if(def.parameters.begin(), def.parameters.end(), [&](const Parameter& p) { return p.name == name; })
      ->value;
}

void LawMaker::set_default(const std::string& name, double value) {
  if (!is_given(name)) find(name)->value = value;
}

void LawMaker::drop(std::initializer_list<const char*> names) {
  for (const std::string name : names) {
    std::erase_if(def.parameters, [&](const Parameter& parameter) { return parameter.name == name; });
  }
}

Symbols3 LawMaker::vector(const std::string& name) {
  return {parameter(name + axes[0]), parameter(name + axes[1]), parameter(name + axes[2])};
}

Symbols3 LawMaker::inputs(Role role, int who) {
  Symbols3 found;
  for (std::uint8_t k = 0; k < 3; k++) found[k] = input({role, static_cast<std::uint8_t>(who), k, {}});
  return found;
}

const std::vector<LibraryLaw>& library() {
  static const std::vector<LibraryLaw> all = [] {
    std::vector<LibraryLaw> made;
    for (const auto& part : {pair_laws(), short_range_laws(), point_laws(), many_laws()}) {
      made.insert(made.end(), part.begin(), part.end());
    }
    return made;
  }();
  return all;
}

const LibraryLaw* find_library_law(std::string_view name) {
  const auto found =
      std::find_if(library().begin(), library().end(), [&](const LibraryLaw& law) { return name == law.name; });
  return found == library().end() ? nullptr : &*found;
}

std::shared_ptr<Law> RemadeLaw::operator()(std::span<const double> values) const {
  LawArguments present = arguments;
  for (std::size_t i = 0; i < parameters.size(); i++) present.numbers[parameters[i]] = values[i];
  return std::make_shared<Law>(make_library_law(name, present).front());
}

namespace {

/// A cutoff that was not given comes of parameters, and follows them.
void follow_parameters(const LibraryLaw& library_law, const LawArguments& arguments, Law& law) {
  RemadeLaw remade{library_law.name, arguments, {}};
  for (const Parameter& parameter : law.parameters) remade.parameters.push_back(parameter.name);
  law.remade = std::move(remade);
}

}  // namespace

void check_law_arguments(const LibraryLaw& law, const LawArguments& arguments) { LawMaker(law, arguments); }

std::vector<Law> make_library_law(std::string_view name, const LawArguments& arguments) {
  const LibraryLaw* law = find_library_law(name);
  require(law != nullptr, "there is no law \"", name, "\"");
  LawMaker maker(*law, arguments);
  std::vector<Law> made = law->make(maker);
  const bool of_table = !arguments.distances.empty();
  if (!arguments.cutoff && std::isfinite(made[0].cutoff) && !of_table) follow_parameters(*law, arguments, made[0]);
  return made;
}

double present_value(std::span<const Vec3> positions) {
  assume(positions.size() >= 2 && positions.size() <= 4);
  const Vec3 first = positions[1] - positions[0];
  if (positions.size() == 2) return norm(first);
  const Vec3 second = positions[2] - positions[1];
  const Vec3 normal = cross(first, second);
  if (positions.size() == 3) return functions::atan2(norm(normal), -dot(first, second));
  const Vec3 third = positions[3] - positions[2];
  const Vec3 other_normal = cross(second, third);
  return functions::atan2(norm(second) * dot(first, other_normal), dot(normal, other_normal));
}

}  // namespace pantin
