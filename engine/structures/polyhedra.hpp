#pragma once
// Polyhedra and other shapes, centred on the origin; flat ones are in the plane z = 0, y is up. Lengths in m, > 0.
#include "structures/structure.hpp"

namespace pantin::shapes {

Structure tetrahedron(double edge);
Structure cube(double edge);
Structure octahedron(double edge);
Structure dodecahedron(double edge);
Structure icosahedron(double edge);
/// Two regular polygons of 3 or more sides, one above the other.
Structure prism(int sides, double edge, double height);
/// One face.
Structure polygon(int sides, double edge);
/// A line along x in some pieces.
Structure rod(double length, int pieces);
/// Squares in columns (along x) and rows (along y).
Structure sheet(int columns, int rows, double edge);
/// A regular polygon without a face.
Structure ring(int sides, double radius);
/// An icosahedron whose triangles are divided into four some times, with all vertices on a sphere.
Structure geodesic(int divisions, double radius);

/// Squares hinged at their corners, turned by +-angle [rad] in turn, 0 to pi/4 (Grima and Evans 2000).
Structure rotating_squares(int columns, int rows, double edge, double angle);
/// A honeycomb of bow ties: upright ribs of a length and slanted ones of `edge`, which rise inwards by `angle` [rad], > 0
/// and < pi/2; `rib` > 2 edge sin(angle) (Gibson and Ashby 1982).
Structure reentrant(int columns, int rows, double rib, double edge, double angle);

}  // namespace pantin::shapes
