#pragma once
// What the function of a law sees while it runs: its particles, its parameters, time and noise; as symbols while it is
// traced, as numbers while it is called.
#include <cstddef>
#include <cstdint>
#include <lua.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "laws/law.hpp"
#include "lua/value/callback.hpp"

namespace pantin::lua {

class Runtime;

/// Which function a law was given, and so its arguments and what it returns.
enum class LawForm : std::uint8_t {
  pair_potential,   ///< (r, a, b, own, t) → J
  pair_tension,     ///< (r, rate, a, b, own, t) → N
  pair_force,       ///< (d, u, a, b, own, t) → vec, N
  point_potential,  ///< (p, own, t) → J
  point_force,      ///< (p, own, t) → vec, N
  many_potential,   ///< ({ p1, p2, … }, own, t) → J
  number_curve,     ///< (age, life) → number: no law, but traced as one
  color_curve,      ///< (age, life) → color
};

inline bool is_pair(LawForm form) { return form <= LawForm::pair_force; }
inline bool is_potential(LawForm form) {
  return form == LawForm::pair_potential || form == LawForm::point_potential || form == LawForm::many_potential;
}
inline bool is_curve(LawForm form) { return form == LawForm::number_curve || form == LawForm::color_curve; }
inline bool gives_vec(LawForm form) { return form == LawForm::pair_force || form == LawForm::point_force; }

/// The names that a law may read of one of its particles.
struct KnownNames {
  std::string whose;                    ///< "family 'water'": for messages
  std::vector<std::string> attributes;  ///< besides mass, radius, age and lifetime
  bool place = false;                   ///< of the world, which has nothing but where it is

  /// All of them.
  std::vector<std::string> all() const;
  /// Where among all of them a name is, or -1.
  std::ptrdiff_t find(std::string_view name) const;
  /// Whether a law made for one serves for the other; of places it does not matter which.
  friend bool operator==(const KnownNames& a, const KnownNames& b) {
    return a.place == b.place && a.attributes == b.attributes && (a.place || a.whose == b.whose);
  }
};

/// What every particle has: mass, radius, age, lifetime.
const std::vector<std::string>& common_attributes();

/// A function of a scene, as a law between known particles.
struct LawFunction {
  Callback function;
  LawForm form = LawForm::pair_potential;
  int count = 2;  ///< particles
  LawDef def;
  std::vector<KnownNames> known;  ///< (count)
  bool exact = true;              ///< an equality test is not traced
};

/// One run of a law's function, or many in a row.
class LawRun {
 public:
  enum class Seen : std::uint8_t { distance, rate, displacement, relative_velocity, place, velocity, time };

  explicit LawRun(const LawFunction& function) : law(function) {}
  virtual ~LawRun() = default;

  virtual void push(lua_State* state, Seen what, int who = 0) = 0;
  /// `index`: among all that are known of it.
  virtual void push_attribute(lua_State* state, int who, std::size_t index) = 0;
  virtual void push_parameter(lua_State* state, std::size_t index) = 0;
  virtual void push_noise(lua_State* state, int index) = 0;
  /// A field of a thing, or of the scene, is read. True: its value is at the top.
  virtual bool on_thing(lua_State* state, std::string_view field, bool of_scene) = 0;

  /// Ends the run for a fault of the scene, which no way of running the law forgives. The text gets the line.
  [[noreturn]] void mistake(lua_State* state, const std::string& text);

  const LawFunction& law;
  int noises = 0;       ///< calls of noise() so far
  std::string mistook;  ///< the mistake, if one was made
};

/// While it lives, `run` is what the arguments of laws answer for.
class InLaw {
 public:
  InLaw(Runtime& runtime, LawRun& run);
  ~InLaw();
  InLaw(const InLaw&) = delete;
  InLaw& operator=(const InLaw&) = delete;

 private:
  Runtime& runtime_;
  LawRun* previous_;
};

/// Calls a law's function again and again, with arguments that are made once and stay on the stack.
class LawCall {
 public:
  LawCall(lua_State* state, LawRun& run);
  /// Calls once; the result is at the top.
  void call();

 private:
  lua_State* state_;
  LawRun& run_;
  int base_;
};

/// Throws where the law that runs must not do this, as `math.random`.
void forbid_in_law(lua_State* state, const char* what, const char* instead);

/// Puts `noise` and `where` into the globals.
void open_law_run(lua_State* state);

}  // namespace pantin::lua
