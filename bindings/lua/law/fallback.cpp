#include "lua/law/fallback.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "lua/law/dual.hpp"
#include "lua/vm/guard.hpp"
#include "lua/vm/runtime.hpp"

namespace pantin::lua {
namespace {

constexpr std::size_t role_count = static_cast<std::size_t>(Role::noise) + 1;

void want_three(std::vector<Input>& wanted, Role role, int who) {
  for (std::uint8_t i = 0; i < 3; i++) wanted.push_back({role, static_cast<std::uint8_t>(who), i, ""});
}

}  // namespace

/// The calls over one block.
class CalledLaw::Calls : public LawRun {
 public:
  Calls(CalledLaw& called, const Block& block);

  /// Calls for one pair or particle and writes its outputs.
  void evaluate(lua_State* state, LawCall& call, std::size_t k) {
    k_ = k;
    at_cutoff_ = false;
    call.call();
    if (is_potential(law.form))
      take_potential(state, call);
    else
      take_force(state);
  }
  /// "at distance 1.2 m": what the function saw.
  std::string seen() const;

  void push(lua_State* state, Seen what, int who) override;
  void push_attribute(lua_State* state, int who, std::size_t index) override;
  void push_parameter(lua_State* state, std::size_t index) override;
  void push_noise(lua_State* state, int index) override;
  bool on_thing(lua_State* state, std::string_view field, bool of_scene) override;

 private:
  double value(Role role, int who = 0, std::size_t i = 0) const {
    return block_.inputs[first_[static_cast<std::size_t>(role)][static_cast<std::size_t>(who)] + i][k_];
  }
  double distance() const { return at_cutoff_ ? law.def.cutoff : std::sqrt(value(Role::distance2)); }
  void push_vec(lua_State* state, Role role, int who) const {
    lua::push(state, vec(value(role, who, 0), value(role, who, 1), value(role, who, 2)));
  }
  void push_place(lua_State* state, int who) const;
  void take_potential(lua_State* state, LawCall& call);
  void take_force(lua_State* state);
  Dual energy(lua_State* state) const;
  void write(int output, double x) {
    if (const auto i = static_cast<std::size_t>(output); i < block_.outputs.size()) block_.outputs[i][k_] = x;
  }

  CalledLaw& called_;
  const Block& block_;
  const int known_noises_;
  std::array<std::array<std::size_t, 4>, role_count>
      first_{};  ///< column of a role of each particle; its others follow
  std::size_t k_ = 0;
  bool at_cutoff_ = false;  ///< the call is for the energy that a cutoff takes off
};

CalledLaw::Calls::Calls(CalledLaw& called, const Block& block)
    : LawRun(called.law_), called_(called), block_(block), known_noises_(called.noises) {
  const std::vector<Input> wanted = called.inputs_wanted();
  for (std::size_t column = wanted.size(); column-- > 0;)
    first_[static_cast<std::size_t>(wanted[column].role)][wanted[column].who] = column;
}

void CalledLaw::Calls::push_place(lua_State* state, int who) const {
  std::array<Dual, 3> place;
  for (std::size_t i = 0; i < 3; i++)
    place[i] = Dual::variable(value(Role::position, who, i), 3 * who + static_cast<int>(i), 3 * law.count);
  DualAlgebra(state).push_vec(state, place);
}

void CalledLaw::Calls::push(lua_State* state, Seen what, int who) {
  switch (what) {
    case Seen::distance:
      if (law.form == LawForm::pair_potential && !at_cutoff_)
        return DualAlgebra(state).push(state, Dual::variable(distance(), 0, 1));
      return lua_pushnumber(state, distance());
    case Seen::rate: return lua_pushnumber(state, value(Role::approach) / distance());
    case Seen::displacement: return push_vec(state, Role::displacement, 0);
    case Seen::relative_velocity: return push_vec(state, Role::relative_velocity, 0);
    case Seen::place: return is_potential(law.form) ? push_place(state, who) : push_vec(state, Role::position, who);
    case Seen::velocity: return push_vec(state, Role::velocity, who);
    case Seen::time: return lua_pushnumber(state, block_.time);
  }
}

void CalledLaw::Calls::push_attribute(lua_State* state, int who, std::size_t index) {
  lua_pushnumber(state, value(Role::attribute, who, index));
}

void CalledLaw::Calls::push_parameter(lua_State* state, std::size_t index) {
  lua_pushnumber(state, block_.parameters.empty() ? block_.parameter_columns[index][k_] : block_.parameters[index]);
}

void CalledLaw::Calls::push_noise(lua_State* state, int index) {
  if (index >= known_noises_)
    mistake(state, text("noise: the law calls it ", index + 1,
                        " times here, and less often when it was checked; call "
                        "it as often whatever the values"));
  lua_pushnumber(state, value(Role::noise, 0, static_cast<std::size_t>(index)));
}

bool CalledLaw::Calls::on_thing(lua_State* state, std::string_view field, bool of_scene) {
  if (of_scene && field == "time" && !is_curve(law.form)) {
    called_.reads_time = true;
    push(state, Seen::time, 0);
    return true;
  }
  if (!of_scene) called_.reads = field;
  return false;
}

std::string CalledLaw::Calls::seen() const {
  if (law.form == LawForm::pair_force) {
    double square = 0.0;
    for (std::size_t i = 0; i < 3; i++) square += value(Role::displacement, 0, i) * value(Role::displacement, 0, i);
    return text("at distance ", std::sqrt(square), " m");
  }
  if (is_pair(law.form)) return text("at distance ", distance(), " m");
  return text("at vec(", value(Role::position, 0, 0), ", ", value(Role::position, 0, 1), ", ",
              value(Role::position, 0, 2), ") m");
}

Dual CalledLaw::Calls::energy(lua_State* state) const {
  const auto energy = DualAlgebra(state).read(state, -1);
  require(energy.has_value(), law.function.place(), ": the law must return a number [J], got ",
          kind_of_value(state, -1));
  lua_pop(state, 1);
  return *energy;
}

void CalledLaw::Calls::take_potential(lua_State* state, LawCall& call) {
  Dual potential = energy(state);
  if (law.form == LawForm::pair_potential) {
    write(0, potential.slope(0) / distance());
    if (law.def.shift && std::isfinite(law.def.cutoff) && block_.outputs.size() > 1) {
      at_cutoff_ = true;
      call.call();
      potential.value -= energy(state).value;
      at_cutoff_ = false;
    }
    write(1, potential.value);
    return;
  }
  for (int i = 0; i < 3 * law.count; i++) write(i, -potential.slope(i));
  write(3 * law.count, potential.value);
}

void CalledLaw::Calls::take_force(lua_State* state) {
  if (law.form == LawForm::pair_tension) {
    require(lua_type(state, -1) == LUA_TNUMBER, law.function.place(), ": the law must return a number [N], got ",
            kind_of_value(state, -1));
    write(0, lua_tonumber(state, -1) / distance());
  } else {
    const auto force = to_vec(state, -1);
    require(force.has_value(), law.function.place(), ": the law must return a vec [N], got ", kind_of_value(state, -1));
    for (int i = 0; i < 3; i++) write(i, (*force)[i]);
  }
  lua_pop(state, 1);
}

std::vector<Input> CalledLaw::inputs_wanted() const {
  std::vector<Input> wanted;
  if (law_.form == LawForm::pair_potential || law_.form == LawForm::pair_tension)
    wanted = {{Role::distance2, 0, 0, ""}};
  if (law_.form == LawForm::pair_tension) wanted.push_back({Role::approach, 0, 0, ""});
  if (law_.form == LawForm::pair_force) {
    want_three(wanted, Role::displacement, 0);
    want_three(wanted, Role::relative_velocity, 0);
  }
  for (int who = 0; who < law_.count; who++) {
    if (!is_pair(law_.form)) want_three(wanted, Role::position, who);
    if (law_.form == LawForm::point_force) want_three(wanted, Role::velocity, who);
    for (const std::string& name : law_.known[static_cast<std::size_t>(who)].all())
      wanted.push_back({Role::attribute, static_cast<std::uint8_t>(who), 0, name});
  }
  for (int i = 0; i < noises; i++) wanted.push_back({Role::noise, 0, static_cast<std::uint8_t>(i), ""});
  return wanted;
}

std::size_t CalledLaw::forces() const {
  if (law_.form == LawForm::pair_potential || law_.form == LawForm::pair_tension) return 1;
  return law_.form == LawForm::many_potential ? 3 * static_cast<std::size_t>(law_.count) : 3;
}

void CalledLaw::run(const Block& block) {
  Runtime& runtime = law_.function.runtime();
  Calls calls(*this, block);
  const InLaw inside(runtime, calls);
  try {
    runtime.run([&](lua_State* state) {
      LawCall call(state, calls);
      for (std::size_t k = 0; k < static_cast<std::size_t>(block.n); k++) {
        calls.evaluate(state, call, k);
        for (double* column : block.outputs)
          require(std::isfinite(column[k]), law_.function.place(), ": the law gives a force or an energy of ",
                  column[k]);
      }
    });
  } catch (const Interrupted&) { throw; } catch (const StaleHandle&) {
    throw;
  } catch (const Error& error) { throw ScriptError(text(error.what(), ", ", calls.seen())); }
}

std::vector<std::string> CalledLaw::try_each(const Block& block) {
  Runtime& runtime = law_.function.runtime();
  Calls calls(*this, block);
  const InLaw inside(runtime, calls);
  std::vector<std::string> failures(static_cast<std::size_t>(block.n));
  int most_noises = 0;
  for (std::size_t k = 0; k < failures.size(); k++) {
    try {
      runtime.run([&](lua_State* state) {
        LawCall call(state, calls);
        calls.evaluate(state, call, k);
      });
    } catch (const Interrupted&) { throw; } catch (const ScriptError& error) {
      if (runtime.watch().over) throw;
      failures[k] = error.what();
    }
    if (!calls.mistook.empty()) throw ScriptError(calls.mistook);
    most_noises = std::max(most_noises, calls.noises);
  }
  noises = std::min(noises, most_noises);
  return failures;
}

}  // namespace pantin::lua
