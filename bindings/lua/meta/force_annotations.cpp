#include "lua/meta/force_annotations.hpp"

#include <cmath>
#include <sstream>
#include <string_view>
#include <utility>

#include "base/check.hpp"
#include "laws/library.hpp"
#include "lua/meta/annotations.hpp"

namespace pantin::lua {
namespace {

using Given = LibraryParameter::Given;

const char* const own_laws = R"(---A law: how particles pull at each other, or are pulled. It does not change.
---@class Law

---What a law sees of a particle: mass, radius, age, lifetime and its family's attributes.
---@class LawParticle
---@field position vec [m] of laws of single particles and of `force.many`
---@field velocity vec [m/s] of forces on single particles
---@field [string] number [each its own]

---@class LawOptions
---@field name? string in the ledger (default the law's, or the line where it was written)

---@class OwnLawOptions: LawOptions
---@field parameters? table<string, number> [each its own] seen by the function as `own`; may be changed while the law acts (default `{}`)
---@field strict? boolean an error where the function cannot be traced, and would be called every time (default `false`)
---@field exact? boolean false: == and ~= on numbers, always false of a traced one, are traced as that (default `true`)

---@class PairLawOptions: LawOptions
---@field cutoff? number [m] no force beyond; a connection keeps to one that is given here, not to what a law takes by itself (default what the law says, or `math.huge`)
---@field shift? boolean the energy is 0 at the cutoff (default `true`)
---@field one_sided? boolean b feels nothing of what a feels (default `false`)
---@field exclude? integer pairs within so many connections are left out (default `0`)
---@field implicit? boolean|"dissipative" connections are solved with what they tie, whatever their stiffness: with exact energy, or losing it; of a law that knows the time not where scene.accuracy is set (default `false`)

---@class ConnectOptions: NameOptions
---@field breaks_at? Breaking force and length (default `{}`)
---@field implicit? boolean|"dissipative" for this connection (default as of the law)
---@field [string] number [each its own] of the law's parameters, for this connection

---@class OwnPairLawOptions: OwnLawOptions, PairLawOptions
---@field potential? fun(r: number, a: LawParticle, b: LawParticle, own: table, t: number): number [J] of the distance (default none)
---@field tension? fun(r: number, rate: number, a: LawParticle, b: LawParticle, own: table, t: number): number [N] pulls when positive (default none)
---@field force? fun(d: vec, u: vec, a: LawParticle, b: LawParticle, own: table, t: number): vec [N] on a; d and u: position and velocity of b relative to a (default none)

---@class OwnPointLawOptions: OwnLawOptions
---@field potential? fun(p: LawParticle, own: table, t: number): number [J] (default none)
---@field force? fun(p: LawParticle, own: table, t: number): vec [N] (default none)

---@class OwnManyLawOptions: OwnLawOptions
---@field count integer 2, 3 or 4 particles
---@field potential fun(p: LawParticle[], own: table, t: number): number [J]

force = {}
---A law between two particles, of one of three functions.
---```lua
---local law = force.pair { potential = function(r, a, b, own) return own.k * (r - 1) ^ 4 end, parameters = { k = 5 } }
---scene:connect(p, q, law)
---```
---@param options OwnPairLawOptions
---@return Law
function force.pair(options) end
---A law on each of some particles, of one of two functions.
---```lua
---scene:field(scene, force.point { force = function(p) return -0.1 * p.mass * p.velocity end })
---```
---@param options OwnPointLawOptions
---@return Law
function force.point(options) end
---A law of several particles at once.
---```lua
---local law = force.many { count = 3, potential = function(p)
---  return (p[1].position - 2 * p[2].position + p[3].position):length() ^ 2 end }
---scene:connect({ p, q, ion }, law)
---```
---@param options OwnManyLawOptions
---@return Law
function force.many(options) end
)";

const char* const functions =
    R"(---In the function of a law: a normal deviate of mean 0 and variance 1, one for each call, pair and step.
---```lua
---scene:field(scene, force.point { force = function(p) return vec(noise(), noise(), 0) end })
---```
---@return number
function noise() end

---In the function of a law: one of two values, without a branch.
---```lua
---scene:field(scene, force.point { force = function(p) return vec(0, where(p.position.y < 0, 5, 0), 0) end })
---```
---@generic T
---@param condition boolean
---@param yes T
---@param no T
---@return T
function where(condition, yes, no) end

)";

/// A call of each law, and its use.
const std::pair<std::string_view, const char*> examples[] = {
    {"spring", "scene:connect(p, q, force.spring { stiffness = 100, damping = 2 })"},
    {"damper", "scene:connect(p, q, force.damper { damping = 5 })"},
    {"gravitation", "scene:interact(ions, ions, force.gravitation { constant = 1, softening = 0.1 })"},
    {"coulomb", "scene:interact(ions, ions, force.coulomb { constant = 1 })"},
    {"morse", "scene:connect(p, q, force.morse { depth = 5, steepness = 2 })"},
    {"buckingham", "scene:interact(ions, ions, force.buckingham { repulsion = 100, steepness = 3, attraction = 1 })"},
    {"yukawa", "scene:interact(ions, ions, force.yukawa { strength = 2, screening = 0.5, cutoff = 3 })"},
    {"table", "scene:connect(p, q, force.table { distances = { 0.5, 1, 2 }, tensions = { -5, 0, 3 } })"},
    {"lennard_jones", "scene:interact(ions, ions, force.lennard_jones { epsilon = 1, sigma = 0.3 })"},
    {"wca", "scene:interact(ions, ions, force.wca { epsilon = 1, sigma = 0.3 })"},
    {"hydrophobic", "scene:interact(ions, ions, force.hydrophobic { strength = 1, size = 0.3 })"},
    {"repel", "scene:interact(ions, ions, force.repel { stiffness = 1000 })"},
    {"flock", "scene:interact(ions, ions, force.flock { sight = 2, separation = 0.1, alignment = 1, cohesion = 0.5 })"},
    {"drag", "scene:field(scene, force.drag { linear = 0.1, quadratic = 0.05 })"},
    {"wind", "scene:field(ions, force.wind { velocity = vec(3, 0, 0), linear = 0.2 })"},
    {"vortex", "scene:field(ions, force.vortex { axis = vec(0, 1, 0), circulation = 5, core = 0.5, linear = 0.2 })"},
    {"buoyancy", "scene:field(group, force.buoyancy { density = 1000, surface = 0.5 })"},
    {"thermostat", "scene:field(ions, force.thermostat { rate = 2, temperature = 1 })"},
    {"wall", "scene:field(scene, force.wall { normal = vec(0, 1, 0), stiffness = 1e4, damping = 20, friction = 0.3 })"},
    {"angle", "scene:connect({ p, q, ion }, force.angle { stiffness = 2, angle = math.pi / 2 })"},
    {"torsion", "scene:connect({ p, q, ion, elbow }, force.torsion { stiffness = 2, fold = 3 })"},
};

const char* example_of(const LibraryLaw& law) {
  for (const auto& [name, example] : examples)
    if (name == law.name) return example;
  return "";
}

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
  out << "---@field " << p.name << (needed ? " " : "? ") << (p.is_vector ? "vec" : "number") << " [" << p.unit << "] ";
  // What stands for a value that depends on others is the last word of its sentence: "w; 1.6 b".
  const std::string_view doc = p.doc;
  const bool told = p.given == Given::optional && !p.is_vector && !std::isfinite(p.value);
  const auto semicolon = told ? doc.rfind("; ") : doc.npos;
  out << doc.substr(0, semicolon);
  if (told) out << " (default " << (semicolon == doc.npos ? "none" : doc.substr(semicolon + 2)) << ")";
  if (p.given == Given::present) out << " (default the present one)";
  if (p.given == Given::optional && p.is_vector) out << " (default `vec(0, 0, 0)`)";
  if (p.given == Given::optional && std::isfinite(p.value) && !p.is_vector)
    out << " (default `" << to_text(p.value) << "`)";
  out << "\n";
}

void write_law(std::ostringstream& out, const LibraryLaw& law) {
  out << "---@class " << class_name(law.name) << (is_of_pairs(law) ? ": PairLawOptions" : ": LawOptions") << "\n";
  for (const LibraryParameter& p : law.parameters)
    if (p.given != Given::world) write_parameter(out, p);
  if (std::string_view(law.name) == "table")
    out << "---@field distances number[] [m] rising\n---@field potentials? number[] [J] at the distances; this or "
           "tensions (default none)\n"
           "---@field tensions? number[] [N] at the distances, positive where they pull (default none)\n";
  out << "\n---" << law.doc << " (" << law.source << ")\n";
  write_example(out, example_of(law));
  out << "---@param options " << class_name(law.name) << "\n---@return Law\nfunction force." << law.name
      << "(options) end\n";
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
