#pragma once
#include "view/figure.hpp"

namespace pantin {

/// Adds a shape that has a cover; `bare` is its figure without.
void add_covered(Figure& figure, const Shape& shape, const Figure& bare);
/// Edges of a picture, but for half a pixel, so that none of the edge across shows [pictures].
struct PictureEdges {
  float left, right, upper, lower;
};
PictureEdges edges_of(const Picture& picture);
/// [m] of a picture that is so wide.
double height_of(const Cover& cover);

}  // namespace pantin
