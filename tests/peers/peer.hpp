#pragma once
// What a program `pantin_peer_NAME` is made of: another engine's settings, and `peer.cpp`'s main round them.
//   pantin_peer_NAME list                         names of the settings, one a line; "*" before one that chooses its steps
//   pantin_peer_NAME run SETTING CASE RATE X Y    error energy gap cost, or "trouble: …"; RATE in steps per second,
//                                                 X Y [m] where the reference has the measured body
#include "peers/trial.hpp"

namespace pantin::peers {

/// Each engine's own.
std::vector<Setting> settings();

}  // namespace pantin::peers
