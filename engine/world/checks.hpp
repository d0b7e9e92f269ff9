#pragma once
// What calls check of what they are given, and what they then say.
#include <string>
#include <string_view>

#include "base/check_values.hpp"
#include "world/world.hpp"

namespace pantin::internal {

/// Throws Error unless the world may be edited now; `call` begins the message.
void require_unlocked(const World& world, std::string_view call);

/// Throw Error where there is no such step [s], or no such integrator.
void require_step(double step);
void require_integrator(Integrator integrator);
/// Throws Error where settings, which anybody may write, cannot be.
void check_settings(const Settings& settings);

/// Finite, symmetric, positive semidefinite and of a real body: no principal moment above the sum of the others.
void require_inertia(std::string_view call, const Mat3& inertia);
/// Throws Error where a constraint cannot keep this number.
void require_kept(std::string_view call, const Constraint& constraint, double value);
/// The quaternion at unit length; throws Error where it has none.
Quat unit(std::string_view call, const Quat& q);

}  // namespace pantin::internal
