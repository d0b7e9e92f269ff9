#include "view/panel_style.hpp"

#include <imgui.h>

#include <catch2/catch.hpp>
#include <iostream>
#include <sstream>

#include "support/process.hpp"

using namespace pantin;

TEST_CASE("a font that is missing or broken is told, and another is taken", "[view]") {
  const support::Folder folder;
  const std::string broken = folder / "broken.ttf", cut = folder / "cut.ttf";
  support::write_file(broken, "this is no font");
  support::write_file(cut, std::string("\0\1\0\0\0\x10", 6) + std::string(500, 'x'));
  const char* const paths[] = {"/nowhere/none.ttf", folder.path.c_str(), broken.c_str(), cut.c_str()};
  ImGuiContext* const context = ImGui::CreateContext();
  ImGui::SetCurrentContext(context);
  std::ostringstream told;
  std::streambuf* const before = std::cerr.rdbuf(told.rdbuf());
  load_panel_font(2.0f, paths);
  std::cerr.rdbuf(before);
  CHECK(told.str().find("font is not here") != std::string::npos);
  CHECK(ImGui::GetIO().Fonts->Build());
  CHECK(ImGui::GetIO().Fonts->Fonts.Size == 1);
  ImGui::DestroyContext(context);
}
