#pragma once
#include <string>
#include <unordered_set>
#include <variant>
#include <vector>

#include "model/body.hpp"
#include "model/constraint.hpp"
#include "model/emitter.hpp"
#include "model/family.hpp"
#include "model/force_element.hpp"
#include "model/particle.hpp"
#include "model/shape.hpp"

namespace pantin {

struct Group;
/// Any thing a script can name.
using AnyId = std::variant<std::monostate, PointId, ParticleId, BodyId, ConstraintId, Handle<Group>, FamilyId,
                           ConnectionId, InteractionId, FieldId, EmitterId, ShapeId>;

/// A named set of things, in the order of adding.
struct Group {
  std::vector<AnyId> members;
  std::unordered_set<AnyId> known;  ///< the same, to ask whether one is in it
  std::size_t sweep = 64;           ///< number of members at which the dead are dropped
  std::string name;
  std::uint64_t serial = 0;
};

}  // namespace pantin
