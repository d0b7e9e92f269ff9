#include "view/hand_marks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "view/draw_list.hpp"
#include "view/making.hpp"
#include "view/stroke.hpp"

namespace pantin {

namespace {

constexpr Color danger = {0.86f, 0.16f, 0.18f, 0.95f}, warm = {0.93f, 0.45f, 0.12f, 0.9f},
                cold = {0.20f, 0.50f, 0.85f, 0.9f};
constexpr double reach = 40.0, letters = 14.0;  // [px]

Color faded(Color color, float opacity) { return {color.r, color.g, color.b, opacity}; }
Color mixed(const Color& a, const Color& b, float part) {
  return {a.r + (b.r - a.r) * part, a.g + (b.g - a.g) * part, a.b + (b.b - a.b) * part, a.a + (b.a - a.a) * part};
}

/// Adds marks of one hand.
class Pen {
 public:
  Pen(const Viewport& viewport, const ShownHand& hand, std::vector<Mark>& marks)
      : viewport_(viewport), hand_(hand), color_(hand_color(hand.hand)), marks_(marks) {}

  void cursor() {
    if (hand_.mouse) return;
    const bool down = hand_.use->active();
    ring_on_screen(down ? 13.0 : 20.0, color_);
    Mark dot = on_screen(Mark::Kind::point, down ? 7.0 : 4.0, color_);
    marks_.push_back(dot);
    text(std::to_string(hand_.hand + 1), 12.0, -20.0, color_);
  }

  void hover() {
    switch (hand_.choice.kind) {
      case ToolKind::cut:
        for (const AnyId& thing : cuttable(viewport_, {hand_.x, hand_.y, hand_.x, hand_.y})) target(thing, danger);
        return;
      case ToolKind::remove: return target(pick_thing(viewport_, hand_.x, hand_.y), danger);
      case ToolKind::heat: return brush(viewport_.camera.distance);
      case ToolKind::make:
        if (hand_.use->snaps()) grid();
        if (hand_.choice.variant == 0) held(true);
        return;
      default: return held(false);
    }
  }

  void act() {
    switch (hand_.use->choice().kind) {
      case ToolKind::drag: return force();
      case ToolKind::cut:
      case ToolKind::remove: return stroke();
      case ToolKind::join: return join();
      case ToolKind::push:
        if (!hand_.use->begun_at(viewport_.world)) return;
        arrow(hand_.use->start(viewport_), hand_.use->start(viewport_) + hand_.use->way(viewport_), color_);
        return text(hand_.use->push_story(viewport_), 14.0, 10.0, color_);
      case ToolKind::spin:
        if (!hand_.use->begun_at(viewport_.world)) return;
        arrow(hand_.use->start(viewport_), hand_.use->start(viewport_) + hand_.use->way(viewport_), color_);
        return text(short_number(norm(hand_.use->turn(viewport_))) + " rad/s", 14.0, 10.0, color_);
      case ToolKind::make:
        if (hand_.use->snaps()) grid();
        return hand_.use->choice().is_polygon() ? outline() : made();
      case ToolKind::heat:
        return brush(
            dot(hand_.use->place(viewport_, hand_.x, hand_.y) - viewport_.camera.eye(), viewport_.camera.forward()));
      case ToolKind::nail: return;
    }
  }

 private:
  Mark on_screen(Mark::Kind kind, double size, Color color) const {
    Mark mark;
    mark.kind = kind;
    mark.from = vec(hand_.x, hand_.y, 0);
    mark.on_screen = true;
    mark.size = size;
    mark.color = color;
    return mark;
  }
  void ring_on_screen(double diameter, Color color) { marks_.push_back(on_screen(Mark::Kind::ring, diameter, color)); }
  void ring(Vec3 at, double diameter, Color color) {
    Mark mark;
    mark.kind = Mark::Kind::ring;
    mark.from = at;
    mark.size = diameter;
    mark.color = color;
    marks_.push_back(mark);
  }
  void line(Vec3 from, Vec3 to, Color color, double width) {
    Mark mark;
    mark.from = from;
    mark.to = to;
    mark.size = width;
    mark.color = color;
    marks_.push_back(mark);
  }
  void arrow(Vec3 from, Vec3 to, Color color) {
    line(from, to, color, 3.0);
    marks_.back().kind = Mark::Kind::arrow;
  }
  /// Beside the cursor.
  void text(std::string words, double dx, double dy, Color color) {
    Mark mark = on_screen(Mark::Kind::text, letters, color);
    mark.from = vec(std::max(hand_.x + dx, 0.0), std::max(hand_.y + dy, 0.0), 0);
    mark.text = std::move(words);
    marks_.push_back(mark);
  }

  /// The point under the cursor, or how far the hand reaches.
  void held(bool only_hinged) {
    if (const Held held = pick_held(viewport_, hand_.x, hand_.y))
      ring(shown_place(viewport_.world, held), 26.0, color_);
    else if (!only_hinged)
      ring_on_screen(2.0 * reach, faded(color_, 0.22f));
  }

  /// A thing that would be cut or removed.
  void target(const AnyId& thing, Color color) {
    if (!alive(viewport_.world, thing)) return;
    if (const auto* body = std::get_if<BodyId>(&thing)) {
      const Vec3 middle = seen_place(viewport_, thing).from;
      const auto& points = viewport_.world.bodies[*body].points;
      for (std::size_t i = 0; i < std::min<std::size_t>(points.size(), 64); i++)
        line(middle, shown_place(viewport_.world, points[i]), color, 4.0);
      if (points.size() < 2) ring(middle, 26.0, color);
      return;
    }
    const auto* particle = std::get_if<ParticleId>(&thing);
    const Seen seen =
        particle && !viewport_.world.particles[*particle].is_hinge()
            ? Seen{shown_place(viewport_.world, viewport_.world.particles[*particle].points[0]), zero3(), false}
            : seen_place(viewport_, thing);
    if (seen.tie)
      line(seen.from, seen.to, color, 4.0);
    else
      ring(seen.from, 28.0, color);
  }

  /// The line to what it pulls grows and reddens with the force.
  void force() {
    if (!hand_.use->holding() || !viewport_.world.points.alive(hand_.use->point())) return;
    const auto index = static_cast<std::size_t>(hand_.hand);
    if (index >= viewport_.world.hands.size()) return;
    const Hand& hand = viewport_.world.hands[index];
    if (!viewport_.world.constraints.alive(hand.grab)) return;
    const Constraint& grip = viewport_.world.constraints[hand.grab];
    const double pull = norm(grip.force);
    const bool limited = std::isfinite(grip.max_force) && grip.max_force > 0.0;
    const auto part = static_cast<float>(limited ? std::clamp(pull / grip.max_force, 0.0, 1.0) : 0.5);
    const Vec3 from = shown_place(viewport_.world, grip.a), to = hand_.use->place(viewport_, hand_.x, hand_.y);
    const Color color = mixed(faded(color_, 0.8f), danger, std::sqrt(part));
    line(from, to, color, 1.5 + 4.5 * std::sqrt(static_cast<double>(part)));
    ring(from, 26.0, color);
    text(short_number(pull) + " N" + (limited ? " of " + short_number(grip.max_force) + " N" : ""), 14.0, 10.0, color);
  }

  void stroke() {
    const std::vector<Vec3>& trail = hand_.use->trail();
    for (std::size_t i = 1; i < trail.size(); i++) {
      line(trail[i - 1], trail[i], faded(danger, static_cast<float>(i) / static_cast<float>(trail.size())), 2.5);
      marks_.back().on_screen = true;
    }
  }

  void join() {
    if (!hand_.use->begun_at(viewport_.world)) return;
    const Held other = pick_held(viewport_, hand_.x, hand_.y);
    const bool there = other && other.point != hand_.use->point();
    const Vec3 from = hand_.use->start(viewport_);
    ring(from, 26.0, color_);
    line(from, there ? shown_place(viewport_.world, other) : hand_.use->place(viewport_, hand_.x, hand_.y), color_,
         2.5);
    if (there) ring(shown_place(viewport_.world, other), 26.0, color_);
  }

  /// Points about the cursor that what is made snaps to, across the view.
  void grid() {
    const double step = grid_of(viewport_);
    const Vec3 middle = place_to_make(viewport_, hand_.x, hand_.y, true), forward = viewport_.camera.forward();
    int depth = 0;
    for (int i = 1; i < 3; i++)
      if (std::fabs(forward[i]) > std::fabs(forward[depth])) depth = i;
    constexpr int reach_of_grid = 6;
    for (int a = -reach_of_grid; a <= reach_of_grid; a++)
      for (int b = -reach_of_grid; b <= reach_of_grid; b++) {
        Vec3 by = zero3();
        by[(depth + 1) % 3] = step * a;
        by[(depth + 2) % 3] = step * b;
        Mark dot;
        dot.kind = Mark::Kind::point;
        dot.from = middle + by;
        dot.size = a == 0 && b == 0 ? 7.0 : 3.0;
        dot.color = faded(color_, a == 0 && b == 0 ? 0.9f : 0.5f);
        marks_.push_back(dot);
      }
  }

  void brush(double depth) {
    const double pixel = 2.0 * depth * std::tan(0.5 * viewport_.camera.fov) / viewport_.height;
    ring_on_screen(2.0 * heat_radius(viewport_, depth) / pixel, hand_.choice.variant == 1 ? cold : warm);
  }

  /// What is drawn of a polygon, and its next edges.
  void outline() {
    const std::vector<Vec3>& corners = hand_.use->corners();
    const bool clicks = !hand_.use->active();
    for (std::size_t i = 1; i < corners.size(); i++) line(corners[i - 1], corners[i], color_, 2.5);
    const Vec3 here = clicks ? place_to_make(viewport_, hand_.x, hand_.y, hand_.use->snaps()) : corners.back();
    if (clicks) line(corners.back(), here, color_, 2.5);
    line(here, corners.front(), faded(color_, 0.4f), 1.5);
    ring(corners.front(), 24.0, color_);
  }

  void made_box(const Command& c) {
    for (std::size_t i = 0; i < 8; i++)
      for (std::size_t axis = 1; axis < 8; axis *= 2)
        if ((i & axis) == 0) line(c.position + c.points[i], c.position + c.points[i | axis], color_, 2.0);
  }

  /// What would be made: a line, or the shortest lines between corners, or a ball's outline.
  void made() {
    const Command c = hand_.use->making(viewport_);
    if (c.points.size() == 1 || c.form == MadeForm::wheel) {
      const auto seen = viewport_.project(c.position);
      if (seen) ring(c.position, std::max(6.0, 2.0 * c.radius / seen->pixel), color_);
      return;
    }
    if (c.points.size() == 8) return made_box(c);
    double edge = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < c.points.size(); i++)
      for (std::size_t k = 0; k < i; k++) edge = std::min(edge, norm(c.points[i] - c.points[k]));
    for (std::size_t i = 1; i < c.points.size(); i++)
      for (std::size_t k = 0; k < i; k++)
        if (norm(c.points[i] - c.points[k]) < 1.01 * edge)
          line(c.position + c.points[i], c.position + c.points[k], color_, 2.0);
    for (const PointId end : {c.point, c.other})
      if (viewport_.world.points.alive(end) && hand_.use->choice().variant == 0)
        ring(shown_place(viewport_.world, end), 26.0, color_);
  }

  const Viewport& viewport_;
  const ShownHand& hand_;
  Color color_;
  std::vector<Mark>& marks_;
};

}  // namespace

Color hand_color(std::int32_t hand) {
  static constexpr std::array<Color, 6> colors = {{{0.85f, 0.30f, 0.20f, 1.0f},
                                                   {0.15f, 0.50f, 0.80f, 1.0f},
                                                   {0.20f, 0.60f, 0.30f, 1.0f},
                                                   {0.62f, 0.34f, 0.76f, 1.0f},
                                                   {0.85f, 0.58f, 0.10f, 1.0f},
                                                   {0.10f, 0.60f, 0.62f, 1.0f}}};
  return colors[static_cast<std::size_t>(std::max(hand, 0)) % colors.size()];
}

void mark_hand(const Viewport& viewport, const ShownHand& hand, std::vector<Mark>& marks) {
  Pen pen(viewport, hand, marks);
  pen.cursor();
  if (hand.use->active() || !hand.use->corners().empty())
    pen.act();
  else
    pen.hover();
}

}  // namespace pantin
