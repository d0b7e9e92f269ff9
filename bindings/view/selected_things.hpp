#pragma once
#include <string>
#include <vector>

#include "view/overlay.hpp"
#include "view/tool_use.hpp"
#include "view/viewport.hpp"

namespace pantin {

/// Things that are copied, moved and removed as one, each with all that is joined to it. They are chosen by clicks, or by a
/// box that is drawn over them, with shift held.
class SelectedThings {
 public:
  bool empty() const { return things_.empty(); }
  void clear();
  /// One of each whole that is chosen and still there: a body, or the point of a free particle.
  std::vector<AnyId> wholes(const World& world) const;
  bool has(const World& world, const AnyId& thing) const;

  /// A press, with shift or, where `moves`, upon what is chosen; then moves and the release of the same pointer.
  void press(double x, double y, bool moves);
  void move(double x, double y);
  /// Moved is what was chosen, by commands of that hand; else it says how many things are.
  void release(const Viewport& viewport, std::int32_t hand, ToolOutput& output);
  bool pressed() const { return does_ != Does::nothing; }

  void add_marks(const Viewport& viewport, std::vector<Mark>& marks) const;

 private:
  enum class Does : std::uint8_t { nothing, chooses, moves };
  void choose(const Viewport& viewport);
  Vec3 way(const Viewport& viewport) const;

  std::vector<AnyId> things_;
  Does does_ = Does::nothing;
  double x0_ = 0.0, y0_ = 0.0, x_ = 0.0, y_ = 0.0;  // [px]
};

/// The body that is seen at a pixel, or that has the point there, or the point of a free particle; monostate: nothing.
AnyId thing_at(const Viewport& viewport, double x, double y);
/// [m] Its centre.
Vec3 centre_of(const World& world, const AnyId& thing);
/// A command of a hand that means a thing.
Command command_of(Command::Kind kind, std::int32_t hand, const AnyId& thing);

}  // namespace pantin
