// Whatever is edited, laws act on what they would act on if all of them were made anew.
#include <catch2/catch.hpp>
#include <map>
#include <set>
#include <tuple>

#include "forces/forces_parts.hpp"
#include "step/phases.hpp"
#include "support/random_edits.hpp"

using namespace pantin;

namespace {

std::shared_ptr<const Law> library_law(const char* name, std::map<std::string, double> numbers) {
  LawArguments arguments;
  arguments.numbers = std::move(numbers);
  return std::make_shared<const Law>(make_library_law(name, arguments).front());
}

/// 0.01 J/m⁴ (1 m² - r²)² within 1 m, but not between what is one or two connections apart.
std::shared_ptr<const Law> soft_cores() {
  Expressions g;
  const Expr depth = g.subtract(g.constant(1.0), g.input({Role::distance2, 0, 0, {}}));
  LawDef def;
  def.name = "soft cores";
  def.cutoff = 1.0;
  def.exclude = 2;
  const Expr energy = g.scale(g.multiply(depth, depth), 0.01);
  return std::make_shared<Law>(central_potential(def, g, energy));
}

/// A site, told without its number.
struct Told {
  std::tuple<std::uint32_t, std::uint32_t, bool, std::int32_t, bool> binding;  // point, body or tied point, articulate
  std::uint32_t family;
  std::multiset<std::uint32_t> bodies;
  Vec3 arm, x, v, force;
  double inverse_mass;
  std::vector<double> attributes;
};

/// Without laws of velocity, whose forces are those of the last kick [N].
Vec3 still_force(const Forces& f, std::uint32_t i) {
  return f.sites.force[i] + (f.velocity_dependent && !f.still.empty() ? f.still[i] : f.sites.nonconservative_force[i]);
}

std::map<std::uint64_t, Told> told_by_serial(const World& world, const Forces& f) {
  const Sites& s = f.sites;
  std::map<std::uint64_t, Told> list;
  for (std::uint32_t i = 0; i < s.n; i++) {
    if (s.particle[i] == Forces::none) continue;
    Told t{{f.point[i], 0, false, -1, false},
           s.family[i],
           {},
           zero3(),
           s.x[i],
           s.v[i],
           still_force(f, i),
           f.inverse_mass[i],
           {}};
    for (std::uint32_t body : s.bodies_of(i)) t.bodies.insert(body);
    for (const auto& column : s.attributes) t.attributes.push_back(column[i]);
    for (const Attached& a : f.attached) {
      if (a.site != i) continue;
      const Receiver& m = f.receivers[a.receiver];
      const std::int32_t articulate =
          m.is_body ? world.motion[m.slot].articulate : world.points.at_slot(m.slot).articulate;
      t.binding = {Forces::none, m.slot, m.is_body, articulate, a.pulled};
      t.arm = a.arm;
    }
    REQUIRE(list.emplace(s.serial[i], t).second);
    REQUIRE(f.site_of[s.particle[i]] == i);
  }
  return list;
}

/// Serials at the ends of connections, by their serials.
std::map<std::uint64_t, std::vector<std::uint64_t>> bonds_of(const Forces& f) {
  std::map<std::uint64_t, std::vector<std::uint64_t>> list;
  for (const ActingConnections& a : f.connections)
    for (std::size_t k = 0; k < a.ids.size(); k++)
      for (int i = 0; i < a.bond_list.count; i++)
        list[a.serials[k]].push_back(f.sites.serial[a.bond_list.sites[k * static_cast<std::size_t>(a.bond_list.count) +
                                                                      static_cast<std::size_t>(i)]]);
  return list;
}

void check_receivers(const World& world, const Forces& f) {
  std::set<std::uint32_t> used;
  for (const Attached& a : f.attached) used.insert(a.receiver);
  CHECK(used.size() == f.receivers.size());
  for (const Receiver& m : f.receivers) {
    const std::int32_t articulate =
        m.is_body ? world.motion[m.slot].articulate : world.points.at_slot(m.slot).articulate;
    CHECK(m.articulate == articulate);
    if (articulate >= 0)
      CHECK(static_cast<std::int32_t>(m.node) ==
            (m.is_body ? world.motion[m.slot].node : world.points.at_slot(m.slot).node));
  }
}

void check_against_anew(const World& world) {
  Forces& f = *world.forces;
  const std::unique_ptr<Forces> made = build_forces(world);
  REQUIRE(made);
  start(world, *made);
  refresh_ages(world, *made, world.time);
  made->sites.clear_forces();
  const double energy = run_laws(world, *made, instant_of(world, world.time, world.instant), true);
  keep_in_plane(world.plane, made->sites);
  check_receivers(world, f);
  CHECK(bonds_of(f) == bonds_of(*made));
  const auto now = told_by_serial(world, f), anew = told_by_serial(world, *made);
  REQUIRE(now.size() == anew.size());
  double scale = 1e-9, wrong = 0.0;
  for (const auto& [serial, b] : anew) {
    REQUIRE(now.contains(serial));
    const Told& a = now.at(serial);
    CHECK(a.binding == b.binding);
    CHECK(a.family == b.family);
    CHECK(a.bodies == b.bodies);
    CHECK(same(a.arm, b.arm));
    CHECK(same(a.x, b.x));
    CHECK(same(a.v, b.v));
    CHECK(a.inverse_mass == b.inverse_mass);
    CHECK(a.attributes == b.attributes);
    scale = std::max(scale, norm(b.force));
    wrong = std::max(wrong, norm(a.force - b.force));
  }
  CHECK(wrong < 1e-11 * scale);
  CHECK(std::fabs(f.energy - energy) < 1e-11 * (1.0 + std::fabs(energy)));
}

/// Random edits on bodies and dust that attract, are tied, dragged and held off each other.
struct ActingEdits : RandomEdits {
  void prepare(bool everybody) {
    world.settings.gravity = zero3();
    while (world.bodies.size() < 40) add();
    ParticleDef def;
    def.family = dust;
    for (int i = 0; i < 20; i++) {
      def.at = make.place(10.0);
      add_particle(world, def);
    }
    add_interaction(world, soft_cores(), dust, dust);
    add_interaction(world, library_law("repel", {{"stiffness", 2.0}}), dust, dust);
    add_field(world, library_law("drag", {{"linear", 0.1}}), everybody ? AnyId() : AnyId(dust));
  }

  void change_particle() {
    const std::vector<ParticleId> all = world.particles.ids();
    const ParticleId id = awake(world, all[below(all.size())]);
    switch (below(5)) {
      case 0: return set_family(world, id, below(3) > 0 ? dust : FamilyId{});
      case 1: return set_radius(world, id, make.number(0.0, 0.5));
      case 2: return kick(world, world.particles[id].points[0], make.place(0.1));
      case 3: return set_position(world, some_body(), make.place(10.0));
      default: return set_velocity(world, some_body(), make.place(0.1));
    }
  }

  void edit_some() {
    for (std::size_t k = 0; k < 1 + below(3); k++) {
      if (below(3) == 0)
        change_particle();
      else
        edit();
      while (world.bodies.size() < 36) add();
    }
  }
};

}  // namespace

TEST_CASE("acting: after random edits laws act on what they would if they were made anew") {
  const bool everybody = GENERATE(true, false);
  ActingEdits t;
  t.prepare(everybody);
  step(t.world);
  for (int i = 0; i < 400; i++) {
    t.edit_some();
    phases::find_articulates(t.world);
    if (acting_now(t.world)) continue;
    phases::refresh_forces(t.world);
    INFO(i << ": " << t.world.failure);
    REQUIRE(t.world.failure.empty());
    check_against_anew(t.world);
    step(t.world);
    INFO(i << ": " << t.world.failure);
    REQUIRE(t.world.failure.empty());
  }
}
