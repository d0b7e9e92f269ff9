#include "contacts/solve/best_impulses.hpp"

namespace pantin {

void BestImpulses::keep(const ContactIsland& island, double now) {
  residual = now;
  contacts.clear();
  rolls.clear();
  ties.clear();
  scalars.clear();
  for (const IslandContact& c : island.contacts) contacts.push_back(c.impulse);
  for (const IslandRoll& r : island.rolls) rolls.push_back(r.impulse);
  for (const IslandTie& t : island.ties) ties.push_back(t.impulse);
  for (const IslandScalar& s : island.scalars) scalars.push_back(s.impulse);
}

void BestImpulses::put_back(ContactIsland& island) const {
  for (std::size_t k = 0; k < contacts.size(); k++) island.contacts[k].impulse = contacts[k];
  for (std::size_t k = 0; k < rolls.size(); k++) island.rolls[k].impulse = rolls[k];
  for (std::size_t k = 0; k < ties.size(); k++) island.ties[k].impulse = ties[k];
  for (std::size_t k = 0; k < scalars.size(); k++) island.scalars[k].impulse = scalars[k];
  apply_impulses(island);
  observe(island);
}

}  // namespace pantin
