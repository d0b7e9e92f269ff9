#pragma once
#include <functional>
#include <memory>
#include <vector>

#include "choreography/choreography.hpp"
#include "laws/law.hpp"
#include "model/force_element.hpp"

namespace pantin {

/// Melting and freezing. While the particles of the families together are hotter than `above`, nothing that ties them to
/// each other holds: connections break, hinges are cut, joins let go. While they are colder than `below`, those that come
/// within `near` and are not tied yet get a connection, or are joined to a hinge.
struct BondingDef {
  std::vector<FamilyId> families;  ///< one: within it; two: between them
  double near = 0.0;               ///< [m] > 0
  double below = 0.0;              ///< [K]
  double above = 0.0;              ///< [K] >= below
  std::shared_ptr<const Law> law;  ///< of two particles; null: they are joined
  std::vector<double> parameters;  ///< (parameters of the law)
  Solve solve = Solve::explicitly;
  double time_constant = 0.05;                      ///< [s] > 0 of joins
  std::function<void(ConnectionId)> on_connection;  ///< called with each that is made
  std::string label;                                ///< "scene.lua:12"
};
/// The event of a bonding.
struct BondingAtWork {
  World* world = nullptr;
  BondingDef def;
  void operator()(double) const;
};
/// An over without an end; cancel it to end the bonding.
EventId add_bonding(World& world, BondingDef def);

}  // namespace pantin
