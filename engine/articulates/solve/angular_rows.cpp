// Angular rows: torques between two nodes, or on one from the world. With equal axes at both ends of the step the relative
// rotation a_a - a_b is along the mean axis, so that a torque across it does no work.
#include "articulates/solve/angular_rows.hpp"

#include "constraints/row_rule.hpp"

namespace pantin {

void place_angular_row_at_start(Articulate& a, Row& row) {
  const Node& first = a.nodes[static_cast<std::size_t>(row.a)];
  const Node* second = row.b >= 0 ? &a.nodes[static_cast<std::size_t>(row.b)] : nullptr;
  const Condition& c = condition(a, row);
  row.ra0 = first.R0 * row.la;
  row.rb0 = second ? second->R0 * c.axis0 : c.axis0;
}

void place_angular_row_at_end(Articulate& a, Row& row) {
  const Node& first = a.nodes[static_cast<std::size_t>(row.a)];
  const Node* second = row.b >= 0 ? &a.nodes[static_cast<std::size_t>(row.b)] : nullptr;
  Condition& c = condition(a, row);
  row.ra1 = first.R1 * row.la;
  row.rb1 = second ? second->R1 * c.axis1 : c.axis1;
  row.rule->read_turn(row, c, {first.q1, second ? second->q1 : Quat{}, first.R1});
}

double work_of_angular_row(const Articulate& a, const Row& row) {
  const auto turned = [&](std::int32_t node) { return a.nodes[static_cast<std::size_t>(node)].cayley; };
  const Vec3 torque = row.f * row.lever;
  return dot(torque, turned(row.a)) - (row.b >= 0 ? dot(torque, turned(row.b)) : 0.0);
}

}  // namespace pantin
