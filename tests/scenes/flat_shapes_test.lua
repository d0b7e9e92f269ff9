-- Shapes in a scene that has a plane.
local g = 9.81

test("polygons have the inertia of their outline about the normal: a triangle, a square and a hexagon", function()
  local scene = open_text [[
    scene.plane = "xy"
    local function add(name, points) scene:body { name = name, mass = 3, shape = shape.polygon(points) } end
    add("triangle", { vec(0, 0, 0), vec(3, 0, 0), vec(0, 6, 0) })
    add("square", { vec(-1, -1, 0), vec(1, -1, 0), vec(1, 1, 0), vec(-1, 1, 0) })
    local corners = {}
    for i = 1, 6 do corners[i] = vec(math.cos(i * math.pi / 3), math.sin(i * math.pi / 3), 0) end
    add("hexagon", corners)
  ]]
  local function moment(name)
    local inertia = scene:find(name).inertia
    return type(inertia) == "table" and inertia.zz or inertia.z
  end
  -- m a²/6, m 5/12 a²; of the triangle m (a² + b² + c²)/36 of its sides, and m r² to the origin of its frame
  expect(scene:find("triangle").position):near(vec(1, 2, 0), 1e-12)
  expect(moment "square"):near(3 * 4 / 6, 1e-12)
  expect(moment "hexagon"):near(3 * 5 / 12, 1e-12)
  expect(moment "triangle"):near(3 * (9 + 36 + 45) / 36 + 3 * (1 + 4), 1e-12)
end)

test("in each plane a ball and a polygon come to rest on a line, and stay in the plane", function()
  for plane, up in pairs { xy = vec(0, 1, 0), yz = vec(0, 0, 1), xz = vec(0, 0, 1) } do
    local along = plane == "yz" and vec(0, 1, 0) or vec(1, 0, 0)
    local scene = open_text(([[
      scene.plane = %q
      local up, along = vec(%g, %g, %g), vec(%g, %g, %g)
      scene.gravity = -9.81 * up
      scene:ground { shape = shape.line { -9 * along, 9 * along } }
      scene:ball { radius = 0.5, at = 0.7 * up - 2 * along, name = "ball" }
      scene:body { shape = shape.polygon { -along, along, up }, at = 0.3 * up, name = "wedge" }
    ]]):format(plane, up.x, up.y, up.z, along.x, along.y, along.z))
    scene:advance(2)
    expect(scene:find("ball").position):near(0.5 * up - 2 * along, 1e-5)
    expect(scene:find("wedge").position):near(up / 3, 1e-5)
    expect(scene.energy.kinetic):below(1e-9)
  end
end)

test("a box slides over the joints of a chain of segments as over one: v²/2µg, without a bump, however deep both are", function()
  for _, thickness in ipairs { 0.1, 1, 2, 100 } do
    for _, depth in ipairs { 1, 3 } do
      local scene = open_text(([[
        scene.plane = "xy"
        local points = {}
        for i = 0, 60 do points[i + 1] = vec(-2 + 0.37 * i, 0, 0) end
        scene:ground { shape = shape.line(points, { friction = 0.5, thickness = %g }) }
        scene:box { size = vec(1, 1, %g), at = vec(0, 0.5, 0), velocity = vec(5, 0, 0), name = "box" }
      ]]):format(thickness, depth))
      local box, highest = scene:find "box", 0
      for _ = 1, 480 do
        scene:step()
        highest = math.max(highest, box.position.y)
      end
      expect(box.position.x):near(25 / (2 * 0.5 * g), 2e-4)
      expect(highest):below(0.5 + 1e-6)
      expect(box.orientation:rotate(vec(1, 0, 0))):near(vec(1, 0, 0), 1e-6)
    end
  end
end)

test("a ball slides over a chain that bends down and up: energy is only lost", function()
  local scene = open_text [[
    scene.plane = "xy"
    scene:ground { shape = shape.line({ vec(-5, 3, 0), vec(0, 0, 0), vec(4, 0, 0), vec(8, 2, 0) }, { friction = 0 }) }
    scene:ball { radius = 0.3, at = vec(-4, 3, 0), friction = 0, name = "ball" }
  ]]
  local start = scene.energy.total
  scene:advance(3)
  expect(scene.energy.total):below(start + 1e-6)
  expect(scene:find("ball").position.y):above(0.29)
  expect(scene.error.energy):below(1e-4)
end)

test("a stack of polygons and boxes stands in a plane", function()
  local scene = open_text [[
    scene.plane = "xy"
    scene:floor {}
    for i = 0, 4 do
      scene:box { size = vec(1, 0.5, 1), at = vec(0, 0.25 + i, 0) }
      scene:body { shape = shape.polygon { vec(-0.6, 0, 0), vec(0.6, 0, 0), vec(0.4, 0.5, 0), vec(-0.4, 0.5, 0) },
        at = vec(0, 0.5 + i, 0) }
    end
  ]]
  scene:advance(3)
  for _, body in ipairs(scene.bodies) do expect(math.abs(body.position.x)):below(1e-5) end
  expect(scene.energy.kinetic):below(1e-9)
end)

test("a closed line keeps what is in it, from the front alone", function()
  local scene = open_text [[
    scene.plane = "xy"
    scene:ground { shape = shape.line({ vec(-2, 0, 0), vec(2, 0, 0), vec(2, 4, 0), vec(-2, 4, 0) }, { closed = true, restitution = 1, friction = 0 }) }
    scene:ball { radius = 0.2, at = vec(0, 2, 0), velocity = vec(7, 3, 0), restitution = 1, friction = 0, name = "ball" }
  ]]
  local ball = scene:find "ball"
  for _ = 1, 1000 do
    scene:step()
    expect(math.max(math.abs(ball.position.x), math.abs(ball.position.y - 2))):below(1.8 + 1e-3)
  end
end)

test("polygons and lines that cannot be are told", function()
  for code, message in pairs {
    ["shape.polygon { vec(0, 0, 1), vec(1, 0, 0), vec(0, 1, 0) }"] = "polygon: point 1 must lie in the plane of x and y, got z = 1 m",
    ["scene.plane = 'xz' shape.polygon { vec(0, 0, 1), vec(1, 2, 0), vec(0, 0, 0) }"] = "polygon: point 2 must lie in the plane of x and z, got y = 2 m",
    ["scene.plane = 'yz' shape.line { vec(3, 0, 1), vec(0, 2, 0) }"] = "line: point 1 must lie in the plane of y and z, got x = 3 m",
    ["shape.line { vec(0, 0, 0) }"] = "line: points must be 2 or more, got 1",
    ["shape.line({ vec(0, 0, 0), vec(1, 0, 0) }, { closed = true })"] = "line: points must be 3 or more, got 2",
    ["shape.line { vec(0, 0, 0), vec(0, 0, 0), vec(1, 0, 0) }"] = "line: points 1 and 2 are at one position",
    ["shape.line { vec(0, 0, 0), vec(0/0, 0, 0) }"] = "line: point 2 must be",
    ["shape.line({ vec(0, 0, 0), vec(1, 0, 0) }, { thickness = 0 })"] = "line: thickness must be > 0 m, got 0",
    ["shape.polygon { vec(0, 0, 0), vec(1, 0, 0), vec(2, 0, 0) }"] = "polygon: points: A hull's points lie in a plane",
    ["scene:body { shape = shape.line { vec(0, 0, 0), vec(1, 0, 0) } }"] = "which do not move; give it to scene:ground",
  } do
    expect(function() open_text(code) end):fails(message)
  end
end)

test("a line is one-sided: from left to right it bears what is above, anticlockwise it holds in", function()
  local function speed_after(points, at, velocity, closed)
    local scene = open_text(([[
      scene.gravity = vec(0, 0, 0)
      scene:ground { shape = shape.line({ %s }, { restitution = 1, closed = %s }) }
      scene:ball { radius = 0.1, at = %s, velocity = %s, name = "ball" }
    ]]):format(points, tostring(closed or false), at, velocity))
    scene:advance(1)
    return scene:find("ball").velocity.y
  end
  local right, left = "vec(0, 0, 0), vec(1, 0, 0)", "vec(1, 0, 0), vec(0, 0, 0)"
  local above, below, down, up = "vec(0.5, 0.5, 0)", "vec(0.5, -0.5, 0)", "vec(0, -1, 0)", "vec(0, 1, 0)"
  expect(speed_after(right, above, down)):near(1, 1e-9)
  expect(speed_after(right, below, up)):near(1, 1e-9)
  expect(speed_after(left, above, down)):near(-1, 1e-9)
  expect(speed_after(left, below, up)):near(-1, 1e-9)
  local round = "vec(0, 0, 0), vec(1, 0, 0), vec(1, 1, 0), vec(0, 1, 0)"
  local back = "vec(0, 0, 0), vec(0, 1, 0), vec(1, 1, 0), vec(1, 0, 0)"
  expect(speed_after(round, above, down, true)):near(1, 1e-9)
  expect(speed_after(back, above, down, true)):near(-1, 1e-9)
  expect(speed_after(back, below, up, true)):near(-1, 1e-9)
end)

local from_behind = {
  ["a ball through a line"] = { [[scene.plane = "xy"]], "shape.line { vec(-1, 0, 0), vec(1, 0, 0) }", "ball", "radius = 0.1" },
  ["a ball through a line's end"] = { [[scene.plane = "xy"]], "shape.line { vec(-1, 0, 0), vec(0.03, 0, 0) }", "ball", "radius = 0.1" },
  ["a box that turns through a line"] = { [[scene.plane = "xy"]], "shape.line { vec(-1, 0, 0), vec(1, 0, 0) }", "box", "size = vec(0.5, 0.1, 0.1), spin = vec(0, 0, 3)" },
  ["a box through triangles"] = { "", "shape.mesh { vertices = { vec(-1, 0, 1), vec(1, 0, 1), vec(1, 0, -1), vec(-1, 0, -1) }, faces = { { 1, 2, 3 }, { 1, 3, 4 } } }", "box", "size = 0.2, spin = vec(1, 2, 3)" },
}
for what, case in pairs(from_behind) do
  local before, ground, kind, size = table.unpack(case)
  local function thrown(speed, time)
    local scene = open_text(([[
      %s
      local touched = 0
      scene:result("touched", touched)
      scene:ground { shape = %s }
      scene:%s { %s, at = vec(0, -0.6, 0), velocity = vec(0, %.17g, 0), name = "thrown" }
      scene:on("touched", function()
        touched = touched + 1
        scene:result("touched", touched)
      end)
    ]]):format(before, ground, kind, size, speed))
    scene:advance(time)
    return scene, scene:find("thrown")
  end

  test(what .. " from behind flies as through air, and lands before it", function()
    local scene, body = thrown(6, 0.5)
    expect(body.position.y):near(-0.6 + 6 * 0.5 - 0.5 * 9.81 * 0.25, 1e-9)
    expect(body.velocity.y):near(6 - 9.81 * 0.5, 1e-9)
    expect(scene.ledger.push_out):equal(0)
    expect(scene:result("touched")):equal(0)
    scene:advance(3)
    if not what:find("end") then expect(body.position.y):above(0) end
  end)

  test(what .. " from behind that does not get through falls back", function()
    local scene, body = thrown(math.sqrt(2 * 9.81 * 0.58), 1)
    expect(body.position.y):near(-0.6 + math.sqrt(2 * 9.81 * 0.58) - 0.5 * 9.81, 1e-9)
    expect(scene.ledger.push_out):equal(0)
    expect(scene:result("touched")):equal(0)
  end)
end

test("what is fast comes through a line and triangles from behind, too", function()
  for _, rate in ipairs { 60, 240 } do
    for _, speed in ipairs { 7, 20, 50, 200 } do
      for _, ground in ipairs { "shape.line { vec(-1, 0, 0), vec(1, 0, 0) }", "shape.mesh { vertices = { vec(-1, 0, 1), vec(1, 0, 1), vec(0, 0, -1) }, faces = { { 1, 2, 3 } } }" } do
        local scene = open_text(([[
          scene.gravity, scene.step = vec(0, 0, 0), 1 / %d
          scene:ground { shape = %s }
          scene:ball { radius = 0.1, at = vec(0, -2, 0), velocity = vec(0, %d, 0) }
        ]]):format(rate, ground, speed))
        scene:advance(1)
        expect(scene.bodies[1].position.y):near(speed - 2, 1e-9)
        expect(scene.ledger.push_out):equal(0)
      end
    end
  end
end)
