#pragma once
// What a body's masses come to: mass, centre, principal moments, and what its points leave free.
#include <span>
#include <string>

#include "model/body.hpp"

namespace pantin {

/// A mass at a position of the body's frame; mass 0: an anchor.
struct MassPoint {
  Vec3 position;  ///< [m]
  double mass;    ///< [kg] >= 0
};

struct Weighed {
  double mass = 0.0;       ///< [kg]
  Vec3 centre = zero3();   ///< [m] in the body's frame
  Vec3 moments = zero3();  ///< [kg m²] principal, about the centre, rising; of a line the first axis is the line
  Quat axes;               ///< principal axes to the body's frame
  Freedom freedom = Freedom::rigid;
  bool bare = false;  ///< has no moment about an axis that points are off: that is lifted
};

/// The smallest moment of a body that is tied, relative to its largest: articulates are solved to round-off down to 2e-5.
constexpr double least_inertia = 1e-4;
/// Rising principal moments, none below that.
Vec3 lifted(Vec3 moments);

/// What a body weighs beside its points.
struct OwnMass {
  double mass = 0.0;        ///< [kg]
  Mat3 inertia = zero33();  ///< [kg m²] about `position`
  Vec3 position = zero3();  ///< [m] in the body's frame
};
inline OwnMass own_mass_of(const Body& body) { return {body.own_mass, body.own_inertia, body.own_position}; }

/// Weighs points together with a body's own mass. Axes come near to `near`. Throws Error, beginning with `who`, where
/// there is no mass, or mass at one position only and points elsewhere. With a unit vector `normal` in the frame, an axis of
/// `near`, it is what moves across that alone: the axes are `near`, and there is no moment but that about the normal.
Weighed weigh(const std::string& who, std::span<const MassPoint> points, const OwnMass& own, const Quat& near,
              Vec3 normal = zero3());

}  // namespace pantin
