#include "bench/pantin_rig.hpp"

#include "base/check.hpp"
#include "forces/sleep.hpp"
#include "peers/piles.hpp"
#include "step/step.hpp"
#include "support/mechanisms.hpp"

namespace pantin {

namespace {

class PantinRig : public peers::Rig {
 public:
  PantinRig(const peers::Mechanism& mechanism, double step, Integrator integrator, bool energy_return,
            std::optional<double> accuracy = {}) {
    world_.settings.step = step;
    world_.settings.integrator = integrator;
    world_.settings.energy_return = energy_return;
    world_.settings.accuracy = accuracy;
    world_.settings.gravity = pantin::vec(0, -peers::gravity, 0);
    bodies_ = support::add_mechanism(world_, mechanism);
  }

  void search(ContactSearch how) { world_.settings.contact = how; }

  void step() override {
    wake_all(world_);  // no engine sleeps here
    pantin::step(world_);
    require(world_.failure.empty(), world_.failure);
  }

  void read(std::vector<peers::SolidState>& state) override { support::read_solids(world_, bodies_, state); }
  std::size_t contacts() const override { return world_.contacts.list.size(); }
  std::size_t unsolved() const override { return world_.stats.unsolved_islands; }

 private:
  World world_;
  std::vector<BodyId> bodies_;
};

}  // namespace

std::vector<peers::Setting> pantin_settings() {
  std::vector<peers::Setting> all;
  for (const bool energy_return : {false, true})
    for (const NamedIntegrator& known : integrators) {
      // The one takes no constraints, the other is verlet where there are no connections.
      if (known.integrator == Integrator::rk4 || known.integrator == Integrator::implicit ||
          known.integrator == Integrator::adaptive)
        continue;
      peers::Setting setting;
      setting.name = text(known.name, energy_return ? " + return" : "");
      setting.make = [integrator = known.integrator, energy_return](const peers::Mechanism& m, double step) {
        return std::make_unique<PantinRig>(m, step, integrator, energy_return);
      };
      all.push_back(setting);
    }
  for (const double accuracy : {1.0, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8}) {
    peers::Setting setting;
    setting.name = text("adaptive ", accuracy);
    setting.chooses_steps = true;
    setting.make = [accuracy](const peers::Mechanism& m, double step) {
      return std::make_unique<PantinRig>(m, step, Integrator::adaptive, false, accuracy);
    };
    all.push_back(setting);
  }
  return all;
}

std::vector<peers::Setting> pantin_pile_settings() {
  std::vector<peers::Setting> all;
  for (const ContactSearch search : {ContactSearch::automatic, ContactSearch::fast}) {
    peers::Setting setting;
    setting.name = search == ContactSearch::fast ? "fast" : "";
    setting.make = [search](const peers::Mechanism& pile, double step) {
      auto rig = std::make_unique<PantinRig>(pile, step, Integrator::verlet, true);
      rig->search(search);
      return rig;
    };
    all.push_back(setting);
  }
  return all;
}

}  // namespace pantin
