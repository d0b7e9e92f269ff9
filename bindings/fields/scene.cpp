// The settings of the world.
#include <algorithm>
#include <cmath>

#include "edit/edit.hpp"
#include "fields/make.hpp"

namespace pantin::fields {
namespace {

using None = std::monostate;

double positive(double value, const char* name, const char* unit) {
  require(value > 0, "scene: ", name, " must be > 0", *unit ? " " : "", unit, ", got ", value);
  return value;
}

void write_accuracy_per(World& world, const std::string& per) {
  require(per == "second" || per == "step", "scene: accuracy_per must be \"second\" or \"step\", got \"", per, "\"");
  set_accuracy_per_step(world, per == "step");
}

void write_integrator(World& world, const std::string& name) {
  std::string known;
  for (const NamedIntegrator& named : integrators) {
    if (named.name == name) return set_integrator(world, named.integrator);
    known += text(known.empty() ? "\"" : named.name == integrators.back().name ? " or \"" : ", \"", named.name, "\"");
  }
  throw Error(text("scene: integrator must be ", known, ", got \"", name, "\""));
}

void write_contact(World& world, const std::string& name) {
  const auto& names = contact_search_names;
  const auto found = std::find(names.begin(), names.end(), name);
  require(found != names.end(), "scene: contact must be \"auto\", \"exact\" or \"fast\", got \"", name, "\"");
  require(!world.locked,
          "scene: contact cannot be written while the world steps; write it in an event or a step callback");
  world.settings.contact = static_cast<ContactSearch>(found - names.begin());
}

void write_energy_return(World& world, bool on) {
  require(!world.locked,
          "scene: energy_return cannot be written while the world steps; write it in an event or a step callback");
  world.settings.energy_return = on;
}

void write_plane(World& world, const std::optional<std::string>& name) {
  if (!name) return set_plane(world, {});
  const auto found = std::find(plane_names.begin(), plane_names.end(), *name);
  require(found != plane_names.end(), "scene: plane must be \"xy\", \"xz\" or \"yz\", got \"", *name, "\"");
  set_plane(world, {static_cast<int>(found - plane_names.begin())});
}

void write_seed(World& world, double seed) {
  require(seed >= 0 && seed < 0x1p53 && std::trunc(seed) == seed,
          "scene: seed must be a whole number from 0 to 2^53, got ", seed);
  world.settings.seed = static_cast<std::uint64_t>(seed);
  world.random = Random{world.settings.seed, 0};
}

std::vector<Property> steps() {
  return {
      property<None>(
          "gravity", "vec", "m/s²", "uniform acceleration (default `vec(0, -9.81, 0)`)",
          [](const World& w, None) { return w.settings.gravity; },
          [](World& w, None, Vec3 gravity) { set_gravity(w, gravity); }),
      property<None>(
          "step", "number", "s", "length of one step (default `1 / 240`)",
          [](const World& w, None) { return w.settings.step; },
          [](World& w, None, double step) { set_step(w, positive(step, "step", "s")); }),
      property<None>(
          "accuracy", "number?", "1/s",
          "wanted error per second, relative to the distance between what interacts, or to how far it swings beside a "
          "uniform motion where it interacts with nothing; sub-steps follow from it, and what is a tree of hinges "
          "moves as with \"adaptive\". Functions of time that ties follow are then asked at each quarter of a step; "
          "round "
          "sharp corners of paths errors fall only as fast as sub-steps (default none: fixed steps)",
          [](const World& w, None) { return w.settings.accuracy; },
          [](World& w, None, std::optional<double> wanted) {
            if (wanted) positive(*wanted, "accuracy", "1/s");
            set_accuracy(w, wanted);
          }),
      property<None>(
          "accuracy_per", "string", "",
          "whether `accuracy` is that of a \"second\" or of a \"step\", as where a scene lasts microseconds (default "
          "`\"second\"`)",
          [](const World& w, None) { return w.settings.accuracy_per_step ? "step" : "second"; },
          [](World& w, None, const std::string& per) { write_accuracy_per(w, per); }),
      property<None>(
          "integrator", "string", "",
          "\"verlet\" (2nd order), \"implicit\" (the same with connections of any stiffness), \"suzuki4\" (4th order, "
          "where "
          "nothing dissipates), \"rk4\" (4th order, no constraints), \"euler\" (1st order, semi-implicit; free "
          "particles "
          "as with "
          "\"verlet\"), \"adaptive\" (\"verlet\", but what is a tree of hinges and nails under gravity alone moves in "
          "its own rotations, of 8th order, to `accuracy`, or to 1e-6 where none is wanted) (default `\"verlet\"`)",
          [](const World& w, None) { return name_of(w.settings.integrator); },
          [](World& w, None, const std::string& name) { write_integrator(w, name); }),
      property<None>(
          "energy_return", "boolean", "", "give back what the velocity projection took (default `true`)",
          [](const World& w, None) { return w.settings.energy_return; },
          [](World& w, None, bool on) { write_energy_return(w, on); }),
      property<None>(
          "contact", "string", "",
          "how what touches is solved: \"exact\" by Newton's search, however long it takes, \"fast\" by sweeps alone, "
          "which leave slips and loads unfinished, \"auto\" by the size and the motion of an island (default "
          "`\"auto\"`)",
          [](const World& w, None) { return contact_search_names[static_cast<std::size_t>(w.settings.contact)]; },
          [](World& w, None, const std::string& name) { write_contact(w, name); }),
  };
}

std::vector<Property> space() {
  return {
      property<None>(
          "box", "vec?", "m",
          "edges of the periodic box, through whose sides laws reach, but not what touches (default none: open space)",
          [](const World& w, None) { return w.settings.box; },
          [](World& w, None, std::optional<Vec3> box) { set_box(w, box); }),
      property<None>(
          "plane", "string?", "",
          "\"xy\", \"xz\" or \"yz\": everything stays in that plane, and forces across it do nothing; set it before "
          "things "
          "are made (default none: in space)",
          [](const World& w, None) {
            return w.plane.flat() ? std::optional(plane_names[static_cast<std::size_t>(w.plane.normal)]) : std::nullopt;
          },
          [](World& w, None, const std::optional<std::string>& name) { write_plane(w, name); }),
      property<None>(
          "tolerance", "number", "1",
          "points of a new hinge may be this far apart, relative to the size of their bodies with their shapes; of "
          "points "
          "without bodies to the largest coordinate (default `1e-6`)",
          [](const World& w, None) { return w.settings.tolerance; },
          [](World& w, None, double v) { w.settings.tolerance = positive(v, "tolerance", ""); }),
      property<None>(
          "seed", "integer", "", "of math.random (default `1`)", [](const World& w, None) { return w.settings.seed; },
          [](World& w, None, double seed) { write_seed(w, seed); }),
      property<None>(
          "boltzmann", "number", "J/K", "k_B; temperature is in J while it is 1 (default `1`)",
          [](const World& w, None) { return w.settings.boltzmann; },
          [](World& w, None, double v) { w.settings.boltzmann = positive(v, "boltzmann", "J/K"); }),
  };
}

std::vector<Property> settings() {
  std::vector<Property> all = steps();
  for (Property& more : space()) all.push_back(std::move(more));
  return all;
}

}  // namespace

const Type& scene_type() {
  static const Type type = {"Scene", "scene", "The scene that is being run.", settings(), &any_scene_type()};
  return type;
}

}  // namespace pantin::fields
