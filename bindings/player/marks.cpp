#include "player/marks.hpp"

namespace pantin::player {
namespace {

Mark::Kind mark_kind(Drawing::Kind kind) {
  switch (kind) {
    case Drawing::Kind::arrow: return Mark::Kind::arrow;
    case Drawing::Kind::text: return Mark::Kind::text;
    case Drawing::Kind::point: return Mark::Kind::point;
    case Drawing::Kind::line: break;
  }
  return Mark::Kind::line;
}

}  // namespace

void write_marks_of(const Scene& scene, std::vector<Mark>& marks) {
  marks.resize(scene.drawings().size());
  for (std::size_t i = 0; i < marks.size(); i++) {
    const Drawing& d = scene.drawings()[i];
    Mark& mark = marks[i];
    mark.kind = mark_kind(d.kind);
    mark.from = d.from;
    mark.to = d.to;
    mark.color = d.color;
    mark.size = d.size;
    mark.on_screen = d.on_screen;
    mark.text = d.text;
  }
}

}  // namespace pantin::player
