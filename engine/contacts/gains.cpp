#include "contacts/gains.hpp"

#include <algorithm>

#include "base/sets.hpp"

namespace pantin {

double gains(const Model& model, std::span<const TouchIsland> placed, std::span<const TouchIsland> met,
             std::span<const WorkOnThing> beside) {
  std::vector<std::size_t> owner(model.bodies.slots() + (model.solids ? model.points.slots() : 0), 0);  // 0: none
  std::vector<const TouchIsland*> islands = {nullptr};
  for (const std::span<const TouchIsland> some : {placed, met})
    for (const TouchIsland& island : some) islands.push_back(&island);
  Sets sets(islands.size());
  for (std::size_t i = 1; i < islands.size(); i++)
    for (const std::uint32_t thing : islands[i]->things) {
      const std::size_t number = number_of(model, thing);
      if (number >= owner.size()) continue;
      if (owner[number] != 0) sets.join(owner[number], i);
      owner[number] = i;
    }
  std::vector<double> work(islands.size(), 0.0), belts(islands.size(), 0.0);
  for (std::size_t i = 1; i < islands.size(); i++) {
    const bool is_placed = i <= placed.size();
    work[sets.find(i)] += islands[i]->report.work + (is_placed ? islands[i]->placed_work : 0.0);
    belts[sets.find(i)] += is_placed ? 0.0 : islands[i]->report.belts;
  }
  for (const auto& [thing, by] : beside) work[sets.find(owner[thing])] += by;
  double sum = 0.0;
  for (std::size_t i = 0; i < work.size(); i++) sum += std::max(0.0, work[i] - std::max(0.0, belts[i]));
  return sum;
}

}  // namespace pantin
