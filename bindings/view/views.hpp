#pragma once
// What a picture can show of a world beside what it looks like. No view changes the world.
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>

namespace pantin {

enum class View : std::uint8_t {
  bodies,
  loads,
  shadows,
  rings,
  forces,
  velocities,
  trails,
  families,
  articulates,
  islands,
  temperature,
  errors,
  cells,
  contacts,
  contact_forces,
  asleep,
  dark
};

struct NamedView {
  View view;
  const char* name;
  const char* help;
};

/// All, in the order in which they are listed and drawn.
std::span<const NamedView> view_table();

/// Those that are on.
class Views {
 public:
  /// Bodies, loads and shadows.
  Views() : Views({View::bodies, View::loads, View::shadows}) {}
  Views(std::initializer_list<View> on) {
    for (const View view : on) set(view, true);
  }
  bool on(View view) const { return (bits_ >> static_cast<unsigned>(view) & 1u) != 0; }
  /// Of those that colour things, the last one set is the only one.
  void set(View view, bool wanted);
  void toggle(View view) { set(view, !on(view)); }
  friend bool operator==(const Views&, const Views&) = default;

 private:
  std::uint32_t bits_ = 0;
};

/// Reads "rings,forces,-shadows": what is added to those that are on at first, and with a minus taken away. Throws Error
/// that lists the names.
Views read_views(const std::string& list);

}  // namespace pantin
