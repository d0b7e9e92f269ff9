#pragma once
// What an articulate forbids of one number made of velocities: over more than two things at once, as a coupling, or within bounds,
// as a limit that only pushes and a motor that is only so strong.
#include <vector>

#include "articulates/articulate.hpp"

namespace pantin {

/// Σ along·(velocity of its row) >= wanted - room/h, h of the drift, by a force along these between the bounds; = wanted where it has none.
struct ScalarRow {
  struct Term {
    std::uint32_t row;
    Vec3 along;  ///< [1]
  };
  /// What a unit force does to a node [1], [m], about its centre, world axes.
  struct End {
    std::int32_t node;
    Vec3 force = zero3(), moment = zero3();
  };
  std::vector<Term> terms;          ///< the first is of the row that it is known by
  std::vector<End> ends;            ///< each of another node
  double wanted = 0.0;              ///< [m/s]
  double room = 0.0;                ///< [m] until it acts
  double lower = 0.0, upper = 0.0;  ///< [N] bounds of its force

  std::uint32_t row() const { return terms.front().row; }
  bool is_angular(const Articulate& a) const { return a.rows[row()].lever > 0.0; }
  bool is_bounded() const { return std::isfinite(lower) || std::isfinite(upper); }
};

/// Whether contacts meet a condition as a scalar row within bounds, not as a tie.
inline bool is_bounded(const Condition& c) { return c.ranged || is_limited(c); }

/// Those of rows as they are placed (`place_velocity_constraints`), with what they want at a moment (0 … 1) of the step [s].
std::vector<ScalarRow> scalar_rows(Articulate& articulate, double step, double wanted_at);

}  // namespace pantin
