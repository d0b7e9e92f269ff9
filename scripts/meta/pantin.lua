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
---@alias Look "ball"|"glow"|"streak"
---@alias Curve<T> T|fun(age: number, life: number): T
---@alias Thing Point|Particle|Body|Nail|Follow|Rod|Group|Family|Connection|Interaction|Field|Emitter

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

---@class Ledger
---@field laws table<string, number> [J] given to the motion by each law with energy
---@field without_energy string[] names of the laws at work that have no energy
---@field open number [J] work of those of them that do not depend on velocities
---@field hand number [J] by hands, follows, moving anchors and lengths, and pushes on what is tied
---@field motor number [J] by motors, and turns and angles that follow a function of time
---@field limit number [J] by limits, and by all that ties what strikes one
---@field event number [J] by kicks, and pushes on what is loose
---@field edit number [J] by things made and changed
---@field merge number [J] lost by what became one body
---@field emitter number [J] by particles that emitters made
---@field removal number [J] by things removed
---@field damper number [J] by laws that depend on velocities (dampers, drag, wind, thermostats) but for those that do no work by it, as v × B, and what springs swallow that are solved at the end of the step
---@field law_edit number [J] by laws made, changed and removed, and attributes that follow an age
---@field sleep number [J] that articulates still had which fell asleep
---@field projection number [J] taken by the projection of velocities, since it is kept
---@field energy_return number [J] given back of that
---@field fallback_step number [J] taken by fallback steps, since it is kept
---@field integrator number [J] that the integrators euler and rk4 gave by being inexact, since it is kept
---@field unsolved number [J] of forces on what the iteration left open within its tolerance, since it is kept
---@field since number? [s] when all began to be kept; nil, and so the fields below: not yet
---@field gravity number? [J] given to the motion since then
---@field closure number? what no line explains of the kinetic energy, relative to all lines: a test of the program
---@field truncation table<string, number>? [J] error of the steps for each law and gravity: change of its energy, and what it gave; of laws without energy, together: what they gave beyond a second estimate along the way

---@class Stats
---@field steps integer
---@field articulates integer
---@field asleep integer of them, which rest until something moves them
---@field newton_iterations integer
---@field worst_iterations integer
---@field solves integer
---@field factorisations integer
---@field halved_steps integer
---@field fallback_steps integer
---@field rejected_steps integer steps that were done again with more sub-steps, as `scene.accuracy` wants
---@field missed_accuracy number largest error where not even the most sub-steps gave what `scene.accuracy` wants, in its unit; 0 where none was missed
---@field projections integer
---@field sub_steps integer of the whole scene in its last step, as `scene.accuracy` wants
---@field most_sub_steps integer the most of any body or articulate, those of the scene included
---@field most_sub_steps_of string that body, or the first of that articulate; "" where all take as many
---@field ns table<string, number> [ns] per phase

---@class LogLine
---@field time number [s]
---@field kind string
---@field text string

---@alias Waiting fun(what?: number|fun(): boolean) [s]

---@class Condition one limit, and what it is of: the whole scene unless given
---@field temperature_above? number [K]
---@field temperature_below? number [K]
---@field energy_above? number [J]
---@field energy_below? number [J]
---@field force_above? number [N] of a hinge, constraint or connection
---@field force_below? number [N]
---@field distance_above? number [m] of a list of two things or places
---@field distance_below? number [m]
---@field count_above? number of a group or family
---@field count_below? number
---@field of? Thing|Scene|(Thing|vec)[]

---@class JoinOptions
---@field at? vec [m] where they meet
---@field time_constant? number [s]
---@field max_force? number [N]
---@field on_met? fun(hinge: Particle)
---@field name? string of the hinge

---@class Behaviour { target, options } are fields of self
---@field start? fun(self: table)
---@field step? fun(self: table, dt: number)
---@field stop? fun(self: table)

---@class BondingOptions
---@field families Family|Family[] one, or two
---@field near number [m] at most so far apart
---@field below number [K] bonds are made
---@field above number [K] bonds break
---@field law? Law of the connections that are made; this or hinge
---@field implicit? boolean|string of those connections, as in connect
---@field hinge? boolean what is near is joined to a hinge
---@field time_constant? number [s] of that

---@class WhenOptions
---@field mean? number [s] over which the measure is averaged
---@field again? boolean at each crossing
---@field hysteresis? number how far back beyond the limit before it may cross again

---@class TimelineEntry
---@field kind "at"|"every"|"over"|"when"|"play"
---@field state "waiting"|"fired"|"dropped"|"cancelled"
---@field time? number [s] when it ended, or is due next; nil of what waits for something that holds
---@field from? number [s] of an over
---@field to? number [s] of an over
---@field period? number [s] of an every
---@field fired integer how often so far
---@field label string where it was set
---@field target? string

---@class LineOptions
---@field color? color
---@field width? number [px]
---@field space? "scene"|"screen"

---@class MarkOptions
---@field color? color
---@field size? number [px] diameter of a point, height of letters
---@field space? "scene"|"screen"

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
---@field radius? Curve<number> [m]
---@field color? Curve<color>
---@field look? Look
---@field family? Family
---@field lifetime? number [s]
---@field name? string
---@field [string] Curve<number> attributes of its family

---@class FamilyOptions
---@field attributes? table<string, Curve<number>>|string[] values of a particle that gives none
---@field color? Curve<color>
---@field radius? Curve<number> [m]
---@field mass? number [kg]
---@field look? Look

---@class EmitterOptions
---@field rate number|fun(t: number): number [1/s]
---@field at? vec|vec[]|Point|Particle [m] a place, a box { vec, vec }, or what carries it
---@field velocity? vec [m/s]
---@field spread? number [rad]
---@field lifetime? number|{ min: number, max: number } [s]
---@field max? integer
---@field family? Family
---@field mass? number [kg]
---@field radius? Curve<number> [m]
---@field color? Curve<color>
---@field look? Look
---@field enabled? boolean
---@field name? string
---@field [string] Curve<number> attributes of its family

---@class PointOptions
---@field at? vec [m]
---@field mass? number [kg]
---@field radius? number [m]
---@field color? color
---@field family? Family

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
---@field family? Family
---@field axis? vec the bodies given here turn about it only, against each other; world axes
---@field breaks_at? table { force [N], torque [N m] }
---@field name? string

---@class TieOptions
---@field time_constant? number [s]
---@field name? string

---@class FollowOptions: TieOptions
---@field max_force? number [N]

---@class ConstraintOptions
---@field name? string
---@field breaks_at? table { force [N], torque [N m], length [m] }

---@class OrientOptions: ConstraintOptions
---@field time_constant? number [s]

---@class AlignOptions: OrientOptions
---@field angle? number|fun(t: number): number [rad]

---@class MotorOptions: OrientOptions
---@field axis? vec world axes; in a plane (scene.plane) its normal, unless given
---@field speed? number|fun(t: number): number [rad/s]
---@field angle? number|fun(t: number): number [rad]
---@field max_torque? number [N m]

---@class LimitOptions: OrientOptions
---@field axis? vec of an angle; world axes, in a plane its normal unless given
---@field min? number [rad] or [m]
---@field max? number [rad] or [m]
---@field length? number [m] of a distance, the same as max

---@class StringOptions: OrientOptions
---@field length? number|fun(t: number): number [m]

---@class PathOptions: OrientOptions
---@field smooth? boolean a spline with continuous curvature; else straight pieces
---@field closed? boolean

---@alias BuildForm "deformable"|"rigid"|"articulated"|"panels"

---@class BuildForms what each vertex, edge or face becomes
---@field vertices? fun(at: vec, number: integer): BuildForm? deformable or rigid
---@field edges? fun(a: vec, b: vec, number: integer): BuildForm? deformable, rigid or articulated
---@field faces? fun(middle: vec, number: integer): BuildForm? deformable, rigid or panels

---@class BuildOptions
---@field as BuildForm|BuildForms|fun(at: vec, number: integer): BuildForm? a function alone is of vertices
---@field law? Law on edges that are not within a body
---@field laws? { edge?: Law, angle?: Law, torsion?: Law }
---@field mass? number [kg] of all; 1 unless given
---@field mass_in? "points"|"edges"|"faces"|"solid" edges if articulated, faces of panels, else points
---@field at? vec [m] place of the structure's origin
---@field velocity? vec [m/s]
---@field family? Family
---@field color? color
---@field radius? number [m]
---@field axis? vec hinges turn about it only; world axes
---@field name? string

---@class PlaneOptions: OrientOptions
---@field through? vec [m]
---@field normal? vec

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
---@field family Family? its family, whose attributes are fields of it: p.charge
---@field lifetime number [s] goes at the beginning of the first step at which its age has reached this; a hinge is cut; math.huge: never
---@field age number [s] time since it was made (read only)
---@field color color|fun(age: number, life: number): color color, or a function of age and lifetime [s]; overrides its points'
---@field radius number|fun(age: number, life: number): number [m] size, or a function of age and lifetime [s]; overrides its points'
---@field look string "ball", "glow" (a soft disc of light) or "streak" (a line of light along its velocity)
---@field points Point[] its points, in the order of joining (read only)
---@field bodies Body[] the bodies of its points (read only)
---@field enabled boolean of a hinge: whether its points stay together
---@field breaks_at table of a hinge: { force [N], torque [N m] } at which it breaks
---@field is_hinge boolean whether it joins two points or more (read only)
---@field name string what messages and scene:find call it
---@field alive boolean whether it still exists (read only)
---@field data table a table of yours, which goes with the thing (read only)
---@field [string] number attributes of its family
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
---@field inertia vec|table [kg m²] its points' and its own about the frame's origin, in the frame's axes: vec of the diagonal, or { xx, yy, zz, xy, xz, yz }. Tied, a body moves with no principal moment below 1e-4 of the largest, and a warning says so
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
---@field force vec [N] what it exerted on its first point in the last step (read only)
---@field breaks_at table { force [N], torque [N m], length [m] } at which it breaks, within a step where its load passes that; a weld's torque is about the middle between the two centres of mass
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
---@field force vec [N] what it exerted on its first point in the last step (read only)
---@field breaks_at table { force [N], torque [N m], length [m] } at which it breaks, within a step where its load passes that; a weld's torque is about the middle between the two centres of mass
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
---@field length number [m] the distance that it keeps; written as a number or a function of time [s]
---@field force number [N] tension in the last step, > 0 when it pulls (read only)
---@field breaks_at table { force [N], torque [N m], length [m] } at which it breaks, within a step where its load passes that; a weld's torque is about the middle between the two centres of mass
---@field enabled boolean whether it acts
---@field name string what messages and scene:find call it
---@field alive boolean whether it still exists (read only)
---@field data table a table of yours, which goes with the thing (read only)
local Rod = {}
---Takes it out of the world.
function Rod:remove() end

---Keeps two bodies in their relative place and orientation.
---@class Weld
---@field a Body its first body (read only)
---@field b Body? its second body, or nil for the world (read only)
---@field force vec [N] what it exerted on its first point in the last step (read only)
---@field torque vec [N m] what it exerted on its first body in the last step; a weld's is about the middle between the centres of mass (read only)
---@field breaks_at table { force [N], torque [N m], length [m] } at which it breaks, within a step where its load passes that; a weld's torque is about the middle between the two centres of mass
---@field enabled boolean whether it acts
---@field name string what messages and scene:find call it
---@field alive boolean whether it still exists (read only)
---@field data table a table of yours, which goes with the thing (read only)
local Weld = {}
---Takes it out of the world.
function Weld:remove() end

---Keeps the orientation of a body.
---@class Orient
---@field a Body its first body (read only)
---@field to quat the orientation; written as a quat or a function of time [s]; the body is drawn to a new one
---@field torque vec [N m] what it exerted on its first body in the last step; a weld's is about the middle between the centres of mass (read only)
---@field breaks_at table { force [N], torque [N m], length [m] } at which it breaks, within a step where its load passes that; a weld's torque is about the middle between the two centres of mass
---@field enabled boolean whether it acts
---@field name string what messages and scene:find call it
---@field alive boolean whether it still exists (read only)
---@field data table a table of yours, which goes with the thing (read only)
local Orient = {}
---Takes it out of the world.
function Orient:remove() end

---Keeps the angle between an axis of a body and one of another.
---@class Align
---@field a Body its first body (read only)
---@field b Body? its second body, or nil for the world (read only)
---@field angle number [rad] the angle, 0 to π; written as a number or a function of time [s]
---@field torque vec [N m] what it exerted on its first body in the last step; a weld's is about the middle between the centres of mass (read only)
---@field breaks_at table { force [N], torque [N m], length [m] } at which it breaks, within a step where its load passes that; a weld's torque is about the middle between the two centres of mass
---@field enabled boolean whether it acts
---@field name string what messages and scene:find call it
---@field alive boolean whether it still exists (read only)
---@field data table a table of yours, which goes with the thing (read only)
local Align = {}
---Takes it out of the world.
function Align:remove() end

---Turns a body about an axis, against another or the world.
---@class Motor
---@field a Body its first body (read only)
---@field b Body? its second body, or nil for the world (read only)
---@field speed number [rad/s] of a against b, where it keeps that; a number or a function of time [s]; a step, or a sub-step, turns by 2 atan(speed step / 2), as it turns what spins freely
---@field angle number [rad] that it keeps, where it does; a number or a function of time [s]
---@field turned number [rad] the angle of a against b now, turns counted (read only)
---@field max_torque number [N m] never pushes harder; math.huge: no limit
---@field torque vec [N m] what it exerted on its first body in the last step; a weld's is about the middle between the centres of mass (read only)
---@field breaks_at table { force [N], torque [N m], length [m] } at which it breaks, within a step where its load passes that; a weld's torque is about the middle between the two centres of mass
---@field enabled boolean whether it acts
---@field name string what messages and scene:find call it
---@field alive boolean whether it still exists (read only)
---@field data table a table of yours, which goes with the thing (read only)
local Motor = {}
---Takes it out of the world.
function Motor:remove() end

---Keeps an angle about an axis, or a distance, in a range.
---@class Limit
---@field min number least angle [rad] or distance [m]
---@field max number greatest angle [rad] or distance [m]
---@field value number the angle [rad] or distance [m] now (read only)
---@field force vec [N] what it exerted on its first point in the last step (read only)
---@field torque vec [N m] what it exerted on its first body in the last step; a weld's is about the middle between the centres of mass (read only)
---@field breaks_at table { force [N], torque [N m], length [m] } at which it breaks, within a step where its load passes that; a weld's torque is about the middle between the two centres of mass
---@field enabled boolean whether it acts
---@field name string what messages and scene:find call it
---@field alive boolean whether it still exists (read only)
---@field data table a table of yours, which goes with the thing (read only)
local Limit = {}
---Takes it out of the world.
function Limit:remove() end

---Keeps a point on a plane.
---@class OnPlane
---@field point Point the point that it holds (read only)
---@field through vec [m] a place on the plane; the point is drawn to a new one
---@field normal vec across the plane, of unit length
---@field force vec [N] what it exerted on its first point in the last step (read only)
---@field breaks_at table { force [N], torque [N m], length [m] } at which it breaks, within a step where its load passes that; a weld's torque is about the middle between the two centres of mass
---@field enabled boolean whether it acts
---@field name string what messages and scene:find call it
---@field alive boolean whether it still exists (read only)
---@field data table a table of yours, which goes with the thing (read only)
local OnPlane = {}
---Takes it out of the world.
function OnPlane:remove() end

---Is at most so long along its points; slides through the inner ones.
---@class String
---@field points table what it goes through: points, or places [m] (read only)
---@field length number [m] the most that it is long; written as a number or a function of time [s]
---@field taken number [m] how long its way is now: less than its length where it is slack (read only)
---@field force number [N] tension in the last step, 0 where it is slack (read only)
---@field breaks_at table { force [N], torque [N m], length [m] } at which it breaks, within a step where its load passes that; a weld's torque is about the middle between the two centres of mass
---@field enabled boolean whether it acts
---@field name string what messages and scene:find call it
---@field alive boolean whether it still exists (read only)
---@field data table a table of yours, which goes with the thing (read only)
local String = {}
---Takes it out of the world.
function String:remove() end

---Keeps a point on a path.
---@class OnPath
---@field point Point the point that it holds (read only)
---@field path vec[] [m] the places that the path goes through (read only)
---@field along number where on the path the point is: 0 at the first place, 1 at the second, and so on (read only)
---@field force vec [N] what it exerted on its first point in the last step (read only)
---@field breaks_at table { force [N], torque [N m], length [m] } at which it breaks, within a step where its load passes that; a weld's torque is about the middle between the two centres of mass
---@field enabled boolean whether it acts
---@field name string what messages and scene:find call it
---@field alive boolean whether it still exists (read only)
---@field data table a table of yours, which goes with the thing (read only)
local OnPath = {}
---Takes it out of the world.
function OnPath:remove() end

---Draws two points together, to join them into a hinge.
---@class Join
---@field a Point the first point (read only)
---@field b Point the second point (read only)
---@field max_force number [N] it never pulls harder; math.huge: no limit (read only)
---@field force vec [N] what it exerted on its first point in the last step (read only)
---@field breaks_at table { force [N], torque [N m], length [m] } at which it breaks, within a step where its load passes that; a weld's torque is about the middle between the two centres of mass
---@field enabled boolean whether it acts
---@field name string what messages and scene:find call it
---@field alive boolean whether it still exists (read only)
---@field data table a table of yours, which goes with the thing (read only)
local Join = {}
---Takes it out of the world.
function Join:remove() end

---A named set of things. It is gone when no member lives.
---@class Group
---@field energy Energy [J] { kinetic, potential, total } of its things (read only)
---@field momentum vec [kg m/s] sum over its things (read only)
---@field angular_momentum vec [kg m²/s] sum over its things about the world's origin (read only)
---@field temperature number [K] of its things, relative to their common motion; in J while scene.boltzmann is 1 (read only)
---@field mass number [kg] sum over its things (read only)
---@field particles Particle[] its particles, in the order of adding; of a built structure one for each vertex (read only)
---@field bodies Body[] its bodies, in the order of adding (read only)
---@field hinges Particle[] those of its particles that are hinges (read only)
---@field connections Connection[] its connections, in the order of adding (read only)
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
---Removes the connections in the group and those among its things.
function Group:break_connections() end
---Adds kinetic energy relative to the common motion; a negative one cools.
---@param energy number [J]
function Group:heat(energy) end
---Lower and upper corner [m] of the box round all its points.
---@return vec
---@return vec
function Group:bounds() end
---Lists of what is within the distance of another member, biggest first.
---@param distance number [m]
---@return Thing[][]
function Group:clusters(distance) end

---Particles of a kind, with named numeric attributes that laws read.
---@class Family
---@field attributes table<string, number> values of a particle that gives none (read only)
---@field particles Particle[] its living particles, in the order of making (read only)
---@field energy Energy [J] { kinetic, potential, total } of its things (read only)
---@field momentum vec [kg m/s] sum over its things (read only)
---@field angular_momentum vec [kg m²/s] sum over its things about the world's origin (read only)
---@field temperature number [K] of its things, relative to their common motion; in J while scene.boltzmann is 1 (read only)
---@field mass number [kg] sum over its things (read only)
---@field name string what messages and scene:find call it
---@field alive boolean whether it still exists (read only)
---@field data table a table of yours, which goes with the thing (read only)
local Family = {}
---Takes it out of the world.
function Family:remove() end

---Ties two, three or four particles by a law.
---@class Connection
---@field particles table what it ties: particles, or places [m] (read only)
---@field force number [N] tension in the last step, positive where it pulls; 0 of a law of three or four (read only)
---@field breaks_at table { force [N], length [m] } at which it breaks
---@field parameters table<string, number> of its law: read and written by name (read only)
---@field energy number? [J] of its law now; nil where the law has none (read only)
---@field enabled boolean whether it acts
---@field name string what messages and scene:find call it
---@field alive boolean whether it still exists (read only)
---@field data table a table of yours, which goes with the thing (read only)
local Connection = {}
---Takes it out of the world.
function Connection:remove() end

---A law between all pairs of two families, or within one.
---@class Interaction
---@field parameters table<string, number> of its law: read and written by name (read only)
---@field energy number? [J] of its law now; nil where the law has none (read only)
---@field enabled boolean whether it acts
---@field name string what messages and scene:find call it
---@field alive boolean whether it still exists (read only)
---@field data table a table of yours, which goes with the thing (read only)
local Interaction = {}
---Takes it out of the world.
function Interaction:remove() end

---A law on each particle of a family, of a group or of the scene.
---@class Field
---@field parameters table<string, number> of its law: read and written by name (read only)
---@field energy number? [J] of its law now; nil where the law has none (read only)
---@field enabled boolean whether it acts
---@field name string what messages and scene:find call it
---@field alive boolean whether it still exists (read only)
---@field data table a table of yours, which goes with the thing (read only)
local Field = {}
---Takes it out of the world.
function Field:remove() end

---Makes particles at a rate.
---@class Emitter
---@field at vec|vec[]|Point [m] where particles begin: a place, a box { vec, vec }, or a point that carries it
---@field rate number|fun(t: number): number [1/s] particles per second; read: of the last step
---@field velocity vec [m/s] relative to the point that carries it
---@field spread number [rad] half angle of the cone of velocities
---@field lifetime number|table [s] of its particles, or { min, max } between which it is random
---@field max number particles of it that may live at once
---@field enabled boolean whether it makes particles
---@field family Family? of its particles (read only)
---@field count integer how many of its particles live (read only)
---@field made integer how many it has made (read only)
---@field name string what messages and scene:find call it
---@field alive boolean whether it still exists (read only)
---@field data table a table of yours, which goes with the thing (read only)
local Emitter = {}
---Takes it out of the world.
function Emitter:remove() end

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

---A function that scene:on calls, or a behaviour.
---@class Subscription
local Subscription = {}
---The function is called no more; a behaviour is stopped.
function Subscription:cancel() end

---Vertices, edges and faces: a value, which does not change.
---@class Structure
---@field vertices vec[] [m] places (read only)
---@field edges integer[][] pairs of numbers of vertices (read only)
---@field faces integer[][] lists of numbers of vertices, counter-clockwise seen from outside (read only)
---@field elements string[] chemical element of each vertex of a molecule; else empty (read only)
---@field euler integer vertices - edges + faces (read only)
---@field area number? [m²] of all faces; nil without any (read only)
---@field volume number? [m³] inside of a closed surface; nil of another (read only)
local Structure = {}
---Times larger, alike or along each axis.
---@param factor number|vec
---@return Structure
function Structure:scale(factor) end
---Turned about the origin.
---@param turn quat
---@return Structure
function Structure:rotate(turn) end
---Moved.
---@param by vec [m]
---@return Structure
function Structure:move(by) end
---Mirror image in a plane.
---@param normal vec
---@param through? vec [m]
---@return Structure
function Structure:mirror(normal, through) end
---Both as one: vertices of the other within the tolerance (1e-6) of one of this become that one.
---@param other Structure
---@param tolerance? number [m]
---@return Structure
function Structure:join(other, tolerance) end
---Each edge halved: triangles become four, other faces quadrilaterals.
---@return Structure
function Structure:subdivide() end
---A vertex for each face, a face for each inner vertex.
---@return Structure
function Structure:dual() end
---Each vertex of a closed surface cut off at a fraction of its edges.
---@param fraction number
---@return Structure
function Structure:truncate(fraction) end
---What is made of the parts for which keep is true, and their numbers; keep is given the vertex' place, both ends of the edge or the middle of the face [m], then the number.
---@param part "vertices"|"edges"|"faces"
---@param keep function
---@return Structure
---@return integer[]
function Structure:select(part, keep) end
---Inertia [kg m²] of 1 kg about its centre of mass, and that centre [m].
---@param mass_in? "points"|"edges"|"faces"|"solid"
---@return vec|table
---@return vec
function Structure:inertia(mass_in) end

---Draws over the scene what is shown until the next step: call it in each step. On the screen (space = "screen") x and y are in px from the upper left corner, negative ones from the right or lower edge.
---@class Draw
local Draw = {}
---A line.
---@param from vec [m]
---@param to vec [m]
---@param options? LineOptions
function Draw:line(from, to, options) end
---An arrow to a place.
---@param from vec [m]
---@param to vec [m]
---@param options? LineOptions
function Draw:arrow(from, to, options) end
---Text whose upper left corner is at a place; \n begins a new line.
---@param at vec [m]
---@param text string
---@param options? MarkOptions
function Draw:text(at, text, options) end
---A dot.
---@param at vec [m]
---@param options? MarkOptions
function Draw:point(at, options) end

---A state of the scene, to which scene:restore goes back: the world, scene.store and the data of things; not what a script keeps in its variables.
---@class Snapshot
---@field time number [s] of the scene when it was taken (read only)
local Snapshot = {}

---The scene that is being run.
---@class Scene
---@field title string what the window and the pictures are called
---@field duration number? [s] end of a headless run
---@field pace number simulated s per real s
---@field camera Camera { at [m], look_at [m], follow = thing }
---@field store table plain values of yours, which snapshots keep
---@field gravity vec [m/s²] uniform acceleration
---@field step number [s] length of one step
---@field accuracy number? [1/s] wanted error per second, relative to the distance between what interacts, or to how far it swings beside a uniform motion where it interacts with nothing; sub-steps follow from it. Functions of time that ties follow are then asked at each quarter of a step
---@field accuracy_per string whether `accuracy` is that of a "second" or of a "step", as where a scene lasts microseconds
---@field integrator string "verlet" (2nd order), "implicit" (the same with connections of any stiffness), "suzuki4" (4th order, where nothing dissipates), "rk4" (4th order, no constraints), "euler" (1st order, semi-implicit; free particles as with "verlet")
---@field energy_return boolean give back what the velocity projection took
---@field box vec? [m] edges of the periodic box; nil: open space
---@field plane string? "xy", "xz" or "yz": everything stays in that plane, and forces across it do nothing; set it before things are made
---@field tolerance number points of a new hinge may be this far apart, relative to the size of their bodies
---@field seed integer of math.random
---@field boltzmann number [J/K] k_B; temperature is in J while it is 1
---@field time number [s] simulated time (read only)
---@field energy Energy [J] { kinetic, potential, total } (read only)
---@field momentum vec [kg m/s] sum over all things (read only)
---@field angular_momentum vec [kg m²/s] sum over all things about the world's origin (read only)
---@field temperature number [K] relative to the common motion; in J while scene.boltzmann is 1 (read only)
---@field error Accuracy { hinge_gap [m], constraint [m], energy (relative) } now, and worst_… since the start (read only)
---@field ledger Ledger [J] where energy came from and went since the start; the first reading has all of it kept from the next step on (read only)
---@field stats Stats counts since the start, and ns per phase (read only)
---@field log LogLine[] { time [s], kind, text } of all that was logged (read only)
---@field timeline TimelineEntry[] events that ended, then those that wait: the latest and the next 1000 (read only)
---@field bodies Body[] all bodies, in the order of making (read only)
---@field particles Particle[] all particles that are no hinges, and do not sleep in one (read only)
---@field hinges Particle[] all hinges (read only)
---@field connections Connection[] all connections, in the order of making (read only)
---@field hands Hand[] the mouse, fingers, sticks, and scripted hands (read only)
---@field draw Draw draws over the scene for one frame (read only)
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
---@param length? number|fun(t: number): number [m]
---@return Rod
function Scene:rod(a, b, length) end
---Keeps two bodies in their present relative place and orientation; it tells its load, and may break.
---@param a Body
---@param b Body
---@param options? ConstraintOptions
---@return Weld
function Scene:weld(a, b, options) end
---Keeps the orientation of a body, or its present one.
---@param body Body
---@param to? quat|fun(t: number): quat
---@param options? OrientOptions
---@return Orient
function Scene:orient(body, to, options) end
---Keeps the angle between an axis of a and one of b, each in its body's frame; without b, one of the world.
---@param a Body
---@param axis_a vec
---@param b Body|vec
---@param axis_b? vec|AlignOptions
---@param options? AlignOptions
---@return Align
function Scene:align(a, axis_a, b, axis_b, options) end
---Turns a about an axis (world axes) against b, or without b against the world.
---@param a Body
---@param b Body|MotorOptions
---@param options? MotorOptions
---@return Motor
function Scene:motor(a, b, options) end
---Keeps the angle of a against b about an axis, 0 where it is now, or the distance of two points, in a range.
---@param a Body|Point|Particle
---@param b Body|Point|Particle|vec|LimitOptions
---@param options? LimitOptions
---@return Limit
function Scene:limit(a, b, options) end
---Keeps a point on a plane.
---@param point Point|Particle
---@param options? PlaneOptions
---@return OnPlane
function Scene:on_plane(point, options) end
---Is at most so long along its points and places, slides through the inner ones, and may go slack.
---@param points (Point|Particle|vec)[]
---@param options? StringOptions
---@return String
function Scene:string(points, options) end
---Keeps a point on a path through places [m]; at the end of an open one it stops.
---@param point Point|Particle
---@param path vec[]
---@param options? PathOptions
---@return OnPath
function Scene:on_path(point, path, options) end
---Draws two points together, at a place or on their way to each other, and makes the hinge when they are within a tenth of scene.tolerance of their size, some 20 time constants later. Without at, momentum is kept on the way, and so is angular momentum: they come together on a straight line, and what that takes goes into the turning of all that hangs on them. Two free particles alone have nothing to turn, and lose theirs.
---@param a Point|Particle
---@param b Point|Particle
---@param options? JoinOptions
---@return Join
function Scene:join(a, b, options) end
---a lives on with b's points, which stay valid; b is gone.
---@param a Body
---@param b Body
---@return Body
function Scene:merge(a, b) end
---Makes a body of its own of some of a body's points.
---@param body Body
---@param points Point|Point[]
---@param ... Point
---@return Body
function Scene:split(body, points, ...) end
---Makes one body of the free particles and the bodies of a group.
---@param group Group
---@return Body
function Scene:freeze(group) end
---Makes free particles of a body's points; those without mass are gone.
---@param body Body
---@return Particle[]
function Scene:shatter(body) end
---Ties the particles of a group that are nearer than a distance and not tied yet.
---@param group Group
---@param distance number [m]
---@param law Law
---@param options? ConnectOptions
---@return Connection[]
function Scene:connect_within(group, distance, law, options) end
---Makes a named set of things.
---@param name string
---@return Group
function Scene:group(name) end
---Makes a family of particles, with named numeric attributes.
---@param name string
---@param options? FamilyOptions
---@return Family
function Scene:family(name, options) end
---Ties two particles by a law; or a list of two, three or four.
---@param a Point|Particle|vec|table
---@param b Point|Particle|vec|Law
---@param law? Law
---@param options? ConnectOptions
---@return Connection
function Scene:connect(a, b, law, options) end
---Breaks what ties the particles of families above a temperature; below one ties what is near, or joins it to hinges.
---@param options BondingOptions
---@return Event
function Scene:bonding(options) end
---A law between all pairs of two families, or within one.
---@param a Family
---@param b Family
---@param law Law
---@return Interaction
function Scene:interact(a, b, law) end
---A law on each particle of a family, of a group or of the scene.
---@param target Family|Group|Scene
---@param law Law
---@return Field
function Scene:field(target, law) end
---Makes particles at a rate.
---@param options EmitterOptions
---@return Emitter
function Scene:emitter(options) end
---Makes a structure real; the group has its parts in the structure's order.
---@param structure Structure
---@param options BuildOptions
---@return Group
function Scene:build(structure, options) end
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
---Does it once, at the beginning of the first step whose time is not before it: never early. A run that ends at that time does not do it.
---@param time number [s]
---@param target_or_action Thing|function
---@param action? function
---@return Event
function Scene:at(time, target_or_action, action) end
---Does it once, a while from now, by the rule of at.
---@param delay number [s]
---@param target_or_action Thing|function
---@param action? function
---@return Event
function Scene:after(delay, target_or_action, action) end
---Does it again and again, at period, 2 period, … from now on, by the rule of at.
---@param period number [s]
---@param target_or_action Thing|function
---@param action? function
---@return Event
function Scene:every(period, target_or_action, action) end
---Does it at the beginning of each step from one time to another, with u from 0 to 1; with 1 for sure, and last.
---@param from number [s]
---@param to number [s]
---@param target_or_action Thing|fun(u: number)
---@param action? fun(u: number, target: Thing)
---@return Event
function Scene:over(from, to, target_or_action, action) end
---Does it at the beginning of the first step at which something holds.
---@param condition Condition|fun(): boolean
---@param target_or_action Thing|function
---@param action? function|WhenOptions
---@param options? WhenOptions
---@return Event
function Scene:when(condition, target_or_action, action, options) end
---A script that waits: wait(2) [s] by the rule of at, wait(function() … end), wait() for the next step.
---@param target_or_script Thing|fun(wait: Waiting)
---@param script? fun(wait: Waiting, target: Thing)
---@return Event
function Scene:play(target_or_script, script) end
---Calls a function at each "step" (dt), "press" "release" (hand), "key" (name), "grab" "drop" (point, hand), "cut" "joined" (hinge), "broke" (connection, constraint or hinge, force [N] or torque [N m], story), "removed" (thing, story). on("key", "x", action) takes that key from the window, whatever that does with it; without a name, keys are heard that the window has no use for.
---@param moment string
---@param key_or_action string|function
---@param action? function
---@return Subscription
function Scene:on(moment, key_or_action, action) end
---Puts a behaviour to work on a target, with which it ends.
---@param target Thing|Scene
---@param behaviour Behaviour
---@param options? table
---@return Subscription
function Scene:behave(target, behaviour, options) end
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
---The present state, kept in memory. Taking it changes nothing of the run.
---@return Snapshot
function Scene:snapshot() end
---Goes back to a snapshot once the step is done. Things, events and handlers are those of then, and handles of them are theirs again; what was made since is gone. An error while a play goes on.
---@param snapshot Snapshot
function Scene:restore(snapshot) end
---Goes back to the start of the first step, as restore does.
function Scene:reset() end

---A scene that a test opened.
---@class OpenedScene
---@field time number [s] simulated time (read only)
---@field energy Energy [J] { kinetic, potential, total } (read only)
---@field momentum vec [kg m/s] sum over all things (read only)
---@field angular_momentum vec [kg m²/s] sum over all things about the world's origin (read only)
---@field temperature number [K] relative to the common motion; in J while scene.boltzmann is 1 (read only)
---@field error Accuracy { hinge_gap [m], constraint [m], energy (relative) } now, and worst_… since the start (read only)
---@field ledger Ledger [J] where energy came from and went since the start; the first reading has all of it kept from the next step on (read only)
---@field stats Stats counts since the start, and ns per phase (read only)
---@field log LogLine[] { time [s], kind, text } of all that was logged (read only)
---@field timeline TimelineEntry[] events that ended, then those that wait: the latest and the next 1000 (read only)
---@field bodies Body[] all bodies, in the order of making (read only)
---@field particles Particle[] all particles that are no hinges, and do not sleep in one (read only)
---@field hinges Particle[] all hinges (read only)
---@field connections Connection[] all connections, in the order of making (read only)
---@field finished boolean whether it called scene:finish() (read only)
---@field drawn integer lines, arrows, texts and points that it drew in the last step (read only)
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
---The present state.
---@return Snapshot
function OpenedScene:snapshot() end
---Puts a state back.
---@param snapshot Snapshot
function OpenedScene:restore(snapshot) end
---The oldest living thing of that name.
---@param name string
---@return Thing?
function OpenedScene:find(name) end
---Particles within a radius, nearest first.
---@param at vec [m]
---@param radius number [m]
---@return Particle[]
function OpenedScene:near(at, radius) end

---A law: how particles pull at each other, or are pulled. It does not change.
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
---@class SpringOptions: PairLawOptions
---@field stiffness number [N/m] k
---@field length? number [m] at which there is no force; the present one unless given
---@field damping? number [N s/m] c; without it the spring only stores energy; 0
---@field name? string in the ledger

---V = k (r - l)² / 2, with damping c also a tension c dr/dt (R. Hooke, De Potentia Restitutiva, 1678)
---@param options SpringOptions
---@return Law
function force.spring(options) end
---@class DamperOptions: PairLawOptions
---@field damping number [N s/m] c
---@field name? string in the ledger

---tension c dr/dt (Lord Rayleigh, The Theory of Sound, vol. 1, 1877, § 81)
---@param options DamperOptions
---@return Law
function force.damper(options) end
---@class GravitationOptions: PairLawOptions
---@field constant? number [N m²/kg²] G; 6.6743e-11
---@field softening? number [m] s; 0
---@field name? string in the ledger

---V = -G m m' / sqrt(r² + s²) (I. Newton, Principia, 1687, book 3, proposition 7; softening: H. C. Plummer, MNRAS 71, 1911, p. 460)
---@param options GravitationOptions
---@return Law
function force.gravitation(options) end
---@class CoulombOptions: PairLawOptions
---@field constant? number [N m²/C²] k; 8987551787.368176
---@field name? string in the ledger

---V = k q q' / r (C. A. Coulomb, Premier mémoire sur l'électricité et le magnétisme, 1785)
---@param options CoulombOptions
---@return Law
function force.coulomb(options) end
---@class MorseOptions: PairLawOptions
---@field depth number [J] D
---@field steepness number [1/m] a
---@field length? number [m] at which there is no force; the present one unless given
---@field name? string in the ledger

---V = D (exp(-2 a (r - l)) - 2 exp(-a (r - l))) (P. M. Morse, Phys. Rev. 34, 1929, p. 57, eq. 4)
---@param options MorseOptions
---@return Law
function force.morse(options) end
---@class BuckinghamOptions: PairLawOptions
---@field repulsion number [J] A
---@field steepness number [1/m] B
---@field attraction number [J m⁶] C
---@field name? string in the ledger

---V = A exp(-B r) - C / r⁶; without bound where r is very small (R. A. Buckingham, Proc. R. Soc. A 168, 1938, p. 264)
---@param options BuckinghamOptions
---@return Law
function force.buckingham(options) end
---@class YukawaOptions: PairLawOptions
---@field strength number [J m] g
---@field screening number [m] λ
---@field name? string in the ledger

---V = g exp(-r / λ) / r, repulsive where g > 0 (H. Yukawa, Proc. Phys.-Math. Soc. Japan 17, 1935, p. 48)
---@param options YukawaOptions
---@return Law
function force.yukawa(options) end
---@class TableOptions: PairLawOptions
---@field distances number[] [m] rising
---@field potentials? number[] [J] at the distances
---@field tensions? number[] [N] at the distances, instead
---@field name? string in the ledger

---a natural cubic spline through given potentials or tensions; straight before the first point, cut off at the last (C. de Boor, A Practical Guide to Splines, 1978, ch. IV)
---@param options TableOptions
---@return Law
function force.table(options) end
---@class LennardJonesOptions: PairLawOptions
---@field epsilon number [J] ε
---@field sigma number [m] σ
---@field name? string in the ledger

---V = 4 ε ((σ/r)¹² - (σ/r)⁶), cut off at 2.5 σ unless it is said where (J. E. Lennard-Jones, Proc. Phys. Soc. 43, 1931, p. 461)
---@param options LennardJonesOptions
---@return Law
function force.lennard_jones(options) end
---@class WcaOptions: PairLawOptions
---@field epsilon number [J] ε
---@field sigma number [m] σ
---@field name? string in the ledger

---V = 4 ε ((σ/r)¹² - (σ/r)⁶) + ε up to 2^(1/6) σ, 0 beyond (J. D. Weeks, D. Chandler and H. C. Andersen, J. Chem. Phys. 54, 1971, p. 5237, eq. 4)
---@param options WcaOptions
---@return Law
function force.wca(options) end
---@class HydrophobicOptions: PairLawOptions
---@field strength number [J] ε
---@field size number [m] b
---@field range? number [m] w; 1.6 b
---@field attraction? number h; 1
---@field name? string in the ledger

---a core as wca's with ε and σ = b, and around it a well -h ε cos²(π x / 2), x = (r - 2^(1/6) b) / w from 0 to 1: attraction between like (h = 1, tails that shun water), none (0) or repulsion (-1) between others. Makes droplets, membranes and vesicles of bodies with a head and tails (I. R. Cooke, K. Kremer and M. Deserno, Phys. Rev. E 72, 2005, 011506, eqs. 1 and 4)
---@param options HydrophobicOptions
---@return Law
function force.hydrophobic(options) end
---@class RepelOptions: PairLawOptions
---@field stiffness number [N/m^1.5] k
---@field name? string in the ledger

---balls that touch push with k overlap^1.5, the overlap that of their radii (H. Hertz, J. reine angew. Math. 92, 1882, p. 156)
---@param options RepelOptions
---@return Law
function force.repel(options) end
---@class FlockOptions: PairLawOptions
---@field sight number [m] beyond it neighbours do not matter
---@field separation? number [N m] s; 0
---@field alignment? number [N s/m] a; 0
---@field cohesion? number [N/m] c; 0
---@field name? string in the ledger

---each follows its neighbours: w (c d + a u - s d / r²), d and u the position and velocity of the other relative to it, w = (1 - r²/sight²)² (C. W. Reynolds, Computer Graphics 21 (4), 1987, p. 25)
---@param options FlockOptions
---@return Law
function force.flock(options) end
---@class DragOptions
---@field linear? number [N s/m] c; 0
---@field quadratic? number [N s²/m²] q; 0
---@field name? string in the ledger

----(c + q |v|) v (G. G. Stokes, Trans. Camb. Phil. Soc. 9, 1851, p. 8 (linear); Newton, Principia, 1687, book 2 (quadratic))
---@param options DragOptions
---@return Law
function force.drag(options) end
---@class WindOptions
---@field velocity vec [m/s] u
---@field linear? number [N s/m] c; 0
---@field quadratic? number [N s²/m²] q; 0
---@field name? string in the ledger

---drag in air that moves with velocity u: (c + q |u - v|) (u - v) (as drag)
---@param options WindOptions
---@return Law
function force.wind(options) end
---@class VortexOptions
---@field centre? vec [m] a point of the axis
---@field axis vec direction that the air circles by the right-hand rule
---@field circulation number [m²/s] Γ
---@field core number [m] distance where the air is fastest
---@field linear? number [N s/m] c; 0
---@field quadratic? number [N s²/m²] q; 0
---@field name? string in the ledger

---drag in air that circles an axis: u = Γ s / (2 π (core² + s²)) at distance s from it (W. Kaufmann, Ingenieur-Archiv 31, 1962, p. 1)
---@param options VortexOptions
---@return Law
function force.vortex(options) end
---@class BuoyancyOptions
---@field density number [kg/m³] of the liquid
---@field surface? number [m] height y of the surface; 0
---@field gravity? number [m/s²] weight per mass; 9.81
---@field name? string in the ledger

---a ball is lifted along y by the weight of the liquid that it displaces (Archimedes, On Floating Bodies, book 1, propositions 5 to 7; volume of a cap: π h² (3 R - h) / 3)
---@param options BuoyancyOptions
---@return Law
function force.buoyancy(options) end
---@class ThermostatOptions
---@field rate number [1/s] γ
---@field temperature number [K] T
---@field name? string in the ledger

----γ m v + sqrt(2 γ m k T / h) noise, k Boltzmann's constant and h the step of the scene, in the middle of each drift: particles in a harmonic well spread as at T at any step, and free ones have its velocities; in a well in which they swing at ω the velocities, and with them scene.temperature, are those of T (1 - (ω h)²/4) (P. Langevin, C. R. Acad. Sci. 146, 1908, p. 530; the splitting BAOAB: B. Leimkuhler and C. Matthews, Appl. Math. Res. Express 2013, p. 34)
---@param options ThermostatOptions
---@return Law
function force.thermostat(options) end
---@class WallOptions
---@field through? vec [m] a point of the plane
---@field normal vec out of the wall
---@field stiffness number [N/m] k
---@field damping? number [N s/m] c; 0
---@field friction? number μ; 0
---@field slip? number [m/s] speed below which friction is less than full; 1e-06
---@field name? string in the ledger

---a ball that reaches behind a plane is pushed out: N = max(k overlap - c v_n, 0), with friction μ N against its sliding v, as v / sqrt(v² + slip²) (P. A. Cundall and O. D. L. Strack, Géotechnique 29, 1979, p. 47)
---@param options WallOptions
---@return Law
function force.wall(options) end
---@class AngleOptions
---@field stiffness number [J] k
---@field angle? number [rad] θ where there is no force; the present one unless given
---@field name? string in the ledger

---V = k (θ - θ0)² / 2 of the angle at the second of three particles; no force where they are in line (E. B. Wilson, J. C. Decius and P. C. Cross, Molecular Vibrations, 1955, ch. 4)
---@param options AngleOptions
---@return Law
function force.angle(options) end
---@class TorsionOptions
---@field stiffness number [J] k
---@field angle? number [rad] θ where there is no force; the present one unless given
---@field fold? number n, minima of a turn; 1
---@field name? string in the ledger

---V = k (1 - cos(n (φ - φ0))) of the torsion of four particles, IUPAC's sign; no force where three are in line (B. R. Brooks et al., J. Comput. Chem. 4, 1983, p. 187, eq. 4; derivative by the graph's reverse mode)
---@param options TorsionOptions
---@return Law
function force.torsion(options) end

---In the function of a law: a normal deviate of mean 0 and variance 1, one for each call, pair and step.
---@return number
function noise() end

---@generic T
---@param condition boolean
---@param yes T
---@param no T
---@return T
function where(condition, yes, no) end

structure = {}
---Four triangles. Lengths [m] are 1 unless given.
---@param options? { edge?: number }
---@return Structure
function structure.tetrahedron(options) end
---Six squares.
---@param options? { edge?: number }
---@return Structure
function structure.cube(options) end
---Eight triangles.
---@param options? { edge?: number }
---@return Structure
function structure.octahedron(options) end
---Twelve pentagons.
---@param options? { edge?: number }
---@return Structure
function structure.dodecahedron(options) end
---Twenty triangles.
---@param options? { edge?: number }
---@return Structure
function structure.icosahedron(options) end
---Two regular polygons, one above the other.
---@param options? { sides?: integer, edge?: number, height?: number }
---@return Structure
function structure.prism(options) end
---One regular face.
---@param options? { sides?: integer, edge?: number }
---@return Structure
function structure.polygon(options) end
---A line along x.
---@param options? { length?: number, pieces?: integer }
---@return Structure
function structure.rod(options) end
---Squares side by side, in the plane z = 0.
---@param options? { columns?: integer, rows?: integer, edge?: number }
---@return Structure
function structure.sheet(options) end
---A regular polygon without a face.
---@param options? { sides?: integer, radius?: number }
---@return Structure
function structure.ring(options) end
---An icosahedron with its triangles divided into four some times, on a sphere.
---@param options? { divisions?: integer, radius?: number }
---@return Structure
function structure.geodesic(options) end
---Squares that touch at their corners, turned by plus and minus an angle [rad] of 0 to pi/4.
---@param options? { columns?: integer, rows?: integer, edge?: number, angle?: number }
---@return Structure
function structure.rotating_squares(options) end
---A honeycomb of bow ties: upright ribs, and edges that rise inwards by an angle [rad].
---@param options? { columns?: integer, rows?: integer, rib?: number, edge?: number, angle?: number }
---@return Structure
function structure.reentrant(options) end
---A block of cells with edges between neighbours: "cubic", "fcc", "bcc", "diamond", or flat: "square", "triangular", "honeycomb", "kagome".
---@param options { kind?: string, cells?: integer|vec, edge?: number }
---@return Structure
function structure.lattice(options) end
---Atoms, bonds and flat rings of a .xyz, .sdf, .mol, .pdb, .cif or .mmcif file in the scene's folder or assets/molecules; 1 Å becomes scale [m], 1 unless given.
---@param file string
---@param options? { scale?: number }
---@return Structure
function structure.molecule(file, options) end
---A structure of one's own; edges of faces need not be given.
---@param parts { vertices: vec[], edges?: integer[][], faces?: integer[][] }
---@return Structure
function structure.new(parts) end

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
