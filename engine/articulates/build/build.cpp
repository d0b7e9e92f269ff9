// Makes the nodes and rows of an articulate, orders them by elimination and lays out the factor. What was there before
// an edit keeps the history from which the unknowns are predicted.
#include "articulates/build/build.hpp"

#include <algorithm>

#include "articulates/build/elimination.hpp"
#include "articulates/build/history.hpp"
#include "articulates/build/row_graph.hpp"
#include "articulates/solve/node_batches.hpp"
#include "articulates/solve/state.hpp"
#include "constraints/kind.hpp"
#include "constraints/slider.hpp"
#include "constraints/stiff.hpp"

namespace pantin {

namespace {

void weigh(Node& n, const Model& model) {
  if (n.is_body) {
    const Motion& m = model.motion[n.slot];
    n.mass = m.mass;
    n.inertia = m.inertia;
    n.inverse_inertia = inverse_inertia(m);
    n.turns = m.freedom != Freedom::point;
  } else {
    n.mass = model.points.at_slot(n.slot).mass;
    n.inertia = n.inverse_inertia = zero3();
    n.turns = false;
  }
  n.inverse_mass = 1.0 / n.mass;
}

/// Least radius of gyration of the bodies of an angular row, [m].
double lever(const Articulate& a, const Row& row) {
  const auto gyration = [&](std::int32_t node) {
    const Node& n = a.nodes[static_cast<std::size_t>(node)];
    return std::sqrt((n.inertia[0] + n.inertia[1] + n.inertia[2]) * (0.5 * n.inverse_mass));
  };
  return row.b < 0 ? gyration(row.a) : std::min(gyration(row.a), gyration(row.b));
}

/// Numbers nodes in the order in which the rows meet them; `things` (nodes) in that order.
struct NodeOrder {
  std::vector<std::uint32_t> things, first_rows;
};

NodeOrder order_nodes(const std::vector<Edge>& edges, const std::vector<std::uint32_t>& order, std::size_t count,
                      std::vector<std::int32_t>& position) {
  NodeOrder nodes;
  nodes.things.reserve(count);
  nodes.first_rows.reserve(count);
  position.assign(count, -1);
  for (std::uint32_t k = 0; k < order.size(); k++)
    for (std::int32_t node : {edges[order[k]].a, edges[order[k]].b}) {
      if (node < 0 || position[static_cast<std::size_t>(node)] >= 0) continue;
      position[static_cast<std::size_t>(node)] = static_cast<std::int32_t>(nodes.things.size());
      nodes.things.push_back(static_cast<std::uint32_t>(node));
      nodes.first_rows.push_back(k);
    }
  return nodes;
}

void add_nodes(Articulate& a, Model& model, std::span<const Thing> things, const NodeOrder& order) {
  a.nodes.reserve(things.size());
  for (std::size_t k = 0; k < order.things.size(); k++) {
    const Thing t = things[order.things[k]];
    Node& n = a.nodes.emplace_back();
    n.slot = t.slot;
    n.is_body = t.is_body;
    n.first_row = order.first_rows[k];
    weigh(n, model);
    node_of(model, t) = static_cast<std::int32_t>(k);
  }
}

Condition make_condition(const Model& model, const Edge& edge, Row& row) {
  Condition condition;
  condition.constraint = edge.constraint;
  condition.index = edge.index;
  if (edge.connection) {
    make_stiff(model, edge.connection, row, condition);
    return condition;
  }
  const Constraint& c = model.constraints[edge.constraint];
  condition.kept_value = c.number.now;
  const CoupledValue* const value = edge.rule->coupled && !c.coupled().empty() ? &c.coupled()[edge.index] : nullptr;
  const CoupledValue* const apart = value != nullptr && c.as<CouplingData>().apart ? value : nullptr;
  condition.turns_axis = edge.angular && value != nullptr && value->point_a;
  condition.sum = apart ? edge.index : 0;
  condition.held = condition.held_before =
      !(apart ? is_end_of_slider(c, edge.index) : has_range(c)) && !edge.rule->held_at_end && std::isinf(c.max_torque);
  row.f = condition.turns_axis ? zero3() : edge.angular ? c.torque / row.lever : apart ? apart->force : c.force;
  return condition;
}

/// What the last steps found out of a row.
void inherit(const History::Match& before, Row& row, Condition* condition) {
  row.f = before.row->f;
  if (condition == nullptr || condition->stiff) return;
  const Condition& old = pantin::condition(*before.articulate, *before.row);
  condition->held = old.held;
  condition->held_before = old.held_before;
}

/// Returns whether the row was there before.
bool add_row(Articulate& a, const Model& model, const Edge& edge, const std::vector<std::int32_t>& position,
             const History& history) {
  const auto index = static_cast<std::uint32_t>(a.rows.size());
  Row& row = a.rows.emplace_back();
  row.rule = edge.rule;
  row.a = position[static_cast<std::size_t>(edge.a)];
  if (edge.b >= 0) row.b = position[static_cast<std::size_t>(edge.b)];
  row.la = edge.la;
  row.lb = edge.lb;
  row.member = edge.member;
  row.star_point = edge.star_point;
  if (edge.angular) row.lever = lever(a, row);
  if (edge.member) {
    row.f = model.points[edge.member].row_force;
  } else {
    row.condition = static_cast<std::int32_t>(a.conditions.size());
    a.conditions.push_back(make_condition(model, edge, row));
    a.conditions.back().row = index;
  }
  const History::Match before = history.row(edge);
  Predictor::OfRow& forces = a.predictor.forces.emplace_back();
  if (before.row == nullptr) return false;
  forces = before.articulate->predictor.forces[before.index()];
  inherit(before, row, edge.member ? nullptr : &a.conditions.back());
  return true;
}

}  // namespace

std::unique_ptr<Articulate> build_articulate(Model& model, std::span<const Thing> things, const Articulates& before) {
  const History history(model, things, before);
  for (std::size_t i = 0; i < things.size(); i++) node_of(model, things[i]) = static_cast<std::int32_t>(i);
  std::vector<Edge> edges;
  edges.reserve(things.size());
  for (Thing t : things) find_edges(model, t, EdgesOf::listed, edges);
  const RowLists rows_on = rows_of_nodes(things.size(), edges);
  std::vector<char> is_body;
  for (Thing t : things) is_body.push_back(t.is_body ? 1 : 0);
  const std::vector<HubNode> hubs = find_hubs(edges, rows_on, is_body);
  const std::uint32_t variables = variables_of(hubs);
  Elimination elimination = minimum_degree(neighbours_of(edges, rows_on, hubs), variables);
  elimination.order.resize(edges.size());
  std::vector<std::int32_t> position;
  const NodeOrder order = order_nodes(edges, elimination.order, things.size(), position);

  auto articulate = std::make_unique<Articulate>();
  Articulate& a = *articulate;
  a.plane = model.plane;
  a.serial = serial_of(model, things.front());
  a.factor = lay_out(std::move(elimination.columns));
  a.breakable = std::any_of(edges.begin(), edges.end(), [](const Edge& edge) { return edge.may_break; });
  history.inherit(a);
  add_nodes(a, model, things, order);
  a.rows.reserve(edges.size());
  a.predictor.forces.reserve(edges.size());
  for (std::uint32_t k : elimination.order)
    if (!add_row(a, model, edges[k], position, history)) disturb(a);
  for (const HubNode& hub : hubs)
    a.hubs.push_back(
        {static_cast<std::uint32_t>(position[hub.node]), a.factor.rows - variables + hub.variable, {}, {}});
  std::sort(a.hubs.begin(), a.hubs.end(), [](const Hub& x, const Hub& y) { return x.node < y.node; });
  a.right_side.resize(a.factor.rows);
  a.f_saved.resize(a.rows.size());
  a.impulses.resize(a.rows.size());
  a.symmetric_impulses.resize(a.rows.size());
  find_row_blocks(a);
  find_dimensions(a, model);
  lay_out_batches(a);
  find_tiles(a);
  history.inherit(a, order.things);
  load_conditions(a, model);  // a kick may ask for them before the step's drift does
  return articulate;
}

namespace {

/// Whether a node is as heavy as its thing.
bool weighs_as_built(const Model& model, const Node& node) {
  Node now{};
  now.slot = node.slot;
  now.is_body = node.is_body;
  weigh(now, model);
  return now.mass == node.mass && same(now.inertia, node.inertia) && now.turns == node.turns;
}

}  // namespace

bool is_row_of(const Articulate& a, const Row& row, const Edge& edge) {
  if (row.rule != edge.rule || row.member != edge.member || row.star_point != edge.star_point ||
      !same(row.la, edge.la) || !same(row.lb, edge.lb))
    return false;
  if (edge.member) return true;
  const Condition& c = condition(a, row);
  if (edge.connection) return c.stiff && c.stiff->connection == edge.connection && c.stiff->solve == edge.solve;
  return c.constraint == edge.constraint && c.index == edge.index;
}

bool is_as_built(const Model& model, const Articulate& a, Thing t) {
  const std::int32_t node = node_of(model, t);
  const auto index = static_cast<std::size_t>(node);
  if (!weighs_as_built(model, a.nodes[index])) return false;
  std::vector<Edge> edges;
  find_edges(model, t, EdgesOf::all, edges);
  std::erase_if(edges, [&](const Edge& edge) { return edge.a != node && edge.b != node; });
  const auto there = [&](const Edge& edge) {
    if (edge.may_break && !a.breakable) return false;
    const auto rows = a.rows_on[index];
    return std::any_of(rows.begin(), rows.end(), [&](std::uint32_t k) {
      return a.rows[k].a == edge.a && a.rows[k].b == edge.b && is_row_of(a, a.rows[k], edge);
    });
  };
  return edges.size() == a.rows_on[index].size() && std::all_of(edges.begin(), edges.end(), there);
}

}  // namespace pantin
