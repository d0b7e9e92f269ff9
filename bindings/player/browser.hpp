#pragma once
#include <memory>
#include <string>
#include <vector>

#include "player/catalogue.hpp"
#include "player/portraits.hpp"

namespace pantin::player {

/// All scenes as cards with a picture, a title and what they are about, over the whole window.
class Browser {
 public:
  /// Scenes of `shipped`, then of `own`.
  Browser(const std::string& shipped, std::string games, std::string own, SceneOptions options);

  void show();
  void hide();
  bool shown() const { return shown_; }
  /// Within a frame of Dear ImGui. `open`: the present scene's path, or empty where there is none.
  void draw(const std::string& open, float width, float height);
  /// Between two frames, in which it may draw a picture.
  void work(bool dark);
  /// What was chosen in the last `draw`, or empty.
  const std::string& chosen() const { return chosen_; }
  /// Esc was pressed where there was nothing to search for.
  bool left() const { return left_; }
  /// Path of the scene so many places on from that at `path`, round and round; empty where there is none.
  std::string neighbour(const std::string& path, int places);

 private:
  void draw_head(float width);
  void draw_cards(const std::string& open);
  bool draw_card(const SceneEntry& scene, float width, bool lit, bool is_nonconservative);
  void list();
  void search();
  bool found(const SceneEntry& scene) const;
  int rank(const SceneEntry& scene) const;
  void move_mark(int columns);

  std::string shipped_, games_, own_;
  SceneOptions options_;
  std::vector<SceneEntry> scenes_;
  std::vector<std::size_t> shown_scenes_;  ///< those that the search finds
  bool listed_ = false;                    ///< anew, since the last search
  std::size_t mark_ = 0;                   ///< of these, the one that Enter opens
  bool moved_ = false;                     ///< the mark, by a key
  std::unique_ptr<Portraits> portraits_;   ///< from when it is shown first
  std::string search_, searched_;
  std::string chosen_;
  bool shown_ = false, appearing_ = false, left_ = false;
};

}  // namespace pantin::player
