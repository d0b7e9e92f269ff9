#include "structures/build.hpp"

#include <algorithm>

#include "structures/build_plan.hpp"

namespace pantin {
namespace {

using Kind = BuildPiece::Kind;

/// Turns the x axis to a direction.
Quat along(Vec3 direction) {
  if (direction[0] < 0.0) return along(-direction) * Quat{0, 0, 0, 1};  // half a turn about z before
  const Vec3 x = vec(1, 0, 0), half = x + direction / norm(direction);
  const Vec3 h = half / norm(half), v = cross(x, h);
  return {dot(x, h), v[0], v[1], v[2]};
}

PointDef point_def(const BuildDef& def, Vec3 at, double mass) {
  PointDef point;
  point.family = def.family;
  point.at = at;
  point.mass = mass;
  point.radius = def.radius.value_or(0.0);
  point.color = def.color;
  return point;
}

/// The frame is at the centre of mass; of a rod x lies along it.
BodyDef body_def(const Structure& s, const BuildDef& def, const BuildPiece& piece) {
  BodyDef body;
  body.at = piece.spread.centre + def.at;
  body.velocity = def.velocity;
  if (def.color) body.color = *def.color;
  if (piece.masses.empty()) {
    body.mass = piece.spread.mass;
    body.inertia = piece.spread.inertia;
  }
  if (piece.hull) {
    body.shapes = {*def.hull};
    body.shapes[0].geometry = moved(*piece.hull, -piece.spread.centre);
    body.shapes[0].color = body.color;
    body.inertia = zero33();  // the shape's
  }
  if (piece.kind == Kind::rod) {
    const Vec3 whole = s.vertices[piece.vertices[1]] - s.vertices[piece.vertices[0]];
    body.orientation = along(whole);
  }
  for (std::size_t i = 0; i < piece.vertices.size(); i++) {
    Vec3 at = s.vertices[piece.vertices[i]] - piece.spread.centre;
    if (piece.kind == Kind::rod) at = vec(i == 0 ? -norm(at) : norm(at), 0, 0);
    body.points.push_back(point_def(def, at, piece.masses.empty() ? 0.0 : piece.masses[i]));
  }
  return body;
}

/// Numbers of the vertices that have an edge with each vertex, rising.
std::vector<std::vector<std::uint32_t>> neighbours_of(const Structure& s) {
  std::vector<std::vector<std::uint32_t>> neighbours(s.vertices.size());
  for (const StructureEdge& e : s.edges) {
    neighbours[e[0]].push_back(e[1]);
    neighbours[e[1]].push_back(e[0]);
  }
  for (auto& list : neighbours) std::sort(list.begin(), list.end());
  return neighbours;
}

class Construction {
 public:
  Construction(World& world, const Structure& structure, const BuildDef& def)
      : world_(world), s_(structure), def_(def), plan_(plan_build(structure, def)) {}

  void make() {
    for (const BuildPiece& piece : plan_.pieces) built.bodies.push_back(add_body(world_, body_def(s_, def_, piece)));
    make_particles();
    if (def_.edge.law)
      for (std::uint32_t e : plan_.ties) tie(def_.edge, s_.edges[e]);
    if (def_.angle.law || def_.torsion.law) make_angles_and_torsions();
    built.group = add_group(world_, def_.name);
    for (ParticleId p : built.particles) add_to_group(world_, built.group, p);
    for (BodyId b : built.bodies) add_to_group(world_, built.group, b);
    for (ConnectionId c : built.connections) add_to_group(world_, built.group, c);
  }

  /// Takes out what was made so far.
  void undo(std::size_t notices) {
    for (BodyId body : built.bodies) remove(world_, body);
    for (ParticleId particle : free_) remove(world_, particle);
    world_.notices.resize(notices);
  }

  Built built;

 private:
  void make_particles() {
    std::vector<std::vector<PointId>> points(s_.vertices.size());
    for (std::size_t k = 0; k < plan_.pieces.size(); k++)
      for (std::size_t i = 0; i < plan_.pieces[k].vertices.size(); i++)
        points[plan_.pieces[k].vertices[i]].push_back(world_.bodies[built.bodies[k]].points[i]);
    for (std::size_t v = 0; v < s_.vertices.size(); v++) {
      if (points[v].empty()) {
        free_.push_back(add_particle(world_, particle_def(v)));
        built.particles.push_back(free_.back());
      } else if (points[v].size() == 1) {
        built.particles.push_back(world_.points[points[v][0]].own);
      } else {
        HingeDef hinge;
        hinge.axis = def_.axis;
        built.particles.push_back(add_hinge(world_, points[v], hinge));
      }
    }
  }

  ParticleDef particle_def(std::size_t vertex) const {
    ParticleDef particle;
    particle.at = s_.vertices[vertex] + def_.at;
    particle.velocity = def_.velocity;
    particle.mass = plan_.shares[vertex];
    particle.radius = def_.radius;
    particle.color = def_.color;
    particle.family = def_.family;
    return particle;
  }

  void tie(const BuildLaw& law, std::span<const std::uint32_t> vertices) {
    ConnectionDef connection;
    connection.solve = law.solve;
    connection.parameters = law.values;
    for (std::uint32_t v : vertices) connection.ends.push_back({built.particles[v], zero3()});
    for (std::size_t i = 0; i < law.law->parameters.size(); i++)
      if (law.law->parameters[i].present) connection.parameters[i] = present_value(world_, connection.ends);
    built.connections.push_back(add_connection(world_, law.law, connection));
  }

  bool in_line(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const Vec3 u = s_.vertices[b] - s_.vertices[a], v = s_.vertices[c] - s_.vertices[b];
    return norm(cross(u, v)) <= 1e-6 * norm(u) * norm(v);
  }

  void tie_unless_rigid(const BuildLaw& law, std::span<const std::uint32_t> vertices) {
    if (!plan_.in_one_piece(vertices)) tie(law, vertices);
  }

  /// Angles between edges that meet at a vertex; torsions about an edge, but for three vertices in line, which have none.
  void make_angles_and_torsions() {
    const auto neighbours = neighbours_of(s_);
    if (def_.angle.law)
      for (std::uint32_t v = 0; v < neighbours.size(); v++)
        for (std::size_t i = 0; i < neighbours[v].size(); i++)
          for (std::size_t j = i + 1; j < neighbours[v].size(); j++)
            tie_unless_rigid(def_.angle, std::array{neighbours[v][i], v, neighbours[v][j]});
    if (!def_.torsion.law) return;
    for (const StructureEdge& e : s_.edges)
      for (std::uint32_t a : neighbours[e[0]])
        for (std::uint32_t d : neighbours[e[1]])
          if (a != e[1] && d != e[0] && a != d && !in_line(a, e[0], e[1]) && !in_line(e[0], e[1], d))
            tie_unless_rigid(def_.torsion, std::array{a, e[0], e[1], d});
  }

  World& world_;
  const Structure& s_;
  const BuildDef& def_;
  const BuildPlan plan_;
  std::vector<ParticleId> free_;
};

void check_law(const BuildLaw& law, int count, const char* name) {
  if (!law.law) return;
  const int ties = law.law->kind == LawKind::point ? 1 : law.law->kind == LawKind::many ? law.law->count : 2;
  require(ties == count, "build: the law of ", name, " must tie ", count, " particles, got one that ",
          ties == 1 ? "acts on " : "ties ", ties);
}

}  // namespace

Built build(World& world, const Structure& structure, const BuildDef& def) {
  require(!world.locked, "build: things cannot be made while the world steps; do it in an event or a step callback");
  check_law(def.edge, 2, "edges");
  check_law(def.angle, 3, "angles");
  check_law(def.torsion, 4, "torsions");
  Construction construction(world, structure, def);
  const std::size_t notices = world.notices.size();
  try {
    construction.make();
  } catch (...) {
    construction.undo(notices);
    throw;
  }
  return std::move(construction.built);
}

}  // namespace pantin
