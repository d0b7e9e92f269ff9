#include "bindings/lua_support.hpp"

using namespace pantin;
using namespace pantin::lua_tests;
using Catch::Contains;

TEST_CASE("vecs add, scale and measure") {
  CHECK(failure(R"(
    local a, b = vec(1, 2, 3), vec(0, 1, -1)
    assert(a + b == vec(1, 3, 2) and a - b == vec(1, 1, 4) and -a == vec(-1, -2, -3))
    assert(a * 2 == vec(2, 4, 6) and 2 * a == a * 2 and a / 2 == vec(0.5, 1, 1.5))
    assert(a:dot(b) == -1 and a:cross(b) == vec(-5, 1, 1) and vec(3, 0, 4):length() == 5)
    assert(vec(0, 0, 2):normalized() == vec(0, 0, 1))
    assert(a.x == 1 and a.y == 2 and a.z == 3 and a ~= b and a ~= 3)
    assert(tostring(vec(1, 2.5, -0.0)) == 'vec(1, 2.5, 0)'))") == "");
  CHECK(failure("local x = vec(1, 2, 3) * vec(1, 2, 3)") ==
        "scene.lua:1: vec * vec could mean two things: write a:dot(b) or a:cross(b)");
  CHECK_THAT(failure("vec(1, 2)"), Contains("vec: z must be a number, got nil"));
  CHECK_THAT(failure("vec(1, 2, 3, 4)"), Contains("takes three numbers"));
  CHECK_THAT(failure("local x = vec(1, 2, 3) + 1"), Contains("needs two vecs, got a number"));
  CHECK_THAT(failure("local x = vec(1, 2, 3) / vec(1, 2, 3)"), Contains("vec / needs a vec and a number"));
  CHECK_THAT(failure("local x = vec(1, 2, 3).w"), Contains("unknown field 'w'"));
  CHECK_THAT(failure("vec(0, 0, 0):normalized()"), Contains("no direction"));
}

TEST_CASE("values do not change, and the message says what to write") {
  CHECK_THAT(failure("local p = scene:particle() p.position.y = 3"),
             Contains("scene.lua:1: vec: y of a vec cannot be changed") && Contains("thing.position = vec(x, y, z)"));
  CHECK_THAT(failure("quat(vec(0, 1, 0), 1).w = 2"), Contains("cannot be changed"));
}

TEST_CASE("a vec may hold NaN, but the world takes none") {
  CHECK(failure("local v = vec(0/0, 0, 0) assert(v.x ~= v.x)") == "");
  CHECK_THAT(failure("scene.gravity = vec(0/0, 0, 0)"),
             Contains("scene: gravity must be a finite vec [m/s²], got vec(NaN, 0, 0)"));
  CHECK_THAT(failure("scene:particle { at = vec(1/0, 0, 0) }"),
             Contains("particle: at must be a finite vec [m], got vec(infinity, 0, 0)"));
}

TEST_CASE("quats turn") {
  CHECK(failure(R"(
    local q = quat(vec(0, 0, 2), math.pi / 2)
    assert((q:rotate(vec(1, 0, 0)) - vec(0, 1, 0)):length() < 1e-15)
    assert(((q * q):rotate(vec(1, 0, 0)) - vec(-1, 0, 0)):length() < 1e-15)
    assert((q:inverse():rotate(vec(0, 1, 0)) - vec(1, 0, 0)):length() < 1e-15)
    assert(q == quat(vec(0, 0, 1), math.pi / 2)))") == "");
  CHECK_THAT(failure("quat(vec(0, 0, 0), 1)"), Contains("an axis, a finite vec that is not 0"));
  CHECK_THAT(failure("quat(vec(1, 0, 0), 'x')"), Contains("must be a number [rad], got a string"));
  CHECK_THAT(failure("local q = quat(vec(1, 0, 0), 1) * vec(1, 0, 0)"), Contains("q:rotate(v)"));
}

TEST_CASE("colors are written in four ways and read in one") {
  const auto read = [](const std::string& color) {
    return word("local p = scene:particle { color = " + color + " } scene:result('x', p.color)");
  };
  CHECK(read("'#e84'") == "#ee8844");
  CHECK(read("'#E08040'") == "#e08040");
  CHECK(read("'#e0804080'") == "#e0804080");
  CHECK(read("{ 1, 0, 0.2 }") == "#ff0033");
  CHECK(read("{ 1, 0, 0.2, 0.4 }") == "#ff003366");
  for (const char* bad : {"'red'", "'#12'", "'#12345g'", "{ 1, 2, 3 }", "{ 1, 0 }", "3"})
    CHECK_THAT(failure("scene:particle { color = " + std::string(bad) + " }"),
               Contains("particle: color must be a color"));
}
