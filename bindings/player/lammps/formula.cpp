#include "player/lammps/formula.hpp"

#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "base/check.hpp"

namespace pantin::player {
namespace {

constexpr std::size_t most_text = 65536;

std::string number(double value) { return value < 0.0 ? text('(', value, ')') : to_text(value); }

/// Of a function that is not finite everywhere; else null.
const char* harmless_argument(Function f) {
  switch (f) {
    case Function::log:
    case Function::power: return "1";
    case Function::exp:
    case Function::sinh:
    case Function::cosh:
    case Function::tanh:
    case Function::tan:
    case Function::asin:
    case Function::acos: return "0";
    default: return nullptr;
  }
}

class Writer {
 public:
  Writer(const Expressions& graph, FormulaFor reader, const std::function<std::string(const Input&)>& value_of)
      : graph_(graph), reader_(reader), value_of_(value_of) {}

  const std::string& of(Expr e) {
    const auto known = texts_.find({e, where_});
    if (known != texts_.end()) return known->second;
    std::string made = write(graph_[e]);
    require(made.size() <= most_text, "its formula has more than 64 kB");
    return texts_.emplace(std::pair(e, where_), std::move(made)).first->second;
  }

 private:
  using Node = Expressions::Node;
  using Kind = Expressions::Kind;

  const Expressions& graph_;
  FormulaFor reader_;
  const std::function<std::string(const Input&)>& value_of_;
  /// Of a side of a choice, for LAMMPS' variables, which know none and multiply both sides by 1 or 0: 1 where it is taken.
  /// Elsewhere it must be finite all the same, and no division by 0, which ends the run. Empty: it is taken everywhere.
  std::string where_;
  std::map<std::pair<Expr, std::string>, std::string> texts_;  // by that

  std::string write(const Node& node) {
    switch (node.kind) {
      case Kind::constant: return number(node.value);
      case Kind::input: return input(graph_.inputs()[node.index]);
      case Kind::sum: return sum(node);
      case Kind::product: return product(node);
      case Kind::function: return function(node);
    }
    return "";
  }

  std::string input(const Input& input) { return input.role == Role::distance2 ? "(r^2)" : value_of_(input); }

  std::string sum(const Node& node) {
    std::string all = node.value == 0.0 ? "" : number(node.value);
    for (const auto& [term, factor] : node.terms) {
      if (!all.empty()) all += '+';
      if (factor != 1.0) all += number(factor) + "*";
      all += of(term);
    }
    return "(" + all + ")";
  }

  std::string product(const Node& node) {
    std::string all;
    for (const auto& [term, exponent] : node.terms) {
      if (!all.empty()) all += '*';
      all += power(term, exponent);
    }
    return "(" + all + ")";
  }

  /// An argument as it is where it matters, elsewhere one that is harmless.
  std::string harmless(const std::string& x, const char* elsewhere) const {
    return where_.empty() ? x : text('(', where_, '*', x, "+(1-", where_, ")*", elsewhere, ')');
  }

  std::string side(Expr e, const std::string& taken) {
    const std::string before = where_;
    where_ = before.empty() ? taken : text('(', before, '*', taken, ')');
    std::string made = of(e);
    where_ = before;
    return made;
  }

  std::string choice(const Node& node) {
    const std::string condition = of(node.terms[0].first), otherwise = "(1-" + condition + ")";
    return text('(', condition, '*', side(node.terms[1].first, condition), '+', otherwise, '*',
                side(node.terms[2].first, otherwise), ')');
  }

  std::string power(Expr base, double exponent) {
    const Node& node = graph_[base];
    if (node.kind == Kind::input && graph_.inputs()[node.index].role == Role::distance2)
      return exponent == 0.5 ? std::string("r") : "(r^" + number(2.0 * exponent) + ")";
    if (exponent == 1.0) return of(base);
    const bool has_all = exponent > 0.0 && exponent == std::floor(exponent);
    const std::string x = has_all ? of(base) : harmless(of(base), "1");
    if (exponent == 0.5) return "sqrt(" + x + ")";
    if (exponent == -1.0) return "(1/" + x + ")";
    return "(" + x + "^" + number(exponent) + ")";
  }

  std::string function(const Node& node) {
    require(node.function != Function::spline, "it is made of a table of points");
    const bool lepton = reader_ == FormulaFor::lepton;
    if (node.function == Function::select && !lepton) return choice(node);
    std::array<std::string, 3> x;
    for (std::size_t i = 0; i < node.terms.size(); i++) x[i] = of(node.terms[i].first);
    if (const char* const elsewhere = harmless_argument(node.function)) x[0] = harmless(x[0], elsewhere);
    const auto call = [&](const char* name) {
      std::string all = text(name, '(', x[0]);
      for (std::size_t i = 1; i < node.terms.size(); i++) all += "," + x[i];
      return all + ")";
    };
    switch (node.function) {
      case Function::exp: return call("exp");
      case Function::log: return call(lepton ? "log" : "ln");
      case Function::sin: return call("sin");
      case Function::cos: return call("cos");
      case Function::tan: return call("tan");
      case Function::asin: return call("asin");
      case Function::acos: return call("acos");
      case Function::atan: return call("atan");
      case Function::atan2: return call("atan2");
      case Function::sinh: return "((exp(" + x[0] + ")-exp(-" + x[0] + "))/2)";
      case Function::cosh: return "((exp(" + x[0] + ")+exp(-" + x[0] + "))/2)";
      case Function::tanh: return "(1-2/(exp(2*" + x[0] + ")+1))";
      case Function::power: return "(" + x[0] + "^" + x[1] + ")";
      case Function::abs: return call("abs");
      case Function::floor: return call("floor");
      case Function::minimum: return lepton ? call("min") : chosen(x[1], "<", x[0]);
      case Function::maximum: return lepton ? call("max") : chosen(x[1], ">", x[0]);
      case Function::less: return lepton ? "(1-step(" + x[0] + "-" + x[1] + "))" : "(" + x[0] + "<" + x[1] + ")";
      case Function::less_or_equal: return lepton ? "step(" + x[1] + "-" + x[0] + ")" : "(" + x[0] + "<=" + x[1] + ")";
      case Function::select: return call("select");
      case Function::spline: break;
    }
    return "";
  }

  /// The first where it is less (greater), else the second.
  static std::string chosen(const std::string& a, const char* is, const std::string& b) {
    const std::string condition = "(" + a + is + b + ")";
    return "(" + condition + "*" + a + "+(1-" + condition + ")*" + b + ")";
  }
};

}  // namespace

std::string formula(const Expressions& graph, Expr e, FormulaFor reader,
                    const std::function<std::string(const Input&)>& value_of) {
  return Writer(graph, reader, value_of).of(e);
}

}  // namespace pantin::player
