// What laws of velocity give, with their derivatives.
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/check.hpp"
#include "forces/velocity_kick_parts.hpp"

namespace pantin {

double working_part(const Mat3& m) {
  const Mat3 sum = m + transpose(m);
  return 0.5 * std::sqrt(norm2(sum[0]) + norm2(sum[1]) + norm2(sum[2]));
}

double turning_rate(const Mat3& slope) {
  const Mat3 twice = slope - transpose(slope);
  return std::sqrt((norm2(twice[0]) + norm2(twice[1]) + norm2(twice[2])) / 8.0);
}

namespace {

/// The antisymmetric matrix nearest to the derivative of a force that does no work by velocity, with which the force comes
/// of the velocity v: a solution near to v does no work then either, however far Newton's iteration has come.
Mat3 turning_part(const Mat3& slope, Vec3 force, Vec3 v) {
  const double square = norm2(v);
  const Mat3 turning = (slope - transpose(slope)) * 0.5;
  if (!(square > 0.0)) return turning;
  Vec3 rest = force - turning * v;
  rest -= v * (dot(rest, v) / square);
  return turning + (outer(rest, v) - outer(v, rest)) * (1.0 / square);
}

}  // namespace

namespace {

/// Lists what a law of pairs answers, or if it was listed before and is not linear puts it in its place.
template <class Ask>
void list_pairs(VelocityForces& k, bool again, std::size_t& number, Ask ask) {
  std::vector<VelocityPair> fresh;
  if (!again) {
    const std::size_t begin = k.pairs.size();
    const bool linear = ask(k.fields, k.pairs);
    k.listed.push_back({begin, k.pairs.size(), linear});
    k.linear &= linear;
    return;
  }
  const VelocityForces::Listed& before = k.listed[number++];
  if (before.linear) return;
  ask(k.fields, fresh);
  assume(fresh.size() == before.end - before.begin);
  for (std::size_t i = 0; i < fresh.size(); i++) {
    VelocityPair& p = k.pairs[before.begin + i];
    fresh[i].impulse = p.impulse;
    fresh[i].at_rest = p.at_rest;
    p = fresh[i];
  }
}

}  // namespace

namespace {

/// Asks the laws themselves; whether one of single particles that does no work by velocity bends.
bool ask_each(const World& world, Forces& f, const Instant& instant, bool thermal, bool again) {
  VelocityForces& k = thermal ? f.thermostats : f.velocity;
  k.fields.clear(f.sites.n);
  if (f.workless) k.workless.clear(f.sites.n);
  bool bends = false;
  std::size_t number = 0;
  each_element(f, [&](ActingElement& a) {
    if (a.solved || !a.law->velocity_dependent || a.law->thermal != thermal) return;
    const auto ask = [&, parameters = a.parameters(world)](SiteSlopes& on_sites, std::vector<VelocityPair>& pairs) {
      return a.on().add_slopes(f.sites, box_of(world), instant, parameters, *world.workers, on_sites, pairs);
    };
    if (a.law->kind != LawKind::point) return list_pairs(k, again, number, ask);
    const bool linear = ask(k.fields, k.pairs);
    k.linear &= linear;
    if (!a.law->workless) return;
    ask(k.workless, k.pairs);
    bends |= !linear;
  });
  return bends;
}

/// A derivative may be 0/0 at rest, as that of |v| v: it is what it tends to there, or 0 where that is no number either.
void take_limits_at_rest(const World& world, Forces& f, const Instant& instant, bool thermal) {
  constexpr double hardly = 1e-100;  // [m/s] its square is still a number
  VelocityForces& k = thermal ? f.thermostats : f.velocity;
  const std::size_t n = f.sites.n;
  const auto all_finite = [&](const SiteSlopes& of) {
    return std::all_of(of.slope.begin(), of.slope.begin() + static_cast<std::ptrdiff_t>(n),
                       [](const Mat3& slope) { return finite(slope); });
  };
  const bool workless = f.workless && !all_finite(k.workless);
  if (!workless && all_finite(k.fields) &&
      std::all_of(k.pairs.begin(), k.pairs.end(), [](const VelocityPair& p) { return finite(p.slope); }))
    return;
  VelocityForces at_hand = k;
  const AlignedVector<Vec3> v = f.sites.v;
  for (std::size_t i = 0; i < n; i++) f.sites.v[i] = vec(1.0, 1.0, 1.0) * (hardly * static_cast<double>(i + 1));
  ask_each(world, f, instant, thermal, true);
  f.sites.v = v;
  const auto mend = [](Mat3& slope, const Mat3& limit) {
    if (!finite(slope)) slope = finite(limit) ? limit : zero33();
  };
  for (std::size_t i = 0; i < n; i++) {
    mend(at_hand.fields.slope[i], k.fields.slope[i]);
    if (f.workless) mend(at_hand.workless.slope[i], k.workless.slope[i]);
  }
  for (std::size_t i = 0; i < k.pairs.size(); i++) mend(at_hand.pairs[i].slope, k.pairs[i].slope);
  k = std::move(at_hand);
}

}  // namespace

void ask_velocity_laws(const World& world, Forces& f, const Instant& instant, bool thermal, bool again) {
  VelocityForces& k = thermal ? f.thermostats : f.velocity;
  const std::size_t n = f.sites.n;
  if (!again) {
    k.pairs.clear();
    k.listed.clear();
    k.linear = k.known = true;
  }
  const bool bends = ask_each(world, f, instant, thermal, again);
  take_limits_at_rest(world, f, instant, thermal);
  k.at.assign(n, zero3());
  std::copy_n(f.sites.v.begin(), n, k.at.begin());
  for (std::size_t i = 0; bends && i < n; i++) {
    const Mat3 turning = turning_part(k.workless.slope[i], k.workless.force[i], k.at[i]);
    k.fields.slope[i] += turning - k.workless.slope[i];
    k.workless.slope[i] = turning;
  }
  const Plane& plane = world.plane;
  if (!plane.flat()) return;
  const auto flatten = [&](Vec3& force, Mat3& slope) {
    force = plane.along(force);
    for (int c = 0; c < 3; c++) slope[c] = c == plane.normal ? zero3() : plane.along(slope[c]);
  };
  for (std::size_t i = 0; i < n; i++) flatten(k.fields.force[i], k.fields.slope[i]);
  for (std::size_t i = 0; f.workless && i < n; i++) flatten(k.workless.force[i], k.workless.slope[i]);
  for (VelocityPair& p : k.pairs) flatten(p.force, p.slope);
}

namespace {

/// What is left of a force without the part by velocity, but for round-off.
Vec3 without(Vec3 force, Vec3 by_velocity) {
  const Vec3 rest = force - by_velocity;
  return norm2(rest) > 1e-28 * norm2(force) ? rest : zero3();
}

Vec3 if_finite(Vec3 force) { return std::isfinite(norm2(force)) ? force : zero3(); }

void find_at_rest(VelocityForces& k, const Forces& f) {
  for (std::size_t i = 0; i < f.sites.n; i++) {
    Vec3 force = k.fields.force[i];
    Mat3 slope = k.fields.slope[i];
    if (f.workless) {
      force -= k.workless.force[i];
      slope -= k.workless.slope[i];
    }
    k.at_rest[i] = without(force, slope * k.at[i]);
  }
  for (VelocityPair& p : k.pairs) p.at_rest = p.workless ? zero3() : without(p.force, p.slope * p.at);
}

void ask_at_rest(const World& world, Forces& f, const Instant& instant) {
  VelocityForces& k = f.velocity;
  const SiteSlopes fields = k.fields, workless = k.workless;
  const std::vector<VelocityPair> pairs = k.pairs;
  const AlignedVector<Vec3> at = k.at, v = f.sites.v;
  std::fill(f.sites.v.begin(), f.sites.v.end(), zero3());
  ask_velocity_laws(world, f, instant, false);
  for (std::size_t i = 0; i < f.sites.n; i++)
    k.at_rest[i] = if_finite(f.workless ? k.fields.force[i] - k.workless.force[i] : k.fields.force[i]);
  assume(k.pairs.size() == pairs.size());
  const std::vector<VelocityPair> resting = std::exchange(k.pairs, pairs);
  for (std::size_t i = 0; i < pairs.size(); i++)
    if (!pairs[i].workless) k.pairs[i].at_rest = if_finite(resting[i].force);
  k.fields = fields;
  k.workless = workless;
  k.at = at;
  f.sites.v = v;
  k.linear = false;
}

}  // namespace

void ask_velocity_laws_first(const World& world, Forces& f, const Instant& instant) {
  VelocityForces& k = f.velocity;
  ask_velocity_laws(world, f, instant, false);
  k.at_rest.resize(f.sites.n);
  k.linear ? find_at_rest(k, f) : ask_at_rest(world, f, instant);
}

Vec3 spared_force(const Forces& f, const VelocityForces& k, std::size_t site, Vec3 v) {
  if (!f.workless) return k.at_rest[site];
  return k.at_rest[site] + k.workless.force[site] + k.workless.slope[site] * (v - k.at[site]);
}

Vec3 spared_force(const VelocityPair& pair, Vec3 all) { return pair.workless ? all : pair.at_rest; }

namespace {

/// How fast a force with this slope changes velocities of a unit mass, by damping or by turning [1/s], at most.
double rate_part(const Mat3& slope) {
  const Mat3 working = slope + transpose(slope);
  double damps = 0.0;
  for (const Vec3& column : working.column)
    damps = std::max(damps, 0.5 * (std::fabs(column[0]) + std::fabs(column[1]) + std::fabs(column[2])));
  return std::max(damps, turning_rate(slope));
}

}  // namespace

void find_velocity_slopes(const World& world, Forces& f, const Instant& instant) {
  ask_velocity_laws_first(world, f, instant);
  const VelocityForces& k = f.velocity;
  f.undamped = f.still;
  for (std::size_t i = 0; i < f.sites.n; i++) {
    f.sites.nonconservative_force[i] += k.fields.force[i];
    f.undamped[i] += spared_force(f, k, i, k.at[i]);
  }
  for (const VelocityPair& p : k.pairs) {
    const Vec3 spared = spared_force(p, p.force);
    const auto add = [&](std::size_t site, double sign) {
      f.sites.nonconservative_force[site] += p.force * sign;
      f.undamped[site] += spared * sign;
    };
    add(p.a, 1.0);
    if (!p.one_sided) add(p.b, -1.0);
  }
}

double fastest_change(const World& world, const Forces& f) {
  if (!f.velocity.known) return 0.0;
  std::vector<double> strength(f.sites.n);
  for (std::size_t i = 0; i < f.sites.n; i++) strength[i] = rate_part(f.velocity.fields.slope[i]);
  for (const VelocityPair& p : f.velocity.pairs) {
    const double felt = rate_part(p.slope) * (p.one_sided ? 1.0 : 2.0);
    strength[p.a] += felt;
    if (!p.one_sided) strength[p.b] += felt;
  }
  double fastest = 0.0;
  for (std::size_t i = 0; i < f.sites.n; i++) {
    double mobility = f.inverse_mass[i];
    if (const std::uint32_t m = receiver_at(f, i); m != Forces::none && f.receivers[m].is_body) {
      const Motion& motion = world.motion[f.receivers[m].slot];
      mobility = 1.0 / motion.mass + norm2(f.attached[f.attached_of[i]].r) * largest(inverse_inertia(motion));
    }
    fastest = std::max(fastest, mobility * strength[i]);
  }
  return fastest;
}

}  // namespace pantin
