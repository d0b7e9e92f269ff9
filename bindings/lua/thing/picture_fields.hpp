#pragma once
#include "lua/thing/fields.hpp"

namespace pantin::lua {

/// `picture` of a body's shapes and of a collider; `sprite` of a body and of a family.
Field picture_of_body();
Field picture_of_collider();
Field sprite_of_body();
Field sprite_of_family();

}  // namespace pantin::lua
