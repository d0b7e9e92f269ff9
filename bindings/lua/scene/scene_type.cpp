// `scene`: the table of all that it can do.
#include "lua/scene/scene_type.hpp"

#include <filesystem>

#include "edit/edit.hpp"
#include "lua/scene/box_call.hpp"
#include "lua/scene/choreography.hpp"
#include "lua/scene/events.hpp"
#include "lua/scene/parameters.hpp"
#include "lua/scene/scene_settings.hpp"
#include "lua/scene/snapshot.hpp"
#include "lua/scene/sounds.hpp"
#include "lua/scene/touch_methods.hpp"
#include "lua/thing/assemble.hpp"
#include "lua/thing/body_options.hpp"
#include "lua/thing/build_options.hpp"
#include "lua/thing/constraint_options.hpp"
#include "lua/thing/emitter_options.hpp"
#include "lua/thing/family_options.hpp"
#include "lua/thing/fields.hpp"
#include "lua/thing/force_element_options.hpp"
#include "lua/thing/look_options.hpp"
#include "lua/thing/point_constraint_options.hpp"
#include "lua/thing/script.hpp"
#include "lua/thing/shape_type.hpp"
#include "lua/thing/structure_type.hpp"
#include "lua/thing/targets.hpp"
#include "lua/value/arguments.hpp"
#include "lua/vm/guard.hpp"
#include "scene/files.hpp"

namespace pantin::lua {
namespace {

int scene_particle(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "particle");
  ParticleDef def;
  std::vector<std::string_view> known = {"at", "velocity", "mass", "radius", "color", "look", "lifetime", "name"};
  const FamilyOption family = family_option(state, 2, "particle", known);
  const Options o(state, 2, "particle", known);
  def.at = o.vector("at", "m").value_or(def.at);
  def.velocity = o.vector("velocity", "m/s").value_or(def.velocity);
  def.mass = o.number("mass", "kg");
  def.family = family.id;
  take_looks(def, o, family.attributes);
  def.lifetime = o.number_or_infinity("lifetime", "s").value_or(def.lifetime);
  def.name = o.string("name").value_or("");
  push_thing(state, self.script, add_particle(self.world, def));
  return 1;
}

int scene_body(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "body");
  push_thing(state, self.script, add_body(self.world, body_def(self.script, state, 2)));
  return 1;
}

int make_solid(lua_State* state, const char* kind, const char* call) {
  const Self self = check_self(state, Kind::scene, call);
  push_thing(state, self.script, add_body(self.world, solid_def(self.script, state, 2, kind, call)));
  return 1;
}
int scene_ball(lua_State* state) { return make_solid(state, "ball", "ball"); }
int scene_box(lua_State* state) { return make_solid(state, "box", "box"); }
int scene_capsule(lua_State* state) { return make_solid(state, "capsule", "capsule"); }
int scene_cylinder(lua_State* state) { return make_solid(state, "cylinder", "cylinder"); }

int scene_group(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "group");
  push_thing(state, self.script, add_group(self.world, check_text(state, 2, "group", "argument 1, the name,")));
  return 1;
}

int scene_result(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "result");
  const std::string name = check_name(state, 2, "result");
  SceneValue value;
  switch (lua_type(state, 3)) {
    case LUA_TNUMBER: value = check_number(state, 3, "result", "argument 2, the value,", ""); break;
    case LUA_TBOOLEAN: value = lua_toboolean(state, 3) != 0; break;
    case LUA_TSTRING: value = check_text(state, 3, "result", "argument 2, the value,"); break;
    default:
      throw Error(text("result: argument 2, the value, must be a number, true or false, or a string, got ",
                       kind_of_value(state, 3)));
  }
  self.script.results.insert_or_assign(name, std::move(value));
  return 0;
}

/// The step is done to its end first.
int scene_open(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "open");
  const std::string name = check_text(state, 2, "open", "argument 1, the file,");
  Runtime& runtime = self.script.runtime;
  const std::string path = path_in(runtime.folder, name);
  require(name.ends_with(".lua"), "open: argument 1, the file, must end in .lua, got '", name, "'");
  require(stays_inside(name) && lies_below(path, runtime.folder), "open: '", name,
          "' must be a file below the scene's folder");
  require(runtime.read(path, largest_source), "open: there is no file '", name, "' in the scene's folder");
  NextScene next{path, given_parameters(state, 3, "open"), where(state)};
  const NextScene& chosen = self.script.next;
  const std::string already = std::filesystem::path(chosen.path).filename().string();
  require(chosen.path.empty() || chosen.path == path, "open: the next scene is ", already, " already");
  require(chosen.path.empty() || chosen.parameters == next.parameters, "open: the next scene is ", already,
          " already, with other parameters");
  std::string with;
  for (const auto& [parameter, value] : next.parameters)
    with += text(with.empty() ? " with " : ", ", parameter, " = ", setting_text(value));
  log_line(self.world, "notice", text(next.place, ": the next scene is ", name, with));
  self.script.next = std::move(next);
  self.script.finished = true;
  return 0;
}

int scene_finish(lua_State* state) {
  check_self(state, Kind::scene, "finish").script.finished = true;
  return 0;
}

/// Of a kind of which a scene has one.
void push_one(const Self& s, Kind kind) { push_ref(s.state, make_ref(s.script, kind, 1, 1, 1)); }

void read_hands(const Self& s) {
  lua_newtable(s.state);
  for (std::size_t i = 0; i < s.world.hands.size(); i++) {
    push_hand(s.state, s.script, static_cast<std::int32_t>(i));
    lua_rawseti(s.state, -2, static_cast<lua_Integer>(i + 1));
  }
}

std::vector<Method> making() {
  return {
      {"particle", guard<scene_particle>, "options?: ParticleOptions", "Particle",
       "Makes a free particle of one point.",
       "local drop = scene:particle { at = vec(0, 2, 0), velocity = vec(1, 0, 0), mass = 0.1, color = \"#4af\" }"},
      {"body", guard<scene_body>, "options: BodyOptions", "Body", "Makes a rigid body.",
       "local rod = scene:body { at = vec(0, 3, 0),\n"
       "  points = { left = { at = vec(-1, 0, 0), mass = 1 }, right = { at = vec(1, 0, 0), mass = 1 } } }"},
      {"ball", guard<scene_ball>, "options: BallOptions", "Body", "Makes a rigid body that is a ball, which touches.",
       "local ball = scene:ball { radius = 0.2, at = vec(0, 2, 0), velocity = vec(3, 0, 0), restitution = 0.7 }"},
      {"box", guard<scene_box>, "options: BoxOptions", "Body", "Makes a rigid body that is a box, which touches.",
       "local crate = scene:box { size = vec(1, 1, 1), at = vec(0, 3, 0), density = 300, friction = 0.4 }\n"
       "local pictured = scene:box { size = 1, at = vec(2, 3, 0), picture = \"crate.png\" }"},
      {"block", guard<scene_box>, "options: BoxOptions", "Body", "The same as scene:box.",
       "local brick = scene:block { size = vec(0.2, 0.1, 0.1), at = vec(0, 4, 0) }"},
      {"capsule", guard<scene_capsule>, "options: CapsuleOptions", "Body",
       "Makes a rigid body that is a cylinder with round ends, which touches.",
       "local pill = scene:capsule { radius = 0.2, length = 0.5, at = vec(0, 2, 0) }"},
      {"cylinder", guard<scene_cylinder>, "options: CylinderOptions", "Body",
       "Makes a rigid body that is a cylinder, which touches.",
       "local wheel = scene:cylinder { radius = 0.5, length = 0.1, axis = vec(0, 0, 1), at = vec(0, 2, 0) }"},
      {"merge", guard<scene_merge>, "a: Body, b: Body", "Body",
       "a lives on with b's points, which stay valid; b is gone.", "local both = scene:merge(arm, block)"},
      {"split", guard<scene_split>, "body: Body, points: Point|Point[]|CuttingPlane, ...: Point", "Body",
       "Makes a body of its own of some of a body's points, or of what of it is in front of a plane. Shapes go with "
       "the points that are in them, else with the nearest; a plane cuts them. Parts of a ball, a capsule or a "
       "cylinder "
       "are hulls with its mass; those of a cylinder cut across are cylinders.",
       "local corner = scene:split(block, block.points[1], block.points[2], block.points[3])\n"
       "local top = scene:split(scene:box { size = 1, at = vec(0, 9, 0) }, { through = vec(0, 9, 0), normal = vec(1, "
       "1, "
       "0) })"},
      {"freeze", guard<scene_freeze>, "group: Group", "Body",
       "Makes one body of the free particles and the bodies of a group.",
       "local lump = scene:freeze(scene:group(\"to be one\"):add(p, q, block))"},
      {"shatter", guard<scene_shatter>, "body: Body, options?: ShatterOptions", "Particle[]|Body[]",
       "Makes free particles of a body's points; those without mass are gone. With `pieces`, it breaks a body with "
       "shapes into that many bodies, hulls that have its mass and move on as it did.",
       "for _, piece in ipairs(scene:shatter(block)) do piece.color = \"#f40\" end\n"
       "local plate = scene:box { size = vec(2, 0.1, 2), at = vec(0, 9, 0) }\n"
       "scene:on(\"touched\", plate, function(touch) scene:shatter(plate, { pieces = 30, at = touch.at }) end)"},
      {"connect_within", guard<scene_connect_within>,
       "group: Group, distance: number [m], law: Law, options?: ConnectOptions", "Connection[]",
       "Ties the particles of a group that are nearer than a distance and not tied yet.",
       "scene:connect_within(group, 5, spring, { breaks_at = { length = 8 } })"},
      {"group", guard<scene_group>, "name: string", "Group", "Makes a named set of things.",
       "local pair = scene:group(\"a pair\"):add(p, q)"},
      {"family", guard<scene_family>, "name: string, options?: FamilyOptions", "Family",
       "Makes a family of particles, with named numeric attributes.",
       "local electrons = scene:family(\"electrons\", { attributes = { charge = -1.6e-19 }, mass = 9.1e-31 })"},
      {"emitter", guard<scene_emitter>, "options: EmitterOptions", "Emitter", "Makes particles at a rate.",
       "local fountain = scene:emitter { at = vec(0, 0, 0), rate = 50, velocity = vec(0, 5, 0), spread = 0.2, lifetime "
       "= 2 }"},
      {"build", guard<scene_build>, "structure: Structure, options: BuildOptions", "Group",
       "Makes a structure real; the group has its parts in the structure's order.",
       "local cloth = scene:build(structure.sheet { columns = 4, rows = 4, edge = 0.2 },\n"
       "  { as = \"deformable\", law = spring, mass = 0.5, at = vec(0, 5, 0) })"},
      {"hand", guard<scene_hand>, "options?: HandOptions", "Hand", "Makes a hand; with a path it moves by itself.",
       "local hand = scene:hand { path = function(t) return vec(-2 + t, 1, 0) end }\n"
       "scene:at(0.5, function() hand:grab(p, { max_force = 20 }) end)"},
  };
}

std::vector<Method> constraining() {
  std::vector<Method> methods = {
      {"hinge", guard<scene_hinge>, "a: Point|Particle, b: Point|Particle, ...: Point|Particle|HingeOptions",
       "Particle",
       "Joins points of two or more bodies, or free particles, into one particle. Bodies that share a hinge pass "
       "through "
       "each other, unless it says collide = true; each touches everything else: the world, and bodies further along a "
       "chain. What shall not touch those either gets a layer, and scene:collide(layer, other, false). Where a point "
       "is in "
       "a hinge already, the new hinge takes that one's place, with all that it joins: it keeps the name and breaks_at "
       "that it is not given anew.",
       "local foot = scene:body { at = leg.tail.position, mass = 1, inertia = vec(1, 1, 1), points = { heel = vec(0, "
       "0, 0) } }\n"
       "scene:hinge(leg.tail, foot.heel, { name = \"ankle\", breaks_at = { force = 1000 } })"}};
  for (const ConstraintCall* call : constraint_calls()) methods.push_back(call->method);
  return methods;
}

std::vector<Method> forcing() {
  return {
      {"connect", guard<scene_connect>,
       "a: Point|Particle|vec|(Point|Particle|vec)[] [m], b: Point|Particle|vec|Law [m], law?: Law|ConnectOptions, "
       "options?: "
       "ConnectOptions",
       "Connection", "Ties two particles by a law; or a list of two, three or four.",
       "local tie = scene:connect(p, q, spring, { name = \"tie\", length = 1 })\n"
       "scene:connect({ p, q, ion }, force.angle { stiffness = 2 })"},
      {"bonding", guard<scene_bonding>, "options: BondingOptions", "Event",
       "Breaks what ties the particles of families above a temperature; below one ties what is near, or joins it to "
       "hinges.",
       "scene:bonding { families = ions, near = 0.2, below = 5, above = 10, law = spring }"},
      {"interact", guard<scene_interact>, "a: Family, b: Family, law: Law", "Interaction",
       "A law between all pairs of two families, or within one.",
       "scene:interact(ions, ions, force.coulomb { constant = 1, cutoff = 5 })"},
      {"field", guard<scene_field>, "target: Family|Group|Scene, law: Law", "Field",
       "A law on each particle of a family, of a group or of the scene. Of bodies it acts on their points alone.",
       "scene:field(scene, force.drag { linear = 0.1 })\n"
       "scene:field(ions, force.point { force = function(p) return vec(p.charge, 0, 0) end })"},
  };
}

std::vector<Method> choreographing() {
  return {
      {"param", guard<scene_param>, "name: string, default: number|boolean|string [its own], options?: ParamOptions",
       "any", "Declares a parameter and returns its value.",
       "local links = scene:param(\"links\", 8, { min = 1, max = 100, step = 1, help = \"how many links\" })"},
      {"at", guard<scene_at>, "time: number [s], target_or_action: Thing|function, action?: function", "Event",
       "Does it once, at the beginning of the first step whose time is not before it: never early. A run that ends at "
       "that time does not do it.",
       "scene:at(1, function() scene.gravity = vec(0, 0, 0) end)"},
      {"after", guard<scene_after>, "delay: number [s], target_or_action: Thing|function, action?: function", "Event",
       "Does it once, a while from now, by the rule of at.", "scene:after(2, elbow, function(hinge) hinge:cut() end)"},
      {"every", guard<scene_every>, "period: number [s], target_or_action: Thing|function, action?: function", "Event",
       "Does it again and again, at period, 2 period, … from now on, by the rule of at.",
       "local ticks = scene:every(0.5, function() print(scene.time) end)"},
      {"over", guard<scene_over>,
       "from: number [s], to: number [s], target_or_action: Thing|fun(u: number), action?: fun(u: number, target: "
       "Thing)",
       "Event",
       "Does it at the beginning of each step from one time to another, with u from 0 to 1; with 1 for sure, and "
       "last.",
       "scene:over(1, 3, function(u) scene.gravity = vec(0, -9.81 * (1 - u), 0) end)"},
      {"when", guard<scene_when>,
       "condition: Condition|fun(): boolean, target_or_action: Thing|function, action?: function|WhenOptions, "
       "options?: WhenOptions",
       "Event", "Does it at the beginning of the first step at which something holds.",
       "scene:when({ distance_below = 1, of = { p, q } }, function() print(\"near\") end)\n"
       "scene:when(function() return p.position.y < 0 end, p, function(it) it:remove() end)"},
      {"play", guard<scene_play>,
       "target_or_script: Thing|fun(wait: Waiting), script?: fun(wait: Waiting, target: Thing)", "Event",
       "A script that waits: wait(2) [s] by the rule of at, wait(function() … end), wait() for the next step.",
       "scene:play(function(wait)\n"
       "  p:kick(vec(0, 1, 0)) wait(0.5) q:kick(vec(0, 1, 0))\n"
       "end)"},
      {"on", guard<scene_on>,
       "moment: Moment, filter_or_action: string|Body|Particle|Collider|Group|Family|function, action?: function",
       "Subscription",
       "Calls a function at each \"step\" (dt), \"press\" \"release\" (hand), \"key\" \"key_up\" (name), \"grab\" "
       "\"drop\" "
       "(point, hand), "
       "\"cut\" \"joined\" (hinge), \"broke\" (connection, constraint or hinge, force [N] or torque [N m], story), "
       "\"removed\" (thing, "
       "story). on(\"key\", \"x\", action) and on(\"key_up\", \"x\", action) take that key from the window, whatever "
       "that "
       "does with it; without a name, keys are heard that the window has no use for, and of those that are let go the "
       "ones "
       "that the scene has taken. Of a gamepad \"pad.a\" is a key, too. "
       "\"touched\" \"parted\" (Touch) are told in the step after, once "
       "for "
       "two things, and with a filter only of it: a body, a solid particle, a floor or ground, a group of these, a "
       "family, "
       "or the name of a layer.",
       "scene:on(\"broke\", function(thing, load, story) print(story) end)\n"
       "scene:on(\"key\", \"x\", function() p:kick(vec(0, 1, 0)) end)\n"
       "scene:on(\"touched\", block, function(touch) print(touch.b, touch.speed, touch.impulse) end)"},
      {"behave", guard<scene_behave>, "target: Thing|Scene, behaviour: Behaviour, options?: table", "Subscription",
       "Puts a behaviour to work on a target, with which it ends.",
       "scene:behave(p, { step = function(self) self.target:push(vec(self.options.pull, 0, 0)) end }, { pull = 3 })"},
  };
}

std::vector<Method> telling() {
  return {
      {"button", guard<scene_button>, "name: string, action: function", "", "Puts a button in the window.",
       "scene:button(\"kick\", function() p:kick(vec(0, 2, 0)) end)"},
      {"probe", guard<scene_probe>, "name: string, read: fun(): number", "",
       "Records a number each step. `pantin run --out t.csv --when NAME` writes a row where it changes.",
       "scene:probe(\"height\", function() return p.position.y end)"},
      {"result", guard<scene_result>, "name: string, value: number|boolean|string [its own]", "",
       "Puts a value into the summary.",
       "scene:at(0, function() scene:result(\"gap\", (p.position - q.position):length()) end)"},
      {"finish", guard<scene_finish>, "", "", "Ends the run.",
       "scene:when({ energy_below = 1 }, function() scene:finish() end)"},
      {"snapshot", guard<scene_snapshot>, "", "Snapshot",
       "The present state, kept in memory. Taking it changes nothing of the run.", "local before = scene:snapshot()"},
      {"restore", guard<scene_restore>, "snapshot: Snapshot", "",
       "Goes back to a snapshot once the step is done. Things, events and handlers are those of then, and handles of "
       "them "
       "are theirs again; what was made since is gone. An error while a play goes on.",
       "local before\n"
       "scene:button(\"again\", function() scene:restore(before) end)\n"
       "before = scene:snapshot()  -- last: what is made after it is gone with the first restore"},
      {"reset", guard<scene_reset>, "", "",
       "Goes back to the start of the first step, as restore does. A state in a file has none: there it is an error.",
       "scene:button(\"from the start\", function() scene:reset() end)"},
      {"rewind", guard<scene_rewind>, "by: number [s]", "",
       "Goes back by a time to a state that scene.history has kept, once the step is done, as restore does. What was "
       "before a state in a file is not kept.",
       "scene.history = 3\n"
       "scene:on(\"key\", \"z\", function() scene:rewind(2) end)"},
      {"save", guard<scene_save>, "file: string", "",
       "Saves the state once the step is done, with the script, what it keeps in its variables, and the files that it "
       "read, into a file that ends in .pantin, where the program was started or below.",
       "scene:button(\"save\", function() scene:save(\"state.pantin\") end)"},
  };
}

std::vector<Method> playing() {
  return {
      {"sound", guard<scene_sound>, "sound: string, options?: SoundOptions", "",
       "Lets a sound be heard: \"wood\", \"metal\", \"glass\", \"rubber\" as if struck, \"blip\", \"noise\", or a "
       ".wav file below the scene's folder. It changes nothing of the motion, and is heard in the window alone.",
       "scene:on(\"touched\", block, function(touch) scene:sound(\"wood\", { volume = math.min(1, touch.speed / 5) }) "
       "end)\n"
       "scene:on(\"key\", \"x\", function() scene:sound(\"blip\", { pitch = 2 }) end)"},
      {"open", guard<scene_open>, "file: string, parameters?: table", "",
       "Opens another scene of the scene's folder, or the same again, once the step is done, with values of its "
       "parameters as --set gives them. Without a window the run ends there, and the log tells it.",
       "local score = scene:param(\"score\", 0)\n"
       "scene:on(\"key\", \"n\", function() scene:open(\"level2.lua\", { score = score + 1 }) end)"},
  };
}

Type make() {
  Type type = type_with(fields::scene_type());
  const std::vector<Field> of_script = show_settings();
  type.fields.insert(type.fields.begin(), of_script.begin(), of_script.end());
  type.fields.push_back({"hands", "Hand[]", "", "the mouse, fingers, sticks, and scripted hands", read_hands, nullptr});
  type.fields.push_back({"draw", "Draw", "", "draws over the scene for one frame",
                         [](const Self& s) { push_one(s, Kind::draw); }, nullptr});
  const auto once = [&](const char* name, const char* of, const char* doc, void (*read)(const Self&)) {
    type.fields.push_back({name, of, "", doc, read, nullptr});
  };
  once("keys", "HeldKeys", "keys that are held", [](const Self& s) { push_one(s, Kind::held_keys); });
  once("pad", "Gamepad", "sticks and buttons of a gamepad", [](const Self& s) { push_one(s, Kind::gamepad); });
  once("mouse", "Mouse", "where the pointer is, and what of it is held",
       [](const Self& s) { push_one(s, Kind::mouse); });
  for (const auto& methods :
       {making(), touch_methods(), constraining(), forcing(), choreographing(), telling(), playing()})
    type.methods.insert(type.methods.end(), methods.begin(), methods.end());
  add_base(type, any_scene_type());
  type.methods.insert(type.methods.end(), any_scene_type().methods.begin(), any_scene_type().methods.end());
  return type;
}

}  // namespace

void push_store(lua_State* state, Script& script) {
  const void* key = &script.keys[kind_count + 1];
  if (lua_rawgetp(state, LUA_REGISTRYINDEX, key) != LUA_TNIL) return;
  lua_pop(state, 1);
  lua_newtable(state);
  lua_pushvalue(state, -1);
  lua_rawsetp(state, LUA_REGISTRYINDEX, key);
}

void open_globals(lua_State* state, Script& script) {
  push_ref(state, make_ref(script, Kind::scene, 1, 1, 1));
  lua_setglobal(state, "scene");
  let_box_be_called(state, guard<scene_box>);
  open_structures(state, script);
  open_shapes(state, script);
}

const Type& scene_type() {
  static const Type type = make();
  return type;
}

}  // namespace pantin::lua
