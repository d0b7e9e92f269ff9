#include "lua/law/law_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/check.hpp"
#include "base/random.hpp"
#include "lua/law/term_sizes.hpp"

namespace pantin::lua {
namespace {

constexpr std::array<double, 16> near_cutoff = {1e-3, 0.03, 0.1, 0.2,  0.3,  0.4,   0.5,      0.6,
                                                0.7,  0.8,  0.9, 0.95, 0.99, 0.999, 1 - 1e-7, 1.0};
constexpr std::array<double, 16> everywhere = {1e-10, 1e-6, 1e-3, 0.01, 0.1, 0.3, 0.5,  0.8,
                                               1.0,   1.2,  1.5,  2.0,  3.0, 10., 100., 1000.};
constexpr std::array<double, 8> attribute_values = {1.0, -1.0, 0.0, 0.5, 2.0, -0.3, 3.7, 100.0};
constexpr std::array<double, 5> positive_values = {1.0, 0.5, 2.0, 0.1, 7.3};

/// Uniform in -1 … 1.
double either_sign(Random& random) { return 2.0 * random.uniform() - 1.0; }

template <std::size_t n>
double one_of(const std::array<double, n>& values, Random& random) {
  return values[static_cast<std::size_t>(random.uniform() * static_cast<double>(n))];
}

Vec3 somewhere(Random& random) {
  const double x = either_sign(random), y = either_sign(random), z = either_sign(random);
  return vec(x, y, z);
}

Input part(Role role, int who, int i) {
  return {role, static_cast<std::uint8_t>(who), static_cast<std::uint8_t>(i), ""};
}

std::string name_of(const Input& input, const LawFunction& law) {
  const std::string who = is_pair(law.form)                     ? std::string(1, "ab"[input.who])
                          : law.form == LawForm::many_potential ? text("p[", input.who + 1, "]")
                                                                : "p";
  const std::string axis = text(".", "xyz"[input.component % 3]);
  switch (input.role) {
    case Role::distance2: return "r";
    case Role::approach: return "r * rate";
    case Role::displacement: return "d" + axis;
    case Role::relative_velocity: return "u" + axis;
    case Role::position: return who + ".position" + axis;
    case Role::velocity: return who + ".velocity" + axis;
    case Role::attribute: return text(who, ".", input.name);
    case Role::parameter: return text("own.", input.name);
    case Role::time: return "t";
    case Role::noise: break;
  }
  return text("noise ", input.component + 1);
}

/// Values of inputs in a block.
class InputReader {
 public:
  InputReader(const CalledLaw& called, const Called::Block& block)
      : law_(called.law()), wanted_(called.inputs_wanted()), block_(block) {}
  double operator()(const Input& input, std::size_t k) const {
    if (input.role == Role::time) return block_.time;
    if (input.role == Role::parameter) {
      const auto& all = law_.def.parameters;
      const auto i = static_cast<std::size_t>(
          std::find_if(all.begin(), all.end(), [&](const Parameter& p) { return p.name == input.name; }) - all.begin());
      return block_.parameters.empty() ? block_.parameter_columns[i][k] : block_.parameters[i];
    }
    return block_
        .inputs[static_cast<std::size_t>(std::find(wanted_.begin(), wanted_.end(), input) - wanted_.begin())][k];
  }
  /// "r = 0.5, a.charge = -1"
  std::string describe(std::span<const Input> inputs, std::size_t k) const {
    std::string all;
    for (const Input& input : inputs) {
      const double value = (*this)(input, k);
      all += text(all.empty() ? "" : ", ", name_of(input, law_), " = ",
                  input.role == Role::distance2 ? std::sqrt(value) : value);
    }
    return all;
  }

 private:
  const LawFunction& law_;
  std::vector<Input> wanted_;
  const Called::Block& block_;
};

std::vector<Expr> outputs_of(const Law& law) {
  std::vector<Expr> outputs = law.force;
  if (law.energy != no_expression) outputs.push_back(law.energy);
  return outputs;
}

/// The same block with other outputs, and what the calls write.
std::vector<std::vector<double>> call(CalledLaw& called, Called::Block block, std::vector<std::string>& failures) {
  const std::size_t outputs = called.forces() + (is_potential(called.law().form) ? 1 : 0);
  std::vector<std::vector<double>> values(outputs, std::vector<double>(static_cast<std::size_t>(block.n)));
  std::vector<double*> columns;
  for (auto& column : values) columns.push_back(column.data());
  block.outputs = columns;
  failures = called.try_each(block);
  return values;
}

}  // namespace

Samples::Samples(const CalledLaw& called, double time) : wanted_(called.inputs_wanted()), time_(time) {
  for (const Input& input : wanted_) columns_[input].resize(count);
  for (const Parameter& p : called.law().def.parameters) parameters_.push_back(p.value);
  fill(called.law());
}

void Samples::fill(const LawFunction& law) {
  Random random{17, 0};
  const auto set = [&](const Input& input, std::size_t k, double value) {
    if (const auto column = columns_.find(input); column != columns_.end()) column->second[k] = value;
  };
  const auto set_vec = [&](Role role, int who, std::size_t k, Vec3 v) {
    for (int i = 0; i < 3; i++) set(part(role, who, i), k, v[i]);
  };
  const bool limited = std::isfinite(law.def.cutoff);
  for (std::size_t k = 0; k < count; k++) {
    const double r = limited ? near_cutoff[k % near_cutoff.size()] * law.def.cutoff : everywhere[k % everywhere.size()];
    const Vec3 direction = somewhere(random), d = direction * (r / norm(direction));
    const Vec3 u = somewhere(random);
    set(part(Role::distance2, 0, 0), k, norm2(d));
    set(part(Role::approach, 0, 0), k, pantin::dot(d, u));
    set_vec(Role::displacement, 0, k, d);
    set_vec(Role::relative_velocity, 0, k, u);
    for (int who = 0; who < law.count; who++) {
      set_vec(Role::position, who, k, somewhere(random) * 3.0);
      set_vec(Role::velocity, who, k, somewhere(random));
    }
    for (const Input& input : wanted_) {
      const auto& common = common_attributes();
      const bool positive = std::find(common.begin(), common.end(), input.name) != common.end();
      if (input.role == Role::noise) set(input, k, 1.7 * either_sign(random));
      if (input.role == Role::attribute)
        set(input, k, positive ? one_of(positive_values, random) : one_of(attribute_values, random));
    }
  }
}

void Samples::exchange() {
  for (auto& [input, column] : columns_) {
    if (input.role == Role::displacement || input.role == Role::relative_velocity)
      for (double& x : column) x = -x;
    if (input.who == 0 && input.role == Role::attribute) {
      Input other = input;
      other.who = 1;
      if (const auto found = columns_.find(other); found != columns_.end()) column.swap(found->second);
    }
  }
}

Called::Block Samples::block() {
  inputs_.clear();
  for (const Input& input : wanted_) inputs_.push_back(columns_.at(input).data());
  Called::Block block;
  block.n = count;
  block.inputs = inputs_;
  block.time = time_;
  block.parameters = parameters_;
  return block;
}

Outcome outcome(CalledLaw& called, const Law* law, const Called::Block& block) {
  Outcome result;
  const InputReader read(called, block);
  const auto value = [&](const Input& input, int k) { return read(input, static_cast<std::size_t>(k)); };
  if (law) {
    result.computed = run_expressions(law->graph, outputs_of(*law), block.n, value);
    result.terms = term_sizes(law->graph, outputs_of(*law), block.n, value);
  }
  result.called = call(called, block, result.failures);
  return result;
}

bool depends_on_time(CalledLaw& called, std::span<const double> times) {
  const auto at = [&](double time) { return outcome(called, nullptr, Samples(called, time).block()); };
  const auto same = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
  const Outcome first = at(times[0]);
  for (double time : times.subspan(1)) {
    const Outcome now = at(time);
    if (now.failures != first.failures) return true;
    for (std::size_t i = 0; i < now.called.size(); i++)
      if (!std::equal(now.called[i].begin(), now.called[i].end(), first.called[i].begin(), same)) return true;
  }
  return false;
}

std::string disagreement(CalledLaw& called, const Law& law, const Called::Block& block) {
  const InputReader read(called, block);
  const Outcome tried = outcome(called, &law, block);
  for (std::size_t i = 0; i < tried.computed.size(); i++)
    for (std::size_t k = 0; k < tried.failures.size(); k++) {
      const double wanted = tried.called[i][k], got = tried.computed[i][k];
      if (!tried.failures[k].empty() || !std::isfinite(wanted)) continue;
      if (std::isfinite(got) && !(std::fabs(got - wanted) > 1e-9 * tried.terms[i][k])) continue;
      std::vector<Input> inputs = law.graph.inputs_of(outputs_of(law));
      const Input distance2 = part(Role::distance2, 0, 0);
      if (law.kind == LawKind::central && (inputs.empty() || inputs[0] != distance2))
        inputs.insert(inputs.begin(), distance2);
      const bool energy = i == law.force.size();
      const std::string where = read.describe(inputs, k);
      return text("traced, the ", energy ? "energy" : "force", " is ", got, " and called it is ", wanted,
                  where.empty() ? "" : " at ", where);
    }
  return "";
}

std::string asymmetry(CalledLaw& called, const Law* law, double time) {
  Samples samples(called, time);
  const Outcome first = outcome(called, law, samples.block());
  samples.exchange();
  const Called::Block exchanged = samples.block();
  const Outcome second = outcome(called, law, exchanged);
  const double sign = called.law().form == LawForm::pair_force ? -1.0 : 1.0;
  for (std::size_t i = 0; i < called.forces(); i++)
    for (std::size_t k = 0; k < first.failures.size(); k++) {
      const double a = first.called[i][k], b = sign * second.called[i][k];
      if (!first.failures[k].empty() || !second.failures[k].empty() || !std::isfinite(a) || !std::isfinite(b)) continue;
      const double size =
          law ? std::max(first.terms[i][k], second.terms[i][k]) : 100.0 * std::max(std::fabs(a), std::fabs(b));
      if (!(std::fabs(a - b) > 1e-9 * size)) continue;
      std::vector<Input> inputs;
      for (const Input& input : called.inputs_wanted())
        if (input.role != Role::noise) inputs.push_back(input);
      if (law) inputs = law->graph.inputs_of(outputs_of(*law));
      samples.exchange();
      return text("within one family a law must be the same with a and b exchanged, and this one gives ", a,
                  " and then ", b, " at ", InputReader(called, samples.block()).describe(inputs, k),
                  "; with one_sided = true each feels only what it is given as a");
    }
  return "";
}

}  // namespace pantin::lua
