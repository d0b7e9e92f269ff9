#pragma once
// A central law of a pair as LAMMPS reads it: values at distances, between which it interpolates.
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "player/lammps/law_of_distance.hpp"

namespace pantin::player {

/// Over what a table is even: LAMMPS looks pairs up by r², bonds by r.
enum class TableOver : std::uint8_t { square, distance };

/// What is wanted of a table.
struct TableWish {
  TableOver over = TableOver::square;
  std::vector<double> distances;  ///< [m] of such pairs that there are now, at least one
  double to =
      0.0;  ///< [m] where it ends: of a pair its cutoff, of a bond 0: where its energy is far from what it is now
  double most = std::numeric_limits<double>::infinity();  ///< [m] where that of a bond ends at the latest
  double error =
      1e-6;  ///< of energy and force between its points, relative to the value there, or to the usual one now
             ///< where that is more; of a law that does nothing yet, to a tenth of `idle_kinetic`
  double kinetic = 0.0;                       ///< [J] the largest of a particle now, which a pair may take up
  bool idle = false;                          ///< no pair is within the law's reach: the distances are made up
  double idle_kinetic = 0.0;                  ///< [J] which such a pair would bring along
  std::size_t points = 256;                   ///< at least
  std::size_t enough = std::size_t{1} << 18;  ///< where it is as exact as wished from half of the nearest distance on
  bool straight = false;                      ///< by straight lines in any case
};

struct LawTable {
  bool spline = true;  ///< between the points by cubic splines of energy and force (of pairs force / r); else straight
  std::vector<double> r;       ///< [m]
  std::vector<double> energy;  ///< [J] 0 of a law without
  std::vector<double> force;   ///< [N] pushes apart where positive
  double slope_from = 0.0;     ///< [N/m] of the force at the first
  double slope_to = 0.0;       ///< [N/m] and the last
  double error = 0.0;          ///< the largest from `good_from` on, see TableWish
  double good_from = 0.0;      ///< [m] the first, but of laws that do not vanish where particles meet
  double inner_error = 0.0;    ///< before that; 0: it is the first
  double beside = 0.0;         ///< [J] what errors are held against of a law that does nothing yet; 0: what is usual
  double usual_energy = 0.0;   ///< [J] mean size at the distances that there are now, or a hundredth more
  double usual_force = 0.0;    ///< [N] the same
  double stiffness = 0.0;      ///< [N/m] there, the largest, of what pulls back

  double from() const { return r.front(); }
  double to() const { return r.back(); }
};

/// Samples a law so densely that the wish is met. Throws Error where no table can.
LawTable make_table(LawOfDistance& law, const TableWish& wish);

/// That of the law times a factor.
LawTable times(LawTable table, double factor);

}  // namespace pantin::player
