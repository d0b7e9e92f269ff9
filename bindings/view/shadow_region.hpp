#pragma once
#include <Eigen/Core>
#include <array>

#include "view/camera.hpp"

namespace pantin {

/// The part of the ground that maps of shadows show, by where light falls there: what is seen and may be in shadow, finer
/// where it is near. Relative to the eye, in units of the camera's distance; places on the ground are (x, z).
struct ShadowRegion {
  bool empty = true;                                     ///< no shadow is seen
  Eigen::Matrix3f to_map = Eigen::Matrix3f::Identity();  ///< (x, z, 1) to a place on the map, -1 … 1, times a depth
  std::array<std::array<float, 2>, 4> corners{};         ///< as the strip of a rectangle
  float along = 1.0f,
        across = 1.0f;  ///< a length on the map is so long on the ground, over its depth squared and its depth
};

/// Of things in a box that stand above the ground or throw shadows on it; `slant` is how far light goes aside over its
/// height.
ShadowRegion find_shadow_region(Vec3 lower, Vec3 upper, double level, const std::array<double, 2>& slant,
                                const Camera& camera, double aspect);

}  // namespace pantin
