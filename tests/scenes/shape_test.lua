-- Shapes as scripts make them: options, errors, mass and inertia; closed forms are worked out here.
local function fails(code, message)
  expect(function() open_text(code) end):fails(message)
end

local function body_of(code)
  return open_text(code).bodies[1]
end

test("a ball has the mass of its volume and 2/5 m r²", function()
  local ball = body_of "scene:ball { radius = 0.5, density = 300, at = vec(1, 2, 3) }"
  local mass = 300 * 4 / 3 * math.pi * 0.125
  expect(ball.mass):near(mass, 1e-12 * mass)
  expect(ball.inertia):near(vec(1, 1, 1) * (0.4 * mass * 0.25), 1e-12 * mass)
  expect(ball.position):near(vec(1, 2, 3), 1e-15)
  expect(#ball.points):equal(0)
end)

test("a box has m/12 (b² + c²) about each axis, a cube's size may be a number", function()
  local box = body_of "scene:box { size = vec(1, 2, 3) }"
  expect(box.mass):near(6000, 1e-9)
  expect(box.inertia):near(vec(4 + 9, 1 + 9, 1 + 4) * 500, 1e-9)
  expect(body_of("scene:box { x = 1, y = 2, z = 3 }").inertia):near(box.inertia, 1e-9)
  expect(body_of("scene:box { size = 2, density = 1 }").mass):near(8, 1e-12)
end)

test("a cylinder is along y, or along its axis", function()
  local mass, r, l = math.pi * 0.04 * 0.5 * 1000, 0.2, 0.5
  local round, across = mass * r * r / 2, mass * (3 * r * r + l * l) / 12
  local upright = body_of "scene:cylinder { radius = 0.2, length = 0.5 }"
  expect(upright.mass):near(mass, 1e-10)
  expect(upright.inertia):near(vec(across, round, across), 1e-10)
  local lying = body_of "scene:cylinder { radius = 0.2, length = 0.5, axis = vec(0, 0, 3) }"
  expect(lying.inertia):near(vec(across, across, round), 1e-10)
end)

test("a capsule is a cylinder and two half balls, along y or from an end to another", function()
  local r, l, density = 0.2, 0.6, 1000
  local tube, ends = density * math.pi * r ^ 2 * l, density * 4 / 3 * math.pi * r ^ 3
  local round = tube * r ^ 2 / 2 + ends * 0.4 * r ^ 2
  local across = tube * (3 * r ^ 2 + l ^ 2) / 12 + ends * (0.4 * r ^ 2 + l ^ 2 / 4 + 3 / 8 * l * r)
  local capsule = body_of "scene:capsule { radius = 0.2, length = 0.6 }"
  expect(capsule.mass):near(tube + ends, 1e-9)
  expect(capsule.inertia):near(vec(across, round, across), 1e-10)
  local other = body_of "scene:capsule { radius = 0.2, from = vec(1, 0, 0), to = vec(1.6, 0, 0) }"
  expect(other.position):near(vec(1.3, 0, 0), 1e-12)
  expect(other.mass):near(capsule.mass, 1e-9)
end)

test("a hull of a cube is a box, a polygon a prism", function()
  local hull = body_of "scene:body { shape = shape.hull(structure.cube { edge = 2 }, { density = 10 }) }"
  expect(hull.mass):near(80, 1e-9)
  expect(hull.inertia):near(vec(1, 1, 1) * (80 * 8 / 12), 1e-8)
  local wedge = body_of [[scene:body { shape = shape.polygon({ vec(0, 0, 0), vec(3, 0, 0), vec(0, 3, 0) }, 0.5,
    { density = 2 }) }]]
  expect(wedge.mass):near(4.5, 1e-9)
  expect(wedge.position):near(vec(1, 1, 0), 1e-9)
end)

test("several shapes are one body; mass alone scales their inertia, points' masses take their place", function()
  local two = [[shapes = { shape.ball(0.5, { at = vec(-1, 0, 0) }),
    shape.ball(0.5, { at = vec(1, 0, 0), density = 3000 }) }]]
  local dumbbell = body_of("scene:body { " .. two .. " }")
  local one = 1000 * math.pi / 6
  expect(dumbbell.mass):near(4 * one, 1e-9)
  expect(dumbbell.position):near(vec(0.5, 0, 0), 1e-12)
  local light = body_of("scene:body { mass = 2, " .. two .. " }")
  expect(light.mass):near(2, 1e-12)
  expect(light.inertia):near(dumbbell.inertia * (2 / dumbbell.mass), 1e-12)
  local framed = body_of("scene:body { " .. two .. [[,
    points = { { at = vec(0, 1, 0), mass = 1 }, { at = vec(0, -1, 0), mass = 1 }, { at = vec(1, 0, 0), mass = 1 } } }]])
  expect(framed.mass):near(3, 1e-12)
end)

test("a shape is a value that tells of itself, moves and turns", function()
  local scene = open_text [[
    local one = shape.box(1, 2, 3, { density = 2, friction = 0.1, restitution = 0.9, surface_velocity = vec(1, 0, 0) })
    assert(one.kind == "box" and one.friction == 0.1 and one.restitution == 0.9 and one.density == 2)
    assert(one.volume == 6 and one.mass == 12 and one.centre == vec(0, 0, 0) and one.surface_velocity == vec(1, 0, 0))
    local other = one:move(vec(0, 1, 0)):rotate(quat(vec(0, 0, 1), math.pi / 2))
    assert((other.centre - vec(-1, 0, 0)):length() < 1e-15 and one.centre == vec(0, 0, 0))
    local plane = shape.plane()
    assert(plane.volume == nil and plane.mass == nil and plane.friction == 0.5 and plane.restitution == 0)
    assert(tostring(one) == "shape")
  ]]
  expect(#scene.bodies):equal(0)
end)

test("by position: shape.ball(r), box(x, y, z), capsule(r, l), and a table of the rest", function()
  open_text [[
    assert(shape.ball(2, { density = 1 }).mass == shape.ball { radius = 2, density = 1 }.mass)
    assert(shape.box(1, 2, 3).volume == 6 and shape.box(vec(1, 2, 3)).volume == 6 and shape.box(2).volume == 8)
    assert(shape.capsule(0.1, 1).volume == shape.capsule { radius = 0.1, length = 1 }.volume)
    assert(shape.cylinder(0.1, 1, { axis = vec(1, 0, 0) }).kind == "cylinder")
    assert(math.abs(shape.hull { points = structure.cube() }.volume - 1) < 1e-12)
  ]]
end)

test("what is wrong is told with its name and unit", function()
  fails("shape.ball(0)", "ball: radius must be > 0 m, got 0")
  fails("shape.ball { radius = 0 / 0 }", "ball: radius must be a finite number [m], got NaN")
  fails("shape.ball()", "ball: needs radius [m]")
  fails("shape.box { size = vec(1, 0, 1) }", "box: size must be > 0 m along each axis, got (1, 0, 1)")
  fails("shape.box { x = 1, y = 2 }", "box: needs z [m]")
  fails("shape.box {}", "box: needs size")
  fails("shape.box { size = 1, x = 1 }", "box: takes size, or x, y and z, not both")
  fails("shape.capsule { radius = 1, from = vec(0, 0, 0), to = vec(0, 0, 0) }", "capsule: from and to must be apart")
  fails("shape.capsule { radius = 1 }", "capsule: needs length [m]")
  fails("shape.cylinder { radius = 1, length = 1, axis = vec(0, 0, 0) }", "cylinder: axis must have a length > 0")
  fails("shape.hull { points = { vec(0, 0, 0), vec(1, 0, 0), vec(0, 1, 0), vec(1, 1, 0) } }", "hull: points: ")
  fails("shape.hull { points = { vec(0, 0, 0), 3 } }", "hull: point 2 must be a vec [m], got a number")
  fails("shape.polygon { points = { vec(0, 0, 0), vec(1, 0, 1), vec(0, 1, 0) } }", "polygon: point 2 must lie in")
  fails("shape.polygon { points = { vec(0, 0, 0), vec(1, 0, 0) } }", "polygon: points must be 3 or more, got 2")
  fails("shape.ball(1, { friction = -1 })", "ball: friction must be >= 0, got -1")
  fails("shape.ball(1, { restitution = 2 })", "ball: restitution must be from 0 to 1, got 2")
  fails("shape.ball(1, { rolling = -0.1 })", "ball: rolling must be >= 0 m, got -0.1")
  fails("shape.ball(1, { spinning = 0 / 0 })", "ball: spinning must")
  fails("shape.ball(1, { density = 0 })", "ball: density must be > 0 kg/m³, got 0")
  fails("shape.ball { raduis = 1 }", "ball: unknown field 'raduis'. Did you mean 'radius'?")
  fails("shape.sphere(1)", "shape: unknown shape 'sphere'")
  fails("shape.mesh { vertices = { vec(0, 0, 0) }, faces = { { 1, 2, 3 } } }", "mesh: face 1 must have numbers of")
  fails("shape.heights { columns = 2, rows = 2, height = { 1, 2, 3 } }", "height must have columns x rows = 4 numbers")
  fails("shape.heights { columns = 1, rows = 2, height = {} }", "heights: columns must be a whole number from 2 to 1e+07, got 1")
  fails("shape.heights { columns = 2, rows = 2, height = function() return 0 / 0 end }", "height at x = -0.5 m")
  fails("scene:ball { radius = 1, restitution = -1 }", "ball: restitution must be from 0 to 1, got -1")
  fails("scene:ball { radius = 1, shape = shape.ball(1) }", "ball: unknown field 'shape'")
  fails("scene:body { shape = 3 }", "body: shape must be a shape")
  fails("scene:body { shapes = {} }", "body: shapes must be a list of shapes, got none")
  fails("scene:body { shape = shape.plane() }", "body: shape 1 is a plane, a mesh or heights")
  fails("scene:floor { friction = -1 }", "floor: friction must be >= 0, got -1")
  fails("scene:ground {}", "ground: needs a shape")
end)

test("friction and restitution of a body are those of its shapes", function()
  local scene = open_text [[
    local box = scene:box { size = 1, friction = 0.2, name = "box" }
    assert(box.friction == 0.2 and box.restitution == 0)
    box.friction, box.restitution = 0.7, 0.5
    assert(not pcall(function() box.friction = -1 end))
    assert(not pcall(function() box.restitution = 2 end))
    local bare = scene:body { mass = 1, inertia = vec(1, 1, 1) }
    assert(bare.friction == nil and not pcall(function() bare.friction = 1 end))
  ]]
  expect(scene:find("box").friction):equal(0.7)
  expect(scene:find("box").restitution):equal(0.5)
end)

test("a box at rest on a floor tells its contacts, whose forces bear its weight", function()
  local scene = open_text [[
    scene:floor { name = "floor" }
    scene:box { size = vec(1, 0.5, 1), at = vec(0, 0.25, 0), name = "box" }
  ]]
  scene:advance(1)
  local box, sum = scene:find "box", vec(0, 0, 0)
  expect(#box.contacts):equal(4)
  for _, contact in ipairs(box.contacts) do
    expect(contact.with):equal(scene:find "floor")
    expect(contact.normal):near(vec(0, 1, 0), 1e-9)
    expect(contact.at.y):near(0, 1e-6)
    expect(math.abs(contact.depth)):below(1e-6)
    sum = sum + contact.force
  end
  expect(sum):near(vec(0, 9.81 * box.mass, 0), 2e-6 * box.mass)
  expect(box.position):near(vec(0, 0.25, 0), 1e-6)
  expect(scene.stats.contacts):equal(4)
  expect(scene.stats.unsolved_islands):equal(0)
end)

test("one body on another: each tells the other, with opposite forces", function()
  local scene = open_text [[
    scene:floor { name = "floor" }
    scene:box { size = 1, at = vec(0, 0.5, 0), name = "low" }
    scene:box { size = 0.5, at = vec(0, 1.25, 0), name = "high" }
  ]]
  scene:advance(1)
  local low, high, force = scene:find "low", scene:find "high", vec(0, 0, 0)
  for _, contact in ipairs(high.contacts) do
    expect(contact.with):equal(low)
    force = force + contact.force
  end
  expect(force):near(vec(0, 9.81 * high.mass, 0), 1e-6 * high.mass)
  for _, contact in ipairs(low.contacts) do
    if contact.with ~= scene:find "floor" then force = force + contact.force end
  end
  expect(force):near(vec(0, 0, 0), 1e-9 * high.mass)
end)

test("scene:box makes a body, and scene.box is the edges of the periodic box, of none or of one", function()
  local scene = open_text [[
    assert(scene.box == nil)
    scene:box { size = 1, name = "in open space" }
    scene.box = vec(9, 9, 9)
    scene:box { size = 2, at = vec(3, 0, 0), name = "in a box" }
    scene:block { size = 1, at = vec(-3, 0, 0), name = "by its old name" }
    assert(scene.box == vec(9, 9, 9))
  ]]
  expect(scene:find("in open space").mass):near(1000, 1e-9)
  expect(scene:find("in a box").mass):near(8000, 1e-9)
  expect(scene:find("by its old name").mass):near(1000, 1e-9)
  for code, message in pairs {
    ["scene:box { sise = 1 }"] = "box: unknown field 'sise'",
    ["scene.box { size = 1 }"] = "attempt to call a nil value (field 'box')",
    ["local f f(scene)"] = "attempt to call a nil value (local 'f')",
    ["nowhere()"] = "attempt to call a nil value (global 'nowhere')",
    ["local v = vec(1, 2, 3) v(scene)"] = "attempt to call a vec value (local 'v')",
    ["local box box(scene, { size = 1 })"] = "attempt to call a nil value",
  } do
    expect(function() open_text("local x\n" .. code) end):fails("text.lua:2: ")
    expect(function() open_text("local x\n" .. code) end):fails(message)
  end
end)
