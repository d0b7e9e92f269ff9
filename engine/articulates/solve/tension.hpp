#pragma once

namespace pantin {

struct Articulate;

/// [1/s] How fast the lightest of what rows pull taut swings across them, by their forces in the last drift; 0: none is taut.
double rate_of_tension(const Articulate& articulate);

}  // namespace pantin
