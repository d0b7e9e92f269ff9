#include <algorithm>

#include "edit/common.hpp"
#include "edit/edit.hpp"
#include "forces/solved.hpp"
#include "laws/library.hpp"
#include "laws/run/block.hpp"
#include "laws/run/sites.hpp"
#include "laws/within_cutoff.hpp"

namespace pantin {

using namespace internal;

namespace {

std::vector<double> checked_parameters(std::string_view call, const Law& law, std::vector<double> values) {
  if (values.empty())
    for (const Parameter& p : law.parameters) values.push_back(p.value);
  require(values.size() == law.parameters.size(), call, ": the law has ", law.parameters.size(), " parameters, got ",
          values.size());
  check_parameters(call, law.name, law.parameters, values);
  return values;
}

const char* kind_name(LawKind kind) {
  static constexpr const char* names[] = {"pair", "pair", "point", "many"};
  return names[static_cast<std::size_t>(kind)];
}

bool is_pair(const Law& law) { return law.kind == LawKind::central || law.kind == LawKind::pair; }

std::size_t ends_of(const Law& law) { return is_pair(law) ? 2 : static_cast<std::size_t>(law.count); }

/// Throws Error where there is no law, or it has not what its kind gives.
void require_law(std::string_view call, const std::shared_ptr<const Law>& law) {
  require(law != nullptr, call, ": a law is needed, got none");
  constexpr int most = 4;  // particles
  const int least = is_pair(*law) ? 2 : 1;
  const bool many = law->kind == LawKind::many;
  require(law->kind <= LawKind::many && law->count >= least && law->count <= (many ? most : least), call,
          ": the law \"", law->name, "\" is of no kind, or of ", law->count, " particles");
  const auto outside = [&](Expr e) { return !law->graph.has(e); };
  const auto missing = [&](Expr e) { return e != no_expression && outside(e); };
  require(law->called || (law->force.size() == force_outputs(*law) &&
                          std::none_of(law->force.begin(), law->force.end(), outside) && !missing(law->energy) &&
                          !missing(law->stiffness)),
          call, ": the law \"", law->name, "\" has no force; central_potential and its like make laws");
}

/// Every end alive, none twice, at least one that can move.
void check_ends(const World& world, const Law& law, std::span<const End> ends) {
  const std::size_t wanted = ends_of(law);
  require(law.kind != LawKind::point, "connect: a point law acts on single particles; use scene:field");
  require(ends.size() == wanted, "connect: a ", kind_name(law.kind), " law ties ", wanted, " particles, got ",
          ends.size());
  bool any = false;
  for (std::size_t i = 0; i < ends.size(); i++) {
    if (!ends[i].particle) {
      require_finite("connect", "a position", ends[i].position, "m");
      continue;
    }
    any = true;
    require(world.particles.alive(ends[i].particle), "connect: ", world.particles.story(ends[i].particle));
    for (std::size_t j = 0; j < i; j++)
      require(!ends[j].particle || awake(world, ends[j].particle) != awake(world, ends[i].particle),
              "connect: ", describe(world, ends[i].particle), " is given twice");
  }
  require(any, "connect: one of its ends must be a particle; all are positions");
}

void write_parameter(const Law& law, std::vector<double>& values, std::size_t index, double value) {
  require(index < values.size(), "parameters: the law \"", law.name, "\" has ", values.size(),
          ", counted from 0, got the index ", index);
  const std::string& name = law.parameters[index].name;
  require(!given_by_world(name), "parameters: ", name, " is the scene's, and cannot be written here");
  values[index] = value;
  check_parameter("parameters", law.name, law.parameters, values, index);
}

}  // namespace

double present_value(const World& world, std::span<const End> ends) {
  const Box box{world.settings.box.value_or(zero3())};
  std::vector<Vec3> positions;
  for (const End& end : ends) {
    const Vec3 at = end.particle ? position(world, end.particle) : end.position;
    positions.push_back(positions.empty() ? at : positions.back() + box.nearest(at - positions.back()));
  }
  return present_value(positions);
}

ConnectionId add_connection(World& world, std::shared_ptr<const Law> law, const ConnectionDef& def) {
  require_unlocked(world, "connect");
  require_law("connect", law);
  check_ends(world, *law, def.ends);
  require_positive_or_infinite("connect", "breaks_at.force", def.max_force, "N");
  require_positive_or_infinite("connect", "breaks_at.length", def.max_length, "m");
  Connection row;
  row.parameters = checked_parameters("connect", *law, def.parameters);
  row.law = within_cutoff(law);
  row.count = static_cast<std::uint32_t>(def.ends.size());
  row.max_force = def.max_force;
  row.max_length = def.max_length;
  row.name = def.name;
  row.made_at = world.who ? world.who() : "";
  row.serial = world.next_serial++;
  for (std::size_t i = 0; i < def.ends.size(); i++) {
    row.particles[i] = def.ends[i].particle;
    if (!row.particles[i]) row.positions.resize(def.ends.size(), zero3());
  }
  for (std::size_t i = 0; i < row.positions.size(); i++) row.positions[i] = def.ends[i].position;
  row.asked = def.solve;
  require(
      row.asked == Solve::explicitly || can_be_solved(world, row), "connect: ",
      world.settings.box ? "implicit = true works in open space, and this scene is a periodic box"
      : world.plane.flat()
          ? "implicit = true needs ends at one height in scene.plane, and a law of their distance, traced, two-sided "
            "and without noise"
          : "implicit = true needs a law of the distance of two particles, traced, two-sided and "
            "without noise");
  disturb_forces(world);
  world.stiffness_unknown = true;
  const ConnectionId id = world.connections.add(std::move(row));
  for (const End& end : def.ends)
    if (end.particle) world.particles[end.particle].connections.push_back(id);
  return id;
}

InteractionId add_interaction(World& world, std::shared_ptr<const Law> law, FamilyId a, FamilyId b,
                              std::vector<double> parameters) {
  require_unlocked(world, "interact");
  require_law("interact", law);
  require(is_pair(*law), "interact: it needs a pair law, got a ", kind_name(law->kind), " law");
  for (FamilyId family : {a, b}) require(world.families.alive(family), "interact: ", world.families.story(family));
  Interaction row;
  row.parameters = checked_parameters("interact", *law, std::move(parameters));
  row.law = std::move(law);
  row.a = a;
  row.b = b;
  row.made_at = world.who ? world.who() : "";
  row.serial = world.next_serial++;
  disturb_forces(world);
  return world.interactions.add(std::move(row));
}

FieldId add_field(World& world, std::shared_ptr<const Law> law, const AnyId& target, std::vector<double> parameters) {
  require_unlocked(world, "field");
  require_law("field", law);
  require(law->kind == LawKind::point, "field: it needs a point law, got a ", kind_name(law->kind), " law");
  Field row;
  if (const FamilyId* family = std::get_if<FamilyId>(&target)) {
    require(world.families.alive(*family), "field: ", world.families.story(*family));
    row.family = *family;
  } else if (const GroupId* group = std::get_if<GroupId>(&target)) {
    require(world.groups.alive(*group), "field: ", world.groups.story(*group));
    row.group = *group;
  } else {
    require(std::holds_alternative<std::monostate>(target), "field: it acts on a family, a group or the scene, got ",
            describe(world, target));
  }
  row.parameters = checked_parameters("field", *law, std::move(parameters));
  row.law = std::move(law);
  row.made_at = world.who ? world.who() : "";
  row.serial = world.next_serial++;
  disturb_forces(world);
  return world.fields.add(std::move(row));
}

namespace {

/// What ties things into one articulate is to be found anew.
void touch_solved(World& world, const Connection& c) {
  if (c.solve == Solve::explicitly) return;
  for (ParticleId end : {c.particles[0], c.particles[1]})
    if (end && world.particles.alive(end)) mark_edited(world, end);
}

void take_out(World& world, ConnectionId id, Obituary obituary) {
  const Connection row = world.connections[id];
  disturb_forces_by_break(world, row);
  touch_solved(world, row);
  for (std::uint32_t i = 0; i < row.count; i++)
    if (row.particles[i] && world.particles.alive(row.particles[i]))
      std::erase(world.particles[row.particles[i]].connections, id);
  world.connections.remove(id, std::move(obituary));
}

}  // namespace

void remove(World& world, ConnectionId id) {
  require_unlocked(world, "remove");
  take_out(world, id, obituary(world, describe(world, id)));
  notice(world, Notice::Kind::removed, id, world.connections.story(id));
}

void internal::break_connection(World& world, ConnectionId id, double force) {
  const Connection& row = world.connections[id];
  if (world.breaks.size() == most_breaks) world.breaks.pop_front();
  world.breaks.push_back({end_of(world, row, 0), end_of(world, row, 1), next_time(world)});
  const double length = norm(end_of(world, row, 1) - end_of(world, row, 0));
  const std::string by =
      std::fabs(force) > row.max_force ? text("its load of ", force, " N") : text("its length of ", length, " m");
  take_out(world, id, {describe(world, id), next_time(world), by});
  world.notices.push_back({Notice::Kind::broke, id, -1, world.connections.story(id), force});
}

void remove(World& world, InteractionId id) {
  require_unlocked(world, "remove");
  const std::string what = describe(world, id);
  disturb_forces(world);
  world.interactions.remove(id, obituary(world, what));
}

void remove(World& world, FieldId id) {
  require_unlocked(world, "remove");
  const std::string what = describe(world, id);
  disturb_forces(world);
  world.fields.remove(id, obituary(world, what));
}

void set_enabled(World& world, const ForceElementId& id, bool enabled) {
  require_unlocked(world, "enabled");
  ForceElement& row = force_element(world, id);
  disturb_forces(world);
  if (const auto* connection = std::get_if<ConnectionId>(&id)) {
    world.stiffness_unknown = true;
    touch_solved(world, world.connections[*connection]);
  }
  row.enabled = enabled;
}

void set_parameter(World& world, const ForceElementId& id, std::size_t index, double value) {
  require_unlocked(world, "parameters");
  ForceElement& row = force_element(world, id);
  std::vector<double> values = row.parameters;
  write_parameter(*row.law, values, index, value);
  std::shared_ptr<Law> remade;
  if (std::holds_alternative<InteractionId>(id) && row.law->remade) {
    remade = row.law->remade(values);
    remade->name = row.law->name;
  }
  disturb_forces(world);
  if (std::holds_alternative<ConnectionId>(id)) world.stiffness_unknown = true;
  if (remade) row.law = remade;
  row.parameters = values;
}

void replace_law(World& world, const std::shared_ptr<const Law>& law, const std::shared_ptr<const Law>& by) {
  require_unlocked(world, "replace_law");
  for (const auto& one : {law, by}) require_law("replace_law", one);
  const bool alike = is_pair(*law) ? is_pair(*by) : law->kind == by->kind;
  require(alike && ends_of(*law) == ends_of(*by), "replace_law: a ", kind_name(law->kind), " law of ", ends_of(*law),
          " particles, got a ", kind_name(by->kind), " law of ", ends_of(*by), " for it");
  require(law->parameters.size() == by->parameters.size(), "replace_law: the law has ", law->parameters.size(),
          " parameters, got one of ", by->parameters.size(), " for it");
  disturb_forces(world);
  world.stiffness_unknown = true;
  const auto replace = [](auto& rows, const auto& old, const auto& now) {
    for (std::uint32_t s = 0; s < rows.slots(); s++)
      if (rows.alive_at(s) && rows.at_slot(s).law == old) rows.at_slot(s).law = now;
  };
  replace(world.connections, within_cutoff(law), within_cutoff(by));
  replace(world.interactions, law, by);
  replace(world.fields, law, by);
}

void set_breaks_at(World& world, ConnectionId id, double max_force, double max_length) {
  require_unlocked(world, "breaks_at");
  require_positive_or_infinite("connection", "breaks_at.force", max_force, "N");
  require_positive_or_infinite("connection", "breaks_at.length", max_length, "m");
  world.connections[id].max_force = max_force;
  world.connections[id].max_length = max_length;
}

}  // namespace pantin
