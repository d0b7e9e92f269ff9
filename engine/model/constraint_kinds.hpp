// The kinds of constraints, one in a line. All that there is of each kind is listed from here: who includes it defines
// CONSTRAINT_KIND(name) before.
CONSTRAINT_KIND(nail)      // a point stays at a position of the world
CONSTRAINT_KIND(follow)    // a point keeps to a moving target; with a finite `max_force` by a spring
CONSTRAINT_KIND(rod)       // two points, or a point and a position, keep their distance
CONSTRAINT_KIND(axis)      // a hinge's, two bodies turn about one axis only
CONSTRAINT_KIND(weld)      // two bodies keep their relative position and orientation
CONSTRAINT_KIND(orient)    // a body keeps an orientation
CONSTRAINT_KIND(align)     // an axis of a body keeps its angle to one of another, or of the world
CONSTRAINT_KIND(motor)     // turns a body about an axis, relative to another or to the world
CONSTRAINT_KIND(limit)     // an angle about an axis stays between two, or a distance
CONSTRAINT_KIND(on_plane)  // a point stays on a plane
CONSTRAINT_KIND(string)    // at most so long along its points, slides through the inner ones
CONSTRAINT_KIND(on_path)   // a point stays on a path
CONSTRAINT_KIND(join)      // draws two points together, to become a hinge; with a finite `max_force` by a spring
CONSTRAINT_KIND(gear)      // one body turns in proportion to another
CONSTRAINT_KIND(rack)      // a point moves along a line as far as the rim of a wheel turns
CONSTRAINT_KIND(pulley)    // a rope over two anchors is at most so long
CONSTRAINT_KIND(screw)     // a point moves along an axis in proportion to a turn about it
CONSTRAINT_KIND(slider)    // a point stays on a line of a body, or of the world
#undef CONSTRAINT_KIND
