#pragma once
// What the functions that make library laws have in common. For the library alone.
#include <string>
#include <vector>

#include "laws/library.hpp"
#include "laws/symbol.hpp"

namespace pantin {

class LawMaker {
 public:
  /// Checks the arguments. Throws Error.
  LawMaker(const LibraryLaw& law, const LawArguments& arguments);

  LawDef def;
  const LawArguments& arguments;

  /// A parameter of the law.
  Symbol parameter(const std::string& name) { return input({Role::parameter, 0, 0, name}); }
  Symbols3 vector(const std::string& name);
  /// The value it was given, or its default.
  double value(const std::string& name) const;
  /// Gives a value to an optional parameter that was left out.
  void set_default(const std::string& name, double value);
  bool is_given(const std::string& name) const { return arguments.numbers.contains(name); }
  /// Leaves optional parameters that were not given out of the law.
  void drop(std::initializer_list<const char*> names);

  Symbol constant(double value) { return {&graph_, graph_.constant(value)}; }
  Symbol distance2() { return input({Role::distance2, 0, 0, {}}); }
  Symbol distance() { return sqrt(distance2()); }
  Symbol rate() { return {&graph_, rate_of_distance(graph_)}; }
  Symbol attribute(int who, const char* name) {
    return input({Role::attribute, static_cast<std::uint8_t>(who), 0, name});
  }
  Symbol product_of(const char* name) { return attribute(0, name) * attribute(1, name); }
  Symbols3 displacement() { return inputs(Role::displacement, 0); }
  Symbols3 relative_velocity() { return inputs(Role::relative_velocity, 0); }
  Symbols3 position(int who) { return inputs(Role::position, who); }
  Symbols3 velocity() { return inputs(Role::velocity, 0); }
  Symbols3 noise() { return inputs(Role::noise, 0); }
  Symbol spline(std::shared_ptr<const Spline> spline, Symbol x, int order) {
    return {&graph_, graph_.spline(std::move(spline), x.e, order)};
  }

  Law central_potential(Symbol v) const { return pantin::central_potential(def, graph_, v.e); }
  Law central_tension(Symbol tension) const { return pantin::central_tension(def, graph_, tension.e); }
  Law pair_force(const Symbols3& f) const {
    return pantin::pair_force(def, graph_, std::vector{f[0].e, f[1].e, f[2].e});
  }
  Law point_potential(Symbol v) const { return pantin::point_potential(def, graph_, v.e); }
  Law point_force(const Symbols3& f) const {
    return pantin::point_force(def, graph_, std::vector{f[0].e, f[1].e, f[2].e});
  }
  Law many_potential(int count, Symbol v) const { return pantin::many_potential(def, count, graph_, v.e); }

 private:
  Expressions graph_;

  Symbol input(const Input& input) { return {&graph_, graph_.input(input)}; }
  Symbols3 inputs(Role role, int who);
  void check_known(const LibraryLaw& law) const;
  void add_number(const LibraryParameter& parameter);
  void add_vector(const LibraryParameter& parameter);
  Parameter* find(const std::string& name);
};

/// Parts of the library.
std::vector<LibraryLaw> pair_laws();
std::vector<LibraryLaw> short_range_laws();
std::vector<LibraryLaw> point_laws();
std::vector<LibraryLaw> many_laws();

}  // namespace pantin
