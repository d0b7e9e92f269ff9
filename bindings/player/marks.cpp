#include "player/marks.hpp"

namespace pantin::player {
namespace {

Mark::Kind mark_kind(lua::Drawing::Kind kind) {
  switch (kind) {
    case lua::Drawing::Kind::arrow: return Mark::Kind::arrow;
    case lua::Drawing::Kind::text: return Mark::Kind::text;
    case lua::Drawing::Kind::point: return Mark::Kind::point;
    case lua::Drawing::Kind::line: break;
  }
  return Mark::Kind::line;
}

}  // namespace

std::vector<Mark> marks_of(const lua::Scene& scene) {
  std::vector<Mark> marks;
  marks.reserve(scene.drawings().size());
  for (const lua::Drawing& d : scene.drawings())
    marks.push_back({mark_kind(d.kind), d.from, d.to, d.color, d.size, d.on_screen, d.text});
  return marks;
}

}  // namespace pantin::player
