#pragma once
// The world: model rows and all that goes with them through time. Made and changed by the functions of `edit.hpp`,
// moved by `step()` of step.hpp, read by `measure.hpp`, `query.hpp` and `hands.hpp`.
#include <cmath>
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/profile.hpp"
#include "base/random.hpp"
#include "base/shared_list.hpp"
#include "contacts/contact.hpp"
#include "model/model.hpp"
#include "world/input.hpp"
#include "world/ledger.hpp"
#include "world/queue.hpp"
#include "world/settings.hpp"

namespace pantin {

struct Articulate;
struct ContactFinder;
struct Forces;
struct StepStart;
struct TouchSpace;
struct Trial;
struct TreeWorkspace;
class Workers;

/// What can grab: the mouse, a finger, a stick, a script.
struct Hand {
  Vec3 position = zero3();  ///< [m]
  Vec3 velocity = zero3();  ///< [m/s] over the last step
  bool pressed = false;
  bool placed = false;               ///< has been given a position
  ConstraintId grab;                 ///< the follow that holds what it grabbed, or null
  std::function<Vec3(double)> path;  ///< scripted: position at time t [s]
};

/// Momenta of a tied thing at the start of a step.
struct TiedStart {
  std::uint32_t slot;
  bool is_body;
  Vec3 p, P;  ///< of a body [kg m/s], [kg m²/s]; of a point p is its velocity [m/s]
};

/// Something that happened; told to scripts in the next step.
struct Notice {
  enum class Kind : std::uint8_t {
    removed,
    cut,
    broke,
    joined,
    grab,
    drop,
    press,
    release,
    key,
    key_up,
    button,
    touched,
    parted
  };
  Kind kind = Kind::key;
  AnyId thing;
  std::int32_t hand = -1;
  std::string text;    ///< name of the key or button; story of what was removed
  double force = 0.0;  ///< [N] at which it broke
  Touch touch = {};    ///< of what touched; of what parted the pair alone
};

/// Where a connection broke, for whoever shows it.
struct Break {
  Vec3 from = zero3(), to = zero3();  ///< [m] its ends, of three or four the first two
  double time = 0.0;                  ///< [s]
};
constexpr std::size_t most_breaks = 1024;

/// A number recorded at the end of each step.
struct Probe {
  std::string name;
  std::function<double()> read;
  SharedList values;  ///< (steps since it was added)
  std::uint64_t first_step = 0;
  double latest = 0.0;  ///< read in this step
};

/// A particle with a finite lifetime, in the queue for its end.
struct Mortal {
  double time = 0.0;  ///< [s] of the end
  std::uint64_t serial = 0;
  ParticleId particle;
};

/// Rates of change of a body's x, p, angular and q.
struct BodyRate {
  Vec3 x = zero3(), p = zero3(), angular = zero3();
  Quat q = {0.0, 0.0, 0.0, 0.0};
};

/// Rates of change of loose things: of the present stage of a step, and summed over the stages.
struct Slopes {
  std::vector<Vec3> acceleration;     ///< (slots of points) [m/s²] present
  std::vector<Vec3> forces, torques;  ///< (slots of bodies) [N], [N m] present
  std::vector<FreeMotion> points;     ///< (slots of points) [m/s], [m/s²] summed
  std::vector<BodyRate> bodies;       ///< (slots of bodies) summed
};

/// Counts since the start.
struct Stats {
  std::uint64_t newton_iterations = 0;
  std::uint64_t solves = 0;  ///< articulate steps solved
  std::uint64_t factorisations = 0;
  std::uint64_t contacts = 0;         ///< of the last step
  std::uint64_t contact_islands = 0;  ///< of the last step: what touches and what ties it, solved together
  std::uint64_t contact_iterations = 0;
  std::uint64_t unsolved_islands = 0;  ///< times that impulses were left that miss the law of friction
  double gains_taken_back = 0.0;       ///< [J] that contacts gave, which only take, and that was taken back
  std::uint64_t halved_steps = 0;
  std::uint64_t fallback_steps = 0;
  std::uint64_t projections = 0;  ///< velocity projections that needed a factor of their own
  std::uint32_t worst_iterations = 0;
  std::uint64_t unreached = 0;    ///< times that not even the most sub-steps gave the accuracy
  std::uint64_t rejected = 0;     ///< times that a step was done again with more sub-steps
  std::uint64_t evaluations = 0;  ///< of the rates of trees
  double worst_unreached = 0.0;   ///< [1/s] largest error rate told then
};

/// Stages of steps in which the work of laws without energy was held against a second estimate, each with the weight of those
/// that it stands for [J].
struct WorkCheck {
  double missed = 0.0;                         ///< that less what was given
  double squares = 0.0;                        ///< [J²] of the stages
  double drawn = 0.0;                          ///< [J²] of those of them that stand for others
  double sizes = 0.0;                          ///< magnitudes
  double done = 0.0;                           ///< magnitudes of the work
  double unkept = 0.0, unkept_at_first = 0.0;  ///< h² f²/8m of these laws, now and when they began to act
  double kick = 0.0;  ///< the largest so far that one kick could give to what nothing ties: the same of all of them
};

/// How wrong the state is.
struct Accuracy {
  double penetration = 0.0;  ///< [m] deepest overlap of shapes that touch
  double hinge_gap = 0.0;    ///< [m] largest distance between points of one hinge, and of nails and rigid follows
  double constraint = 0.0;   ///< [m] the same with rods
  double energy = 0.0;  ///< |energy - start - work from outside| / largest kinetic energy so far, and what of that work
                        ///< a second estimate does not find
};

/// What a step is doing: a stage of it, from one evaluation of the forces to the next.
struct StepStage {
  std::uint32_t index = 0;
  double full = 0.0;               ///< [s] length of the full sub-step that it belongs to
  double h = 0.0;                  ///< [s] its own length; may be negative
  double from = 0.0, to = 1.0;     ///< of the step
  bool first = true, last = true;  ///< of the full sub-step
};

/// What a snapshot copies as it is.
struct WorldData : Model {
  Settings settings;
  double time = 0.0;             ///< [s] at the end of the last step
  std::uint64_t steps = 0;       ///< done
  double step_origin = 0.0;      ///< [s] time at the last change of the step's length
  std::uint64_t step_count = 0;  ///< steps since then
  StepStage stage;               ///< of the step
  std::uint64_t instant = 0;     ///< number of the instant that the forces are of: stages done since the start
  double kick_error = 0.0;       ///< [1/s] of the step, where `accuracy` wants to know it
  double mean_error = 0.0;       ///< [1/s] over the last second, or
  double error_span = 0.0;       ///< [s] less at first
  SubSteps sub_steps;            ///< full ones, each with kicks and a projection of its own, that `accuracy` asks for

  Contacts contacts;  ///< of shapes that touch

  Choreography choreography;
  std::vector<Hand> hands;
  std::map<std::string, double> controls;  ///< what is held of keys and gamepads, -1 to 1, by name; no zeros
  Mouse mouse;
  StepInput input;              ///< for the coming step; emptied by it
  std::vector<Notice> notices;  ///< of the last step, told in the next; emptied then
  std::deque<Break> breaks;     ///< the latest `most_breaks`, oldest first
  std::vector<LogLine> log;
  std::vector<Probe> probes;
  Random random;

  std::vector<std::uint32_t> loose_bodies;  ///< slots of bodies that nothing constrains
  std::vector<std::uint32_t> loose_points;  ///< slots of free points that nothing constrains
  std::vector<double> loose_masses;         ///< (loose_points) [kg]

  std::map<std::string, double> given_by_laws;  ///< [J] since the start, up to when the laws at work began to act
  bool stiffness_unknown = true;                ///< an edit may have made connections too stiff for explicit steps
  Ledger ledger;
  double nonconservative_work =
      0.0;  ///< [J] done by laws without energy that do not depend on velocities; part of `work`
  WorkCheck work_check;

  Stats stats;
  Accuracy error;                ///< at the end of the last step
  Accuracy worst;                ///< largest so far
  double work = 0.0;             ///< [J] done from outside since the start: hands, follows, pushes, edits
  double start_energy = 0.0;     ///< [J] at the first step
  double largest_kinetic = 0.0;  ///< [J] so far
  double worst_energy = 0.0;     ///< [J] largest |energy - start - work| so far

  std::vector<Mortal> mortals;  ///< binary heap, earliest first; the dead among them
  /// State of loose things at the start of the step, put back if it goes wrong.
  std::vector<FreeMotion> saved_points;  ///< (loose_points)
  std::vector<Motion> saved_motion;      ///< (loose_bodies)
  Slopes slopes;                         ///< of the integrator "rk4"

  std::string last_actor;       ///< who pushed, kicked or changed a thing last; empty: nobody yet
  double last_act = 0.0;        ///< [s] when
  bool pushed = false;          ///< pushes or twists wait for the coming step
  bool locked = false;          ///< inside a step, outside the phases in which scripts run
  bool unchecked = true;        ///< whether the integrator fits is to be seen anew
  std::string integrator_from;  ///< "scene.lua:12", where the integrator was set, or empty
  std::string trouble;          ///< not empty: a law failed in this step
  std::string failure;          ///< not empty: the state became non-finite; the world steps no more
};

struct World : WorldData {
  World();
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  const std::uint64_t number;                                   ///< of this world, in this process: that of no other
  bool stepping = false;                                        ///< a step is under way, and what it calls
  std::vector<std::unique_ptr<Articulate>> articulates;         ///< in the order of their smallest serial
  std::unique_ptr<ContactFinder> contact_finder;                ///< null where there is no shape
  std::unique_ptr<TouchSpace> touch_space;                      ///< the same
  std::unique_ptr<Forces> forces;                               ///< of the laws; null where none acts
  std::vector<std::unique_ptr<Trial>> trials;                   ///< (threads) of sub-steps
  std::vector<std::unique_ptr<TreeWorkspace>> tree_workspaces;  ///< (threads) where trees are moved
  std::unique_ptr<StepStart> start;                             ///< of a step that may have to be done again
  std::vector<TiedStart> tied_starts;                           ///< put back where the step goes wrong
  std::unique_ptr<Workers> workers;                             ///< threads
  Profile profile;

  /// Called in `run_behaviours`, with the notices still there. Scripts may edit in it.
  std::function<void()> behaviours;
  /// Names who edits right now, for obituaries: the script's line, or "hand 1". Empty: "the program".
  std::function<std::string()> who;
};

/// Time at the end of the coming step [s]: whole multiples of its length, however long the run.
inline double next_time(const World& world) {
  return world.step_origin + static_cast<double>(world.step_count + 1) * world.settings.step;
}

/// A little later: times that agree up to the round-off of a step's multiplication are the same time.
inline double with_round_off(double time) {
  return time + 4.0 * std::numeric_limits<double>::epsilon() * std::fabs(time);
}

/// Forbids edits in its scope.
class Lock {
 public:
  explicit Lock(World& world) : world_(world) { world_.locked = true; }
  ~Lock() { world_.locked = false; }
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;

 private:
  World& world_;
};

/// Puts back at the end of its scope whether the world is locked, and who acts.
class Acting {
 public:
  explicit Acting(World& world) : world_(world), locked_(world.locked), who_(world.who) {}
  ~Acting() {
    world_.locked = locked_;
    world_.who = std::move(who_);
  }
  Acting(const Acting&) = delete;
  Acting& operator=(const Acting&) = delete;

 private:
  World& world_;
  bool locked_;
  std::function<std::string()> who_;
};

/// Writes a line into the log, at the present time.
void log_line(World& world, std::string kind, std::string text);

}  // namespace pantin
