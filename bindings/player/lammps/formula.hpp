#pragma once
#include <functional>
#include <string>

#include "laws/expression.hpp"

namespace pantin::player {

/// Who is to read a formula: LAMMPS' variables, or Lepton, which newer ones have.
enum class FormulaFor : std::uint8_t { variable, lepton };

/// An expression as a text without spaces. `value_of` gives the text of each input; of a pair's distance none is asked, it is
/// "r". Throws Error for what the reader has not: tables, and texts of more than 64 kB.
std::string formula(const Expressions& graph, Expr e, FormulaFor reader,
                    const std::function<std::string(const Input&)>& value_of);

}  // namespace pantin::player
