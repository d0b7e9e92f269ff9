#include "view/sheets.hpp"

#include <algorithm>
#include <iostream>
#include <utility>

#include "scene/printable.hpp"

namespace pantin {

struct Sheets::Programs {
  ShaderProgram surface, globe;

  explicit Programs(const std::string& edges)
      : surface("pictured", {"common.glsl", "edges.glsl", "opacity.glsl", "picture.glsl"}, edges),
        globe("ellipsoid", {"common.glsl", "edges.glsl", "opacity.glsl", "picture.glsl", "globe.glsl"}, edges) {}
};

struct Sheets::Sheet {
  std::shared_ptr<const Picture> picture;
  Texture texture;
  FloatRows corners{{3, 3, 4, 2}, false}, sprites{{3, 3, 4, 2}, false}, shades{{3, 3, 4, 2}, false},
      globes{{3, 3, 3, 3, 3, 4}, true};
};

namespace {

Texture texture_of(const Picture& picture) {
  if (auto made = Texture::of_content(picture.content)) return std::move(*made);
  std::cerr << "pantin: the picture '" << printable(picture.file) << "' cannot be made out\n";
  constexpr std::uint8_t white[] = {255, 255, 255, 255};
  return {white, 1, 1};
}

}  // namespace

Sheets::Sheets(std::string edges) : edges_(std::move(edges)) {}
Sheets::~Sheets() = default;

void Sheets::send(const std::vector<DrawList::Sheet>& list) {
  if (list.empty() && sheets_.empty()) return;
  if (!programs_) programs_ = std::make_unique<Programs>(edges_);
  std::vector<std::unique_ptr<Sheet>> kept;
  for (const DrawList::Sheet& sheet : list) {
    const auto known =
        std::ranges::find_if(sheets_, [&](const auto& made) { return made && made->picture == sheet.picture; });
    kept.push_back(known != sheets_.end()
                       ? std::move(*known)
                       : std::unique_ptr<Sheet>(new Sheet{sheet.picture, texture_of(*sheet.picture)}));
    kept.back()->corners.send(sheet.corners);
    kept.back()->sprites.send(sheet.sprites);
    kept.back()->shades.send(sheet.shades);
    kept.back()->globes.send(sheet.globes);
  }
  sheets_ = std::move(kept);
}

void Sheets::draw_shadows(const ShaderProgram& program) const {
  for (const auto& sheet : sheets_) sheet->corners.draw(program, GL_TRIANGLES);
}

void Sheets::draw_sprite_shadows(const ShaderProgram& program) const {
  for (const auto& sheet : sheets_) {
    if (sheet->shades.count() == 0) continue;
    sheet->texture.bind();
    sheet->shades.draw(program, GL_TRIANGLES);
  }
}

void Sheets::draw_globes(const ShaderProgram& program) const {
  for (const auto& sheet : sheets_) sheet->globes.draw(program, GL_TRIANGLE_STRIP, 4);
}

void Sheets::draw(const std::function<void(const ShaderProgram&)>& set_camera) const {
  if (sheets_.empty()) return;
  set_camera(programs_->surface);
  set_camera(programs_->globe);
  for (const auto& sheet : sheets_) {
    sheet->texture.bind();
    sheet->corners.draw(programs_->surface, GL_TRIANGLES);
    sheet->sprites.draw(programs_->surface, GL_TRIANGLES);
    sheet->globes.draw(programs_->globe, GL_TRIANGLE_STRIP, 4);
  }
}

float Sheets::bind(const Picture& picture) const {
  for (const auto& sheet : sheets_)
    if (sheet->picture.get() == &picture) sheet->texture.bind();
  return static_cast<float>(picture.columns) / static_cast<float>(picture.rows);
}

}  // namespace pantin
