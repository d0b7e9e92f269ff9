#include "choreography/hands.hpp"

#include <utility>

#include "choreography/commands.hpp"
#include "edit/common.hpp"
#include "edit/edit.hpp"
#include "forces/integrator.hpp"
#include "measure/reach.hpp"

namespace pantin {

using namespace internal;

namespace {

constexpr std::int32_t most_hands = 256;

Hand& hand_at(World& world, const char* call, std::int32_t hand) {
  const auto index = static_cast<std::size_t>(hand);
  require(hand >= 0 && index < world.hands.size(), call, ": there is no hand ", hand + 1, "; there are ",
          world.hands.size());
  return world.hands[index];
}

void place(Hand& hand, Vec3 at, double h) {
  hand.velocity = hand.placed && h > 0.0 ? (at - hand.position) / h : zero3();
  hand.position = at;
  hand.placed = true;
}

void press(World& world, std::int32_t index, bool pressed) {
  Hand& hand = world.hands[static_cast<std::size_t>(index)];
  if (hand.pressed == pressed) return;
  hand.pressed = pressed;
  notice(world, pressed ? Notice::Kind::press : Notice::Kind::release, {}, "", index);
}

void move_hands(World& world, const StepInput& input, double time) {
  const double h = time - world.time;
  for (const HandMove& move : input.moves) {
    if (!finite(move.position)) require_finite(text("hand ", move.hand + 1), "position", move.position, "m");
    hand_of_input(world, move.hand);
  }
  for (Hand& hand : world.hands) hand.velocity = zero3();
  for (const HandMove& move : input.moves) {
    Hand& hand = world.hands[static_cast<std::size_t>(move.hand)];
    if (hand.path) continue;
    place(hand, move.position, h);
    press(world, move.hand, move.pressed);
  }
  for (std::size_t i = 0; i < world.hands.size(); i++) {
    if (!world.hands[i].path) continue;
    const Vec3 at = world.hands[i].path(time);
    if (!finite(at)) require_finite(text("hand ", i + 1), "path", at, "m");
    place(world.hands[i], at, h);
  }
}

}  // namespace

Hand& hand_of_input(World& world, std::int32_t hand) {
  require(hand >= 0 && hand < most_hands, "hand: its number must be 1 to ", most_hands, ", got ", hand + 1);
  const auto index = static_cast<std::size_t>(hand);
  if (index >= world.hands.size()) world.hands.resize(index + 1);
  return world.hands[index];
}

std::int32_t add_hand(World& world, std::function<Vec3(double)> path) {
  require_unlocked(world, "hand");
  require(world.hands.size() < static_cast<std::size_t>(most_hands), "hand: there are ", most_hands, " already");
  Hand hand;
  if (path) {
    const Vec3 at = present(world, path);
    require_finite("hand", "path", at, "m");
    place(hand, at, 0.0);
    hand.path = std::move(path);
  }
  world.hands.push_back(std::move(hand));
  return static_cast<std::int32_t>(world.hands.size()) - 1;
}

bool internal::let_go(World& world, ConstraintId constraint) {
  const Constraint& c = world.constraints[constraint];
  if (c.hand < 0 || world.hands[static_cast<std::size_t>(c.hand)].grab != constraint) return false;
  world.hands[static_cast<std::size_t>(c.hand)].grab = {};
  notice(world, Notice::Kind::drop, c.a, describe(world, c.a), c.hand);
  return true;
}

namespace {

/// A follow is as stiff as the mass of its articulate asks for; what connections tie to that is to be moved too.
double answer(const World& world, PointId point) {
  return std::sqrt(mass(world, tied_to(world, point, false)) / mass(world, tied_to(world, point, true)));
}

}  // namespace

void grab(World& world, std::int32_t index, PointId point, std::optional<double> max_force) {
  require_unlocked(world, "grab");
  const IntegratorRule& rule = rule_of(world);
  require(rule.kicks && !rule.backwards, "grab: the integrator \"", name_of(rule.integrator),
          "\" cannot move what a hand pulls with a limited force");
  require(hand_at(world, "grab", index).placed, "grab: hand ", index + 1, " has no position yet");
  require(world.points.alive(point), "grab: ", world.points.story(point));
  if (max_force) require_positive_or_infinite("grab", "max_force", *max_force, "N");
  FollowDef def;
  def.hand = index;
  def.max_force = max_force ? *max_force : usual_grab_force(world, point);
  def.time_constant *= answer(world, point);
  if (!std::isfinite(def.max_force)) require_free_of_holders(world, "grab", point, hand_at(world, "grab", index).grab);
  release(world, index);
  const ConstraintId follow = add_follow(world, point, def);
  hand_at(world, "grab", index).grab = follow;
  notice(world, Notice::Kind::grab, point, describe(world, point), index);
}

void release(World& world, std::int32_t index) {
  require_unlocked(world, "release");
  const ConstraintId held = hand_at(world, "release", index).grab;
  if (held) remove(world, held);
}

double usual_grab_force(const World& world, PointId point) {
  const Things hanging = tied_to(world, point, true);
  const double total = mass(world, hanging), weight = norm(world.settings.gravity);
  if (weight > 0.0) return 20.0 * total * weight;
  const Bounds box = bounds(world, hanging);
  const double size = norm(box.high - box.low);
  constexpr double patience = 0.2;  // [s]
  // A thing without size moves by its drawn size, or 1 m.
  const double drawn = world.points[point].radius;
  return 2.0 * total * (size > 0.0 ? size : drawn > 0.0 ? drawn : 1.0) / (patience * patience);
}

void apply_input(World& world, double time) {
  const StepInput input = std::exchange(world.input, {});
  const Acting acting(world);
  world.locked = true;  // paths and targets are functions of time: they look and answer
  move_hands(world, input, time);
  carry_out(world, input.commands);
}

}  // namespace pantin
