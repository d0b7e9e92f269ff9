#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/lanes.hpp"
#include "model/bend.hpp"
#include "model/body.hpp"
#include "model/breaking.hpp"
#include "model/particle.hpp"
#include "model/path.hpp"
#include "model/point.hpp"

namespace pantin {

enum class ConstraintKind : std::uint8_t {
#define CONSTRAINT_KIND(name) name,
#include "model/constraint_kinds.hpp"
};
/// (kinds) as messages and scripts call them
inline constexpr auto constraint_names = [] {
  std::array names = {
#define CONSTRAINT_KIND(name) std::string_view(#name),
#include "model/constraint_kinds.hpp"
  };
  names[static_cast<std::size_t>(ConstraintKind::axis)] = "axis of a hinge";
  return names;
}();

/// A point, or a position of the world, that a string goes through.
struct Passage {
  PointId point;            ///< null: a position
  Vec3 position = zero3();  ///< [m]
};

/// One of the values that a coupling adds up: the angle of a body against another or the world; or the distance of a point
/// from another or from a position; or how far it is from there along an axis.
struct CoupledValue {
  PointId point_a, point_b;  ///< null where it is an angle; point_b null: `position`
  Vec3 position = zero3();   ///< [m] in the frame of body_b, or the world's
  BodyId body_a;             ///< null where it is a distance
  BodyId body_b;             ///< null: the world
  Vec3 axis_a = zero3();     ///< unit vector in the frame of body_a
  Vec3 axis_b =
      zero3();         ///< the same in body_b's, or the world's; of a distance: along which it counts; zero: as it is
  Quat turn;           ///< orientation of body_a in body_b's frame, or the world's, that counts as 0
  double angle = 0.0;  ///< [rad] at the end of the last step, turns counted
  double fixed = 1.0;  ///< its weight, and
  double by_ratio = 0.0;  ///< what the coupling's ratio adds to that, times itself
  double total = 0.0;     ///< [m] of a slider: what this value alone is kept at, or below
  Vec3 force = zero3();   ///< [N] of a slider: on point_a in the last step
};

struct JoinProgress;

constexpr double usual_time_constant = 0.1;  // [s]

/// What a constraint wants of a value: what it is at the end of the step, and was before.
template <class T, class Rate = T>
struct Prescribed {
  T now{};                           ///< at the end of this step
  T previous{};                      ///< one step ago
  T before{};                        ///< two steps ago, once it was moved twice or more
  Rate rate{};                       ///< [1/s] at the end of this step
  Rate previous_rate{};              ///< one step ago
  Rate change{}, earlier_change{};   ///< [1/s] of its mean rate, from step to step; the one before
  std::function<T(double)> of_time;  ///< at time t [s]; empty where it is set by hand
};

/// What is far from where a constraint wants it comes nearer as fast as `time_constant` says.
struct Attraction {
  double excess = 0.0;           ///< [m] or [rad] by which its number is beyond
  double excess_rate = 0.0;      ///< [1/s]
  double previous_excess = 0.0;  ///< one step ago
  double first_excess = 0.0;     ///< where it began
  Vec3 away = zero3();           ///< [m], [rad] of an orient: how far its point or body is
  Vec3 away_rate = zero3();      ///< [1/s]
  Vec3 previous_away = zero3();  ///< one step ago
};

// What only one kind has.

struct AxisData {
  ParticleId ring;          ///< the hinge it belongs to
  std::uint64_t given = 0;  ///< what all axes that were given at once have in common, a serial
};
struct WeldData {
  Vec3 arm_a = zero3(), arm_b = zero3();  ///< [m] its position in the frames of its bodies
};
struct StringData {
  std::vector<Passage> passages;  ///< from end to end
};
struct PathData {
  std::shared_ptr<const Path> path;
  double along = 0.0;  ///< its parameter at the end of the last step,
  PathRun run = {};    ///< and between which corners it was
};
struct JoinData {
  std::shared_ptr<JoinProgress> progress;
};
struct CouplingData {
  std::vector<CoupledValue> values;
  double total = 0.0;  ///< [rad] or [m] that they add up to
  bool given = false;  ///< that was told, else it is what they added up to when it was made
  bool apart = false;  ///< they do not add up: each is kept by itself
};

struct Constraint {
  ConstraintKind kind = ConstraintKind::nail;
  PointId a;      ///< the point that it ties; null where it ties rotations
  PointId b;      ///< of a rod, limit or join; null where its other end is a position of the world
  BodyId body_a;  ///< whose rotation it ties
  BodyId body_b;  ///< to this one's; null: to the world

  Prescribed<Vec3> position;    ///< [m] of a nail, a follow, the world end of a rod
  Prescribed<double> number;    ///< [m] of a rod or string, [rad] of a motor or align, ratio of a coupling
  Prescribed<Quat, Vec3> turn;  ///< of body_a in body_b's frame, or the world's
  bool by_speed = false;        ///< a motor that is told its speed, the rate of `number` [rad/s]
  Bend bend;                    ///< of what moves, in this step: [m], [rad]; of a number the first component
  std::uint32_t moves = 0;      ///< samples of what moves since it last jumped
  Attraction attract;
  double time_constant = usual_time_constant;  ///< [s] of that, and of how fast a soft follow answers; > 0

  Vec3 axis_a = zero3();         ///< unit vector in the frame of body_a; of an on_plane its normal
  Vec3 axis_b = zero3();         ///< the same in body_b's frame, or the world's
  double angle = 0.0;            ///< [rad] of a motor or limit at the end of the last step, turns counted
  double low = 0.0, high = 0.0;  ///< [m] or [rad] of a limit
  double max_force = std::numeric_limits<double>::infinity();   ///< [N] of a follow, > 0
  double max_torque = std::numeric_limits<double>::infinity();  ///< [N m] of a motor, > 0
  std::variant<std::monostate, AxisData, WeldData, StringData, PathData, JoinData, CouplingData> own;

  std::int32_t hand = -1;  ///< of a hand's grab: index of the hand
  bool enabled = true;
  Breaking breaks_at;
  Vec3 force = zero3();   ///< [N] on a in the last step; of a rod along it
  Vec3 torque = zero3();  ///< [N m] on body_a in the last step
  double tension = 0.0;   ///< [N] of a rod in the last step, > 0 when it pulls
  std::string name;
  std::uint64_t serial = 0;

  /// What only its kind has.
  template <class Data>
  Data& as() {
    return std::get<Data>(own);
  }
  template <class Data>
  const Data& as() const {
    return std::get<Data>(own);
  }
  template <class Data>
  bool is() const {
    return std::holds_alternative<Data>(own);
  }
  /// What a string goes through, from end to end; empty of others.
  std::span<const Passage> passages() const {
    return is<StringData>() ? std::span<const Passage>(as<StringData>().passages) : std::span<const Passage>();
  }
  /// The values of a coupling; empty of others.
  std::span<const CoupledValue> coupled() const {
    return is<CouplingData>() ? std::span<const CoupledValue>(as<CouplingData>().values)
                              : std::span<const CoupledValue>();
  }
  /// The hinge of an axis; null of others.
  ParticleId ring() const { return is<AxisData>() ? as<AxisData>().ring : ParticleId(); }
  /// Of a join; null of others.
  std::shared_ptr<JoinProgress> progress() const { return is<JoinData>() ? as<JoinData>().progress : nullptr; }

  /// Calls `visit` with each point that it ties; of a coupling once.
  template <class Visit>
  void each_point(Visit visit) const {
    if (passages().empty() && coupled().empty())
      for (PointId point : {a, b})
        if (point) visit(point);
    for (const Passage& passage : passages())
      if (passage.point) visit(passage.point);
    const std::span<const CoupledValue> coupled = this->coupled();
    for (std::size_t i = 0; i < coupled.size(); i++)
      for (PointId point : {coupled[i].point_a, coupled[i].point_b}) {
        bool seen = !point;
        for (std::size_t k = 0; k < i; k++) seen = seen || point == coupled[k].point_a || point == coupled[k].point_b;
        if (!seen) visit(point);
      }
  }
  /// Calls `visit` with each body whose rotation it ties, once.
  template <class Visit>
  void each_body(Visit visit) const {
    for (BodyId body : {body_a, body_b})
      if (body) visit(body);
    const std::span<const CoupledValue> coupled = this->coupled();
    for (std::size_t i = 0; i < coupled.size(); i++)
      for (BodyId body : {coupled[i].body_a, coupled[i].body_b}) {
        bool seen = !body || body == body_a || body == body_b;
        for (std::size_t k = 0; k < i; k++) seen = seen || body == coupled[k].body_a || body == coupled[k].body_b;
        if (!seen) visit(body);
      }
  }
};

using ConstraintId = Handle<Constraint>;

/// What a join does besides attracting its points to each other.
struct JoinProgress {
  ConstraintId holder;                     ///< that attracts its first point to a position, and goes with it; or null
  std::function<void(ParticleId)> on_met;  ///< called with the hinge, in the step after that in which they met
  std::string hinge_name;
  Vec3 hinge_axis = zero3();                                 ///< world axes; 0: it turns freely
  std::string label;                                         ///< "scene.lua:12"
  double nearest = std::numeric_limits<double>::infinity();  ///< [m] its points were to each other so far
  double nearest_at = 0.0;                                   ///< [s]
  bool told = false;                                         ///< that they come no nearer
};

}  // namespace pantin
