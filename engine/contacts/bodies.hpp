#pragma once
// State of bodies and free points, wherever it is kept: in the model, or after a drift in the articulates.
#include <memory>
#include <vector>

#include "articulates/articulate.hpp"
#include "contacts/contact.hpp"
#include "model/model.hpp"

namespace pantin {

struct BodyState {
  Vec3 x;                ///< [m] centre
  Quat q;                ///< principal axes to the world
  Mat3 R;                ///< its matrix
  Vec3 v, w;             ///< [m/s], [rad/s] world axes
  double mass;           ///< [kg]
  Vec3 inertia;          ///< [kg m²] principal
  Vec3 inverse_inertia;  ///< [1/(kg m²)] principal, 0 where it cannot turn
  Node* node;            ///< where it is kept, or null: in the model
};

/// Bodies by their slots, then points.
inline std::size_t number_of(const Model& model, std::uint32_t thing) {
  return is_point(thing) ? model.bodies.slots() + slot_of(thing) : thing;
}
/// A point is a body that cannot turn.
BodyState state_of(const Model& model, const std::vector<std::unique_ptr<Articulate>>& articulates, std::uint32_t thing,
                   bool drifted);
/// Whether it sleeps, or what it moves with.
bool asleep(const Model& model, const std::vector<std::unique_ptr<Articulate>>& articulates, const Contacts& contacts,
            std::uint32_t thing);
/// Whether a body has to wake with others: what sleeps without touching anything does not.
bool sleeps_in_touch(const Contacts& contacts, std::uint32_t slot);
/// Adds to the momenta [kg m/s], [kg m²/s] about the centre, world axes.
void add_momenta(Model& model, const BodyState& state, std::uint32_t thing, Vec3 p, Vec3 angular);
/// Displaces by `way` [m] and turns by a rotation vector [rad]; momenta in world axes stay.
void displace(Model& model, const BodyState& state, std::uint32_t thing, Vec3 way, Vec3 turn);
/// [m] The centre now, not when its state was taken.
Vec3 position_of(const Model& model, const BodyState& state, std::uint32_t thing);
/// [J] now, not when its state was taken.
double kinetic_energy(const Model& model, const BodyState& state, std::uint32_t thing);
/// [m] Its centre of mass, as in state_of.
Vec3 centre_of(const Model& model, const std::vector<std::unique_ptr<Articulate>>& articulates, std::uint32_t thing,
               bool drifted);
/// Whether it is a point that nothing ties: kicks give it gravity, too.
bool is_loose_point(const Model& model, std::uint32_t thing);

}  // namespace pantin
