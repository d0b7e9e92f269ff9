#pragma once
// What a program `pantin_peer_NAME` is made of: another engine's settings, and `peer.cpp`'s main round them.
//   pantin_peer_NAME list                         names of the settings, one a line; "*" before one that chooses its steps
//   pantin_peer_NAME run SETTING CASE RATE X Y    error energy gap cost, or "trouble: …"; RATE in steps per second,
//                                                 X Y [m] where the reference has the measured body
//   pantin_peer_NAME piles                        names of the settings for piles
//   pantin_peer_NAME pile SETTING CASE SEED END MOST
//                                                 the numbers of a PileTrial, or "trouble: …"; it ends at END [s], or once
//                                                 it has used MOST [s] of the processor
#include "peers/trial.hpp"

namespace pantin::peers {

/// Each engine's own, for mechanisms without shapes and for piles.
std::vector<Setting> settings();
std::vector<Setting> pile_settings();

}  // namespace pantin::peers
