#include "contacts/turn_back.hpp"

#include <algorithm>
#include <cmath>

#include "articulates/solve/momenta.hpp"
#include "base/sets.hpp"
#include "contacts/gather.hpp"

namespace pantin {

namespace {

/// Part of all moments of inertia below which a turn about an axis has no meaning.
constexpr double least_for_turn = 1e-9;
/// Part of the energy of their motion about their centre that turning things as one may have.
constexpr double most_for_turn = 1e-2, most_of_rebounds = 0.2;

/// The spin with this angular momentum, about the axes that it can have one about.
Vec3 turn_for(const Model& model, const Mat3& inertia, Vec3 angular) {
  if (model.plane.flat()) {
    const Vec3 normal = direction(model.plane.about(vec(1, 1, 1)));
    const double moment = dot(normal, inertia * normal);
    return moment > 0.0 ? normal * (dot(normal, angular) / moment) : zero3();
  }
  const Principal principal = principal_axes(inertia, identity33());
  Vec3 turn = zero3();
  for (int i = 0; i < 3; i++)
    if (principal.moments[i] > least_for_turn * trace(inertia))
      turn += principal.axes[i] * (dot(principal.axes[i], angular) / principal.moments[i]);
  return turn;
}

/// [J]
double energy_about_centre(const std::vector<BodyState>& states, double mass) {
  Vec3 momentum = zero3();
  for (const BodyState& s : states) momentum += s.v * s.mass;
  double sum = 0.0;
  for (const BodyState& s : states)
    sum += 0.5 * (s.mass * norm2(s.v - momentum / mass) + dot(s.w, own_inertia(s) * s.w));
  return sum;
}

/// Scales what of their motion is not that of one body so that all have `more` energy [J], and the same momenta. Returns the work of it [J].
double scale_apart(Model& model, const Articulates& articulates, std::span<const std::uint32_t> things, double more,
                   bool drifted) {
  constexpr double least_scale = 0.5, most_scale = 2.0;
  std::vector<BodyState> points;
  for (const std::uint32_t thing : things)
    points.emplace_back(state_of(model, articulates, thing, drifted)).inverse_inertia = zero3();
  const MotionAsOne one = motion_as_one(model, points);
  const auto apart = [&](const BodyState& s) { return s.v - one.velocity_at(s.x); };
  double energy = 0.0;
  for (const BodyState& s : points) energy += 0.5 * s.mass * norm2(apart(s));
  if (!(energy + more > 0.0 && energy > 0.0)) return 0.0;
  const double scale = std::clamp(std::sqrt(1.0 + more / energy), least_scale, most_scale);
  for (std::size_t i = 0; i < points.size(); i++)
    add_momenta(model, points[i], things[i], apart(points[i]) * (points[i].mass * (scale - 1.0)), zero3());
  return energy * (scale * scale - 1.0);
}

/// About a centre.
Mat3 inertia_of(std::span<const BodyState> states, Vec3 centre) {
  Mat3 inertia = zero33();
  for (const BodyState& s : states) {
    const Vec3 r = s.x - centre;
    inertia += own_inertia(s) + (identity33() * norm2(r) - outer(r, r)) * s.mass;
  }
  return inertia;
}

}  // namespace

Mat3 own_inertia(const BodyState& s) {
  Mat3 turning = zero33();
  for (int i = 0; i < 3; i++)
    if (s.inverse_inertia[i] > 0.0) turning += outer(s.R[i], s.R[i]) * s.inertia[i];
  return turning;
}

MotionAsOne motion_as_one(const Model& model, std::span<const BodyState> states) {
  double mass = 0.0;
  Vec3 centre = zero3(), momentum = zero3(), angular = zero3();
  for (const BodyState& s : states) {
    mass += s.mass;
    centre += s.x * s.mass;
    momentum += s.v * s.mass;
  }
  centre /= mass;
  for (const BodyState& s : states) angular += cross(s.x - centre, s.v * s.mass) + own_inertia(s) * s.w;
  return {centre, momentum / mass, turn_for(model, inertia_of(states, centre), angular)};
}

Vec3 angular_momentum(const Model& model, const Articulates& articulates, std::span<const std::uint32_t> things,
                      bool drifted) {
  Vec3 sum = zero3();
  for (const std::uint32_t thing : things) {
    const BodyState s = state_of(model, articulates, thing, drifted);
    sum += cross(s.x, s.v * s.mass) + own_inertia(s) * s.w;
  }
  return sum;
}

double turn_as_one(Model& model, const Articulates& articulates, std::span<const std::uint32_t> things, Vec3 missing,
                   bool drifted, double most) {
  std::vector<BodyState> states;
  double mass = 0.0;
  Vec3 centre = zero3();
  for (const std::uint32_t thing : things) {
    const BodyState& s = states.emplace_back(state_of(model, articulates, thing, drifted));
    mass += s.mass;
    centre += s.x * s.mass;
  }
  centre /= mass;
  const Mat3 inertia = inertia_of(states, centre);
  Vec3 turn = turn_for(model, inertia, missing);
  const double of_turn = 0.5 * dot(turn, inertia * turn), limit = most * energy_about_centre(states, mass);
  if (of_turn > limit) turn *= std::sqrt(limit / of_turn);
  double work = 0.0;
  for (std::size_t i = 0; i < states.size(); i++) {
    const BodyState& s = states[i];
    work -= kinetic_energy(model, s, things[i]);
    add_momenta(model, s, things[i], model.plane.along(cross(turn, s.x - centre)) * s.mass, own_inertia(s) * turn);
    work += kinetic_energy(model, s, things[i]);
  }
  return work;
}

double turn_back(Model& model, const Articulates& articulates, const TouchIsland& island, bool drifted,
                 std::span<const std::array<std::int32_t, 2>> pushed, std::span<const Vec3> missing) {
  const std::size_t count = island.things.size();
  Sets sets(count);
  std::vector<char> anchored(count, 0);
  const auto index = [](std::int32_t body) { return static_cast<std::size_t>(body); };
  const auto each_articulate = [&](auto f) {
    for (std::size_t k = 0; k < island.articulates.size(); k++)
      f(*articulates[island.articulates[k]], island.first_nodes[k]);
  };
  for (const auto& [a, b] : pushed)
    if (b >= 0) sets.join(index(a), index(b));
  each_articulate([&](const Articulate& a, std::size_t first) {
    for (std::size_t i = 1; i < a.nodes.size(); i++) sets.join(first, first + i);
  });
  for (const auto& [a, b] : pushed)
    if (b < 0) anchored[sets.find(index(a))] = 1;
  each_articulate([&](const Articulate& a, std::size_t first) {
    if (!is_free(a)) anchored[sets.find(first)] = 1;
  });
  std::vector<Vec3> sums(count, zero3());  // of the first of each set
  for (std::size_t i = 0; i < count; i++) sums[sets.find(i)] += missing[i];
  std::vector<std::vector<std::uint32_t>> things(count);  // of each set that is to turn
  for (std::size_t i = 0; i < count; i++)
    if (const std::size_t root = sets.find(i); !anchored[root] && norm2(sums[root]) > 0.0)
      things[root].push_back(island.things[i]);
  const bool rebounds =
      !island.problem.is_tied() && std::any_of(island.problem.contacts.begin(), island.problem.contacts.end(),
                                               [](const IslandContact& c) { return c.restitution > 0.0; });
  double work = 0.0;
  for (std::size_t root = 0; root < count; root++) {
    if (things[root].empty()) continue;
    std::sort(things[root].begin(), things[root].end());
    const double by =
        turn_as_one(model, articulates, things[root], sums[root], drifted, rebounds ? most_of_rebounds : most_for_turn);
    work += by;
    if (rebounds) work += scale_apart(model, articulates, things[root], -by, drifted);
  }
  return work;
}

}  // namespace pantin
