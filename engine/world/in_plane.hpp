#pragma once
// What a scene in a plane asks of what it is given.
#include <string_view>

#include "world/world.hpp"

namespace pantin::internal {

/// In a scene in a plane: that a vector has no part across it; that one has no part but that; that a position has the height
/// of another; that a body comes to an orientation by a turn about the normal. Throws Error where it is not so.
void require_in_plane(const World& world, std::string_view call, std::string_view name, Vec3 v, std::string_view unit);
void require_about_normal(const World& world, std::string_view call, std::string_view name, Vec3 v,
                          std::string_view unit);
void require_height(const World& world, std::string_view call, std::string_view name, Vec3 position, Vec3 of);
void require_turn(const World& world, std::string_view call, BodyId body, const Quat& orientation);
/// The same of what a constraint ties.
void require_in_plane(const World& world, const Constraint& constraint);
/// The orientation in the plane that is nearest to one.
Quat turned_in_plane(const World& world, BodyId body, const Quat& orientation);

}  // namespace pantin::internal
