#include "bindings/lua_support.hpp"
#include "player/marks.hpp"

using namespace pantin;
using namespace pantin::lua_tests;
using Catch::Contains;

TEST_CASE("what a script draws in a step is there until the next") {
  const auto scene = open(R"(
    scene.draw:text(vec(1, 2, 3), "before")
    scene:on("step", function()
      scene.draw:line(vec(0, 0, 0), vec(1, 0, 0), { color = "#f00", width = 3 })
      scene.draw:arrow(vec(0, 0, 0), vec(0, 1, 0))
      scene.draw:point(vec(-5, 7, 0), { space = "screen", size = 20 })
    end)
    scene:at(1.5 / 240, function() scene.draw:text(vec(0, 0, 0), "third") end))");
  REQUIRE(scene->drawings().size() == 1);
  CHECK(scene->drawings()[0].text == "before");
  for (const std::size_t count : {3u, 3u, 4u, 3u}) {
    scene->step();
    CHECK(scene->drawings().size() == count);
  }
  const Drawing &line = scene->drawings()[0], &dot = scene->drawings()[2];
  CHECK(line.kind == Drawing::Kind::line);
  CHECK(line.to[0] == 1.0);
  CHECK(line.size == 3.0);
  CHECK(*line.color == Color{1.0f, 0.0f, 0.0f, 1.0f});
  CHECK(dot.on_screen);
  CHECK_FALSE(dot.color);
}

TEST_CASE("the overlay's marks are what the script drew") {
  const auto scene = open(R"(
    scene.draw:line(vec(0, 0, 0), vec(1, 0, 0)) scene.draw:arrow(vec(0, 0, 0), vec(1, 0, 0))
    scene.draw:text(vec(4, 5, 6), "word", { size = 9, color = "#00ff0088" }) scene.draw:point(vec(1, 1, 0), { space = "screen" }))");
  std::vector<Mark> marks;
  player::write_marks_of(*scene, marks);
  REQUIRE(marks.size() == 4);
  CHECK(marks[0].kind == Mark::Kind::line);
  CHECK(marks[1].kind == Mark::Kind::arrow);
  CHECK(marks[2].kind == Mark::Kind::text);
  CHECK(marks[2].text == "word");
  CHECK(marks[2].size == 9.0);
  CHECK(marks[2].from[2] == 6.0);
  CHECK(marks[2].color->a == Approx(0x88 / 255.0));
  CHECK(marks[3].kind == Mark::Kind::point);
  CHECK(marks[3].on_screen);
}

TEST_CASE("bad arguments of scene.draw are errors that name them") {
  CHECK_THAT(failure("scene.draw.line(vec(0, 0, 0))"), Contains("scene.lua:1: draw: call line with a colon"));
  CHECK_THAT(failure("scene.draw:line(1)"), Contains("line: argument 1 must be a vec [m], got a number"));
  CHECK_THAT(failure("scene.draw:arrow(vec(0, 0, 0), vec(0/0, 0, 0))"), Contains("argument 2 must be a finite vec"));
  CHECK_THAT(failure("scene.draw:text(vec(0, 0, 0))"), Contains("text: argument 2 must be a string"));
  CHECK_THAT(failure("scene.draw:text(vec(0, 0, 0), ('x'):rep(1001))"), Contains("at most 1000 bytes, got 1001"));
  CHECK_THAT(failure("scene.draw:point(vec(0, 0, 0), { size = 0 })"),
             Contains("size must be > 0 and at most 1000 px, got 0"));
  CHECK_THAT(failure("scene.draw:point(vec(0, 0, 0), { space = 'moon' })"),
             Contains("space must be \"scene\" or \"screen\", got \"moon\""));
  CHECK_THAT(failure("scene.draw:line(vec(0, 0, 0), vec(1, 0, 0), { size = 3 })"), Contains("unknown field 'size'"));
  CHECK_THAT(failure("scene.draw:circle(vec(0, 0, 0))"), Contains("unknown field 'circle'"));
  CHECK_THAT(failure("scene.draw = 1"), Contains("draw can be read, not written"));
  CHECK_THAT(failure("for i = 1, 10001 do scene.draw:point(vec(0, 0, 0)) end"), Contains("draw: at most 10000 lines"));
}
