-- Bodies with shapes that are made into others.
local function throws(code, message)
  expect(function() open_text(code) end):fails(message)
end

test("shatter: a plate at rest breaks into flush pieces of its mass, which stay where they are", function()
  local scene = open_text [[
    scene.gravity = vec(0, 0, 0)
    local plate = scene:box { size = vec(2, 0.1, 1), density = 2000, friction = 0.3, restitution = 0.1, layer = "glass" }
    scene:at(0.1, plate, function(p)
      local pieces = scene:shatter(p, { pieces = 30, seed = 7, at = vec(0.5, 0.05, 0) })
      local mass, centre, smallest, largest = 0, vec(0, 0, 0), 1 / 0, 0
      for _, piece in ipairs(pieces) do
        mass = mass + piece.mass
        centre = centre + piece.mass * piece.position
        if (piece.position - vec(0.5, 0.05, 0)):length() < 0.3 then smallest = math.min(smallest, piece.mass) end
        largest = math.max(largest, piece.mass)
        assert(piece.friction == 0.3 and piece.restitution == 0.1)
      end
      scene:result("pieces", #pieces)
      scene:result("mass", mass)
      scene:result("off centre", (centre / mass):length())
      scene:result("ratio", largest / smallest)
    end)
  ]]
  scene:advance(1)
  expect(scene:result "pieces"):equal(30)
  expect(scene:result "mass"):near(400, 1e-10)
  expect(scene:result "off centre"):below(1e-13)
  expect(scene:result "ratio"):above(10)
  expect(scene.energy.kinetic):below(1e-12)
  expect(#scene.bodies):equal(30)
end)

test("shatter: the same seed gives the same pieces, another one others", function()
  local function first(seed)
    local scene = open_text(([[
      local cube = scene:box { size = 1, at = vec(0, 5, 0) }
      scene:shatter(cube, { pieces = 9, seed = %d })
    ]]):format(seed))
    return scene.bodies[1].position
  end
  expect(first(1)):equal(first(1))
  expect(first(1) == first(2)):equal(false)
end)

test("shatter: in a handler of what it touches, with what it lay on removed in the same step", function()
  local scene = open_text [[
    scene:floor {}
    local table_top = scene:box { size = vec(2, 0.1, 2), at = vec(0, 0.55, 0), name = "top" }
    local leg = scene:box { size = vec(0.5, 0.5, 0.5), at = vec(0, 0.25, 0) }
    scene:ball { radius = 0.2, density = 8000, at = vec(0.3, 2, 0.2) }
    scene:on("touched", table_top, function(touch)
      if not table_top.alive or touch.b == leg then return end
      scene:result("hit at", touch.at.x)
      scene:shatter(table_top, { pieces = 15, at = touch.at })
      leg:remove()
    end)
  ]]
  scene:advance(2)
  expect(scene:result "hit at"):near(0.3, 1e-3)
  expect(#scene.bodies):equal(16)
  expect(scene:find "top"):equal(nil)
  for _, body in ipairs(scene.bodies) do expect(body.position.y):above(-1e-3) end
end)

test("split: a plane cuts a falling box, and both halves go on as it did", function()
  local scene = open_text [[
    local box = scene:box { size = vec(2, 1, 1), at = vec(0, 9, 0), mass = 8, spin = vec(0, 0, 1), velocity = vec(1, 0, 0) }
    scene:at(0.2, function()
      local before = scene.energy.kinetic
      local right = scene:split(box, { through = box.position, normal = box.orientation:rotate(vec(1, 0, 0)) })
      right.name, box.name = "right", "left"
      scene:result("lost", before - scene.energy.kinetic)
    end)
  ]]
  scene:advance(0.21)
  expect(scene:find("left").mass):near(4, 1e-12)
  expect(scene:find("right").mass):near(4, 1e-12)
  expect(scene:result "lost"):near(0, 1e-12)
end)

test("shatter and split: what is round breaks into hulls with its mass, which come to rest on a floor", function()
  for _, edit in ipairs { "scene:shatter(round, { pieces = 7 })", "scene:split(round, { through = round.position, normal = vec(1, 1, 0) })" } do
    for _, kind in ipairs { "ball { radius = 0.4", "capsule { radius = 0.2, length = 0.5", "cylinder { radius = 0.3, length = 0.4" } do
      local scene = open_text(([[
        scene:floor {}
        local round = scene:%s, mass = 5, at = vec(0, 0.6, 0), spin = vec(0, 2, 0) }
        scene:at(0.1, function() %s end)
      ]]):format(kind, edit))
      scene:advance(4)
      local mass = 0
      for _, body in ipairs(scene.bodies) do
        mass = mass + body.mass
        expect(body.position.y):above(0)
        expect(body.velocity:length()):below(0.5)
      end
      expect(mass):near(5, 1e-12)
      expect(scene.error.energy):below(0.02)
    end
  end
end)

test("merge, weld and freeze keep shapes: two boxes on a floor bear their weight as one", function()
  local stand = [[
    scene:floor {}
    local a = scene:box { size = 1, at = vec(0, 0.5, 0), name = "a" }
    local b = scene:box { size = 1, at = vec(1, 0.5, 0), name = "b" }
    scene:at(0.5, function() %s end)
  ]]
  for _, edit in ipairs { "scene:merge(a, b)", "scene:weld(a, b)",
    "scene:freeze(scene:group('both'):add(a, b))" } do
    local scene = open_text(stand:format(edit))
    scene:advance(1)
    local held = vec(0, 0, 0)
    for _, body in ipairs(scene.bodies) do
      expect(body.velocity:length()):below(1e-6)
      for _, contact in ipairs(body.contacts) do held = held + contact.force end
    end
    expect(held):near(vec(0, 2000 * 9.81, 0), 1)
  end
end)

test("the body and the ground of a contact may go at any time, and what lay on them falls", function()
  local scene = open_text [[
    local slab = scene:ground { shape = shape.box(4, 1, 4), at = vec(0, -0.5, 0) }
    local low = scene:box { size = 1, at = vec(0, 0.5, 0) }
    local high = scene:box { size = 1, at = vec(0, 1.5, 0), name = "high" }
    scene:at(0.5, function() low:remove() end)
    scene:at(1.5, function() slab:remove() end)
  ]]
  scene:advance(1.4)
  expect(scene:find("high").position.y):near(0.5, 1e-4)
  scene:advance(0.6)
  expect(scene:find("high").velocity.y):below(-4)
end)

test("what cannot be done is told with its line", function()
  local cube = "local cube = scene:box { size = 1, name = 'cube' }\n"
  throws(cube .. "scene:shatter(cube, {})", "text.lua:2: shatter: needs pieces")
  throws(cube .. "scene:shatter(cube, { pieces = 1 })", "text.lua:2: shatter: pieces must be from 2 to 1000, got 1")
  throws(cube .. "scene:shatter(cube, { pieces = 2.5 })", "shatter: pieces must be a whole number from 0 to 2^53, got 2.5")
  throws(cube .. "scene:shatter(cube, { pieces = -3 })", "shatter: pieces must be a whole number from 0 to 2^53, got -3")
  throws(cube .. "scene:shatter(cube, { pieces = 0/0 })", "shatter: pieces must be a finite number, got NaN")
  throws(cube .. "scene:shatter(cube, { pieces = 3, seed = 1e300 })", "shatter: seed must be a whole number")
  throws(cube .. "scene:shatter(cube, { pieces = 3, at = vec(1/0, 0, 0) })", "shatter: at must be")
  throws(cube .. "scene:shatter(cube, { piece = 3 })", "unknown field 'piece'")
  throws(cube .. "scene:split(cube, { through = vec(0, 0, 0) })", "split: a plane needs both")
  throws(cube .. "scene:split(cube, { through = vec(3, 0, 0), normal = vec(1, 0, 0) })",
    "split: the plane leaves all of body 'cube' on one side")
  throws(cube .. "scene:split(cube, { through = vec(0, 0, 0), normal = vec(0, 0, 0) })",
    "split: normal must have a length > 0")
  throws(cube .. "scene:split(cube, { through = vec(0, 0, 0), normal = 3 })", "split: normal must be a vec")
end)
