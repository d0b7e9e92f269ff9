#include "lua/force_annotations.hpp"

#include <cmath>
#include <sstream>
#include <string_view>

#include "base/check.hpp"
#include "laws/library.hpp"

namespace pantin::lua {
namespace {

using Given = LibraryParameter::Given;

const char* const own_laws = R"(---A law: how particles pull at each other, or are pulled. It does not change.
---@class Law

---What a law sees of a particle: mass, radius, age, lifetime and its family's attributes.
---@class LawParticle
---@field position vec [m] of laws of single particles and of `force.many`
---@field velocity vec [m/s] of forces on single particles
---@field [string] number

---@class OwnLawOptions
---@field parameters? table<string, number> seen by the function as `own`; may be changed while the law acts
---@field strict? boolean an error where the function cannot be traced, and would be called every time
---@field exact? boolean false: == and ~= on numbers, always false of a traced one, are traced as that
---@field name? string in the ledger

---@class PairLawOptions
---@field cutoff? number [m] no force beyond; a connection keeps to one that is given here, not to what a law takes by itself
---@field shift? boolean the energy is 0 at the cutoff; true unless given
---@field one_sided? boolean b feels nothing of what a feels
---@field exclude? integer pairs within so many connections are left out
---@field implicit? boolean|"dissipative" connections are solved with what they tie, whatever their stiffness: with exact energy, or losing it; of a law that knows the time not where scene.accuracy is set

---@class ConnectOptions
---@field breaks_at? { force?: number, length?: number } [N] and [m] at which it breaks
---@field implicit? boolean|"dissipative" as of the law, for this connection
---@field name? string
---@field [string] number of the law's parameters, for this connection

---@class OwnPairLawOptions: OwnLawOptions, PairLawOptions
---@field potential? fun(r: number, a: LawParticle, b: LawParticle, own: table, t: number): number [J] of the distance
---@field tension? fun(r: number, rate: number, a: LawParticle, b: LawParticle, own: table, t: number): number [N] pulls when positive
---@field force? fun(d: vec, u: vec, a: LawParticle, b: LawParticle, own: table, t: number): vec [N] on a; d and u: place and velocity of b relative to a

---@class OwnPointLawOptions: OwnLawOptions
---@field potential? fun(p: LawParticle, own: table, t: number): number [J]
---@field force? fun(p: LawParticle, own: table, t: number): vec [N]

---@class OwnManyLawOptions: OwnLawOptions
---@field count integer 2, 3 or 4 particles
---@field potential fun(p: LawParticle[], own: table, t: number): number [J]

force = {}
---A law between two particles, of one of three functions.
---@param options OwnPairLawOptions
---@return Law
function force.pair(options) end
---A law on each of some particles, of one of two functions.
---@param options OwnPointLawOptions
---@return Law
function force.point(options) end
---A law of several particles at once.
---@param options OwnManyLawOptions
---@return Law
function force.many(options) end
)";

const char* const functions =
    R"(---In the function of a law: a normal deviate of mean 0 and variance 1, one for each call, pair and step.
---@return number
function noise() end

---@generic T
---@param condition boolean
---@param yes T
---@param no T
---@return T
function where(condition, yes, no) end

)";

bool is_of_pairs(const LibraryLaw& law) { return law.kind == LawKind::central || law.kind == LawKind::pair; }

/// "LennardJonesOptions"
std::string class_name(std::string_view law) {
  std::string name;
  bool capital = true;
  for (char c : law) {
    if (c != '_') name += capital ? static_cast<char>(c - 'a' + 'A') : c;
    capital = c == '_';
  }
  return name + "Options";
}

void write_parameter(std::ostringstream& out, const LibraryParameter& p) {
  const bool needed = p.given == Given::required;
  out << "---@field " << p.name << (needed ? " " : "? ") << (p.is_vector ? "vec" : "number");
  if (std::string_view(p.unit) != "1") out << " [" << p.unit << "]";
  out << " " << p.doc;
  if (p.given == Given::present) out << "; the present one unless given";
  if (p.given == Given::optional && !p.is_vector && std::isfinite(p.value)) out << "; " << to_text(p.value);
  out << "\n";
}

void write_law(std::ostringstream& out, const LibraryLaw& law) {
  out << "---@class " << class_name(law.name) << (is_of_pairs(law) ? ": PairLawOptions" : "") << "\n";
  for (const LibraryParameter& p : law.parameters)
    if (p.given != Given::world) write_parameter(out, p);
  if (std::string_view(law.name) == "table")
    out << "---@field distances number[] [m] rising\n---@field potentials? number[] [J] at the distances\n"
           "---@field tensions? number[] [N] at the distances, instead\n";
  out << "---@field name? string in the ledger\n\n";
  out << "---" << law.doc << " (" << law.source << ")\n---@param options " << class_name(law.name)
      << "\n---@return Law\nfunction force." << law.name << "(options) end\n";
}

}  // namespace

std::string force_annotations() {
  std::ostringstream out;
  out << own_laws;
  for (const LibraryLaw& law : library()) write_law(out, law);
  out << "\n" << functions;
  return out.str();
}

}  // namespace pantin::lua
