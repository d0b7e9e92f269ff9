// Annotations that are not made from the tables of the bindings: values, results and free functions.
#include "lua/meta/annotations.hpp"

namespace pantin::lua {

const char* const annotations_head = R"(---@meta
-- Written by `pantin meta` from the tables of the bindings; do not edit. In brackets: units.

---A vector; it does not change. Of `a * s` and `s * a` either may be the number.
---@class vec
---@field x number [its own]
---@field y number [its own]
---@field z number [its own]
---@operator add(vec): vec
---@operator sub(vec): vec
---@operator unm: vec
---@operator mul(number): vec
---@operator div(number): vec
local vec_methods = {}
---Sum of products of components.
---```lua
---local along = p.velocity:dot(vec(1, 0, 0))
---```
---@param other vec [its own]
---@return number
function vec_methods:dot(other) end
---Across both, by the right-hand rule.
---```lua
---local up = vec(0, 0, 1):cross(vec(1, 0, 0))
---```
---@param other vec [its own]
---@return vec
function vec_methods:cross(other) end
---Its length, in its own unit.
---```lua
---local distance = (p.position - q.position):length()
---```
---@return number
function vec_methods:length() end
---Of the same direction and of length 1.
---```lua
---local direction = (p.position - q.position):normalized()
---```
---@return vec
function vec_methods:normalized() end

---A rotation; it does not change. Of `a * b` b is done first.
---@class quat
---@field w number [1] cosine of half the angle
---@field x number [1]
---@field y number [1]
---@field z number [1]
---@operator mul(quat): quat
local quat_methods = {}
---A vector, turned.
---```lua
---local nose = block.orientation:rotate(vec(1, 0, 0))
---```
---@param v vec [its own]
---@return vec
function quat_methods:rotate(v) end
---The rotation back.
---```lua
---local back = block.orientation:inverse()
---```
---@return quat
function quat_methods:inverse() end

---@alias color string|number[] "#rgb", "#rrggbb", "#rrggbbaa" or { r, g, b, a } of 0 to 1; with an a below 1 it is seen through
---@alias Picture string|PictureOptions a file, which is once on each face, or a file and its width
---@alias Look "ball"|"glow"|"streak" a ball, a soft disc of light, or a line of light along the velocity
---@alias Curve<T> T|fun(age: number, life: number): T a value, or a function of age and lifetime [s]
---@alias Moment "step"|"press"|"release"|"key"|"key_up"|"grab"|"drop"|"cut"|"broke"|"joined"|"removed"|"touched"|"parted" at which scene:on calls
---@alias Waiting fun(what?: number|fun(): boolean) for a time [s], until something holds, or for the next step

---Where a shape of a body, or a solid particle, touches another.
---@class Contact
---@field with? Body|Particle|Collider whose shape it is, or that stands in the world; nil: it is gone
---@field at vec [m] where they touch
---@field normal vec [1] away from the other
---@field force vec [N] on this thing, the mean over the last step, or over its last sub-step where it had several
---@field depth number [m] by which they overlap; below 0: apart
---@field slip vec [m/s] with which its surface slides on the other's, that of belts included
---@field sensor boolean whether one of the two is a sensor, which pushes nothing
---@field heat? number [J] what friction and impact took of the two in the last step, at all their contacts; nil until scene.contact_heat is read

---What scene:on tells of two that touch; of two that part, a and b alone.
---@class Touch
---@field a Particle|Body|Collider the one that the filter names, else a particle or body; `class` says which it is
---@field b Particle|Body|Collider the other
---@field at vec [m] where, the mean by impulse
---@field normal vec [1] from b to a
---@field impulse number [N s] along the normal, in the step in which they touched; of a sensor 0
---@field speed number [m/s] with which they neared each other at its start
---@field heat? number [J] what friction and impact took of them in it; nil until scene.contact_heat is read

--- What friction and impact took of two that touch, or, without a and b, of all of whom one was removed.
---@class ContactHeat
---@field a? Body
---@field b? Body|Collider a body, or what stands in the world
---@field heat number [J] since scene.contact_heat was read first; below 0: a moving surface gave. All together are what the ledger's line `contact` lost since then

---What a ray, a shape or a position meets.
---@class Hit
---@field body? Body whose shape it is; nil: the world's
---@field shape Collider
---@field at vec [m] where it is met; of an overlap on the shape that was given, where it is deepest
---@field normal? vec [1] out of what is met; against the direction of a ray that begins in it; nil of what a position is in
---@field distance? number [m] along the way; of an overlap below 0: as deep as it is; nil of what a position is in

---@class Energy
---@field kinetic number [J] of motion
---@field potential number [J] of gravity and of laws with energy
---@field total number [J] their sum

---@class Accuracy
---@field penetration number [m] deepest overlap of shapes that touch, at the end of the last step
---@field hinge_gap number [m] largest distance between points of a hinge, and of nails and follows without max_force
---@field constraint number [m] the same with rods
---@field energy number [1] change that no work explains, relative to the largest kinetic energy so far
---@field worst_penetration number [m]
---@field worst_hinge_gap number [m]
---@field worst_constraint number [m]
---@field worst_energy number [1]

---@class Ledger
---@field laws table<string, number> [J] given to the motion by each law with energy
---@field without_energy string[] names of the laws at work that have no energy
---@field open number [J] work of those of them that do not depend on velocities
---@field hand number [J] by hands, follows, moving anchors and lengths, and pushes on what is tied
---@field motor number [J] by motors, and turns and angles that follow a function of time
---@field limit number [J] by limits, and by all that ties what strikes one
---@field contact number [J] by friction, restitution and moving surfaces, where shapes touch
---@field push_out number [J] by moving apart what overlaps
---@field event number [J] by kicks, and pushes on what is loose
---@field edit number [J] by things made and changed
---@field merge number [J] lost by what became one body
---@field emitter number [J] by particles that emitters made
---@field removal number [J] by things removed
---@field damper number [J] by laws that depend on velocities (dampers, drag, wind, thermostats) but for those that do no work by it, as v × B, and what springs swallow that are solved at the end of the step
---@field law_edit number [J] by laws made, changed and removed, and attributes that follow an age
---@field sleep number [J] that things still had which fell asleep
---@field projection number [J] taken by the projection of velocities, since it is kept
---@field energy_return number [J] given back of that
---@field fallback_step number [J] taken by fallback steps, since it is kept
---@field integrator number [J] that the integrators euler and rk4, and the steps of trees of hinges, gave by being inexact, since it is kept
---@field unsolved number [J] of forces on what the iteration left open within its tolerance, since it is kept
---@field since number? [s] when all began to be kept; nil, and so the fields below: not yet
---@field gravity number? [J] given to the motion since then
---@field closure number? [1] what no line explains of the kinetic energy, relative to all lines: a test of the program
---@field truncation table<string, number>? [J] error of the steps for each law and gravity: change of its energy, and what it gave; of laws without energy, together: what they gave beyond a second estimate along the way

---@class Stats
---@field steps integer done so far
---@field articulates integer there are now
---@field asleep integer of them, and of bodies that touch, which rest until something moves them
---@field newton_iterations integer of all articulates
---@field worst_iterations integer that one step took
---@field solves integer of systems of linear equations
---@field factorisations integer of their matrices
---@field halved_steps integer that could not be solved, and were done in two
---@field fallback_steps integer that nothing solved
---@field rejected_steps integer steps that were done again with more sub-steps, as `scene.accuracy` wants
---@field missed_accuracy number [as scene.accuracy] largest error where not even the most sub-steps gave what `scene.accuracy` wants; 0 where none was missed
---@field projections integer of velocities
---@field evaluations integer of the rates of what is a tree of hinges, where scene.accuracy or "adaptive" moves it as one
---@field contacts integer of shapes, in the last step
---@field contact_islands integer of what touches, with what ties it, in the last step
---@field contact_iterations integer of all of them
---@field unsolved_islands integer times that impulses were left that miss the law of friction
---@field gains_taken_back number [J] that contacts gave, which only take, and that was taken back by slowing down what they act on: no energy error tells it
---@field sub_steps integer of the whole scene in its last step, as `scene.accuracy` wants
---@field most_sub_steps integer the most of any body or articulate, those of the scene included
---@field most_sub_steps_of string that body, or the first of that articulate; "" where all take as many
---@field ns table<string, number> [ns] per phase

---@class LogLine
---@field time number [s] of the scene
---@field kind string "notice", "warning", "dropped" …
---@field text string what happened

---@class TimelineEntry
---@field kind "at"|"every"|"over"|"when"|"play"
---@field state "waiting"|"fired"|"dropped"|"cancelled"
---@field time? number [s] when it ended, or is due next; nil of what waits for something that holds
---@field from? number [s] of an over
---@field to? number [s] of an over
---@field period? number [s] of an every
---@field fired integer how often so far
---@field label string where it was set
---@field target? string what it is done to

)";

const char* const annotations_tail = R"(---@type Scene
scene = nil

---A vector.
---```lua
---local up = vec(0, 1, 0)
---```
---@param x number [its own]
---@param y number [its own]
---@param z number [its own]
---@return vec
function vec(x, y, z) end

---A rotation about an axis, by the right-hand rule.
---```lua
---block.orientation = quat(vec(0, 0, 1), math.pi / 2)
---```
---@param axis vec [1]
---@param angle number [rad]
---@return quat
function quat(axis, angle) end

---Reads numbers of a file in the scene's folder.
---```lua
---for _, row in ipairs(read_table "track.csv") do scene:particle { at = vec(row.x, row[2], 0) } end
---```
---@param file string
---@return table[] rows by column number and by column name
function read_table(file) end

---What a test expects of a value; where it is not so, the test fails.
---@class Expectation
local Expectation = {}
---Of numbers their difference, of vecs their distance is at most the tolerance.
---```lua
---expect(opened.time):near(0, 1e-12)
---```
---@param value number|vec [its own]
---@param tolerance number [its own]
function Expectation:near(value, tolerance) end
---Less than a number.
---```lua
---expect(opened.error.worst_energy):below(1e-6)
---```
---@param value number [its own]
function Expectation:below(value) end
---More than a number.
---```lua
---expect(opened.energy.kinetic):above(-1)
---```
---@param value number [its own]
function Expectation:above(value) end
---Equal by Lua's ==.
---```lua
---expect(#opened.bodies):equal(1)
---```
---@param value any
function Expectation:equal(value) end
---True, and not only something that is not false.
---```lua
---expect(opened:find("block").alive):is_true()
---```
function Expectation:is_true() end
---The function that was given raises an error with this text in it.
---```lua
---expect(function() opened:read("heihgt") end):fails("Did you mean 'height'?")
---```
---@param text string
function Expectation:fails(text) end

---A test of a file that `pantin test` runs.
---```lua
---test("the scene begins at rest", function()
---  expect(open_text "scene:particle {}".momentum):near(vec(0, 0, 0), 0)
---end)
---```
---@param name string
---@param body function
function test(name, body) end
---What is expected of a value.
---```lua
---expect(opened.time):equal(0)
---```
---@param value any
---@return Expectation
function expect(value) end
---Opens a scene of a file: of `scripts` or of the test's folder.
---```lua
---local chain = open("scenes/chain.lua", { links = 3, ["scene.step"] = 1 / 120 })
---local again = open("scenes/chain.lua", nil, { best = 12 })
---```
---@param path string
---@param params? table<string, any> of the scene, as `--set` (default `{}`)
---@param saved? table<string, number|boolean|string>|Saved what `scene.saved` begins with; `saved` of another opened scene is then of both, as of two plays (default `{}`)
---@return OpenedScene
function open(path, params, saved) end
---Opens a scene of a text.
---```lua
---local falling = open_text [[ scene:particle { name = "stone" } ]]
---falling:advance(1)
---expect(falling:find("stone").velocity.y):near(-9.81, 1e-9)
---```
---@param source string
---@param params? table<string, any> of the scene, as `--set` (default `{}`)
---@param saved? table<string, number|boolean|string>|Saved as of `open`
---@return OpenedScene
function open_text(source, params, saved) end
)";

}  // namespace pantin::lua
