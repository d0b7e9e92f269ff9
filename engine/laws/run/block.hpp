#pragma once
// One block of pairs, connections or sites on its way through a law, in one thread.
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/aligned.hpp"
#include "laws/law.hpp"
#include "laws/program.hpp"
#include "laws/run/sites.hpp"

namespace pantin {

class MachineCode;

/// What a law is run as, for all threads.
struct LawProgram {
  Program program;  ///< empty of a called law
  std::shared_ptr<const MachineCode> code;

  LawProgram(const Law& law, bool with_energy, Uniform uniform);
};

/// Columns to be filled with what the law wants to see, null where it does not; then `run`, and columns to be read.
class LawBlock {
 public:
  static constexpr int most = Machine::block;     ///< values in a column
  static constexpr int room = Machine::distance;  ///< that a column has: what is written past its end does no harm

  struct Attribute {
    std::size_t who = 0;
    std::size_t column = 0;  ///< of Sites::attributes
    double* to = nullptr;
    int input = -1;  ///< of the program
  };
  using Vector = std::array<double*, 3>;  ///< columns of the components

  /// Throws Error where the law wants an attribute that is not among `names`.
  LawBlock(const Law& law, const LawProgram& program, std::span<const std::string> names);

  double* distance2 = nullptr;  ///< never null
  double* approach = nullptr;
  Vector displacement{}, relative_velocity{};
  std::array<Vector, 4> position{}, velocity{};
  std::vector<Attribute> attributes;
  std::array<std::uint32_t*, 4> sites{};  ///< never null; to be filled where the law wants to know who they are
  bool wants_sites = false;
  bool wants_displacement = false, wants_motion = false;

  /// Once before the blocks of an evaluation.
  void set(const Instant& instant, std::span<const double> parameters);
  /// Reads a parameter in place: as many values as a block has, up to the next multiple of 16.
  void bind_parameter(std::size_t parameter, const double* values);
  /// Fills in attributes, and who they are, of n whose sites are those of each role.
  void gather_of(std::span<const std::uint32_t* const> roles, std::size_t n, const Sites& sites_of_all);
  /// Reads attributes in place: columns of the sites themselves.
  void bind_attributes(const Sites& sites_of_all);
  double* const* columns() const { return machine_->columns(); }  ///< by slot of the program
  /// n <= most.
  void run(int n, const Sites& sites_of_all);
  /// The forces as LawKind says, then the energy.
  const double* output(std::size_t k) const {
    return machine_ ? machine_->output(static_cast<int>(k)) : called_outputs_[k];
  }

 private:
  struct Noise {
    std::uint32_t index = 0;
    double* to = nullptr;
  };

  double* take_column(const Input& input);
  void use_column(const Input& input, const double* from);
  void take_input(const Law& law, std::span<const std::string> names, const Input& input);
  void make_noise(int n, const Sites& sites_of_all);
  void call(int n, const Sites& sites_of_all);

  std::size_t count_;  // particles
  std::optional<Machine> machine_;
  std::shared_ptr<Called> called_;
  AlignedVector<double> memory_;
  AlignedVector<std::uint32_t> slots_;  // sites, then particles
  std::size_t used_ = 0;                // columns of `memory_`
  std::vector<Noise> noise_;
  std::vector<std::pair<std::size_t, int>> parameter_inputs_;  // parameter of the law, input of the machine
  int time_input_ = -1;
  Instant instant_;
  std::vector<double> parameters_;
  bool is_set_ = false;  // the machine has run what follows from these two
  std::vector<const double*> called_inputs_, called_parameters_;
  std::vector<const std::uint32_t*> called_particles_;
  std::vector<double*> called_outputs_;
};

struct Slab;

/// A share of an evaluation, and how far it has been gone through.
struct Task {
  std::size_t at = 0, end = 0;  ///< rows of a slab, connections as arranged, or members
  const Slab* slab = nullptr;   ///< of pairs
  std::uint32_t offset = 0;     ///< within the row
  bool exchange = false;        ///< the same pairs come once more, with the roles exchanged
};

/// Of the outputs of a law those before its energy.
std::size_t force_outputs(const Law& law);

/// Some of what a law acts on.
struct Block {
  LawBlock law;
  int count = 0;
  std::size_t first = 0;      ///< number of the first, of connections and members
  bool in_lanes = false;      ///< energies are summed four at a time
  bool in_one_pass = false;   ///< the law is run when forces are scattered
  AlignedVector<Vec3> d;      ///< [m] from a to b, of pairs where the law wants it
  AlignedVector<Vec3> u;      ///< [m/s] velocity of b less that of a, where the law wants it
  double sign = 1.0;          ///< -1: with the roles exchanged, these are from b to a
  AlignedVector<Vec3> force;  ///< [N] on a, where slopes are asked for
  AlignedVector<Mat3> slope;  ///< [N s/m] by velocity, of pairs by that of b relative to a

  explicit Block(LawBlock made, std::size_t pairs = 0) : law(std::move(made)) {
    d.assign(pairs, zero3());
    u.assign(law.wants_motion ? pairs : 0, zero3());
  }
  virtual ~Block() = default;

  void gather_components();
  /// Finds `force` and `slope`, when it was run. A called law is run again for differences [m/s].
  void find_slopes(const Law& of, const Sites& sites, double difference);

 private:
  Vec3 force_of(LawKind kind, std::size_t k) const;
};

}  // namespace pantin
