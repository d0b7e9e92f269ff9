// Hinge, nail, rigid follow, weld and orient: two points, or two orientations, stay together. M = 1 and C = 0 are left out
// of the products.
#include "constraints/row_rule.hpp"

namespace pantin {

namespace {

double evaluate_rigid(Row& row) {
  row.residual = row.d1 - row.offset;
  return norm(row.residual);
}

Vec3 no_gap(const Row&, const Condition&) { return zero3(); }
Stop no_stop(const Row&, const Condition&) { return {zero3()}; }

}  // namespace

const RowRule row_rules[11] = {
    {[](Row& row, Condition&, const RowContext&) { return evaluate_rigid(row); }, [](const Row&, Condition&) {},
     [](const Row& row, const Condition&) { return row.d1 - row.offset; }, no_stop},
    {evaluate_soft, project_soft, no_gap, no_stop},
    {evaluate_rod, project_rod, rod_gap, stop_of_rod},
    {evaluate_plane, project_plane, plane_gap, no_stop},
    {evaluate_axis, project_axis, axis_gap, no_stop},
    {evaluate_align, project_align, align_gap, no_stop},
    {evaluate_turn, project_turn, turn_gap, stop_of_turn},
    // strings are done together, once all rows are placed
    {[](Row&, Condition&, const RowContext&) { return 0.0; }, [](const Row&, Condition&) {}, no_gap, no_stop},
    {evaluate_path, project_path, path_gap, stop_of_path},
    {evaluate_stiff, project_stiff, no_gap, no_stop},
    {evaluate_attract, project_attract, attract_gap, no_stop},
};

}  // namespace pantin
