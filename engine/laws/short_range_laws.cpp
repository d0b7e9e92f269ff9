// Laws of pairs that are 0 beyond a distance of their own.
#include <cmath>

#include "laws/law_maker.hpp"

namespace pantin {

using Given = LibraryParameter::Given;
using Range = LibraryParameter::Range;

namespace {

const double sixth_root_of_2 = 1.122462048309373;  // where Lennard-Jones is least, in sigma

Symbol twelve_six(LawMaker& m, Symbol epsilon, Symbol sigma) {
  const Symbol s = sigma / m.distance();
  return 4.0 * epsilon * (pow(s, 12) - pow(s, 6));
}

std::vector<Law> lennard_jones(LawMaker& m) {
  if (!m.arguments.cutoff) m.def.cutoff = 2.5 * m.value("sigma");
  return {m.central_potential(twelve_six(m, m.parameter("epsilon"), m.parameter("sigma")))};
}

// The repulsive core of Lennard-Jones, lifted to 0 at its end and 0 beyond.
Symbol core(LawMaker& m, Symbol epsilon, Symbol sigma) {
  const Symbol end2 = sixth_root_of_2 * sixth_root_of_2 * pow(sigma, 2);
  return where_less(m.distance2(), end2, twelve_six(m, epsilon, sigma) + epsilon, m.constant(0.0));
}

std::vector<Law> wca(LawMaker& m) {
  if (!m.arguments.cutoff) m.def.cutoff = sixth_root_of_2 * m.value("sigma");
  m.def.shift = false;
  return {m.central_potential(core(m, m.parameter("epsilon"), m.parameter("sigma")))};
}

std::vector<Law> hydrophobic(LawMaker& m) {
  m.set_default("range", 1.6 * m.value("size"));
  if (!m.arguments.cutoff) m.def.cutoff = sixth_root_of_2 * m.value("size") + m.value("range");
  const Symbol size = m.parameter("size"), strength = m.parameter("strength"), range = m.parameter("range");
  const Symbol beyond_core = (m.distance() - sixth_root_of_2 * size) / range;
  const Symbol x = min(max(beyond_core, 0.0), m.constant(1.0));
  const Symbol well = 0.5 * (apply(Function::cos, 3.141592653589793 * x) + 1.0);
  m.def.shift = false;
  return {m.central_potential(core(m, strength, size) - m.parameter("attraction") * strength * well)};
}

std::vector<Law> repel(LawMaker& m) {
  m.def.touching = true;
  const Symbol overlap = max(m.attribute(0, "radius") + m.attribute(1, "radius") - m.distance(), 0.0);
  return {m.central_potential(0.4 * m.parameter("stiffness") * pow(overlap, 2.5))};
}

std::vector<Law> flock(LawMaker& m) {
  if (!m.arguments.cutoff) m.def.cutoff = m.value("sight");
  m.def.one_sided = true;
  const Symbol weight = pow(max(1.0 - m.distance2() / pow(m.parameter("sight"), 2), 0.0), 2);
  const Symbol together = m.parameter("cohesion") - m.parameter("separation") / m.distance2();
  const Symbols3 force = m.displacement() * together + m.relative_velocity() * m.parameter("alignment");
  return {m.pair_force(force * weight)};
}

}  // namespace

std::vector<LibraryLaw> short_range_laws() {
  const LibraryParameter epsilon{"epsilon", "J", "ε", Given::required, 0.0, Range::not_negative};
  const LibraryParameter sigma{"sigma", "m", "σ", Given::required, 0.0, Range::positive};
  return {
      {"lennard_jones",
       "V = 4 ε ((σ/r)¹² - (σ/r)⁶), cut off at 2.5 σ unless it is said where",
       "J. E. Lennard-Jones, Proc. Phys. Soc. 43, 1931, p. 461",
       LawKind::central,
       2,
       {epsilon, sigma},
       lennard_jones},
      {"wca",
       "V = 4 ε ((σ/r)¹² - (σ/r)⁶) + ε up to 2^(1/6) σ, 0 beyond",
       "J. D. Weeks, D. Chandler and H. C. Andersen, J. Chem. Phys. 54, 1971, p. 5237, eq. 4",
       LawKind::central,
       2,
       {epsilon, sigma},
       wca},
      {"hydrophobic",
       "a core as wca's with ε and σ = b, and around it a well -h ε cos²(π x / 2), x = (r - 2^(1/6) b) / w from 0 to "
       "1: "
       "attraction between like (h = 1, tails that shun water), none (0) or repulsion (-1) between others. Makes "
       "droplets, membranes and vesicles of bodies with a head and tails",
       "I. R. Cooke, K. Kremer and M. Deserno, Phys. Rev. E 72, 2005, 011506, eqs. 1 and 4",
       LawKind::central,
       2,
       {{"strength", "J", "ε", Given::required, 0.0, Range::not_negative},
        {"size", "m", "b", Given::required, 0.0, Range::positive},
        {"range", "m", "w; 1.6 b", Given::optional, std::nan(""), Range::positive},
        {"attraction", "1", "h", Given::optional, 1.0, Range::sign}},
       hydrophobic},
      {"repel",
       "balls that touch push with k overlap^1.5, the overlap that of their radii",
       "H. Hertz, J. reine angew. Math. 92, 1882, p. 156",
       LawKind::central,
       2,
       {{"stiffness", "N/m^1.5", "k", Given::required, 0.0, Range::not_negative}},
       repel},
      {"flock",
       "each follows its neighbours: w (c d + a u - s d / r²), d and u the position and velocity of the other relative "
       "to "
       "it, "
       "w = (1 - r²/sight²)²",
       "C. W. Reynolds, Computer Graphics 21 (4), 1987, p. 25",
       LawKind::pair,
       2,
       {{"sight", "m", "beyond it neighbours do not matter", Given::required, 0.0, Range::positive},
        {"separation", "N m", "s", Given::optional, 0.0, Range::not_negative},
        {"alignment", "N s/m", "a", Given::optional, 0.0, Range::not_negative},
        {"cohesion", "N/m", "c", Given::optional, 0.0, Range::not_negative}},
       flock},
  };
}

}  // namespace pantin
