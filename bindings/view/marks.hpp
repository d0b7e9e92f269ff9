#pragma once
#include <span>

#include "view/camera.hpp"
#include "view/overlay.hpp"

struct ImDrawList;

namespace pantin {

/// How marks look that say nothing themselves.
struct MarkLook {
  Color ink;   ///< of marks without a colour
  Color halo;  ///< round text
};

/// Draws marks over a picture of that size [px], in their order; what lies behind the eye or beside the picture is left
/// out.
void draw_marks(ImDrawList& list, std::span<const Mark> marks, const MarkLook& look, const Camera& camera, int width,
                int height);

}  // namespace pantin
