// Annotations: the options of shapes, and of bodies of one shape.
#include "lua/meta/annotations.hpp"

namespace pantin::lua {

const char* const annotations_shapes = R"(---What shapes are made of, and what they touch.
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

)";

}  // namespace pantin::lua
