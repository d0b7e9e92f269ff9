#include "player/lammps/live_laws.hpp"

#include <algorithm>

#include "measure/measure.hpp"
#include "player/lammps/refused.hpp"
#include "player/lammps/system.hpp"

namespace pantin::player {
namespace {

bool is_live(const Law& law) { return law.velocity_dependent || law.timed || (law.also && is_live(*law.also)); }

bool is_nothing(const Law& law) {
  return law.energy == no_expression &&
         std::ranges::all_of(law.force, [&](Expr e) { return law.graph.is_constant(e, 0.0); });
}

}  // namespace

bool LiveLaws::is_zero_everywhere(const std::string& attribute_name) {
  const auto [at, is_new] = zero_everywhere_.try_emplace(attribute_name, true);
  if (is_new)
    at->second = std::ranges::all_of(world_.particles.ids(), [&](ParticleId id) {
      return attribute(world_, id, attribute_name).value_or(0.0) == 0.0;
    });
  return at->second;
}

LiveLaws::Names LiveLaws::zeros_of(const Law& law, const ForceElement& row) {
  Names zeros;
  for (std::size_t i = 0; i < row.parameters.size(); i++)
    if (row.parameters[i] == 0.0) zeros.insert(law.parameters[i].name);
  for (const Law* part = &law; part; part = part->also.get())
    for (const Input& input : inputs_of_law(*part))
      if (input.role == Role::attribute && is_zero_everywhere(input.name)) zeros.insert(input.name);
  return zeros;
}

std::shared_ptr<Law> LiveLaws::without(const Law& law, const Names& zeros) {
  auto made = std::make_shared<Law>(law);
  made->within.reset();
  std::vector<Expr*> outputs = {&made->energy, &made->stiffness};
  for (Expr& e : made->force) outputs.push_back(&e);
  for (const Input& input : inputs_of_law(law)) {
    const bool named = input.role == Role::attribute || input.role == Role::parameter;
    if (!named || !zeros.contains(input.name)) continue;
    for (Expr* e : outputs)
      if (*e != no_expression) *e = made->graph.replaced(*e, input, made->graph.constant(0.0));
  }
  made->velocity_dependent = made->timed = false;
  for (const Input& input : inputs_of_law(*made)) {
    made->velocity_dependent = made->velocity_dependent || input.role == Role::approach ||
                               input.role == Role::relative_velocity || input.role == Role::velocity;
    made->timed = made->timed || input.role == Role::time || input.role == Role::noise;
  }
  if (!law.also) return made;
  made->also = without(*law.also, zeros);
  if (is_nothing(*made->also)) made->also = made->also->also;
  return made;
}

std::shared_ptr<const Law> LiveLaws::of(const ForceElement& row) {
  if (!is_live(*row.law) || row.law->called || row.law->thermal) return row.law;
  const Names zeros = zeros_of(*row.law, row);
  if (zeros.empty()) return row.law;
  const auto [at, is_new] = known_.try_emplace({row.law.get(), zeros}, row.law);
  if (!is_new) return at->second;
  const std::shared_ptr<Law> made = without(*row.law, zeros);
  if (is_live(*made)) return row.law;
  std::string names;
  for (const std::string& name : zeros) names += (names.empty() ? "" : ", ") + name;
  notes_.push_back(text(place_of(row), ": ", names, zeros.size() > 1 ? " are" : " is",
                        " 0, so that what depends on velocities or time is left out"));
  return at->second = made;
}

}  // namespace pantin::player
