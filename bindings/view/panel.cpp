#include "view/panel.hpp"

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <cmath>
#include <filesystem>

#include "base/check.hpp"
#include "view/marks.hpp"

namespace pantin {

namespace {

const ImVec4 ink = {0.22f, 0.20f, 0.18f, 0.85f}, faint = {0.22f, 0.20f, 0.18f, 0.60f},
             warning = {0.72f, 0.16f, 0.14f, 1.0f}, card = {1.0f, 0.985f, 0.96f, 0.90f};
constexpr MarkLook mark_look = {{0.16f, 0.17f, 0.19f, 1.0f}, {0.96f, 0.94f, 0.90f, 0.7f}};
constexpr ImGuiWindowFlags quiet = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                                   ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav |
                                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoSavedSettings;

void load_font(float scale) {
  static const ImWchar ranges[] = {0x20,   0xff,   0x370,  0x3ff,  0x2010, 0x2027, 0x2070,
                                   0x209f, 0x2190, 0x2193, 0x2212, 0x2212, 0};
  const char* path = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
  ImGuiIO& io = ImGui::GetIO();
  if (!std::filesystem::exists(path) || !io.Fonts->AddFontFromFileTTF(path, std::round(14.0f * scale), nullptr, ranges))
    io.Fonts->AddFontDefault();
}

void style(float scale) {
  ImGui::StyleColorsLight();
  ImGuiStyle& s = ImGui::GetStyle();
  s.WindowRounding = 8.0f;
  s.FrameRounding = 6.0f;
  s.WindowPadding = {14.0f, 10.0f};
  s.FramePadding = {10.0f, 5.0f};
  s.ItemSpacing = {10.0f, 6.0f};
  s.WindowBorderSize = 0.0f;
  s.Colors[ImGuiCol_Text] = ink;
  s.Colors[ImGuiCol_WindowBg] = card;
  s.Colors[ImGuiCol_Button] = {1.0f, 0.985f, 0.96f, 0.85f};
  s.Colors[ImGuiCol_ButtonHovered] = {0.98f, 0.86f, 0.72f, 1.0f};
  s.Colors[ImGuiCol_ButtonActive] = {0.94f, 0.66f, 0.42f, 1.0f};
  s.ScaleAllSizes(scale);
}

}  // namespace

Panel::Panel(double scale) : context_(ImGui::CreateContext()), scale_(static_cast<float>(scale)) {
  ImGui::SetCurrentContext(context_);
  ImGui::GetIO().IniFilename = nullptr;
  ImGui::GetIO().LogFilename = nullptr;
  style(scale_);
  load_font(scale_);
  require(ImGui_ImplOpenGL3_Init("#version 330 core"), "the text cannot be drawn with this OpenGL");
}

Panel::~Panel() {
  ImGui::SetCurrentContext(context_);
  ImGui_ImplOpenGL3_Shutdown();
  ImGui::DestroyContext(context_);
}

void Panel::draw(const Overlay& overlay, const Camera& camera, int width, int height) {
  pressed_.clear();
  under_pointer_ = false;
  if (overlay.status.empty() && overlay.message.empty() && overlay.title.empty() && overlay.help.empty() &&
      overlay.buttons.empty() && overlay.marks.empty())
    return;
  ImGui::SetCurrentContext(context_);
  ImGui_ImplOpenGL3_NewFrame();
  ImGuiIO& io = ImGui::GetIO();
  const float w = static_cast<float>(width), h = static_cast<float>(height);
  io.DisplaySize = {w, h};
  io.DeltaTime = 1.0f / 60.0f;
  io.MousePos = {static_cast<float>(overlay.pointer_x), static_cast<float>(overlay.pointer_y)};
  io.MouseDown[0] = overlay.pointer_down;
  ImGui::NewFrame();
  draw_marks(*ImGui::GetBackgroundDrawList(), overlay.marks, mark_look, camera, width, height);
  status(overlay, w, h);
  buttons(overlay);
  help(overlay, w, h);
  ImGui::Render();
  under_pointer_ = io.WantCaptureMouse;
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void Panel::status(const Overlay& overlay, float width, float height) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const float edge = 14.0f * scale_, line = ImGui::GetFontSize() * 1.35f, gap = 22.0f * scale_;
  if (!overlay.title.empty()) list.AddText({edge, edge}, ImGui::GetColorU32(ink), overlay.title.c_str());
  float y = height - edge - ImGui::GetFontSize();
  float x = edge;
  for (const std::string& part : overlay.status) {
    const float wide = ImGui::CalcTextSize(part.c_str()).x;
    if (x > edge && x + wide > width - edge) {
      x = edge;
      y -= line;
    }
    list.AddText({x, y}, ImGui::GetColorU32(faint), part.c_str());
    x += wide + gap;
  }
  if (overlay.message.empty()) return;
  const float wrap = width - 4.0f * edge;
  const ImVec2 size = ImGui::CalcTextSize(overlay.message.c_str(), nullptr, false, wrap);
  if (!overlay.status.empty()) y -= line;
  const ImVec2 at = {edge, y + ImGui::GetFontSize() - size.y - 6.0f * scale_};
  const float pad = 7.0f * scale_;
  list.AddRectFilled({at.x - pad, at.y - pad}, {at.x + size.x + pad, at.y + size.y + pad}, ImGui::GetColorU32(card),
                     pad);
  list.AddText(nullptr, 0.0f, at, ImGui::GetColorU32(warning), overlay.message.c_str(), nullptr, wrap);
}

void Panel::buttons(const Overlay& overlay) {
  if (overlay.buttons.empty()) return;
  const float edge = 10.0f * scale_;
  ImGui::SetNextWindowPos({edge, edge + (overlay.title.empty() ? 0.0f : 1.8f * ImGui::GetFontSize())});
  ImGui::Begin("buttons", nullptr, quiet | ImGuiWindowFlags_NoBackground);
  for (const std::string& name : overlay.buttons)
    if (ImGui::Button(name.c_str())) pressed_ = name;
  ImGui::End();
}

void Panel::help(const Overlay& overlay, float width, float height) {
  if (overlay.help.empty()) return;
  ImGui::SetNextWindowPos({0.5f * width, 0.5f * height}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::Begin("keys", nullptr, quiet);
  if (ImGui::BeginTable("table", 2, ImGuiTableFlags_SizingFixedFit)) {
    for (const auto& [key, does] : overlay.help) {
      ImGui::TableNextRow();
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(key.c_str());
      ImGui::TableNextColumn();
      ImGui::TextColored(faint, "%s", does.c_str());
    }
    ImGui::EndTable();
  }
  ImGui::End();
}

}  // namespace pantin
