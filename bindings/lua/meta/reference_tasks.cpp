// What the reference begins with: tasks, and what its examples have.
#include "lua/meta/reference.hpp"

#include <algorithm>
#include <string_view>

#include "lua/thing/constraint_options.hpp"

namespace pantin::lua {

const char* const example_scene = R"(local p = scene:particle { at = vec(-2, 1, 0), name = "p" }
local q = scene:particle { at = vec(0, 1.5, 0), name = "q" }
local ions = scene:family("ions", { attributes = { charge = 1 } })
local ion = scene:particle { at = vec(1, 2, 1), family = ions, name = "ion" }
local arm = scene:body { mass = 1, inertia = vec(0.1, 0.1, 0.1), at = vec(3, 0, 0), name = "arm",
                         points = { head = vec(-1, 0, 0), tail = vec(1, 0, 0) } }
local leg = scene:body { mass = 1, inertia = vec(0.1, 0.1, 0.1), at = vec(5, 0, 0), name = "leg",
                         points = { head = vec(-1, 0, 0), tail = vec(1, 0, 0) } }
local elbow = scene:hinge(arm.tail, leg.head, { name = "elbow" })
local block = scene:build(structure.cube(), { as = "rigid", at = vec(0, 5, 0) }).bodies[1]
local group = scene:group("all"):add(p, q, ion, arm, leg)
local spring = force.spring { stiffness = 100 }
)";

const char* const example_test = R"(local opened = open_text [[
  scene:build(structure.cube(), { as = "rigid", at = vec(0, 1, 0) }).bodies[1].name = "block"
  scene:probe("height", function() return scene:find("block").position.y end)
  scene:result("answer", 42)
]]
)";

namespace {

constexpr std::string_view of_constraints = "Tie them";

const std::vector<ReferenceTasks> all = {
    {"Make things",
     {{"a free particle", {"Scene:particle", "ParticleOptions"}},
      {"a rigid body", {"Scene:body", "BodyOptions", "Body:add_point"}},
      {"a body that touches others", {"Scene:ball", "Scene:box", "Scene:block", "Scene:capsule", "Scene:cylinder"}},
      {"what things rest on", {"Scene:floor", "Scene:ground"}},
      {"particles of a kind, with attributes of their own", {"Scene:family", "FamilyOptions"}},
      {"particles at a rate, as of a fountain", {"Scene:emitter", "EmitterOptions"}},
      {"many things from a shape, a lattice or a molecule", {"Scene:build", "BuildOptions", "structure"}},
      {"a named set of things", {"Scene:group", "Group:add"}},
      {"how they look", {"LookOptions", "Look", "color", "Curve"}},
      {"pictures on them, or instead of them", {"Picture", "Sprite"}},
      {"positions and rotations", {"vec", "quat"}}}},
    {of_constraints.data(),
     {{"points of bodies to one position, free to turn", {"Scene:hinge", "HingeOptions"}},
      {"what breaks under load", {"Breaking", "AnyConstraint.breaks_at"}}}},
    {"Forces",
     {{"weight", {"Scene.gravity"}},
      {"springs and other laws between given particles", {"Scene:connect", "Scene:connect_within", "force.spring"}},
      {"laws between all pairs", {"Scene:interact", "force.lennard_jones", "force.coulomb", "force.gravitation"}},
      {"laws on single particles: drag, wind, walls", {"Scene:field", "force.drag", "force.wind", "force.wall"}},
      {"laws of one's own", {"force.pair", "force.point", "force.many", "where", "noise"}},
      {"heat", {"force.thermostat", "Group:heat", "Scene.boltzmann"}},
      {"bonds that melt and freeze", {"Scene:bonding"}},
      {"a push, a kick or a twist", {"Body:push", "Body:kick", "Body:twist", "Particle:push"}}}},
    {"Time and events",
     {{"at a time, after a while, again and again", {"Scene:at", "Scene:after", "Scene:every"}},
      {"little by little from one time to another", {"Scene:over"}},
      {"as soon as something holds", {"Scene:when", "Condition"}},
      {"one thing after the other", {"Scene:play"}},
      {"when something happens, and in each step", {"Scene:on"}},
      {"a script that belongs to a thing", {"Scene:behave", "Behaviour"}},
      {"not after all", {"Event:cancel", "Subscription:cancel"}},
      {"the end of the run", {"Scene:finish", "Scene.duration"}}}},
    {"Measure",
     {{"where things are and how they move", {"Particle", "Body", "Point"}},
      {"energy, momentum and temperature", {"AnyScene.energy", "AnyScene.momentum", "AnySet.temperature"}},
      {"forces in hinges, constraints and connections", {"Particle:force", "Nail.force", "Connection.force"}},
      {"a number of each step, and results of the run", {"Scene:probe", "Scene:result"}},
      {"errors, and where energy went", {"AnyScene.error", "AnyScene.ledger", "AnyScene.stats", "AnyScene.hash"}},
      {"what is near, and what has a name", {"AnyScene:near", "AnyScene:find", "Group:clusters"}},
      {"measured data from a file", {"read_table"}}}},
    {"Play and draw",
     {{"grab things by script", {"Scene:hand", "Hand:grab", "Hand:release"}},
      {"buttons, keys and parameters", {"Scene:button", "Scene:on", "Scene:param", "Keys"}},
      {"keys that are held, and gamepads", {"Scene.keys", "HeldKeys", "Scene.pad", "Gamepad"}},
      {"where the pointer is, and its buttons", {"Scene.mouse", "Mouse"}},
      {"sounds", {"Scene:sound", "Scene.contact_sounds"}},
      {"the next level, and a score that lasts", {"Scene:open", "Scene.saved", "Saved"}},
      {"the camera, the title, the pace and a dark ground",
       {"Scene.camera", "Camera", "Scene.title", "Scene.pace", "Scene.dark"}},
      {"lines, arrows and text over the scene", {"Draw:line", "Draw:arrow", "Draw:text", "Draw:point"}}}},
    {"Change a scene while it runs",
     {{"cut and remove", {"Particle:cut", "Group:cut_hinges", "Group:break_connections", "AnyThing:remove"}},
      {"make one body of several, or several of one", {"Scene:merge", "Scene:freeze", "Scene:split", "Scene:shatter"}},
      {"switch on and off", {"AnyConstraint.enabled", "AnyForceElement.enabled", "Emitter.enabled"}},
      {"change a law's parameters", {"AnyForceElement.parameters"}},
      {"keep a state and go back to it",
       {"Scene:snapshot", "Scene:restore", "Scene:reset", "Scene:rewind", "Scene.history", "Scene.store"}},
      {"go on in another process", {"Scene:save"}}}},
    {"Settings",
     {{"the step, or the accuracy that is wanted", {"Scene.step", "Scene.accuracy", "Scene.accuracy_per"}},
      {"how steps are taken", {"Scene.integrator", "Scene.energy_return", "Scene.tolerance"}},
      {"a plane, or a periodic box", {"Scene.plane", "Scene.box"}},
      {"random numbers", {"Scene.seed"}}}},
    {"Shapes that touch",
     {{"round ones and boxes", {"shape.ball", "shape.box", "shape.capsule", "shape.cylinder"}},
      {"any convex one", {"shape.hull", "shape.polygon"}},
      {"what does not move", {"shape.plane", "shape.mesh", "shape.heights", "shape.line"}},
      {"a body of one or several", {"BodyOptions", "Shape:move", "Shape:rotate"}},
      {"friction and restitution", {"MaterialOptions", "Body.friction", "Body.restitution"}},
      {"which ones touch, and with which friction", {"Scene:collide", "MaterialOptions", "HingeOptions"}},
      {"where it touches, and how hard", {"Body.contacts", "Contact"}},
      {"what friction takes, and of whom", {"AnyScene.contact_heat", "ContactHeat"}},
      {"how contacts are solved", {"Scene.contact"}},
      {"when it begins and ends to touch", {"Scene:on", "Touch"}},
      {"what is in the way, and what is where",
       {"AnyScene:ray", "AnyScene:cast", "AnyScene:overlap", "AnyScene:inside"}}}},
    {"Structures",
     {{"regular shapes", {"structure.cube", "structure.prism", "structure.polygon", "structure.geodesic"}},
      {"lines, sheets and rings", {"structure.rod", "structure.sheet", "structure.ring"}},
      {"lattices, mechanisms and molecules",
       {"structure.lattice", "structure.rotating_squares", "structure.reentrant", "structure.molecule",
        "structure.mesh"}},
      {"one's own", {"structure.new"}},
      {"change them", {"Structure:scale", "Structure:move", "Structure:rotate", "Structure:join", "Structure:select"}},
      {"make them real", {"Scene:build"}}}},
    {"Write tests",
     {{"a test", {"test"}},
      {"open a scene and let it run", {"open", "open_text", "OpenedScene:advance", "OpenedScene:step"}},
      {"read its probes and results", {"OpenedScene:read", "OpenedScene:result"}},
      {"hold keys, press buttons, point", {"OpenedScene:hold", "OpenedScene:press", "OpenedScene:mouse"}},
      {"what it keeps for the next time, and opens next", {"OpenedScene.saved", "OpenedScene.next"}},
      {"expect something", {"expect", "Expectation:near", "Expectation:below", "Expectation:fails"}}}},
};

/// With the calls that make constraints, before what is said of all.
std::vector<ReferenceTasks> with_constraints(std::vector<ReferenceTasks> titles) {
  std::vector<ReferenceTask>& tasks = std::find_if(titles.begin(), titles.end(), [](const ReferenceTasks& t) {
                                        return t.title == of_constraints;
                                      })->tasks;
  for (const ConstraintCall* call : constraint_calls()) {
    auto task = std::find_if(tasks.begin(), tasks.end(),
                             [&](const ReferenceTask& t) { return call->wanted == std::string_view(t.wanted); });
    if (task == tasks.end()) task = tasks.insert(tasks.end() - 1, {call->wanted, {}});
    task->entries.push_back(text("Scene:", call->method.name));
    if (*call->further) task->entries.push_back(call->further);
  }
  return titles;
}

}  // namespace

const std::vector<ReferenceTasks>& reference_tasks() {
  static const std::vector<ReferenceTasks> tasks = with_constraints(all);
  return tasks;
}

}  // namespace pantin::lua
