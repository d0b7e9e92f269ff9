#include "view/pick.hpp"

#include <cmath>
#include <limits>

#include "measure/hits.hpp"
#include "view/draw_list.hpp"

namespace pantin {

namespace {

constexpr double hinge_bonus = 4.0;  // [px] a hinge may be farther off and still win

struct Best {
  double score = std::numeric_limits<double>::infinity();  // [px]
  double depth = std::numeric_limits<double>::infinity();  // [m]

  bool take(double new_score, double new_depth) {
    const bool better = new_score < score - 0.5 || (new_score < score + 0.5 && new_depth < depth);
    if (better) *this = {new_score, new_depth};
    return better;
  }
};

struct Sight {
  const World& world;
  const Stage& stage;
  const Camera& camera;
  double x, y;  // [px]
  int width, height;
  double reach;  // [px]

  // Rates a place by its distance on the screen from the rim of a ball; true if it is the best so far.
  bool rate(Best& best, Vec3 place, double radius, double bonus) const {
    const auto seen = finite(place) ? camera.project(place, width, height) : std::nullopt;
    if (!seen) return false;
    const double rim = std::fmax(0.0, std::hypot(seen->x - x, seen->y - y) - radius / seen->pixel);
    return rim <= reach && best.take(rim - bonus, seen->depth);
  }
};

}  // namespace

PointId pick_point(const World& world, const Stage& stage, const Camera& camera, double x, double y, int width,
                   int height, double reach) {
  const Sight sight{world, stage, camera, x, y, width, height, reach};
  Best best;
  PointId found;
  for (std::uint32_t s = 0; s < world.particles.slots(); s++) {
    const Particle& particle = world.particles.at_slot(s);
    if (!world.particles.alive_at(s) || particle.asleep_in || particle.points.empty()) continue;
    const bool hinge = particle.is_hinge(), of_body = static_cast<bool>(world.points[particle.points[0]].body);
    const double radius = hinge || of_body ? 0.05 * stage.unit : drawn_radius(world, particle.points[0], stage);
    const ParticleId id = world.particles.id_at(s);
    if (sight.rate(best, shown_place(world, particle.points[0]), radius, hinge ? hinge_bonus : 0.0))
      found = hinge ? star(world, id) : particle.points[0];
  }
  return found;
}

ParticleId pick_hinge(const World& world, const Stage& stage, const Camera& camera, double x, double y, int width,
                      int height, double reach) {
  const Sight sight{world, stage, camera, x, y, width, height, reach};
  Best best;
  ParticleId found;
  for (std::uint32_t s = 0; s < world.particles.slots(); s++) {
    if (!world.particles.alive_at(s) || !world.particles.at_slot(s).is_hinge()) continue;
    const ParticleId id = world.particles.id_at(s);
    if (sight.rate(best, shown_place(world, star(world, id)), 0.05 * stage.unit, 0.0)) found = id;
  }
  return found;
}

AnyId pick_shape(World& world, const Camera& camera, double x, double y, int width, int height) {
  if (world.shapes.empty()) return {};
  const Ray sight = camera.ray(x, y, width, height);
  const std::vector<Hit> hits = hits_of_endless_ray(world, sight.from, sight.direction);
  if (hits.empty()) return {};
  const BodyId body = world.shapes[hits[0].shape].body;
  return body ? AnyId(body) : AnyId(hits[0].shape);
}

}  // namespace pantin
