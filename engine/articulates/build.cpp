// Makes the nodes and rows of an articulate, orders them by elimination and lays out the factor.
#include <algorithm>
#include <unordered_map>

#include "articulates/batches.hpp"
#include "articulates/conditions.hpp"
#include "articulates/islands.hpp"
#include "articulates/stiff.hpp"
#include "articulates/strand.hpp"
#include "model/path.hpp"

namespace pantin {

namespace {

std::vector<std::vector<std::uint32_t>> rows_of_nodes(std::size_t nodes, const std::vector<Row>& rows) {
  std::vector<std::vector<std::uint32_t>> on(nodes);
  for (std::uint32_t k = 0; k < rows.size(); k++) {
    on[static_cast<std::size_t>(rows[k].a)].push_back(k);
    if (rows[k].b >= 0) on[static_cast<std::size_t>(rows[k].b)].push_back(k);
  }
  return on;
}

struct Builder {
  const Model& model;
  std::unordered_map<std::uint64_t, std::int32_t> node_of;  // 2 slot + is_body
  std::vector<Node> nodes;
  std::vector<Row> rows;
  std::vector<Condition> conditions;
  bool breakable = false;

  static std::uint64_t key(Thing t) { return 2ull * t.slot + (t.is_body ? 1 : 0); }

  Thing holder(PointId point) const {
    const Point& p = model.points[point];
    return p.body ? Thing{p.body.slot - 1, true} : Thing{point.slot - 1, false};
  }

  void add_node(Thing t) {
    Node n{};
    n.slot = t.slot;
    n.is_body = t.is_body;
    if (t.is_body) {
      const Motion& m = model.motion[t.slot];
      n.mass = m.mass;
      n.inertia = m.inertia;
      n.inverse_inertia = inverse_inertia(m);
      n.turns = m.freedom != Freedom::point;
    } else {
      n.mass = model.points.at_slot(t.slot).mass;
      n.inertia = n.inverse_inertia = zero3();
      n.turns = false;
    }
    n.inverse_mass = 1.0 / n.mass;
    node_of[key(t)] = static_cast<std::int32_t>(nodes.size());
    nodes.push_back(n);
  }

  void tie_a(Row& row, PointId point) const {
    row.a = node_of.at(key(holder(point)));
    row.la = arm(model, point);
  }
  void tie_b(Row& row, PointId point) const {
    row.b = node_of.at(key(holder(point)));
    row.lb = arm(model, point);
  }

  void add_hinge(const Particle& ring, PointId centre) {
    breakable = breakable || ring.breaks_at.possible();
    for (PointId member : ring.points) {
      if (member == centre) continue;
      Row row;
      tie_a(row, member);
      tie_b(row, centre);
      row.member = member;
      row.centre = centre;
      row.f = row.f_last = model.points[member].row_force;
      rows.push_back(row);
    }
  }

  /// A place or an axis in the frame of a body, in principal axes of its node.
  std::int32_t tie(BodyId id, Vec3 v, bool is_axis, Vec3& arm) const {
    const Body& body = model.bodies[id];
    arm = rotate(conjugate(body.axes), is_axis ? v : v - body.centre);
    return node_of.at(key({id.slot - 1, true}));
  }

  /// Least radius of gyration of the bodies of a couple, [m].
  double lever(const Row& row) const {
    const auto gyration = [&](std::int32_t node) {
      const Node& n = nodes[static_cast<std::size_t>(node)];
      return std::sqrt((n.inertia[0] + n.inertia[1] + n.inertia[2]) * (0.5 * n.inverse_mass));
    };
    return row.b < 0 ? gyration(row.a) : std::min(gyration(row.a), gyration(row.b));
  }

  void add_constraint(ConstraintId id) {
    const Constraint& c = model.constraints[id];
    breakable = breakable || c.breaks_at.possible();
    for (const RowPlan& plan : plan_rows(model, c)) {
      Row row;
      row.kind = plan.kind;
      if (plan.point_a) tie_a(row, plan.point_a);
      if (plan.point_b) tie_b(row, plan.point_b);
      if (plan.body_a) row.a = tie(plan.body_a, plan.arm_a, plan.couple, row.la);
      if (plan.body_b) row.b = tie(plan.body_b, plan.arm_b, plan.couple, row.lb);
      if (plan.couple) row.lever = lever(row);
      row.condition = static_cast<std::int32_t>(conditions.size());
      Condition condition;
      condition.constraint = id;
      condition.length = c.length;
      condition.part = plan.part;
      condition.held = condition.held_before =
          c.kind != ConstraintKind::limit && c.kind != ConstraintKind::string && !c.path && std::isinf(c.max_torque);
      conditions.push_back(condition);
      row.f = row.f_last = plan.couple ? c.torque / row.lever : c.force;
      rows.push_back(row);
    }
  }

  /// Of a connection that is solved here: between the points at which its rings are pulled.
  void add_stiff(ConnectionId id) {
    const Connection& c = model.connections[id];
    const bool swapped = !c.particles[0];  // a place of the world is always the second end
    const ParticleId a = c.particles[swapped ? 1 : 0], b = c.particles[swapped ? 0 : 1];
    if (b && holder(star(model, a)) == holder(star(model, b))) return;  // nothing between them can move
    Row row;
    Condition condition;
    condition.stiff = std::make_shared<StiffTie>();
    StiffTie& tie = *condition.stiff;
    tie.connection = id;
    tie.a = a;
    tie.b = b;
    tie.solve = c.solve;
    tie_a(row, star(model, a));
    if (b) tie_b(row, star(model, b));
    if (!b) condition.whole0 = condition.whole1 = c.places[swapped ? 0 : 1];
    const Vec3 d = position(model, a) - (b ? position(model, b) : condition.whole1);
    tie.least2 = 1e-24 * (norm2(d) > 0.0 ? norm2(d) : 1.0);
    for (auto law = c.law; law; law = law->also) tie.curves.emplace_back(*law);
    for (auto* column : {&tie.energy0, &tie.energy1, &tie.pulls, &tie.given}) column->resize(tie.curves.size());
    row.kind = RowKind::stiff;
    row.condition = static_cast<std::int32_t>(conditions.size());
    row.f = row.f_last = direction(d) * -c.tension;
    conditions.push_back(condition);
    rows.push_back(row);
  }

  void add_rows(Thing t) {
    const auto visit_ring = [&](ParticleId ring) {
      for (ConnectionId id : model.particles[ring].connections) {
        const Connection& c = model.connections[id];
        const ParticleId first = c.particles[0] ? c.particles[0] : c.particles[1];
        if (c.enabled && c.solve != Solve::explicitly && first == ring) add_stiff(id);
      }
    };
    const auto visit = [&](PointId point) {
      const ParticleId ring_id = model.points[point].particle;
      const Particle& ring = model.particles[ring_id];
      if (ring.joins() && ring.points.front() == point) add_hinge(ring, star(model, ring_id));
      for (ConstraintId id : model.points[point].constraints)
        if (model.constraints[id].enabled && model.constraints[id].a == point) add_constraint(id);
      visit_ring(model.points[point].own);
      if (ring.is_hinge() && ring.points.front() == point) visit_ring(ring_id);
    };
    if (!t.is_body) return visit(model.points.id_at(t.slot));
    const Body& body = model.bodies.at_slot(t.slot);
    for (PointId point : body.points) visit(point);
    for (ConstraintId id : body.constraints)
      if (model.constraints[id].enabled && model.constraints[id].body_a == model.bodies.id_at(t.slot))
        add_constraint(id);
  }

  std::vector<std::vector<std::uint32_t>> neighbours() const {
    std::vector<std::vector<std::uint32_t>> graph(rows.size());
    const auto on = rows_of_nodes(nodes.size(), rows);
    for (const auto& list : on)
      for (std::uint32_t i : list)
        for (std::uint32_t j : list)
          if (i != j) graph[i].push_back(j);
    meet_as_strings(on, graph);
    for (auto& list : graph) {
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
    }
    return graph;
  }

  /// Any segment of a string may become its head, which meets whatever its segments meet.
  void meet_as_strings(const std::vector<std::vector<std::uint32_t>>& on,
                       std::vector<std::vector<std::uint32_t>>& graph) const {
    for (std::uint32_t i = 0; i < rows.size(); i++) {
      if (rows[i].kind != RowKind::strand) continue;
      const auto constraint_of = [&](std::uint32_t k) {
        return conditions[static_cast<std::size_t>(rows[k].condition)].constraint;
      };
      for (std::uint32_t j = 0; j < rows.size(); j++) {
        if (rows[j].kind != RowKind::strand || constraint_of(i) != constraint_of(j)) continue;
        for (std::int32_t node : {rows[j].a, rows[j].b})
          if (node >= 0)
            for (std::uint32_t k : on[static_cast<std::size_t>(node)])
              if (k != i) {
                graph[i].push_back(k);
                graph[k].push_back(i);
              }
        if (j != i) graph[i].push_back(j);
      }
    }
  }

  /// Rows in the order of elimination, nodes in the order in which the rows meet them.
  void sort(const std::vector<std::uint32_t>& order) {
    std::vector<Row> sorted_rows;
    sorted_rows.reserve(rows.size());
    for (std::uint32_t k : order) sorted_rows.push_back(rows[k]);
    rows = std::move(sorted_rows);
    std::vector<std::int32_t> place(nodes.size(), -1);
    std::vector<Node> sorted;
    sorted.reserve(nodes.size());
    const auto take = [&](std::int32_t& node, std::uint32_t row) {
      std::int32_t& p = place[static_cast<std::size_t>(node)];
      if (p < 0) {
        p = static_cast<std::int32_t>(sorted.size());
        sorted.push_back(nodes[static_cast<std::size_t>(node)]);
        sorted.back().first_row = row;
      }
      node = p;
    };
    for (std::uint32_t k = 0; k < rows.size(); k++) {
      take(rows[k].a, k);
      if (rows[k].b >= 0) take(rows[k].b, k);
    }
    nodes = std::move(sorted);
    for (std::uint32_t k = 0; k < rows.size(); k++)
      if (rows[k].condition >= 0) conditions[static_cast<std::size_t>(rows[k].condition)].row = k;
  }
};

void find_meetings(Articulate& a) {
  const auto on = rows_of_nodes(a.nodes.size(), a.rows);
  std::vector<char> reached(a.factor.below.size(), 0);
  a.first_meeting.assign(1, 0);
  for (std::uint32_t n = 0; n < a.nodes.size(); n++) {
    for (std::uint32_t i : on[n])
      for (std::uint32_t j : on[n]) {
        if (i < j) continue;
        const std::uint32_t block = i == j ? i : a.factor.block(i, j);
        a.meetings.push_back({block, false, false});
        if (i != j) reached[block] = 1;
      }
    a.first_meeting.push_back(static_cast<std::uint32_t>(a.meetings.size()));
  }
  find_strands(a);
  for (Strand& strand : a.strands) {
    const auto clear = [&](std::uint32_t block) {
      if (reached[block]) return;
      reached[block] = 1;
      strand.cleared.push_back(block);
    };
    for (const StrandMeeting& m : strand.meetings)
      if (m.column != strand.head) clear(m.block);
    for (const StrandLink& link : strand.links) clear(link.block);
  }
  for (std::uint32_t& t : a.factor.target) {
    if (t & Factor::on_diagonal || reached[t]) continue;
    reached[t] = 1;
    t |= Factor::is_first;
  }
}

void find_waves(Articulate& a) {
  constexpr std::uint32_t stretch = 8;
  const auto rows = static_cast<std::uint32_t>(a.rows.size()), batches = static_cast<std::uint32_t>(a.batches.size());
  std::vector<std::uint32_t> last_row(batches, 0), last_batch(rows, 0);
  for (std::uint32_t k = 0; k < rows; k++)
    for (std::int32_t n : {a.rows[k].a, a.rows[k].b}) {
      if (n < 0) continue;
      const auto batch = static_cast<std::uint32_t>(n) / static_cast<std::uint32_t>(batch_size);
      last_row[batch] = k;
      last_batch[k] = std::max(last_batch[k], batch);
    }
  for (const Strand& strand : a.strands)
    for (std::uint32_t k : strand.segments) last_batch[strand.head] = std::max(last_batch[strand.head], last_batch[k]);
  Wave w;
  while (w.forces < rows) {
    w.forces = std::min(rows, w.forces + stretch);
    while (w.batches < batches && last_row[w.batches] < w.forces) w.batches++;
    while (w.rows < rows && last_batch[w.rows] < w.batches) w.rows++;
    const std::vector<std::uint32_t>&first = a.factor.first, &below = a.factor.below;
    while (w.columns < w.rows && (first[w.columns + 1] == first[w.columns] || below[first[w.columns + 1] - 1] < w.rows))
      w.columns++;
    a.waves.push_back(w);
  }
}

/// Clears `coupled` about the axis of symmetry that both arms lie on.
void find_free_axes(Articulate& a) {
  for (Node& n : a.nodes) n.coupled = n.turns ? vec(1, 1, 1) : zero3();
  const auto differs = [](double x, double y) { return std::fabs(x - y) > 1e-9 * std::fmax(x, y); };
  for (int axis = 0; axis < 3; axis++) {
    const int j = (axis + 1) % 3, k = (axis + 2) % 3;
    std::vector<char> free(a.nodes.size(), 1);
    const auto visit = [&](std::int32_t node, Vec3 l) {
      if (node >= 0 &&
          std::fmax(std::fabs(l[j]), std::fabs(l[k])) > 1e-9 * a.nodes[static_cast<std::size_t>(node)].reach)
        free[static_cast<std::size_t>(node)] = 0;
    };
    for (const Row& row : a.rows) {
      const bool couple = row.lever > 0.0;
      visit(row.a, couple ? vec(infinity, infinity, infinity) : row.la);
      visit(row.b, couple ? vec(infinity, infinity, infinity) : row.lb);
    }
    for (std::size_t n = 0; n < a.nodes.size(); n++)
      if (free[n] && !differs(a.nodes[n].inertia[j], a.nodes[n].inertia[k])) a.nodes[n].coupled[axis] = 0.0;
  }
}

/// Whether the rows make no loop; the world counts as one node, and a couple beside a row between points makes none.
bool is_tree(const Articulate& a) {
  if (!a.strands.empty()) return false;
  const bool anchored = std::any_of(a.rows.begin(), a.rows.end(), [](const Row& row) { return row.b < 0; });
  std::vector<std::pair<std::int32_t, std::int32_t>> points, couples;
  for (const Row& row : a.rows) (row.lever > 0.0 ? couples : points).push_back(std::minmax(row.a, row.b));
  std::sort(couples.begin(), couples.end());
  if (std::adjacent_find(couples.begin(), couples.end()) != couples.end()) return false;
  std::sort(points.begin(), points.end());
  const auto alone = std::count_if(couples.begin(), couples.end(), [&](const auto& pair) {
    return !std::binary_search(points.begin(), points.end(), pair);
  });
  return points.size() + static_cast<std::size_t>(alone) + 1 == a.nodes.size() + (anchored ? 1 : 0);
}

void measure(Articulate& a, const Model& model) {
  std::vector<double> lengths;
  for (Row& row : a.rows) {
    if (row.kind == RowKind::path) {
      const auto& places = model.constraints[condition(a, row).constraint].path->places();
      lengths.push_back(norm(places[1] - places[0]));
    }
    if (row.kind == RowKind::strand) lengths.push_back(model.constraints[condition(a, row).constraint].length);
    if (row.kind == RowKind::rod && condition(a, row).length > 0.0) lengths.push_back(condition(a, row).length);
    if (row.kind == RowKind::stiff) lengths.push_back(1e12 * std::sqrt(condition(a, row).stiff->least2));
    if (row.lever > 0.0) lengths.push_back(row.lever);
    a.all_rigid = a.all_rigid && row.kind == RowKind::rigid;
    a.couples = a.couples || row.lever > 0.0;
    a.limited = a.limited || row.kind == RowKind::limited;
    if (row.kind == RowKind::stiff) a.open = a.open || condition(a, row).stiff->is_open();
    if (row.lever > 0.0) continue;
    for (double l : {norm(row.la), row.b >= 0 ? norm(row.lb) : 0.0})
      if (l > 0.0) lengths.push_back(l);
  }
  a.yields = std::all_of(a.rows.begin(), a.rows.end(), is_soft);
  if (!lengths.empty()) {
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    a.length = *middle;
  } else {  // points without arms: the size of their coordinates
    for (const Row& row : a.rows)
      if (row.member) a.length = std::max(a.length, norm(position(model, row.member)));
    if (a.length == 0.0) a.length = 1.0;
  }
  for (Node& node : a.nodes) {
    node.reach = 0.1 * a.length;
    a.total_mass += node.mass;
  }
  for (const Row& row : a.rows) {
    double& ra = a.nodes[static_cast<std::size_t>(row.a)].reach;
    ra = std::max(ra, row.lever > 0.0 ? row.lever : norm(row.la));
    if (row.b < 0) continue;
    double& rb = a.nodes[static_cast<std::size_t>(row.b)].reach;
    rb = std::max(rb, row.lever > 0.0 ? row.lever : norm(row.lb));
  }
  find_free_axes(a);
  if (is_tree(a)) a.most_epsilon = a.epsilon = Articulate::least_epsilon;
}

}  // namespace

std::unique_ptr<Articulate> build_articulate(const Model& model, std::span<const Thing> things) {
  Builder builder{model, {}, {}, {}, {}, false};
  for (Thing t : things) builder.add_node(t);
  for (Thing t : things) builder.add_rows(t);
  const Elimination elimination = minimum_degree(builder.neighbours());
  builder.sort(elimination.order);
  auto articulate = std::make_unique<Articulate>();
  articulate->factor = lay_out(elimination);
  articulate->nodes = std::move(builder.nodes);
  articulate->rows = std::move(builder.rows);
  articulate->conditions = std::move(builder.conditions);
  articulate->breakable = builder.breakable;
  articulate->right_side.resize(articulate->rows.size());
  find_meetings(*articulate);
  measure(*articulate, model);
  lay_out_batches(*articulate);
  find_waves(*articulate);
  const Thing oldest = things.front();
  articulate->serial =
      oldest.is_body ? model.bodies.at_slot(oldest.slot).serial : model.points.at_slot(oldest.slot).serial;
  return articulate;
}

}  // namespace pantin
