#include "snapshot/check_read.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "articulates/articulate.hpp"
#include "constraints/row_rule.hpp"
#include "constraints/slider.hpp"
#include "model/path.hpp"
#include "shapes/shape.hpp"

namespace pantin {

namespace {

void sound_state(bool good) { require(good, "what is in it contradicts itself"); }

bool is_index(std::int64_t index, std::size_t size) { return index >= 0 && static_cast<std::size_t>(index) < size; }

bool all_finite(std::initializer_list<Vec3> vectors) {
  return std::all_of(vectors.begin(), vectors.end(), [](Vec3 v) { return finite(v); });
}
bool is_rotation(const Quat& q) { return std::fabs(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z - 1.0) < 1e-6; }

bool is_material(const Material& m) {
  return all_finite({m.surface_velocity, vec(m.density, m.friction, m.restitution), vec(m.rolling, m.spinning, 0)}) &&
         m.density > 0.0 && m.friction >= 0.0 && m.restitution >= 0.0 && m.restitution <= 1.0 && m.rolling >= 0.0 &&
         m.spinning >= 0.0;
}

template <class Row>
void check_handles(const Reader& from, const Store<Row>& store) {
  const auto named = from.largest_slots.find(typeid(Handle<Row>));
  require(named == from.largest_slots.end() || named->second <= store.slots(), "it names a thing that is not in it");
}

template <class Row, class Check>
void each_row(const Store<Row>& store, Check check) {
  for (std::uint32_t slot = 0; slot < store.slots(); slot++)
    if (store.alive_at(slot)) check(store.at_slot(slot), slot);
}

template <class List, class Store>
bool all_alive(const List& list, const Store& store) {
  return std::all_of(list.begin(), list.end(), [&](auto id) { return store.alive(id); });
}

/// What a node stands for: its thing has the node's number.
void check_place(const World& world, std::int32_t articulate, std::int32_t node) {
  if (world.topology_changed) return sound_state(articulate >= -1);
  sound_state(articulate == -1 ||
              (is_index(articulate, world.articulates.size()) &&
               is_index(node, world.articulates[static_cast<std::size_t>(articulate)]->nodes.size())));
}

void check_points(const World& w) {
  sound_state(w.free_motion.size() == w.points.slots());
  each_row(w.points, [&](const Point& p, std::uint32_t slot) {
    sound_state((!p.body || w.bodies.alive(p.body)) && w.particles.alive(p.own) && w.particles.alive(p.particle) &&
                all_alive(p.constraints, w.constraints));
    sound_state(std::isfinite(p.mass) && p.mass >= 0.0 && (p.body || p.mass > 0.0));
    sound_state(p.body ? finite(p.position) : all_finite({w.free_motion[slot].x, w.free_motion[slot].v}));
    const auto& members = w.particles[p.particle].points;
    sound_state(std::count(members.begin(), members.end(), w.points.id_at(slot)) == 1);
    check_place(w, p.articulate, p.node);
  });
  each_row(w.particles, [&](const Particle& p, std::uint32_t) {
    sound_state(!p.points.empty() && all_alive(p.points, w.points) && all_alive(p.connections, w.connections) &&
                all_alive(p.axes, w.constraints) && (!p.asleep_in || w.particles.alive(p.asleep_in)));
    sound_state(!p.family ? p.values.empty()
                          : w.families.alive(p.family) && p.values.size() == w.families[p.family].attributes.size());
  });
}

void check_bodies(const World& w) {
  sound_state(w.motion.size() == w.bodies.slots());
  each_row(w.bodies, [&](const Body& b, std::uint32_t slot) {
    const BodyId id = w.bodies.id_at(slot);
    sound_state(all_alive(b.points, w.points) && all_alive(b.shapes, w.shapes) &&
                all_alive(b.constraints, w.constraints));
    for (const PointId point : b.points) sound_state(w.points[point].body == id);
    for (const ShapeId shape : b.shapes) sound_state(w.shapes[shape].body == id);
    const Motion& m = w.motion[slot];
    sound_state(m.mass > 0.0 && std::isfinite(m.mass) && m.sub_steps.count > 0);
    sound_state(all_finite({m.x, m.p, m.angular, m.inertia, b.centre, b.moments}) && is_rotation(m.q) &&
                is_rotation(b.axes) && std::min({m.inertia[0], m.inertia[1], m.inertia[2]}) >= 0.0);
    check_place(w, m.articulate, m.node);
  });
}

/// Whether a run is between corners of a path, or without ends.
bool is_run_of(const Path& path, PathRun run) {
  constexpr double far = 1e9;
  const auto is_corner = [&](double u, double least, double most) {
    return u == std::floor(u) && (path.closed() ? std::fabs(u) < far : u >= least && u <= most);
  };
  return (run.from == -infinity || is_corner(run.from, 0.0, path.pieces() - 1.0)) &&
         (run.to == infinity || is_corner(run.to, 1.0, path.pieces())) && run.from <= run.to;
}

/// Whether all that only its kind has is there, and what it ties.
void check_constraint(const World& w, const Constraint& c) {
  c.each_point([&](PointId point) { sound_state(w.points.alive(point)); });
  c.each_body([&](BodyId body) { sound_state(w.bodies.alive(body)); });
  sound_state(c.hand == -1 || is_index(c.hand, w.hands.size()));
  switch (c.kind) {
    case ConstraintKind::axis: return sound_state(c.is<AxisData>() && w.particles.alive(c.ring()));
    case ConstraintKind::weld: return sound_state(c.is<WeldData>());
    case ConstraintKind::on_path:
      return sound_state(c.is<PathData>() && c.as<PathData>().path &&
                         is_run_of(*c.as<PathData>().path, c.as<PathData>().run));
    case ConstraintKind::join: return sound_state(c.is<JoinData>() && c.progress());
    case ConstraintKind::string: return sound_state(c.passages().size() >= 2 || c.coupled().size() >= 1);
    case ConstraintKind::pulley:
    case ConstraintKind::gear:
    case ConstraintKind::rack:
    case ConstraintKind::screw: return sound_state(!c.coupled().empty());
    case ConstraintKind::slider: return sound_state(c.coupled().size() == slider_values && c.a);
    default: return sound_state(c.is<std::monostate>());
  }
}

void check_rest(const World& w) {
  each_row(w.constraints, [&](const Constraint& c, std::uint32_t) { check_constraint(w, c); });
  each_row(w.shapes, [&](const Shape& s, std::uint32_t) {
    sound_state(!s.body || w.bodies.alive(s.body));
    check_shape(s.geometry);
    sound_state(s.layer <= w.layers.names.size() && finite(s.at) && is_rotation(s.orientation) &&
                is_material(s.material));
  });
  each_row(w.connections, [&](const Connection& c, std::uint32_t) {
    sound_state(c.law && c.count == static_cast<std::uint32_t>(c.law->count) &&
                c.parameters.size() == c.law->parameters.size() &&
                (c.positions.empty() || c.positions.size() == c.count));
    for (std::size_t k = 0; k < c.count; k++)
      sound_state(c.particles[k] ? w.particles.alive(c.particles[k]) : !c.positions.empty());
  });
  const auto check_element = [](const ForceElement& e, std::uint32_t) {
    sound_state(e.law && e.parameters.size() == e.law->parameters.size());
  };
  each_row(w.interactions, check_element);
  each_row(w.fields, check_element);
  each_row(w.emitters, [&](const Emitter& e, std::uint32_t) {
    sound_state((!e.point || w.points.alive(e.point)) &&
                (!e.family ? e.values.empty()
                           : w.families.alive(e.family) && e.values.size() == w.families[e.family].attributes.size()));
  });
  each_row(w.families, [&](const Family& f, std::uint32_t) {
    sound_state(!f.solid || (w.solids && f.solid->layer <= w.layers.names.size()));
  });
}

void check_world(const World& w) {
  const Settings& s = w.settings;
  sound_state(w.plane.normal >= -1 && w.plane.normal <= 2);
  sound_state(std::isfinite(s.step) && s.step > 0.0 && std::isfinite(w.time) && w.sub_steps.count > 0 && !w.locked);
  sound_state(w.loose_masses.size() == w.loose_points.size() || w.topology_changed);
  for (const std::uint32_t slot : w.loose_bodies) sound_state(slot < w.bodies.slots());
  for (const std::uint32_t slot : w.loose_points) sound_state(slot < w.points.slots());
  for (const std::int32_t k : w.disturbed) sound_state(k == -1 || is_index(k, w.articulates.size()));
  for (const EditedThing& thing : w.edited_things)
    sound_state(thing.articulate == -1 || is_index(thing.articulate, w.articulates.size()));
}

/// What is due has a state, and something to do; what is measured, a measure.
void check_choreography(const Choreography& c) {
  each_row(c.events, [](const Event& e, std::uint32_t) {
    sound_state(e.state != nullptr && !std::isnan(e.time) && (e.kind != EventKind::every || e.period > 0.0));
    sound_state(e.kind == EventKind::over ? static_cast<bool>(e.progress) : e.kind != EventKind::play && e.action);
    sound_state(e.kind != EventKind::when || e.condition.measure);
  });
}

void check_contacts(const World& w) {
  const Contacts& c = w.contacts;
  const auto is_thing = [&](std::uint32_t thing) {
    return slot_of(thing) < (is_point(thing) ? w.points.slots() : w.bodies.slots());
  };
  const auto is_shape = [&](std::uint32_t shape) {
    return is_point(shape) ? is_thing(shape) : shape < w.shapes.slots();
  };
  for (const auto* list : {&c.list, &c.sensed, &c.resting, &c.resting_sensed})
    for (const Contact& x : *list) {
      sound_state(all_finite({x.at, x.belt, x.place_impulse, x.place_moment, x.total, x.total_moment,
                              vec(x.gap, x.friction, x.restitution), vec(x.rolling, x.spinning, x.size)}) &&
                  std::fabs(norm2(x.normal) - 1.0) < 1e-6 && x.size > 0.0 && x.friction >= 0.0 && x.rolling >= 0.0 &&
                  x.spinning >= 0.0);
      sound_state(is_shape(x.key.a) && is_shape(x.key.b) && is_thing(x.body_a) &&
                  (x.body_b == -1 || (x.body_b >= 0 && is_thing(static_cast<std::uint32_t>(x.body_b)))));
    }
  for (const PutOverlap& put : c.put) sound_state(is_shape(put.a) && is_shape(put.b));
  for (const PassingPair& pair : c.passing) sound_state(is_shape(pair.a) && is_shape(pair.b));
  for (const std::uint32_t slot : c.sleepers) sound_state(slot < w.bodies.slots() && slot < c.bodies.size());
  sound_state(c.bodies.size() <= w.bodies.slots() && c.points.size() <= w.points.slots());
}

/// Whether the constraint of a row has what the row is of: its coupling, its part of a string, its path, the bodies that it turns.
bool has_its_part(const World& w, const Condition& condition, const Row& row) {
  if (!w.constraints.alive(condition.constraint)) return true;
  const Constraint& c = w.constraints[condition.constraint];
  if (is_coupled(row) && c.is<CouplingData>()) return condition.index < c.coupled().size();
  if (c.kind == ConstraintKind::string) return condition.index + 1 < c.passages().size();
  if (row.rule == &path_row) return c.is<PathData>();
  return row.lever == 0.0 || (w.bodies.alive(c.body_a) && (!c.body_b || w.bodies.alive(c.body_b)));
}

void check_articulate(const World& w, const Articulate& a) {
  for (const Node& node : a.nodes) sound_state(node.slot < (node.is_body ? w.bodies.slots() : w.points.slots()));
  for (const Node& node : a.saved) sound_state(node.slot < (node.is_body ? w.bodies.slots() : w.points.slots()));
  sound_state(a.plane.normal == w.plane.normal && a.sub_steps.count > 0);
  for (const Row& row : a.rows)
    if (row.condition >= 0) sound_state(has_its_part(w, condition(a, row), row));
}

}  // namespace

void check_read(const Reader& from, const World& w) {
  check_handles(from, w.points);
  check_handles(from, w.particles);
  check_handles(from, w.bodies);
  check_handles(from, w.constraints);
  check_handles(from, w.groups);
  check_handles(from, w.families);
  check_handles(from, w.connections);
  check_handles(from, w.interactions);
  check_handles(from, w.fields);
  check_handles(from, w.emitters);
  check_handles(from, w.shapes);
  check_handles(from, w.choreography.events);
  check_world(w);
  check_points(w);
  check_bodies(w);
  check_rest(w);
  check_choreography(w.choreography);
  check_contacts(w);
  for (const auto& articulate : w.articulates) check_articulate(w, *articulate);
  if (w.forces) check_read(*w.forces, w);
}

}  // namespace pantin
