#pragma once
// The laws that come with the engine: each an expression with named parameters, and where it is from.
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/lanes.hpp"
#include "laws/law.hpp"

namespace pantin {

struct LibraryParameter {
  enum class Given {
    required,  ///< by the scene
    optional,  ///< else `value`, or where that is NaN what `doc` says
    present,   ///< by the scene, else for each connection what it is when that is made: distance or angle
    world,     ///< by whoever runs the law, before each step, never by the scene: "step" and "boltzmann"
  };
  using Range = ParameterRange;

  const char* name;
  const char* unit;
  const char* doc;
  Given given = Given::required;
  double value = 0.0;
  Range range = Range::any;
  bool is_vector =
      false;  ///< of range any or direction; "v" is given as a vector; the law's own parameters are "v_x", "v_y", "v_z"
};

/// What a scene says of a law.
struct LawArguments {
  std::map<std::string, double> numbers;
  std::map<std::string, Vec3> vectors;
  std::vector<double> distances, potentials, tensions;  ///< of `table` [m], [J] or [N]
  std::optional<double> cutoff;                         ///< [m] of laws of pairs
  bool shift = true;                                    ///< a potential with a cutoff is 0 there
  bool one_sided = false;
  int exclude = 0;
};

class LawMaker;

struct LibraryLaw {
  const char* name;
  const char* doc;
  const char* source;
  LawKind kind;
  int count;  ///< particles
  std::vector<LibraryParameter> parameters;
  std::vector<Law> (*make)(LawMaker&);
};

/// All of them, in a fixed order.
const std::vector<LibraryLaw>& library();
/// The law of that name, or none.
const LibraryLaw* find_library_law(std::string_view name);

/// Throws Error for what is missing, unknown or out of range, with its name and unit.
void check_law_arguments(const LibraryLaw& law, const LawArguments& arguments);
/// The law, and after it, where it also dissipates, the part that has no energy: both act, with the same parameters. Throws
/// Error for what is missing, unknown or out of range, with its name and unit.
std::vector<Law> make_library_law(std::string_view name, const LawArguments& arguments);

/// Makes a law anew for other values of its parameters, from which its cutoff comes.
struct RemadeLaw {
  std::string name;
  LawArguments arguments;
  std::vector<std::string> parameters;
  std::shared_ptr<Law> operator()(std::span<const double> values) const;
};

/// The value of a parameter that is the present one: distance [m] of two positions, angle [rad] at the second of three,
/// torsion [rad] of four.
double present_value(std::span<const Vec3> positions);

}  // namespace pantin
