// The judge of single solves: random islands, the impulses that the engine finds, and how far Siconos says that these are
// from Coulomb's law (its own natural map, scaled by what comes); beside its solvers, on the same problems.
#include <siconos/numerics/FrictionContactProblem.h>
#include <siconos/numerics/Friction_cst.h>
#include <siconos/numerics/NonSmoothDrivers.h>
#include <siconos/numerics/NumericsMatrix.h>
#include <siconos/numerics/SolverOptions.h>
#include <siconos/numerics/fc3d_compute_error.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <vector>

#include "contacts/solve/solve.hpp"
#include "support/random_island.hpp"

namespace {

using namespace pantin;
using Clock = std::chrono::steady_clock;

constexpr int islands = 200;
constexpr double tolerance = 1e-8;

/// u = W γ + q of all contacts, as Siconos wants it.
struct Problem {
  std::vector<double> W, q, friction;
  FrictionContactProblem* problem = nullptr;

  explicit Problem(const ContactIsland& island) {
    const support::DenseProblem dense(island);
    const Eigen::MatrixXd& w = dense.W;
    const Eigen::VectorXd& free = dense.q;
    for (const IslandContact& c : island.contacts) friction.push_back(c.friction);
    W.assign(w.data(), w.data() + w.size());
    q.assign(free.data(), free.data() + free.size());
    problem = frictionContactProblem_new_with_data(
        3, static_cast<int>(island.contacts.size()),
        NM_create_from_data(NM_DENSE, static_cast<int>(w.rows()), static_cast<int>(w.cols()), W.data()), q.data(),
        friction.data());
  }
  double norm_q() const {
    double sum = 0.0;
    for (const double x : q) sum += x * x;
    return std::sqrt(sum);
  }
  double error(std::vector<double> impulses, SolverOptions* options) {
    std::vector<double> u(impulses.size());
    double error = 0.0;
    fc3d_compute_error(problem, impulses.data(), u.data(), tolerance, options, norm_q(), &error);
    return error;
  }
};

struct Column {
  const char* name;
  int solver;
  std::vector<double> errors = {};
  double seconds = 0.0;

  void tell() {
    std::sort(errors.begin(), errors.end());
    const auto within = std::count_if(errors.begin(), errors.end(), [](double e) { return e <= 1e-5; });
    std::printf("| %s | %.0e | %.0e | %ld of %zu | %.3f |\n", name, errors[errors.size() / 2], errors.back(),
                static_cast<long>(within), errors.size(), 1e3 * seconds / static_cast<double>(errors.size()));
  }
};

void judge(double ratio) {
  support::Chance chance{std::mt19937_64(7)};
  Column columns[] = {{"Pantin", 0},
                      {"Siconos, Gauss-Seidel", SICONOS_FRICTION_3D_NSGS},
                      {"Siconos, Newton", SICONOS_FRICTION_3D_NSN_AC}};
  for (int i = 0; i < islands; i++) {
    ContactIsland island = support::random_island(chance, ratio);
    Problem problem(island);
    for (Column& column : columns) {
      std::vector<double> impulses(3 * island.contacts.size(), 0.0), u(impulses.size());
      SolverOptions* options = solver_options_create(column.solver == 0 ? SICONOS_FRICTION_3D_NSGS : column.solver);
      options->dparam[SICONOS_DPARAM_TOL] = tolerance;
      const auto start = Clock::now();
      if (column.solver == 0) {
        solve_island(island, SearchEffort::all, ContactSearch::exact);
        for (std::size_t k = 0; k < island.contacts.size(); k++)
          for (std::size_t row = 0; row < 3; row++)
            impulses[3 * k + row] = island.contacts[k].impulse[static_cast<int>(row)];
      } else {
        fc3d_driver(problem.problem, impulses.data(), u.data(), options);
      }
      column.seconds += std::chrono::duration<double>(Clock::now() - start).count();
      column.errors.push_back(problem.error(impulses, options));
      solver_options_delete(options);
    }
  }
  std::printf(
      "\nmasses up to %g : 1\n\n| solver | median error | largest error | within 1e-5 | ms an island |\n"
      "| --- | --- | --- | --- | --- |\n",
      ratio);
  for (Column& column : columns) column.tell();
}

}  // namespace

int main() {
  std::printf("%d random islands; errors as Siconos has them, relative to the velocities without impulses\n", islands);
  for (const double ratio : {1.0, 100.0, 1e4}) judge(ratio);
  return 0;
}
