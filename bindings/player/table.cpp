#include "player/table.hpp"

#include "player/csv.hpp"

namespace pantin::player {

void Times::add(const World& world) {
  if (world.steps <= first_step) values = {};
  if (values.empty()) first_step = world.steps > 0 ? world.steps - 1 : 0;
  const std::size_t count = world.steps - first_step;
  values.shorten(count);
  for (std::size_t i = values.size(); i < count; i++)  // more than one where a script went forward again
    values.push_back(world.time - static_cast<double>(count - 1 - i) * world.settings.step);
}

std::string probe_table(const Times& times, const std::vector<Probe>& probes) {
  std::string out = "time";
  for (const Probe& probe : probes) out.append(1, ',').append(csv_cell(probe.name));
  out += "\n";
  for (std::size_t row = 0; row < times.values.size(); row++) {
    out += number_text(times.values[row]);
    for (const Probe& probe : probes) {
      out += ",";
      std::uint64_t step = times.first_step + row;
      bool known = step >= probe.first_step && step - probe.first_step < probe.values.size();
      if (known) out += number_text(probe.values[step - probe.first_step]);
    }
    out += "\n";
  }
  return out;
}

}  // namespace pantin::player
