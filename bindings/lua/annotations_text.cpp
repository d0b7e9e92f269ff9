// Annotations that are not made from the tables of the bindings.
#include "lua/annotations.hpp"

namespace pantin::lua {

const char* const annotations_head = R"(---@meta
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

)";

const char* const annotations_tail = R"(---@type Scene
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
)";

}  // namespace pantin::lua
