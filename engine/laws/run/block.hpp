#pragma once
// One block of pairs, connections or sites on its way through a law, in one thread.
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/aligned.hpp"
#include "laws/law.hpp"
#include "laws/program.hpp"
#include "laws/run/sites.hpp"

namespace pantin {

/// Columns to be filled with what the law wants to see, null where it does not; then `run`, and columns to be read.
class LawBlock {
 public:
  static constexpr int most = Machine::block;     ///< values in a column
  static constexpr int room = Machine::distance;  ///< that a column has: what is written past its end does no harm

  struct Attribute {
    std::size_t who = 0;
    std::size_t column = 0;  ///< of Sites::attributes
    double* to = nullptr;
  };
  using Vector = std::array<double*, 3>;  ///< columns of the components

  /// Throws Error where the law wants an attribute that is not among `names`.
  LawBlock(const Law& law, bool with_energy, std::span<const std::string> names, Uniform uniform = {});

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
  /// What it was set to last.
  const Instant& instant() const { return instant_; }
  std::span<const double> parameters() const { return parameters_; }
  /// Reads a parameter in place: as many values as a block has, up to the next multiple of 16.
  void bind_parameter(std::size_t parameter, const double* values);
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
  std::vector<const double*> called_inputs_, called_parameters_;
  std::vector<const std::uint32_t*> called_particles_;
  std::vector<double*> called_outputs_;
};

}  // namespace pantin
