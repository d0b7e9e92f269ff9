#include <algorithm>
#include <cmath>

#include "contacts/find.hpp"
#include "contacts/motor_bounds.hpp"
#include "contacts/pass_parts.hpp"
#include "contacts/solve/even_loads.hpp"
#include "contacts/solve/ties.hpp"
#include "contacts/turning_apart.hpp"

namespace pantin {

namespace {

constexpr double soft_overlap =
    1e-8;  // of the size: what the largest load of an island makes whose loads are not made even
constexpr double as_closed =
    1e-10;  // of the size: so little may what bore come open and still bear in one whose loads are

/// Speed [m/s] with which it leaves what it meets in this step: as if it had met it at the surface; 0 where it is too slow.
double rebound_of(const Contact& c, const TouchSettings& settings, double slow) {
  if (c.restitution == 0.0 || c.approach >= -slow) return 0.0;
  const double fall = c.body_b < 0 ? -dot(c.normal, settings.gravity) : 0.0;
  return c.restitution * std::sqrt(std::max(0.0, c.approach * c.approach + 2.0 * fall * std::max(0.0, c.gap)));
}

/// [N m s] By how much an impulse with two ends apart changes the angular momentum.
Vec3 turned_by(const TouchIsland& island, const Contact& contact, const IslandContact& c) {
  if (!contact.foreseen || c.b < 0) return zero3();
  const auto end = [&](std::int32_t body, Vec3 arm) { return island.states[static_cast<std::size_t>(body)].x + arm; };
  return cross(end(c.a, c.ra) - end(c.b, c.rb), contact.place_impulse);
}

/// Kicks gave loose points half of gravity: their velocities at the start of the step are without.
void take_half_of_gravity(const Model& model, TouchIsland& island, const TouchSettings& settings) {
  for (std::size_t i = 0; i < island.things.size(); i++)
    if (is_loose_point(model, island.things[i]))
      island.problem.bodies[i].v0 -= model.plane.along(settings.gravity) * (0.5 * settings.h);
}

/// [J] What gravity, pushes and soft rows give to an island from rest in a step, or over a way that is nothing to what touches.
double forces_in_step(const Model& model, const TouchIsland& island, const Contacts& contacts,
                      const TouchSettings& settings) {
  constexpr double nothing = 1e-6;  // of the size
  double size = 0.0, energy = 0.0;
  for (const std::size_t k : island.contacts) size = std::fmax(size, contacts.list[k].size);
  for (std::size_t i = 0; i < island.things.size(); i++) {
    const double mass = island.problem.bodies[i].mass;
    Vec3 force = settings.gravity * mass + island.pulls[i].force;
    if (!is_point(island.things[i])) force += model.motion[island.things[i]].force;
    const double f = norm(force);
    energy += f * std::fmax(0.5 * f / mass * settings.h * settings.h, nothing * size);
  }
  return energy;
}

/// Forces that the drift will have beside contacts: gravity, pushes, and what soft rows pulled with last.
void foresee_forces(const Model& model, TouchIsland& island, const TouchSettings& settings) {
  const double half = 0.5 * settings.h;
  for (std::size_t i = 0; i < island.things.size(); i++) {
    IslandBody& b = island.problem.bodies[i];
    b.v0 += (model.plane.along(settings.gravity) + island.pulls[i].force * b.inverse_mass) * half;
    b.w0 += b.inverse_inertia * island.pulls[i].moment * half;
    if (is_point(island.things[i])) continue;
    const Motion& m = model.motion[island.things[i]];
    b.v0 += m.force * (half * b.inverse_mass);
    b.w0 += b.inverse_inertia * m.torque * half;
  }
}

/// Spins of what nothing ties become what they are on average in the drift: without a moment, too, momentum turns about its axes.
void foresee_spins(const Model& model, TouchIsland& island, double h) {
  for (std::size_t i = 0; i < island.things.size(); i++) {
    if (is_point(island.things[i]) || model.motion[island.things[i]].articulate >= 0) continue;
    IslandBody& b = island.problem.bodies[i];
    b.w0 += b.inverse_inertia * cross(b.inertia * b.w0, b.w0) * curving(b.w0, h);
  }
}

/// What rebounds off one of several that a body meets in the drift does not know when: it is met where it is after the drift.
void meet_several_at_end(const TouchIsland& island, Contacts& contacts, double h) {
  constexpr std::int32_t nothing = -2, several = -3;
  const ContactIsland& problem = island.problem;
  std::vector<std::int32_t> met(problem.bodies.size(), nothing);  // (bodies) what they meet
  const auto meets = [&](std::int32_t body, std::int32_t other) {
    if (body < 0) return;
    std::int32_t& one = met[static_cast<std::size_t>(body)];
    one = one == nothing || one == other ? other : several;
  };
  for (std::size_t k = 0; k < problem.contacts.size(); k++) {
    const Contact& from = contacts.list[island.contacts[k]];
    const IslandContact& c = problem.contacts[k];
    if (dot(from.normal, relative(c, problem.bodies, &IslandBody::v0, &IslandBody::w0)) * h >= -from.gap) continue;
    meets(c.a, c.b);
    meets(c.b, c.a);
  }
  const auto meets_several = [&](std::int32_t body) {
    return body >= 0 && met[static_cast<std::size_t>(body)] == several;
  };
  for (std::size_t k = 0; k < problem.contacts.size(); k++) {
    Contact& from = contacts.list[island.contacts[k]];
    const IslandContact& c = problem.contacts[k];
    if (c.b >= 0 && from.restitution > 0.0 && (problem.is_tied() || meets_several(c.a) || meets_several(c.b)))
      from.foreseen = false;
  }
}

/// What `place` wants: no gap closed by more than it is open, by the drift and by turning.
void want_no_overlaps(TouchIsland& island, Contacts& contacts, double h, double slow) {
  ContactIsland& problem = island.problem;
  const bool even = has_even_loads(problem);
  double largest = 0.0;
  for (const std::size_t k : island.contacts)
    largest = std::max(largest, dot(contacts.list[k].place_impulse, contacts.list[k].normal));
  for (std::size_t k = 0; k < problem.contacts.size(); k++) {
    Contact& from = contacts.list[island.contacts[k]];
    IslandContact& c = problem.contacts[k];
    c.compliance = even || largest == 0.0 ? 0.0 : soft_overlap * from.size / (h * largest);
    from.approach = dot(from.normal, relative(c, problem.bodies, &IslandBody::v0, &IslandBody::w0));
    const double borne = norm2(from.total) > 0.0 ? as_closed * from.size : 0.0;
    double gap = even ? std::max(0.0, from.gap - borne) / h
                      : std::max(from.gap / h, -c.compliance * std::max(0.0, dot(from.place_impulse, from.normal)));
    if (from.foreseen && c.b >= 0 && from.approach < -slow)  // they part again for the rest of the drift
      gap -= from.restitution * std::max(0.0, -from.approach - gap);
    c.bias = to_frame(c, from.belt);
    c.bias[0] = gap;
    const Vec3 turning = turning_apart(island, c, from, h);
    c.bias += turning;
    from.turning = std::fabs(turning[0]) * h;
    c.start = to_frame(c, from.place_impulse);
  }
}

/// Makes velocities what ties want, with what turning alone takes their ends off their tangents. Not with that where they would
/// have to move a body far to make up for it, as the links of a linkage that is almost straight.
void hold_turning_ties(TouchIsland& island, double h) {
  constexpr double most = 0.1;  // of the kinetic energy, that turning may give for the drift
  ContactIsland& problem = island.problem;
  if (!problem.is_tied()) return;
  for (IslandTie& t : problem.ties) {
    if (t.lever > 0.0) continue;
    const auto turned = [&](std::int32_t body, Vec3 r) {
      const Vec3 w = problem.bodies[static_cast<std::size_t>(body)].w0;
      return cross(w, cross(w, r)) * curving(w, h);
    };
    t.turning = turned(t.a, t.ra) - (t.b < 0 ? zero3() : turned(t.b, t.rb));
    t.wanted -= t.turning;
  }
  std::vector<std::array<Vec3, 2>> free;
  for (const IslandBody& b : problem.bodies) free.push_back({b.v0, b.w0});
  start_without_impulses(problem);
  const double before = kinetic_energy(problem);
  hold_ties(problem);
  if (kinetic_energy(problem) - before <= most * before + work_of_ties(problem)) return;
  for (std::size_t i = 0; i < free.size(); i++) {
    problem.bodies[i].v0 = free[i][0];
    problem.bodies[i].w0 = free[i][1];
  }
  forget_held(problem);
  forget_turning(problem);
  hold_ties(problem);
}

/// Takes turning as it is with the impulses found, of one body alone with few contacts: whether that takes it elsewhere.
bool turn_as_found(TouchIsland& island, const Contacts& contacts, double h) {
  constexpr std::size_t few = 8;
  constexpr double nothing = 1e-9;  // of the size
  ContactIsland& problem = island.problem;
  if (problem.is_tied() || problem.bodies.size() > 1 || problem.contacts.size() > few) return false;
  IslandBody& body = problem.bodies[0];
  const IslandBody free = body;
  std::array<Vec3, few> change;
  bool elsewhere = false;
  for (std::size_t k = 0; k < problem.contacts.size(); k++) {
    const Contact& from = contacts.list[island.contacts[k]];
    const auto turning = [&](Vec3 v, Vec3 w) {
      body.v0 = v;
      body.w0 = w;
      return turning_apart(island, problem.contacts[k], from, h);
    };
    change[k] = turning(free.v, free.w) - turning(free.v0, free.w0);
    elsewhere = elsewhere || norm(change[k]) * h > nothing * from.size;
  }
  body = free;
  for (std::size_t k = 0; elsewhere && k < problem.contacts.size(); k++) {
    problem.contacts[k].bias += change[k];
    problem.contacts[k].start = problem.contacts[k].impulse;
  }
  return elsewhere;
}

/// Where `place` holds a point on the world that was open, of two shapes that touched at another one, they roll on to it in the
/// drift: the other one bears until they meet it, as it did in the last drift, but no more than the forces on the body press: what
/// a blow gave in the last drift it does not give again. Not of two bodies, whose angular momentum is to be kept.
void note_rolling(const Contacts& contacts, double h, TouchIsland& island) {
  const ContactIsland& problem = island.problem;
  if (problem.is_tied() || !(contacts.drift > 0.0)) return;
  const auto contact = [&](std::size_t k) -> const Contact& { return contacts.list[island.contacts[k]]; };
  const auto is_open = [&](const Contact& c) { return c.gap > closed_gap * c.size; };
  const auto is_rolled_to = [&](const Contact& c) {
    return is_open(c) && norm2(c.place_impulse) > 0.0 && c.approach * h < -c.gap;
  };
  const auto bore = [&](const Contact& c) {
    return !is_open(c) && !c.foreseen && c.restitution == 0.0 && dot(c.total, c.normal) > 0.0;
  };
  std::size_t placed = 0;
  for (std::size_t first = 0, end = 0; first < problem.contacts.size(); first = end) {
    double part = 1.0, borne = 0.0, pressed = 0.0;  // of the drift; [N s] in it
    for (; end < problem.contacts.size() && contact(end).key.same_shapes(contact(first).key); end++) {
      const Contact& c = contact(end);
      if (bore(c)) {
        const auto a = static_cast<std::size_t>(problem.contacts[end].a);
        const IslandBody& body = problem.bodies[a];
        borne += dot(c.total, c.normal) * h / contacts.drift;
        pressed = std::max(pressed, 2.0 * body.mass * dot(island.states[a].v - body.v0, c.normal));
      }
      if (is_rolled_to(c)) part = std::min(part, c.gap / (-c.approach * h));
    }
    const bool rolls = contact(first).body_b < 0 && borne > 0.0 && part < 1.0;
    const double times = rolls ? part * std::min(1.0, pressed / borne) * h / contacts.drift : 0.0;
    for (std::size_t k = first; k < end; k++) {
      const Contact& c = contact(k);
      const IslandContact& at = problem.contacts[k];
      if (norm2(c.place_impulse) > 0.0) island.placed[placed++].rolled_on = rolls && is_rolled_to(c);
      if (rolls && bore(c))
        island.rolled.push_back({c.key,
                                 {c.body_a, c.body_b, c.key.b, c.total * times, zero3(), at.ra, at.rb, c.normal, false,
                                  zero3(), at.a, at.b}});
    }
  }
}

/// Whether one turns so far in the drift that where it touches then says nothing of where it was given impulses.
bool whirls(const Model& model, const TouchIsland& island, double h) {
  constexpr double far = 0.5;  // [rad]
  for (std::size_t i = 0; i < island.things.size(); i++) {
    const Vec3 w = island.problem.bodies[i].w;
    if (is_point(island.things[i]) || norm(w) * h <= far) continue;
    const std::vector<ShapeId>& shapes = model.bodies.at_slot(island.things[i]).shapes;
    if (shapes.size() != 1) return true;
    const Shape& shape = model.shapes[shapes[0]];
    if (norm(turn_of(shape.geometry, pose_of(model, shape), w)) * h > far) return true;
  }
  return false;
}

}  // namespace

void begin_placing(const Model& model, const Articulates& articulates, Contacts& contacts,
                   const TouchSettings& settings) {
  contacts.bodies.resize(model.bodies.slots());
  if (model.solids) contacts.points.resize(model.points.slots());
  for (const auto& articulate : articulates) {
    if (articulate->touches)
      end_jams(*articulate);
    else
      free_motors(*articulate);
    articulate->touches = false;
  }
  std::erase_if(contacts.list, [](const Contact& c) { return c.from_before; });
  for (Contact& c : contacts.list)
    if (settings.at == 0.0) c.closed_beyond = 0.0;
}

void find_placing(TouchSpace& space, Workers& workers, Model& model, const Articulates& articulates, Contacts& contacts,
                  const TouchSettings& settings, TouchReport& sum) {
  for (Contact& c : contacts.list) c.rebound = c.approach = 0.0;
  const std::vector<char> used(contacts.list.size(), 1);
  const double h = settings.h;
  const std::span<TouchIsland> islands =
      gather(space.placing, space.index, workers, model, articulates, contacts, settings, used);
  each_island(workers, islands, sum, [&](TouchIsland& island, TouchReport& report) {
    ContactIsland& problem = island.problem;
    const double slow = slow_of(settings, problem);
    meet_several_at_end(island, contacts, h);
    act_where_met(island, contacts, false);
    take_half_of_gravity(model, island, settings);
    foresee_spins(model, island, h);
    want_no_overlaps(island, contacts, h, slow);
    report.from_rest += forces_in_step(model, island, contacts, settings);
    foresee_forces(model, island, settings);
    start_rolls(problem, contacts, island.contacts, &Contact::place_moment);
    start_ties(island, articulates, Pass::place);
    set_scalars(island, articulates, h, 0.5 * h);
    hold_turning_ties(island, h);
    const auto solve = [&] { return solve_pass(contacts, island, Pass::place, settings.search, report); };
    island.solved = solve() && !whirls(model, island, h) && (!turn_as_found(island, contacts, h) || solve());
    keep_tie_impulses(articulates, island, Pass::place);
    keep_rolls(problem, contacts, island.contacts, &Contact::place_moment);
    for (std::size_t k = 0; k < problem.contacts.size(); k++) {
      Contact& to = contacts.list[island.contacts[k]];
      IslandContact& c = problem.contacts[k];
      if (c.impulse[0] * c.wn <= problem.tolerance) c.impulse = zero3();  // round-off, which holds nothing
      to.place_impulse = to_world(c, c.impulse);
      to.rebound = rebound_of(to, settings, slow);
      to.gap_before = std::max(0.0, to.gap);
      to.checks_drift = !island.missed && problem.is_tied();
      if (norm2(to.place_impulse) == 0.0) continue;
      island.placed.push_back({to.body_a, to.body_b, to.key.b, to.place_impulse, to.place_moment, c.ra, c.rb, to.normal,
                               to.foreseen, turned_by(island, to, c), c.a, c.b, c.ra + to.normal * to.round_a.radius});
    }
    note_rolling(contacts, h, island);
  });
  space.placed = islands.size();
  std::int32_t next = 0;
  for (TouchIsland& island : islands) {
    island.first_placed = static_cast<std::size_t>(next);
    for (const std::size_t k : island.contacts)
      contacts.list[k].place_index = norm2(contacts.list[k].place_impulse) > 0.0 ? next++ : -1;
  }
}

}  // namespace pantin
