// Annotations of the tables that calls are given: each field with its unit, and what holds where it is left out.
#include "lua/meta/annotations.hpp"

namespace pantin::lua {

const char* const annotations_options = R"(---@class NameOptions
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

)";

}  // namespace pantin::lua
