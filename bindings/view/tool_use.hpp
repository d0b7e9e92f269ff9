#pragma once
#include <string>
#include <vector>

#include "view/tools.hpp"
#include "view/viewport.hpp"

namespace pantin {

/// Where the use of tools puts what it does: commands for the coming step, what to say of them, and the names of acts
/// whose first command is among them.
struct ToolOutput {
  StepInput& input;
  std::vector<std::string>& said;
  std::vector<std::string>& acts;
};

/// What one hand does with a tool, from press to release.
class ToolUse {
 public:
  void press(const Viewport& viewport, ToolChoice choice, std::int32_t hand, double x, double y, ToolOutput& output);
  void move(const Viewport& viewport, double x, double y, ToolOutput& output);
  /// Once for each picture in which it is down; `time` [s] since the last.
  void hold(const Viewport& viewport, double time, ToolOutput& output);
  void release(const Viewport& viewport, ToolOutput& output);
  /// The hand is gone: it lets go, and does no more.
  void cancel(ToolOutput& output);

  /// The world goes on in another, with another number of the hand and another point: a drag goes on where the point is
  /// not null, all else ends.
  void carry_over(std::int32_t hand, PointId point);

  /// Whether what it makes is on the grid.
  void snap(bool on) { snaps_ = on; }
  bool snaps() const { return snaps_; }

  bool active() const { return active_; }
  /// Corners [m] of a polygon that is drawn by clicks, and by this press along a stroke.
  const std::vector<Vec3>& corners() const { return corners_; }
  /// Holds a point by dragging it.
  bool holding() const { return active_ && choice_.kind == ToolKind::drag && (point_ || body_); }
  ToolChoice choice() const { return choice_; }
  PointId point() const { return point_; }  ///< at which it began, or null
  /// Whether there is what it began at.
  bool begun_at(const World& world) const;
  /// Where the hand is [m]: at the depth of what it began at.
  Vec3 place(const Viewport& viewport, double x, double y) const;
  /// Where it began to drag [m]: the point as it is now, or the place of the press.
  Vec3 start(const Viewport& viewport) const;
  /// Where it went last, for a stroke [px].
  const std::vector<Vec3>& trail() const { return trail_; }
  /// From the press to the cursor [m], along the picture.
  Vec3 way(const Viewport& viewport) const;

  /// What is made by a drag as it is now; its `points` and `place`.
  Command making(const Viewport& viewport) const;
  /// The impulse [N s] and the change of spin [rad/s] of a drag as it is now.
  Vec3 impulse(const Viewport& viewport) const;
  /// "45.0 N s: 9.00 m/s", as it is and what it makes of the thing that is pushed.
  std::string push_story(const Viewport& viewport) const;
  Vec3 turn(const Viewport& viewport) const;

 private:
  Command command(Command::Kind kind) const;
  Command command_there(const Viewport& viewport, Command::Kind kind) const;
  void take_point(const World& world);
  void send(Command command, ToolOutput& output);
  void grab(const Viewport& viewport, ToolOutput& output);
  void nail(const Viewport& viewport, ToolOutput& output);
  void cut(const Viewport& viewport, double x, double y, ToolOutput& output);
  void remove(const Viewport& viewport, ToolOutput& output);
  void join(const Viewport& viewport, ToolOutput& output);
  void draw_on(const Viewport& viewport);
  void end_corner(const Viewport& viewport, ToolOutput& output);
  void make_polygon(const Viewport& viewport, ToolOutput& output);
  void turn_or_push(const Viewport& viewport, ToolOutput& output);
  bool is_click() const;
  BodyId body_of(const World& world) const;
  double mass_pushed(const World& world) const;

  ToolChoice choice_;
  std::int32_t hand_ = -1;
  bool active_ = false, acted_ = false, snaps_ = false;
  double x0_ = 0.0, y0_ = 0.0, x_ = 0.0, y_ = 0.0;  // [px] of the press, and now
  double depth_ = 0.0;                              // [m]
  Vec3 offset_ = zero3();                           // [m] from the place under the pointer to the point
  PointId point_;
  BodyId body_;              // at which it began where that has no point; until a drag has given it one
  Vec3 on_body_ = zero3();   // [m] the place, in the body's frame
  std::vector<AnyId> done_;  // what it cut or removed
  std::vector<Vec3> trail_;
  std::vector<Vec3> corners_;
  std::size_t clicked_ = 0;  // of the corners, before this press
};

/// A number with three digits or so, without an exponent where that is readable: "0.123", "45.6", "2040".
std::string short_number(double value);
/// Radius [m] of the ball that the tool "heat" reaches: a fifteenth of the picture's height, where the hand is.
double heat_radius(const Viewport& viewport, double depth);

}  // namespace pantin
