#include "lua/thing/build_options.hpp"

#include "lua/law/force.hpp"
#include "lua/law/recheck.hpp"
#include "lua/thing/family_options.hpp"
#include "lua/thing/fields.hpp"
#include "lua/thing/force_element_options.hpp"
#include "lua/thing/script.hpp"
#include "lua/thing/shape_options.hpp"
#include "lua/thing/structure_type.hpp"
#include "lua/thing/targets.hpp"
#include "lua/value/arguments.hpp"
#include "lua/vm/guard.hpp"
#include "structures/build.hpp"

namespace pantin::lua {
namespace {

const char* const forms[] = {"nothing", "deformable", "rigid", "articulated", "panels"};

BuildAs check_form(lua_State* state, int index, const std::string& name) {
  if (lua_type(state, index) == LUA_TSTRING)
    for (std::size_t i = 1; i < std::size(forms); i++)
      if (std::string_view(lua_tostring(state, index)) == forms[i]) return static_cast<BuildAs>(i);
  const std::string got = lua_type(state, index) == LUA_TSTRING ? text("\"", lua_tostring(state, index), "\"")
                                                                : kind_of_value(state, index);
  throw Error(text("build: ", name, " must be \"deformable\", \"rigid\", \"articulated\" or \"panels\", got ", got));
}

/// What the function at `index` says of each part; nil is nothing.
std::vector<BuildAs> forms_of(lua_State* state, int index, const Structure& s, Part part, const std::string& name) {
  require(lua_isfunction(state, index), "build: ", name, " must be a function, got ", kind_of_value(state, index));
  const std::size_t count = part == Part::vertices ? s.vertices.size()
                            : part == Part::edges  ? s.edges.size()
                                                   : s.faces.size();
  std::vector<BuildAs> all;
  for (std::uint32_t i = 0; i < count; i++) {
    lua_pushvalue(state, index);
    lua_call(state, push_part(state, s, part, i), 1);
    all.push_back(lua_toboolean(state, -1) ? check_form(state, lua_gettop(state), "what the function returns")
                                           : BuildAs::nothing);
    lua_pop(state, 1);
  }
  return all;
}

std::function<BuildAs(std::uint32_t)> table_of(std::vector<BuildAs> all) {
  return [all = std::move(all)](std::uint32_t i) { return all[i]; };
}

/// A form, a function of vertices, or functions by name.
void read_as(const Options& o, const Structure& s, BuildDef& def) {
  lua_State* state = o.state();
  const int at = o.push("as");
  if (lua_isfunction(state, at)) {
    def.vertices = table_of(forms_of(state, at, s, Part::vertices, "as"));
  } else if (lua_istable(state, at)) {
    const Options parts(state, at, "build: as", {"vertices", "edges", "faces"});
    const auto read = [&](const char* name, Part part, std::function<BuildAs(std::uint32_t)>& form) {
      if (parts.has(name)) form = table_of(forms_of(state, parts.push(name), s, part, text("as.", name)));
    };
    read("vertices", Part::vertices, def.vertices);
    read("edges", Part::edges, def.edges);
    read("faces", Part::faces, def.faces);
    require(def.vertices || def.edges || def.faces, "build: as must have a function of vertices, edges or faces");
  } else {
    def.as = check_form(state, at, "as");
  }
  lua_settop(state, at - 1);
}

/// A law at the top of the stack, for `count` particles.
ResolvedLaw read_law(const Self& self, const std::string& name, int count, FamilyId family) {
  const LawSpec* spec = to_law(self.state, -1);
  require(spec, "build: ", name, " must be a law, got ", kind_of_value(self.state, -1));
  require(spec->kind != LawKind::point && spec->count == count, "build: ", name, " must tie ", count, " particles; ",
          spec->word, spec->kind == LawKind::point ? " acts on one" : text(" ties ", spec->count));
  const KnownNames particle = family ? names_of_family(self.world, family) : KnownNames{"the structure", {}};
  const std::vector<KnownNames> known(static_cast<std::size_t>(count), particle);
  return resolve_law(self.state, lua_gettop(self.state), self.world, known, false);
}

/// Laws by what they tie, and how to compare them with their functions.
struct BuildLaws {
  std::vector<std::pair<BuildLaw*, ResolvedLaw>> read;

  void add(const Self& self, const Options& o, const char* key, const std::string& name, int count, FamilyId family,
           BuildLaw& law) {
    if (!o.has(key)) return;
    o.push(key);
    const ResolvedLaw resolved = read_law(self, name, count, family);
    lua_pop(self.state, 1);
    law = {resolved.laws.front(), resolved.values, resolved.solve};
    read.push_back({&law, resolved});
  }
};

BuildLaws read_laws(const Self& self, const Options& o, BuildDef& def) {
  BuildLaws laws;
  require(!(o.has("law") && o.has("laws")),
          "build: give law, of the edges, or laws = { edge, angle, torsion }, not both");
  laws.add(self, o, "law", "law", 2, def.family, def.edge);
  if (!o.has("laws")) return laws;
  const Options by_name(self.state, o.push("laws"), "build: laws", {"edge", "angle", "torsion"});
  laws.add(self, by_name, "edge", "laws.edge", 2, def.family, def.edge);
  laws.add(self, by_name, "angle", "laws.angle", 3, def.family, def.angle);
  laws.add(self, by_name, "torsion", "laws.torsion", 4, def.family, def.torsion);
  lua_pop(self.state, 1);
  return laws;
}

std::optional<ShapeDef> read_hull(const Options& o) {
  const auto shape = o.string("shape");
  require(!shape || *shape == "hull", "build: shape must be \"hull\", got \"", shape.value_or(""), "\"");
  for (const char* name : {"friction", "restitution", "rolling", "spinning", "layer"})
    require(shape || !o.has(name), "build: ", name, " is of shapes, and there are none; give shape = \"hull\"");
  if (!shape) return {};
  ShapeDef def;
  def.material = material_of(o);
  def.layer = layer_option(o);
  return def;
}

/// Laws that nothing obeys, and particles that no law ties, are told of.
void tell_of_laws(World& world, const Structure& structure, const BuildDef& def, bool with_laws) {
  if (def.vertices || def.edges || def.faces) return;
  const std::string what = def.name.empty() ? "build" : text("build '", def.name, "'");
  if (def.as == BuildAs::deformable && !with_laws && !structure.edges.empty())
    log_line(world, "notice", what + ": nothing ties the particles along the edges: no law was given");
  if (def.as == BuildAs::rigid && with_laws)
    log_line(world, "notice", what + ": a rigid body has no use for the law that was given");
}

}  // namespace

int scene_build(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "build");
  const Structure& structure = check_structure(state, 2, "build", argument(1));
  const Options o(state, 3, "build",
                  {"as", "law", "laws", "mass", "mass_in", "at", "velocity", "family", "color", "radius", "axis",
                   "name", "shape", "friction", "restitution", "rolling", "spinning", "layer"});
  require(o.has("as"), "build: needs as = \"deformable\", \"rigid\", \"articulated\" or \"panels\"");
  BuildDef def;
  if (o.has("family")) {
    def.family = check_kind(state, o.push("family"), Kind::family, "build", "family").id<FamilyId>();
    lua_pop(state, 1);
  }
  const BuildLaws laws = read_laws(self, o, def);
  def.mass = o.number("mass", "kg").value_or(def.mass);
  if (o.has("mass_in")) {
    def.mass_in = check_mass_in(state, o.push("mass_in"), "build", "mass_in");
    lua_pop(state, 1);
  }
  def.at = o.vector("at", "m").value_or(def.at);
  def.velocity = o.vector("velocity", "m/s").value_or(def.velocity);
  def.color = o.color("color");
  def.radius = o.number("radius", "m");
  def.axis = o.vector("axis", "");
  def.name = o.string("name").value_or("");
  def.hull = read_hull(o);
  read_as(o, structure, def);
  const Built built = build(self.world, structure, def);
  tell_of_laws(self.world, structure, def, !laws.read.empty());
  for (ConnectionId id : built.connections)
    for (const auto& [law, resolved] : laws.read)
      if (self.world.connections[id].law == law->law) watch_law(self.script.laws, id, resolved);
  push_thing(state, self.script, built.group);
  return 1;
}

}  // namespace pantin::lua
