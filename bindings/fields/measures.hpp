#pragma once
#include "fields/value.hpp"
#include "measure/measure.hpp"

namespace pantin::fields {

/// The largest of all steps and of now: of large scenes a run measures in every 16th step or so.
Accuracy worst_accuracy(const World& world);
/// { kinetic, potential, total } [J].
Table table_of(const Energy& energy);
/// The events that ended, then those that wait.
Table timeline_of(const World& world);
const char* name_of(EventState state);

}  // namespace pantin::fields
