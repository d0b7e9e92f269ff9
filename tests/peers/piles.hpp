#pragma once
// The cases of `pantin bench contacts`: stacks, and what falls into a bin. Friction is 0.5 and restitution 0 everywhere.
#include <cstdint>

#include "peers/mechanism.hpp"

namespace pantin::peers {

inline constexpr double friction = 0.5;

/// A case by its name and number, as in "boxes(100)": stack(n) and pyramid(rows) of unit boxes; boxes(n), balls(n), mixed(n)
/// (boxes, balls and capsules), slabs(n), chains(n) of five boxes, ragdolls(n) of ten bodies, heavy(n) (boxes of 1 kg and, each
/// 16th, 1000 kg) dropped into a bin. The same name and seed give the same bits. In a plane (z = 0) the bins are twice as wide
/// and as many more lie side by side. Throws std::invalid_argument where there is no such case.
Mechanism pile(const std::string& name, bool in_plane = false, std::uint32_t seed = 1);

/// Those that are measured where none is named.
std::vector<std::string> usual_piles();

/// [kg m²] about the centre, of a solid of even density.
Eigen::Vector3d moments_of(Form form, const Eigen::Vector3d& size, double mass);

}  // namespace pantin::peers
