// Laws of pairs that reach far, and laws of connections.
#include <cmath>

#include "base/check.hpp"
#include "laws/law_maker.hpp"

namespace pantin {

using Given = LibraryParameter::Given;
using Range = LibraryParameter::Range;

namespace {

std::vector<Law> spring(LawMaker& m) {
  if (!m.is_given("damping")) m.drop({"damping"});
  const Law elastic =
      m.central_potential(0.5 * m.parameter("stiffness") * pow(m.distance() - m.parameter("length"), 2));
  if (!m.is_given("damping")) return {elastic};
  return {elastic, m.central_tension(m.parameter("damping") * m.rate())};
}

std::vector<Law> damper(LawMaker& m) { return {m.central_tension(m.parameter("damping") * m.rate())}; }

std::vector<Law> gravitation(LawMaker& m) {
  const Symbol softened = sqrt(m.distance2() + pow(m.parameter("softening"), 2));
  return {m.central_potential(-m.parameter("constant") * m.product_of("mass") / softened)};
}

std::vector<Law> coulomb(LawMaker& m) {
  return {m.central_potential(m.parameter("constant") * m.product_of("charge") / m.distance())};
}

std::vector<Law> morse(LawMaker& m) {
  const Symbol e = apply(Function::exp, -m.parameter("steepness") * (m.distance() - m.parameter("length")));
  return {m.central_potential(m.parameter("depth") * (e * e - 2.0 * e))};
}

std::vector<Law> buckingham(LawMaker& m) {
  const Symbol repulsion = m.parameter("repulsion") * apply(Function::exp, -m.parameter("steepness") * m.distance());
  return {m.central_potential(repulsion - m.parameter("attraction") * pow(m.distance(), -6))};
}

std::vector<Law> yukawa(LawMaker& m) {
  const Symbol decay = apply(Function::exp, -m.distance() / m.parameter("screening"));
  return {m.central_potential(m.parameter("strength") * decay / m.distance())};
}

std::vector<Law> table(LawMaker& m) {
  const auto& [distances, potentials, tensions] =
      std::tie(m.arguments.distances, m.arguments.potentials, m.arguments.tensions);
  require(potentials.empty() != tensions.empty(), "table: give either potentials [J] or tensions [N], not ",
          potentials.empty() ? "none" : "both");
  require(distances.empty() || distances[0] >= 0.0, "table: the first distance must be >= 0 m, got ", distances[0]);
  if (!m.arguments.cutoff && !distances.empty()) m.def.cutoff = distances.back();
  const int order = tensions.empty() ? 0 : -1;
  const auto spline = std::make_shared<const Spline>(distances, tensions.empty() ? potentials : tensions);
  return {m.central_potential(m.spline(spline, m.distance(), order))};
}

}  // namespace

std::vector<LibraryLaw> pair_laws() {
  const double left_out = std::nan("");
  const LibraryParameter length{"length",       "m",      "at which there is no force",
                                Given::present, left_out, Range::not_negative};
  const auto damping = [](Given given, const char* doc) {
    return LibraryParameter{"damping", "N s/m", doc, given, 0.0, Range::not_negative};
  };
  return {
      {"spring",
       "V = k (r - l)² / 2, with damping c also a tension c dr/dt",
       "R. Hooke, De Potentia Restitutiva, 1678",
       LawKind::central,
       2,
       {{"stiffness", "N/m", "k", Given::required, 0.0, Range::not_negative},
        length,
        damping(Given::optional, "c; without it the spring only stores energy")},
       spring},
      {"damper",
       "tension c dr/dt",
       "Lord Rayleigh, The Theory of Sound, vol. 1, 1877, § 81",
       LawKind::central,
       2,
       {damping(Given::required, "c")},
       damper},
      {"gravitation",
       "V = -G m m' / sqrt(r² + s²)",
       "I. Newton, Principia, 1687, book 3, proposition 7; softening: H. C. Plummer, MNRAS 71, 1911, p. 460",
       LawKind::central,
       2,
       {{"constant", "N m²/kg²", "G", Given::optional, 6.6743e-11, Range::any},
        {"softening", "m", "s", Given::optional, 0.0, Range::not_negative}},
       gravitation},
      {"coulomb",
       "V = k q q' / r",
       "C. A. Coulomb, Premier mémoire sur l'électricité et le magnétisme, 1785",
       LawKind::central,
       2,
       {{"constant", "N m²/C²", "k", Given::optional, 8.9875517873681764e9, Range::any}},
       coulomb},
      {"morse",
       "V = D (exp(-2 a (r - l)) - 2 exp(-a (r - l)))",
       "P. M. Morse, Phys. Rev. 34, 1929, p. 57, eq. 4",
       LawKind::central,
       2,
       {{"depth", "J", "D", Given::required, 0.0, Range::not_negative},
        {"steepness", "1/m", "a", Given::required, 0.0, Range::positive},
        length},
       morse},
      {"buckingham",
       "V = A exp(-B r) - C / r⁶; without bound where r is very small",
       "R. A. Buckingham, Proc. R. Soc. A 168, 1938, p. 264",
       LawKind::central,
       2,
       {{"repulsion", "J", "A", Given::required, 0.0, Range::not_negative},
        {"steepness", "1/m", "B", Given::required, 0.0, Range::positive},
        {"attraction", "J m⁶", "C", Given::required, 0.0, Range::not_negative}},
       buckingham},
      {"yukawa",
       "V = g exp(-r / λ) / r, repulsive where g > 0",
       "H. Yukawa, Proc. Phys.-Math. Soc. Japan 17, 1935, p. 48",
       LawKind::central,
       2,
       {{"strength", "J m", "g"}, {"screening", "m", "λ", Given::required, 0.0, Range::positive}},
       yukawa},
      {"table",
       "a natural cubic spline through given potentials or tensions; straight before the first point, cut off at the "
       "last",
       "C. de Boor, A Practical Guide to Splines, 1978, ch. IV",
       LawKind::central,
       2,
       {},
       table},
  };
}

}  // namespace pantin
