#pragma once
// What of a scene LAMMPS is given: atoms with types, laws as tables, fields as formulas.
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "player/lammps/law_table.hpp"
#include "world/world.hpp"

namespace pantin::player {

/// Particles that LAMMPS cannot tell apart: of one family and mass, with equal values of what laws read, acted on by the same
/// fields.
struct AtomType {
  FamilyId family;
  double mass = 0.0;              ///< [kg]
  std::vector<double> values;     ///< (attributes that laws read)
  std::vector<FieldId> of_group;  ///< fields that act on it since it is in a group
  std::size_t count = 0;
};

struct LammpsTable {
  std::string name;  ///< of its section in the file
  std::string law;   ///< "scene.lua:12: lennard_jones"
  LawTable table;
  bool has_energy = true;
  std::string lepton;  ///< the energy as a formula of r; empty: it has none
};

/// Types a <= b, counted from 1, and their table.
struct PairCoefficient {
  int a = 1, b = 1;
  std::size_t table = 0;
};

/// Interactions that LAMMPS takes together: each two types have at most one table.
struct PairStyle {
  std::vector<PairCoefficient> coefficients;
};

struct LammpsBond {
  int type = 1;                ///< counted from 1
  std::uint32_t a = 0, b = 0;  ///< indices of atoms
};

/// A field on some types.
struct LammpsField {
  std::string law;
  std::vector<int> types;
  std::array<std::string, 3> force;  ///< formulas of x, y, z [N]
  std::string energy;                ///< the same [J], or empty
};

struct LammpsBath {
  std::vector<int> types;
  double temperature = 0.0;  ///< [J] times Boltzmann's constant
  double rate = 0.0;         ///< [1/s] > 0
};

struct LammpsSystem {
  std::vector<std::string> attributes;  ///< that laws read, beside the mass
  std::vector<AtomType> types;
  std::vector<ParticleId> atoms;       ///< in the order of making
  std::vector<int> type_of;            ///< (atoms) counted from 1
  std::vector<std::uint32_t> body_of;  ///< (atoms) counted from 1; 0: of none
  std::vector<BodyId> bodies;          ///< of two points or more
  std::vector<LammpsTable> pair_tables, bond_tables;
  std::vector<PairStyle> pair_styles;
  int exclude = 0;  ///< connections within which pairs are left out, 0 to 3
  std::vector<LammpsBond> bonds;
  std::vector<LammpsField> fields;
  std::vector<LammpsBath> baths;
  std::vector<std::string> notes;  ///< what of laws is left out, a sentence each
  double nearest = 0.0;            ///< [m] least distance of atoms that interact
  double longest_bond = 0.0;       ///< [m] now
  double body_extent = 0.0;        ///< [m] the largest distance of two points of one body
  double error = 1e-6;             ///< of the tables
  double usual_force = 0.0;        ///< [N] of a pair or bond now, of the law where it is largest
  double energy_size = 0.0;        ///< [J] sum of the energies of near pairs and bonds, whatever their signs
};

/// What LAMMPS is given of the present state, with tables of a wanted error. Throws Error for what it cannot be given.
LammpsSystem lammps_system(const World& world, double error);

/// Its atoms, types and bodies alone.
LammpsSystem lammps_atoms(const World& world);

/// (atoms) how many edges of the periodic box it is away from the box [m], whole bodies by their first point; zero without one.
std::vector<Vec3> boxes_away(const World& world, const LammpsSystem& system);

/// The mass, or what a law reads of particles of a type.
double attribute_of(const LammpsSystem& system, const AtomType& type, const std::string& name);

/// To ten digits: what differs by less, as by round-off of what was measured in the scene, counts as one.
double merged(double value);

/// What a law's force and energy read.
std::vector<Input> inputs_of_law(const Law& law);

/// "atoms 'tail' of mass 1, charge 0.5": what a type is.
std::string describe(const World& world, const LammpsSystem& system, const AtomType& type);

}  // namespace pantin::player
