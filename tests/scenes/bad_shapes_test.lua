-- Shapes as nobody should give them: what cannot be is told with its line, what can be behaves.
local wrong = {
  ["shape.ball(1e-13)"] = "ball: A ball's radius is 1e-13 m; it must be 1e-12 m … 1e12 m.",
  ["shape.box(1, 0, 1)"] = "box: y must be > 0 m, got 0",
  ["shape.box { size = vec(0 / 0, 1, 1) }"] = "box: size must be a finite vec [m], got vec(NaN, 1, 1)",
  ["shape.cylinder { radius = 1, length = 1e-200 }"] = "cylinder: Half a cylinder's length is 5e-201 m",
  ["shape.capsule { radius = 1, length = -1 }"] = "capsule: length must be > 0 m, got -1",
  ["shape.hull { points = { vec(0, 0, 0), vec(1, 0, 0), vec(0, 1, 0), vec(1, 1, 1e-14) } }"] = "lie in a plane as good as",
  ["shape.hull { points = { vec(0, 0, 0), vec(1, 0, 0), vec(2, 0, 0), vec(3, 0, 0) } }"] = "lie in a plane as good as",
  ["shape.hull { points = { vec(0, 0, 0), vec(0, 0, 0), vec(0, 0, 0), vec(0, 0, 0) } }"] = "are within 0 m of each other",
  ["shape.hull { points = { vec(0, 0, 0), vec(1, 0, 0), vec(0, 1, 0), vec(0 / 0, 1, 0) } }"] = "hull: point 4 must be a finite vec",
  ["shape.mesh { vertices = { vec(0, 0, 0), vec(1, 0, 0), vec(2, 0, 0) }, faces = { { 1, 2, 3 } } }"] = "no triangles with an area",
  ["shape.mesh { vertices = { vec(0, 0, 0), vec(1, 0, 0), vec(0, 0, 1) }, faces = {} }"] = "no triangles with an area",
  ["shape.mesh { vertices = { vec(0, 0, 0), vec(1, 0, 0), vec(0, 0, 1 / 0) }, faces = { { 1, 2, 3 } } }"] = "mesh: vertex 3 must be a finite vec",
  ["scene:ball { radius = 1, friction = -1 }"] = "ball: friction must be >= 0, got -1",
  ["scene:ball { radius = 1, friction = 1 / 0 }"] = "ball: friction must be a finite number, got infinity",
  ["scene:ball { radius = 1, friction = 1e300 }"] = "friction must be at most 1e100, got 1e+300",
  ["scene:ball { radius = 1, restitution = 2 }"] = "ball: restitution must be from 0 to 1, got 2",
  ["scene:ball { radius = 1 }.friction = 1 / 0"] = "friction must be a finite number, got infinity",
  ["scene:ball { radius = 1, rolling = 1e300 }"] = "rolling must be at most 1e12 m, got 1e+300",
  ["scene:floor {}.spinning = 1e300"] = "spinning must be at most 1e12 m, got 1e+300",
  ["shape.hull(structure.cube {}:scale(vec(1, 1e-9, 1)))"] = "hull: A shape of 1 m is 1e-09 m thick; it must be 1e-7 of its extent or more, 1e-07 m.",
  ["shape.box { size = vec(1e-9, 2, 1) }"] = "box: A shape of 2 m is 1e-09 m thick",
  ["shape.cylinder(1, 1e-8)"] = "cylinder: A shape of 2 m is 1e-08 m thick",
  ["shape.capsule(1e-8, 10)"] = "capsule: A shape of 10 m is 2e-08 m thick",
  ["shape.polygon({ vec(0, 0, 0), vec(1, 0, 0), vec(0, 1, 0) }, 1e-9)"] = "polygon: A shape of 1 m is 1e-09 m thick",
  ["scene:body { shape = shape.box(1, 1, 1), friction = 0.1 }"] = "body: there is no 'friction' here. Each of its shapes has one: shape = shape.box { size = 1, friction = 0.8 }",
  ["scene:body { shape = shape.box(1, 1, 1), density = 10 }"] = "body: there is no 'density' here. Each of its shapes has one",
  ["scene:body { mass = 1, sensor = true }"] = "body: there is no 'sensor' here. Each of its shapes has one",
  ["scene:ground { shape = shape.box(1, 1, 1), restitution = 0.1 }"] = "ground: there is no 'restitution' here. Each of its shapes has one",
  ["scene:ground { shape = shape.box(1, 1, 1), name = 'step' }"] = "ground: there is no 'name' here. Each of its shapes has one",
  ["scene:ball { radius = 1, mass = 2, density = 500 }"] = "ball: takes mass or density, not both: with a mass of 2 kg the density of 500 kg/m³ has no effect; leave one out",
  ["scene:body { shape = shape.box { size = 1, density = 500 }, mass = 2 }"] = "body: takes mass or density, not both",
  ["scene:floor { at = vec(0, 1, 0) }"] = "floor: there is no 'at' here. It has no end; height [m] says how far along its normal it lies",
  ["scene:ground { shape.box(1, 1, 1) }"] = "ground: unknown field '1'. Each value needs its name, { name = value }. Known are shape",
  ["scene:collide('a', 'b', { restitution = 2 })"] = "collide: restitution must be from 0 to 1, got 2",
  ["scene:ground { shape = shape.box(1, 1, 1), velocity = vec(1, 0, 0) }"] = "ground: there is no 'velocity' here. What stands in the world does not move",
  ["scene:ground { shape = shape.box(1, 1, 1) }.velocity = vec(1, 0, 0)"] = "collider: it has no 'velocity'. What stands in the world does not move",
}

for code, message in pairs(wrong) do
  test("bad shapes: " .. code, function()
    expect(function() open_text("\n" .. code) end):fails("text.lua:2: ")
    expect(function() open_text("\n" .. code) end):fails(message)
  end)
end

test("bad shapes: of several one of which cannot be, none is there", function()
  local scene = open_text [[
    local good, bad = shape.box(1, 1, 1), shape.box(1, 1, 1, { friction = 1e300 })
    assert(not pcall(function() scene:ground { shapes = { good, bad } } end))
    assert(not pcall(function() scene:body { shapes = { good, bad } } end))
    assert(not pcall(function() scene:collide("a", "b", { friction = 1, restitution = 2 }) end))
    assert(not pcall(function() scene:on("touched", good, print) end))
  ]]
  expect(#scene.bodies):equal(0)
  expect(#scene:inside(vec(0, 0, 0))):equal(0)
end)

test("bad shapes: with a mass, densities of several shapes are its proportions", function()
  local scene = open_text [[
    scene:body { name = "club", mass = 4, shapes = {
      shape.box { size = 1, density = 3000 }, shape.box { size = 1, density = 1000, at = vec(4, 0, 0) } } }
  ]]
  expect(scene:find("club").mass):equal(4)
  expect(scene:find("club").position):near(vec(1, 0, 0), 1e-12)
end)

test("bad shapes: what is thin for 1 m is a thing of its own at 1e-6 m", function()
  local scene = open_text [[
    scene:body { shape = shape.hull(structure.cube {}:scale(vec(1e-6, 2e-13, 1e-6))), mass = 1 }
    scene:body { shape = shape.box(1, 1e-6, 1), mass = 1, at = vec(0, 5, 0) }
  ]]
  scene:advance(0.1)
end)

test("bad shapes: a thousand balls in one place are told with the place", function()
  local scene = open_text "for i = 1, 1000 do scene:ball { radius = 0.1, at = vec(1, 2, 3) } end"
  expect(function() scene:advance(0.1) end):fails "too much touches in one place, about (1, 2, 3) m"
end)

test("bad shapes: a hundred balls in one place part slowly, and none goes faster than it is pushed", function()
  local scene = open_text [[
    scene.gravity = vec(0, 0, 0)
    for i = 1, 100 do scene:ball { radius = 0.1 } end
  ]]
  scene:advance(0.2)
  expect(scene.energy.kinetic):below(1e-9)
  local bodies = scene.bodies
  for i, ball in ipairs(bodies) do
    local nearest = math.huge
    for j, other in ipairs(bodies) do
      if i ~= j then nearest = math.min(nearest, (ball.position - other.position):length()) end
    end
    expect(nearest):above(1e-3)
    expect(nearest):below(0.2 * 1.0)
  end
  expect(scene.stats.contacts):above(100)
  scene:advance(1.0)  -- none falls asleep before
  for i, ball in ipairs(bodies) do
    for j = 1, i - 1 do expect((ball.position - bodies[j].position):length()):above(0.2 - 1e-3) end
  end
end)

test("bad shapes: ten thousand stones in one place that nothing can strike are no crowd", function()
  local scene = open_text [[
    for i = 1, 10000 do scene:ground { shape = shape.box(1, 1, 1) } end
    scene:ball { radius = 0.1, at = vec(0, 5, 0), name = "ball" }
  ]]
  scene:advance(0.1)
  expect(scene:find("ball").position.y):near(5 - 9.81 * 0.01 / 2, 1e-3)
end)

test("bad shapes: a ball of 1e-6 m and a box of 1e3 m rest in one scene", function()
  local scene = open_text [[
    scene:ground { shape = shape.box(1e3, 1e3, 1e3), at = vec(0, -500, 0) }
    scene:ball { radius = 1e-6, at = vec(0, 1e-6, 0), name = "ball" }
    scene:box { size = 1e-6, at = vec(1e-4, 0.5e-6, 0), name = "grain" }
    scene:box { size = 300, at = vec(300, 150, 0), name = "house" }
  ]]
  scene:advance(10)
  for name, height in pairs { ball = 1e-6, grain = 0.5e-6, house = 150 } do
    local body = scene:find(name)
    expect(body.position.y / height):near(1, 1e-6)
    expect(body.velocity:length()):below(1e-6 * height)
  end
  expect(scene.stats.unsolved_islands):equal(0)
  expect(scene.error.energy):below(0.02)
end)

test("bad shapes: a floor at 1e6 m bears a tower as one at 0 does, to the round-off of its height", function()
  local scene = open_text [[
    scene:floor { height = 1e6 }
    for i = 1, 5 do scene:box { size = 1, at = vec(1e6, 1e6 + i - 0.5, 0), name = i == 5 and "top" or nil } end
  ]]
  scene:advance(10)
  expect(scene:find("top").position):near(vec(1e6, 1e6 + 4.5, 0), 1e-7)
  expect(scene.stats.unsolved_islands):equal(0)
  expect(scene.stats.asleep):equal(5)
end)

test("bad shapes: a mesh with holes lets through what fits, and bears the rest", function()
  local scene = open_text [[
    local v, f = {}, {}
    for i = 0, 10 do for j = 0, 10 do v[#v + 1] = vec(i, 0, j) end end
    for i = 0, 9 do for j = 0, 9 do
      local a = i * 11 + j + 1
      if i ~= 4 or j ~= 4 then f[#f + 1] = { a, a + 1, a + 12, a + 11 } end
    end end
    scene:ground { shape = shape.mesh { vertices = v, faces = f } }
    scene:ball { radius = 0.4, at = vec(4.5, 1, 4.5), name = "small" }
    scene:ball { radius = 0.8, at = vec(4.5, 3, 4.5), name = "large" }
    scene:box { size = 0.5, at = vec(2.2, 1, 2.3), name = "box" }
  ]]
  scene:advance(2)
  expect(scene:find("small").position.y):below(-10)
  expect(scene:find("large").position.y):near(math.sqrt(0.8 ^ 2 - 0.5 ^ 2), 1e-3)
  expect(scene:find("box").position.y):near(0.25, 1e-4)
end)

test("bad shapes: a body that is held and given a velocity stays, and its blow is in the ledger", function()
  local scene = open_text [[
    local post = scene:body { shape = shape.box(1, 1, 1), points = { c = vec(0, 0, 0) }, velocity = vec(3, 0, 0), spin = vec(0, 1, 0), name = "post" }
    scene:nail(post.c) scene:orient(post)
    scene:ball { radius = 0.2, at = vec(0, 0.7, 0), name = "ball" }
  ]]
  scene:advance(2)
  expect(scene:find("post").position:length()):below(1e-12)
  expect(scene:find("ball").position.y):near(0.7, 1e-6)
  expect(scene.error.energy):below(1e-6)
end)

test("bad shapes: a friction of 1e100 holds a box where gravity leans", function()
  local scene = open_text [[
    scene:floor { friction = 1e100 }
    scene:box { size = 1, at = vec(0, 0.5, 0), friction = 1e100, name = "box" }
    scene.gravity = vec(8, -10, 0)
  ]]
  scene:advance(1)
  expect(scene:find("box").position):near(vec(0, 0.5, 0), 1e-6)
end)
