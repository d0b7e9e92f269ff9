#pragma once
// What makes laws act: connections tie given particles, interactions act between all pairs of two families, fields on
// single particles.
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "model/particle.hpp"

namespace pantin {

struct Law;

/// What the three have in common.
struct ForceElement {
  std::shared_ptr<const Law> law;
  std::vector<double> parameters;  ///< (parameters of the law)
  bool enabled = true;
  std::string name;
  std::string made_at;  ///< "scene.lua:12", or empty
  std::uint64_t serial = 0;
};

/// How a connection acts: by forces at the ends of steps, or solved with its articulate, which no stiffness can make
/// unstable: at the middle of the step, where energy is exact, or at its end, which dissipates.
enum class Solve : std::uint8_t { explicitly, at_middle, at_end };

struct Connection : ForceElement {
  std::array<ParticleId, 4> particles;  ///< the first `count`
  std::uint32_t count = 2;              ///< 2, 3 or 4
  std::vector<Vec3> positions;          ///< [m] (count) where some end is a position of the world: its particle is null
  double max_force = std::numeric_limits<double>::infinity();   ///< [N] tension at which it breaks
  double max_length = std::numeric_limits<double>::infinity();  ///< [m] at which it breaks
  Solve asked = Solve::explicitly;
  Solve solve = Solve::explicitly;  ///< what it does: more than asked where the scene or its stiffness wants it
  bool too_stiff = false;           ///< for explicit steps
  double tension = 0.0;             ///< [N] in the last step, where it is solved
};

struct Interaction : ForceElement {
  FamilyId a, b;
  bool told_idle = false;  ///< that it does nothing to what it is to act on
};

struct Group;
using GroupId = Handle<Group>;

struct Field : ForceElement {
  FamilyId family;         ///< of its particles; or
  GroupId group;           ///< they are a group's members; neither: all particles
  bool told_idle = false;  ///< that it does nothing to what it is to act on
};

using ConnectionId = Handle<Connection>;
using InteractionId = Handle<Interaction>;
using FieldId = Handle<Field>;
using ForceElementId = std::variant<ConnectionId, InteractionId, FieldId>;

}  // namespace pantin
