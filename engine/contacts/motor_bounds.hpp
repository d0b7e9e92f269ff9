#pragma once
#include <span>

#include "contacts/bodies.hpp"
#include "contacts/passes.hpp"

namespace pantin {

/// Bounds the motors of an articulate that have no limit of their torque by what brings all that touches in its island to their
/// speed in half a drift, and lifts it twice over: what jams then stops, where an endless torque would let speeds grow.
void bound_motors(Articulate& articulate, const Model& model, const Articulates& articulates,
                  std::span<const Contact> contacts, std::span<const std::size_t> touching,
                  const TouchSettings& settings);
/// Has a motor that contacts stop exert nothing in the drift.
void jam(Condition& motor);
/// Ends that.
void end_jams(Articulate& articulate);
/// Lets motors of what touches no longer have no limit again.
void free_motors(Articulate& articulate);

}  // namespace pantin
