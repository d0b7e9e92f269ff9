#include "articulates/build/edges.hpp"

#include <algorithm>

#include "constraints/kind.hpp"
#include "constraints/row_rule.hpp"

namespace pantin {

namespace {

class Finder {
 public:
  Finder(const Model& model, EdgesOf which, std::vector<Edge>& edges)
      : model_(model), which_(which), edges_(edges), begin_(edges.size()) {}

  void visit(Thing t) {
    if (!t.is_body) return visit(model_.points.id_at(t.slot));
    const Body& body = model_.bodies.at_slot(t.slot);
    for (PointId point : body.points) visit(point);
    for (ConstraintId id : body.constraints) {
      const Constraint& c = model_.constraints[id];
      add(id, !c.a && c.body_a == model_.bodies.id_at(t.slot));
    }
  }

 private:
  const Model& model_;
  const EdgesOf which_;
  std::vector<Edge>& edges_;
  const std::size_t begin_;

  bool wanted(bool listed_here) const { return listed_here || which_ == EdgesOf::all; }

  void visit(PointId id) {
    const Point& point = model_.points[id];
    const Particle& ring = model_.particles[point.particle];
    const bool is_first = ring.points.front() == id;
    if (ring.joins() && wanted(is_first)) add_hinge(ring, star(model_, point.particle));
    for (ConstraintId c : point.constraints) add(c, model_.constraints[c].a == id);
    if (which_ == EdgesOf::all)  // the star is pulled by what ties other members too
      for (PointId member : ring.points) visit_connections(model_.points[member].own);
    else
      visit_connections(point.own);
    if (ring.is_hinge() && wanted(is_first)) visit_connections(point.particle);
  }

  void visit_connections(ParticleId ring) {
    for (ConnectionId id : model_.particles[ring].connections) {
      const Connection& c = model_.connections[id];
      if (!c.enabled || c.solve == Solve::explicitly) continue;
      if (wanted((c.particles[0] ? c.particles[0] : c.particles[1]) == ring)) add(id, c);
    }
  }

  void edge_a(Edge& edge, PointId point) const {
    edge.a = node_of(model_, owner(model_, point));
    edge.la = model_.plane.along(arm(model_, point));
  }
  void edge_b(Edge& edge, PointId point) const {
    edge.b = node_of(model_, owner(model_, point));
    edge.lb = model_.plane.along(arm(model_, point));
  }
  /// A position or an axis in the frame of a body, in principal axes of its node.
  std::int32_t edge(BodyId id, Vec3 v, bool is_axis, Vec3& arm) const {
    const Body& body = model_.bodies[id];
    const Vec3 turned = rotate(conjugate(body.axes), is_axis ? v : v - body.centre);
    arm = is_axis ? model_.plane.axis(turned) : model_.plane.along(turned);
    return node_of(model_, Thing{id.slot - 1, true});
  }

  void add_hinge(const Particle& ring, PointId star_point) {
    for (PointId member : ring.points) {
      if (member == star_point) continue;
      Edge edge;
      edge.may_break = ring.breaks_at.possible();
      edge_a(edge, member);
      edge_b(edge, star_point);
      edge.member = member;
      edge.star_point = star_point;
      edges_.push_back(edge);
    }
  }

  /// Whether something found from another of its ends is there already.
  template <class Is>
  bool found(Is is) const {
    return which_ == EdgesOf::all &&
           std::any_of(edges_.begin() + static_cast<std::ptrdiff_t>(begin_), edges_.end(), is);
  }

  void add(ConstraintId id, bool listed_here) {
    const Constraint& c = model_.constraints[id];
    if (!c.enabled || !wanted(listed_here) || found([&](const Edge& edge) { return edge.constraint == id; })) return;
    for (const RowPlan& plan : rule_of(c).rows(model_, c)) {
      Edge row;
      row.rule = plan.rule;
      row.angular = plan.angular;
      row.may_break = c.breaks_at.possible();
      row.index = plan.index;
      row.constraint = id;
      if (plan.point_a) edge_a(row, plan.point_a);
      if (plan.point_b) edge_b(row, plan.point_b);
      if (plan.body_a) row.a = edge(plan.body_a, plan.arm_a, plan.angular, row.la);
      if (plan.body_b) row.b = edge(plan.body_b, plan.arm_b, plan.angular, row.lb);
      edges_.push_back(row);
    }
  }

  /// Between the points at which its rings are pulled.
  void add(ConnectionId id, const Connection& c) {
    if (found([&](const Edge& edge) { return edge.connection == id; })) return;
    const bool swapped = !c.particles[0];  // a position of the world is always the second end
    const ParticleId a = c.particles[swapped ? 1 : 0], b = c.particles[swapped ? 0 : 1];
    if (b && owner(model_, star(model_, a)) == owner(model_, star(model_, b))) return;  // nothing can move
    Edge edge;
    edge.rule = &stiff_row;
    edge.connection = id;
    edge.solve = c.solve;
    edge_a(edge, star(model_, a));
    if (b) edge_b(edge, star(model_, b));
    edges_.push_back(edge);
  }
};

}  // namespace

void find_edges(const Model& model, Thing thing, EdgesOf which, std::vector<Edge>& edges) {
  Finder(model, which, edges).visit(thing);
}

Thing owner(const Model& model, PointId point) {
  const Point& p = model.points[point];
  return p.body ? Thing{p.body.slot - 1, true} : Thing{point.slot - 1, false};
}

std::int32_t& node_of(Model& model, Thing t) {
  return t.is_body ? model.motion[t.slot].node : model.points.at_slot(t.slot).node;
}
std::uint64_t serial_of(const Model& model, Thing t) {
  return t.is_body ? model.bodies.at_slot(t.slot).serial : model.points.at_slot(t.slot).serial;
}

std::int32_t node_of(const Model& model, Thing t) {
  return t.is_body ? model.motion[t.slot].node : model.points.at_slot(t.slot).node;
}

}  // namespace pantin
