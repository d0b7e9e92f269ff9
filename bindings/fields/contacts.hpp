#pragma once
#include "fields/value.hpp"
#include "world/world.hpp"

namespace pantin::fields {

/// What touches a thing (contacts/contact.hpp), or is about to and was pushed: forces on it, normals towards it.
Table contacts_of(const World& world, std::uint32_t thing);

}  // namespace pantin::fields
