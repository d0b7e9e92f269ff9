#pragma once
// Expressions written as formulas.
#include <array>
#include <cstddef>
#include <initializer_list>

#include "laws/expression.hpp"

namespace pantin {

/// An expression and its graph, which must outlive it.
struct Symbol {
  Expressions* graph = nullptr;
  Expr e = no_expression;
};

/// The graph of symbols that are put together. Throws Error where they have none, or not the same one.
inline Expressions& graph_of(std::initializer_list<Symbol> symbols) {
  Expressions* graph = symbols.begin()->graph;
  for (const Symbol& symbol : symbols) {
    require(symbol.graph && symbol.graph->has(symbol.e),
            "a symbol has no expression; Symbol{&graph, graph.input(…)} has one");
    require(symbol.graph == graph, "symbols of two graphs cannot be put together");
  }
  return *graph;
}

inline Symbol operator+(Symbol a, Symbol b) { return {a.graph, graph_of({a, b}).add(a.e, b.e)}; }
inline Symbol operator-(Symbol a, Symbol b) { return {a.graph, graph_of({a, b}).subtract(a.e, b.e)}; }
inline Symbol operator*(Symbol a, Symbol b) { return {a.graph, graph_of({a, b}).multiply(a.e, b.e)}; }
inline Symbol operator/(Symbol a, Symbol b) { return {a.graph, graph_of({a, b}).divide(a.e, b.e)}; }
inline Symbol operator*(double a, Symbol b) { return {b.graph, graph_of({b}).scale(b.e, a)}; }
inline Symbol operator*(Symbol a, double b) { return b * a; }
inline Symbol operator-(Symbol a) { return -1.0 * a; }
inline Symbol number(Symbol like, double value) { return {like.graph, graph_of({like}).constant(value)}; }
inline Symbol operator+(Symbol a, double b) { return a + number(a, b); }
inline Symbol operator-(Symbol a, double b) { return a + number(a, -b); }
inline Symbol operator-(double a, Symbol b) { return number(b, a) - b; }

inline Symbol pow(Symbol a, double exponent) { return {a.graph, graph_of({a}).power(a.e, exponent)}; }
inline Symbol sqrt(Symbol a) { return pow(a, 0.5); }
inline Symbol apply(Function f, Symbol a) { return {a.graph, graph_of({a}).apply(f, a.e)}; }
inline Symbol apply(Function f, Symbol a, Symbol b) { return {a.graph, graph_of({a, b}).apply(f, a.e, b.e)}; }
inline Symbol max(Symbol a, double b) { return apply(Function::maximum, a, number(a, b)); }
inline Symbol min(Symbol a, Symbol b) { return apply(Function::minimum, a, b); }
/// `yes` where a < b, else `no`
inline Symbol where_less(Symbol a, Symbol b, Symbol yes, Symbol no) {
  return {a.graph, graph_of({a, b, yes, no}).select(apply(Function::less, a, b).e, yes.e, no.e)};
}

using Symbols3 = std::array<Symbol, 3>;

inline Symbols3 operator+(const Symbols3& a, const Symbols3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Symbols3 operator-(const Symbols3& a, const Symbols3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Symbols3 operator*(const Symbols3& a, Symbol s) { return {a[0] * s, a[1] * s, a[2] * s}; }
inline Symbol dot(const Symbols3& a, const Symbols3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Symbols3 cross(const Symbols3& a, const Symbols3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace pantin
