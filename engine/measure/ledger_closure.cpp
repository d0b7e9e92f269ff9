#include "measure/ledger_closure.hpp"

#include <algorithm>
#include <cmath>

#include "forces/forces.hpp"
#include "measure/measure.hpp"

namespace pantin {

double closure(const World& world) {
  const Ledger& l = world.ledger;
  const double scale = std::max({l.posted, std::fabs(energy(world).potential), world.largest_kinetic});
  return scale > 0.0 ? l.unexplained / scale : 0.0;
}

std::map<std::string, double> truncation(const World& world) {
  const Ledger& l = world.ledger;
  std::map<std::string, double> list = {{"gravity", l.gravity_potential + l.gravity}};
  const LawLedger laws = law_ledger(world);
  if (!laws.without_energy.empty()) {
    std::string names;
    for (const std::string& name : laws.without_energy) names += (names.empty() ? "" : " + ") + name;
    const WorkCheck& check = world.work_check;
    list[names] = check.unkept - check.unkept_at_first - check.missed;
  }
  for (const auto& [name, given] : laws.given) {
    const auto before = l.before.find(name);
    const auto kicks = l.kicks.find(name);
    list[name] =
        (kicks == l.kicks.end() ? 0.0 : kicks->second) - (given - (before == l.before.end() ? 0.0 : before->second));
  }
  return list;
}

}  // namespace pantin
