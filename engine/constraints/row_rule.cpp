#include "constraints/row_rule.hpp"

namespace pantin {

const std::array<const RowRule*, 11> row_rules = {&rigid_row, &soft_row,  &rod_row,    &plane_row,
                                                  &axis_row,  &align_row, &turn_row,   &coupled_row,
                                                  &path_row,  &stiff_row, &attract_row};

}  // namespace pantin
