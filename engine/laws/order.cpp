// The order of a graph's nodes. Nodes are numbered as they are made, and terms are summed in the order of their numbers;
// C++ leaves open which operand of + makes its nodes first, so a finished law is numbered anew by what its nodes are.
#include <algorithm>

#include "base/hash.hpp"
#include "base/stable.hpp"
#include "laws/expression.hpp"

namespace pantin {

namespace {

void add_input(Hash& hash, const Input& input) {
  hash.add(static_cast<std::uint64_t>(input.role) << 16 | static_cast<std::uint64_t>(input.who) << 8 | input.component);
  for (char c : input.name) hash.add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
}

}  // namespace

std::vector<std::uint64_t> Expressions::structure() const {
  std::vector<std::uint64_t> known;
  for (const Node& node : nodes_) {
    Hash hash;
    hash.add(static_cast<std::uint64_t>(node.kind) << 8 | static_cast<std::uint64_t>(node.function));
    hash.add(node.value);
    if (node.kind == Kind::input) add_input(hash, inputs_[node.index]);
    if (node.kind == Kind::function) hash.add(static_cast<std::uint64_t>(node.index));
    std::vector<std::uint64_t> parts;
    for (const auto& [term, factor] : node.terms) {
      Hash part;
      part.add(known[static_cast<std::size_t>(term)]);
      part.add(factor);
      parts.push_back(part.value);
    }
    if (node.kind != Kind::function) std::sort(parts.begin(), parts.end());
    for (std::uint64_t part : parts) hash.add(part);
    known.push_back(hash.value);
  }
  return known;
}

void Expressions::put_in_order(std::span<Expr> outputs) {
  const std::vector<std::uint64_t> of = structure();
  const auto before = [&](const auto& a, const auto& b) {
    return of[static_cast<std::size_t>(a.first)] < of[static_cast<std::size_t>(b.first)];
  };
  std::vector<Expr> position(nodes_.size(), no_expression);
  Expressions ordered;
  ordered.splines_ = splines_;
  const auto take = [&](const auto& self, Expr e) -> Expr {
    Expr& to = position[static_cast<std::size_t>(e)];
    if (to != no_expression) return to;
    Node node = (*this)[e];
    if (node.kind == Kind::constant) return to = ordered.constant(node.value);
    if (node.kind == Kind::input) return to = ordered.input(inputs_[node.index]);
    const bool any_order = node.kind != Kind::function;
    if (any_order) sort_stably(node.terms.begin(), node.terms.end(), before);
    for (auto& [term, factor] : node.terms) term = self(self, term);
    if (any_order) std::sort(node.terms.begin(), node.terms.end());
    return to = ordered.intern(std::move(node));
  };
  for (Expr& e : outputs)
    if (e != no_expression) e = take(take, e);
  *this = std::move(ordered);
}

}  // namespace pantin
