// Laws of three and four particles.
#include <cmath>

#include "laws/law_maker.hpp"

namespace pantin {

using Given = LibraryParameter::Given;
using Range = LibraryParameter::Range;

namespace {

constexpr double least_sine2 = 1e-20;  // of an angle; below, particles are in line

std::vector<Law> angle(LawMaker& m) {
  const Symbols3 u = m.position(0) - m.position(1), v = m.position(2) - m.position(1), normal = cross(u, v);
  const Symbol sine = sqrt(dot(normal, normal) + least_sine2 * dot(u, u) * dot(v, v)), cosine = dot(u, v);
  const Symbol bent = apply(Function::atan2, sine, cosine) - m.parameter("angle");
  return {m.many_potential(3, 0.5 * m.parameter("stiffness") * bent * bent)};
}

std::vector<Law> torsion(LawMaker& m) {
  const Symbols3 b1 = m.position(1) - m.position(0), b2 = m.position(2) - m.position(1),
                 b3 = m.position(3) - m.position(2);
  const Symbols3 n1 = cross(b1, b2), n2 = cross(b2, b3);
  const Symbol length2 = dot(b2, b2), zero = m.constant(0.0), one = m.constant(1.0);
  const Symbol least = least_sine2 * length2 * length2 * dot(b1, b1) * dot(b3, b3), size = dot(n1, n1) * dot(n2, n2);
  const Symbol sine = where_less(least, size, sqrt(length2) * dot(b1, n2), zero);
  const Symbol cosine = where_less(least, size, dot(n1, n2), one);
  const Symbol turn = apply(Function::atan2, sine, cosine);
  const Symbol wave = apply(Function::cos, m.parameter("fold") * (turn - m.parameter("angle")));
  return {m.many_potential(4, m.parameter("stiffness") * (1.0 - wave))};
}

}  // namespace

std::vector<LibraryLaw> many_laws() {
  const LibraryParameter stiffness{"stiffness", "J", "k", Given::required, 0.0, Range::not_negative};
  const LibraryParameter present{"angle", "rad", "θ where there is no force", Given::present, std::nan("")};
  return {
      {"angle",
       "V = k (θ - θ0)² / 2 of the angle at the second of three particles; no force where they are in line",
       "E. B. Wilson, J. C. Decius and P. C. Cross, Molecular Vibrations, 1955, ch. 4",
       LawKind::many,
       3,
       {stiffness, present},
       angle},
      {"torsion",
       "V = k (1 - cos(n (φ - φ0))) of the torsion of four particles, IUPAC's sign; no force where three are in line",
       "B. R. Brooks et al., J. Comput. Chem. 4, 1983, p. 187, eq. 4; derivative by the graph's reverse mode",
       LawKind::many,
       4,
       {stiffness, present, {"fold", "1", "n, minima of a turn", Given::optional, 1.0, Range::whole}},
       torsion},
  };
}

}  // namespace pantin
