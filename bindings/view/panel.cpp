#include "view/panel.hpp"

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <cstdlib>

#include "base/check.hpp"
#include "view/marks.hpp"
#include "view/panel_style.hpp"

namespace pantin {

namespace {

using Kind = PointerEvent::Kind;

MarkLook mark_look(bool dark) {
  if (dark) return {{0.90f, 0.89f, 0.86f, 1.0f}, {0.08f, 0.08f, 0.09f, 0.7f}};
  return {{0.16f, 0.17f, 0.19f, 1.0f}, {0.96f, 0.94f, 0.90f, 0.7f}};
}

constexpr float over_tools = 150.0f;  // [px] at scale 1: over the tools, their variants and what they say

constexpr std::pair<const char*, ImGuiKey> editing_keys[] = {{"tab", ImGuiKey_Tab},
                                                             {"left", ImGuiKey_LeftArrow},
                                                             {"right", ImGuiKey_RightArrow},
                                                             {"up", ImGuiKey_UpArrow},
                                                             {"down", ImGuiKey_DownArrow},
                                                             {"pageup", ImGuiKey_PageUp},
                                                             {"home", ImGuiKey_Home},
                                                             {"pagedown", ImGuiKey_PageDown},
                                                             {"end", ImGuiKey_End},
                                                             {"delete", ImGuiKey_Delete},
                                                             {"backspace", ImGuiKey_Backspace},
                                                             {"space", ImGuiKey_Space},
                                                             {"return", ImGuiKey_Enter},
                                                             {"keypad enter", ImGuiKey_KeyPadEnter},
                                                             {"escape", ImGuiKey_Escape},
                                                             {"a", ImGuiKey_A},
                                                             {"c", ImGuiKey_C},
                                                             {"v", ImGuiKey_V},
                                                             {"x", ImGuiKey_X},
                                                             {"y", ImGuiKey_Y},
                                                             {"z", ImGuiKey_Z}};

/// NeighbourList of a key and what it does, which is wrapped at that width [px]; one that does nothing is a heading.
void help_column(const char* name, std::span<const std::pair<std::string, std::string>> rows, float wrap) {
  if (rows.empty() || !ImGui::BeginTable(name, 2, ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_NoHostExtendX))
    return;
  for (const auto& [key, does] : rows) {
    ImGui::TableNextColumn();
    if (does.empty())
      ImGui::TextColored(ImGui::GetStyleColorVec4(ImGuiCol_CheckMark), "%s", key.c_str());
    else
      ImGui::TextUnformatted(key.c_str());
    ImGui::TableNextColumn();
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + wrap);
    ImGui::TextDisabled("%s", does.c_str());
    ImGui::PopTextWrapPos();
  }
  ImGui::EndTable();
}

/// Under the bar of buttons, at the right.
void draw_legends(ImDrawList& list, const ShownViews& views, float width) {
  float y = 56.0f;
  for (const std::string_view words : {views.colors, views.forces}) {
    if (words.empty()) continue;
    const char *const begin = words.data(), *const end = begin + words.size();
    const ImVec2 size = ImGui::CalcTextSize(begin, end), at = {width - 14.0f - size.x, y};
    const float pad = 4.0f;
    list.AddRectFilled({at.x - pad, at.y}, {at.x + size.x + pad, at.y + size.y},
                       ImGui::GetColorU32(ImGuiCol_WindowBg, 0.5f));
    list.AddText(at, ImGui::GetColorU32(ImGuiCol_Text), begin, end);
    y += 1.35f * ImGui::GetFontSize();
  }
}

void show_at_once(ImDrawList& list) {
  ImDrawList* lists[] = {&list};
  ImDrawData data;
  data.Valid = true;
  data.CmdLists = lists;
  data.CmdListsCount = 1;
  data.TotalIdxCount = list.IdxBuffer.Size;
  data.TotalVtxCount = list.VtxBuffer.Size;
  data.DisplaySize = ImGui::GetIO().DisplaySize;
  data.FramebufferScale = ImGui::GetIO().DisplayFramebufferScale;
  ImGui_ImplOpenGL3_RenderDrawData(&data);
}

}  // namespace

Panel::Panel(double scale) : context_(ImGui::CreateContext()), scale_(static_cast<float>(scale)) {
  ImGui::SetCurrentContext(context_);
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  for (const auto& [name, key] : editing_keys) io.KeyMap[key] = key;
  set_panel_style(dark_);
  load_panel_font(scale_);
  require(ImGui_ImplOpenGL3_Init("#version 330 core"), "the text cannot be drawn with this OpenGL");
}

Panel::~Panel() {
  ImGui::SetCurrentContext(context_);
  list_.reset();
  ImGui_ImplOpenGL3_Shutdown();
  ImGui::DestroyContext(context_);
}

void Panel::set_scale(double scale) {
  ImGui::SetCurrentContext(context_);
  scale_ = static_cast<float>(scale);
  ImGui_ImplOpenGL3_DestroyFontsTexture();
  load_panel_font(scale_);
  ImGui_ImplOpenGL3_CreateFontsTexture();
}

// IO.WantTextInput is late by a frame.
bool Panel::writing() const { return context_->WantTextInputNextFrame == 1; }

bool Panel::covers(double x, double y) const {
  const ImVec2 at(static_cast<float>(x), static_cast<float>(y));
  return std::ranges::any_of(context_->Windows, [&](const ImGuiWindow* window) {
    return window->WasActive && !window->Hidden && !(window->Flags & ImGuiWindowFlags_NoMouseInputs) &&
           window->OuterRectClipped.Contains(at);
  });
}

void Panel::take(Gestures& gestures) {
  ImGui::SetCurrentContext(context_);
  take_events(gestures);
  take_keys(gestures);
}

void Panel::take_events(Gestures& gestures) {
  ImGuiIO& io = ImGui::GetIO();
  std::array<bool, 3> down{};
  std::erase_if(gestures.events, [&](const PointerEvent& event) {
    if (event.pointer == pointer_ && event.kind == Kind::press && event.button != PointerEvent::Button::none)
      down[static_cast<std::size_t>(event.button) - 1] = true;  // a quick click may be over by now
    if (event.kind == Kind::wheel && covers(event.x, event.y)) {
      io.MouseWheel += static_cast<float>(event.dy);
      io.MouseWheelH += static_cast<float>(event.dx);
      return true;
    }
    if (event.kind == Kind::press && covers(event.x, event.y)) {
      if (engaged_.empty()) {
        pointer_ = event.pointer;
        io.MousePos = {static_cast<float>(event.x), static_cast<float>(event.y)};
        if (event.button != PointerEvent::Button::none) down[static_cast<std::size_t>(event.button) - 1] = true;
      }
      engaged_.insert(event.pointer);
    }
    const bool mine = engaged_.contains(event.pointer);
    if (event.kind == Kind::release) engaged_.erase(event.pointer);
    return mine;
  });
  if (const auto found = gestures.pointers.find(pointer_); found != gestures.pointers.end()) {
    const Pointer& pointer = found->second;
    io.MousePos = {static_cast<float>(pointer.x), static_cast<float>(pointer.y)};
    if (pointer_ != 0 && scroll_.take(io.MousePos.x, io.MousePos.y)) io.MousePos = {-FLT_MAX, -FLT_MAX};
    down[0] |= pointer.left;
    down[1] |= pointer.middle;
    down[2] |= pointer.right;
  } else if (pointer_ == 0) {
    io.MousePos = {-FLT_MAX, -FLT_MAX};
  } else if (!down[0]) {  // a tap may be over before it is seen
    pointer_ = 0;         // the finger went up, where it was
  }
  if (!gestures.pointers.contains(pointer_) || pointer_ == 0) scroll_.end();
  io.MouseDown[ImGuiMouseButton_Left] = down[0];
  io.MouseDown[ImGuiMouseButton_Middle] = down[1];
  io.MouseDown[ImGuiMouseButton_Right] = down[2];
  const auto mouse = gestures.pointers.find(0);
  under_pointer_ =
      mouse != gestures.pointers.end() && (engaged_.contains(0) || covers(mouse->second.x, mouse->second.y));
  for (const PointerId id : engaged_)
    if (const auto found = gestures.pointers.find(id); found != gestures.pointers.end())
      found->second.left = found->second.middle = found->second.right = false;
}

void Panel::take_keys(Gestures& gestures) {
  ImGuiIO& io = ImGui::GetIO();
  io.KeyShift = gestures.shift;
  io.KeyCtrl = gestures.control;
  for (const auto& entry : editing_keys) {
    const auto is_key = [&](const std::string& name) { return name == entry.first; };
    io.KeysDown[entry.second] =
        std::ranges::any_of(gestures.held, is_key) || std::ranges::any_of(gestures.keys, is_key);
  }
  if (context_->OpenPopupStack.Size > 0 && std::erase(gestures.keys, "escape") > 0) ImGui::ClosePopupToLevel(0, false);
  if (!writing()) return;
  io.AddInputCharactersUTF8(gestures.text.c_str());
  gestures.keys.clear();
}

void Panel::draw(const Overlay& overlay, const ShownViews& views, const Camera& camera, int width, int height) {
  pressed_.clear();
  if (overlay.status.empty() && overlay.message.empty() && overlay.title.empty() && overlay.help.empty() &&
      overlay.buttons.empty() && overlay.marks.empty() && !overlay.windows && !overlay.without_panels &&
      views.marks.empty() && views.colors.empty() && views.forces.empty())
    return;
  ImGui::SetCurrentContext(context_);
  if (const bool dark = overlay.views.on(View::dark); dark != dark_) set_panel_style(dark_ = dark);
  ImGui_ImplOpenGL3_NewFrame();
  ImGuiIO& io = ImGui::GetIO();
  const float w = static_cast<float>(width), h = static_cast<float>(height);
  io.DisplaySize = {w, h};
  io.DisplayFramebufferScale = {scale_, scale_};
  io.DeltaTime = 1.0f / 60.0f;
  ImGui::NewFrame();
  marks(overlay, views, camera, width, height);
  status(overlay, w, h);
  buttons(overlay);
  if (overlay.windows) overlay.windows();
  help(overlay, w, h);
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

ImDrawList& Panel::own_list() {
  if (!list_) list_ = std::make_unique<ImDrawList>(ImGui::GetDrawListSharedData());
  list_->_ResetForNewFrame();
  list_->PushTextureID(ImGui::GetIO().Fonts->TexID);
  list_->PushClipRectFullScreen();
  return *list_;
}

/// At once, where somebody wants the picture before all else is drawn.
void Panel::marks(const Overlay& overlay, const ShownViews& views, const Camera& camera, int width, int height) {
  ImDrawList& list = overlay.without_panels ? own_list() : *ImGui::GetBackgroundDrawList();
  for (const std::span<const Mark> marks : {views.marks, std::span<const Mark>(overlay.marks)})
    draw_marks(list, marks, mark_look(dark_), camera, width, height);
  draw_legends(list, views, static_cast<float>(width));
  if (!overlay.without_panels) return;
  show_at_once(list);
  overlay.without_panels();
}

void Panel::status(const Overlay& overlay, float width, float height) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const float edge = 14.0f, line = ImGui::GetFontSize() * 1.35f, gap = 22.0f;
  if (!overlay.title.empty()) list.AddText({edge, edge}, ImGui::GetColorU32(ImGuiCol_Text), overlay.title.c_str());
  float y = height - edge - ImGui::GetFontSize();
  float x = edge;
  for (const std::string& part : overlay.status) {
    const float wide = ImGui::CalcTextSize(part.c_str()).x;
    if (x > edge && x + wide > width - edge) {
      x = edge;
      y -= line;
    }
    list.AddRectFilled({x - 0.5f * gap, y - 0.5f * (line - ImGui::GetFontSize())},
                       {x + wide + 0.5f * gap, y + 0.5f * (line + ImGui::GetFontSize())},
                       ImGui::GetColorU32(ImGuiCol_WindowBg, 0.5f));
    list.AddText({x, y}, ImGui::GetColorU32(ImGuiCol_TextDisabled), part.c_str());
    x += wide + gap;
  }
  if (overlay.message.empty()) return;
  const float wrap = width - 4.0f * edge;
  const ImVec2 size = ImGui::CalcTextSize(overlay.message.c_str(), nullptr, false, wrap);
  if (overlay.windows && !overlay.status.empty()) y = height - over_tools * ImGui::GetFontSize() / 14.0f;
  const ImVec2 at = {edge, y + ImGui::GetFontSize() - size.y - 6.0f};
  const float pad = 7.0f;
  ImDrawList& front = *ImGui::GetForegroundDrawList();  // also over the browser
  front.AddRectFilled({at.x - pad, at.y - pad}, {at.x + size.x + pad, at.y + size.y + pad},
                      ImGui::GetColorU32(ImGuiCol_WindowBg), pad);
  front.AddText(nullptr, 0.0f, at, ImGui::GetColorU32(warning_ink(dark_)), overlay.message.c_str(), nullptr, wrap);
}

void Panel::buttons(const Overlay& overlay) {
  if (overlay.buttons.empty()) return;
  const float edge = 10.0f;
  ImGui::SetNextWindowPos({edge, edge + (overlay.title.empty() ? 0.0f : 1.8f * ImGui::GetFontSize())});
  ImGui::Begin("buttons", nullptr, quiet_window | ImGuiWindowFlags_NoBackground);
  ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_WindowBg));
  for (const std::string& name : overlay.buttons)
    if (ImGui::Button(name.c_str())) pressed_ = name;
  ImGui::PopStyleColor();
  ImGui::End();
}

void Panel::help(const Overlay& overlay, float width, float height) {
  if (overlay.help.empty()) return;
  const float edge = 8.0f, between = 28.0f;
  float keys = 0.0f;
  for (const auto& row : overlay.help) keys = std::max(keys, ImGui::CalcTextSize(row.first.c_str()).x);
  const float wrap = std::max(0.5f * (width - between - 6.0f * edge) - keys - 3.0f * edge, 8.0f * edge);
  ImGui::SetNextWindowPos({0.5f * width, 0.5f * height}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSizeConstraints({0.0f, 0.0f}, {width - edge, height - 0.5f * edge});
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {3.0f, 0.0f});
  ImGui::Begin("keys", nullptr, quiet_window & ~ImGuiWindowFlags_NoScrollbar);
  const auto middle = overlay.help.begin() + static_cast<std::ptrdiff_t>(overlay.help.size() / 2);
  auto heading = overlay.help.end();  // that nearest the middle
  for (auto row = overlay.help.begin(); row != overlay.help.end(); ++row)
    if (row->second.empty() && std::abs(row - middle) < std::abs(heading - middle)) heading = row;
  help_column("left", {overlay.help.begin(), heading}, wrap);
  ImGui::SameLine(0.0f, between);
  help_column("right", {heading, overlay.help.end()}, wrap);
  ImGui::End();
  ImGui::PopStyleVar();
}

}  // namespace pantin
