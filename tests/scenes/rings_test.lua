test("rings: members are of different bodies and coincide; their data are their own, the ring's are shared", function()
  local rings = open("scenes/rings.lua")
  rings:advance(2)
  local members = { hub = 3, upper = 2, left = 2, right = 3 }
  for name, count in pairs(members) do
    local hinge = rings:find(name)
    expect(#hinge.points):equal(count)
    local mass, bodies = 0, {}
    for _, point in ipairs(hinge.points) do
      expect(point.particle):equal(hinge)
      expect((point.position - hinge.position):length()):below(1e-9)
      expect(bodies[point.body] == nil):is_true()
      bodies[point.body] = true
      mass = mass + point.mass
    end
    expect(hinge.mass):near(mass, 1e-15)
  end
end)

test("rings: each member is drawn as a line, an arrow, a dot and a text, each ring as a text", function()
  local rings = open("scenes/rings.lua")
  rings:step()
  expect(rings.drawn):equal(4 * 10 + 4 + 1)
  rings:find("right"):cut()
  rings:step()
  expect(rings.drawn):equal(4 * 7 + 3 + 1)
end)
