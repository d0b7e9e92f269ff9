#pragma once
// How far the particles of a scene are from each other now.
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "player/lammps/system.hpp"

namespace pantin::player {

/// Distances [m] of near particles, as far as the mean distance, around a hundred thousand of them at most.
class NearDistances {
 public:
  /// Of atoms by their numbers, whether laws leave the two out.
  using LeftOut = std::function<bool(std::uint32_t, std::uint32_t)>;

  /// The system has its atoms and types. Throws Error where two are at one position.
  NearDistances(const World& world, const LammpsSystem& system, LeftOut left_out);

  /// [m] The least.
  double nearest() const { return nearest_; }
  /// How many pairs are near, in all.
  double pairs() const { return pairs_; }
  /// [m] As far was looked.
  double spacing() const { return spacing_; }
  /// Of particles that an interaction acts on; of some of them where none are near.
  std::vector<double> of(const Interaction& row) const;

 private:
  const World& world_;
  const LammpsSystem& system_;
  LeftOut left_out_;
  std::map<std::pair<std::size_t, std::size_t>, std::vector<double>> by_types_;
  double spacing_ = 0.0, nearest_ = 0.0, pairs_ = 0.0;

  bool are_apart(std::uint32_t a, std::uint32_t b) const;
  std::vector<std::uint32_t> some_of(FamilyId family) const;
  std::vector<double> of_some(const Interaction& row) const;
  /// Whether laws act on the two.
  bool note(std::uint32_t a, std::uint32_t b, double distance);
  template <class Visit>
  void each_image(Vec3 x, Visit visit) const;
};

}  // namespace pantin::player
