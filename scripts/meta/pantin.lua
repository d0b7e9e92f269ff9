---@meta
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

---@alias Thing Point|Particle|Body|Nail|Follow|Rod|Weld|Orient|Align|Motor|Limit|OnPlane|String|OnPath|Join|Gear|Rack|Pulley|Screw|Slider|Group|Family|Connection|Interaction|Field|Emitter|Collider

---What every thing has; it may be a target of events and behaviours, and a member of a group.
---@class AnyThing
---@field name string what messages and scene:find call it (default `""`)
---@field alive boolean whether it still exists (read only)
---@field data table a table of yours, which goes with the thing, and is there still while its end is told (default `{}`) (read only)
---@field class string what it is, as it is called here: `if touch.b.class == "Collider" then … end` (read only)
local AnyThing = {}
---Takes it out of the world.
---```lua
---scene:after(2, function() p:remove() end)
---```
function AnyThing:remove() end

---What every constraint has.
---@class AnyConstraint: AnyThing
---@field breaks_at Breaking load or length at which it breaks, within a step where it passes that; of a blow or a push that is far too much it bears nothing; a weld's torque is about the middle between the two centres of mass (default `{}`)
---@field enabled boolean whether it acts (default `true`)
local AnyConstraint = {}

---What every connection, interaction and field has.
---@class AnyForceElement: AnyThing
---@field parameters table<string, number> [each its own] of its law: read and written by name (read only)
---@field energy number? [J] of its law now; nil where the law has none (read only)
---@field enabled boolean whether it acts (default `true`)
local AnyForceElement = {}

---What groups and families tell of their things.
---@class AnySet: AnyThing
---@field energy Energy [J] of its things (read only)
---@field momentum vec [kg m/s] sum over its things (read only)
---@field angular_momentum vec [kg m²/s] sum over its things about the world's origin (read only)
---@field temperature number [K] of its things, relative to their common motion; in J while scene.boltzmann is 1 (read only)
---@field mass number [kg] sum over its things (read only)
local AnySet = {}

---What a scene tells of itself: to its script, and to a test that opened it.
---@class AnyScene
---@field time number [s] simulated time (read only)
---@field energy Energy [J] of all things (read only)
---@field momentum vec [kg m/s] sum over all things (read only)
---@field angular_momentum vec [kg m²/s] sum over all things about the world's origin (read only)
---@field temperature number [K] relative to the common motion; in J while scene.boltzmann is 1 (read only)
---@field error Accuracy what is left open now, and the worst since the start (read only)
---@field ledger Ledger [J] where energy came from and went since the start; the first reading has all of it kept from the next step on (read only)
---@field contact_heat ContactHeat[] what friction and impact took, by who touches; the first reading has it kept from the next step on (read only)
---@field stats Stats counts since the start, and ns per phase (read only)
---@field log LogLine[] all that was logged (read only)
---@field timeline TimelineEntry[] events that ended, then those that wait: the latest and the next 1000 (read only)
---@field bodies Body[] all bodies, in the order of making (read only)
---@field particles Particle[] all particles that are no hinges, and do not sleep in one (read only)
---@field hash string 16 hexadecimal digits that all positions and velocities make: equal states have equal ones (read only)
---@field hinges Particle[] all hinges (read only)
---@field connections Connection[] all connections, in the order of making (read only)
local AnyScene = {}
---The oldest living thing of that name; or the living one of that number, by which messages call what has no name, as "body 11": all kinds of things are counted together, in the order of making.
---```lua
---local found = scene:find("all")
---```
---@param name string|integer
---@return Thing?
function AnyScene:find(name) end
---Particles within a radius, nearest first.
---```lua
---for _, other in ipairs(scene:near(p.position, 0.5)) do other:remove() end
---```
---@param at vec [m]
---@param radius number [m]
---@return Particle[]
function AnyScene:near(at, radius) end
---Where a ray first meets each shape, nearest first. One that begins in a shape meets it at once.
---```lua
---local hits = scene:ray { from = p.position, direction = vec(0, -1, 0) }
---if hits[1] then print(hits[1].distance, hits[1].body) end
---```
---@param options RayOptions
---@return Hit[]
function AnyScene:ray(options) end
---Where a convex shape that moves straight, without turning, first touches each other, nearest first.
---```lua
---local hits = scene:cast(shape.ball(0.3), p.position, p.position + vec(0, -5, 0), { ignore = block })
---```
---@param shape Shape
---@param from vec [m]
---@param to vec [m]
---@param filter? HitFilter
---@return Hit[]
function AnyScene:cast(shape, from, to, filter) end
---What overlaps a convex shape at a position, the deepest first.
---```lua
---if #scene:overlap(shape.box(1, 1, 1), vec(0, 3, 0)) == 0 then scene:box { size = 1, at = vec(0, 3, 0) } end
---```
---@param shape Shape
---@param at vec [m]
---@param filter? HitFilter
---@return Hit[]
function AnyScene:overlap(shape, at, filter) end
---What a position is inside of, the oldest first. A mesh has no inside.
---```lua
---for _, hit in ipairs(scene:inside(p.position)) do print(hit.body) end
---```
---@param at vec [m]
---@param filter? HitFilter
---@return Hit[]
function AnyScene:inside(at, filter) end

---A point mass. It belongs to at most one body, and always to one particle.
---@class Point: AnyThing
---@field position vec [m] position in the world; written only where the point is free
---@field velocity vec [m/s] velocity in the world; written only where the point is free
---@field mass number [kg] mass; 0 only in a body, as an anchor
---@field color color of the point
---@field radius number [m] drawn size; 0: the window chooses
---@field body Body? the body it belongs to, or nil (read only)
---@field particle Particle the particle it is in now: its own, or a hinge (read only)
local Point = {}
---Pulls for the coming step.
---```lua
---scene:on("step", function() arm.head:push(vec(0, 10, 0)) end)
---```
---@param force vec [N]
function Point:push(force) end
---Changes the velocity at once. What ties take of that is in no force of theirs, and breaks none: a push does.
---```lua
---arm.head:kick(vec(0, 0.5, 0))
---```
---@param impulse vec [N s]
function Point:kick(impulse) end

---A ring of one or more points. One point: an ordinary particle. More: a hinge, whose points coincide.
---@class Particle: AnyThing
---@field position vec [m] position in the world; written only of a free particle
---@field velocity vec [m/s] velocity in the world; written only of a free particle
---@field mass number [kg] mass; of a hinge its points' sum, which is not written
---@field family Family? its family, whose attributes are fields of it: p.charge
---@field lifetime number [s] goes at the beginning of the first step at which its age has reached this; a hinge is cut; math.huge: never
---@field contacts Contact[] where it touches shapes and others, if its family is solid (read only)
---@field age number [s] time since it was made (read only)
---@field color color|fun(age: number, life: number): color or a function of age and lifetime [s]; overrides its points'
---@field radius number|fun(age: number, life: number): number [m] or a function of age and lifetime [s]; overrides its points'
---@field look Look "ball", "glow" (a soft disc of light) or "streak" (a line of light along its velocity)
---@field points Point[] its points, in the order of joining (read only)
---@field bodies Body[] the bodies of its points (read only)
---@field enabled boolean of a hinge: whether its points stay together (default `true`)
---@field collide boolean of a hinge: whether its bodies touch each other (default `false`)
---@field breaks_at Breaking of a hinge: load at which it breaks (default `{}`)
---@field is_hinge boolean whether it joins two points or more (read only)
---@field [string] number [each its own] attributes of its family
local Particle = {}
---Pulls for the coming step.
---```lua
---scene:on("step", function() p:push(vec(0, 10, 0)) end)
---```
---@param force vec [N]
function Particle:push(force) end
---Changes the velocity at once. What ties take of that is in no force of theirs, and breaks none: a push does.
---```lua
---p:kick(vec(0, 0.5, 0))
---```
---@param impulse vec [N s]
function Particle:kick(impulse) end
---Frees all members of a hinge, or those of one body.
---```lua
---elbow:cut()
---```
---@param body? Body
function Particle:cut(body) end
---Force [N] of a hinge on one of its bodies in the last step.
---```lua
---scene:probe("pull", function() return elbow:force(arm):length() end)
---```
---@param body Body
---@return vec
function Particle:force(body) end

---Points at fixed relative positions: rigid. Its named points are fields: link.head.
---@class Body: AnyThing
---@field position vec [m] position of the centre of mass; what it is hinged to stays where it is, and the next step draws both together: `Group:move` moves all of it
---@field velocity vec [m/s] velocity of the centre of mass
---@field origin vec [m] position of its frame's origin
---@field orientation quat turns its frame to the world
---@field spin vec [rad/s] angular velocity, world axes
---@field momentum vec [kg m/s] mass times velocity (read only)
---@field angular_momentum vec [kg m²/s] about its centre of mass, world axes (read only)
---@field mass number [kg] its points' and its own
---@field inertia vec|Inertia [kg m²] its points' and its own about the frame's origin, in the frame's axes: vec of the diagonal, or a table. Tied, a body moves with no principal moment below 1e-4 of the largest, and a warning says so
---@field points Point[] its points, in the order of making (read only)
---@field hinges Particle[] the hinges that its points are in (read only)
---@field color color color of its first shape, or point; writing gives it to all
---@field friction number? [1] of its first shape, nil without one; writing gives it to all
---@field restitution number? [1] of its first shape, nil without one; writing gives it to all
---@field layer string? of its first shape, nil without one; writing gives it to all
---@field colliders Collider[] its shapes, in the order of making (read only)
---@field contacts Contact[] where its shapes touch others, after the last step (read only)
---@field picture Picture? of its first shape; writing gives it to all
---@field sprite Sprite? drawn instead of its shapes and points; nil: those
---@field [string] Point its named points
local Body = {}
---Pulls for the coming step, at its centre of mass or at a position of the world.
---```lua
---scene:on("step", function() block:push(vec(0, 20, 0), block.points[1].position) end)
---```
---@param force vec [N]
---@param at? vec [m]
function Body:push(force, at) end
---Changes the velocity at once, at its centre of mass or at a position of the world. What ties take of that is in no force of theirs, and breaks none: a push does.
---```lua
---block:kick(vec(0, 2, 0))
---```
---@param impulse vec [N s]
---@param at? vec [m]
function Body:kick(impulse, at) end
---Turns for the coming step.
---```lua
---scene:on("step", function() block:twist(vec(0, 0, 0.5)) end)
---```
---@param torque vec [N m]
function Body:twist(torque) end
---Adds a point at a position in its frame.
---```lua
---local handle = block:add_point { at = vec(0, 1, 0), mass = 0.2, name = "handle" }
---```
---@param point vec|AddPointOptions [m]
---@return Point
function Body:add_point(point) end
---Takes a point off.
---```lua
---block:remove_point(block.points[8])
---```
---@param point Point
function Body:remove_point(point) end

---Keeps a point at a position of the world.
---@class Nail: AnyConstraint
---@field point Point the point that it holds (read only)
---@field at vec [m] the position; the point is drawn to a new one
---@field force vec [N] what it exerted on its first point in the last step (read only)
local Nail = {}

---Keeps a point to a moving target; with max_force as a spring and damper of its time_constant, and never harder: a weight hangs g time_constant^2 lower.
---@class Follow: AnyConstraint
---@field point Point the point that it holds (read only)
---@field target vec [m] where the target is; written as a vec or a function of time [s]
---@field max_force number [N] never pulls harder; math.huge: no limit
---@field force vec [N] what it exerted on its first point in the last step (read only)
local Follow = {}

---Keeps two points, or a point and a position, at a distance.
---@class Rod: AnyConstraint
---@field a Point its first point (read only)
---@field b Point? its second point, or nil where that end is a position (read only)
---@field at vec [m] position of its second end; written where no point is there
---@field length number [m] the distance that it keeps; written as a number or a function of time [s]
---@field force number [N] tension in the last step, > 0 when it pulls (read only)
local Rod = {}

---Keeps two bodies in their relative position and orientation.
---@class Weld: AnyConstraint
---@field a Body its first body (read only)
---@field b Body? its second body, or nil for the world (read only)
---@field force vec [N] what it exerted on its first point in the last step (read only)
---@field torque vec [N m] what it exerted on its first body in the last step; a weld's is about the middle between the centres of mass (read only)
local Weld = {}

---Keeps the orientation of a body.
---@class Orient: AnyConstraint
---@field a Body its first body (read only)
---@field to quat the orientation; written as a quat or a function of time [s]; the body is drawn to a new one
---@field torque vec [N m] what it exerted on its first body in the last step; a weld's is about the middle between the centres of mass (read only)
local Orient = {}

---Keeps the angle between an axis of a body and one of another.
---@class Align: AnyConstraint
---@field a Body its first body (read only)
---@field b Body? its second body, or nil for the world (read only)
---@field angle number [rad] the angle, 0 to π; written as a number or a function of time [s]
---@field torque vec [N m] what it exerted on its first body in the last step; a weld's is about the middle between the centres of mass (read only)
local Align = {}

---Turns a body about an axis, against another or the world.
---@class Motor: AnyConstraint
---@field a Body its first body (read only)
---@field b Body? its second body, or nil for the world (read only)
---@field speed number [rad/s] of a against b, where it keeps that; a number or a function of time [s]; a step, or a sub-step, turns by 2 atan(speed step / 2), as it turns what spins freely
---@field angle number [rad] that it keeps, where it does; a number or a function of time [s]
---@field turned number [rad] the angle of a against b now, turns counted (read only)
---@field max_torque number [N m] never pushes harder; math.huge: no limit
---@field torque vec [N m] what it exerted on its first body in the last step; a weld's is about the middle between the centres of mass (read only)
local Motor = {}

---Keeps an angle about an axis, or a distance, in a range.
---@class Limit: AnyConstraint
---@field min number [rad or m] least angle or distance; -math.huge: none
---@field max number [rad or m] greatest angle or distance; math.huge: none
---@field value number [rad or m] the angle or distance now (read only)
---@field force vec [N] what it exerted on its first point in the last step (read only)
---@field torque vec [N m] what it exerted on its first body in the last step; a weld's is about the middle between the centres of mass (read only)
local Limit = {}

---Keeps a point on a plane.
---@class OnPlane: AnyConstraint
---@field point Point the point that it holds (read only)
---@field through vec [m] a position on the plane; the point is drawn to a new one
---@field normal vec [1] across the plane, of unit length
---@field force vec [N] what it exerted on its first point in the last step (read only)
local OnPlane = {}

---Is at most so long along its points; slides through the inner ones.
---@class String: AnyConstraint
---@field points (Point|vec)[] [m] what it goes through: points, or positions (read only)
---@field length number [m] the most that it is long; written as a number or a function of time [s]. One that is written longer becomes so evenly in the step after
---@field taken number [m] how long its way is now: less than its length where it is slack (read only)
---@field force number [N] tension in the last step, 0 where it is slack (read only)
local String = {}

---Keeps a point on a path.
---@class OnPath: AnyConstraint
---@field point Point the point that it holds (read only)
---@field path vec[] [m] the positions that the path goes through (read only)
---@field along number [1] where on the path the point is: 0 at the first position, 1 at the second, and so on; of a closed path it goes on counting beyond the last, and back below 0, round after round (read only)
---@field force vec [N] what it exerted on its first point in the last step (read only)
local OnPath = {}

---Draws two points together, to join them into a hinge.
---@class Join: AnyConstraint
---@field a Point the first point (read only)
---@field b Point the second point (read only)
---@field max_force number [N] it never pulls harder; math.huge: no limit (read only)
---@field force vec [N] what it exerted on its first point in the last step (read only)
local Join = {}

---Turns one body `ratio` times as far as another.
---@class Gear: AnyConstraint
---@field a Body its first body (read only)
---@field b Body its second body (read only)
---@field carrier Body? against which it turns, or nil for the world (read only)
---@field ratio number [1] turns of a for one of b, in the sense of their axes; below 0 they turn against each other, as wheels do that mesh from outside; written as a number or a function of time [s], the wheels mesh anew
---@field turned number [rad] the angle of a against the carrier, since it was made, turns counted (read only)
---@field torque vec [N m] what it exerted on its first body in the last step; a weld's is about the middle between the centres of mass (read only)
local Gear = {}

---Moves a point along a line as far as the rim of a wheel turns.
---@class Rack: AnyConstraint
---@field wheel Body the body that turns (read only)
---@field point Point the point that moves (read only)
---@field carrier Body? against which it turns, or nil for the world (read only)
---@field radius number [m] how far the point moves for a turn of 1 rad; written as a number or a function of time [s], the teeth mesh anew
---@field turned number [rad] the angle of the wheel against the carrier, since it was made, turns counted (read only)
---@field force vec [N] what it exerted on its first point in the last step (read only)
---@field torque vec [N m] what it exerted on its first body in the last step; a weld's is about the middle between the centres of mass (read only)
local Rack = {}

---A rope over two anchors, at most so long; one side may count several times, as in a tackle.
---@class Pulley: AnyConstraint
---@field a Point the point at its first end (read only)
---@field b Point the point at its second end (read only)
---@field ratio number [1] how many times the second side counts, > 0; written as a number, after which a rope that is too short attracts what it ties, or as a function of time [s], with which its length goes
---@field length number [m] the most that a's side and ratio times b's add up to; one that is too short attracts what it ties
---@field force number [N] tension of a's side in the last step, 0 where it is slack (read only)
local Pulley = {}

---Moves one point along an axis of another's body by `lead` for each turn of its own body about it. How far it is along the axis counts, on both sides; something else must keep it on the axis, such as a guide or a hinge.
---@class Screw: AnyConstraint
---@field a Point its first point (read only)
---@field b Point its second point (read only)
---@field lead number [m] by which a goes along the axis in a turn of its body about it; written as a number or a function of time [s], the thread begins anew
---@field turned number [rad] the angle of the first body against the second, since it was made, turns counted (read only)
---@field force vec [N] what it exerted on its first point in the last step (read only)
---@field torque vec [N m] what it exerted on its first body in the last step; a weld's is about the middle between the centres of mass (read only)
local Screw = {}

---Keeps a point on a line that goes with a body, or stays in the world.
---@class Slider: AnyConstraint
---@field point Point the point that slides (read only)
---@field carrier Body? along which it slides, or nil for the world (read only)
---@field slid number [m] how far it is along the axis now; 0 where it was made (read only)
---@field length number [m] how far along the axis it is kept, or of one that slides freely is; written as a number or a function of time [s] it is kept there from then on, and drawn to where that is
---@field min number [m] least way along the axis; -math.huge: none
---@field max number [m] greatest way along the axis; math.huge: none
---@field force vec [N] what it exerted on its first point in the last step (read only)
---@field torque vec [N m] what it exerted on its first body in the last step; a weld's is about the middle between the centres of mass (read only)
local Slider = {}

---A named set of things. It is gone when no member lives.
---@class Group: AnySet
---@field particles Particle[] its particles, in the order of adding; of a built structure one for each vertex (read only)
---@field bodies Body[] its bodies, in the order of adding (read only)
---@field hinges Particle[] those of its particles that are hinges (read only)
---@field connections Connection[] its connections, in the order of adding (read only)
local Group = {}
---Adds things; returns the group.
---```lua
---scene:group("a pair"):add(p, q)
---```
---@param thing Thing
---@param ... Thing
---@return Group
function Group:add(thing, ...) end
---Takes things out of the set; without any, ends the set.
---```lua
---group:remove(p)
---```
---@param thing? Thing
---@param ... Thing
function Group:remove(thing, ...) end
---For loops: for thing in g:each() do … end. Goes over a copy and leaves out what died.
---```lua
---for thing in group:each() do thing.data.found = true end
---```
---@return fun(): Thing?
function Group:each() end
---Cuts the hinges in the group and those between its bodies, of the groups in it, too.
---```lua
---scene:at(1, function() group:cut_hinges() end)
---```
function Group:cut_hinges() end
---Removes the connections in the group and those among its things.
---```lua
---scene:connect(p, q, spring)
---group:break_connections()
---```
function Group:break_connections() end
---Adds kinetic energy relative to the common motion; a negative one cools. What moves goes on faster or slower; what rests gets random velocities, of which the next step takes what ties forbid (in the ledger's `edit`): heat again for the rest.
---```lua
---group:heat(5)
---```
---@param energy number [J]
function Group:heat(energy) end
---Moves its bodies and particles as one, hinges and all; `turn` turns them about their centre of mass first, with their velocities. Returns the group.
---```lua
---group:move(vec(0, 2, 0), quat(vec(0, 1, 0), math.pi))
---```
---@param by vec [m]
---@param turn? quat
---@return Group
function Group:move(by, turn) end
---Lower and upper corner [m] of the box round all its points; nil where it has none.
---```lua
---local lower, upper = group:bounds()
---```
---@return vec?
---@return vec?
function Group:bounds() end
---Lists of what is within the distance of another member, biggest first.
---```lua
---local biggest = group:clusters(2)[1]
---```
---@param distance number [m]
---@return Thing[][]
function Group:clusters(distance) end

---Particles of a kind, with named numeric attributes that laws read.
---@class Family: AnySet
---@field attributes table<string, number> [each its own] values of a particle that gives none (read only)
---@field particles Particle[] its living particles, in the order of making (read only)
---@field solid boolean whether its free particles touch shapes and each other, as balls of their radius that do not turn (read only)
---@field friction number? [1] of what is solid, else nil
---@field restitution number? [1] 0 … 1, of what is solid, else nil
---@field layer string? of what is solid, see scene:collide
---@field sprite Sprite? drawn instead of its free particles; nil: as their look says
local Family = {}

---Ties two, three or four particles by a law.
---@class Connection: AnyForceElement
---@field particles (Particle|vec)[] [m] what it ties: particles, or positions (read only)
---@field force number [N] tension in the last step, positive where it pulls; 0 of a law of three or four (read only)
---@field breaks_at Breaking tension or length at which it breaks (default `{}`)
local Connection = {}

---A law between all pairs of two families, or within one.
---@class Interaction: AnyForceElement
local Interaction = {}

---A law on each particle of a family, of a group or of the scene.
---@class Field: AnyForceElement
local Field = {}

---Makes particles at a rate.
---@class Emitter: AnyThing
---@field at vec|vec[]|Point|Particle [m] where particles begin: a position, a box { vec, vec }, or a point that carries it
---@field rate number|fun(t: number): number [1/s] particles per second; read: of the last step
---@field velocity vec [m/s] relative to the point that carries it
---@field spread number [rad] half angle of the cone of velocities
---@field lifetime number|{ min: number, max: number } [s] of its particles, or between which it is random
---@field max number [1] particles of it that may live at once
---@field enabled boolean whether it makes particles
---@field family Family? of its particles (read only)
---@field count integer how many of its particles live (read only)
---@field made integer how many it has made (read only)
local Emitter = {}

---A shape in use: of a body, or standing in the world, as a floor.
---@class Collider: AnyThing
---@field body Body? whose it is; nil: it stands in the world (read only)
---@field position vec [m] of its origin, in the world (read only)
---@field friction number [1] of two that touch the root of the product counts (default `0.5`)
---@field restitution number [1] 0 to 1; of two that touch the larger counts (default `0`)
---@field rolling number [m] moment by normal force against rolling; of two that touch the larger counts (default `0`)
---@field spinning number [m] moment by normal force against spinning on the spot; of two that touch the larger counts (default `0`)
---@field surface_velocity vec [m/s] of its surface against its body, as of a belt; along the axes of the body, with which it turns, or of the world for what stands in it (default `vec(0, 0, 0)`)
---@field layer string? that scene:collide speaks of; nil: none
---@field sensor boolean tells what it touches, and pushes nothing (default `false`)
---@field size number? [m] of a plane: across which it is drawn, though it has no end; nil: as far as is seen
---@field color color how it is drawn
---@field picture Picture? that is drawn on it, times its color; nil: the color alone
local Collider = {}

---Something set to happen.
---@class Event
---@field state string "waiting", "fired", "dropped" or "cancelled" (read only)
local Event = {}
---Takes it out of the choreography; one that fired stays as it is.
---```lua
---local alarm = scene:at(5, function() print("late") end)
---alarm:cancel()
---```
function Event:cancel() end

---What can grab: the mouse, a finger, a stick, a script's.
---@class Hand
---@field position vec [m] position in the world (read only)
---@field velocity vec [m/s] velocity over the last step (read only)
---@field pressed boolean whether its button is down (read only)
local Hand = {}
---Takes hold of a point; lets go of what it held.
---```lua
---local hand = scene:hand { path = function(t) return vec(-2 + t, 1, 0) end }
---hand:grab(p, { max_force = 20 })
---```
---@param point Point|Particle
---@param options? GrabOptions
function Hand:grab(point, options) end
---Lets go.
---```lua
---local hand = scene:hand()
---scene:at(1, function() hand:release() end)
---```
function Hand:release() end

---A function that scene:on calls, or a behaviour.
---@class Subscription
local Subscription = {}
---The function is called no more; a behaviour is stopped.
---```lua
---local listening = scene:on("step", function(dt) print(dt) end)
---listening:cancel()
---```
function Subscription:cancel() end

---Vertices, edges and faces: a value, which does not change.
---@class Structure
---@field vertices vec[] [m] positions (read only)
---@field edges integer[][] pairs of numbers of vertices (read only)
---@field faces integer[][] lists of numbers of vertices, counter-clockwise seen from outside (read only)
---@field elements string[] chemical element of each vertex of a molecule; else empty (read only)
---@field euler integer vertices - edges + faces (read only)
---@field area number? [m²] of all faces; nil without any (read only)
---@field volume number? [m³] inside of a closed surface; nil of another (read only)
local Structure = {}
---Times larger, alike or along each axis.
---```lua
---local slab = structure.cube():scale(vec(4, 0.2, 1))
---```
---@param factor number|vec [1]
---@return Structure
function Structure:scale(factor) end
---Turned about the origin.
---```lua
---local tip = structure.cube():rotate(quat(vec(1, 0, 0), math.pi / 4))
---```
---@param turn quat
---@return Structure
function Structure:rotate(turn) end
---Moved.
---```lua
---local above = structure.cube():move(vec(0, 2, 0))
---```
---@param by vec [m]
---@return Structure
function Structure:move(by) end
---Mirror image in a plane, through the origin unless given.
---```lua
---local left = structure.prism { sides = 3 }:mirror(vec(1, 0, 0))
---```
---@param normal vec [1]
---@param through? vec [m]
---@return Structure
function Structure:mirror(normal, through) end
---Both as one: vertices of the other within the tolerance (1e-6) of one of this become that one.
---```lua
---local tower = structure.cube():join(structure.cube():move(vec(0, 1, 0)))
---```
---@param other Structure
---@param tolerance? number [m]
---@return Structure
function Structure:join(other, tolerance) end
---Each edge halved: triangles become four, other faces quadrilaterals.
---```lua
---local finer = structure.octahedron():subdivide()
---```
---@return Structure
function Structure:subdivide() end
---A vertex for each face, a face for each inner vertex.
---```lua
---local cube = structure.octahedron():dual()
---```
---@return Structure
function Structure:dual() end
---Each vertex of a closed surface cut off at a fraction of its edges.
---```lua
---local football = structure.icosahedron():truncate(1 / 3)
---```
---@param fraction number [1]
---@return Structure
function Structure:truncate(fraction) end
---What is made of the parts for which keep is true, and their numbers; keep is given the vertex' position, both ends of the edge or the middle of the face [m], then the number.
---```lua
---local upper, numbers = structure.geodesic():select("vertices", function(at, number) return at.y > 0 end)
---```
---@param part "vertices"|"edges"|"faces"
---@param keep function
---@return Structure
---@return integer[]
function Structure:select(part, keep) end
---Inertia [kg m²] of 1 kg, in its points unless given, about its centre of mass, and that centre [m].
---```lua
---local inertia, centre = structure.cube():inertia("solid")
---```
---@param mass_in? "points"|"edges"|"faces"|"solid"
---@return vec|Inertia
---@return vec
function Structure:inertia(mass_in) end

---What touches, and what it is made of: a value, which does not change.
---@class Shape
---@field kind string "ball", "box", "capsule" …, as it was made (read only)
---@field volume number? [m³] inside it; nil of a plane, a mesh and heights (read only)
---@field mass number? [kg] of its volume filled with its density; nil without a volume (read only)
---@field centre vec? [m] its centre of mass in the frame of its body; nil without a volume (read only)
---@field density number [kg/m³] of a body whose mass is not given (read only)
---@field friction number [1] of two that touch the root of the product counts (read only)
---@field restitution number [1] 0 to 1; of two that touch the larger counts (read only)
---@field rolling number [m] moment by normal force against rolling; of two that touch the larger counts (read only)
---@field spinning number [m] moment by normal force against spinning on the spot; of two that touch the larger counts (read only)
---@field layer string? that scene:collide speaks of; nil: that of its body, or none (read only)
---@field sensor boolean tells what it touches, and pushes nothing (read only)
---@field surface_velocity vec [m/s] of its surface against its body, as of a belt; along the axes of the body, with which it turns, or of the world for what stands in it (read only)
local Shape = {}
---Moved in the frame of its body.
---```lua
---local head = shape.box(1, 1, 1):move(vec(0, 2, 0))
---```
---@param by vec [m]
---@return Shape
function Shape:move(by) end
---Turned about the origin of its body's frame.
---```lua
---local log = shape.cylinder(0.2, 3):rotate(quat(vec(0, 0, 1), math.pi / 2))
---```
---@param turn quat
---@return Shape
function Shape:rotate(turn) end

---Draws over the scene what is shown until the next step: call it in each step. On the screen (space = "screen") x and y are in px from the upper left corner, negative ones from the right or lower edge. The window's title and bar are over the upper 45 px, its tools and status line over the lower 120 px, and scene:button begins at the left below the title.
---@class Draw
local Draw = {}
---A line.
---```lua
---scene:on("step", function() scene.draw:line(p.position, q.position, { color = "#f00", width = 3 }) end)
---```
---@param from vec [m]
---@param to vec [m]
---@param options? LineOptions
function Draw:line(from, to, options) end
---An arrow to a position.
---```lua
---scene:on("step", function() scene.draw:arrow(p.position, p.position + p.velocity) end)
---```
---@param from vec [m]
---@param to vec [m]
---@param options? LineOptions
function Draw:arrow(from, to, options) end
---Text whose upper left corner is at a position; \n begins a new line.
---```lua
---scene:on("step", function() scene.draw:text(vec(10, 10, 0), "t = " .. scene.time, { space = "screen" }) end)
---```
---@param at vec [m]
---@param text string
---@param options? MarkOptions
function Draw:text(at, text, options) end
---A dot.
---```lua
---scene:on("step", function() scene.draw:point(vec(0, 1, 0), { size = 12 }) end)
---```
---@param at vec [m]
---@param options? MarkOptions
function Draw:point(at, options) end

---What keys are held, by their names: `scene.keys.left`, `scene.keys.a`, `scene.keys.left_shift`. A key that a script reads is the scene's and not the window's from then on, so read it once where the file begins if that matters; Esc never is. Without a window none is held, unless a test or a recording holds it.
---@class HeldKeys
---@field [string] boolean whether this key is held
local HeldKeys = {}

---What is held of a gamepad: `left_x left_y right_x right_y` (-1 to 1, right and up > 0), `left_trigger right_trigger` (0 to 1); `a b x y left_shoulder right_shoulder left_stick right_stick start back up down left right` (true while held). Of several gamepads that which is pressed most counts, and with none all is at rest. What a script reads is the scene's: a stick of which it reads an axis is no hand. When one is pressed `scene:on("key", "pad.a", f)` tells.
---@class Gamepad
---@field [string] number|boolean [1] of an axis or a button
local Gamepad = {}

---The pointer: the mouse, or a finger, which is its left button: `if scene.mouse.left_pressed then scene:ball { radius = 0.2, at = scene.mouse.position } end`. A button that a script reads is the scene's and not the window's from then on: with the left one no hand takes hold, with the right one the view does not turn, and with the wheel it does not zoom. To know where the pointer is takes nothing from the window. Without a window there is none, unless a test or a recording has one.
---@class Mouse
---@field position vec? [m] the place that it points at: in the scene's plane, else in that through what the camera looks at, facing it; nil where there is no pointer (read only)
---@field left boolean whether it is down (read only)
---@field left_pressed boolean whether it went down in this step (read only)
---@field left_released boolean whether it went up in this step (read only)
---@field middle boolean whether it is down (read only)
---@field middle_pressed boolean whether it went down in this step (read only)
---@field middle_released boolean whether it went up in this step (read only)
---@field right boolean whether it is down (read only)
---@field right_pressed boolean whether it went down in this step (read only)
---@field right_released boolean whether it went up in this step (read only)
---@field wheel number [1] notches that it was turned in this step, up > 0 (read only)
local Mouse = {}

---Where the scene is seen from. A script may give it all at once, `scene.camera = { at = …, look_at = … }`, or change one of these at any time: the camera then goes where they say, in the time of `ease`, and between such changes it is whoever watches who moves it.
---@class Camera
---@field at vec? [m] where it is (default from where all is seen, as where it would be at `look_at`)
---@field look_at vec? [m] what is in the middle (default the middle of all)
---@field follow Thing? what it goes along with (default none); with `ease` it has it in the middle
---@field zoom number? [1] how many times larger all is seen than from there (default `1`)
---@field ease number? [s] in which it comes nearer by a factor of e to where it is to be (default `0`: at once)
local Camera = {}

---What lasts from one play of a scene to the next: `scene.saved.best = 12`. Numbers, booleans and strings, by names; nil takes one away, and what is not there is nil; a whole number is an integer again. The window keeps them in a file for each scene, in `pantin/saved` of `XDG_DATA_HOME` (or `~/.local/share`). Without a window they begin empty and end with the run. Restore, reset, rewind and undo leave them.
---@class Saved
---@field [string] number|boolean|string|nil [its own] a value of yours
local Saved = {}

---A state of the scene, to which scene:restore goes back: the world, scene.store and the data of things; not what a script keeps in its variables.
---@class Snapshot
---@field time number [s] of the scene when it was taken (read only)
local Snapshot = {}

---The scene that is being run.
---@class Scene: AnyScene
---@field title string what the window and the pictures are called (default the file's name)
---@field duration number? [s] end of a headless run (default none, which ends after 10 s)
---@field pace number [1] simulated s per real s (default `1`)
---@field history number [s] for how long the states of all steps are kept, for `scene:rewind` (default `0`, none)
---@field camera Camera where the scene is seen from (default from where all is seen)
---@field dark boolean whether it is shown on a dark ground, as what glows wants it (default `false`)
---@field saved Saved plain values of yours, which last from one play to the next (read only)
---@field contact_sounds boolean|string whether what touches is heard, as hard as it strikes: as its density says (wood, rubber, glass or metal) where it is true, else as the sound of this name (default `false`)
---@field store table plain values of yours, which snapshots keep (default `{}`)
---@field gravity vec [m/s²] uniform acceleration (default `vec(0, -9.81, 0)`)
---@field step number [s] length of one step (default `1 / 240`)
---@field accuracy number? [1/s] wanted error per second, relative to the distance between what interacts, or to how far it swings beside a uniform motion where it interacts with nothing; sub-steps follow from it, and what is a tree of hinges moves as with "adaptive". Functions of time that ties follow are then asked at each quarter of a step; round sharp corners of paths errors fall only as fast as sub-steps (default none: fixed steps)
---@field accuracy_per string whether `accuracy` is that of a "second" or of a "step", as where a scene lasts microseconds (default `"second"`)
---@field integrator string "verlet" (2nd order), "implicit" (the same with connections of any stiffness), "suzuki4" (4th order, where nothing dissipates), "rk4" (4th order, no constraints), "euler" (1st order, semi-implicit; free particles as with "verlet"), "adaptive" ("verlet", but what is a tree of hinges and nails under gravity alone moves in its own rotations, of 8th order, to `accuracy`, or to 1e-6 where none is wanted) (default `"verlet"`)
---@field energy_return boolean give back what the velocity projection took (default `true`)
---@field contact string how what touches is solved: "exact" by Newton's search, however long it takes, "fast" by sweeps alone, which leave slips and loads unfinished, "auto" by the size and the motion of an island (default `"auto"`)
---@field box vec? [m] edges of the periodic box, through whose sides laws reach, but not what touches (default none: open space)
---@field plane string? "xy", "xz" or "yz": everything stays in that plane, and forces across it do nothing; set it before things are made (default none: in space)
---@field tolerance number [1] points of a new hinge may be this far apart, relative to the size of their bodies with their shapes; of points without bodies to the largest coordinate (default `1e-6`)
---@field seed integer of math.random (default `1`)
---@field boltzmann number [J/K] k_B; temperature is in J while it is 1 (default `1`)
---@field hands Hand[] the mouse, fingers, sticks, and scripted hands (read only)
---@field draw Draw draws over the scene for one frame (read only)
---@field keys HeldKeys keys that are held (read only)
---@field pad Gamepad sticks and buttons of a gamepad (read only)
---@field mouse Mouse where the pointer is, and what of it is held (read only)
local Scene = {}
---Makes a free particle of one point.
---```lua
---local drop = scene:particle { at = vec(0, 2, 0), velocity = vec(1, 0, 0), mass = 0.1, color = "#4af" }
---```
---@param options? ParticleOptions
---@return Particle
function Scene:particle(options) end
---Makes a rigid body.
---```lua
---local rod = scene:body { at = vec(0, 3, 0),
---  points = { left = { at = vec(-1, 0, 0), mass = 1 }, right = { at = vec(1, 0, 0), mass = 1 } } }
---```
---@param options BodyOptions
---@return Body
function Scene:body(options) end
---Makes a rigid body that is a ball, which touches.
---```lua
---local ball = scene:ball { radius = 0.2, at = vec(0, 2, 0), velocity = vec(3, 0, 0), restitution = 0.7 }
---```
---@param options BallOptions
---@return Body
function Scene:ball(options) end
---Makes a rigid body that is a box, which touches.
---```lua
---local crate = scene:box { size = vec(1, 1, 1), at = vec(0, 3, 0), density = 300, friction = 0.4 }
---local pictured = scene:box { size = 1, at = vec(2, 3, 0), picture = "crate.png" }
---```
---@param options BoxOptions
---@return Body
function Scene:box(options) end
---The same as scene:box.
---```lua
---local brick = scene:block { size = vec(0.2, 0.1, 0.1), at = vec(0, 4, 0) }
---```
---@param options BoxOptions
---@return Body
function Scene:block(options) end
---Makes a rigid body that is a cylinder with round ends, which touches.
---```lua
---local pill = scene:capsule { radius = 0.2, length = 0.5, at = vec(0, 2, 0) }
---```
---@param options CapsuleOptions
---@return Body
function Scene:capsule(options) end
---Makes a rigid body that is a cylinder, which touches.
---```lua
---local wheel = scene:cylinder { radius = 0.5, length = 0.1, axis = vec(0, 0, 1), at = vec(0, 2, 0) }
---```
---@param options CylinderOptions
---@return Body
function Scene:cylinder(options) end
---a lives on with b's points, which stay valid; b is gone.
---```lua
---local both = scene:merge(arm, block)
---```
---@param a Body
---@param b Body
---@return Body
function Scene:merge(a, b) end
---Makes a body of its own of some of a body's points, or of what of it is in front of a plane. Shapes go with the points that are in them, else with the nearest; a plane cuts them. Parts of a ball, a capsule or a cylinder are hulls with its mass; those of a cylinder cut across are cylinders.
---```lua
---local corner = scene:split(block, block.points[1], block.points[2], block.points[3])
---local top = scene:split(scene:box { size = 1, at = vec(0, 9, 0) }, { through = vec(0, 9, 0), normal = vec(1, 1, 0) })
---```
---@param body Body
---@param points Point|Point[]|CuttingPlane
---@param ... Point
---@return Body
function Scene:split(body, points, ...) end
---Makes one body of the free particles and the bodies of a group.
---```lua
---local lump = scene:freeze(scene:group("to be one"):add(p, q, block))
---```
---@param group Group
---@return Body
function Scene:freeze(group) end
---Makes free particles of a body's points; those without mass are gone. With `pieces`, it breaks a body with shapes into that many bodies, hulls that have its mass and move on as it did.
---```lua
---for _, piece in ipairs(scene:shatter(block)) do piece.color = "#f40" end
---local plate = scene:box { size = vec(2, 0.1, 2), at = vec(0, 9, 0) }
---scene:on("touched", plate, function(touch) scene:shatter(plate, { pieces = 30, at = touch.at }) end)
---```
---@param body Body
---@param options? ShatterOptions
---@return Particle[]|Body[]
function Scene:shatter(body, options) end
---Ties the particles of a group that are nearer than a distance and not tied yet.
---```lua
---scene:connect_within(group, 5, spring, { breaks_at = { length = 8 } })
---```
---@param group Group
---@param distance number [m]
---@param law Law
---@param options? ConnectOptions
---@return Connection[]
function Scene:connect_within(group, distance, law, options) end
---Makes a named set of things.
---```lua
---local pair = scene:group("a pair"):add(p, q)
---```
---@param name string
---@return Group
function Scene:group(name) end
---Makes a family of particles, with named numeric attributes.
---```lua
---local electrons = scene:family("electrons", { attributes = { charge = -1.6e-19 }, mass = 9.1e-31 })
---```
---@param name string
---@param options? FamilyOptions
---@return Family
function Scene:family(name, options) end
---Makes particles at a rate.
---```lua
---local fountain = scene:emitter { at = vec(0, 0, 0), rate = 50, velocity = vec(0, 5, 0), spread = 0.2, lifetime = 2 }
---```
---@param options EmitterOptions
---@return Emitter
function Scene:emitter(options) end
---Makes a structure real; the group has its parts in the structure's order.
---```lua
---local cloth = scene:build(structure.sheet { columns = 4, rows = 4, edge = 0.2 },
---  { as = "deformable", law = spring, mass = 0.5, at = vec(0, 5, 0) })
---```
---@param structure Structure
---@param options BuildOptions
---@return Group
function Scene:build(structure, options) end
---Makes a hand; with a path it moves by itself.
---```lua
---local hand = scene:hand { path = function(t) return vec(-2 + t, 1, 0) end }
---scene:at(0.5, function() hand:grab(p, { max_force = 20 }) end)
---```
---@param options? HandOptions
---@return Hand
function Scene:hand(options) end
---Makes a plane on which things rest, solid below.
---```lua
---local floor = scene:floor { height = -9, friction = 0.8 }
---floor.friction = 0.2
---```
---@param options? FloorOptions
---@return Collider
function Scene:floor(options) end
---Puts shapes into the world, where they stay: things rest on them and strike them. Returns each of them.
---```lua
---local slab = scene:ground { shape = shape.box(10, 1, 10), at = vec(0, -9, 0), color = "#987" }
---```
---@param options GroundOptions
---@return Collider
function Scene:ground(options) end
---Says how shapes of two layers touch, or two of one layer: not at all, with a friction and restitution of their own, or as usual (true). What was said before of the two is forgotten.
---```lua
---scene:collide("car", "ghost", false)
---scene:collide("ice", "rubber", { friction = 0.05, restitution = 0.3 })
---```
---@param a string
---@param b string
---@param how boolean|PairOptions
function Scene:collide(a, b, how) end
---Joins points of two or more bodies, or free particles, into one particle. Bodies that share a hinge pass through each other, unless it says collide = true; each touches everything else: the world, and bodies further along a chain. What shall not touch those either gets a layer, and scene:collide(layer, other, false). Where a point is in a hinge already, the new hinge takes that one's place, with all that it joins: it keeps the name and breaks_at that it is not given anew.
---```lua
---local foot = scene:body { at = leg.tail.position, mass = 1, inertia = vec(1, 1, 1), points = { heel = vec(0, 0, 0) } }
---scene:hinge(leg.tail, foot.heel, { name = "ankle", breaks_at = { force = 1000 } })
---```
---@param a Point|Particle
---@param b Point|Particle
---@param ... Point|Particle|HingeOptions
---@return Particle
function Scene:hinge(a, b, ...) end
---Keeps a point at a position, or where it is.
---```lua
---scene:nail(arm.head)
---scene:nail(p, vec(0, 2, 0), { time_constant = 0.2 })
---```
---@param point Point|Particle
---@param at? vec|TieOptions [m]
---@param options? TieOptions
---@return Nail
function Scene:nail(point, at, options) end
---Keeps a point to a target: a position [m], a function of time [s] or a hand.
---```lua
---scene:follow(p, function(t) return vec(math.cos(t), math.sin(t), 0) end, { max_force = 100 })
---```
---@param point Point|Particle
---@param target vec|Hand|fun(t: number): vec [m]
---@param options? FollowOptions
---@return Follow
function Scene:follow(point, target, options) end
---Keeps two points, or a point and a position, at a distance, or at their present one.
---```lua
---scene:rod(p, q, { name = "strut", breaks_at = { force = 200 } })
---scene:rod(p, vec(-2, 4, 0), function(t) return 3 + 0.1 * math.sin(t) end)
---```
---@param a Point|Particle|vec [m]
---@param b Point|Particle|vec [m]
---@param length? number|fun(t: number): number|ConstraintOptions [m]
---@param options? ConstraintOptions
---@return Rod
function Scene:rod(a, b, length, options) end
---Keeps two bodies in their present relative position and orientation; it tells its load, and may break. The two pass through each other, and touch everything else.
---```lua
---local weld = scene:weld(arm, block, { breaks_at = { force = 500, torque = 100 } })
---```
---@param a Body
---@param b Body
---@param options? ConstraintOptions
---@return Weld
function Scene:weld(a, b, options) end
---Keeps the orientation of a body, or its present one.
---```lua
---scene:orient(block, quat(vec(0, 0, 1), math.pi / 4), { time_constant = 0.5 })
---```
---@param body Body
---@param to? quat|OrientOptions|fun(t: number): quat
---@param options? OrientOptions
---@return Orient
function Scene:orient(body, to, options) end
---Keeps the angle between an axis of a and one of b, each in its body's frame; without b, one of the world.
---```lua
---scene:align(arm, vec(1, 0, 0), block, vec(0, 1, 0))
---scene:align(block, vec(0, 1, 0), vec(0, 1, 0), { angle = 0 })
---```
---@param a Body
---@param axis_a vec [1]
---@param b? Body|vec [1]
---@param axis_b? vec|AlignOptions [1]
---@param options? AlignOptions
---@return Align
function Scene:align(a, axis_a, b, axis_b, options) end
---Turns a about an axis (world axes) against b, or without b against the world.
---```lua
---scene:motor(arm, leg, { axis = vec(0, 0, 1), speed = 2, max_torque = 5 })
---scene:motor(block, { axis = vec(0, 1, 0), angle = function(t) return 0.5 * t end })
---```
---@param a Body
---@param b? Body|MotorOptions
---@param options? MotorOptions
---@return Motor
function Scene:motor(a, b, options) end
---Keeps the angle of a against b about an axis, 0 where it is now, or the distance of two points, in a range.
---```lua
---scene:limit(arm, leg, { axis = vec(0, 0, 1), min = -0.5, max = 0.5 })
---scene:limit(p, q, { length = 3 })
---```
---@param a Body|Point|Particle
---@param b? Body|Point|Particle|vec|LimitOptions [m]
---@param options? LimitOptions
---@return Limit
function Scene:limit(a, b, options) end
---Keeps a point on a plane.
---```lua
---scene:on_plane(p, { through = vec(0, 1, 0), normal = vec(0, 1, 0) })
---```
---@param point Point|Particle
---@param options? PlaneOptions
---@return OnPlane
function Scene:on_plane(point, options) end
---Is at most so long along its points and positions, slides through the inner ones, and may go slack.
---```lua
---local string = scene:string({ p, vec(0, 4, 0), q })
---string.length = 0.9 * string.length
---```
---@param points (Point|Particle|vec)[] [m]
---@param options? StringOptions
---@return String
function Scene:string(points, options) end
---Keeps a point on a path through positions; at the end of an open one it stops.
---```lua
---scene:on_path(p, { p.position, vec(0, 3, 0), vec(2, 3, 0) }, { smooth = true })
---```
---@param point Point|Particle
---@param path vec[] [m]
---@param options? PathOptions
---@return OnPath
function Scene:on_path(point, path, options) end
---Draws two points together, at a position or on their way to each other, and makes the hinge when they are within a tenth of scene.tolerance of their size, some 20 time constants later. Without at, momentum is kept on the way, and so is angular momentum: they come together on a straight line, and what that takes goes into the turning of all that hangs on them. Two free particles alone have nothing to turn, and lose theirs. The two do not touch each other on the way.
---```lua
---scene:join(p, q, { max_force = 50, on_met = function(hinge) print(hinge) end })
---```
---@param a Point|Particle
---@param b Point|Particle
---@param options? JoinOptions
---@return Join
function Scene:join(a, b, options) end
---Turns a `ratio` times as far as b, each about an axis of a carrier or of the world. It keeps neither on its axis: hinges with an axis do.
---```lua
---local gear = scene:gear(arm, block, { ratio = -2, axis = vec(0, 0, 1) })
---gear.ratio = -3
---```
---@param a Body
---@param b Body
---@param options GearOptions
---@return Gear
function Scene:gear(a, b, options) end
---Moves a point along a direction as far as the rim of a wheel turns.
---```lua
---scene:rack(block, p, { radius = 0.5, axis = vec(0, 0, 1), along = vec(1, 0, 0) })
---```
---@param wheel Body
---@param point Point|Particle
---@param options RackOptions
---@return Rack
function Scene:rack(wheel, point, options) end
---A rope from a over two anchors to b, at most so long; as in a tackle b's side may count several times.
---```lua
---scene:pulley(p, vec(0, 5, 0), vec(1, 5, 0), q, { ratio = 2 })
---```
---@param a Point|Particle
---@param over_a Point|Particle|vec [m]
---@param over_b Point|Particle|vec [m]
---@param b Point|Particle
---@param options? PulleyOptions
---@return Pulley
function Scene:pulley(a, over_a, over_b, b, options) end
---Moves a along an axis of b's body by `lead` for each turn of a's body about it.
---```lua
---scene:screw(block.points[1], arm.head, { lead = 0.01, axis = vec(0, 1, 0) })
---```
---@param a Point
---@param b Point
---@param options ScrewOptions
---@return Screw
function Scene:screw(a, b, options) end
---Keeps a point on the line through it along an axis, which goes with a body or, without one, stays in the world. The point's own body does not turn against that, unless it `turns`. The two do not touch.
---```lua
---local slider = scene:slider(block.points[1], arm, { axis = vec(1, 0, 0), min = 0, max = 0.5 })
---scene:slider(p, { axis = vec(0, 1, 0), length = function(t) return 0.1 * math.sin(t) end })
---```
---@param point Point|Particle
---@param carrier? Body|SliderOptions
---@param options? SliderOptions
---@return Slider
function Scene:slider(point, carrier, options) end
---Ties two particles by a law; or a list of two, three or four.
---```lua
---local tie = scene:connect(p, q, spring, { name = "tie", length = 1 })
---scene:connect({ p, q, ion }, force.angle { stiffness = 2 })
---```
---@param a Point|Particle|vec|(Point|Particle|vec)[] [m]
---@param b Point|Particle|vec|Law [m]
---@param law? Law|ConnectOptions
---@param options? ConnectOptions
---@return Connection
function Scene:connect(a, b, law, options) end
---Breaks what ties the particles of families above a temperature; below one ties what is near, or joins it to hinges.
---```lua
---scene:bonding { families = ions, near = 0.2, below = 5, above = 10, law = spring }
---```
---@param options BondingOptions
---@return Event
function Scene:bonding(options) end
---A law between all pairs of two families, or within one.
---```lua
---scene:interact(ions, ions, force.coulomb { constant = 1, cutoff = 5 })
---```
---@param a Family
---@param b Family
---@param law Law
---@return Interaction
function Scene:interact(a, b, law) end
---A law on each particle of a family, of a group or of the scene. Of bodies it acts on their points alone.
---```lua
---scene:field(scene, force.drag { linear = 0.1 })
---scene:field(ions, force.point { force = function(p) return vec(p.charge, 0, 0) end })
---```
---@param target Family|Group|Scene
---@param law Law
---@return Field
function Scene:field(target, law) end
---Declares a parameter and returns its value.
---```lua
---local links = scene:param("links", 8, { min = 1, max = 100, step = 1, help = "how many links" })
---```
---@param name string
---@param default number|boolean|string [its own]
---@param options? ParamOptions
---@return any
function Scene:param(name, default, options) end
---Does it once, at the beginning of the first step whose time is not before it: never early. A run that ends at that time does not do it.
---```lua
---scene:at(1, function() scene.gravity = vec(0, 0, 0) end)
---```
---@param time number [s]
---@param target_or_action Thing|function
---@param action? function
---@return Event
function Scene:at(time, target_or_action, action) end
---Does it once, a while from now, by the rule of at.
---```lua
---scene:after(2, elbow, function(hinge) hinge:cut() end)
---```
---@param delay number [s]
---@param target_or_action Thing|function
---@param action? function
---@return Event
function Scene:after(delay, target_or_action, action) end
---Does it again and again, at period, 2 period, … from now on, by the rule of at.
---```lua
---local ticks = scene:every(0.5, function() print(scene.time) end)
---```
---@param period number [s]
---@param target_or_action Thing|function
---@param action? function
---@return Event
function Scene:every(period, target_or_action, action) end
---Does it at the beginning of each step from one time to another, with u from 0 to 1; with 1 for sure, and last.
---```lua
---scene:over(1, 3, function(u) scene.gravity = vec(0, -9.81 * (1 - u), 0) end)
---```
---@param from number [s]
---@param to number [s]
---@param target_or_action Thing|fun(u: number)
---@param action? fun(u: number, target: Thing)
---@return Event
function Scene:over(from, to, target_or_action, action) end
---Does it at the beginning of the first step at which something holds.
---```lua
---scene:when({ distance_below = 1, of = { p, q } }, function() print("near") end)
---scene:when(function() return p.position.y < 0 end, p, function(it) it:remove() end)
---```
---@param condition Condition|fun(): boolean
---@param target_or_action Thing|function
---@param action? function|WhenOptions
---@param options? WhenOptions
---@return Event
function Scene:when(condition, target_or_action, action, options) end
---A script that waits: wait(2) [s] by the rule of at, wait(function() … end), wait() for the next step.
---```lua
---scene:play(function(wait)
---  p:kick(vec(0, 1, 0)) wait(0.5) q:kick(vec(0, 1, 0))
---end)
---```
---@param target_or_script Thing|fun(wait: Waiting)
---@param script? fun(wait: Waiting, target: Thing)
---@return Event
function Scene:play(target_or_script, script) end
---Calls a function at each "step" (dt), "press" "release" (hand), "key" "key_up" (name), "grab" "drop" (point, hand), "cut" "joined" (hinge), "broke" (connection, constraint or hinge, force [N] or torque [N m], story), "removed" (thing, story). on("key", "x", action) and on("key_up", "x", action) take that key from the window, whatever that does with it; without a name, keys are heard that the window has no use for, and of those that are let go the ones that the scene has taken. Of a gamepad "pad.a" is a key, too. "touched" "parted" (Touch) are told in the step after, once for two things, and with a filter only of it: a body, a solid particle, a floor or ground, a group of these, a family, or the name of a layer.
---```lua
---scene:on("broke", function(thing, load, story) print(story) end)
---scene:on("key", "x", function() p:kick(vec(0, 1, 0)) end)
---scene:on("touched", block, function(touch) print(touch.b, touch.speed, touch.impulse) end)
---```
---@param moment Moment
---@param filter_or_action string|Body|Particle|Collider|Group|Family|function
---@param action? function
---@return Subscription
function Scene:on(moment, filter_or_action, action) end
---Puts a behaviour to work on a target, with which it ends.
---```lua
---scene:behave(p, { step = function(self) self.target:push(vec(self.options.pull, 0, 0)) end }, { pull = 3 })
---```
---@param target Thing|Scene
---@param behaviour Behaviour
---@param options? table
---@return Subscription
function Scene:behave(target, behaviour, options) end
---Puts a button in the window.
---```lua
---scene:button("kick", function() p:kick(vec(0, 2, 0)) end)
---```
---@param name string
---@param action function
function Scene:button(name, action) end
---Records a number each step. `pantin run --out t.csv --when NAME` writes a row where it changes.
---```lua
---scene:probe("height", function() return p.position.y end)
---```
---@param name string
---@param read fun(): number
function Scene:probe(name, read) end
---Puts a value into the summary.
---```lua
---scene:at(0, function() scene:result("gap", (p.position - q.position):length()) end)
---```
---@param name string
---@param value number|boolean|string [its own]
function Scene:result(name, value) end
---Ends the run.
---```lua
---scene:when({ energy_below = 1 }, function() scene:finish() end)
---```
function Scene:finish() end
---The present state, kept in memory. Taking it changes nothing of the run.
---```lua
---local before = scene:snapshot()
---```
---@return Snapshot
function Scene:snapshot() end
---Goes back to a snapshot once the step is done. Things, events and handlers are those of then, and handles of them are theirs again; what was made since is gone. An error while a play goes on.
---```lua
---local before
---scene:button("again", function() scene:restore(before) end)
---before = scene:snapshot()  -- last: what is made after it is gone with the first restore
---```
---@param snapshot Snapshot
function Scene:restore(snapshot) end
---Goes back to the start of the first step, as restore does. A state in a file has none: there it is an error.
---```lua
---scene:button("from the start", function() scene:reset() end)
---```
function Scene:reset() end
---Goes back by a time to a state that scene.history has kept, once the step is done, as restore does. What was before a state in a file is not kept.
---```lua
---scene.history = 3
---scene:on("key", "z", function() scene:rewind(2) end)
---```
---@param by number [s]
function Scene:rewind(by) end
---Saves the state once the step is done, with the script, what it keeps in its variables, and the files that it read, into a file that ends in .pantin, where the program was started or below.
---```lua
---scene:button("save", function() scene:save("state.pantin") end)
---```
---@param file string
function Scene:save(file) end
---Lets a sound be heard: "wood", "metal", "glass", "rubber" as if struck, "blip", "noise", or a .wav file below the scene's folder. It changes nothing of the motion, and is heard in the window alone.
---```lua
---scene:on("touched", block, function(touch) scene:sound("wood", { volume = math.min(1, touch.speed / 5) }) end)
---scene:on("key", "x", function() scene:sound("blip", { pitch = 2 }) end)
---```
---@param sound string
---@param options? SoundOptions
function Scene:sound(sound, options) end
---Opens another scene of the scene's folder, or the same again, once the step is done, with values of its parameters as --set gives them. Without a window the run ends there, and the log tells it.
---```lua
---local score = scene:param("score", 0)
---scene:on("key", "n", function() scene:open("level2.lua", { score = score + 1 }) end)
---```
---@param file string
---@param parameters? table
function Scene:open(file, parameters) end

---A scene that a test opened.
---@class OpenedScene: AnyScene
---@field finished boolean whether it called scene:finish() (read only)
---@field drawn integer lines, arrows, texts and points that it drew in the last step (read only)
---@field sounds string[] names of the sounds that began in the last step (read only)
---@field taken string keys and what of gamepads and the mouse it has read, which are its own (read only)
---@field next string? the file that it opened by scene:open (read only)
---@field next_parameters table the parameters that it opened that file with (read only)
---@field saved Saved what it keeps for the next time, to be read and written (read only)
local OpenedScene = {}
---Steps on for a time.
---```lua
---opened:advance(0.5)
---```
---@param seconds number [s]
function OpenedScene:advance(seconds) end
---Does one step.
---```lua
---opened:step()
---```
function OpenedScene:step() end
---Presses a key from the next step on until it is released; or, by a name as "pad.left_x", what a gamepad has, as far as is said (-1 to 1, default 1).
---```lua
---opened:hold("left")
---opened:hold("pad.left_x", -0.5)
---```
---@param key string
---@param how_far? number [1]
function OpenedScene:hold(key, how_far) end
---Lets go of what is held.
---```lua
---opened:hold("space")
---opened:advance(0.1)
---opened:release("space")
---```
---@param key string
function OpenedScene:release(key) end
---Presses a button of scene:button, in the next step.
---```lua
---local game = open_text [[ scene:button("start", function() scene:finish() end) ]]
---game:press("start")
---game:step()
---```
---@param button string
function OpenedScene:press(button) end
---Points with the mouse from the next step on, until the next call.
---```lua
---opened:mouse { at = vec(1, 2, 0), left = true }
---opened:advance(0.1)
---opened:mouse()
---```
---@param options? MouseOptions
function OpenedScene:mouse(options) end
---The present number of a probe.
---```lua
---expect(opened:read("height")):near(1, 1e-9)
---```
---@param name string
---@return number
function OpenedScene:read(name) end
---A result that the scene gave.
---```lua
---expect(opened:result("answer")):equal(42)
---```
---@param name string
---@return number|boolean|string
function OpenedScene:result(name) end
---The present state.
---```lua
---local before = opened:snapshot()
---```
---@return Snapshot
function OpenedScene:snapshot() end
---Puts a state back.
---```lua
---local before = opened:snapshot()
---opened:advance(0.1)
---opened:restore(before)
---```
---@param snapshot Snapshot
function OpenedScene:restore(snapshot) end

---@class NameOptions
---@field name? string what messages and scene:find call it (default `""`)

---How particles look, and how heavy they are.
---@class LookOptions
---@field mass? number [kg] (default `1`, or its family's)
---@field radius? Curve<number> [m] drawn size, and that of balls in laws (default `0.05`, or its family's)
---@field color? Curve<color> (default blue, or its family's)
---@field look? Look (default `"ball"`, or its family's)

---A PNG or JPEG, of at most 4096 x 4096 pixels and 16 MiB. It is on each face of a box, round balls, capsules and cylinders, and across other shapes as one looks at them; where it is clear, the color shows. A .glb has it, too, but for that of floors.
---@class PictureOptions
---@field file string in the scene's folder or assets/pictures
---@field width? number [m] of the picture, which is repeated (default once on each face)
---@field low? vec [m] corner of the box that it lies over, in the shape's axes: of a piece, that of the whole (default the shape's own)
---@field high? vec [m] the corner opposite to that (default the shape's own)

---A flat picture that is drawn instead of a thing; what is less than half opaque of it is not there. It throws the shadow of a card that stands upright. A .glb has the thing.
---@class Sprite
---@field file string a PNG or JPEG in the scene's folder or assets/pictures
---@field width number [m] of the picture

---@class ParticleOptions: NameOptions, LookOptions
---@field at? vec [m] position (default `vec(0, 0, 0)`)
---@field velocity? vec [m/s] (default `vec(0, 0, 0)`)
---@field family? Family (default none)
---@field lifetime? number [s] after which it goes (default `math.huge`)
---@field [string] Curve<number> [each its own] attributes of its family

---@class FamilyOptions: LookOptions
---@field sprite? Sprite drawn instead of its free particles, times their color where one is given (default none)
---@field attributes? table<string, Curve<number>>|string[] [each its own] values of a particle that gives none; of names alone 0 (default `{}`)
---@field solid? boolean its free particles touch shapes and each other, as balls of their radius that do not turn (default `false`)
---@field friction? number [1] >= 0, of what is solid: of two that touch the root of the product (default `0.5`)
---@field restitution? number [1] 0 … 1, of what is solid: of two that touch the larger (default `0`)
---@field layer? string of what is solid, see Scene:collide (default none)

---@class EmitterOptions: NameOptions, LookOptions
---@field rate number|fun(t: number): number [1/s] particles per second
---@field at? vec|vec[]|Point|Particle [m] a position, a box { vec, vec }, or what carries it (default `vec(0, 0, 0)`)
---@field velocity? vec [m/s] relative to what carries it, along the axes of the world (default `vec(0, 0, 0)`)
---@field spread? number [rad] half angle of the cone of velocities (default `0`)
---@field lifetime? number|{ min: number, max: number } [s] of its particles, or between which it is random (default `math.huge`)
---@field max? integer particles of it that may live at once (default `math.huge`)
---@field family? Family of its particles (default none)
---@field enabled? boolean whether it makes particles (default `true`)
---@field [string] Curve<number> [each its own] attributes of its family

---@class PointOptions
---@field at? vec [m] position in the body's frame (default `vec(0, 0, 0)`)
---@field mass? number [kg] (default `0`, an anchor)
---@field radius? number [m] drawn size (default `0`: the window chooses)
---@field color? color (default the body's)
---@field family? Family (default none)
---@field [string] number [each its own] attributes of its family

---@class AddPointOptions: PointOptions
---@field name? string by which the body has it as a field (default none)

---Moments and products of inertia; a list of the six in this order is understood, too.
---@class Inertia
---@field xx? number [kg m²] (default `0`)
---@field yy? number [kg m²] (default `0`)
---@field zz? number [kg m²] (default `0`)
---@field xy? number [kg m²] (default `0`)
---@field xz? number [kg m²] (default `0`)
---@field yz? number [kg m²] (default `0`)

---What bodies of all sorts are given.
---@class AnyBodyOptions: NameOptions
---@field points? table<integer|string, vec|PointOptions> [m] in its frame, a list or by name; a vec is a position without mass (default `{}`)
---@field at? vec [m] position of its frame's origin (default `vec(0, 0, 0)`)
---@field orientation? quat turns its frame to the world (default `quat(vec(0, 0, 1), 0)`)
---@field velocity? vec [m/s] of its centre of mass (default `vec(0, 0, 0)`)
---@field spin? vec [rad/s] angular velocity, world axes (default `vec(0, 0, 0)`)
---@field mass? number [kg] beside its points', spread over its shapes, or else at its frame's origin (default that of its shapes' density where no point has a mass, else `0`)
---@field inertia? vec|Inertia|number[] [kg m²] beside its points', about the centre of its shapes, or else its frame's origin, in the frame's axes; a vec is the diagonal (default that of its shapes, else `vec(0, 0, 0)`)
---@field color? color of its points and shapes (default orange; of shapes with a picture white)
---@field picture? Picture of those of its shapes that have none (default none)
---@field sprite? Sprite drawn instead of its shapes and points, about its frame's origin; it turns with the body in a scene with a plane, else it faces the camera (default none)

---It needs masses enough to turn: of its shapes, of its points, or its own mass and inertia.
---@class BodyOptions: AnyBodyOptions
---@field shape? Shape that touches others (default none)
---@field shapes? Shape[] several of them (default none)
---@field layer? string of those of its shapes that have none (default none)

---A plane of the world.
---@class CuttingPlane
---@field through vec [m] a position in it
---@field normal vec [1] towards what becomes a body of its own

---@class ShatterOptions
---@field pieces integer bodies, 2 to 1000, and as many as the body has shapes
---@field seed? integer of the random positions about which the pieces are (default `1`)
---@field at? vec [m] in the world: pieces are smaller the nearer they are (default none: spread evenly)

---@class FloorOptions: NameOptions
---@field height? number [m] along its normal (default `0`)
---@field normal? vec [1] out of what is solid (default `vec(0, 1, 0)`)
---@field friction? number [1] (default `0.5`)
---@field restitution? number [1] 0 to 1 (default `0`)
---@field rolling? number [m] moment by normal force against rolling (default `0`)
---@field spinning? number [m] moment by normal force against spinning on the spot (default `0`)
---@field surface_velocity? vec [m/s] of a belt, along the axes of the world (default `vec(0, 0, 0)`)
---@field layer? string that scene:collide speaks of (default none)
---@field sensor? boolean tells what it touches, and pushes nothing (default `false`)
---@field size? number [m] across which it is drawn, though it has no end (default as far as is seen)
---@field color? color of its brighter squares (default grey; with a picture white)
---@field picture? Picture instead of squares, again and again; 1 m wide unless it says so (default none)

---@class GroundOptions
---@field shape? Shape to be put into the world (default none)
---@field shapes? Shape[] several of them (default none)
---@field at? vec [m] position of their frame's origin (default `vec(0, 0, 0)`)
---@field orientation? quat turns their frame to the world (default `quat(vec(0, 0, 1), 0)`)
---@field color? color of those that have none (default grey; with a picture white)
---@field picture? Picture of those that have none (default none)
---@field layer? string of those that have none (default none)

---Of two layers that touch.
---@class PairOptions
---@field friction? number [1] (default as usual: the root of the product)
---@field restitution? number [1] 0 to 1 (default as usual: the larger)

---Which shapes may be met.
---@class HitFilter
---@field layer? string only those in it (default any)
---@field layers? string[] only those in one of these (default any)
---@field ignore? Body|Collider|Group|(Body|Collider|Group)[] not these (default none)
---@field sensors? boolean sensors, too (default `false`)

---To, or direction.
---@class RayOptions: HitFilter
---@field from vec [m] where it begins
---@field to? vec [m] where it ends (default none)
---@field direction? vec [1] in which it goes without end; its length does not matter (default none)

---Loads, and of a constraint or connection the length, at which it breaks.
---@class Breaking
---@field force? number [N] (default `math.huge`)
---@field torque? number [N m] of a constraint or hinge (default `math.huge`)
---@field length? number [m] of a constraint or connection (default `math.huge`)

---@class HingeOptions: NameOptions
---@field color? color (default its points')
---@field radius? number [m] (default its points')
---@field lifetime? number [s] after which it is cut (default `math.huge`)
---@field family? Family (default the first point's)
---@field axis? vec [1] the bodies given here turn about it only, against each other; world axes (default none: about any)
---@field collide? boolean its bodies touch each other, as all else; not right at the hinge, which holds them together (default `false`)
---@field breaks_at? Breaking (default `{}`)

---@class ConstraintOptions: NameOptions
---@field breaks_at? Breaking (default `{}`)

---@class HandOptions
---@field path? fun(t: number): vec [m] its position at a time [s] (default none)

---@class GrabOptions
---@field max_force? number [N] it never pulls harder (default 20 times the weight of what hangs on the point)

---@class BondingOptions
---@field families Family|Family[] one, or two
---@field near number [m] at most so far apart
---@field below number [K] bonds are made
---@field above number [K] bonds break
---@field law? Law of the connections that are made; this or hinge (default none)
---@field implicit? boolean|"dissipative" of those connections, as in connect (default as of the law)
---@field hinge? boolean what is near is joined to a hinge (default `false`)
---@field time_constant? number [s] of that (default `0.05`)

---One limit, and what it is of.
---@class Condition
---@field temperature_above? number [K] (default none)
---@field temperature_below? number [K] (default none)
---@field energy_above? number [J] (default none)
---@field energy_below? number [J] (default none)
---@field force_above? number [N] of a hinge, constraint or connection (default none)
---@field force_below? number [N] (default none)
---@field distance_above? number [m] of a list of two things or positions (default none)
---@field distance_below? number [m] (default none)
---@field count_above? number [1] of a group or family (default none)
---@field count_below? number [1] (default none)
---@field of? Thing|Scene|(Thing|vec)[] [m] (default the scene)

---@class WhenOptions
---@field mean? number [s] over which the measure is averaged (default `0`)
---@field again? boolean at each crossing (default `false`)
---@field hysteresis? number [as the limit] how far back beyond the limit before it may cross again (default `0`)

---Functions of what is at work, which looks up in the behaviour what it does not have; its fields target and options are what scene:behave was given.
---@class Behaviour
---@field start? fun(self: table) at once (default none)
---@field step? fun(self: table, dt: number) at the beginning of each step, of dt [s] (default none)
---@field stop? fun(self: table) when it ends (default none)

---@class LineOptions
---@field color? color (default what shows on the background)
---@field width? number [px] (default `2`)
---@field space? "scene"|"screen" where positions are: in m or in px (default `"scene"`)

---@class MarkOptions
---@field color? color (default what shows on the background)
---@field size? number [px] diameter of a point, height of letters (default `8` of a point, `14` of text)
---@field space? "scene"|"screen" where positions are: in m or in px (default `"scene"`)

---@class SoundOptions
---@field volume? number [1] from 0 to 1 (default `1`)
---@field pitch? number [1] times the usual frequency, from 1/8 to 8 (default `1`)

---@class MouseOptions
---@field at? vec [m] what it points at (default where it was)
---@field left? boolean whether this button is down (default `false`)
---@field middle? boolean the same (default `false`)
---@field right? boolean the same (default `false`)
---@field wheel? number [1] notches that it turns in that step, up > 0 (default `0`)

---@class ParamOptions
---@field min? number [its own] (default none)
---@field max? number [its own] (default none)
---@field step? number [its own] (default none)
---@field help? string what it does (default `""`)
---@field choices? any[] the values that it may have (default all)
---@field on_change? fun(value: any) changes it while the scene runs; without it the scene starts anew (default none)

---@alias BuildForm "deformable"|"rigid"|"articulated"|"panels" particles tied by laws, one body, or rods or plates with hinges

---What each vertex, edge or face becomes; nothing where the function returns nil.
---@class BuildForms
---@field vertices? fun(at: vec, number: integer): BuildForm? [m] deformable or rigid (default none)
---@field edges? fun(a: vec, b: vec, number: integer): BuildForm? [m] deformable, rigid or articulated (default none)
---@field faces? fun(middle: vec, number: integer): BuildForm? [m] deformable, rigid or panels (default none)

---@class BuildOptions
---@field as BuildForm|BuildForms|fun(at: vec, number: integer): BuildForm? a function alone is of vertices
---@field law? Law on edges that are not within a body (default none)
---@field laws? { edge?: Law, angle?: Law, torsion?: Law } instead: on edges, pairs of edges that meet, and three in a row (default none)
---@field mass? number [kg] of all (default `1`)
---@field mass_in? "points"|"edges"|"faces"|"solid" where it is (default edges if articulated, faces of panels, the hulls of those that touch, else points)
---@field shape? "hull" rigid parts touch others, each as the convex hull of its vertices (default none)
---@field friction? number [1] of these, as of any shape (default `0.5`)
---@field restitution? number [1] (default `0`)
---@field rolling? number [m] (default `0`)
---@field spinning? number [m] (default `0`)
---@field layer? string that scene:collide speaks of (default none)
---@field at? vec [m] position of the structure's origin (default `vec(0, 0, 0)`)
---@field velocity? vec [m/s] (default `vec(0, 0, 0)`)
---@field family? Family of the particles (default none)
---@field color? color of particles and points (default as of those made alone)
---@field radius? number [m] of particles and points (default as of those made alone)
---@field axis? vec [1] hinges turn about it only; world axes (default none: about any)
---@field name? string of the group (default `""`)

---@class EdgeOptions
---@field edge? number [m] length of an edge (default `1`)

---@class PolygonOptions: EdgeOptions
---@field sides? integer (default `6`)

---@class PrismOptions: PolygonOptions
---@field height? number [m] (default `1`)

---@class PiecesOptions
---@field length? number [m] (default `1`)
---@field pieces? integer (default `1`)

---@class SheetOptions: EdgeOptions
---@field columns? integer (default `1`)
---@field rows? integer (default `1`)

---@class RotatingSquaresOptions: SheetOptions
---@field angle? number [rad] of 0 to π/4 (default `0`)

---@class ReentrantOptions: SheetOptions
---@field rib? number [m] length of the upright ribs (default twice the edge)
---@field angle? number [rad] by which edges rise inwards (default `0.5`)

---@class RingOptions
---@field sides? integer (default `12`)
---@field radius? number [m] (default `1`)

---@class GeodesicOptions
---@field divisions? integer how often each triangle becomes four (default `2`)
---@field radius? number [m] (default `1`)

---@class LatticeOptions: EdgeOptions
---@field kind? "cubic"|"fcc"|"bcc"|"diamond"|"square"|"triangular"|"honeycomb"|"kagome" the last four are flat (default `"cubic"`)
---@field cells? integer|vec [1] in each direction (default `1`)

---@class MoleculeOptions
---@field scale? number [m/Å] (default `1`)

---@class StructureParts
---@field vertices vec[] [m] positions
---@field edges? integer[][] pairs of numbers of vertices; those of faces need not be given (default `{}`)
---@field faces? integer[][] lists of numbers of vertices, counter-clockwise seen from outside (default `{}`)

---@class TieOptions: ConstraintOptions
---@field time_constant? number [s] with which what is far is drawn there, critically damped (default `0.1`)

---@class FollowOptions: ConstraintOptions
---@field time_constant? number [s] with which what is far is drawn there, critically damped (default `0.05`)
---@field max_force? number [N] it never pulls harder, and is a spring and damper then: a weight hangs g time_constant^2 lower (default `math.huge`)

---@class OrientOptions: ConstraintOptions
---@field time_constant? number [s] with which what is far is drawn there, critically damped (default `0.1`)

---@class AlignOptions: OrientOptions
---@field angle? number|fun(t: number): number [rad] of 0 to π (default the present one)

---One of speed and angle must be given.
---@class MotorOptions: OrientOptions
---@field axis? vec [1] world axes; it stays fixed in a (default the normal of scene.plane; without one it must be given)
---@field speed? number|fun(t: number): number [rad/s] of a against b (default none)
---@field angle? number|fun(t: number): number [rad] of a against b, 0 where it is now (default none)
---@field max_torque? number [N m] it never pushes harder (default `math.huge`)

---@class LimitOptions: OrientOptions
---@field axis? vec [1] of an angle; world axes (default the normal of scene.plane; without one it must be given)
---@field min? number [rad or m] (default `-math.huge`; of a distance 0)
---@field max? number [rad or m] (default `math.huge`)
---@field length? number [m] of a distance, the same as max (default none)

---@class PlaneOptions: OrientOptions
---@field through? vec [m] a position on the plane (default where the point is)
---@field normal? vec [1] across the plane, world axes (default `vec(0, 1, 0)`)

---@class StringOptions: OrientOptions
---@field length? number|fun(t: number): number [m] the most that it is long (default the present one)

---@class PathOptions: OrientOptions
---@field smooth? boolean a spline with continuous curvature; else straight pieces, round whose corners a bead keeps its speed (default `false`)
---@field closed? boolean its end is its beginning (default `false`)

---@class JoinOptions
---@field at? vec [m] where they meet (default on their way to each other)
---@field time_constant? number [s] with which they are drawn together (default `0.05`)
---@field max_force? number [N] it never pulls harder, until they are near (default `math.huge`)
---@field axis? vec [1] the hinge turns about it only; world axes as they are when it is made (default none: about any)
---@field on_met? fun(hinge: Particle) called in the step after (default none)
---@field name? string of the hinge (default `""`)

---@class GearOptions: ConstraintOptions
---@field ratio number|fun(t: number): number [1] turns of a for one of b, in the sense of their axes; not 0, below 0 they turn against each other, as wheels do that mesh from outside
---@field axis? vec [1] of a, world axes; it stays fixed in a (default the normal of scene.plane; without one it must be given)
---@field axis_b? vec [1] of b (default `axis`)
---@field carrier? Body against which both turn, as the arm of a planetary gear (default the world)

---@class RackOptions: ConstraintOptions
---@field radius number|fun(t: number): number [m] how far the point moves for a turn of 1 rad; not 0
---@field axis? vec [1] of the wheel, world axes (default the normal of scene.plane; without one it must be given)
---@field along vec [1] in which the point moves when the wheel turns about the axis, world axes; it stays fixed in the carrier
---@field carrier? Body against which the wheel turns and the point moves (default the world)

---@class PulleyOptions: OrientOptions
---@field ratio? number|fun(t: number): number [1] how many times b's side counts, > 0 (default `1`)
---@field length? number [m] the most that a's side and ratio times b's add up to (default the present one)

---@class ScrewOptions: ConstraintOptions
---@field lead number|fun(t: number): number [m] by which the first point goes along the axis for a turn of its body about it; not 0
---@field axis vec [1] world axes; it stays fixed in both bodies

---@class SliderOptions: OrientOptions
---@field axis vec [1] world axes; it stays fixed in the carrier
---@field turns? boolean the point's body turns freely about it, as a pin in a slot (default `false`)
---@field length? number|fun(t: number): number [m] how far along the axis it is kept, 0 where it is now (default none: it slides)
---@field min? number [m] least way along the axis, 0 where it is now; not with a length (default `-math.huge`)
---@field max? number [m] greatest way along the axis; not with a length (default `math.huge`)

---What shapes are made of, and what they touch.
---@class MaterialOptions
---@field density? number [kg/m³] of a body whose mass is not given; of one with several shapes and a mass, in which proportion it is theirs (default `1000`)
---@field friction? number [1] of two that touch the root of the product counts (default `0.5`)
---@field restitution? number [1] 0 to 1; of two that touch the larger counts (default `0`)
---@field rolling? number [m] moment by normal force against rolling; of two that touch the larger counts (default `0`)
---@field spinning? number [m] moment by normal force against spinning on the spot; of two that touch the larger counts (default `0`)
---@field surface_velocity? vec [m/s] of its surface against its body, as of a belt; along the axes of the body, with which it turns, or of the world for what stands in it (default `vec(0, 0, 0)`)
---@field layer? string that scene:collide speaks of; it exists once it is named (default the body's, or none)
---@field sensor? boolean tells what it touches, and pushes nothing; beside others it weighs nothing (default `false`)

---@class ShapeOptions: NameOptions, MaterialOptions
---@field at? vec [m] position in the frame of its body, or in the world (default `vec(0, 0, 0)`)
---@field orientation? quat turns it in that frame (default `quat(vec(0, 0, 1), 0)`)
---@field color? color (default the body's, or grey; with a picture white)
---@field picture? Picture that is drawn on it, times its color (default the body's, or none)

---@class BallSize
---@field radius number [m]

---Size, or x, y and z.
---@class BoxSize
---@field size? vec|number [m] its edges along the axes; a number is that of a cube (default none)
---@field x? number [m] (default none)
---@field y? number [m] (default none)
---@field z? number [m] (default none)

---Length, or from and to.
---@class CapsuleSize
---@field radius number [m] of its ends
---@field length? number [m] between the centres of its ends, along y (default none)
---@field from? vec [m] the centre of one end (default none)
---@field to? vec [m] that of the other (default none)

---@class CylinderSize
---@field radius number [m]
---@field length number [m]
---@field axis? vec [1] along which it is long (default `vec(0, 1, 0)`)

---@class BallShapeOptions: ShapeOptions, BallSize

---@class BoxShapeOptions: ShapeOptions, BoxSize

---@class CapsuleShapeOptions: ShapeOptions, CapsuleSize

---@class CylinderShapeOptions: ShapeOptions, CylinderSize

---@class HullShapeOptions: ShapeOptions
---@field points vec[]|Structure [m] four or more that are not in one plane; of a structure its vertices

---@class PolygonShapeOptions: ShapeOptions
---@field points vec[] [m] three or more, in the scene's plane, else in that of x and y
---@field thickness? number [m] across that plane (default `1`)

---One-sided: its front is on the left of who walks from point to point; through its back things pass.
---@class LineShapeOptions: ShapeOptions
---@field points vec[] [m] two or more, in the scene's plane, else in that of x and y; from left to right the front is above
---@field closed? boolean the last one is joined to the first; anticlockwise the front is inside (default `false`)
---@field thickness? number [m] across that plane; what touches it may be deeper (default `2`)

---@class PlaneShapeOptions: ShapeOptions
---@field normal? vec [1] out of what is solid (default `vec(0, 1, 0)`)
---@field height? number [m] of the plane along its normal (default `0`)

---A file, or vertices and faces.
---@class MeshShapeOptions: ShapeOptions, MeshFileOptions
---@field file? string of the scene's folder or assets/meshes, a Wavefront .obj (default none)
---@field vertices? vec[]|Structure [m] positions; of a structure its faces count, too (default none)
---@field faces? integer[][] lists of three or more numbers of vertices, counter-clockwise seen from outside (default the structure's)

---@class MeshFileOptions
---@field scale? number [m] of the file's length 1 (default `1`)

---@class HeightsShapeOptions: ShapeOptions
---@field columns integer of places along x
---@field rows integer of places along z
---@field spacing? number [m] between them, about the origin (default `1`)
---@field height number[]|fun(x: number, z: number): number [m] a list, row by row, or at a place

---@class BallOptions: AnyBodyOptions, MaterialOptions, BallSize

---@class BoxOptions: AnyBodyOptions, MaterialOptions, BoxSize

---@class CapsuleOptions: AnyBodyOptions, MaterialOptions, CapsuleSize

---@class CylinderOptions: AnyBodyOptions, MaterialOptions, CylinderSize

---A law: how particles pull at each other, or are pulled. It does not change.
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
---@class SpringOptions: PairLawOptions
---@field stiffness number [N/m] k
---@field length? number [m] at which there is no force (default the present one)
---@field damping? number [N s/m] c; without it the spring only stores energy (default `0`)

---V = k (r - l)² / 2, with damping c also a tension c dr/dt (R. Hooke, De Potentia Restitutiva, 1678)
---```lua
---scene:connect(p, q, force.spring { stiffness = 100, damping = 2 })
---```
---@param options SpringOptions
---@return Law
function force.spring(options) end
---@class DamperOptions: PairLawOptions
---@field damping number [N s/m] c

---tension c dr/dt (Lord Rayleigh, The Theory of Sound, vol. 1, 1877, § 81)
---```lua
---scene:connect(p, q, force.damper { damping = 5 })
---```
---@param options DamperOptions
---@return Law
function force.damper(options) end
---@class GravitationOptions: PairLawOptions
---@field constant? number [N m²/kg²] G (default `6.6743e-11`)
---@field softening? number [m] s (default `0`)

---V = -G m m' / sqrt(r² + s²) (I. Newton, Principia, 1687, book 3, proposition 7; softening: H. C. Plummer, MNRAS 71, 1911, p. 460)
---```lua
---scene:interact(ions, ions, force.gravitation { constant = 1, softening = 0.1 })
---```
---@param options GravitationOptions
---@return Law
function force.gravitation(options) end
---@class CoulombOptions: PairLawOptions
---@field constant? number [N m²/C²] k (default `8987551787.368176`)

---V = k q q' / r (C. A. Coulomb, Premier mémoire sur l'électricité et le magnétisme, 1785)
---```lua
---scene:interact(ions, ions, force.coulomb { constant = 1 })
---```
---@param options CoulombOptions
---@return Law
function force.coulomb(options) end
---@class MorseOptions: PairLawOptions
---@field depth number [J] D
---@field steepness number [1/m] a
---@field length? number [m] at which there is no force (default the present one)

---V = D (exp(-2 a (r - l)) - 2 exp(-a (r - l))) (P. M. Morse, Phys. Rev. 34, 1929, p. 57, eq. 4)
---```lua
---scene:connect(p, q, force.morse { depth = 5, steepness = 2 })
---```
---@param options MorseOptions
---@return Law
function force.morse(options) end
---@class BuckinghamOptions: PairLawOptions
---@field repulsion number [J] A
---@field steepness number [1/m] B
---@field attraction number [J m⁶] C

---V = A exp(-B r) - C / r⁶; without bound where r is very small (R. A. Buckingham, Proc. R. Soc. A 168, 1938, p. 264)
---```lua
---scene:interact(ions, ions, force.buckingham { repulsion = 100, steepness = 3, attraction = 1 })
---```
---@param options BuckinghamOptions
---@return Law
function force.buckingham(options) end
---@class YukawaOptions: PairLawOptions
---@field strength number [J m] g
---@field screening number [m] λ

---V = g exp(-r / λ) / r, repulsive where g > 0 (H. Yukawa, Proc. Phys.-Math. Soc. Japan 17, 1935, p. 48)
---```lua
---scene:interact(ions, ions, force.yukawa { strength = 2, screening = 0.5, cutoff = 3 })
---```
---@param options YukawaOptions
---@return Law
function force.yukawa(options) end
---@class TableOptions: PairLawOptions
---@field distances number[] [m] rising
---@field potentials? number[] [J] at the distances; this or tensions (default none)
---@field tensions? number[] [N] at the distances, positive where they pull (default none)

---a natural cubic spline through given potentials or tensions; straight before the first point, cut off at the last (C. de Boor, A Practical Guide to Splines, 1978, ch. IV)
---```lua
---scene:connect(p, q, force.table { distances = { 0.5, 1, 2 }, tensions = { -5, 0, 3 } })
---```
---@param options TableOptions
---@return Law
function force.table(options) end
---@class LennardJonesOptions: PairLawOptions
---@field epsilon number [J] ε
---@field sigma number [m] σ

---V = 4 ε ((σ/r)¹² - (σ/r)⁶), cut off at 2.5 σ unless it is said where (J. E. Lennard-Jones, Proc. Phys. Soc. 43, 1931, p. 461)
---```lua
---scene:interact(ions, ions, force.lennard_jones { epsilon = 1, sigma = 0.3 })
---```
---@param options LennardJonesOptions
---@return Law
function force.lennard_jones(options) end
---@class WcaOptions: PairLawOptions
---@field epsilon number [J] ε
---@field sigma number [m] σ

---V = 4 ε ((σ/r)¹² - (σ/r)⁶) + ε up to 2^(1/6) σ, 0 beyond (J. D. Weeks, D. Chandler and H. C. Andersen, J. Chem. Phys. 54, 1971, p. 5237, eq. 4)
---```lua
---scene:interact(ions, ions, force.wca { epsilon = 1, sigma = 0.3 })
---```
---@param options WcaOptions
---@return Law
function force.wca(options) end
---@class HydrophobicOptions: PairLawOptions
---@field strength number [J] ε
---@field size number [m] b
---@field range? number [m] w (default 1.6 b)
---@field attraction? number [1] h (default `1`)

---a core as wca's with ε and σ = b, and around it a well -h ε cos²(π x / 2), x = (r - 2^(1/6) b) / w from 0 to 1: attraction between like (h = 1, tails that shun water), none (0) or repulsion (-1) between others. Makes droplets, membranes and vesicles of bodies with a head and tails (I. R. Cooke, K. Kremer and M. Deserno, Phys. Rev. E 72, 2005, 011506, eqs. 1 and 4)
---```lua
---scene:interact(ions, ions, force.hydrophobic { strength = 1, size = 0.3 })
---```
---@param options HydrophobicOptions
---@return Law
function force.hydrophobic(options) end
---@class RepelOptions: PairLawOptions
---@field stiffness number [N/m^1.5] k

---balls that touch push with k overlap^1.5, the overlap that of their radii (H. Hertz, J. reine angew. Math. 92, 1882, p. 156)
---```lua
---scene:interact(ions, ions, force.repel { stiffness = 1000 })
---```
---@param options RepelOptions
---@return Law
function force.repel(options) end
---@class FlockOptions: PairLawOptions
---@field sight number [m] beyond it neighbours do not matter
---@field separation? number [N m] s (default `0`)
---@field alignment? number [N s/m] a (default `0`)
---@field cohesion? number [N/m] c (default `0`)

---each follows its neighbours: w (c d + a u - s d / r²), d and u the position and velocity of the other relative to it, w = (1 - r²/sight²)² (C. W. Reynolds, Computer Graphics 21 (4), 1987, p. 25)
---```lua
---scene:interact(ions, ions, force.flock { sight = 2, separation = 0.1, alignment = 1, cohesion = 0.5 })
---```
---@param options FlockOptions
---@return Law
function force.flock(options) end
---@class DragOptions: LawOptions
---@field linear? number [N s/m] c (default `0`)
---@field quadratic? number [N s²/m²] q (default `0`)

----(c + q |v|) v (G. G. Stokes, Trans. Camb. Phil. Soc. 9, 1851, p. 8 (linear); Newton, Principia, 1687, book 2 (quadratic))
---```lua
---scene:field(scene, force.drag { linear = 0.1, quadratic = 0.05 })
---```
---@param options DragOptions
---@return Law
function force.drag(options) end
---@class WindOptions: LawOptions
---@field velocity vec [m/s] u
---@field linear? number [N s/m] c (default `0`)
---@field quadratic? number [N s²/m²] q (default `0`)

---drag in air that moves with velocity u: (c + q |u - v|) (u - v) (as drag)
---```lua
---scene:field(ions, force.wind { velocity = vec(3, 0, 0), linear = 0.2 })
---```
---@param options WindOptions
---@return Law
function force.wind(options) end
---@class VortexOptions: LawOptions
---@field centre? vec [m] a point of the axis (default `vec(0, 0, 0)`)
---@field axis vec [1] direction that the air circles by the right-hand rule
---@field circulation number [m²/s] Γ
---@field core number [m] distance where the air is fastest
---@field linear? number [N s/m] c (default `0`)
---@field quadratic? number [N s²/m²] q (default `0`)

---drag in air that circles an axis: u = Γ s / (2 π (core² + s²)) at distance s from it (W. Kaufmann, Ingenieur-Archiv 31, 1962, p. 1)
---```lua
---scene:field(ions, force.vortex { axis = vec(0, 1, 0), circulation = 5, core = 0.5, linear = 0.2 })
---```
---@param options VortexOptions
---@return Law
function force.vortex(options) end
---@class BuoyancyOptions: LawOptions
---@field density number [kg/m³] of the liquid
---@field surface? number [m] height y of the surface (default `0`)
---@field gravity? number [m/s²] weight per mass (default `9.81`)

---a ball is lifted along y by the weight of the liquid that it displaces (Archimedes, On Floating Bodies, book 1, propositions 5 to 7; volume of a cap: π h² (3 R - h) / 3)
---```lua
---scene:field(group, force.buoyancy { density = 1000, surface = 0.5 })
---```
---@param options BuoyancyOptions
---@return Law
function force.buoyancy(options) end
---@class ThermostatOptions: LawOptions
---@field rate number [1/s] γ
---@field temperature number [K] T

----γ m v + sqrt(2 γ m k T / h) noise, k Boltzmann's constant and h the step of the scene, in the middle of each drift: particles in a harmonic well spread as at T at any step, and free ones have its velocities; in a well in which they swing at ω the velocities, and with them scene.temperature, are those of T (1 - (ω h)²/4) (P. Langevin, C. R. Acad. Sci. 146, 1908, p. 530; the splitting BAOAB: B. Leimkuhler and C. Matthews, Appl. Math. Res. Express 2013, p. 34)
---```lua
---scene:field(ions, force.thermostat { rate = 2, temperature = 1 })
---```
---@param options ThermostatOptions
---@return Law
function force.thermostat(options) end
---@class WallOptions: LawOptions
---@field through? vec [m] a point of the plane (default `vec(0, 0, 0)`)
---@field normal vec [1] out of the wall
---@field stiffness number [N/m] k
---@field damping? number [N s/m] c (default `0`)
---@field friction? number [1] μ (default `0`)
---@field slip? number [m/s] speed below which friction is less than full (default `1e-06`)

---a ball that reaches behind a plane is pushed out: N = max(k overlap - c v_n, 0), with friction μ N against its sliding v, as v / sqrt(v² + slip²) (P. A. Cundall and O. D. L. Strack, Géotechnique 29, 1979, p. 47)
---```lua
---scene:field(scene, force.wall { normal = vec(0, 1, 0), stiffness = 1e4, damping = 20, friction = 0.3 })
---```
---@param options WallOptions
---@return Law
function force.wall(options) end
---@class AngleOptions: LawOptions
---@field stiffness number [J] k
---@field angle? number [rad] θ where there is no force (default the present one)

---V = k (θ - θ0)² / 2 of the angle at the second of three particles; no force where they are in line (E. B. Wilson, J. C. Decius and P. C. Cross, Molecular Vibrations, 1955, ch. 4)
---```lua
---scene:connect({ p, q, ion }, force.angle { stiffness = 2, angle = math.pi / 2 })
---```
---@param options AngleOptions
---@return Law
function force.angle(options) end
---@class TorsionOptions: LawOptions
---@field stiffness number [J] k
---@field angle? number [rad] θ where there is no force (default the present one)
---@field fold? number [1] n, minima of a turn (default `1`)

---V = k (1 - cos(n (φ - φ0))) of the torsion of four particles, IUPAC's sign; no force where three are in line (B. R. Brooks et al., J. Comput. Chem. 4, 1983, p. 187, eq. 4; derivative by the graph's reverse mode)
---```lua
---scene:connect({ p, q, ion, elbow }, force.torsion { stiffness = 2, fold = 3 })
---```
---@param options TorsionOptions
---@return Law
function force.torsion(options) end

---In the function of a law: a normal deviate of mean 0 and variance 1, one for each call, pair and step.
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

structure = {}
---Four triangles.
---```lua
---local t = structure.tetrahedron { edge = 2 }
---```
---@param options? EdgeOptions
---@return Structure
function structure.tetrahedron(options) end
---Six squares.
---```lua
---local c = structure.cube { edge = 2 }
---```
---@param options? EdgeOptions
---@return Structure
function structure.cube(options) end
---Eight triangles.
---```lua
---local o = structure.octahedron()
---```
---@param options? EdgeOptions
---@return Structure
function structure.octahedron(options) end
---Twelve pentagons.
---```lua
---local d = structure.dodecahedron()
---```
---@param options? EdgeOptions
---@return Structure
function structure.dodecahedron(options) end
---Twenty triangles.
---```lua
---local i = structure.icosahedron()
---```
---@param options? EdgeOptions
---@return Structure
function structure.icosahedron(options) end
---Two regular polygons, one above the other.
---```lua
---local p = structure.prism { sides = 8, height = 0.2 }
---```
---@param options? PrismOptions
---@return Structure
function structure.prism(options) end
---One regular face.
---```lua
---local hexagon = structure.polygon { sides = 6 }
---```
---@param options? PolygonOptions
---@return Structure
function structure.polygon(options) end
---A line along x.
---```lua
---local chain = structure.rod { length = 5, pieces = 20 }
---```
---@param options? PiecesOptions
---@return Structure
function structure.rod(options) end
---Squares side by side, in the plane z = 0.
---```lua
---local net = structure.sheet { columns = 10, rows = 5, edge = 0.1 }
---```
---@param options? SheetOptions
---@return Structure
function structure.sheet(options) end
---A regular polygon without a face.
---```lua
---local hoop = structure.ring { sides = 24, radius = 0.5 }
---```
---@param options? RingOptions
---@return Structure
function structure.ring(options) end
---An icosahedron with its triangles divided into four some times, on a sphere.
---```lua
---local globe = structure.geodesic { divisions = 2, radius = 3 }
---```
---@param options? GeodesicOptions
---@return Structure
function structure.geodesic(options) end
---Squares that touch at their corners, turned by plus and minus an angle.
---```lua
---local mesh = structure.rotating_squares { columns = 4, rows = 4, angle = 0.3 }
---```
---@param options? RotatingSquaresOptions
---@return Structure
function structure.rotating_squares(options) end
---A honeycomb of bow ties: upright ribs, and edges that rise inwards by an angle.
---```lua
---local auxetic = structure.reentrant { columns = 4, rows = 3 }
---```
---@param options? ReentrantOptions
---@return Structure
function structure.reentrant(options) end
---A block of cells with edges between neighbours.
---```lua
---local crystal = structure.lattice { kind = "diamond", cells = vec(2, 2, 1), edge = 0.5 }
---```
---@param options? LatticeOptions
---@return Structure
function structure.lattice(options) end
---Atoms, bonds and flat rings of a .xyz, .sdf, .mol, .pdb, .cif or .mmcif file in the scene's folder or assets/molecules.
---```lua
---local ball = structure.molecule("c60.xyz", { scale = 0.1 })
---```
---@param file string
---@param options? MoleculeOptions
---@return Structure
function structure.molecule(file, options) end
---Vertices and faces of a Wavefront .obj file in the scene's folder or assets/meshes; a notice tells of holes.
---```lua
---scene:ground { shape = shape.mesh(structure.mesh("bowl.obj", { scale = 0.5 })), at = vec(0, -9, 0) }
---```
---@param file string
---@param options? MeshFileOptions
---@return Structure
function structure.mesh(file, options) end
---A structure of one's own; edges of faces need not be given.
---```lua
---local kite = structure.new { vertices = { vec(0, 0, 0), vec(1, 0, 0), vec(1, 1, 0) }, faces = { { 1, 2, 3 } } }
---```
---@param parts StructureParts
---@return Structure
function structure.new(parts) end

shape = {}
---A ball.
---```lua
---local ball = shape.ball { radius = 0.5, restitution = 0.8 }
---local rubber = shape.ball(0.5, { restitution = 0.8 })
---```
---@param radius number|BallShapeOptions [m]
---@param options? BallShapeOptions
---@return Shape
function shape.ball(radius, options) end
---A box along the axes; of one length a cube.
---```lua
---local brick = shape.box { size = vec(0.24, 0.07, 0.12), density = 1900 }
---local plank = shape.box(2, 0.05, 0.3)
---```
---@param x number|vec|BoxShapeOptions [m]
---@param y? number|BoxShapeOptions [m]
---@param z? number [m]
---@param options? BoxShapeOptions
---@return Shape
function shape.box(x, y, z, options) end
---All within a radius of a line: a cylinder with round ends.
---```lua
---local limb = shape.capsule { radius = 0.1, from = vec(0, 0, 0), to = vec(1, 0, 0) }
---local post = shape.capsule(0.1, 1)
---```
---@param radius number|CapsuleShapeOptions [m]
---@param length? number [m]
---@param options? CapsuleShapeOptions
---@return Shape
function shape.capsule(radius, length, options) end
---A cylinder along y, or along an axis.
---```lua
---local wheel = shape.cylinder { radius = 0.4, length = 0.1, axis = vec(0, 0, 1) }
---```
---@param radius number|CylinderShapeOptions [m]
---@param length? number [m]
---@param options? CylinderShapeOptions
---@return Shape
function shape.cylinder(radius, length, options) end
---The convex hull of at most 100,000 points, or of the vertices of a structure; it may have 10,000 corners.
---```lua
---local die = shape.hull(structure.dodecahedron { edge = 0.2 }, { friction = 0.3 })
---```
---@param points vec[]|Structure|HullShapeOptions [m]
---@param options? HullShapeOptions
---@return Shape
function shape.hull(points, options) end
---A plate whose outline is the convex hull of points in the scene's plane, else in that of x and y, which is at half its thickness.
---```lua
---local wedge = shape.polygon { points = { vec(0, 0, 0), vec(2, 0, 0), vec(0, 1, 0) }, thickness = 0.5 }
---```
---@param points vec[]|PolygonShapeOptions [m]
---@param thickness? number [m]
---@param options? PolygonShapeOptions
---@return Shape
function shape.polygon(points, thickness, options) end
---A line through points in the scene's plane, else in that of x and y, and what lies before and behind it. It is one-sided: its front, on the left of who walks along it, bears things; through its back they pass. Points from left to right have their front above, as of ground; from right to left below, as of a ceiling. A closed line whose points go round anticlockwise holds things in, clockwise it keeps them out. For both sides give two lines, polygon. It does not move, so no body can have it.
---```lua
----- things rest on it:   1 -> 2 -> 3   and come through from below
---scene:ground { shape = shape.line({ vec(-5, -9, 0), vec(0, -9.5, 0), vec(5, -9, 0) }) }
---```
---@param points vec[]|LineShapeOptions [m]
---@param options? LineShapeOptions
---@return Shape
function shape.line(points, options) end
---A plane, solid behind it. It does not move, so no body can have it.
---```lua
---scene:ground { shape = shape.plane { normal = vec(1, 0, 0), height = -9 } }
---```
---@param options? PlaneShapeOptions
---@return Shape
function shape.plane(options) end
---Triangles, one-sided: their front is where their corners run counter-clockwise; from behind things come through. It does not move, so no body can have it.
---```lua
---scene:ground { shape = shape.mesh(structure.sheet { columns = 4, rows = 4 }) }
---```
---@param vertices vec[]|Structure|MeshShapeOptions [m]
---@param faces? integer[][]
---@param options? MeshShapeOptions
---@return Shape
function shape.mesh(vertices, faces, options) end
---Heights over a grid in x and z, solid below. It does not move, so no body can have it.
---```lua
---scene:ground { shape = shape.heights { columns = 20, rows = 20, spacing = 0.5,
---  height = function(x, z) return -9 + 0.1 * x * x end } }
---```
---@param options HeightsShapeOptions
---@return Shape
function shape.heights(options) end

---@type Scene
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
