// Laws of single particles.
#include <cmath>

#include "base/check.hpp"
#include "laws/law_maker.hpp"

namespace pantin {

using Given = LibraryParameter::Given;
using Range = LibraryParameter::Range;

namespace {

constexpr double pi = 3.141592653589793;

// Towards the velocity u of what surrounds a particle: (linear + quadratic |u - v|) (u - v).
Symbols3 drag_towards(LawMaker& m, const Symbols3& u) {
  const Symbols3 relative = u - m.velocity();
  Symbol factor = m.parameter("linear");
  if (m.is_given("quadratic")) factor = factor + m.parameter("quadratic") * sqrt(dot(relative, relative));
  return relative * factor;
}

void check_drag(LawMaker& m) {
  require(m.is_given("linear") || m.is_given("quadratic"), m.def.name,
          ": linear [N s/m] or quadratic [N s²/m²] must be given");
  if (!m.is_given("quadratic")) m.drop({"quadratic"});
}

std::vector<Law> drag(LawMaker& m) {
  check_drag(m);
  const Symbol zero = m.constant(0.0);
  return {m.point_force(drag_towards(m, {zero, zero, zero}))};
}

std::vector<Law> wind(LawMaker& m) {
  check_drag(m);
  return {m.point_force(drag_towards(m, m.vector("velocity")))};
}

Symbols3 unit(const Symbols3& v) { return v * pow(dot(v, v), -0.5); }

std::vector<Law> vortex(LawMaker& m) {
  check_drag(m);
  const Symbols3 axis = unit(m.vector("axis")), from_centre = m.position(0) - m.vector("centre");
  const Symbols3 around = cross(axis, from_centre);
  const Symbol swirl = m.parameter("circulation") / (2.0 * pi * (pow(m.parameter("core"), 2) + dot(around, around)));
  return {m.point_force(drag_towards(m, around * swirl))};
}

// Energy of displaced liquid: the integral of the volume of the ball under the surface, over its depth.
std::vector<Law> buoyancy(LawMaker& m) {
  const Symbol radius = m.attribute(0, "radius"), depth = m.parameter("surface") - m.position(0)[1] + radius;
  const Symbol diameter = 2.0 * radius, wet = min(max(depth, 0.0), diameter), deeper = max(depth - diameter, 0.0);
  const Symbol cap = pi / 3.0 * (radius * pow(wet, 3) - 0.25 * pow(wet, 4));
  const Symbol ball = 4.0 / 3.0 * pi * pow(radius, 3) * deeper;
  return {m.point_potential(m.parameter("density") * m.parameter("gravity") * (cap + ball))};
}

std::vector<Law> thermostat(LawMaker& m) {
  const Symbol drag = m.parameter("rate") * m.attribute(0, "mass");
  const Symbol kick = sqrt(2.0 * drag * m.parameter("boltzmann") * m.parameter("temperature") / m.parameter("step"));
  Law law = m.point_force(m.noise() * kick - m.velocity() * drag);
  law.thermal = true;
  return {law};
}

std::vector<Law> wall(LawMaker& m) {
  const bool damped = m.is_given("damping"), rough = m.is_given("friction");
  if (!damped) m.drop({"damping"});
  if (!rough) m.drop({"friction", "slip"});
  const Symbols3 normal = unit(m.vector("normal"));
  const Symbol overlap = max(m.attribute(0, "radius") - dot(normal, m.position(0) - m.vector("through")), 0.0);
  const Symbol elastic = m.parameter("stiffness") * overlap;
  std::vector<Law> made = {m.point_potential(0.5 * elastic * overlap)};
  if (!damped && !rough) return made;
  const Symbol speed = dot(normal, m.velocity()), zero = m.constant(0.0);
  Symbol load = elastic;
  if (damped) load = where_less(zero, overlap, max(elastic - m.parameter("damping") * speed, 0.0), zero);
  Symbols3 force = normal * (load - elastic);
  if (rough) {
    const Symbols3 sliding = m.velocity() - normal * speed;
    const Symbol size = sqrt(dot(sliding, sliding) + pow(m.parameter("slip"), 2));
    force = force - sliding * (m.parameter("friction") * load / size);
  }
  made.push_back(m.point_force(force));
  return made;
}

}  // namespace

std::vector<LibraryLaw> point_laws() {
  const LibraryParameter linear{"linear", "N s/m", "c", Given::optional, 0.0, Range::not_negative};
  const LibraryParameter quadratic{"quadratic", "N s²/m²", "q", Given::optional, 0.0, Range::not_negative};
  const auto vector = [](const char* name, const char* unit, const char* doc, Given given, Range range) {
    return LibraryParameter{name, unit, doc, given, 0.0, range, true};
  };
  return {
      {"drag",
       "-(c + q |v|) v",
       "G. G. Stokes, Trans. Camb. Phil. Soc. 9, 1851, p. 8 (linear); Newton, Principia, 1687, book 2 (quadratic)",
       LawKind::point,
       1,
       {linear, quadratic},
       drag},
      {"wind",
       "drag in air that moves with velocity u: (c + q |u - v|) (u - v)",
       "as drag",
       LawKind::point,
       1,
       {vector("velocity", "m/s", "u", Given::required, Range::any), linear, quadratic},
       wind},
      {"vortex",
       "drag in air that circles an axis: u = Γ s / (2 π (core² + s²)) at distance s from it",
       "W. Kaufmann, Ingenieur-Archiv 31, 1962, p. 1",
       LawKind::point,
       1,
       {vector("centre", "m", "a point of the axis", Given::optional, Range::any),
        vector("axis", "1", "direction that the air circles by the right-hand rule", Given::required, Range::direction),
        {"circulation", "m²/s", "Γ"},
        {"core", "m", "distance where the air is fastest", Given::required, 0.0, Range::positive},
        linear,
        quadratic},
       vortex},
      {"buoyancy",
       "a ball is lifted along y by the weight of the liquid that it displaces",
       "Archimedes, On Floating Bodies, book 1, propositions 5 to 7; volume of a cap: π h² (3 R - h) / 3",
       LawKind::point,
       1,
       {{"density", "kg/m³", "of the liquid", Given::required, 0.0, Range::not_negative},
        {"surface", "m", "height y of the surface", Given::optional, 0.0, Range::any},
        {"gravity", "m/s²", "weight per mass", Given::optional, 9.81, Range::not_negative}},
       buoyancy},
      {"thermostat",
       "-γ m v + sqrt(2 γ m k T / h) noise, k Boltzmann's constant and h the step of the scene, in the middle of each "
       "drift: particles in a harmonic well spread as at T at any step, and free ones have its velocities; in a well "
       "in "
       "which they swing at ω the velocities, and with them scene.temperature, are those of T (1 - (ω h)²/4)",
       "P. Langevin, C. R. Acad. Sci. 146, 1908, p. 530; the splitting BAOAB: B. Leimkuhler and C. Matthews, Appl. "
       "Math. "
       "Res. Express 2013, p. 34",
       LawKind::point,
       1,
       {{"rate", "1/s", "γ", Given::required, 0.0, Range::not_negative},
        {"temperature", "K", "T", Given::required, 0.0, Range::not_negative},
        {"boltzmann", "J/K", "k", Given::world, std::nan("")},
        {"step", "s", "h", Given::world, std::nan("")}},
       thermostat},
      {"wall",
       "a ball that reaches behind a plane is pushed out: N = max(k overlap - c v_n, 0), with friction μ N against its "
       "sliding v, as v / sqrt(v² + slip²)",
       "P. A. Cundall and O. D. L. Strack, Géotechnique 29, 1979, p. 47",
       LawKind::point,
       1,
       {vector("through", "m", "a point of the plane", Given::optional, Range::any),
        vector("normal", "1", "out of the wall", Given::required, Range::direction),
        {"stiffness", "N/m", "k", Given::required, 0.0, Range::not_negative},
        {"damping", "N s/m", "c", Given::optional, 0.0, Range::not_negative},
        {"friction", "1", "μ", Given::optional, 0.0, Range::not_negative},
        {"slip", "m/s", "speed below which friction is less than full", Given::optional, 1e-6, Range::positive}},
       wall},
  };
}

}  // namespace pantin
