// What a report promises, held against motions that are known otherwise.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "bindings/study_support.hpp"
#include "support/reference.hpp"

using namespace pantin;
using namespace pantin::player;
using reference::State;

namespace {

/// Where things are at the times of a study, in the order of their making.
using Truth = std::function<std::vector<std::vector<Vec3>>(const std::vector<double>& times)>;

struct Wrong {
  double mean = 0.0, most = 0.0;  ///< [m]
};

Wrong wrong(const Places& places, const std::vector<Vec3>& truth) {
  REQUIRE(places.size() == truth.size());
  Wrong result;
  for (std::size_t i = 0; i < places.size(); i++) {
    const double square = norm2(places[i].second - truth[i]);
    result.mean += square / static_cast<double>(places.size());
    result.most = std::max(result.most, std::sqrt(square));
  }
  result.mean = std::sqrt(result.mean);
  return result;
}

/// What is nearest to each place at the first time, for all times.
std::vector<std::vector<Vec3>> in_order(const std::vector<std::vector<Vec3>>& truth, const Places& first) {
  std::vector<std::vector<Vec3>> list(truth.size());
  for (const auto& [serial, place] : first) {
    const Vec3 from = place;
    const auto& all = truth.front();
    const auto nearer = [&](const Vec3& a, const Vec3& b) { return norm(a - from) < norm(b - from); };
    const auto i = static_cast<std::size_t>(std::min_element(all.begin(), all.end(), nearer) - all.begin());
    for (std::size_t k = 0; k < truth.size(); k++) list[k].push_back(truth[k][i]);
  }
  return list;
}

std::string name_of(const StudyRun& run) {
  return run.integrator + (run.accuracy > 0 ? text(", accuracy ", run.accuracy) : text(", step 1/", 1.0 / run.step));
}

/// No error of a run is larger than the one promised, over the times that it is promised for; `round_off` [m] is what the
/// truth is known to.
void check_promises(const Study& study, const Truth& truth, double round_off = 1e-10) {
  const auto places = in_order(truth(study.times), study.finest().positions.front());
  std::size_t told = 0;
  for (const StudyRun& run : study.runs) {
    INFO(name_of(run) + text(" until ", study.comparable));
    Wrong worst;
    for (std::size_t k = 0; k < run.positions.size(); k++) {
      const Wrong now = wrong(run.positions[k], places[k]);
      if (study.times[k] <= run.true_until * (1 + 1e-9)) CHECK(now.mean <= 0.01 * study.size);
      if (study.times[k] > study.comparable * (1 + 1e-9)) continue;
      worst = {std::max(worst.mean, now.mean), std::max(worst.most, now.most)};
    }
    if (!std::isfinite(study.error_of(run))) continue;
    CHECK(worst.mean <= study.error_of(run) + round_off);
    CHECK(worst.most <= study.farthest_of(run) + round_off);
    told++;
  }
  CHECK((told > 0 || study.comparable == 0.0));
}

/// Of one ball, from its place and velocity at the times.
Truth ball(const std::function<Vec3(double)>& place) {
  return [place](const std::vector<double>& times) {
    std::vector<std::vector<Vec3>> list;
    for (const double t : times) list.push_back({place(t)});
    return list;
  };
}

/// Of things whose places (3 each) are the first in a state with the time as its last number.
Truth solved(const std::function<State(const State&)>& rate, const State& start, int pieces, std::size_t things = 1) {
  return [=](const std::vector<double>& times) {
    std::vector<std::vector<Vec3>> list;
    State y = start;
    double now = 0.0;
    for (const double t : times) {
      y = reference::integrate(rate, y, t - now, pieces);
      now = t;
      list.emplace_back();
      for (std::size_t i = 0; i < things; i++) {
        const auto k = static_cast<Eigen::Index>(3 * i);
        list.back().push_back(vec(y[k], y[k + 1], y[k + 2]));
      }
    }
    return list;
  };
}

State state(std::initializer_list<double> numbers) {
  State y(static_cast<Eigen::Index>(numbers.size()));
  Eigen::Index i = 0;
  for (const double x : numbers) y[i++] = x;
  return y;
}

/// Height of a ball of 1 kg and radius 0.1 m dropped from 1 m, gravity 9.81, on a wall that pushes by k [N/m] times what it
/// is pressed in, less damping [N s/m] times its speed: parabolas and damped sines one after another.
double bounce(double t, double k, double damping) {
  const double g = 9.81, r = 0.1;
  double y = 1.0, v = 0.0;
  while (true) {
    const double fall = (v + std::sqrt(v * v + 2 * g * (y - r))) / g;  // to the wall
    if (t <= fall) return y + v * t - 0.5 * g * t * t;
    t -= fall;
    v -= g * fall;
    // u = y - r + g/k: u'' = -k u - damping u'
    const double a = 0.5 * damping, w = std::sqrt(k - a * a), u0 = g / k, b = (v + a * u0) / w;
    const auto u = [&](double s) { return std::exp(-a * s) * (u0 * std::cos(w * s) + b * std::sin(w * s)); };
    const auto rate = [&](double s) {
      return std::exp(-a * s) * ((-a * u0 + b * w) * std::cos(w * s) + (-a * b - u0 * w) * std::sin(w * s));
    };
    double low = std::atan2(b * w - a * u0, a * b + u0 * w) / w;  // the lowest
    while (low < 0) low += std::numbers::pi / w;
    double high = low + std::numbers::pi / w;
    for (int i = 0; i < 200; i++) {  // until nothing pushes any more
      const double s = 0.5 * (low + high);
      (k * (u0 - u(s)) - damping * rate(s) > 0 ? low : high) = s;
    }
    if (t <= low) return r - u0 + u(t);
    t -= low;
    y = r - u0 + u(low);
    v = rate(low);
  }
}

/// Height of the centre of a ball of radius 0.1 m dropped from 1 m, gravity 9.81, on a floor that gives back a part of its
/// speed.
double hard_bounce(double t, double restitution) {
  const double g = 9.81, r = 0.1;
  double y = 1.0 - r, v = 0.0;
  while (true) {
    const double fall = (v + std::sqrt(v * v + 2 * g * y)) / g;
    if (t <= fall) return r + y + v * t - 0.5 * g * t * t;
    t -= fall;
    y = 0.0;
    v = restitution * (g * fall - v);
  }
}

/// From the nearest point (1 - e) on the x axis, with constant and half axis 1.
Vec3 kepler(double t, double e) {
  double anomaly = std::fmod(t, 2 * std::numbers::pi) < std::numbers::pi ? 2.0 : 4.0;
  const double mean = std::fmod(t, 2 * std::numbers::pi);
  double low = 0.0, high = 2 * std::numbers::pi;
  for (int i = 0; i < 200; i++) {
    anomaly = 0.5 * (low + high);
    (anomaly - e * std::sin(anomaly) < mean ? low : high) = anomaly;
  }
  return vec(std::cos(anomaly) - e, std::sqrt(1 - e * e) * std::sin(anomaly), 0);
}

/// Attracted by 10/r from the origin, from (-3, 0.02) with 6 m/s along x: the hyperbola in closed form.
Vec3 fly_by(double t) {
  const double mu = 10.0, x0 = -3, y0 = 0.02, vx = 6.0;
  const double r0 = std::hypot(x0, y0), energy = 0.5 * vx * vx - mu / r0, a = mu / (2 * energy);
  const double L = -y0 * vx;  // turns the negative way
  const double ex = 0.0 * L / mu - x0 / r0, ey = -vx * L / mu - y0 / r0;
  const double e = std::hypot(ex, ey), n = std::sqrt(mu / (a * a * a));
  const double h0 = -std::acosh((1 + r0 / a) / e), mean0 = e * std::sinh(h0) - h0;
  double low = -20, high = 20;
  for (int i = 0; i < 300; i++) {
    const double h = 0.5 * (low + high);
    (e * std::sinh(h) - h < mean0 + n * t ? low : high) = h;
  }
  const double along = a * (e - std::cosh(low)), across = a * std::sqrt(e * e - 1) * std::sinh(low);
  const Vec3 p = vec(ex / e, ey / e, 0), q = vec(-p[1], p[0], 0) * (L > 0 ? 1.0 : -1.0);
  return p * along + q * across;
}

/// Links from the origin, from the x axis at rest, as places of their heads' ends and centres.
Truth chain_truth(const reference::PlaneChain& chain, int pieces) {
  return [=](const std::vector<double>& times) {
    std::vector<std::vector<Vec3>> list;
    State y = chain.start;
    double now = 0.0;
    for (const double t : times) {
      y = reference::integrate([&](const State& at) { return reference::rate(chain, at); }, y, t - now, pieces);
      now = t;
      list.emplace_back();
      for (int i = 0; i < static_cast<int>(chain.links.size()); i++) {
        const Eigen::Vector2d c = reference::centre(chain, y, i);
        list.back().push_back(vec(c.x(), c.y(), 0));
      }
    }
    return list;
  };
}

}  // namespace

TEST_CASE("promise: a ball that bounces on a floor, and nothing is told by the order", "[slow]") {
  for (const double restitution : {1.0, 0.7}) {
    const Study study = study_text(
        text("scene:floor {}\n"
             "scene:ball { radius = 0.1, at = vec(0, 1, 0), velocity = vec(1, 0, 0), friction = 0, restitution = ",
             restitution, " }"),
        1.5);
    CHECK(study.touches());
    CHECK_THAT(report_text(study, 1.0), Catch::Contains("Shapes touch in it"));
    check_promises(study, ball([&](double t) { return vec(t, hard_bounce(t, restitution), 0); }));
  }
}

TEST_CASE("promise: a box that slides until friction stops it", "[slow]") {
  const Study study =
      study_text("scene:floor {}\nscene:block { size = 0.2, at = vec(0, 0.1, 0), velocity = vec(3, 0, 0) }", 1.0);
  CHECK(study.touches());
  check_promises(study, ball([](double t) {
                   const double a = 0.5 * 9.81, end = std::min(t, 3.0 / a);
                   return vec(3.0 * end - 0.5 * a * end * end, 0.1, 0);
                 }));
}

TEST_CASE("promise: a ball on a stiff wall, where runs may agree by luck", "[slow]") {
  struct Wall {
    double stiffness, damping;
  };
  for (const Wall& wall : {Wall{1e5, 0.0}, Wall{1e4, 5.0}}) {
    const Study study = study_text(
        text("local p = scene:particle { mass = 1, at = vec(0, 1, 0), velocity = vec(1, 0, 0), radius = 0.1 }\n"
             "scene:field(scene, force.wall { normal = vec(0, 1, 0), damping = ",
             wall.damping, ", stiffness = ", wall.stiffness, " })"),
        2.0);
    check_promises(study, ball([&](double t) { return vec(t, bounce(t, wall.stiffness, wall.damping), 0); }));
  }
}

TEST_CASE("promise: an orbit of eccentricity 0.9", "[slow]") {
  const Study study = study_text(R"(
    scene.gravity = vec(0, 0, 0)
    local p = scene:particle { mass = 1, at = vec(0.1, 0, 0), velocity = vec(0, math.sqrt(19), 0) }
    scene:connect(p, vec(0, 0, 0), force.pair { potential = function(r) return -1 / r end })
  )",
                                 4.0);
  check_promises(study, ball([](double t) { return kepler(t, 0.9); }));
  CHECK(study.comparable == study.until);
}

TEST_CASE("promise: a fly-by that no step resolves is not called chaotic, and what explodes there is no size") {
  const Study study = study_text(R"(
    scene.gravity = vec(0, 0, 0)
    local p = scene:particle { mass = 1, at = vec(-3, 0.02, 0), velocity = vec(6, 0, 0) }
    scene:connect(p, vec(0, 0, 0), force.pair { potential = function(r) return -10 / r end })
  )",
                                 1.0);
  check_promises(study, ball(fly_by));
  CHECK_FALSE(study.chaotic);
  CHECK(study.unresolved());
  CHECK(study.size < 3.1);
  CHECK(study.comparable > 0.35);
  CHECK_THAT(report_text(study, 1.0), Catch::Contains("Unresolved: the finest runs part after 0.4"));
}

TEST_CASE("promise: a driven oscillator, a quartic well, a force that jumps and one that has a kink", "[slow]") {
  struct Case {
    const char* name;
    std::string source;
    Truth truth;
  };
  const auto point = [&](const std::string& at, const std::string& law) {
    return "scene.gravity = vec(0, 0, 0)\nscene:particle { mass = 1, at = vec(" + at +
           ", 0, 0) }\nscene:field(scene, force.point { " + law + " })";
  };
  const Case cases[] = {
      {"driven", point("0", "force = function(p, own, t) return vec(5 * math.sin(7 * t), 0, 0) - 25 * p.position end"),
       solved(
           [](const State& y) {
             return state({y[3], y[4], y[5], 5 * std::sin(7 * y[6]) - 25 * y[0], 0, 0, 1});
           },
           state({0, 0, 0, 0, 0, 0, 0}), 4)},
      {"quartic", point("1", "potential = function(p) return 50 * p.position.x ^ 4 end"),
       solved(
           [](const State& y) {
             return state({y[3], y[4], y[5], -200 * y[0] * y[0] * y[0], 0, 0});
           },
           state({1, 0, 0, 0, 0, 0}), 8)},
      {"where jump", point("1", "force = function(p) return vec(where(p.position.x > 0, -3, 3), 0, 0) end"),
       ball([](double t) {
         const double quarter = std::sqrt(2.0 / 3), s = std::fmod(t, 4 * quarter);
         if (s <= quarter) return vec(1 - 1.5 * s * s, 0, 0);
         if (s <= 3 * quarter) return vec(-1 + 1.5 * (s - 2 * quarter) * (s - 2 * quarter), 0, 0);
         return vec(1 - 1.5 * (s - 4 * quarter) * (s - 4 * quarter), 0, 0);
       })},
      {"max", point("1", "force = function(p) return vec(3 - 400 * math.max(p.position.x - 2, 0), 0, 0) end"),
       ball([](double t) {
         const double w = 20, dip = 3.0 / 400, T = std::sqrt(2.0 / 3), v = 3 * T;  // hits 2 with v
         // beyond: u = x - 2 - dip: u'' = -400 u from u = -dip
         double low = 0.5 * std::numbers::pi / w, high = 1.5 * std::numbers::pi / w;
         const auto u = [&](double s) { return -dip * std::cos(w * s) + v / w * std::sin(w * s); };
         for (int i = 0; i < 200; i++) (u(0.5 * (low + high)) > -dip ? low : high) = 0.5 * (low + high);
         const double period = 2 * T + low, s = std::fmod(t, period);
         if (s <= T) return vec(1 + 1.5 * s * s, 0, 0);
         if (s <= T + low) return vec(2 + dip + u(s - T), 0, 0);
         return vec(1 + 1.5 * (period - s) * (period - s), 0, 0);
       })},
  };
  for (const Case& c : cases) {
    INFO(c.name);
    check_promises(study_text(c.source, 1.5), c.truth);
  }
}

TEST_CASE("promise: a double pendulum, until chaos parts the runs", "[slow]") {
  reference::PlaneChain chain = reference::plane_chain(2);
  for (reference::Link& link : chain.links) link.centre = 1.0, link.inertia = 0.0;
  const Study study = study_text(R"(
    local first = scene:particle { at = vec(1, 0, 0), mass = 1 }
    local second = scene:particle { at = vec(2, 0, 0), mass = 1 }
    scene:rod(vec(0, 0, 0), first)
    scene:rod(first, second)
  )",
                                 30.0);
  check_promises(study, chain_truth(chain, 40), 1e-9);
  CHECK(study.parts());
  CHECK_FALSE(study.unresolved());
  CHECK(study.comparable < study.together);
}

TEST_CASE("promise: two bodies on hinges with a motor between them") {
  // The second link is at the angle of the first and 1 - cos 3t: the sum of Lagrange's two equations.
  const double m = 1, c = 0.5, L = 1, inertia = 1.01 / 12, g = 9.81;
  const auto rate = [&](const State& y) {
    const double t = y[2], a = y[0], w = y[1], b = a + 1 - std::cos(3 * t), v = w + 3 * std::sin(3 * t);
    const double first = m * c * c + L * L * m + inertia, second = m * c * c + inertia, tie = L * m * c;
    const double cosine = tie * std::cos(a - b), sine = tie * std::sin(a - b), bend = 9 * std::cos(3 * t);
    const double push = -g * (m * c + L * m) * std::cos(a) - g * m * c * std::cos(b);
    return state({w, (push - (cosine + second) * bend - sine * (v * v - w * w)) / (first + second + 2 * cosine), 1});
  };
  const Study study = study_text(R"(
    local inertia = vec(1 / 600, 1.01 / 12, 1.01 / 12)
    local function link(x)
      return scene:body { mass = 1, inertia = inertia, at = vec(x, 0, 0),
                          points = { head = vec(-0.5, 0, 0), tail = vec(0.5, 0, 0) } }
    end
    local a, b = link(0.5), link(1.5)
    scene:nail(a.head)
    scene:hinge(a.tail, b.head)
    scene:motor(b, a, { axis = vec(0, 0, 1), angle = function(t) return 1 - math.cos(3 * t) end })
  )",
                                 3.0);
  check_promises(
      study,
      [&](const std::vector<double>& times) {
        std::vector<std::vector<Vec3>> list;
        State y = state({0, 0, 0});
        double now = 0.0;
        for (const double t : times) {
          y = reference::integrate(rate, y, t - now, 20);
          now = t;
          const double b = y[0] + 1 - std::cos(3 * t);
          const Vec3 e = vec(std::cos(y[0]), std::sin(y[0]), 0), f = vec(std::cos(b), std::sin(b), 0);
          list.push_back({vec(0, 0, 0), e * 0.5, e, e + f * 0.5, e + f});
        }
        return list;
      },
      1e-9);
}

TEST_CASE("promise: a kick that falls into whole steps") {
  const Study study = study_text(R"(
    local p = scene:particle { at = vec(0, 0, 0), velocity = vec(1, 0, 0) }
    scene:at(0.71, function() p:kick(vec(0, 3, 0)) end)
  )",
                                 1.0);
  check_promises(study,
                 ball([](double t) { return vec(t, -0.5 * 9.81 * t * t + (t > 0.71 ? 3 * (t - 0.71) : 0.0), 0); }));
}
