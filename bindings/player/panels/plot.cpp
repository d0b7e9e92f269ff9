#include "player/panels/plot.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace pantin::player {
namespace {

constexpr std::size_t most_looks = 48;  // values that a column of pixels looks at

/// What a probe recorded, by the steps of the table of times.
struct Curve {
  const Probe& probe;
  const Times& times;

  std::size_t size() const { return times.values.size(); }
  double value(std::size_t i) const {
    const std::uint64_t step = times.first_step + i;
    if (step < probe.first_step || step - probe.first_step >= probe.values.size())
      return std::numeric_limits<double>::quiet_NaN();
    return probe.values[step - probe.first_step];
  }
  /// The first index at a time or later.
  std::size_t index(double time) const {
    std::size_t low = 0, high = size();
    while (low < high) {
      const std::size_t middle = low + (high - low) / 2;
      times.values[middle] < time ? low = middle + 1 : high = middle;
    }
    return low;
  }
};

struct Extent {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void add(double x) {
    if (!std::isfinite(x)) return;
    low = std::fmin(low, x);
    high = std::fmax(high, x);
  }
  bool empty() const { return low > high; }
};

/// Of the values with indices in [from, to), of which some are looked at.
Extent extent(const Curve& curve, std::size_t from, std::size_t to) {
  Extent result;
  const std::size_t stride = std::max<std::size_t>(1, (to - from) / most_looks);
  for (std::size_t i = from; i < to; i += stride) result.add(curve.value(i));
  if (to > from) result.add(curve.value(to - 1));
  return result;
}

struct Frame {
  ImVec2 from, to;  // [px]
  double start, end, low, high;

  float x(double time) const { return from.x + (to.x - from.x) * static_cast<float>((time - start) / (end - start)); }
  float y(double value) const { return to.y - (to.y - from.y) * static_cast<float>((value - low) / (high - low)); }
};

void draw_curve(ImDrawList& list, const Frame& frame, const Curve& curve) {
  const ImU32 ink = ImGui::GetColorU32(ImGuiCol_CheckMark);
  const std::size_t first = curve.index(frame.start), last = std::min(curve.index(frame.end) + 1, curve.size());
  const auto columns = static_cast<std::size_t>(frame.to.x - frame.from.x);
  if (last - first <= 2 * columns) {  // each value is seen
    for (std::size_t i = first > 0 ? first - 1 : 0; i < last; i++)
      list.PathLineTo({frame.x(curve.times.values[i]), frame.y(curve.value(i))});
    return list.PathStroke(ink, 0, 1.5f);
  }
  float before = 0.0f;
  for (std::size_t c = 0; c < columns; c++) {
    const std::size_t from = first + (last - first) * c / columns, to = first + (last - first) * (c + 1) / columns;
    const Extent e = extent(curve, from, to);
    if (e.empty()) continue;
    const float x = frame.from.x + static_cast<float>(c), low = frame.y(e.low), high = frame.y(e.high);
    list.AddLine({x, std::fmax(low, high) + 0.75f}, {x, std::fmin(low, high) - 0.75f}, ink, 1.0f);
    if (c > 0) list.AddLine({x - 1.0f, before}, {x, 0.5f * (low + high)}, ink, 1.0f);
    before = 0.5f * (low + high);
  }
}

void number(ImDrawList& list, ImVec2 at, double value, float right_of = 0.0f) {
  char label[32];
  std::snprintf(label, sizeof label, "%.4g", value);
  const float size = 0.8f * ImGui::GetFontSize();
  at.x -= right_of * ImGui::CalcTextSize(label).x * 0.8f;
  list.AddText(nullptr, size, at, ImGui::GetColorU32(ImGuiCol_TextDisabled), label);
}

/// Zooms, shifts, and tells the value under the pointer.
void handle(PlotRange& range, const Frame& frame, const Curve& curve, ImDrawList& list) {
  const ImGuiIO& io = ImGui::GetIO();
  const double length = frame.end - frame.start, per_pixel = length / static_cast<double>(frame.to.x - frame.from.x);
  const double under = frame.start + per_pixel * static_cast<double>(io.MousePos.x - frame.from.x);
  if (ImGui::IsItemActive() && io.MouseDelta.x != 0.0f) {
    const double by = -per_pixel * static_cast<double>(io.MouseDelta.x);
    range = {frame.start + by, frame.end + by, false};
  }
  if (!ImGui::IsItemHovered()) return;
  if (io.MouseWheel != 0.0f) {
    const double factor = std::pow(0.8, static_cast<double>(io.MouseWheel));
    range = {under + factor * (frame.start - under), under + factor * (frame.end - under), false};
  }
  if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) range.all = true;
  const std::size_t i = std::min(curve.index(under), curve.size() - 1);
  if (!std::isfinite(curve.value(i))) return;
  const ImVec2 at = {frame.x(curve.times.values[i]), frame.y(curve.value(i))};
  list.AddLine({at.x, frame.from.y}, {at.x, frame.to.y}, ImGui::GetColorU32(ImGuiCol_TextDisabled));
  list.AddCircleFilled(at, 3.0f, ImGui::GetColorU32(ImGuiCol_Text));
  ImGui::SetTooltip("%.6g at %.4f s", curve.value(i), curve.times.values[i]);
}

}  // namespace

void follow(PlotRange& range, const Times& times) {
  if (!range.all || times.values.empty()) return;
  range.from = times.values.front();
  range.to = std::fmax(times.values.back(), range.from + 1e-3);
}

void plot(const Probe& probe, const Times& times, PlotRange& range, float high) {
  const Curve curve{probe, times};
  const float wide = ImGui::GetContentRegionAvail().x;
  const ImVec2 from = ImGui::GetCursorScreenPos(), to = {from.x + wide, from.y + high};
  ImGui::InvisibleButton(probe.name.c_str(), {wide, high});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(from, to, ImGui::GetColorU32(ImGuiCol_FrameBg), 5.0f);
  const std::size_t first = curve.index(range.from), last = curve.index(range.to);
  Extent e;
  const std::size_t parts = 64;
  for (std::size_t p = 0; p < parts && last > first; p++) {
    const Extent part = extent(curve, first + (last - first) * p / parts, first + (last - first) * (p + 1) / parts);
    if (part.empty()) continue;
    e.add(part.low);
    e.add(part.high);
  }
  if (e.empty()) return number(list, {from.x + 4.0f, from.y + 2.0f}, 0.0);
  const double margin = std::fmax(0.08 * (e.high - e.low), 1e-9 * std::fmax(std::fabs(e.high), 1e-300));
  const Frame frame{from, to, range.from, range.to, e.low - margin, e.high + margin};
  list.PushClipRect(from, to, true);
  if (e.low < 0.0 && e.high > 0.0)
    list.AddLine({from.x, frame.y(0.0)}, {to.x, frame.y(0.0)}, ImGui::GetColorU32(ImGuiCol_Separator));
  draw_curve(list, frame, curve);
  number(list, {from.x + 4.0f, from.y + 1.0f}, e.high);
  number(list, {from.x + 4.0f, to.y - ImGui::GetFontSize()}, e.low);
  number(list, {to.x - 4.0f, to.y - ImGui::GetFontSize()}, range.to, 1.0f);
  handle(range, frame, curve, list);
  list.PopClipRect();
}

}  // namespace pantin::player
