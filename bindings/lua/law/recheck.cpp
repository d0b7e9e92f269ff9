#include "lua/law/recheck.hpp"

#include <algorithm>
#include <bit>
#include <span>
#include <utility>
#include <variant>

#include "edit/edit.hpp"
#include "forces/forces.hpp"
#include "laws/run/sites.hpp"
#include "laws/within_cutoff.hpp"
#include "measure/query.hpp"

namespace pantin::lua {
namespace {

constexpr std::size_t sample_count = 4;
using Together = std::vector<End>;  // what one evaluation of a law sees

Vec3 place(const World& world, const End& end) { return end.particle ? position(world, end.particle) : end.position; }
Vec3 speed(const World& world, const End& end) { return end.particle ? velocity(world, end.particle) : zero3(); }
Vec3 apart(const World& world, const End& a, const End& b) {
  return Box{world.settings.box.value_or(zero3())}.nearest(place(world, b) - place(world, a));
}

/// Particles here and there in a list.
std::vector<ParticleId> some(const World& world, const std::vector<ParticleId>& list) {
  std::vector<ParticleId> chosen;
  for (std::size_t k = 0; k < std::min(sample_count, list.size()); k++)
    chosen.push_back(list[(k * 7919 + world.steps * 104729) % list.size()]);
  return chosen;
}

/// A particle here and there in the rows of an interaction, and the nearest in its row.
std::vector<Together> pairs_of(const World& world, InteractionId id) {
  std::vector<Together> list;
  if (!acting_now(world)) return list;  // what acts is found anew in this step
  const Forces& forces = *world.forces;
  const Sites& sites = forces.sites;
  const auto acting = std::find_if(forces.interactions.begin(), forces.interactions.end(),
                                   [&](const ActingInteraction& a) { return a.id == id; });
  if (acting == forces.interactions.end()) return list;
  std::vector<const Slab*> slabs;
  for (const std::vector<Slab>& phase : acting->pairs.neighbours.phases())
    for (const Slab& slab : phase)
      if (!slab.rows.empty()) slabs.push_back(&slab);
  const auto particle = [&](std::uint32_t site) { return world.particles.id_at(sites.particle[site]); };
  for (std::size_t k = 0; k < sample_count && !slabs.empty(); k++) {
    const std::size_t number = k * 7919 + world.steps * 104729;
    const Slab& slab = *slabs[number % slabs.size()];
    const NeighbourRow& row = slab.rows[number % slab.rows.size()];
    std::uint32_t nearest = sites.dummy();
    double least = infinity;
    for (std::uint32_t j : std::span(slab.list + row.begin, row.count))
      if (const double d = norm2(sites.x[j] - sites.x[row.site] + acting->pairs.neighbours.shifts()[row.shift]);
          d < least)
        least = d, nearest = j;
    if (nearest != sites.dummy()) list.push_back({{particle(row.site)}, {particle(nearest)}});
  }
  return list;
}

std::vector<Together> met_by(const World& world, const AnyId& id) {
  std::vector<Together> list;
  if (const auto* interaction = std::get_if<InteractionId>(&id)) return pairs_of(world, *interaction);
  if (const auto* connection = std::get_if<ConnectionId>(&id)) {
    const Connection& row = world.connections[*connection];
    Together ends;
    for (std::uint32_t i = 0; i < row.count; i++)
      ends.push_back({row.particles[i], row.positions.empty() ? zero3() : row.positions[i]});
    return {ends};
  }
  const pantin::Field& field = world.fields[std::get<FieldId>(id)];
  if (field.group) return {};  // whose members may be anything
  for (ParticleId p : some(world, field.family ? particles(world, field.family) : particles(world)))
    list.push_back({{p}});
  return list;
}

double value(const World& world, const Together& ends, const Input& input) {
  switch (input.role) {
    case Role::distance2: return norm2(apart(world, ends[0], ends[1]));
    case Role::approach:
      return pantin::dot(apart(world, ends[0], ends[1]), speed(world, ends[1]) - speed(world, ends[0]));
    case Role::displacement: return apart(world, ends[0], ends[1])[input.component];
    case Role::relative_velocity: return (speed(world, ends[1]) - speed(world, ends[0]))[input.component];
    case Role::position: return place(world, ends[input.who])[input.component];
    case Role::velocity: return speed(world, ends[input.who])[input.component];
    case Role::attribute:
      return ends[input.who].particle ? attribute(world, ends[input.who].particle, input.name).value_or(0.0) : 0.0;
    case Role::noise: return 0.3 + 0.1 * input.component;
    case Role::parameter:
    case Role::time: break;
  }
  return 0.0;
}

const std::vector<double>& parameters_of(const World& world, const AnyId& id) {
  if (const auto* interaction = std::get_if<InteractionId>(&id)) return world.interactions[*interaction].parameters;
  if (const auto* connection = std::get_if<ConnectionId>(&id)) return world.connections[*connection].parameters;
  return world.fields[std::get<FieldId>(id)].parameters;
}

std::string disagreement(const World& world, const TracedAtWork& at_work) {
  const std::vector<Together> met = met_by(world, at_work.id);
  if (met.empty()) return {};
  const std::vector<Input> wanted = at_work.law.function->inputs_wanted();
  std::vector<std::vector<double>> columns(wanted.size());
  std::vector<const double*> inputs;
  for (std::size_t c = 0; c < wanted.size(); c++) {
    for (const Together& ends : met) columns[c].push_back(value(world, ends, wanted[c]));
    inputs.push_back(columns[c].data());
  }
  std::vector<std::vector<std::uint32_t>> slots(met[0].size());
  std::vector<const std::uint32_t*> particles;
  for (std::size_t who = 0; who < slots.size(); who++) {
    for (const Together& ends : met) slots[who].push_back(ends[who].particle ? ends[who].particle.slot - 1 : 0);
    particles.push_back(slots[who].data());
  }
  Called::Block block;
  block.n = static_cast<int>(met.size());
  block.inputs = inputs;
  block.particles = particles;
  block.time = world.time;
  block.parameters = parameters_of(world, at_work.id);
  return recheck_law(at_work.law, block);
}

}  // namespace

void watch_law(LawsAtWork& laws, const AnyId& id, const ResolvedLaw& law) {
  if (!law.function || law.laws.front()->called) return;
  for (const TracedAtWork& known : laws.traced)
    if (known.law.function == law.function) return;
  laws.traced.push_back({id, law});
}

namespace {

/// Whether the law is traced no more.
bool follow_changes(World& world, TracedAtWork& at_work) {
  constexpr int often = 16;
  const std::shared_ptr<const Law> old = at_work.law.laws.front();
  const bool traced = trace_again(at_work.law);
  if (traced && at_work.law.laws.front() == old) return false;  // it sees what has changed, and does not read it
  if (traced && ++at_work.traced_again <= often) {
    replace_law(world, old, at_work.law.laws.front());
    return false;
  }
  log_line(
      world, "warning",
      text(at_work.law.function->law().function.place(),
           ": the scene changes what this law reads again and again: it is called in Lua from now on, some 50 to 300 "
           "times slower; as one of its parameters it may change at no cost"));
  replace_law(world, old, called_law(at_work.law.function));
  return true;
}

/// A living thing that has the law; std::monostate where none has.
AnyId user_of(const World& world, const std::shared_ptr<const Law>& law) {
  const auto find_in = [](const auto& rows, const auto& of_row) -> AnyId {
    for (const auto id : rows.ids())
      if (rows[id].law == of_row) return id;
    return {};
  };
  for (const AnyId& id :
       {find_in(world.connections, within_cutoff(law)), find_in(world.interactions, law), find_in(world.fields, law)})
    if (!std::holds_alternative<std::monostate>(id)) return id;
  return {};
}

void drop_unused(const World& world, LawsAtWork& laws) {
  std::erase_if(laws.traced, [&](TracedAtWork& t) {
    if (!alive(world, t.id)) t.id = user_of(world, t.law.laws.front());
    return std::holds_alternative<std::monostate>(t.id);
  });
}

}  // namespace

void renew_laws(World& world, LawsAtWork& laws) {
  drop_unused(world, laws);
  std::erase_if(laws.traced, [&](TracedAtWork& t) { return has_changed(t.law) && follow_changes(world, t); });
}

void recheck_laws(World& world, LawsAtWork& laws, const Runtime& runtime) {
  if (laws.traced.empty()) return;
  laws.runs_seen != runtime.runs() ? renew_laws(world, laws) : drop_unused(world, laws);
  laws.runs_seen = runtime.runs();  // those of tracing, too
  if (!std::has_single_bit(world.steps)) return;
  for (std::size_t i = 0; i < laws.traced.size(); i++) {
    const TracedAtWork at_work = laws.traced[i];
    const std::string found = disagreement(world, at_work);
    if (found.empty()) continue;
    log_line(world, "warning", found);
    replace_law(world, at_work.law.laws.front(), called_law(at_work.law.function));
    laws.traced.erase(laws.traced.begin() + static_cast<std::ptrdiff_t>(i--));
  }
}

}  // namespace pantin::lua
