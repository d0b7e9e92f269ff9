// Films of the window: of the scene alone, or of all that is on the screen.
#include <imgui.h>
#include <imgui_internal.h>

#include <catch2/catch.hpp>
#include <cstdlib>

#include "window/played.hpp"

using namespace pantin;

namespace {

constexpr int width = 960, height = 900;

/// What the first picture of a film, or a picture, has of colours, 3 bytes a pixel.
std::string colors_of(const support::Folder& folder, const std::string& name) {
  const std::string raw = folder / (name + ".raw");
  support::finish(
      {{"ffmpeg", "-v", "error", "-i", folder / name, "-frames:v", "1", "-f", "rawvideo", "-pix_fmt", "rgb24", raw},
       {},
       "",
       -1});
  std::string colors = support::read_file(raw);
  REQUIRE(colors.size() == 3u * width * height);
  return colors;
}

/// Pixels that differ clearly.
int apart(const std::string& a, const std::string& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.size(); i += 3) {
    int most = 0;
    for (std::size_t c = i; c < i + 3; c++)
      most = std::max(most, std::abs(static_cast<unsigned char>(a[c]) - static_cast<unsigned char>(b[c])));
    count += most > 40;
  }
  return count;
}

/// The line of the menu that is so many above its end.
void click_in_menu(Played& played, float from_end) {
  played.click(width - 10 - 6 - 12, 10 + 3 + 12);
  played.frames(3);
  REQUIRE(GImGui->OpenPopupStack.Size == 1);
  const ImGuiWindow& menu = *GImGui->OpenPopupStack[0].Window;
  const float y = menu.Rect().Max.y - menu.WindowPadding.y - (from_end + 0.5f) * ImGui::GetTextLineHeightWithSpacing();
  played.click(static_cast<double>(menu.Pos.x) + 30.0, static_cast<double>(y));
  played.frames(3);
  pushed::move(5, 700);
  played.frames(3);
}

}  // namespace

TEST_CASE("film: it shows the scene without panels, and with them where that is wanted", "[window]") {
  if (!support::have_program("ffmpeg")) return;
  player::RunOptions options = Played::options_of(5.0, {width, height});
  options.paused = true;
  Played played("scene:particle { at = vec(0, 0, 0) } scene:param('mass', 1, { min = 0, max = 2 })", options);
  pushed::move(5, 700);
  played.frames(3);
  const auto here = std::filesystem::current_path();
  std::filesystem::current_path(played.folder.path);
  const auto film = [&] {
    pushed::tap(SDLK_F9);
    played.frames(8);
    pushed::tap(SDLK_F9);
    played.frames(3);
  };
  film();
  click_in_menu(played, 3);
  film();
  played.player->write_picture("picture.png");
  std::filesystem::current_path(here);
  const std::string scene = colors_of(played.folder, "pantin-0001.mp4"),
                    all = colors_of(played.folder, "pantin-0002.mp4"),
                    picture = colors_of(played.folder, "picture.png");
  CHECK(apart(scene, picture) < 200);  // the ring of the pointer
  CHECK(apart(all, picture) > 2000);
}
