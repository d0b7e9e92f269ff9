// `scene.draw`: lines, arrows, text and points for one frame.
#include "lua/thing/fields.hpp"
#include "lua/thing/script.hpp"
#include "lua/thing/targets.hpp"
#include "lua/value/arguments.hpp"
#include "lua/vm/guard.hpp"
#include "scene/drawing.hpp"

namespace pantin::lua {
namespace {

constexpr double largest_size = 1000.0;  // [px]

double check_size(const Options& o, const char* key, double usual) {
  const double size = o.number(key, "px").value_or(usual);
  require(size > 0.0 && size <= largest_size, o.what(), ": ", key, " must be > 0 and at most ", largest_size,
          " px, got ", size);
  return size;
}

void take_look(Drawing& drawing, const Options& o, const char* size, double usual_size) {
  drawing.color = o.color("color");
  drawing.size = check_size(o, size, usual_size);
  const std::string space = o.string("space").value_or("scene");
  require(space == "scene" || space == "screen", o.what(), ": space must be \"scene\" or \"screen\", got \"", space,
          "\"");
  drawing.on_screen = space == "screen";
}

int put(const Self& self, Drawing drawing) {
  std::vector<Drawing>& list = self.script.drawings;
  require(list.size() < most_drawings, "draw: at most ", most_drawings,
          " lines, arrows, texts and points may be drawn in one step");
  list.push_back(std::move(drawing));
  return 0;
}

int draw_between(lua_State* state, const char* call, Drawing::Kind kind) {
  const Self self = check_self(state, Kind::draw, call);
  Drawing drawing;
  drawing.kind = kind;
  drawing.from = check_vec(state, 2, call, argument(1), "m");
  drawing.to = check_vec(state, 3, call, argument(2), "m");
  take_look(drawing, Options(state, 4, call, {"color", "width", "space"}), "width", 2.0);
  return put(self, std::move(drawing));
}

int draw_line(lua_State* state) { return draw_between(state, "line", Drawing::Kind::line); }
int draw_arrow(lua_State* state) { return draw_between(state, "arrow", Drawing::Kind::arrow); }

int draw_text(lua_State* state) {
  const Self self = check_self(state, Kind::draw, "text");
  Drawing drawing;
  drawing.kind = Drawing::Kind::text;
  drawing.from = check_vec(state, 2, "text", argument(1), "m");
  drawing.text = check_text(state, 3, "text", argument(2));
  require(drawing.text.size() <= longest_text, "text: ", argument(2), " may have at most ", longest_text,
          " bytes, got ", drawing.text.size());
  take_look(drawing, Options(state, 4, "text", {"color", "size", "space"}), "size", 14.0);
  return put(self, std::move(drawing));
}

int draw_point(lua_State* state) {
  const Self self = check_self(state, Kind::draw, "point");
  Drawing drawing;
  drawing.kind = Drawing::Kind::point;
  drawing.from = check_vec(state, 2, "point", argument(1), "m");
  take_look(drawing, Options(state, 3, "point", {"color", "size", "space"}), "size", 8.0);
  return put(self, std::move(drawing));
}

Type make_draw_type() {
  Type type{"Draw",
            "draw",
            "Draws over the scene what is shown until the next step: call it in each step. On the screen (space = "
            "\"screen\") x and y are in px from the upper left corner, negative ones from the right or lower edge. "
            "The window's title and bar are over the upper 45 px, its tools and status line over the lower 120 px, and "
            "scene:button begins at the left below the title.",
            {},
            {}};
  type.methods = {
      {"line", guard<draw_line>, "from: vec [m], to: vec [m], options?: LineOptions", "", "A line.",
       "scene:on(\"step\", function() scene.draw:line(p.position, q.position, { color = \"#f00\", width = 3 }) end)"},
      {"arrow", guard<draw_arrow>, "from: vec [m], to: vec [m], options?: LineOptions", "", "An arrow to a position.",
       "scene:on(\"step\", function() scene.draw:arrow(p.position, p.position + p.velocity) end)"},
      {"text", guard<draw_text>, "at: vec [m], text: string, options?: MarkOptions", "",
       "Text whose upper left corner is at a position; \\n begins a new line.",
       "scene:on(\"step\", function() scene.draw:text(vec(10, 10, 0), \"t = \" .. scene.time, { space = \"screen\" }) "
       "end)"},
      {"point", guard<draw_point>, "at: vec [m], options?: MarkOptions", "", "A dot.",
       "scene:on(\"step\", function() scene.draw:point(vec(0, 1, 0), { size = 12 }) end)"},
  };
  return type;
}

}  // namespace

const Type& draw_type() {
  static const Type type = make_draw_type();
  return type;
}

}  // namespace pantin::lua
