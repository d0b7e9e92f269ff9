// What a hand does is in the very next picture.
#include <epoxy/gl.h>

#include <catch2/catch.hpp>
#include <vector>

#include "window/played.hpp"

using namespace pantin;

namespace {

constexpr int width = 640, height = 480;

std::vector<unsigned char> picture() {
  std::vector<unsigned char> pixels(4 * static_cast<std::size_t>(width) * height);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  return pixels;
}

/// Pixels within `reach` of a position [pixels from the left and top] that changed.
int changed(const std::vector<unsigned char>& a, const std::vector<unsigned char>& b, int x, int y, int reach) {
  int count = 0;
  for (int row = y - reach; row <= y + reach; row++)
    for (int column = x - reach; column <= x + reach; column++) {
      const std::size_t at =
          4 * (static_cast<std::size_t>(height - 1 - row) * width + static_cast<std::size_t>(column));
      for (std::size_t i = at; i < at + 3; i++)
        if (a[i] != b[i]) {
          count++;
          break;
        }
    }
  return count;
}

}  // namespace

TEST_CASE("window: what the pointer takes hold of, and where it drags it, is in the next picture", "[window]") {
  Played played(R"(
    scene.gravity = vec(0, 0, 0)
    scene.camera = { at = vec(0, 0, 10), look_at = vec(0, 0, 0) }
    local ball = scene:particle { mass = 1e-3, at = vec(0, 0, 0), radius = 0.5, color = "#c33" }
  )",
                5.0, {width, height});
  pushed::move(width / 2, height / 2);
  played.frames(3);
  pushed::button(true, width / 2, height / 2);
  played.frames(1);
  REQUIRE(played.world().hands.size() == 1);
  CHECK(played.world().hands[0].grab);
  const std::vector<unsigned char> before = picture();
  const Vec3 position = played.world().hands[0].position;
  pushed::move(width / 2 + 100, height / 2 - 80);
  played.frames(1);
  const std::vector<unsigned char> after = picture();
  CHECK(norm(played.world().hands[0].position - position) > 0.1);
  CHECK(changed(before, after, width / 2 + 100, height / 2 - 80, 40) > 50);
}
