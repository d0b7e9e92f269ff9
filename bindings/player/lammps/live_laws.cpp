#include "player/lammps/live_laws.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "base/random.hpp"
#include "forces/forces.hpp"
#include "player/lammps/refused.hpp"
#include "player/lammps/system.hpp"

namespace pantin::player {
namespace {

bool is_live(const Law& law) { return law.velocity_dependent || law.timed || (law.also && is_live(*law.also)); }

/// Whether a law without energy gives no force wherever one looks: what is left of a part without its damping, as
/// max(k x, 0) - k x for an overlap x >= 0, need not be a 0 that its expression shows.
bool is_nothing(const Law& law, std::span<const double> parameters) {
  if (law.energy != no_expression) return false;
  Random random{1, 0};
  for (int look = 0; look < 1000; look++) {
    const double size = std::pow(10.0, 8.0 * random.uniform() - 4.0);
    std::vector<double> values;
    for (const Input& input : law.graph.inputs()) {
      double x = size * random.uniform();
      if (input.role != Role::attribute && input.role != Role::distance2 && random.uniform() < 0.5) x = -x;
      for (std::size_t i = 0; input.role == Role::parameter && i < parameters.size(); i++)
        if (law.parameters[i].name == input.name) x = parameters[i];
      values.push_back(x);
    }
    for (Expr e : law.force)
      if (law.graph.evaluate(e, values) != 0.0) return false;
  }
  return true;
}

std::string listed(const std::set<std::string>& names) {
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  return all + (names.size() > 1 ? " are 0" : " is 0");
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
  if (law.also) made->also = without(*law.also, zeros);
  return made;
}

std::shared_ptr<const Law> LiveLaws::live_part(const Law& law, const ForceElement& row, const Names& zeros) {
  const std::shared_ptr<Law> made = without(law, zeros);
  if (is_live(*made)) return nullptr;
  if (made->also && !made->also->also && is_nothing(*made->also, row.parameters)) made->also = nullptr;
  return made;
}

/// Without any of which it would be live.
LiveLaws::Names LiveLaws::needed_of(const Law& law, const Names& zeros) {
  Names needed;
  for (const std::string& name : zeros) {
    Names others = zeros;
    others.erase(name);
    if (is_live(*without(law, others))) needed.insert(name);
  }
  return needed.empty() ? zeros : needed;
}

std::shared_ptr<const Law> LiveLaws::of(const ForceElement& row) {
  if (!is_live(*row.law) || row.law->called || row.law->thermal) return row.law;
  const Names zeros = zeros_of(*row.law, row);
  if (zeros.empty()) return row.law;
  const auto [at, is_new] = known_.try_emplace({row.law.get(), zeros}, row.law);
  if (!is_new) return at->second;
  const std::shared_ptr<const Law> made = live_part(*row.law, row, zeros);
  if (!made) return row.law;
  notes_.push_back(text(place_of(row), ": ", listed(needed_of(*row.law, zeros)),
                        ", so that what depends on velocities or time is left out"));
  return at->second = made;
}

}  // namespace pantin::player
