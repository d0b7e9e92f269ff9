// `scene`: the table of all that it can do.
#include "edit/edit.hpp"
#include "lua/arguments.hpp"
#include "lua/assemble.hpp"
#include "lua/body_options.hpp"
#include "lua/build_options.hpp"
#include "lua/choreography.hpp"
#include "lua/couple_options.hpp"
#include "lua/emitter_options.hpp"
#include "lua/events.hpp"
#include "lua/family_options.hpp"
#include "lua/fields.hpp"
#include "lua/force_element_options.hpp"
#include "lua/guard.hpp"
#include "lua/look_options.hpp"
#include "lua/measures.hpp"
#include "lua/parameters.hpp"
#include "lua/scene_settings.hpp"
#include "lua/script.hpp"
#include "lua/snapshot.hpp"
#include "lua/structure_type.hpp"
#include "lua/targets.hpp"
#include "lua/tie_options.hpp"

namespace pantin::lua {
namespace {

int scene_particle(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "particle");
  ParticleDef def;
  std::vector<std::string> known = {"at", "velocity", "mass", "radius", "color", "look", "lifetime", "name"};
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
  push_thing(state, self.script, add_body(self.world, body_def(state, 2)));
  return 1;
}

int scene_group(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "group");
  push_thing(state, self.script, add_group(self.world, check_text(state, 2, "group", "argument 1, the name,")));
  return 1;
}

int scene_result(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "result");
  const std::string name = check_text(state, 2, "result", "argument 1, the name,");
  Value value;
  switch (lua_type(state, 3)) {
    case LUA_TNUMBER: value = check_number(state, 3, "result", "argument 2, the value,", ""); break;
    case LUA_TBOOLEAN: value = lua_toboolean(state, 3) != 0; break;
    default: value = check_text(state, 3, "result", "argument 2, the value,");
  }
  self.script.results.insert_or_assign(name, std::move(value));
  return 0;
}

int scene_finish(lua_State* state) {
  check_self(state, Kind::scene, "finish").script.finished = true;
  return 0;
}

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
       "Makes a free particle of one point."},
      {"body", guard<scene_body>, "options: BodyOptions", "Body", "Makes a rigid body."},
      {"hinge", guard<scene_hinge>, "a: Point|Particle, b: Point|Particle, ...: Point|Particle|HingeOptions",
       "Particle", "Joins points of two or more bodies, or free particles, into one particle."},
      {"nail", guard<scene_nail>, "point: Point|Particle, at?: vec|TieOptions [m], options?: TieOptions", "Nail",
       "Keeps a point at a place, or where it is."},
      {"follow", guard<scene_follow>,
       "point: Point|Particle, target: vec|Hand|fun(t: number): vec, options?: FollowOptions", "Follow",
       "Keeps a point to a target: a place [m], a function of time [s] or a hand."},
      {"rod", guard<scene_rod>,
       "a: Point|Particle|vec, b: Point|Particle|vec, length?: number|fun(t: number): number [m]", "Rod",
       "Keeps two points, or a point and a place, at a distance, or at their present one."},
      {"weld", guard<scene_weld>, "a: Body, b: Body, options?: ConstraintOptions", "Weld",
       "Keeps two bodies in their present relative place and orientation; it tells its load, and may break."},
      {"orient", guard<scene_orient>, "body: Body, to?: quat|fun(t: number): quat, options?: OrientOptions", "Orient",
       "Keeps the orientation of a body, or its present one."},
      {"align", guard<scene_align>,
       "a: Body, axis_a: vec, b: Body|vec, axis_b?: vec|AlignOptions, options?: AlignOptions", "Align",
       "Keeps the angle between an axis of a and one of b, each in its body's frame; without b, one of the world."},
      {"motor", guard<scene_motor>, "a: Body, b: Body|MotorOptions, options?: MotorOptions", "Motor",
       "Turns a about an axis (world axes) against b, or without b against the world."},
      {"limit", guard<scene_limit>,
       "a: Body|Point|Particle, b: Body|Point|Particle|vec|LimitOptions, options?: LimitOptions", "Limit",
       "Keeps the angle of a against b about an axis, 0 where it is now, or the distance of two points, in a range."},
      {"on_plane", guard<scene_on_plane>, "point: Point|Particle, options?: PlaneOptions", "OnPlane",
       "Keeps a point on a plane."},
      {"string", guard<scene_string>, "points: (Point|Particle|vec)[], options?: StringOptions", "String",
       "Is at most so long along its points and places, slides through the inner ones, and may go slack."},
      {"on_path", guard<scene_on_path>, "point: Point|Particle, path: vec[], options?: PathOptions", "OnPath",
       "Keeps a point on a path through places [m]; at the end of an open one it stops."},
      {"join", guard<scene_join>, "a: Point|Particle, b: Point|Particle, options?: JoinOptions", "Join",
       "Draws two points together, at a place or on their way to each other, and makes the hinge when they are within "
       "a tenth of scene.tolerance of their size, some 20 time constants later. Without at, momentum is kept on the "
       "way, and so is angular momentum: they come together on a straight line, and what that takes goes into the "
       "turning of all that hangs on them. Two free particles alone have nothing to turn, and lose theirs."},
      {"merge", guard<scene_merge>, "a: Body, b: Body", "Body",
       "a lives on with b's points, which stay valid; b is gone."},
      {"split", guard<scene_split>, "body: Body, points: Point|Point[], ...: Point", "Body",
       "Makes a body of its own of some of a body's points."},
      {"freeze", guard<scene_freeze>, "group: Group", "Body",
       "Makes one body of the free particles and the bodies of a group."},
      {"shatter", guard<scene_shatter>, "body: Body", "Particle[]",
       "Makes free particles of a body's points; those without mass are gone."},
      {"connect_within", guard<scene_connect_within>,
       "group: Group, distance: number [m], law: Law, options?: ConnectOptions", "Connection[]",
       "Ties the particles of a group that are nearer than a distance and not tied yet."},
      {"group", guard<scene_group>, "name: string", "Group", "Makes a named set of things."},
      {"family", guard<scene_family>, "name: string, options?: FamilyOptions", "Family",
       "Makes a family of particles, with named numeric attributes."},
      {"connect", guard<scene_connect>,
       "a: Point|Particle|vec|table, b: Point|Particle|vec|Law, law?: Law, options?: ConnectOptions", "Connection",
       "Ties two particles by a law; or a list of two, three or four."},
      {"bonding", guard<scene_bonding>, "options: BondingOptions", "Event",
       "Breaks what ties the particles of families above a temperature; below one ties what is near, or joins it to "
       "hinges."},
      {"interact", guard<scene_interact>, "a: Family, b: Family, law: Law", "Interaction",
       "A law between all pairs of two families, or within one."},
      {"field", guard<scene_field>, "target: Family|Group|Scene, law: Law", "Field",
       "A law on each particle of a family, of a group or of the scene."},
      {"emitter", guard<scene_emitter>, "options: EmitterOptions", "Emitter", "Makes particles at a rate."},
      {"build", guard<scene_build>, "structure: Structure, options: BuildOptions", "Group",
       "Makes a structure real; the group has its parts in the structure's order."},
      {"find", guard<scene_find>, "name: string", "Thing?", "The oldest living thing of that name."},
      {"near", guard<scene_near>, "at: vec [m], radius: number [m]", "Particle[]",
       "Particles within a radius, nearest first."},
      {"hand", guard<scene_hand>, "options?: { path: fun(t: number): vec }", "Hand",
       "Makes a hand; with a path, place [m] of time [s], it moves by itself."},
  };
}

std::vector<Method> telling() {
  return {
      {"param", guard<scene_param>, "name: string, default: any, options?: ParamOptions", "any",
       "Declares a parameter and returns its value."},
      {"at", guard<scene_at>, "time: number [s], target_or_action: Thing|function, action?: function", "Event",
       "Does it once, at the beginning of the first step whose time is not before it: never early. A run that ends at "
       "that time does not do it."},
      {"after", guard<scene_after>, "delay: number [s], target_or_action: Thing|function, action?: function", "Event",
       "Does it once, a while from now, by the rule of at."},
      {"every", guard<scene_every>, "period: number [s], target_or_action: Thing|function, action?: function", "Event",
       "Does it again and again, at period, 2 period, … from now on, by the rule of at."},
      {"over", guard<scene_over>,
       "from: number [s], to: number [s], target_or_action: Thing|fun(u: number), action?: fun(u: number, target: "
       "Thing)",
       "Event",
       "Does it at the beginning of each step from one time to another, with u from 0 to 1; with 1 for sure, and "
       "last."},
      {"when", guard<scene_when>,
       "condition: Condition|fun(): boolean, target_or_action: Thing|function, action?: function|WhenOptions, "
       "options?: WhenOptions",
       "Event", "Does it at the beginning of the first step at which something holds."},
      {"play", guard<scene_play>,
       "target_or_script: Thing|fun(wait: Waiting), script?: fun(wait: Waiting, target: Thing)", "Event",
       "A script that waits: wait(2) [s] by the rule of at, wait(function() … end), wait() for the next step."},
      {"on", guard<scene_on>, "moment: string, key_or_action: string|function, action?: function", "Subscription",
       "Calls a function at each \"step\" (dt), \"press\" \"release\" (hand), \"key\" (name), \"grab\" \"drop\" "
       "(point, hand), "
       "\"cut\" \"joined\" (hinge), \"broke\" (connection, constraint or hinge, force [N] or torque [N m], story), "
       "\"removed\" (thing, "
       "story). on(\"key\", \"x\", action) takes that key from the window, whatever that does with it; without a name, "
       "keys are heard that the window has no use for."},
      {"behave", guard<scene_behave>, "target: Thing|Scene, behaviour: Behaviour, options?: table", "Subscription",
       "Puts a behaviour to work on a target, with which it ends."},
      {"button", guard<scene_button>, "name: string, action: function", "", "Puts a button in the window."},
      {"probe", guard<scene_probe>, "name: string, read: fun(): number", "", "Records a number each step."},
      {"result", guard<scene_result>, "name: string, value: number|boolean|string", "",
       "Puts a value into the summary."},
      {"finish", guard<scene_finish>, "", "", "Ends the run."},
      {"snapshot", guard<scene_snapshot>, "", "Snapshot",
       "The present state, kept in memory. Taking it changes nothing of the run."},
      {"restore", guard<scene_restore>, "snapshot: Snapshot", "",
       "Goes back to a snapshot once the step is done. Things, events and handlers are those of then, and handles of "
       "them "
       "are theirs again; what was made since is gone. An error while a play goes on."},
      {"reset", guard<scene_reset>, "", "", "Goes back to the start of the first step, as restore does."},
  };
}

Type make() {
  Type type{"Scene", "scene", "The scene that is being run.", {}, {}};
  type.fields = show_settings();
  for (const auto& list : {engine_settings(), scene_measures()})
    type.fields.insert(type.fields.end(), list.begin(), list.end());
  type.fields.push_back({"hands", "Hand[]", "", "the mouse, fingers, sticks, and scripted hands", read_hands, nullptr});
  type.fields.push_back({"draw", "Draw", "", "draws over the scene for one frame",
                         [](const Self& s) {
                           push_ref(s.state, {Tag::ref, Kind::draw, 1, 1, 1, &s.script});
                         },
                         nullptr});
  type.methods = making();
  const std::vector<Method> more = telling();
  type.methods.insert(type.methods.end(), more.begin(), more.end());
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

void open_scene(lua_State* state, Script& script) {
  push_ref(state, {Tag::ref, Kind::scene, 1, 1, 1, &script});
  lua_setglobal(state, "scene");
  open_structures(state, script);
}

const Type& scene_type() {
  static const Type type = make();
  return type;
}

}  // namespace pantin::lua
