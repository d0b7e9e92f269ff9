#include "view/constraint_look.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "constraints/slider.hpp"
#include "model/path.hpp"
#include "view/draw_list.hpp"

namespace pantin {

namespace {

using Line = ConstraintLook::Line;

constexpr double turn = 6.283185307179586;  // [rad]

/// By how much the box shows a constraint's point beside where it is.
Vec3 shift_of(const World& world, const Constraint& c) { return shown_place(world, c.a) - position(world, c.a); }

Vec3 second_end(const World& world, const Constraint& c) { return c.b ? position(world, c.b) : c.position.now; }

Vec3 place(const World& world, const Passage& p) { return p.point ? position(world, p.point) : p.position; }

void draw_nail(const World& world, const Constraint& c, const Stage&, ConstraintLook& look) {
  look.knobs.push_back({c.position.now + shift_of(world, c), 0.0, 1.6, c.kind != ConstraintKind::nail});
}

void draw_rod(const World& world, const Constraint& c, const Stage& stage, ConstraintLook& look) {
  const Vec3 shift = shift_of(world, c), end = second_end(world, c) + shift;
  look.lines.push_back({position(world, c.a) + shift, end, 0.025 * std::min(c.number.now, stage.unit), 0.8, true});
  if (!c.b) look.knobs.push_back({end, 0.0, 1.7});
}

/// Between its two ends; nothing of a limit of an angle.
void draw_thread(const World& world, const Constraint& c, const Stage&, ConstraintLook& look) {
  if (c.a) look.lines.push_back({position(world, c.a), second_end(world, c)});
}

void draw_string(const World& world, const Constraint& c, const Stage& stage, ConstraintLook& look) {
  for (std::size_t i = 1; i < c.passages().size(); i++)
    look.lines.push_back(
        {place(world, c.passages()[i - 1]), place(world, c.passages()[i]), 0.01 * stage.unit, 0.7, false, true});
  for (const Passage& p : c.passages())
    if (!p.point) look.knobs.push_back({p.position, 0.05 * stage.unit});
}

void draw_path(const World&, const Constraint& c, const Stage& stage, ConstraintLook& look) {
  const Path& path = *c.as<PathData>().path;
  const int pieces = (path.smooth() ? 12 : 1) * static_cast<int>(path.pieces());
  const double scale = path.pieces() / pieces;
  for (int i = 0; i < pieces; i++)
    look.lines.push_back(
        {path.position(i * scale), path.position((i + 1) * scale), 0.012 * stage.unit, 0.8, true, false});
}

/// Two unit vectors across another, at right angles.
std::array<Vec3, 2> across(Vec3 normal) {
  const Vec3 u = direction(cross(normal, std::fabs(normal[0]) < 0.7 ? vec(1, 0, 0) : vec(0, 1, 0)));
  return {u, cross(normal, u)};
}

/// A square in the plane, round the point that is on it.
void draw_plane(const World& world, const Constraint& c, const Stage& stage, ConstraintLook& look) {
  const auto [x, y] = across(c.axis_a);
  const Vec3 u = x * (0.4 * stage.unit), v = y * (0.4 * stage.unit), at = position(world, c.a);
  const Vec3 corners[] = {at + u + v, at - u + v, at - u - v, at + u - v};
  for (std::size_t i = 0; i < 4; i++) look.lines.push_back({corners[i], corners[(i + 1) % 4], 0.0, 0.6, false, false});
}

// Couplings.

struct Wheel {
  Vec3 at, axis, mark;  // centre [m], unit vectors; `mark` turns with it
};

/// Its mark was along `contact` when it meshed.
Wheel wheel_of(const World& world, const CoupledValue& v, Vec3 contact) {
  const Vec3 axis = rotate(orientation(world, v.body_a), v.axis_a), at = world.motion_of(v.body_a).x;
  const Vec3 u = direction(contact - axis * dot(contact, axis));
  return {at + image_shift(world, at), axis, u * std::cos(v.angle) + cross(axis, u) * std::sin(v.angle)};
}

/// Corner `i` of a row of teeth and gaps, two to each, which begins in the middle of one: where it is along the row, counted in
/// teeth and gaps, and whether it is of a tooth.
struct Corner {
  double along;
  bool tooth;
};
Corner corner_of(int i) {
  const int which = i >= 0 ? i / 2 : (i - 1) / 2;
  return {which + (i % 2 == 0 ? -0.22 : 0.22), which % 2 == 0};
}

/// How wide a tooth and a gap are [m]: alike all over the scene, but where a wheel is too small for that.
double pitch_of(double smallest, const Stage& stage) { return std::min(0.12 * stage.unit, turn * smallest / 16.0); }

/// A ring that has teeth and gaps, so many all round, where it meets another, at `contact`: a tooth at its mark or a gap.
void draw_ring(const Wheel& wheel, Vec3 contact, double radius, int teeth, bool tooth_first, ConstraintLook& look) {
  const double pitch = turn / teeth, depth = 0.6 * radius * pitch;
  const Vec3 u = wheel.mark, v = cross(wheel.axis, u);
  const auto place = [&](double angle, double out) {
    return wheel.at + (u * std::cos(angle) + v * std::sin(angle)) * out;
  };
  constexpr int sides = 48, shown = 7;  // teeth and gaps to either side of where they meet
  for (int i = 0; i < sides; i++)
    look.lines.push_back(
        {place(turn * i / sides, radius), place(turn * (i + 1) / sides, radius), 0.0, 0.8, true, false});
  const double met = std::atan2(dot(contact, v), dot(contact, u));
  const int middle = 2 * static_cast<int>(std::lround(met / pitch)), all = 2 * std::min(shown, teeth / 2);
  const auto corner = [&](int i) {
    const Corner c = corner_of(i);
    return place(pitch * c.along, radius + (c.tooth == tooth_first ? 0.5 : -0.5) * depth);
  };
  for (int i = middle - all; i < middle + all; i++)
    look.lines.push_back({corner(i), corner(i + 1), 0.0, 1.2, true, false});
}

/// Rings that roll on each other, as far apart as the wheels are: their radii are as the turns say. None where the axes are
/// not parallel, or the wheels sit on one.
void draw_gear(const World& world, const Constraint& c, const Stage& stage, ConstraintLook& look) {
  const CoupledValue &of_a = c.coupled()[0], &of_b = c.coupled()[1];
  const Vec3 axis = rotate(orientation(world, of_a.body_a), of_a.axis_a),
             other = rotate(orientation(world, of_b.body_a), of_b.axis_a);
  Vec3 apart = world.motion_of(of_b.body_a).x - world.motion_of(of_a.body_a).x;
  apart -= axis * dot(apart, axis);
  const double distance = norm(apart), ratio = c.number.now * (dot(axis, other) < 0.0 ? -1.0 : 1.0);
  if (std::fabs(dot(axis, other)) < 0.99 || distance < 0.05 * stage.unit || std::fabs(1.0 - ratio) < 1e-3) return;
  const double radius_b = distance / std::fabs(1.0 / ratio - 1.0), radius_a = radius_b / std::fabs(ratio);
  const bool inner = ratio > 0.0;  // the smaller one rolls in the larger
  const Vec3 from_a = inner && radius_b > radius_a ? apart * -1.0 : apart, from_b = inner ? from_a : apart * -1.0;
  const double pitch = pitch_of(std::min(radius_a, radius_b), stage);
  const auto count = [&](double radius) { return 2 * static_cast<int>(std::lround(0.5 * turn * radius / pitch)); };
  draw_ring(wheel_of(world, of_a, from_a), from_a, radius_a, count(radius_a), true, look);
  draw_ring(wheel_of(world, of_b, from_b), from_b, radius_b, count(radius_b), inner, look);
}

/// The wheel's ring, and a bar with teeth past it.
void draw_rack(const World& world, const Constraint& c, const Stage& stage, ConstraintLook& look) {
  const CoupledValue &of_wheel = c.coupled()[0], &of_rack = c.coupled()[1];
  const Vec3 along = of_rack.body_b ? rotate(orientation(world, of_rack.body_b), of_rack.axis_b) : of_rack.axis_b,
             at = shown_place(world, of_rack.point_a);
  const double radius = std::fabs(c.number.now);
  Wheel wheel = wheel_of(world, of_wheel, zero3());
  Vec3 contact = at - wheel.at;
  contact = direction(contact - along * dot(contact, along) - wheel.axis * dot(contact, wheel.axis));
  wheel = wheel_of(world, of_wheel, contact);
  const int teeth = 2 * static_cast<int>(std::lround(0.5 * turn * radius / pitch_of(radius, stage)));
  const double pitch = radius * turn / teeth, moved = c.number.now * of_wheel.angle;
  draw_ring(wheel, contact, radius, teeth, true, look);
  const int middle = 4 * static_cast<int>(std::lround((dot(at - wheel.at, along) - moved) / (2.0 * pitch)));
  const auto place = [&](int i) {
    const Corner corner = corner_of(i);
    const double out = radius + (corner.tooth ? 0.3 : -0.3) * pitch;
    return wheel.at + contact * out + along * (moved + pitch * corner.along);
  };
  for (int i = middle - teeth; i < middle + teeth; i++)
    look.lines.push_back({place(i), place(i + 1), 0.0, 1.0, true, false});
}

/// The rope over both of its anchors.
void draw_pulley(const World& world, const Constraint& c, const Stage& stage, ConstraintLook& look) {
  std::array<Vec3, 2> anchors;
  for (std::size_t i = 0; i < 2; i++) {
    const CoupledValue& v = c.coupled()[i];
    anchors[i] = v.point_b ? position(world, v.point_b) : v.position;
    look.lines.push_back({position(world, v.point_a), anchors[i], 0.01 * stage.unit, 0.7});
    look.knobs.push_back({anchors[i], 0.05 * stage.unit});
  }
  look.lines.push_back({anchors[0], anchors[1], 0.01 * stage.unit, 0.7});
}

/// A thread of the screw's lead between its points.
void draw_screw(const World& world, const Constraint& c, const Stage& stage, ConstraintLook& look) {
  const Vec3 from = position(world, c.coupled()[1].point_a), to = position(world, c.coupled()[1].point_b);
  const Wheel wheel = wheel_of(world, c.coupled()[0], across(to - from)[0]);
  const double radius = 0.12 * stage.unit, length = norm(to - from);
  const double turns = std::clamp(length / std::fmax(std::fabs(c.number.now), 1e-9), 0.0, 60.0);
  const int pieces = std::max(1, static_cast<int>(12.0 * turns));
  const Vec3 u = wheel.mark, v = cross(wheel.axis, u) * (c.number.now < 0.0 ? -1.0 : 1.0);
  const auto corner = [&](int i) {
    const double angle = turn * turns * i / pieces;
    return from + (to - from) * (static_cast<double>(i) / pieces) +
           (u * std::cos(angle) + v * std::sin(angle)) * radius;
  };
  for (int i = 0; i < pieces; i++) look.lines.push_back({corner(i), corner(i + 1), 0.0, 1.0, true, false});
}

/// The line that its point slides along, as far as its ends.
void draw_slider(const World& world, const Constraint& c, const Stage& stage, ConstraintLook& look) {
  const CoupledValue& v = c.coupled()[static_cast<std::size_t>(SliderValue::along)];
  const Vec3 axis = v.body_b ? rotate(orientation(world, v.body_b), v.axis_b) : v.axis_b,
             zero = v.body_b ? origin(world, v.body_b) + rotate(orientation(world, v.body_b), v.position) : v.position,
             at = position(world, c.a);
  const double slid = dot(at - zero, axis), open = 0.5 * stage.unit;
  const double low = std::isfinite(c.low) ? c.low : slid - open, high = std::isfinite(c.high) ? c.high : slid + open;
  look.lines.push_back({zero + axis * low, zero + axis * high, 0.0, 1.0, true, false});
  for (const double end : {c.low, c.high})
    if (std::isfinite(end)) look.knobs.push_back({zero + axis * end, 0.03 * stage.unit});
}

bool always(const Constraint&) { return true; }
double none(const Constraint&) { return 0.0; }

// (kinds)
constexpr const ConstraintDrawing* drawings[] = {
#define CONSTRAINT_KIND(name) &name##_drawing,
#include "model/constraint_kinds.hpp"
};

}  // namespace

const ConstraintDrawing nail_drawing = {"nail", "nails", draw_nail, always, none};
const ConstraintDrawing follow_drawing = {"tie", "ties", draw_nail, always, none};
const ConstraintDrawing rod_drawing = {"rod", "rods", draw_rod, always,
                                       [](const Constraint& c) { return c.number.now; }};
const ConstraintDrawing axis_drawing, weld_drawing, orient_drawing, align_drawing, motor_drawing;  // not to be seen
const ConstraintDrawing limit_drawing = {"tie", "ties", draw_thread,
                                         [](const Constraint& c) { return static_cast<bool>(c.a); },
                                         [](const Constraint& c) { return c.high; }};
const ConstraintDrawing on_plane_drawing = {"tie", "ties", draw_plane};
const ConstraintDrawing string_drawing = {"string", "strings", draw_string, always};
const ConstraintDrawing on_path_drawing = {"tie", "ties", draw_path};
const ConstraintDrawing join_drawing = {"tie", "ties", draw_thread, always};
const ConstraintDrawing gear_drawing = {"gear", "gears", draw_gear, always};
const ConstraintDrawing rack_drawing = {"rack", "racks", draw_rack, always};
const ConstraintDrawing pulley_drawing = {"pulley", "pulleys", draw_pulley, always};
const ConstraintDrawing screw_drawing = {"screw", "screws", draw_screw, always};
const ConstraintDrawing slider_drawing = {"slider", "sliders", draw_slider, always};

const ConstraintDrawing& drawing_of(const Constraint& c) { return *drawings[static_cast<std::size_t>(c.kind)]; }

void find_look(const World& world, const Constraint& c, const Stage& stage, ConstraintLook& look) {
  look.lines.clear();
  look.knobs.clear();
  const ConstraintDrawing& drawing = drawing_of(c);
  if (!c.enabled || c.hand >= 0 || drawing.draw == nullptr) return;
  drawing.draw(world, c, stage, look);
  const auto lost = [](const Line& l) { return !finite(l.from) || !finite(l.to); };
  std::erase_if(look.lines, lost);
  std::erase_if(look.knobs, [](const ConstraintLook::Knob& k) { return !finite(k.at); });
}

}  // namespace pantin
