#pragma once
// What calls check of what they are given, and what they then say.
#include <string>
#include <string_view>

#include "world/world.hpp"

namespace pantin::internal {

/// Throws Error unless the world may be edited now; `call` begins the message.
void require_unlocked(const World& world, std::string_view call);

std::string to_text(Vec3 v);
/// "<call>: <name> must be finite, got (NaN, 0, 0) m"
void require_finite(std::string_view call, std::string_view name, Vec3 v, std::string_view unit);
void require_finite(std::string_view call, std::string_view name, double x, std::string_view unit);
void require_positive(std::string_view call, std::string_view name, double x, std::string_view unit);
/// Above zero, or infinite.
void require_positive_or_infinite(std::string_view call, std::string_view name, double x, std::string_view unit);
void require_not_negative(std::string_view call, std::string_view name, double x, std::string_view unit);
/// Finite, symmetric, positive semidefinite and of a real body: no principal moment above the sum of the others.
void require_inertia(std::string_view call, const Mat3& inertia);
/// Whether a constraint can keep this number, and an error where it cannot.
bool can_keep(const Constraint& constraint, double value);
void require_kept(std::string_view call, const Constraint& constraint, double value);
/// The quaternion at unit length; throws Error where it has none.
Quat unit(std::string_view call, const Quat& q);

}  // namespace pantin::internal
