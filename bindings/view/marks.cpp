#include "view/marks.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace pantin {

namespace {

constexpr double head_angle = 0.45;  // [rad] of an arrow's head, to either side
constexpr double head_part = 0.35;   // of a short arrow that is head
constexpr double head_widths = 5.0;  // length of the head of a long one, in widths of the line

struct Spot {
  double x = 0.0, y = 0.0;  // [px]
};
using Stretch = std::pair<Spot, Spot>;

ImU32 packed(const Color& c) { return ImGui::ColorConvertFloat4ToU32({c.r, c.g, c.b, c.a}); }
ImVec2 imgui(Spot s) { return {static_cast<float>(s.x), static_cast<float>(s.y)}; }

class Screen {
 public:
  Screen(const Camera& camera, int width, int height)
      : camera_(camera), eye_(camera.eye()), forward_(camera.forward()), width_(width), height_(height) {}

  std::optional<Spot> spot(const Mark& mark) const {
    if (mark.on_screen) return on_screen(mark.from);
    const auto seen = finite(mark.from) ? camera_.project(mark.from, width_, height_) : std::nullopt;
    if (!seen || !(std::fabs(seen->x) < far_off) || !(std::fabs(seen->y) < far_off)) return {};
    return Spot{seen->x, seen->y};
  }

  std::optional<Stretch> stretch(const Mark& mark) const {
    if (mark.on_screen) return within({on_screen(mark.from), on_screen(mark.to)});
    Vec3 a = mark.from, b = mark.to;
    if (!finite(a) || !finite(b) || !before_eye(a, b)) return {};
    const auto p = camera_.project(a, width_, height_), q = camera_.project(b, width_, height_);
    if (!p || !q) return {};
    return within({{p->x, p->y}, {q->x, q->y}});
  }

 private:
  static constexpr double far_off = 1e6;  // [px]

  Spot on_screen(Vec3 v) const { return {v[0] < 0.0 ? v[0] + width_ : v[0], v[1] < 0.0 ? v[1] + height_ : v[1]}; }

  /// Cuts off what lies behind the eye; false where all does.
  bool before_eye(Vec3& a, Vec3& b) const {
    const double least = 1.001 * camera_.nearest(), da = dot(a - eye_, forward_), db = dot(b - eye_, forward_);
    if (!(da > least) && !(db > least)) return false;
    if (da < least) a = a + (b - a) * ((least - da) / (db - da));
    if (db < least) b = b + (a - b) * ((least - db) / (da - db));
    return true;
  }

  /// The part near the picture (Liang and Barsky 1984), so that far ends stay drawable.
  std::optional<Stretch> within(Stretch s) const {
    const double dx = s.second.x - s.first.x, dy = s.second.y - s.first.y;
    double from = 0.0, to = 1.0;
    const auto cut = [&](double rate, double room) {  // rate * t <= room
      if (rate == 0.0) return room >= 0.0;
      (rate < 0.0 ? from : to) = rate < 0.0 ? std::max(from, room / rate) : std::min(to, room / rate);
      return from <= to;
    };
    const double wide = 2.0 * width_, high = 2.0 * height_;
    if (!cut(-dx, s.first.x + width_) || !cut(dx, wide - s.first.x) || !cut(-dy, s.first.y + height_) ||
        !cut(dy, high - s.first.y))
      return {};
    const auto at = [&](double t) { return Spot{s.first.x + t * dx, s.first.y + t * dy}; };
    return Stretch{at(from), at(to)};
  }

  const Camera& camera_;
  Vec3 eye_, forward_;
  int width_, height_;
};

/// A sign of the font that stands for a shape: two triangles, smooth at the edge, where the shape itself takes dozens.
class Stamp {
 public:
  explicit Stamp(ImWchar sign) : glyph_(ImGui::GetFont()->FindGlyphNoFallback(sign)) {}
  bool there() const { return glyph_ != nullptr; }
  /// With its upper left corner at a, then round.
  void put(ImDrawList& list, ImVec2 a, ImVec2 b, ImVec2 c, ImVec2 d, ImU32 color) const {
    const ImFontGlyph& g = *glyph_;
    list.AddImageQuad(ImGui::GetFont()->ContainerAtlas->TexID, a, b, c, d, {g.U0, g.V0}, {g.U1, g.V0}, {g.U1, g.V1},
                      {g.U0, g.V1}, color);
  }

 private:
  const ImFontGlyph* glyph_;
};

struct Stamps {
  Stamp disc{0x25cf}, head{0x25b6};
};
constexpr double largest_disc = 16.0;  // [px] that a sign of the font is fine enough for

void draw_disc(ImDrawList& list, const Stamps& stamps, Spot at, double size, ImU32 color) {
  const double r = 0.5 * size;
  if (!stamps.disc.there() || size > largest_disc) return list.AddCircleFilled(imgui(at), static_cast<float>(r), color);
  stamps.disc.put(list, imgui({at.x - r, at.y - r}), imgui({at.x + r, at.y - r}), imgui({at.x + r, at.y + r}),
                  imgui({at.x - r, at.y + r}), color);
}

void draw_arrow(ImDrawList& list, const Stamps& stamps, const Stretch& at, ImU32 color, double width) {
  const double dx = at.second.x - at.first.x, dy = at.second.y - at.first.y, length = std::hypot(dx, dy);
  if (!(length > 0.5)) return;
  const double head = std::min(head_part * length + width, head_widths * width + 4.0), ux = dx / length,
               uy = dy / length;
  const double back = head * std::cos(head_angle), aside = head * std::sin(head_angle);
  const Spot neck = {at.second.x - back * ux, at.second.y - back * uy};
  list.AddLine(imgui(at.first), imgui(neck), color, static_cast<float>(width));
  const double sx = aside * uy, sy = -aside * ux;
  const Spot left = {neck.x + sx, neck.y + sy}, right = {neck.x - sx, neck.y - sy};
  if (stamps.head.there())
    stamps.head.put(list, imgui(left), imgui({at.second.x + sx, at.second.y + sy}),
                    imgui({at.second.x - sx, at.second.y - sy}), imgui(right), color);
  else
    list.AddTriangleFilled(imgui(at.second), imgui(right), imgui(left), color);
}

void draw_text(ImDrawList& list, Spot at, const Mark& mark, ImU32 color, ImU32 halo) {
  const float size = static_cast<float>(mark.size);
  const char* const begin = mark.text.c_str();
  for (const auto& [dx, dy] : {std::pair{-1.0, 0.0}, {1.0, 0.0}, {0.0, -1.0}, {0.0, 1.0}})
    list.AddText(nullptr, size, imgui({at.x + dx, at.y + dy}), halo, begin, begin + mark.text.size());
  list.AddText(nullptr, size, imgui(at), color, begin, begin + mark.text.size());
}

}  // namespace

void draw_marks(ImDrawList& list, std::span<const Mark> marks, const MarkLook& look, const Camera& camera, int width,
                int height) {
  const Screen screen(camera, width, height);
  const Stamps stamps;
  const ImU32 halo = packed(look.halo);
  for (const Mark& mark : marks) {
    const ImU32 color = packed(mark.color.value_or(look.ink));
    if (mark.kind == Mark::Kind::line || mark.kind == Mark::Kind::arrow) {
      const auto at = screen.stretch(mark);
      if (!at) continue;
      if (mark.kind == Mark::Kind::arrow)
        draw_arrow(list, stamps, *at, color, mark.size);
      else
        list.AddLine(imgui(at->first), imgui(at->second), color, static_cast<float>(mark.size));
    } else if (const auto at = screen.spot(mark)) {
      if (mark.kind == Mark::Kind::text)
        draw_text(list, *at, mark, color, halo);
      else if (mark.kind == Mark::Kind::ring)
        list.AddCircle(imgui(*at), static_cast<float>(0.5 * mark.size), color, 0, 2.0f);
      else
        draw_disc(list, stamps, *at, mark.size, color);
    }
  }
}

}  // namespace pantin
