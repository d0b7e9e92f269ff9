#pragma once
// Scenes in Lua, opened by a program of one's own. Their world is that of <pantin/pantin.hpp>.
#include "lua/scene/open.hpp"
#include "pantin.hpp"
#include "scene/errors.hpp"
