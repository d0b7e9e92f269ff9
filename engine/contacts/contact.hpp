#pragma once
// What goes through time of things that touch: their contacts, with the impulses of the last step to begin with.
#include <array>
#include <cstdint>
#include <optional>
#include <tuple>
#include <vector>

#include "articulates/rest.hpp"
#include "base/handle.hpp"
#include "base/lanes.hpp"
#include "model/group.hpp"

namespace pantin {

/// Things that touch are known by the slot of a body; or, with a bit more, by that of a free point.
constexpr std::uint32_t point_bit = 1u << 30;
constexpr std::uint32_t point_thing(std::uint32_t slot) { return slot | point_bit; }
constexpr bool is_point(std::uint32_t thing) { return (thing & point_bit) != 0; }
constexpr std::uint32_t slot_of(std::uint32_t thing) { return thing & ~point_bit; }

/// Which features of which shapes meet: lasts as long as they do.
struct ContactKey {
  std::uint32_t a = 0, b = 0;  ///< slots of Model::shapes, or things that are points
  std::uint32_t part = 0;      ///< of b: a triangle of a mesh
  std::uint32_t feature = 0;
  friend auto operator<=>(const ContactKey&, const ContactKey&) = default;
  bool same_shapes(const ContactKey& k) const { return a == k.a && b == k.b; }
};

/// How a shape is round where it touches: what turns there is its core, or what of it is not about an axis.
struct Roundness {
  double radius = 0.0;  ///< [m] of the surface about the core; of a cylinder its own
  Vec3 axis = zero3();  ///< of a cylinder, in the world; else 0
};

/// A point at which two shapes touch, or soon may. Shape a is a body's, or a solid point.
struct Contact {
  ContactKey key;
  std::uint32_t body_a = 0;  ///< thing
  std::int32_t body_b = -1;  ///< thing, or -1: the world
  Vec3 normal = zero3();     ///< from b to a, of unit length
  Vec3 at = zero3();  ///< [m] world: where impulses act, between the surfaces; of a point and a shape in the point
  double gap = 0.0;   ///< [m] below 0: overlap
  double size = 1.0;  ///< [m] thickness of the smaller shape: lengths are held against it
  double friction = 0.0, restitution = 0.0;
  double rolling = 0.0, spinning = 0.0;  ///< [m] moment by normal force against rolling, against spinning on the spot
  Roundness round_a, round_b;
  Vec3 belt = zero3();  ///< [m/s] by which the surface of a moves on it, less that of b
  /// [N s], and [N m s] of rolling and spinning, on a: of the pass before the drift, which keeps shapes from overlapping;
  Vec3 place_impulse = zero3(), place_moment = zero3();
  /// of all the step, which the velocities after it have.
  Vec3 total = zero3(), total_moment = zero3();
  std::int32_t place_index = -1;  ///< of what `place` gave it, among all of the pass, as long as it lasts; -1: nothing
  double approach = 0.0;          ///< [m/s] along the normal at the start of the step, below 0: nearing
  double gap_before = 0.0;        ///< [m] at the start of the step, 0 at least
  double rebound = 0.0;           ///< [m/s] that `place` foresaw after the first impact; 0: it foresaw none
  double turning = 0.0;           ///< [m] by how much turning alone was foreseen to move it in the drift
  bool foreseen = false;          ///< it is where a motion within the step will take a to b:
  Vec3 arm_a = zero3(), arm_b = zero3();  ///< [m] at these arms impulses act then
  /// A foreseen one that held in the last drift: for `meet` it stands for those that its shapes have now.
  bool from_before = false;
  /// `place` solved its island and what is tied in it: the drift tells how well it foresaw.
  bool checks_drift = false;
  /// Of the size: by how much drifts of the last step that were so checked closed it more than was foreseen.
  double closed_beyond = 0.0;
};

/// An impulse that was given before a drift.
struct Placing {
  std::uint32_t body_a;    ///< thing
  std::int32_t body_b;     ///< thing, or -1: the world
  std::uint32_t shape_b;   ///< slot
  Vec3 impulse;            ///< [N s] on a
  Vec3 moment;             ///< [N m s] on a, of rolling and spinning
  Vec3 arm_a, arm_b;       ///< [m] then, world axes
  Vec3 normal;             ///< then
  bool foreseen;           ///< its contact was: taken back as it was given
  Vec3 turned;             ///< [N m s] by how much it changed the angular momentum of both, where it was foreseen
  std::int32_t a, b;       ///< the bodies in their island; -1: the world
  Vec3 core_a = zero3();   ///< [m] arm to what turns with a, then: of what is round not to its surface
  bool rolled_on = false;  ///< the two roll on to its contact in the drift: taken back as it was given
};

/// What touch does around each drift, with a search of its own.
enum class Pass : std::uint8_t {
  place,    ///< before the drift: impulses that keep shapes from overlapping in it
  meet,     ///< after it: the impulses of the whole step
  push_out  ///< between them: what overlaps is displaced
};
constexpr std::size_t number(Pass pass) { return static_cast<std::size_t>(pass); }

/// What is known of a body that touches, from step to step.
struct TouchedBody {
  std::array<std::uint8_t, 3> failures{}, wait{};  ///< (passes) in a row of exact searches; solves until the next
  Rest rest;                                       ///< of one that nothing ties
  std::int32_t island = -1;  ///< while it sleeps in touch: the same number in all that sleep with it
};

/// Part of the size: a gap that is as good as closed.
constexpr double closed_gap = 1e-5;
constexpr double held_gap = 1e-2;  ///< the same of one that `place` held: that may be left of what was to be closed

/// Two that touch: particles before bodies before shapes of the world.
struct TouchPair {
  AnyId a, b;
  friend auto operator<=>(const TouchPair&, const TouchPair&) = default;
};

/// How two pressed on each other in a step, or in a stage of it.
struct Touch {
  TouchPair pair;
  Vec3 at = zero3();                ///< [m] mean, by impulse
  Vec3 normal = zero3();            ///< from b to a: of unit length
  double impulse = 0.0;             ///< [N s] along the normal; 0 of a sensor
  double speed = 0.0;               ///< [m/s] with which they neared each other
  std::optional<double> heat = {};  ///< [J] where kept: what friction and impact took of them in the step
};

/// What friction and impact took of two that touch.
struct TouchHeat {
  TouchPair pair;     ///< none: of those of whom one is gone
  double heat = 0.0;  ///< [J] below 0: a moving surface gave
  double last = 0.0;  ///< [J] the part of the last step
};

/// Two shapes that overlapped deeply where an edit put them.
struct PutOverlap {
  std::uint32_t a = 0, b = 0;  ///< slots of shapes, or things that are points
  double depth = 0.0;          ///< [m] then
  std::uint64_t due = 0;       ///< number of the step after which what nothing stops is out by half
};

/// Two shapes, of which the first came through the second from behind: they do not touch until it is out.
struct PassingPair {
  std::uint32_t a = 0, b = 0;  ///< as of a key
  friend auto operator<=>(const PassingPair&, const PassingPair&) = default;
};

/// The deepest overlap so far, of those that are deep for the size of the thinner.
struct DeepestOverlap {
  TouchPair pair;
  double depth = 0.0;  ///< [m]
  double part = 0.0;   ///< of the thickness of the thinner; 0: none was deep
  double time = 0.0;   ///< [s]
};

struct Contacts {
  std::vector<Contact> list;        ///< by key
  std::vector<Contact> sensed;      ///< by key: those of sensors, which no pass knows
  std::vector<TouchedBody> bodies;  ///< (slots of bodies)
  std::vector<TouchedBody> points;  ///< (slots of points) of those that are solid; they sleep in no touch
  double drift = 0.0;               ///< [s] length of the last one: in it contacts gave their `total`
  double work = 0.0;                ///< [J] done by `place`, with what ties answered: told with the rest of the step
  std::vector<Contact> resting;     ///< by key: between things of which none is awake. They are in no other list,
  std::vector<Contact> resting_sensed;  ///< nor are those of sensors
  std::vector<std::uint32_t> sleepers;  ///< slots of bodies that sleep in touch, rising
  std::uint64_t sleep_changes = 0;      ///< how often those became others
  Vec3 slept_position = zero3();        ///< [kg m] sum of mass times position of those of them that nothing ties
  double slept_depth = 0.0;             ///< [m] deepest overlap of those that rest
  bool stale = true;                    ///< positions or shapes changed since they were found
  std::uint8_t shallow_left = 0;        ///< steps since shallow overlaps were pushed out

  DeepestOverlap deepest;
  std::vector<PutOverlap> put;       ///< by shapes, until they are due
  std::vector<PassingPair> passing;  ///< rising

  bool watched = false;             ///< somebody wants to be told who begins and ends to touch
  std::vector<Touch> felt;          ///< where watched: in this step so far, of each stage
  std::vector<TouchPair> touching;  ///< where watched: at the end of the last step, rising

  bool heat_kept = false;           ///< somebody asked what friction and impact take of whom
  std::vector<TouchHeat> new_heat;  ///< where kept: in this stage so far, by impulse
  std::vector<TouchHeat> heat;      ///< where kept: since then, by pair, rising
};

/// Whether one of the two is a point.
inline bool is_of_point(const Contact& c) {
  return is_point(c.body_a) || (c.body_b >= 0 && is_point(static_cast<std::uint32_t>(c.body_b)));
}

/// [m] Where two surfaces meet, in the middle between them.
inline Vec3 between(const Contact& c) {
  const bool in_point = is_point(c.body_a) && !(c.body_b >= 0 && is_point(static_cast<std::uint32_t>(c.body_b)));
  return in_point ? c.at - c.normal * (c.round_a.radius + 0.5 * c.gap) : c.at;
}

/// Forgets contacts of what is gone.
void drop_contacts(Contacts& contacts, std::uint32_t thing);

}  // namespace pantin
