#include "laws/run/block.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

#include "base/check.hpp"
#include "laws/machine_code.hpp"
#include "laws/noise.hpp"

namespace pantin {

namespace {

constexpr std::size_t length = LawBlock::room;
constexpr double unset = marks_unset ? std::numeric_limits<double>::signaling_NaN() : 1.0;  // in columns not yet filled

std::vector<Expr> outputs_of(const Law& law, bool with_energy) {
  std::vector<Expr> outputs = law.force;
  if (with_energy) outputs.push_back(law.energy);
  return outputs;
}

void gather_components(const AlignedVector<Vec3>& from, int n, const LawBlock::Vector& to, double sign) {
  for (int c = 0; c < 3; c++)
    if (double* column = to[static_cast<std::size_t>(c)])
      for (int k = 0; k < n; k++) column[k] = sign * from[static_cast<std::size_t>(k)][c];
}

}  // namespace

std::size_t force_outputs(const Law& law) {
  if (law.kind == LawKind::central) return 1;
  return law.kind == LawKind::many ? 3 * static_cast<std::size_t>(law.count) : 3;
}

LawProgram::LawProgram(const Law& law, bool with_energy, Uniform uniform) {
  if (law.called) return;
  program = lower(law.graph, outputs_of(law, with_energy), uniform);
  code = MachineCode::of(program);
}

LawBlock::LawBlock(const Law& law, const LawProgram& program, std::span<const std::string> names)
    : count_(static_cast<std::size_t>(law.count)), called_(law.called) {
  const std::vector<Input>& inputs = called_ ? law.inputs_wanted : program.program.inputs;
  const std::size_t outputs = called_ ? force_outputs(law) + (law.called_energy ? 1 : 0) : 0;
  memory_.assign((1 + inputs.size() + outputs) * length, unset);
  slots_.assign(8 * length, 0);
  for (std::size_t who = 0; who < 4; who++) sites[who] = slots_.data() + who * length;
  if (!called_) machine_.emplace(program.program).use(program.code);
  distance2 = memory_.data() + used_++ * length;
  parameters_.resize(law.parameters.size());
  called_parameters_.reserve(law.parameters.size());
  for (const Input& input : inputs) take_input(law, names, input);
  for (std::size_t k = 0; k < outputs; k++) called_outputs_.push_back(memory_.data() + used_++ * length);
  if (!called_) return;
  wants_sites = true;
  for (std::size_t who = 0; who < count_; who++) called_particles_.push_back(slots_.data() + (4 + who) * length);
}

double* LawBlock::take_column(const Input& input) {
  double* to = memory_.data() + used_++ * length;
  use_column(input, to);
  return to;
}

void LawBlock::use_column(const Input& input, const double* from) {
  if (machine_)
    machine_->bind(machine_->input(input), from);
  else
    called_inputs_.push_back(from);
}

void LawBlock::take_input(const Law& law, std::span<const std::string> names, const Input& input) {
  const int number = machine_ ? machine_->input(input) : -1;
  switch (input.role) {
    case Role::distance2: use_column(input, distance2); break;
    case Role::approach: approach = take_column(input); break;
    case Role::displacement: displacement[input.component] = take_column(input); break;
    case Role::relative_velocity: relative_velocity[input.component] = take_column(input); break;
    case Role::position: position[input.who][input.component] = take_column(input); break;
    case Role::velocity: velocity[input.who][input.component] = take_column(input); break;
    case Role::attribute: {
      const auto found = std::find(names.begin(), names.end(), input.name);
      require(found != names.end(), law.name, ": there is no attribute \"", input.name, "\"");
      attributes.push_back({input.who, static_cast<std::size_t>(found - names.begin()), take_column(input), number});
      break;
    }
    case Role::parameter: {
      const auto named = [&](const Parameter& parameter) { return parameter.name == input.name; };
      const auto found = std::find_if(law.parameters.begin(), law.parameters.end(), named);
      require(found != law.parameters.end(), law.name, ": there is no parameter \"", input.name, "\"");
      if (machine_) parameter_inputs_.push_back({static_cast<std::size_t>(found - law.parameters.begin()), number});
      break;
    }
    case Role::time: time_input_ = number; break;
    case Role::noise: noise_.push_back({input.component, take_column(input)}); break;
  }
  wants_sites = wants_sites || input.role == Role::noise;
  wants_displacement = wants_displacement || input.role == Role::displacement;
  wants_motion = wants_motion || input.role == Role::approach || input.role == Role::relative_velocity;
}

void LawBlock::set(const Instant& instant, std::span<const double> parameters) {
  assume(parameters.size() == parameters_.size() || parameters.empty());
  const auto same = [](double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
  };
  const bool as_before = is_set_ && (time_input_ < 0 || same(instant.time, instant_.time)) &&
                         std::equal(parameters.begin(), parameters.end(), parameters_.begin(), same);
  instant_ = instant;
  std::copy(parameters.begin(), parameters.end(), parameters_.begin());
  called_parameters_.clear();
  if (!machine_ || as_before) return;
  if (time_input_ >= 0) machine_->fill(time_input_, instant.time);
  for (const auto& [parameter, input] : parameter_inputs_)
    if (!parameters.empty()) machine_->fill(input, parameters[parameter]);
  machine_->run_uniform();
  is_set_ = true;
}

void LawBlock::bind_parameter(std::size_t parameter, const double* values) {
  called_parameters_.resize(parameters_.size(), nullptr);
  called_parameters_[parameter] = values;
  for (const auto& [wanted, input] : parameter_inputs_)
    if (wanted == parameter) machine_->bind(input, values), is_set_ = false;
}

void LawBlock::gather_of(std::span<const std::uint32_t* const> roles, std::size_t n, const Sites& sites_of_all) {
  for (const Attribute& attribute : attributes) {
    const double* column = sites_of_all.attributes[attribute.column].data();
    const std::uint32_t* site = roles[attribute.who];
    for (std::size_t k = 0; k < n; k++) attribute.to[k] = column[site[k]];
  }
  for (std::size_t who = 0; wants_sites && who < roles.size(); who++) std::copy_n(roles[who], n, sites[who]);
}

void LawBlock::bind_attributes(const Sites& sites_of_all) {
  for (const Attribute& attribute : attributes)
    machine_->bind(attribute.input, sites_of_all.attributes[attribute.column].data());
}

void LawBlock::run(int n, const Sites& sites_of_all) {
  if (!noise_.empty()) make_noise(n, sites_of_all);
  if (machine_)
    machine_->run(n);
  else
    call(n, sites_of_all);
}

void LawBlock::make_noise(int n, const Sites& sites_of_all) {
  const std::uint32_t* last = sites[count_ > 1 ? 1 : 0];
  for (const Noise& noise : noise_)
    for (int k = 0; k < n; k++)
      noise.to[k] = instant_.silent ? 0.0
                                    : normal(instant_.seed, instant_.number, sites_of_all.serial[sites[0][k]],
                                             sites_of_all.serial[last[k]], noise.index);
}

void LawBlock::call(int n, const Sites& sites_of_all) {
  for (std::size_t who = 0; who < count_; who++)
    for (std::size_t k = 0; k < static_cast<std::size_t>(n); k++)
      slots_[(4 + who) * length + k] = sites_of_all.particle[sites[who][k]];
  Called::Block block;
  block.n = n;
  block.inputs = called_inputs_;
  block.particles = called_particles_;
  block.outputs = called_outputs_;
  block.time = instant_.time;
  if (called_parameters_.empty())
    block.parameters = parameters_;
  else
    block.parameter_columns = called_parameters_;
  if (n > 0) called_->run(block);
}

void Block::gather_components() {
  pantin::gather_components(d, count, law.displacement, sign);
  pantin::gather_components(u, count, law.relative_velocity, sign);
}

Vec3 Block::force_of(LawKind kind, std::size_t k) const {
  if (kind == LawKind::central) return d[k] * sign * law.output(0)[k];
  return vec(law.output(0)[k], law.output(1)[k], law.output(2)[k]);
}

void Block::find_slopes(const Law& of, const Sites& sites, double difference) {
  const auto n = static_cast<std::size_t>(count);
  const bool central = of.kind == LawKind::central;
  force.resize(n);
  slope.assign(n, zero33());
  for (std::size_t k = 0; k < n; k++) force[k] = force_of(of.kind, k);
  for (std::size_t by = 0; by < (central ? 1 : 3) && !of.called; by++)
    for (std::size_t k = 0; k < n; k++) {
      if (central)
        slope[k] = outer(d[k], d[k]) * law.output(1)[k];
      else
        slope[k][static_cast<int>(by)] =
            vec(law.output(3 + 3 * by)[k], law.output(4 + 3 * by)[k], law.output(5 + 3 * by)[k]);
    }
  const LawBlock::Vector& columns = of.kind == LawKind::point ? law.velocity[0] : law.relative_velocity;
  for (std::size_t by = 0; by < (central ? 1 : 3) && of.called; by++) {
    double* const column = central ? law.approach : columns[by];
    if (column == nullptr) continue;
    const std::vector<double> before(column, column + n);
    for (std::size_t k = 0; k < n; k++) column[k] += central ? difference * norm(d[k]) : difference;
    law.run(count, sites);
    for (std::size_t k = 0; k < n; k++) {
      const Vec3 change = (force_of(of.kind, k) - force[k]) / difference;
      if (central)
        slope[k] = outer(change, direction(d[k] * sign));
      else
        slope[k][static_cast<int>(by)] = change;
    }
    std::copy(before.begin(), before.end(), column);
  }
}

}  // namespace pantin
