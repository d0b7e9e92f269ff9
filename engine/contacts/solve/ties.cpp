#include "contacts/solve/ties.hpp"

#include "contacts/solve/matrix.hpp"

namespace pantin {

void answer_of_ties(ContactIsland& island, std::vector<BodyLoad>& loads) {
  if (!island.ties_prepared) {
    lay_out_ties(island);
    set_base(island, island.ties_alone, tie_stiffness);
    factorise(island, island.ties_alone, {}, {});
    island.ties_prepared = true;
  }
  loads.assign(island.bodies.size(), {});
  for (IslandTie& t : island.ties) {
    t.u = velocity_of(t, island.bodies, &IslandBody::v, &IslandBody::w) - t.kept * t.wanted;
    add_load(loads, t, t.u * (-tie_stiffness / t.w));
  }
  std::vector<BodyLoad>& change = island.tie_change;
  change.resize(loads.size());
  solve(island, island.ties_alone, loads, change);
  for (std::size_t i = 0; i < change.size(); i++) {
    island.bodies[i].dv = change[i].force;
    island.bodies[i].dw = change[i].moment;
    loads[i] = {};
  }
  for (IslandTie& t : island.ties) {
    const Vec3 du = velocity_of(t, island.bodies, &IslandBody::dv, &IslandBody::dw);
    const Vec3 impulse = (t.u + du) * (-tie_stiffness / t.w);
    t.impulse += impulse;
    add_load(loads, t, t.kept * impulse);
  }
}

void hold_ties(ContactIsland& island) {
  if (island.ties.empty()) return;
  constexpr int rounds = 2;  // each leaves some 1e-7 of what the one before did
  weigh_ties(island);
  start_from_rest(island);
  std::vector<BodyLoad> loads;
  for (IslandTie& t : island.ties) t.impulse = zero3();
  for (int round = 0; round < rounds; round++) {
    answer_of_ties(island, loads);
    for (std::size_t i = 0; i < loads.size(); i++) {
      IslandBody& b = island.bodies[i];
      b.v += loads[i].force * b.inverse_mass;
      b.w += b.mobility * loads[i].moment;
    }
  }
  for (IslandBody& b : island.bodies) {
    b.v0 = b.v;
    b.w0 = b.w;
  }
  for (IslandTie& t : island.ties) t.struck += t.kept * t.impulse;
}

}  // namespace pantin
