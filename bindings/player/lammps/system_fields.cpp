#include "player/lammps/system_fields.hpp"

#include <algorithm>
#include <map>

#include "player/lammps/formula.hpp"
#include "player/lammps/live_laws.hpp"
#include "player/lammps/refused.hpp"

namespace pantin::player {
namespace {

constexpr std::size_t most_fields = 29;

class FieldMaker {
 public:
  FieldMaker(const World& world, LammpsSystem& system) : world_(world), system_(system) {}

  void add(FieldId id) {
    const Field& row = world_.fields[id];
    const std::shared_ptr<const Law> live = laws_.of(row);
    std::map<std::vector<double>, std::vector<int>> by_values;
    for (std::size_t i = 0; i < system_.types.size(); i++) {
      const AtomType& type = system_.types[i];
      if (row.family && type.family != row.family) continue;
      if (row.group && std::ranges::find(type.of_group, id) == type.of_group.end()) continue;
      Key key;
      for (const Input& input : inputs_of_law(*live))
        if (input.role == Role::attribute && !row.law->thermal) key.push_back(attribute_of(system_, type, input.name));
      by_values[key].push_back(static_cast<int>(i) + 1);
    }
    for (const auto& [key, types] : by_values) {
      require(system_.fields.size() + system_.baths.size() < most_fields, place_of(row), ": LAMMPS has at most ",
              most_fields, " groups, one for each field and value that it reads; give the particles fewer values");
      if (row.law->thermal)
        add_bath(row, types);
      else
        system_.fields.push_back(field(row, *live, types));
    }
  }

  const std::vector<std::string>& notes() const { return laws_.notes(); }

 private:
  using Key = std::vector<double>;

  const World& world_;
  LammpsSystem& system_;
  LiveLaws laws_{world_};

  void add_bath(const Field& row, const std::vector<int>& types) {
    LammpsBath bath{types, 0.0, 0.0};
    for (std::size_t i = 0; i < row.parameters.size(); i++) {
      if (row.law->parameters[i].name == "temperature")
        bath.temperature = row.parameters[i] * world_.settings.boltzmann;
      if (row.law->parameters[i].name == "rate") bath.rate = row.parameters[i];
    }
    constexpr double most =
        0.2;  // of a step: beyond, fix langevin heats positions by a tenth and more, and then blows up
    require(bath.rate * world_.settings.step <= most, place_of(row), ": a thermostat of rate ", bath.rate,
            " /s is too quick for LAMMPS' steps of ", world_.settings.step, " s; give it a rate of ",
            rounded(most / world_.settings.step), " /s or less, or a shorter scene.step");
    if (bath.rate > 0.0) system_.baths.push_back(bath);
  }

  /// LAMMPS lets atoms leave a periodic box by a little, and this program's fields see them in it at all times.
  std::string coordinate(const char* name, int axis) const {
    if (!world_.settings.box) return name;
    const std::string edge = to_text((*world_.settings.box)[axis]);
    return text('(', name, '-', edge, "*floor(", name, '/', edge, "))");
  }

  LammpsField field(const Field& row, const Law& law, const std::vector<int>& types) const {
    const AtomType& type = system_.types[static_cast<std::size_t>(types[0]) - 1];
    const auto value_of = [&](const Input& input) -> std::string {
      constexpr const char* coordinates[] = {"x", "y", "z"};
      if (input.role == Role::position) return coordinate(coordinates[input.component], input.component);
      double x = world_.time;
      if (input.role == Role::attribute) x = attribute_of(system_, type, input.name);
      for (std::size_t i = 0; input.role == Role::parameter && i < row.parameters.size(); i++)
        if (law.parameters[i].name == input.name) x = row.parameters[i];
      return x < 0.0 ? "(" + to_text(x) + ")" : to_text(x);
    };
    try {
      LammpsField made{place_of(row), types, {}, ""};
      for (std::size_t k = 0; k < 3; k++)
        made.force[k] = formula(law.graph, law.force[k], FormulaFor::variable, value_of);
      if (law.energy != no_expression) made.energy = formula(law.graph, law.energy, FormulaFor::variable, value_of);
      return made;
    } catch (const Error& error) { throw Error(text(place_of(row), ": LAMMPS has no such field: ", error.what())); }
  }
};

}  // namespace

void add_fields(const World& world, LammpsSystem& system) {
  FieldMaker maker(world, system);
  for (FieldId id : world.fields.ids())
    if (world.fields[id].enabled) maker.add(id);
  system.notes.insert(system.notes.end(), maker.notes().begin(), maker.notes().end());
}

}  // namespace pantin::player
