#pragma once
// A law: how particles pull at each other, or are pulled. Library laws and a scene's own are made by the same functions.
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "laws/expression.hpp"
#include "laws/parameter.hpp"
#include "laws/program.hpp"

namespace pantin {

/// What acts where an expression cannot be had: a function called for each pair, bond or particle. Single-threaded.
class Called {
 public:
  virtual ~Called() = default;
  /// What one block gives: `column(i)` of each of `inputs`, in the order of Law::inputs_wanted, and the particles (slots of
  /// Model::particles) of each position: `particles[who][k]`.
  struct Block {
    int n = 0;
    std::span<const double* const> inputs;             ///< (inputs) columns of n values
    std::span<const std::uint32_t* const> particles;   ///< (particles of the law) columns of n slots
    std::span<double* const> outputs;                  ///< (outputs) columns to be written
    double time = 0.0;                                 ///< [s]
    std::span<const double> parameters;                ///< (parameters) when they are the same for all, else empty
    std::span<const double* const> parameter_columns;  ///< (parameters) columns, else empty
  };
  /// Writes the outputs of the law: its forces, then its energy if it has one. Throws Error with the law's line.
  virtual void run(const Block& block) = 0;
};

enum class LawKind : std::uint8_t {
  central,  ///< a pair pulls along its line. Output: tension / distance, positive where it pulls
  pair,     ///< a pair. Outputs: x, y, z of the force on a
  point,    ///< one particle. Outputs: x, y, z of the force
  many,     ///< `count` particles. Outputs: x, y, z of the force on each
};

struct Law {
  std::string name;  ///< "lennard_jones", or where a scene's own was written: "scene.lua:12"
  LawKind kind = LawKind::central;
  int count = 2;                                            ///< particles
  double cutoff = std::numeric_limits<double>::infinity();  ///< [m] of a pair
  bool touching = false;   ///< 0 unless the distance is below the sum of the radii of a and b
  bool one_sided = false;  ///< b feels nothing of what a feels
  int exclude = 0;         ///< pairs within so many connections are left out
  std::vector<Parameter> parameters;

  Expressions graph;
  std::vector<Expr> force;           ///< outputs as `kind` says
  Expr energy = no_expression;       ///< [J]; none: the law is without energy
  Expr stiffness = no_expression;    ///< [N/m] of a central law: rate of tension with distance
  std::shared_ptr<const Law> also;   ///< the part without energy that acts with it, with the same parameters
  std::shared_ptr<Called> called;    ///< instead of the expressions
  std::vector<Input> inputs_wanted;  ///< by `called`
  bool called_energy = false;        ///< `called` gives an energy too

  /// The law for other values of its parameters, where its cutoff comes of them; else empty. Throws Error for a value
  /// that is out of range.
  std::function<std::shared_ptr<Law>(std::span<const double>)> remade;

  mutable std::shared_ptr<const Law> within;  ///< once `within_cutoff` has made it

  bool velocity_dependent = false;  ///< depends on velocities
  bool thermal = false;             ///< a thermostat: acts in the middle of drifts
  bool workless = false;            ///< what these add to its force does no work
  bool timed = false;               ///< depends on time or noise

  /// Neither what depends on time nor what is one-sided has an energy to keep.
  bool has_energy() const { return energy != no_expression || called_energy; }
};

struct LawDef {
  std::string name;
  double cutoff = std::numeric_limits<double>::infinity();  ///< [m]
  bool shift = true;                                        ///< a potential with a cutoff is 0 there
  bool touching = false;
  bool one_sided = false;
  int exclude = 0;
  std::vector<Parameter> parameters = {};
};

/// Whether a law's parameter of that name is the world's own: the length of its step, and k_B.
inline bool given_by_world(std::string_view name) { return name == "step" || name == "boltzmann"; }

/// The rate of distance of a pair [m/s].
Expr rate_of_distance(Expressions& graph);

/// Laws from expressions of `graph`, whose derivatives are taken here. Throw Error where an expression depends on what
/// its kind of law does not have, or on a parameter that is not in `def`.
/// `potential` [J] of distance2, attributes, parameters and time.
Law central_potential(const LawDef& def, const Expressions& graph, Expr potential);
/// `tension` [N] pulls when positive; of approach and noise too.
Law central_tension(const LawDef& def, const Expressions& graph, Expr tension);
/// (3) [N] of distance2, approach, displacement, relative velocity, attributes, parameters, time and noise.
Law pair_force(const LawDef& def, const Expressions& graph, std::span<const Expr> force_on_a);
/// `potential` [J] of position and attributes of a, parameters and time.
Law point_potential(const LawDef& def, const Expressions& graph, Expr potential);
/// (3) [N] of velocity and noise too.
Law point_force(const LawDef& def, const Expressions& graph, std::span<const Expr> force);
/// `potential` [J] of the positions and attributes of `count` particles, parameters and time.
Law many_potential(const LawDef& def, int count, const Expressions& graph, Expr potential);

}  // namespace pantin
