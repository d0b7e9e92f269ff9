#pragma once
// How constraints look: a drawing per kind, which whoever draws, exports, frames or cuts them asks.
#include <optional>
#include <vector>

#include "view/stage.hpp"

namespace pantin {

/// What is seen of a constraint, where the periodic box has it.
struct ConstraintLook {
  struct Line {
    Vec3 from, to;        ///< [m]
    double radius = 0.0;  ///< [m]
    double least = 0.6;   ///< [px]
    bool metal = false;   ///< else of thread
    bool loaded = true;   ///< its colour may show the load
  };
  struct Knob {
    Vec3 at;              ///< [m]
    double radius = 0.0;  ///< [m], and
    double joints = 0.0;  ///< that many radii of the joint of its point, beside which it is to be seen
    bool red = false;
  };
  std::vector<Line> lines;
  std::vector<Knob> knobs;
};

struct ConstraintDrawing {
  const char *one = "tie", *many = "ties";
  /// Null: it is not to be seen. Adds to an empty look.
  void (*draw)(const World& world, const Constraint& constraint, const Stage& stage, ConstraintLook& look) = nullptr;
  /// Whether a hand may cut it.
  bool (*cuttable)(const Constraint& constraint) = nullptr;
  /// How far from its other end its point stays [m]; null: it may go anywhere.
  double (*reach)(const Constraint& constraint) = nullptr;
};

// Of each kind.
#define CONSTRAINT_KIND(name) extern const ConstraintDrawing name##_drawing;
#include "model/constraint_kinds.hpp"

const ConstraintDrawing& drawing_of(const Constraint& constraint);
/// Sets `look` to what is seen now; nothing of what is off, or of what a hand holds by.
void find_look(const World& world, const Constraint& constraint, const Stage& stage, ConstraintLook& look);
inline bool is_cuttable(const Constraint& c) {
  const ConstraintDrawing& drawing = drawing_of(c);
  return drawing.cuttable != nullptr && drawing.cuttable(c);
}

}  // namespace pantin
