// `pantin bench forces`: laws run over neighbour rows and connections, against loops written by hand for one law.
#include <time.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/check.hpp"
#include "base/random.hpp"
#include "laws/bonds.hpp"
#include "laws/cells.hpp"
#include "laws/pairs.hpp"
#include "laws/rows.hpp"
#include "laws/skin.hpp"
#include "player/bench.hpp"

namespace pantin {

namespace {

constexpr double cutoff = 2.5, width = 0.3, dt = 0.005;
const std::vector<std::uint32_t> everybody = {0};

/// [s] Of one thread the time of the processor, which others on the machine do not lengthen; of more that of the clock.
double now(const Workers& workers) {
  timespec time;
  clock_gettime(workers.count() == 1 ? CLOCK_THREAD_CPUTIME_ID : CLOCK_MONOTONIC, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

std::shared_ptr<const Law> lennard_jones() {
  Expressions g;
  const Expr r6 = g.power(g.input({Role::distance2, 0, 0, {}}), -3.0);
  const Expr potential = g.scale(g.subtract(g.multiply(r6, r6), r6), 4.0);
  LawDef def;
  def.name = "lennard-jones";
  def.cutoff = cutoff;
  return std::make_shared<Law>(central_potential(def, std::move(g), potential));
}

std::shared_ptr<const Law> spring() {
  Expressions g;
  const Expr stretch =
      g.subtract(g.square_root(g.input({Role::distance2, 0, 0, {}})), g.input({Role::parameter, 0, 0, "length"}));
  const Expr potential =
      g.scale(g.multiply(g.input({Role::parameter, 0, 0, "stiffness"}), g.multiply(stretch, stretch)), 0.5);
  LawDef def;
  def.name = "spring";
  def.parameters = {{"stiffness", 10.0, "N/m"}, {"length", 1.0, "m"}};
  return std::make_shared<Law>(central_potential(def, std::move(g), potential));
}

void permute(AlignedVector<Vec3>& values, const std::vector<std::uint32_t>& order) {
  const AlignedVector<Vec3> old = values;
  for (std::size_t i = 0; i < order.size(); i++) values[i] = old[order[i]];
}

struct Melt {
  Box box;
  Sites sites;

  /// 20³ face-centred cells of density 0.8442 with normal velocities at T = 1.44.
  Melt() {
    constexpr int cells = 20;
    const double a = std::cbrt(4.0 / 0.8442);
    box.edge = vec(a, a, a) * cells;
    start(4u * cells * cells * cells);
    std::size_t i = 0;
    for (int x = 0; x < cells; x++)
      for (int y = 0; y < cells; y++)
        for (int z = 0; z < cells; z++)
          for (const Vec3 corner : {vec(0, 0, 0), vec(0, 0.5, 0.5), vec(0.5, 0, 0.5), vec(0.5, 0.5, 0)})
            sites.x[i++] = (vec(x, y, z) + corner) * a;
    Random random{1};
    for (i = 0; i < sites.n; i++)
      for (int k = 0; k < 3; k++) {
        double sum = -6.0;  // of twelve uniform numbers: nearly normal
        for (int l = 0; l < 12; l++) sum += random.uniform();
        sites.v[i][k] = sum * 1.2;
      }
  }
  /// A LAMMPS dump: id xu yu zu vx vy vz ….
  explicit Melt(const std::string& path) {
    std::ifstream in(path);
    std::string line;
    const auto skip = [&](int lines) {
      while (lines-- > 0) std::getline(in, line);
    };
    std::size_t n = 0;
    double low = 0.0, edge = 0.0;
    skip(3);
    in >> n;
    skip(2);
    in >> low >> edge;
    skip(4);
    box.edge = vec(edge, edge, edge);
    start(n);
    for (std::size_t i = 0; i < n; i++) {
      int id = 0;
      double x[6] = {};
      in >> id;
      for (double& value : x) in >> value;
      std::getline(in, line);
      sites.x[i] = vec(x[0], x[1], x[2]);
      sites.v[i] = vec(x[3], x[4], x[5]);
    }
    require(static_cast<bool>(in), path, " is no LAMMPS dump of id xu yu zu vx vy vz");
  }

  void start(std::size_t n) {
    sites.resize(n);
    sites.clear_forces();
    std::fill(sites.family.begin(), sites.family.end(), 0u);
    std::fill(sites.kin.begin(), sites.kin.end(), 0u);
  }
  void sort() {
    for (std::size_t i = 0; i < sites.n; i++) sites.x[i] = box.wrapped(sites.x[i]);
    const std::vector<std::uint32_t> order = cell_order({sites.x.data(), sites.n}, box, 0.5 * (cutoff + width));
    permute(sites.x, order);
    permute(sites.v, order);
    permute(sites.force, order);
  }
  double kinetic() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < sites.n; i++) sum += 0.5 * norm2(sites.v[i]);
    return sum;
  }
};

/// What the law program is measured against: one loop in which everything stays in registers.
void add_by_hand(Sites& sites, const Rows& rows) {
  const Vec3* x = sites.x.data();
  Vec3* f = sites.force.data();
  const Vec3 cutoff2 = zero3() + cutoff * cutoff, one = zero3() + 1.0;
  const auto lengths2 = [](Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
    a *= a;
    b *= b;
    c *= c;
    d *= d;
    const Vec3 p = __builtin_shufflevector(a, b, 0, 4, 2, 6) + __builtin_shufflevector(a, b, 1, 5, 3, 7);
    const Vec3 q = __builtin_shufflevector(c, d, 0, 4, 2, 6) + __builtin_shufflevector(c, d, 1, 5, 3, 7);
    return __builtin_shufflevector(p, q, 0, 1, 4, 5) + __builtin_shufflevector(p, q, 2, 3, 6, 7);
  };
  for (const auto& phase : rows.phases())
    for (const Slab& slab : phase)
      for (const NeighbourRow& row : slab.rows) {
        const Vec3 from = x[row.site] - rows.shifts()[row.shift];
        const std::uint32_t* j = slab.list + row.begin;
        Vec3 sum = zero3(), other = zero3();
        for (std::uint32_t k = 0; k < row.count; k += 4) {
          Vec3 a = from - x[j[k]], b = from - x[j[k + 1]], c = from - x[j[k + 2]], d = from - x[j[k + 3]];
          const Vec3 r2 = lengths2(a, b, c, d), i2 = one / r2, i6 = i2 * i2 * i2;
          Vec3 w = i6 * (48.0 * i6 - 24.0) * i2;
          w = r2 < cutoff2 ? w : zero3();
          a *= w[0];
          b *= w[1];
          c *= w[2];
          d *= w[3];
          sum += a;
          other += b;
          sum += c;
          other += d;
          f[j[k]] -= a;
          f[j[k + 1]] -= b;
          f[j[k + 2]] -= c;
          f[j[k + 3]] -= d;
        }
        f[row.site] += sum + other;
      }
}

struct Times {
  double steps = infinity, forces = 0.0, rows = 0.0;  ///< [s] of the whole, and of it
  int builds = 0;
};

using AddForces = std::function<void(Sites&, const Rows&)>;

/// Steps with velocity Verlet; rows are built anew when the skin is spent.
Times run_melt(Melt& melt, int steps, const AddForces& add, Workers& workers) {
  Times times;
  Rows rows;
  Skin skin;
  Sites& s = melt.sites;
  const auto find = [&] {
    const double start = now(workers);
    if (skin.spent(s)) {
      melt.sort();
      rows.build(s, melt.box, everybody, everybody, cutoff, width, workers);
      skin.restart(s, width);
      times.builds++;
    }
    times.rows += now(workers) - start;
  };
  const auto evaluate = [&] {
    const double start = now(workers);
    std::fill(s.force.begin(), s.force.end(), zero3());
    add(s, rows);
    times.forces += now(workers) - start;
  };
  find();
  evaluate();
  times = {};
  const double start = now(workers);
  for (int step = 0; step < steps; step++) {
    for (std::size_t i = 0; i < s.n; i++) {
      s.v[i] += s.force[i] * (0.5 * dt);
      s.x[i] += s.v[i] * dt;
    }
    find();
    evaluate();
    for (std::size_t i = 0; i < s.n; i++) s.v[i] += s.force[i] * (0.5 * dt);
  }
  times.steps = now(workers) - start;
  return times;
}

/// Root of the mean of squared differences over that of squares.
double difference(const AlignedVector<Vec3>& a, const AlignedVector<Vec3>& b, std::size_t n) {
  double sum = 0.0, scale = 0.0;
  for (std::size_t i = 0; i < n; i++) {
    sum += norm2(a[i] - b[i]);
    scale += norm2(b[i]);
  }
  return std::sqrt(sum / scale);
}

void bench_melt(Melt melt, int rounds) {
  constexpr int steps = 100;
  Workers one(1), two(2);
  const std::shared_ptr<const Law> law = lennard_jones();
  Pairs alone(law, {}, one), shared(law, {}, two);
  // By then the crystal has molten.
  run_melt(melt, 100, add_by_hand, one);
  Rows rows;
  melt.sort();
  rows.build(melt.sites, melt.box, everybody, everybody, cutoff, width, one);
  melt.sites.clear_forces();
  add_by_hand(melt.sites, rows);
  const AlignedVector<Vec3> expected = melt.sites.force;
  melt.sites.clear_forces();
  alone.add_forces(melt.sites, rows, {}, {}, one);
  const auto n = static_cast<double>(melt.sites.n);
  std::printf(
      "Lennard-Jones: %zu particles, %.1f pairs and %.1f slots each, %.2f bytes a pair, %.0f bytes a particle; "
      "forces differ from the hand loop's by %.1e\n",
      melt.sites.n, static_cast<double>(rows.pairs()) / n, static_cast<double>(rows.slots()) / n,
      static_cast<double>(rows.memory()) / static_cast<double>(rows.pairs()), static_cast<double>(rows.memory()) / n,
      difference(melt.sites.force, expected, melt.sites.n));
  struct Variant {
    const char* name;
    AddForces add;
    Workers* workers;
    Times best;
  };
  std::vector<Variant> variants = {
      {"by hand, 1 thread", add_by_hand, &one, {}},
      {"law, 1 thread", [&](Sites& s, const Rows& r) { alone.add_forces(s, r, {}, {}, one); }, &one, {}},
      {"law, 2 threads", [&](Sites& s, const Rows& r) { shared.add_forces(s, r, {}, {}, two); }, &two, {}}};
  for (int round = 0; round < rounds; round++)
    for (Variant& variant : variants) {
      Melt copy = melt;
      const Times times = run_melt(copy, steps, variant.add, *variant.workers);
      if (times.steps < variant.best.steps) variant.best = times;
    }
  std::printf("%-20s %16s %10s %12s %10s %8s\n", "", "M atom-steps/s", "forces ms", "rows ms/step", "builds", "ratio");
  for (const Variant& variant : variants)
    std::printf("%-20s %16.2f %10.3f %12.3f %10d %8.2f\n", variant.name, n * steps / variant.best.steps * 1e-6,
                variant.best.forces / steps * 1e3, variant.best.rows / steps * 1e3, variant.best.builds,
                variants[0].best.steps / variant.best.steps);
}

constexpr std::uint32_t lattice = 70;

/// A cubic lattice of springs with places, stiffnesses and lengths a little off.
Ties make_lattice(Sites& sites) {
  Random random{7};
  const auto off = [&] { return 0.4 * random.uniform() - 0.2; };
  sites.resize(std::size_t{lattice} * lattice * lattice);
  sites.clear_forces();
  Ties ties;
  ties.parameters.resize(2);
  for (std::uint32_t i = 0; i < sites.n; i++) {
    const std::uint32_t x = i % lattice, y = i / lattice % lattice, z = i / (lattice * lattice);
    sites.x[i] = vec(x + off(), y + off(), z + off());
    for (const auto& [along, step] : {std::pair{x, 1u}, std::pair{y, lattice}, std::pair{z, lattice * lattice}}) {
      if (along + 1 == lattice) continue;
      ties.sites.push_back(i);
      ties.sites.push_back(i + step);
      ties.parameters[0].push_back(10.0 + off());
      ties.parameters[1].push_back(1.0 + off());
    }
  }
  return ties;
}

void add_springs_by_hand(Sites& sites, const Ties& ties) {
  const double *stiffness = ties.parameters[0].data(), *length = ties.parameters[1].data();
  Vec3 sum = zero3();
  std::uint32_t present = ties.sites[0];
  for (std::size_t i = 0; i < ties.size(); i++) {
    const std::uint32_t a = ties.sites[2 * i], b = ties.sites[2 * i + 1];
    if (a != present) {
      sites.force[present] += sum;
      sum = zero3();
      present = a;
    }
    const Vec3 d = sites.x[b] - sites.x[a];
    const double r = norm(d);
    const Vec3 f = d * (stiffness[i] * (r - length[i]) / r);
    sum += f;
    sites.force[b] -= f;
  }
  sites.force[present] += sum;
}

void bench_springs(int rounds) {
  Sites sites;
  const Ties ties = make_lattice(sites);
  Workers one(1), two(2);
  Bonds alone(spring(), {}, one), shared(spring(), {}, two);
  alone.arrange(ties, sites);
  shared.arrange(ties, sites);
  add_springs_by_hand(sites, ties);
  const AlignedVector<Vec3> expected = sites.force;
  sites.clear_forces();
  alone.add_forces(sites, {}, {}, {}, one);
  std::printf("Springs: %zu; forces differ from the hand loop's by %.1e\n", ties.size(),
              difference(sites.force, expected, sites.n));
  struct Variant {
    const char* name;
    std::function<void()> add;
    Workers* workers;
    double best;
  };
  std::vector<Variant> variants = {
      {"by hand, 1 thread", [&] { add_springs_by_hand(sites, ties); }, &one, infinity},
      {"law, 1 thread", [&] { alone.add_forces(sites, {}, {}, {}, one); }, &one, infinity},
      {"law, 2 threads", [&] { shared.add_forces(sites, {}, {}, {}, two); }, &two, infinity}};
  for (int round = 0; round < 10 * rounds; round++)
    for (Variant& variant : variants) {
      const double start = now(*variant.workers);
      variant.add();
      variant.best = std::min(variant.best, now(*variant.workers) - start);
    }
  std::printf("%-20s %16s %10s %8s\n", "", "M springs/s", "ms", "ratio");
  for (const Variant& variant : variants)
    std::printf("%-20s %16.1f %10.2f %8.2f\n", variant.name, static_cast<double>(ties.size()) / variant.best * 1e-6,
                variant.best * 1e3, variants[0].best / variant.best);
}

void bench_forces(const std::vector<std::string>& arguments) {
  const int rounds = 5;
  bench_melt(arguments.empty() ? Melt() : Melt(arguments[0]), rounds);
  bench_springs(rounds);
}

const player::Register forces_benchmark({"forces",
                                         "laws over pairs and connections, against loops by hand; argument: a "
                                         "LAMMPS dump to begin with",
                                         bench_forces});

}  // namespace

}  // namespace pantin
