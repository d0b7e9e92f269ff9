#include "bindings/lua_support.hpp"
#include "measure/measure.hpp"

using namespace pantin;
using namespace pantin::lua_tests;
using Catch::Contains;
using Catch::StartsWith;

namespace {

const std::string two_links = R"(
  local a = scene:body { name = "a", mass = 1, inertia = vec(0.1, 1, 1), at = vec(0.5, 0, 0),
                         points = { tail = vec(0.5, 0, 0), head = vec(-0.5, 0, 0) } }
  local b = scene:body { name = "b", mass = 2, inertia = vec(0.1, 1, 1), at = vec(1.5, 0, 0),
                         points = { head = vec(-0.5, 0, 0), tail = vec(0.5, 0, 0) } }
)";

}  // namespace

TEST_CASE("errors name the line, the value, the unit and what is allowed") {
  CHECK(failure("\nscene:body { mass = -1, points = { vec(0, 0, 0) } }") ==
        "scene.lua:2: body: mass must be > 0 kg, got -1");
  CHECK(failure("scene:body { mass = 'x' }") == "scene.lua:1: body: mass must be a number [kg], got a string");
  CHECK(failure("scene:body { mass = 0/0 }") == "scene.lua:1: body: mass must be a finite number [kg], got NaN");
  CHECK_THAT(failure("scene:body { points = { vec(0, 0, 0) } }"), StartsWith("scene.lua:1: body") && Contains("mass"));
  CHECK_THAT(failure("scene:body { mas = 1 }"),
             Contains("unknown field 'mas'. Did you mean 'mass'? Known are points, at"));
  CHECK_THAT(failure("scene:body()"), Contains("body: needs a table"));
  CHECK_THAT(failure("scene:body { mass = 1, points = { mass = vec(0, 0, 0) } }"),
             Contains("cannot have the name 'mass'"));
  CHECK_THAT(failure("scene:body { mass = 1, points = { push = vec(0, 0, 0) } }"),
             Contains("cannot have the name 'push'"));
  CHECK_THAT(failure("scene:body { mass = 1, points = { head = { at = vec(0, 0, 0), mass = -1 } } }"),
             Contains("'head'") && Contains("mass"));
  CHECK_THAT(failure("scene:body { mass = 1, points = { head = 3 } }"),
             Contains("body: point 'head' must be a vec [m]"));
  CHECK_THAT(failure("scene:body { mass = 1, inertia = { 1, 2 } }"), Contains("six numbers"));
  CHECK_THAT(failure("scene:particle { mass = 0 }"), Contains("particle: mass must be > 0 kg") && Contains("got 0"));
  CHECK_THAT(failure("scene:hinge(1)"),
             StartsWith("scene.lua:1: hinge: argument 1 must be a point or a free particle, got a number"));
  CHECK_THAT(failure(two_links + "scene:hinge(a, b)"),
             Contains("argument 1 must be a point or a free particle, got a body"));
  CHECK_THAT(failure(two_links + "scene:hinge(a.head, b.tail)"),
             Contains("scene.lua:6: hinge: points 1 and 2 are 2 m apart"));
  CHECK_THAT(failure(two_links + "scene:nail(a)"), Contains("got a body; name one of its points"));
  CHECK_THAT(failure(two_links + "a.massa = 2"),
             Contains("body: cannot write unknown field 'massa'. Did you mean 'mass'?"));
  CHECK_THAT(failure(two_links + "local x = a.middle"), Contains("body: unknown field 'middle'"));
  CHECK_THAT(failure(two_links + "a.momentum = vec(0, 0, 0)"), Contains("body: momentum can be read, not written"));
  CHECK_THAT(failure(two_links + "a.push = 3"), Contains("push is a method"));
  CHECK_THAT(failure(two_links + "a.push(vec(1, 0, 0))"), Contains("with a colon"));
  CHECK_THAT(failure(two_links + "a:push(3)"), Contains("push: force must be a vec [N], got a number"));
}

TEST_CASE("one thing is always the same value") {
  CHECK(failure(two_links + R"(
    assert(a == scene:find "a" and a ~= b and a.head == a.head and a.head.body == a)
    assert(a.points[1] == a.head and a.points[2] == a.tail and #a.points == 2)
    local seen = { [a] = 1 }
    assert(seen[scene.bodies[1]] == 1 and not seen[b])
    local h = scene:hinge(a.tail, b.head)
    assert(h == scene.hinges[1] and a.hinges[1] == h and a.tail.particle == h and h.bodies[2] == b and h.is_hinge)
    a.data.note = "mine"
    assert(scene:find("a").data.note == "mine" and b.data.note == nil)
    assert(tostring(a) == "body 'a'" and scene:find "nobody" == nil and #scene.connections == 0))") == "");
}

TEST_CASE("state is fields that can be written") {
  CHECK(failure(two_links + R"(
    a.position = vec(0, 5, 0) assert(a.position == vec(0, 5, 0) and a.origin == vec(0, 5, 0))
    a.velocity = vec(1, 2, 3) assert(a.velocity == vec(1, 2, 3) and a.momentum == vec(1, 2, 3))
    a.spin = vec(0, 0, 2) assert((a.spin - vec(0, 0, 2)):length() < 1e-14)
    a.orientation = quat(vec(0, 0, 1), math.pi / 2)
    assert((a.tail.position - vec(0, 5.5, 0)):length() < 1e-14 and (a.spin - vec(0, 0, 2)):length() < 1e-14)
    a.origin = vec(1, 0, 0) assert(a.position == vec(1, 0, 0))
    a.mass = 4 assert(a.mass == 4 and (a.velocity - vec(1, 2, 3)):length() < 1e-14)
    a.inertia = vec(1, 2, 2.5) assert(a.inertia == vec(1, 2, 2.5))
    a.tail.mass = 1 assert(a.mass == 5 and a.inertia == vec(1, 2.25, 2.75))
    a.inertia = { xx = 2, yy = 3, zz = 3, xy = 0.1 } assert(math.abs(a.inertia.xy - 0.1) < 1e-15)
    a.color = "#123456" assert(a.tail.color == "#123456")
    local p = scene:particle { at = vec(0, 1, 0), velocity = vec(1, 0, 0), mass = 3, radius = 0.2, lifetime = 2, name = "p" }
    p.position = vec(1, 1, 1) p.velocity = vec(0, 0, 1) p.mass = 2 p.lifetime = 5 p.radius = 0.1
    assert(p.position == vec(1, 1, 1) and p.velocity == vec(0, 0, 1) and p.mass == 2 and p.lifetime == 5 and p.age == 0)
    local extra = a:add_point { at = vec(0, 0.1, 0), name = "extra" }
    assert(a.extra == extra and #a.points == 3)
    a:remove_point(extra) assert(not extra.alive and #a.points == 2))") == "");
  CHECK_THAT(failure(two_links + "a.tail.mass = 1 a.mass = 0.5"),
             Contains("at least that of its points, 1 kg, got 0.5"));
  CHECK_THAT(failure(two_links + "a.head.position = vec(0, 0, 0)"), Contains("moves with its body"));
  CHECK_THAT(failure(two_links + "b:remove_point(a.head)"), Contains("is no point of body 'b'"));
}

TEST_CASE("a removed thing tells its story") {
  CHECK(failure("local p = scene:particle { name = 'spark' }\np:remove()\nassert(not p.alive)\np.mass = 2") ==
        "scene.lua:4: particle 'spark' was removed at 0 s by scene.lua:2");
  CHECK_THAT(failure(two_links + "local head = a.head a:remove() scene:nail(head)"),
             Contains("was removed at 0 s by scene.lua:6"));
  CHECK_THAT(failure(two_links + "a:remove() local x = a.position"), Contains("body 'a' was removed"));
  CHECK_THAT(failure(two_links + "a:remove() local x = a.data"), Contains("body 'a' was removed"));
}

TEST_CASE("ties are made, read and changed") {
  CHECK(failure(two_links + R"(
    local h = scene:hinge(a.tail, b.head, { color = "#fff", name = "elbow" })
    local n = scene:nail(a.head, { time_constant = 0.2 })
    local f = scene:follow(b.tail, function(t) return vec(2, t, 0) end, { max_force = 100, time_constant = 0.1 })
    local p = scene:particle { at = vec(0, 2, 0) }
    local r, s = scene:rod(p, vec(0, 3, 0)), scene:rod(vec(1, 2, 0), p, 1)
    assert(h.name == "elbow" and n.at == vec(0, 0, 0) and n.point == a.head and r.length == 1 and r.b == nil)
    scene:on("step", function(dt)
      if scene.time == 0 or not n.enabled then return end
      assert(h:force(a):length() > 0 and (h:force(a) + h:force(b)):length() < 1e-9 * h:force(a):length())
      assert(n.force:length() > 0 and f.force:length() <= 100 * (1 + 1e-9) and type(r.force) == "number")
      f.max_force = 50 n.enabled = false r.length = 1.5 r.at = vec(0, 3.5, 0) f.target = vec(2, 0, 0)
      assert(not n.enabled and r.length == 1.5)
    end)
    s:remove() assert(not s.alive))") == "");
  CHECK_THAT(failure("scene:rod(vec(0, 0, 0), vec(1, 0, 0))"), Contains("one end must be a point"));
  CHECK_THAT(failure("local p = scene:particle() scene:follow(p, 3)"),
             Contains("must be a vec [m], a function of time or a hand, got a number"));
  CHECK_THAT(failure("local p = scene:particle()\nscene:follow(p, function(t)\nreturn t end)"),
             StartsWith("scene.lua:2: follow: target: what the function returns must be a vec [m], got a number"));
  CHECK_THAT(failure("local p = scene:particle() scene:follow(p, function(t)\nreturn nil + 1 end)"),
             StartsWith("scene.lua:2: attempt to perform arithmetic on a nil value"));
  CHECK_THAT(failure("local p = scene:particle() p:cut()"), Contains("is no hinge"));
}

TEST_CASE("groups hold any things") {
  CHECK(failure(two_links + R"(
    local g = scene:group "arm"
    local h = scene:hinge(a.tail, b.head)
    assert(g:add(a, h, b) == g and #g == 3 and scene:find "arm" == g)
    local lower, upper = g:bounds() assert(lower == vec(0, 0, 0) and upper == vec(2, 0, 0))
    assert(g.mass == 3 and g.momentum == vec(0, 0, 0) and #g:clusters(2) == 1 and #g:clusters(0.1) == 2)
    local n = 0
    for thing in g:each() do n = n + 1 if thing == a then b:remove() end end
    assert(n == 1 and #g == 1, n))") == "");
  CHECK(failure(two_links +
                "local g = scene:group 'g' g:add(a) g:add(b) local h = scene:hinge(a.tail, b.head) g:cut_hinges() "
                "assert(not h.alive and #scene.hinges == 0) g:remove(a) assert(#g == 1)") == "");
  CHECK_THAT(failure("scene:group('g'):add(3)"),
             Contains("group: add: argument 1 must be a thing of the scene, got a number"));
}

TEST_CASE("a particle in a hinge answers for the hinge") {
  CHECK(failure(two_links + R"(
    local p = scene:particle { at = vec(0, 0, 0), mass = 0.5 }
    local h = scene:hinge(a.head, p)
    assert(p.is_hinge and #p.points == 2 and p.mass == 0.5 and #scene.particles == #scene.bodies * 2 - 1 + 1)
    h:cut(a) assert(not h.alive and not p.is_hinge))") == "");
}
