#pragma once
// Motions of all nodes of an articulate as vectors, with the scalar product of the kinetic energy.
#include <Eigen/Core>
#include <functional>
#include <memory_resource>
#include <vector>

#include "base/vectors4.hpp"

namespace pantin {

/// Of four nodes, world axes: velocities, and the momenta that go with them.
struct BatchMotion {
  Vec3x4 v = zero3x4(), w = zero3x4();  ///< [m/s], [rad/s]
  Vec3x4 p = zero3x4(), L = zero3x4();  ///< [kg m/s], [kg m²/s]
};
/// A kick makes and drops many vectors of one size: their memory is kept, for whoever asks next.
std::pmr::memory_resource& kept_memory();
template <class T>
struct Kept {
  using value_type = T;
  Kept() = default;
  template <class U>
  Kept(const Kept<U>&) {}
  T* allocate(std::size_t n) { return static_cast<T*>(kept_memory().allocate(n * sizeof(T), alignof(T))); }
  void deallocate(T* memory, std::size_t n) noexcept { kept_memory().deallocate(memory, n * sizeof(T), alignof(T)); }
  bool operator==(const Kept&) const = default;
};
using Motions = std::vector<BatchMotion, Kept<BatchMotion>>;

/// v_a · p_b + w_a · L_b over all nodes [J].
double product(const Motions& a, const Motions& b);
double size_of(const Motions& motions);  ///< [J^½]
void add(Motions& to, const Motions& more, double times);
/// Adds impulses [N s], [N m s] to the momenta in a lane.
void push(BatchMotion& to, std::size_t lane, Vec3 impulse, Vec3 angular);

/// An orthonormal basis q of motions that grows, with Galerkin's matrix of the forces that laws make at each of them.
struct MotionSpace {
  std::vector<Motions> directions;
  Eigen::MatrixXd galerkin;  ///< [1/s] (i, j): q_i · the forces at q_j

  /// Takes a direction apart from the others, and adds it unless it is hardly more than what answers leave of what was
  /// forbidden, of a motion of size `size_of_all` [J^½]; how much of it was new. A small new part is projected again by
  /// `allowed`: what earlier projections left forbidden would dominate it.
  double add_direction(Motions direction, double size_of_all, const std::function<Motions(const Motions&)>& allowed);
  /// Adds the row and the column of the last direction; `forces` (directions) are those at each, as momenta by time.
  void add_forces(const std::vector<Motions>& forces);
  /// [1/s] The fastest rate at which the forces take from a motion in it: the largest eigenvalue of minus the
  /// symmetric part of Galerkin's matrix.
  double fastest_decay() const;

 private:
  double orthogonalise(Motions& direction) const;  // Gram and Schmidt
};

}  // namespace pantin
