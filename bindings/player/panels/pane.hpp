#pragma once
#include <memory>
#include <string_view>

#include "player/panels/desk.hpp"

namespace pantin::player {

/// A panel: what is inside a small window of its own. It exists from when it is shown first.
class Pane {
 public:
  Pane() = default;
  virtual ~Pane() = default;
  Pane(const Pane&) = delete;
  Pane& operator=(const Pane&) = delete;

  /// Whether it has something to show of this scene.
  virtual bool useful(const Desk&) const { return true; }
  /// Between ImGui::Begin and ImGui::End.
  virtual void draw(Desk& desk) = 0;
  /// Another scene was opened.
  virtual void reset() {}
};

/// How a panel is added: a line in `pane_kinds`.
struct PaneKind {
  const char* title;
  const char* about;  ///< one line
  float width;        ///< [px] at scale 1
  bool left;          ///< stands at the left edge, under the scene's buttons; else at the right
  bool open;          ///< from the start
  std::unique_ptr<Pane> (*make)();
};

std::unique_ptr<Pane> make_parameters_pane();
std::unique_ptr<Pane> make_time_pane();
std::unique_ptr<Pane> make_probes_pane();
std::unique_ptr<Pane> make_ledger_pane();
std::unique_ptr<Pane> make_solver_pane();
std::unique_ptr<Pane> make_phases_pane();
std::unique_ptr<Pane> make_log_pane();
std::unique_ptr<Pane> make_inspector_pane();

/// Each has its key, in their order: KeyUse::panel.
inline constexpr PaneKind pane_kinds[] = {
    {"Parameters", "what the scene lets you change", 210.0f, true, true, make_parameters_pane},
    {"Time", "what was set to happen: what fired, what was dropped, what waits", 400.0f, false, false, make_time_pane},
    {"Probes", "what the scene measures, as plots", 380.0f, false, false, make_probes_pane},
    {"Energy", "where energy came from and went", 300.0f, false, false, make_ledger_pane},
    {"Solver", "articulates, unknowns, contacts, iterations, fallbacks", 300.0f, false, false, make_solver_pane},
    {"Phases", "wall time of each phase of a step", 320.0f, false, false, make_phases_pane},
    {"Log", "what happened and what went wrong", 460.0f, false, false, make_log_pane},
    {"Thing", "the thing that you clicked, field by field, to be edited", 380.0f, false, false, make_inspector_pane},
};

/// Which panel has a title.
constexpr std::size_t pane_called(std::string_view title) {
  std::size_t i = 0;
  while (pane_kinds[i].title != title) i++;
  return i;
}

}  // namespace pantin::player
