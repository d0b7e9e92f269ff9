#pragma once
#include "contacts/solve/contact_search.hpp"
#include "contacts/solve/island.hpp"

namespace pantin {

/// How an island was solved, in the order of how well.
struct IslandReport {
  double residual = 0.0;  ///< [m/s] at contacts and ties
  std::uint32_t iterations = 0, factorisations = 0;
  bool failed = false;     ///< an exact search, where one was tried,
  bool too_dense = false;  ///< since it would cost more than it is worth
};

/// Has so few contacts that it is always solved exactly.
bool is_small(const ContactIsland& island);

/// Whether the mean velocity by mass is small enough at this kinetic energy [J] that an exact search is worth
/// while; within a `part` of that.
bool is_calm(const ContactIsland& island, double kinetic, double part = 1.0);

/// How far the search for a large island that is calm may go: to sweeps, to proximal rounds, to Newton's iteration after them.
enum class SearchEffort { sweeps, rounds, all };

/// Finds impulses and velocities of an island whose contacts and ties say where to begin: exactly where it is small or
/// that is asked for, as far as that succeeds, and where it is calm, as far as `effort` goes; else by sweeps. The impulses balance
/// the momenta to round-off and are in the cone, however well the law is met; `residual` says that.
IslandReport solve_island(ContactIsland& island, SearchEffort effort = SearchEffort::all,
                          ContactSearch search = ContactSearch::automatic);

}  // namespace pantin
