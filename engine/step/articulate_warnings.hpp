#pragma once
#include <string>
#include <string_view>

#include "articulates/articulate.hpp"
#include "world/world.hpp"

namespace pantin {

/// How the line goes on about what is tied so that it bears any load, as a straight chain between two nails.
inline constexpr std::string_view held_by_itself = " has no way to go: ";

/// What begins so is told once of a scene.
void tell_once(World& world, const std::string& kind, const std::string& what, const std::string& rest);

/// The first thing of an articulate, for whoever reads of it.
std::string first_of(const World& world, const Articulate& articulate);

/// Names, once, what stays open, stalls, is too stiff for the step, or bears more than anything asks of it.
void warn(World& world, Articulate& articulate);

}  // namespace pantin
