#pragma once
// From shapes and where they are to contacts.
#include <utility>
#include <vector>

#include "articulates/articulate.hpp"
#include "base/parallel.hpp"
#include "contacts/broad_phase.hpp"
#include "contacts/contact.hpp"
#include "contacts/manifold.hpp"
#include "model/model.hpp"

namespace pantin {

/// Two bodies that collide although a hinge ties them.
struct HingedPair {
  std::uint32_t a, b;  ///< slots, a < b
  Vec3 arm, axis;      ///< [m], of unit length: of the hinge and its axis, in principal axes of a; axis 0: about any
};

/// How a body goes on if nothing new stops it.
struct Going {
  Vec3 v = zero3(), w = zero3();  ///< [m/s], [rad/s]
  double mass = infinity;         ///< [kg]
  bool is_held = false;           ///< something kept it out in the last drift
};

/// Where a shape is now, and how far it may get.
struct ShapeNow {
  Pose pose;
  Vec3 arm = zero3();                             ///< [m] from the body's centre
  Going going;                                    ///< of the body, with the mean velocity of the last drift
  double margin = 0.0;                            ///< [m] gaps up to the sum of two margins are contacts
  double reach = infinity, thickness = infinity;  ///< [m] of the shape
  bool moves = false;                             ///< is of a body that does not sleep in touch
};

/// A solid point, in the same way.
struct PointNow {
  Vec3 x = zero3();                  ///< [m]
  Vec3 displacement = zero3();       ///< [m] over the coming step
  double still = 0.0, margin = 0.0;  ///< [m] of the margin what its speed has no part in
  bool moves = false;
};

/// Contacts of some pairs.
struct FoundContacts {
  std::vector<Contact> list, sensed;
  std::vector<PassingPair> passing;
};

/// A free point that touches as a ball.
struct SolidPoint {
  std::uint32_t slot;
  double radius;  ///< [m]
  Solid touch;
  bool among_others;  ///< may touch other points, too
};

/// What finding contacts keeps; of it, its result depends on `ShapesThen` alone.
struct ContactFinder {
  BroadPhase broad_phase;                                     ///< of shapes
  BroadPhase points;                                          ///< of solid points that may touch others (slots)
  std::vector<SolidPoint> solids;                             ///< by slot
  std::vector<std::uint32_t> height_fields;                   ///< their slots: solid far below their bounds
  std::vector<std::uint64_t> serials;                         ///< (slots of shapes) of what is in there; 0: nothing
  std::vector<std::pair<std::uint32_t, std::uint32_t>> tied;  ///< (smaller, larger) things that do not collide
  std::vector<HingedPair> hinged;                             ///< rising
  std::vector<ShapeNow> shapes_now;                           ///< (slots of shapes) when they moved last
  std::vector<PointNow> points_now;                           ///< (solids)
  std::vector<std::uint32_t> moving;                          ///< slots of shapes that move
  std::vector<Going> going;                  ///< (slots of bodies, then of points where some are solid)
  std::vector<BroadPhase::Pair> pairs;       ///< of shapes that may touch
  std::vector<BroadPhase::Pair> rebounding;  ///< those of them with restitution
  std::vector<FoundContacts> found;          ///< (blocks of pairs)
  std::uint64_t sleep_changes = 0;           ///< of the contacts, when these were found
  double ahead = 1.0;                        ///< of a step: what margins look ahead by, as far as a crowd lets them
  bool changed = true;                       ///< an edit concerned what is in there
  bool displaced = false;                    ///< shapes were, a little, since they were put there
  bool asked_changed = false, asked_displaced = false;  ///< they were, when they were put there for a ray or the like
};

/// Where shapes were when they were looked at last, from which what is pushed before the next drift is looked for.
struct ShapesThen {
  std::vector<ShapeNow> shapes;              ///< (slots of shapes)
  std::vector<Going> going;                  ///< (slots of bodies, then of points)
  std::vector<BroadPhase::Pair> rebounding;  ///< as of the finder
  double ahead = 1.0;                        ///< as of the finder
  std::uint64_t sleep_changes = 0;           ///< as of the finder
  bool displaced = false;                    ///< as of the finder
  bool known = false;                        ///< there were any, and no edit came since
};

/// Where things are: of what rows tie in the articulates after a drift, else in the model.
struct ThingsNow {
  const Model& model;
  const std::vector<std::unique_ptr<Articulate>>& articulates;
  const Contacts& contacts;  ///< know who sleeps
  bool drifted;
  Vec3 gravity;        ///< [m/s²]
  double h;            ///< [s] over which they are to be foreseen
  double drift = 0.0;  ///< [s] of the last drift, where it has
};

/// Makes a finder where there is none, and tells it what edits changed of who may touch. Whether its bounds are to be put anew.
bool renew(std::unique_ptr<ContactFinder>& finder, Model& model);
/// Puts the bounds of all shapes where they are.
void put_bounds(const ThingsNow& where, ContactFinder& finder);
/// For a state that is kept; `finder` may be null.
void keep_shapes(const ContactFinder* finder, const Model& model, ShapesThen& kept);
/// Makes the finder find what it found then; none where they were not known.
void put_back(std::unique_ptr<ContactFinder>& finder, Model& model, const ShapesThen& then);
/// Finds all contacts anew; those that were there before keep their impulses.
void find_all_contacts(const ThingsNow& where, ContactFinder& finder, Workers& workers, Contacts& contacts);
/// Gives contacts the impulses of those that were there before: the same features, else the nearest of the same shapes; what
/// points of two bodies had that are gone is shared out among those that the two have now.
void keep_impulses(const std::vector<Contact>& before, std::vector<Contact>& now);
/// A body's shape in the world.
Pose pose_of(const Model& model, const Shape& shape);

}  // namespace pantin
