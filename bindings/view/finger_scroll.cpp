#include "view/finger_scroll.hpp"

#include <imgui.h>
#include <imgui_internal.h>

#include <cmath>

namespace pantin {

namespace {

constexpr float least_way = 10.0f;  // [px] that a finger goes before it scrolls

ImGuiWindow* scrollable(ImGuiWindow* window) {
  while (window && window->ScrollMax.y <= 0.0f)
    window = window->Flags & ImGuiWindowFlags_ChildWindow ? window->ParentWindow : nullptr;
  return window;
}

bool is_on_edge(ImGuiWindow& window, ImVec2 at) {
  const bool on_bar = window.ScrollbarY && ImGui::GetWindowScrollbarRect(&window, ImGuiAxis_Y).Contains(at);
  return on_bar || window.TitleBarRect().Contains(at);
}

}  // namespace

bool FingerScroll::take(float x, float y) {
  ImGuiContext& context = *ImGui::GetCurrentContext();
  if (!down_) {
    down_ = true;
    x0_ = x;
    y0_ = y_ = y;
    return false;
  }
  if (!scrolls_ && !refused_ && std::hypot(x - x0_, y - y0_) > least_way) {
    ImGuiWindow* window = scrollable(context.HoveredWindow);
    scrolls_ = window && std::fabs(y - y0_) > std::fabs(x - x0_) && !is_on_edge(*window, {x0_, y0_});
    refused_ = !scrolls_;
    if (scrolls_) {
      window_ = window->ID;
      context.MovingWindow = nullptr;
      ImGui::ClearActiveID();
    }
  }
  if (!scrolls_) return false;
  if (ImGuiWindow* window = ImGui::FindWindowByID(window_)) ImGui::SetScrollY(window, window->Scroll.y + y_ - y);
  y_ = y;
  return true;
}

}  // namespace pantin
