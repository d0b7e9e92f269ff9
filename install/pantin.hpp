#pragma once
// The engine: all that a program needs to make a world, move it and read it. Units are SI and radians.
#include "edit/constrain.hpp"
#include "edit/edit.hpp"
#include "laws/library.hpp"
#include "laws/symbol.hpp"
#include "measure/hits.hpp"
#include "measure/measure.hpp"
#include "measure/query.hpp"
#include "shapes/hull.hpp"
#include "snapshot/snapshot.hpp"
#include "step/step.hpp"
