#include "player/lammps/law_of_distance.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "base/check.hpp"
#include "base/lanes.hpp"
#include "laws/derivative.hpp"

namespace pantin::player {

/// A law's outputs as a program, and how many of them are conditions.
struct LoweredLaw {
  Program program;
  std::size_t conditions = 0;
};

namespace {

const Input distance_square{Role::distance2, 0, 0, {}};

bool is_branch(Function f) {
  return f == Function::less || f == Function::less_or_equal || f == Function::minimum || f == Function::maximum;
}

/// What changes its sign where branches of some expressions of the distance meet.
std::vector<Expr> branch_conditions(Expressions& graph, std::span<const Expr> outputs) {
  std::vector<Expr> found, open(outputs.begin(), outputs.end());
  std::set<Expr> seen;
  while (!open.empty()) {
    const Expr e = open.back();
    open.pop_back();
    if (!seen.insert(e).second) continue;
    const Expressions::Node node = graph[e];
    for (const auto& [term, factor] : node.terms) open.push_back(term);
    if (node.kind != Expressions::Kind::function) continue;
    Expr condition = no_expression;
    if (is_branch(node.function)) condition = graph.subtract(node.terms[0].first, node.terms[1].first);
    if (node.function == Function::abs) condition = node.terms[0].first;
    if (condition != no_expression && graph.depends_on(condition, Role::distance2)) found.push_back(condition);
  }
  return found;
}

/// Outputs: tension / distance, its derivative by the square of the distance, the energy if there is one, conditions.
LoweredLaw lower_law(const Law& law) {
  Expressions graph = law.graph;
  std::vector<Expr> outputs = law.force;
  if (law.energy != no_expression) outputs.push_back(law.energy);
  const std::vector<Expr> conditions = branch_conditions(graph, outputs);
  outputs.insert(outputs.begin() + 1, derivative(graph, law.force[0], distance_square));
  outputs.insert(outputs.end(), conditions.begin(), conditions.end());
  graph.put_in_order(outputs);
  return {lower(graph, outputs), conditions.size()};
}

const Law& checked(const std::string& name, const Law& law) {
  require(law.kind == LawKind::central && !law.called && !law.one_sided && !law.velocity_dependent && !law.timed, name,
          ": it is no function of distance alone");
  return law;
}

}  // namespace

LawOfDistance::LawOfDistance(const std::string& name, const Law& law, std::span<const double> parameters,
                             const std::function<double(int, const std::string&)>& attribute)
    : LawOfDistance(lower_law(checked(name, law)), name, law, parameters, attribute) {}

LawOfDistance::LawOfDistance(const LoweredLaw& lowered, const std::string& name, const Law& law,
                             std::span<const double> parameters,
                             const std::function<double(int, const std::string&)>& attribute)
    : name_(name),
      has_energy_(law.has_energy()),
      machine_(lowered.program),
      distance2_(machine_.input(distance_square)),
      conditions_(lowered.conditions) {
  for (const Input& input : lowered.program.inputs) {
    const int at = machine_.input(input);
    if (input.role == Role::attribute) machine_.fill(at, attribute(input.who, input.name));
    for (std::size_t i = 0; input.role == Role::parameter && i < parameters.size(); i++)
      if (law.parameters[i].name == input.name) machine_.fill(at, parameters[i]);
  }
  machine_.run_uniform();
}

void LawOfDistance::run(std::span<const double> r, const std::function<void(std::size_t)>& read) {
  for (std::size_t first = 0; first < r.size(); first += Machine::block) {
    const std::size_t n = std::min<std::size_t>(Machine::block, r.size() - first);
    if (distance2_ >= 0) {
      double* const column = machine_.column(distance2_);
      for (std::size_t k = 0; k < (n + 15) / 16 * 16; k++) {
        const double distance = r[first + std::min(k, n - 1)];
        column[k] = distance * distance;
      }
    }
    machine_.run(static_cast<int>(n));
    for (std::size_t k = 0; k < n; k++) read(k);
  }
}

std::vector<LawOfDistance::Value> LawOfDistance::at(std::span<const double> r) {
  std::vector<Value> values;
  values.reserve(r.size());
  run(r, [&](std::size_t k) {
    const double x = r[values.size()], pull = machine_.output(0)[k], by_square = machine_.output(1)[k];
    values.push_back({has_energy_ ? machine_.output(2)[k] : 0.0, -pull * x, -pull - 2.0 * x * x * by_square});
  });
  return values;
}

std::vector<std::vector<double>> LawOfDistance::conditions_at(std::span<const double> r) {
  const std::size_t before = has_energy_ ? 3 : 2;
  std::vector<std::vector<double>> values(conditions_);
  run(r, [&](std::size_t k) {
    for (std::size_t c = 0; c < conditions_; c++) values[c].push_back(machine_.output(static_cast<int>(before + c))[k]);
  });
  return values;
}

std::vector<double> LawOfDistance::kinks(double from, double to) {
  constexpr std::size_t pieces = 4096, parts = 64;
  const auto even = [](double a, double b, std::size_t n) {
    std::vector<double> list;
    for (std::size_t i = 0; i <= n; i++)
      list.push_back(a + (b - a) * (static_cast<double>(i) / static_cast<double>(n)));
    return list;
  };
  if (conditions_ == 0) return {};
  std::set<double> found;
  const std::vector<double> grid = even(from, to, pieces);
  const auto coarse = conditions_at(grid);
  for (std::size_t c = 0; c < conditions_; c++)
    for (std::size_t i = 0; i < pieces; i++) {
      if ((coarse[c][i] < 0.0) == (coarse[c][i + 1] < 0.0)) continue;
      double low = grid[i], high = grid[i + 1];
      for (double width = infinity; high - low < width && high > low;) {
        width = high - low;
        const std::vector<double> fine = even(low, high, parts);
        const auto values = conditions_at(fine)[c];
        std::size_t k = 0;
        while (k + 1 < parts && (values[k] < 0.0) == (values[k + 1] < 0.0)) k++;
        low = fine[k], high = fine[k + 1];
      }
      found.insert(high);
    }
  // What differs by round-off is one, and the ends are none.
  std::vector<double> list;
  for (double kink : found)
    if (kink > from * (1.0 + resolution) && kink < to * (1.0 - resolution) &&
        (list.empty() || kink > list.back() * (1.0 + resolution)))
      list.push_back(kink);
  return list;
}

}  // namespace pantin::player
