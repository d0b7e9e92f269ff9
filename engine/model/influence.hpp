#pragma once
// What makes laws act: connections tie given particles, interactions act between all pairs of two families, fields on
// single particles.
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "model/particle.hpp"

namespace pantin {

struct Law;

struct Connection {
  std::shared_ptr<const Law> law;
  std::array<ParticleId, 4> particles;  ///< the first `count`
  std::uint32_t count = 2;              ///< 2, 3 or 4
  std::vector<Vec3> places;             ///< [m] (count) where some end is a place of the world: its particle is null
  std::vector<double> parameters;       ///< (parameters of the law)
  double max_force = std::numeric_limits<double>::infinity();   ///< [N] tension at which it breaks
  double max_length = std::numeric_limits<double>::infinity();  ///< [m] at which it breaks
  bool enabled = true;
  std::string name;
  std::string place_of_making;  ///< "scene.lua:12", or empty
  std::uint64_t serial = 0;
};

struct Interaction {
  std::shared_ptr<const Law> law;
  FamilyId a, b;
  std::vector<double> parameters;  ///< (parameters of the law)
  bool enabled = true;
  std::string name;
  std::string place_of_making;  ///< "scene.lua:12", or empty
  std::uint64_t serial = 0;
};

struct Group;
using GroupId = Handle<Group>;

struct Field {
  std::shared_ptr<const Law> law;
  FamilyId family;                 ///< of its particles; or
  GroupId group;                   ///< they are a group's members; neither: all particles
  std::vector<double> parameters;  ///< (parameters of the law)
  bool enabled = true;
  std::string name;
  std::string place_of_making;  ///< "scene.lua:12", or empty
  std::uint64_t serial = 0;
};

using ConnectionId = Handle<Connection>;
using InteractionId = Handle<Interaction>;
using FieldId = Handle<Field>;

}  // namespace pantin
