#include "structures/build_plan.hpp"

#include <algorithm>
#include <numeric>

#include "base/check.hpp"
#include "shapes/mass.hpp"
#include "structures/molecule.hpp"

namespace pantin {
namespace {

using Kind = BuildPiece::Kind;

bool is_mixed(const BuildDef& def) { return def.vertices || def.edges || def.faces; }
bool is_whole(const BuildDef& def, BuildAs as) { return def.as == as && !is_mixed(def); }

MassIn mass_in(const BuildDef& def) {
  if (def.mass_in) return *def.mass_in;
  return is_whole(def, BuildAs::articulated) ? MassIn::edges
         : is_whole(def, BuildAs::panels)    ? MassIn::faces
                                             : MassIn::points;
}

void check(const Structure& s, const BuildDef& def) {
  require(!s.vertices.empty(), "build: the structure is empty");
  require(def.mass > 0.0 && std::isfinite(def.mass), "build: mass must be > 0 kg, got ", def.mass);
  require(finite(def.at), "build: at must be finite [m]");
  require(finite(def.velocity), "build: velocity must be finite [m/s]");
  require(!def.radius || (*def.radius >= 0.0 && std::isfinite(*def.radius)), "build: radius must be >= 0 m, got ",
          def.radius.value_or(0.0));
  require(!def.axis || (finite(*def.axis) && norm(*def.axis) > 0.0), "build: axis must be finite and not 0");
  require(!is_whole(def, BuildAs::articulated) || !s.edges.empty(),
          "build: \"articulated\" makes rods of edges, and the structure has none");
  require(!is_whole(def, BuildAs::panels) || !s.faces.empty(),
          "build: \"panels\" makes plates of faces, and the structure has none");
  for (const StructureEdge& e : s.edges)
    require(norm(s.vertices[e[0]] - s.vertices[e[1]]) > 0.0, "build: vertices ", e[0] + 1, " and ", e[1] + 1,
            " have an edge between them and are at one position");
  const MassIn where = mass_in(def);
  require(!def.hull || where == MassIn::points,
          "build: with shape = \"hull\", mass_in is \"points\", or not given: then the hulls are solid");
  require(where == MassIn::points || is_whole(def, BuildAs::rigid) ||
              (where == MassIn::edges && is_whole(def, BuildAs::articulated)) ||
              (where == MassIn::faces && is_whole(def, BuildAs::panels)),
          "build: mass_in is \"points\"; of a rigid whole also \"edges\", \"faces\" or \"solid\", of articulated "
          "\"edges\", of panels \"faces\"");
}

/// Masses of the vertices: alike, or as their elements'.
std::vector<double> shares_of(const Structure& s, double mass) {
  std::vector<double> shares(s.vertices.size(), 1.0);
  for (std::size_t v = 0; v < s.elements.size(); v++) shares[v] = atomic_mass(s.elements[v]);
  const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
  for (double& share : shares) share *= mass / sum;
  return shares;
}

/// What each part becomes.
struct Forms {
  std::vector<BuildAs> vertices, edges, faces;
};

std::vector<BuildAs> forms_of(std::size_t count, const std::function<BuildAs(std::uint32_t)>& form, BuildAs usual) {
  std::vector<BuildAs> forms(count, usual);
  if (form)
    for (std::uint32_t i = 0; i < count; i++) forms[i] = form(i);
  return forms;
}

Forms forms_of(const Structure& s, const BuildDef& def) {
  Forms forms;
  forms.vertices =
      forms_of(s.vertices.size(), def.vertices, is_whole(def, BuildAs::rigid) ? BuildAs::rigid : BuildAs::deformable);
  forms.edges = forms_of(s.edges.size(), def.edges,
                         is_whole(def, BuildAs::articulated) ? BuildAs::articulated : BuildAs::deformable);
  forms.faces =
      forms_of(s.faces.size(), def.faces, is_whole(def, BuildAs::panels) ? BuildAs::panels : BuildAs::deformable);
  for (BuildAs as : forms.vertices)
    require(as <= BuildAs::rigid, "build: a vertex may become \"deformable\" or \"rigid\"");
  for (BuildAs as : forms.edges)
    require(as != BuildAs::panels, "build: an edge may become \"deformable\", \"rigid\" or \"articulated\"");
  for (BuildAs as : forms.faces)
    require(as != BuildAs::articulated, "build: a face may become \"deformable\", \"rigid\" or \"panels\"");
  return forms;
}

/// Vertices that are rigid together, each group with its lowest number for a leader.
class RigidGroups {
 public:
  explicit RigidGroups(std::size_t count) : leader_(count), rigid_(count, 0) {
    std::iota(leader_.begin(), leader_.end(), 0u);
  }
  void unite(std::span<const std::uint32_t> vertices) {
    for (std::uint32_t v : vertices) {
      rigid_[v] = 1;
      const std::uint32_t a = leader(vertices[0]), b = leader(v);
      leader_[std::max(a, b)] = std::min(a, b);
    }
  }
  std::vector<BuildPiece> pieces() {
    std::vector<BuildPiece> pieces;
    std::vector<std::size_t> piece_of(leader_.size());
    for (std::uint32_t v = 0; v < leader_.size(); v++) {
      if (!rigid_[v]) continue;
      const std::uint32_t first = leader(v);
      if (first == v) {
        piece_of[v] = pieces.size();
        pieces.emplace_back();
      }
      pieces[piece_of[first]].vertices.push_back(v);
    }
    return pieces;
  }

 private:
  std::uint32_t leader(std::uint32_t v) {
    while (leader_[v] != v) v = leader_[v] = leader_[leader_[v]];
    return v;
  }
  std::vector<std::uint32_t> leader_;
  std::vector<char> rigid_;
};

/// Rigid vertices with an edge between them, rigid edges and rigid faces; of a rigid whole all are one.
std::vector<BuildPiece> rigid_pieces(const Structure& s, const BuildDef& def, const Forms& forms) {
  RigidGroups groups(s.vertices.size());
  if (is_whole(def, BuildAs::rigid)) {
    std::vector<std::uint32_t> all(s.vertices.size());
    std::iota(all.begin(), all.end(), 0u);
    groups.unite(all);
    return groups.pieces();
  }
  for (std::uint32_t v = 0; v < s.vertices.size(); v++)
    if (forms.vertices[v] == BuildAs::rigid) groups.unite(std::span(&v, 1));
  for (std::size_t e = 0; e < s.edges.size(); e++) {
    const bool both =
        forms.vertices[s.edges[e][0]] == BuildAs::rigid && forms.vertices[s.edges[e][1]] == BuildAs::rigid;
    if (both || forms.edges[e] == BuildAs::rigid) groups.unite(s.edges[e]);
  }
  for (std::size_t f = 0; f < s.faces.size(); f++)
    if (forms.faces[f] == BuildAs::rigid) groups.unite(s.faces[f]);
  return groups.pieces();
}

void add_piece(BuildPlan& plan, BuildPiece piece) {
  for (std::uint32_t v : piece.vertices) plan.pieces_of[v].push_back(static_cast<std::uint32_t>(plan.pieces.size()));
  plan.pieces.push_back(std::move(piece));
}

/// Plates before rods: an edge of a plate needs no rod.
void add_pieces(BuildPlan& plan, const Structure& s, const BuildDef& def, const Forms& forms) {
  for (BuildPiece& piece : rigid_pieces(s, def, forms)) add_piece(plan, std::move(piece));
  for (std::size_t f = 0; f < s.faces.size(); f++)
    if (forms.faces[f] == BuildAs::panels && !plan.in_one_piece(s.faces[f]))
      add_piece(plan, {Kind::plate, s.faces[f], {}, {}});
  for (std::uint32_t e = 0; e < s.edges.size(); e++) {
    if (plan.in_one_piece(s.edges[e])) continue;
    if (forms.edges[e] == BuildAs::articulated)
      add_piece(plan, {Kind::rod, {s.edges[e][0], s.edges[e][1]}, {}, {}});
    else if (forms.edges[e] == BuildAs::deformable)
      plan.ties.push_back(e);
  }
}

/// A vertex shares its mass among all that it is in.
void weigh_points(const BuildPlan& plan, const Structure& s, BuildPiece& piece) {
  Vec3 moment = zero3();
  for (std::uint32_t v : piece.vertices) {
    piece.masses.push_back(plan.shares[v] / static_cast<double>(plan.pieces_of[v].size()));
    piece.spread.mass += piece.masses.back();
    moment += s.vertices[v] * piece.masses.back();
  }
  piece.spread.centre = moment / piece.spread.mass;
}

/// Of a rod in its own frame, whose x axis it is.
MassDistribution rod_spread(const Structure& s, const BuildPiece& rod, double mass) {
  const Vec3 a = s.vertices[rod.vertices[0]], b = s.vertices[rod.vertices[1]];
  const double moment = mass * norm2(b - a) / 12.0;
  return {mass, (a + b) / 2.0, diagonal(vec(0, moment, moment))};
}

/// Hulls of the rigid pieces, filled with what their vertices share.
void add_hulls(BuildPlan& plan, const Structure& s, const BuildDef& def) {
  for (std::size_t i = 0; i < plan.pieces.size(); i++) {
    BuildPiece& piece = plan.pieces[i];
    require(piece.kind == Kind::rigid, "build: shape = \"hull\" is of rigid parts; rods and plates have none");
    std::vector<Vec3> corners;
    for (std::uint32_t v : piece.vertices) corners.push_back(s.vertices[v]);
    try {
      piece.hull = make_hull(corners);
    } catch (const Error& error) { throw Error(text("build: shape: rigid part ", i + 1, ": ", error.what())); }
    if (def.mass_in) continue;
    const double mass = piece.spread.mass;
    const SolidMass solid = solid_mass(piece.hull);
    piece.masses.clear();
    piece.spread = {mass, solid.centre, solid.second * (mass / solid.volume)};
  }
}

void weigh(BuildPlan& plan, const Structure& s, const BuildDef& def) {
  const MassIn where = mass_in(def);
  if (where == MassIn::points) {
    for (BuildPiece& piece : plan.pieces) weigh_points(plan, s, piece);
    return;
  }
  if (def.as == BuildAs::rigid) {
    plan.pieces[0].spread = distribution(s, where, def.mass);
    return;
  }
  const auto size_of = [&](const BuildPiece& piece) {
    return piece.kind == Kind::plate ? area(s, piece.vertices)
                                     : norm(s.vertices[piece.vertices[1]] - s.vertices[piece.vertices[0]]);
  };
  double whole = def.mass;  // but for what vertices have that are in no piece
  for (std::size_t v = 0; v < plan.shares.size(); v++)
    if (plan.pieces_of[v].empty()) whole -= plan.shares[v];
  double sum = 0.0;
  for (const BuildPiece& piece : plan.pieces) sum += size_of(piece);
  for (BuildPiece& piece : plan.pieces) {
    const double mass = whole * size_of(piece) / sum;
    piece.spread = piece.kind == Kind::plate ? distribution(s, piece.vertices, mass) : rod_spread(s, piece, mass);
  }
}

}  // namespace

bool BuildPlan::in_one_piece(std::span<const std::uint32_t> vertices) const {
  for (std::uint32_t piece : pieces_of[vertices[0]]) {
    const auto has = [&](std::uint32_t v) {
      return std::find(pieces_of[v].begin(), pieces_of[v].end(), piece) != pieces_of[v].end();
    };
    if (std::all_of(vertices.begin(), vertices.end(), has)) return true;
  }
  return false;
}

BuildPlan plan_build(const Structure& s, const BuildDef& def) {
  check(s, def);
  BuildPlan plan;
  plan.shares = shares_of(s, def.mass);
  plan.pieces_of.resize(s.vertices.size());
  add_pieces(plan, s, def, forms_of(s, def));
  weigh(plan, s, def);
  if (def.hull) {
    require(!plan.pieces.empty(), "build: shape = \"hull\" is of rigid parts, and there are none");
    add_hulls(plan, s, def);
  }
  return plan;
}

}  // namespace pantin
