---@meta
-- Written by `pantin meta` from the tables of the bindings; do not edit. In brackets: units.

---@class vec
---@field x number
---@field y number
---@field z number
---@operator add(vec): vec
---@operator sub(vec): vec
---@operator unm: vec
---@operator mul(number): vec
---@operator div(number): vec
local vec_methods = {}
---@param other vec
---@return number
function vec_methods:dot(other) end
---@param other vec
---@return vec
function vec_methods:cross(other) end
---@return number
function vec_methods:length() end
---@return vec
function vec_methods:normalized() end

---@class quat
---@field w number
---@field x number
---@field y number
---@field z number
---@operator mul(quat): quat
local quat_methods = {}
---@param v vec
---@return vec
function quat_methods:rotate(v) end
---@return quat
function quat_methods:inverse() end

---@alias color string|number[] "#rgb", "#rrggbb", "#rrggbbaa" or { r, g, b, a } of 0 to 1
---@alias Thing Point|Particle|Body|Nail|Follow|Rod|Group

---@class Energy
---@field kinetic number [J]
---@field potential number [J]
---@field total number [J]

---@class Accuracy
---@field hinge_gap number [m]
---@field constraint number [m]
---@field energy number relative
---@field worst_hinge_gap number [m]
---@field worst_constraint number [m]
---@field worst_energy number relative

---@class Stats
---@field steps integer
---@field articulates integer
---@field newton_iterations integer
---@field worst_iterations integer
---@field solves integer
---@field factorisations integer
---@field halved_steps integer
---@field safe_steps integer
---@field projections integer
---@field ns table<string, number> [ns] per phase

---@class LogLine
---@field time number [s]
---@field kind string
---@field text string

---@class Camera
---@field at? vec [m]
---@field look_at? vec [m]
---@field follow? Thing

---@class ParamOptions
---@field min? number
---@field max? number
---@field step? number
---@field help? string
---@field choices? any[]
---@field on_change? fun(value: any)

---@class ParticleOptions
---@field at? vec [m]
---@field velocity? vec [m/s]
---@field mass? number [kg]
---@field radius? number [m]
---@field color? color
---@field lifetime? number [s]
---@field name? string

---@class PointOptions
---@field at? vec [m]
---@field mass? number [kg]
---@field radius? number [m]
---@field color? color

---@class BodyOptions
---@field points? table<integer|string, vec|PointOptions>
---@field at? vec [m]
---@field orientation? quat
---@field velocity? vec [m/s]
---@field spin? vec [rad/s]
---@field mass? number [kg]
---@field inertia? vec|table [kg m²]
---@field color? color
---@field name? string

---@class HingeOptions
---@field color? color
---@field radius? number [m]
---@field lifetime? number [s]
---@field name? string

---@class TieOptions
---@field time_constant? number [s]
---@field name? string

---@class FollowOptions: TieOptions
---@field max_force? number [N]

---A point mass. It belongs to at most one body, and always to one particle.
---@class Point
---@field position vec [m] place in the world; written only where the point is free
---@field velocity vec [m/s] velocity in the world; written only where the point is free
---@field mass number [kg] mass; 0 only in a body, as an anchor
---@field color color color
---@field radius number [m] drawn size; 0: the window chooses
---@field body Body? the body it belongs to, or nil (read only)
---@field particle Particle the particle it is in now: its own, or a hinge (read only)
---@field name string what messages and scene:find call it
---@field alive boolean whether it still exists (read only)
---@field data table a table of yours, which goes with the thing (read only)
local Point = {}
---Pulls for the coming step.
---@param force vec [N]
function Point:push(force) end
---Changes the velocity at once.
---@param impulse vec [N s]
function Point:kick(impulse) end
---Takes it out of the world.
function Point:remove() end

---A ring of one or more points. One point: an ordinary particle. More: a hinge, whose points coincide.
---@class Particle
---@field position vec [m] place in the world; written only of a free particle
---@field velocity vec [m/s] velocity in the world; written only of a free particle
---@field mass number [kg] mass; of a hinge its points' sum, which is not written
---@field lifetime number [s] goes when its age reaches this; a hinge is cut; math.huge: never
---@field age number [s] time since it was made (read only)
---@field color color color; overrides its points'
---@field radius number [m] drawn size; overrides its points'
---@field points Point[] its points, in the order of joining (read only)
---@field bodies Body[] the bodies of its points (read only)
---@field is_hinge boolean whether it joins two points or more (read only)
---@field name string what messages and scene:find call it
---@field alive boolean whether it still exists (read only)
---@field data table a table of yours, which goes with the thing (read only)
local Particle = {}
---Pulls for the coming step.
---@param force vec [N]
function Particle:push(force) end
---Changes the velocity at once.
---@param impulse vec [N s]
function Particle:kick(impulse) end
---Frees all members of a hinge, or those of one body.
---@param body? Body
function Particle:cut(body) end
---Force [N] of a hinge on one of its bodies in the last step.
---@param body Body
---@return vec
function Particle:force(body) end
---Takes it out of the world.
function Particle:remove() end

---Points at fixed relative places: rigid. Its named points are fields: link.head.
---@class Body
---@field position vec [m] place of the centre of mass
---@field velocity vec [m/s] velocity of the centre of mass
---@field origin vec [m] place of its frame
---@field orientation quat turns its frame to the world
---@field spin vec [rad/s] angular velocity, world axes
---@field momentum vec [kg m/s] mass times velocity (read only)
---@field angular_momentum vec [kg m²/s] about its centre of mass, world axes (read only)
---@field mass number [kg] its points' and its own
---@field inertia vec|table [kg m²] its points' and its own about the frame's origin, in the frame's axes: vec of the diagonal, or { xx, yy, zz, xy, xz, yz }
---@field points Point[] its points, in the order of making (read only)
---@field hinges Particle[] the hinges that its points are in (read only)
---@field color color color of its first point; writing gives it to all
---@field name string what messages and scene:find call it
---@field alive boolean whether it still exists (read only)
---@field data table a table of yours, which goes with the thing (read only)
---@field [string] Point its named points
local Body = {}
---Pulls for the coming step, at its centre or at a place of the world.
---@param force vec [N]
---@param at? vec [m]
function Body:push(force, at) end
---Changes the velocity at once.
---@param impulse vec [N s]
---@param at? vec [m]
function Body:kick(impulse, at) end
---Turns for the coming step.
---@param torque vec [N m]
function Body:twist(torque) end
---Adds a point: a vec in its frame, or { at, mass, color, radius, name }.
---@param point vec|table [m]
---@return Point
function Body:add_point(point) end
---Takes a point off.
---@param point Point
function Body:remove_point(point) end
---Takes it out of the world.
function Body:remove() end

---Keeps a point at a place of the world.
---@class Nail
---@field point Point the point that it holds (read only)
---@field at vec [m] the place; the point is drawn to a new one
---@field force vec [N] what it exerted on its point in the last step (read only)
---@field enabled boolean whether it acts
---@field name string what messages and scene:find call it
---@field alive boolean whether it still exists (read only)
---@field data table a table of yours, which goes with the thing (read only)
local Nail = {}
---Takes it out of the world.
function Nail:remove() end

---Keeps a point to a moving target; with max_force it never pulls harder.
---@class Follow
---@field point Point the point that it holds (read only)
---@field target vec [m] where the target is; written as a vec or a function of time [s]
---@field max_force number [N] never pulls harder; math.huge: no limit
---@field force vec [N] what it exerted on its point in the last step (read only)
---@field enabled boolean whether it acts
---@field name string what messages and scene:find call it
---@field alive boolean whether it still exists (read only)
---@field data table a table of yours, which goes with the thing (read only)
local Follow = {}
---Takes it out of the world.
function Follow:remove() end

---Keeps two points, or a point and a place, at a distance.
---@class Rod
---@field a Point its first point (read only)
---@field b Point? its second point, or nil where that end is a place (read only)
---@field at vec [m] place of its second end; written where no point is there
---@field length number [m] the distance that it keeps
---@field force number [N] tension in the last step, > 0 when it pulls (read only)
---@field enabled boolean whether it acts
---@field name string what messages and scene:find call it
---@field alive boolean whether it still exists (read only)
---@field data table a table of yours, which goes with the thing (read only)
local Rod = {}
---Takes it out of the world.
function Rod:remove() end

---A named set of things. It is gone when no member lives.
---@class Group
---@field energy Energy [J] { kinetic, potential, total } of its things (read only)
---@field momentum vec [kg m/s] sum over its things (read only)
---@field angular_momentum vec [kg m²/s] sum over its things about the world's origin (read only)
---@field temperature number [K] of its things, relative to their common motion; in J while scene.boltzmann is 1 (read only)
---@field mass number [kg] sum over its things (read only)
---@field name string what messages and scene:find call it
---@field alive boolean whether it still exists (read only)
---@field data table a table of yours, which goes with the thing (read only)
local Group = {}
---Adds things; returns the group.
---@param thing Thing
---@param ... Thing
---@return Group
function Group:add(thing, ...) end
---Takes things out of the set; without any, ends the set.
---@param thing? Thing
---@param ... Thing
function Group:remove(thing, ...) end
---For loops: for thing in g:each() do … end. Goes over a copy and leaves out what died.
---@return fun(): Thing?
function Group:each() end
---Cuts the hinges in the group and those between its bodies.
function Group:cut_hinges() end
---Lower and upper corner [m] of the box round all its points.
---@return vec
---@return vec
function Group:bounds() end
---Lists of what is within the distance of another member, biggest first.
---@param distance number [m]
---@return Thing[][]
function Group:clusters(distance) end

---Something set to happen.
---@class Event
---@field state string "waiting", "fired", "dropped" or "cancelled" (read only)
local Event = {}
---Takes it out of the choreography; one that fired stays as it is.
function Event:cancel() end

---What can grab: the mouse, a finger, a stick, a script's.
---@class Hand
---@field position vec [m] place in the world (read only)
---@field velocity vec [m/s] velocity over the last step (read only)
---@field pressed boolean whether its button is down (read only)
local Hand = {}
---Takes hold of a point with at most max_force [N]; lets go of what it held.
---@param point Point
---@param options? { max_force: number }
function Hand:grab(point, options) end
---Lets go.
function Hand:release() end

---A function that scene:on calls.
---@class Subscription
local Subscription = {}
---The function is called no more.
function Subscription:cancel() end

---The scene that is being run.
---@class Scene
---@field title string what the window and the pictures are called
---@field duration number? [s] end of a headless run
---@field pace number simulated s per real s
---@field camera Camera { at [m], look_at [m], follow = thing }
---@field store table plain values of yours
---@field gravity vec [m/s²] uniform acceleration
---@field step number [s] length of one step
---@field integrator string "verlet", or "euler" (the paper's)
---@field energy_return boolean give back what the velocity projection took
---@field tolerance number points of a new hinge may be this far apart, relative to the size of their bodies
---@field seed integer of math.random
---@field boltzmann number [J/K] k_B; temperature is in J while it is 1
---@field time number [s] simulated time (read only)
---@field energy Energy [J] { kinetic, potential, total } (read only)
---@field momentum vec [kg m/s] sum over all things (read only)
---@field angular_momentum vec [kg m²/s] sum over all things about the world's origin (read only)
---@field temperature number [K] relative to the common motion; in J while scene.boltzmann is 1 (read only)
---@field error Accuracy { hinge_gap [m], constraint [m], energy (relative) } now, and worst_… since the start (read only)
---@field stats Stats counts since the start, and ns per phase (read only)
---@field log LogLine[] { time [s], kind, text } of all that was logged (read only)
---@field bodies Body[] all bodies, in the order of making (read only)
---@field particles Particle[] all particles that are no hinges, and do not sleep in one (read only)
---@field hinges Particle[] all hinges (read only)
---@field connections table all connections (read only)
---@field hands Hand[] the mouse, fingers, sticks, and scripted hands (read only)
local Scene = {}
---Makes a free particle of one point.
---@param options? ParticleOptions
---@return Particle
function Scene:particle(options) end
---Makes a rigid body.
---@param options BodyOptions
---@return Body
function Scene:body(options) end
---Joins points of two or more bodies, or free particles, into one particle.
---@param a Point|Particle
---@param b Point|Particle
---@param ... Point|Particle|HingeOptions
---@return Particle
function Scene:hinge(a, b, ...) end
---Keeps a point at a place, or where it is.
---@param point Point|Particle
---@param at? vec|TieOptions [m]
---@param options? TieOptions
---@return Nail
function Scene:nail(point, at, options) end
---Keeps a point to a target: a place [m], a function of time [s] or a hand.
---@param point Point|Particle
---@param target vec|Hand|fun(t: number): vec
---@param options? FollowOptions
---@return Follow
function Scene:follow(point, target, options) end
---Keeps two points, or a point and a place, at a distance, or at their present one.
---@param a Point|Particle|vec
---@param b Point|Particle|vec
---@param length? number [m]
---@return Rod
function Scene:rod(a, b, length) end
---Makes a named set of things.
---@param name string
---@return Group
function Scene:group(name) end
---The oldest living thing of that name.
---@param name string
---@return Thing?
function Scene:find(name) end
---Particles within a radius, nearest first.
---@param at vec [m]
---@param radius number [m]
---@return Particle[]
function Scene:near(at, radius) end
---Makes a hand; with a path, place [m] of time [s], it moves by itself.
---@param options? { path: fun(t: number): vec }
---@return Hand
function Scene:hand(options) end
---Declares a parameter and returns its value.
---@param name string
---@param default any
---@param options? ParamOptions
---@return any
function Scene:param(name, default, options) end
---Does it once, in the step that reaches the time.
---@param time number [s]
---@param target_or_action Thing|function
---@param action? function
---@return Event
function Scene:at(time, target_or_action, action) end
---Does it once, a while from now.
---@param delay number [s]
---@param target_or_action Thing|function
---@param action? function
---@return Event
function Scene:after(delay, target_or_action, action) end
---Does it again and again.
---@param period number [s]
---@param target_or_action Thing|function
---@param action? function
---@return Event
function Scene:every(period, target_or_action, action) end
---Calls a function at each "step" (dt), "press" "release" (hand), "key" (name), "grab" "drop" (thing, hand), "cut" (hinge), "removed" (thing, story).
---@param moment string
---@param action function
---@return Subscription
function Scene:on(moment, action) end
---Puts a button in the window.
---@param name string
---@param action function
function Scene:button(name, action) end
---Records a number each step.
---@param name string
---@param read fun(): number
function Scene:probe(name, read) end
---Puts a value into the summary.
---@param name string
---@param value number|boolean|string
function Scene:result(name, value) end
---Ends the run.
function Scene:finish() end

---A scene that a test opened.
---@class OpenedScene
---@field time number [s] simulated time (read only)
---@field energy Energy [J] { kinetic, potential, total } (read only)
---@field momentum vec [kg m/s] sum over all things (read only)
---@field angular_momentum vec [kg m²/s] sum over all things about the world's origin (read only)
---@field temperature number [K] relative to the common motion; in J while scene.boltzmann is 1 (read only)
---@field error Accuracy { hinge_gap [m], constraint [m], energy (relative) } now, and worst_… since the start (read only)
---@field stats Stats counts since the start, and ns per phase (read only)
---@field log LogLine[] { time [s], kind, text } of all that was logged (read only)
---@field bodies Body[] all bodies, in the order of making (read only)
---@field particles Particle[] all particles that are no hinges, and do not sleep in one (read only)
---@field hinges Particle[] all hinges (read only)
---@field connections table all connections (read only)
---@field finished boolean whether it called scene:finish() (read only)
local OpenedScene = {}
---Steps on for a time.
---@param seconds number [s]
function OpenedScene:advance(seconds) end
---Does one step.
function OpenedScene:step() end
---The present number of a probe.
---@param name string
---@return number
function OpenedScene:read(name) end
---A result that the scene gave.
---@param name string
---@return number|boolean|string
function OpenedScene:result(name) end
---The oldest living thing of that name.
---@param name string
---@return Thing?
function OpenedScene:find(name) end
---Particles within a radius, nearest first.
---@param at vec [m]
---@param radius number [m]
---@return Particle[]
function OpenedScene:near(at, radius) end

---@type Scene
scene = nil

---@param x number
---@param y number
---@param z number
---@return vec
function vec(x, y, z) end

---@param axis vec
---@param angle number [rad]
---@return quat
function quat(axis, angle) end

---@param file string
---@return table[] rows by column number and by column name
function read_table(file) end

---@class Expectation
local Expectation = {}
---@param value number|vec
---@param tolerance number
function Expectation:near(value, tolerance) end
---@param value number
function Expectation:below(value) end
---@param value number
function Expectation:above(value) end
---@param value any
function Expectation:equal(value) end
function Expectation:is_true() end
---@param text string
function Expectation:fails(text) end

---@param name string
---@param body function
function test(name, body) end
---@param value any
---@return Expectation
function expect(value) end
---@param path string
---@param params? table<string, any>
---@return OpenedScene
function open(path, params) end
---@param source string
---@param params? table<string, any>
---@return OpenedScene
function open_text(source, params) end
