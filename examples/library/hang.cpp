// Two rods on a nail over a floor, and two stars that attract each other by a law of one's own.
#include <cstdio>
#include <pantin/pantin.hpp>

using namespace pantin;

int main() {
  World world;
  add_shape(world, {.geometry = HalfSpaceShape{}, .orientation = turn_to(vec(0, 1, 0))});  // y is up, in m
  BodyDef rod{.points = {{.at = vec(-0.5, 0, 0)}, {.at = vec(0.5, 0, 0)}},
              .shapes = {{.geometry = BoxShape{vec(0.5, 0.05, 0.05)}}}};  // its mass: volume times density
  rod.at = vec(0.5, 1.5, 0);
  const BodyId first = add_body(world, rod);
  rod.at = vec(1.5, 1.5, 0);
  const BodyId second = add_body(world, rod);
  add_nail(world, world.bodies[first].points[0]);
  add_hinge(world, std::vector{world.bodies[first].points[1], world.bodies[second].points[0]});

  Expressions graph;
  const Symbol distance2{&graph, graph.input({.role = Role::distance2})};                             // m²
  const Law law = central_potential({.name = "attraction"}, graph, (-2.0 * pow(distance2, -0.5)).e);  // J
  const FamilyId stars = add_family(world, {.name = "stars"});
  for (const double x : {-1.0, 1.0}) add_particle(world, {.at = vec(x, 9, 0), .family = stars});
  add_interaction(world, std::make_shared<Law>(law), stars, stars);

  while (world.time < 1.0) step(world);  // each of world.settings.step
  const Vec3 at = origin(world, second);
  std::printf("after %g s at %.3f %.3f m, %zu contacts, gap %.0e m, energy error %.0e\n", world.time, at[0], at[1],
              world.contacts.list.size(), world.worst.hinge_gap, world.worst.energy);
}
