#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "view/draw_list.hpp"
#include "view/gl.hpp"
#include "view/texture.hpp"

namespace pantin {

/// What shows pictures, with their textures, which are made when they are first shown. Needs a current context as long as
/// it lives.
class Sheets {
 public:
  /// `edges` are the definitions of `edges.glsl`.
  explicit Sheets(std::string edges);
  ~Sheets();

  void send(const std::vector<DrawList::Sheet>& list);
  bool empty() const { return sheets_.empty(); }
  void draw_shadows(const ShaderProgram& program) const;
  void draw_sprite_shadows(const ShaderProgram& program) const;
  void draw_globes(const ShaderProgram& program) const;
  /// `set_camera` is called with each program.
  void draw(const std::function<void(const ShaderProgram&)>& set_camera) const;
  /// For what is drawn next; the width of the picture over its height.
  float bind(const Picture& picture) const;

 private:
  struct Programs;
  struct Sheet;
  std::string edges_;
  std::unique_ptr<Programs> programs_;  // null while nothing is shown
  std::vector<std::unique_ptr<Sheet>> sheets_;
};

}  // namespace pantin
