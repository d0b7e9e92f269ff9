#include "player/lammps/refused.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "choreography/bonding.hpp"
#include "choreography/choreography.hpp"
#include "laws/curve.hpp"
#include "laws/law.hpp"
#include "player/lammps/live_laws.hpp"
#include "world/checks.hpp"

namespace pantin::player {
namespace {

const char* const as_spring = "tie the same points by a stiff `force.spring`";

/// Things of one kind, told once.
class Refusals {
 public:
  explicit Refusals(const World& world) : world_(world) {}

  /// One more of `what`, which is to be mended as told; `first` names it.
  void add(const std::string& what, const std::string& first, const std::string& remedy) {
    Kind& kind = kinds_[what];
    if (kind.count++ > 0) return;
    kind.first = first;
    kind.remedy = remedy;
    order_.push_back(what);
  }

  std::vector<std::string> told() const {
    std::vector<std::string> list;
    for (const std::string& what : order_) {
      const Kind& kind = kinds_.at(what);
      const std::string more = kind.count > 1 ? text(" and ", kind.count - 1, " more") : "";
      list.push_back(text(what, " (", kind.first, more, "): ", kind.remedy));
    }
    return list;
  }

  const World& world() const { return world_; }

 private:
  struct Kind {
    std::size_t count = 0;
    std::string first, remedy;
  };
  const World& world_;
  std::map<std::string, Kind> kinds_;
  std::vector<std::string> order_;
};

void look_at_ties(Refusals& refusals) {
  const World& world = refusals.world();
  for (ParticleId id : world.particles.ids())
    if (world.particles[id].is_hinge())
      refusals.add("a hinge", describe(world, id), std::string("LAMMPS has rigid bodies but no joints; ") + as_spring);
  for (ConstraintId id : world.constraints.ids()) {
    const Constraint& constraint = world.constraints[id];
    if (constraint.enabled && constraint.hand >= 0)
      refusals.add("a hand that holds something", describe(world, id),
                   "let it go (hand:release()), or pull by a field in place of it");
    else if (constraint.enabled)
      refusals.add(text("a constraint, ", kind_name(constraint.kind)), describe(world, id),
                   std::string("take it away, or ") + as_spring);
  }
  if (!world.plane.flat()) return;
  const bool thermal = std::ranges::any_of(
      world.fields.ids(), [&](FieldId id) { return world.fields[id].enabled && world.fields[id].law->thermal; });
  refusals.add("scene.plane", "everything moves in a plane",
               thermal ? "leave it out, and hold what the thermostat pushes out of the plane by a field across it, as "
                         "force.point{ potential = function(p) return 50 * p.position.z ^ 2 end }"
                       : "leave it out: what begins in a plane and is pushed along it stays there");
}

void look_at_touch(Refusals& refusals) {
  const World& world = refusals.world();
  const char* const repel =
      "give families a pair law that pushes, as force.repel or force.wca, and walls a field force.wall";
  for (ShapeId id : world.shapes.ids()) refusals.add("a shape that touches", describe(world, id), repel);
  for (FamilyId id : world.families.ids())
    if (world.families[id].solid) refusals.add("a solid family", describe(world, id), repel);
}

const char* const pushed = "give a velocity or a field in place of it, or save the state a step later (--save-at)";

void look_at_pushes(Refusals& refusals) {
  const World& world = refusals.world();
  for (PointId id : world.points.ids())
    if (!world.points[id].body && norm2(world.points[id].force) > 0.0)
      refusals.add("a push that the next step takes", describe(world, id), pushed);
}

void look_at_bodies(Refusals& refusals) {
  const World& world = refusals.world();
  for (BodyId id : world.bodies.ids()) {
    const Body& body = world.bodies[id];
    if (body.points.empty() || body.own_mass > 0.0 || trace(body.own_inertia) > 0.0)
      refusals.add("a body with mass beside its points", describe(world, id),
                   "give its mass to its points: points = { { at = vec(0, 0, 0), mass = 1 }, … }");
    for (PointId point : body.points)
      if (world.points[point].mass == 0.0)
        refusals.add("a point without mass", describe(world, point), "give it a mass, or leave it out");
    const Vec3 inertia = world.motion_of(id).inertia;
    const double most = largest(inertia);
    for (int k = 0; k < 3; k++)
      if (inertia[k] > 0.0 && inertia[k] < 1e-5 * most)
        refusals.add("a body that is all but a line", describe(world, id),
                     "LAMMPS takes a moment of inertia below 1e-7 of the largest for none: put its points on one line, "
                     "or farther "
                     "from it");
    const Motion& motion = world.motion_of(id);
    if (norm2(motion.force) + norm2(motion.torque) > 0.0)
      refusals.add("a push that the next step takes", describe(world, id), pushed);
    if (body.points.size() > 1 && body.freedom == Freedom::point)
      refusals.add("a body all of whose points are at one position", describe(world, id), "make it a particle");
  }
}

void look_at_lives(Refusals& refusals) {
  const World& world = refusals.world();
  for (EmitterId id : world.emitters.ids())
    refusals.add("an emitter", describe(world, id),
                 "let it run here, save the state (--save-at), take the emitter away, and give LAMMPS that state");
  for (ParticleId id : world.particles.ids()) {
    const Particle& particle = world.particles[id];
    if (std::isfinite(particle.lifetime))
      refusals.add("a particle whose life ends", describe(world, id), "give no lifetime");
    if (particle.curves)
      for (const auto& curve : particle.curves->list)
        if (curve->name != "color")
          refusals.add(text("'", curve->name, "', which follows the age of particles"), describe(world, id),
                       "give it a number");
  }
}

const char* const after_it =
    "end before it (--until), or run it here to a time after it (pantin run SCENE --until T --save-at T "
    "--save-to later.pantin) and give LAMMPS that state";

const char* const in_pieces =
    "LAMMPS keeps the connections that there are: let it bond here, cancel it (local bonding = scene:bonding{ … } "
    "scene:at(T, function() bonding:cancel() end)), save the state after that (--save-at), and give LAMMPS that state";

void look_at_events(const Scene& scene, double until, Refusals& refusals) {
  const World& world = refusals.world();
  for (const std::string& place : scene.behaviours())
    refusals.add("a behaviour, what a script does in each step", place,
                 "LAMMPS runs no Lua: leave it out, or make it a field or a law");
  for (EventId id : world.choreography.events.ids()) {
    const Event& event = world.choreography.events[id];
    const std::string place = event.label.empty() ? text("event ", event.serial) : event.label;
    if (event.progress.target<BondingAtWork>() != nullptr) {
      refusals.add("a bonding, which makes and breaks connections", place, in_pieces);
      continue;
    }
    switch (event.kind) {
      case EventKind::once:
        if (event.time <= until) refusals.add("an event", text(place, ", at ", event.time, " s"), after_it);
        break;
      case EventKind::over:
        if (event.time <= until)
          refusals.add("an event over a time", text(place, ", from ", event.time, " s"), after_it);
        break;
      case EventKind::every: refusals.add("an event that comes again and again", place, "leave it out"); break;
      case EventKind::when:
        refusals.add("an event that waits for a condition", place,
                     "leave it out, or save the state after it (--save-at)");
        break;
      case EventKind::play: refusals.add("a play", place, "leave it out"); break;
    }
  }
}

/// Why LAMMPS has no such law; empty: it has.
std::string why_not(const Law& law, bool of_pair) {
  if (law.called)
    return text("it is called in Lua for each ", of_pair ? "pair" : "particle",
                ", since it could not be traced (said above); write it so that it can");
  if (law.kind == LawKind::many) return "it is a law of three or four particles; use springs between pairs";
  if (law.kind == LawKind::pair)
    return "its force is a vector, not along the line of the pair; write it as a potential of r";
  if (law.one_sided) return "it acts on one of the two alone; let it act on both";
  if (law.timed && !law.thermal) return "it depends on time or noise; leave it out";
  if (law.velocity_dependent && !law.thermal)
    return of_pair ? "it depends on velocities; leave its damping out, and cool by force.thermostat"
                   : "it depends on velocities; leave its friction or damping out, LAMMPS gets force.thermostat alone";
  if (!law.also) return "";
  const std::string why = why_not(*law.also, of_pair);
  return why.empty() ? "it has a part without energy beside one with; make them two laws" : why;
}

void look_at_law(const ForceElement& element, bool of_pair, LiveLaws& laws, Refusals& refusals) {
  if (!element.enabled || !element.law) return;
  if (const std::string why = why_not(*laws.of(element), of_pair); !why.empty())
    refusals.add(text("the law ", place_of(element)), "a law", why);
}

void look_at_laws(Refusals& refusals) {
  const World& world = refusals.world();
  LiveLaws laws(world);
  for (InteractionId id : world.interactions.ids()) {
    const Interaction& row = world.interactions[id];
    look_at_law(row, true, laws, refusals);
    if (row.enabled && row.law->kind == LawKind::central && !std::isfinite(row.law->cutoff) && !row.law->touching)
      refusals.add(text("the law ", place_of(row)), "no cutoff", "a table ends somewhere: give cutoff = …, in m");
    if (row.enabled && row.law->exclude > 3)
      refusals.add(text("the law ", place_of(row)), text("exclude = ", row.law->exclude),
                   "LAMMPS leaves pairs out up to 3 connections apart");
  }
  for (FieldId id : world.fields.ids()) look_at_law(world.fields[id], false, laws, refusals);
  for (ConnectionId id : world.connections.ids()) {
    const Connection& row = world.connections[id];
    if (!row.enabled) continue;
    look_at_law(row, true, laws, refusals);
    if (!row.positions.empty())
      refusals.add("a connection to a position of the world", describe(world, id),
                   "hold the particle by a field, as a potential of its position");
    if (std::isfinite(row.max_force) || std::isfinite(row.max_length))
      refusals.add("a connection that may break", describe(world, id), "give it no breaks_at");
  }
}

}  // namespace

std::string place_of(const ForceElement& element) {
  const std::string& name = element.law->name;
  return element.made_at.empty() || name.starts_with(element.made_at) ? name : text(element.made_at, ": ", name);
}

std::vector<std::string> refused_by_lammps(const Scene& scene, double until) {
  Refusals refusals(scene.world());
  look_at_ties(refusals);
  look_at_touch(refusals);
  look_at_bodies(refusals);
  look_at_pushes(refusals);
  look_at_lives(refusals);
  look_at_events(scene, until, refusals);
  look_at_laws(refusals);
  return refusals.told();
}

}  // namespace pantin::player
