-- Structures and files as shapes.
test("build: a rigid structure that touches is solid, and rests on its face", function()
  local scene = open_text [[
    scene:floor { friction = 0.4 }
    local cube = scene:build(structure.cube { edge = 2 }, { as = "rigid", mass = 6, shape = "hull", friction = 0.2,
      at = vec(0, 1.2, 0), name = "cube" }).bodies[1]
    cube.name = "die"
  ]]
  local die = scene:find "die"
  expect(die.mass):near(6, 1e-12)
  expect(die.friction):equal(0.2)
  expect(#die.points):equal(8)
  scene:advance(2)
  expect(die.position):near(vec(0, 1, 0), 1e-4)
end)

test("build: the hull's inertia is that of the solid", function()
  local function inertia(options)
    local scene = open_text(([[
      scene:build(structure.cube { edge = 2 }, { as = "rigid", mass = 3, %s }).bodies[1].name = "cube"
    ]]):format(options))
    return scene:find("cube").inertia
  end
  expect(inertia 'shape = "hull"'):near(vec(2, 2, 2), 1e-12)
  expect(inertia 'mass_in = "solid"'):near(vec(2, 2, 2), 1e-12)
  expect(inertia 'shape = "hull", mass_in = "points"'):near(vec(6, 6, 6), 1e-12)
end)

test("build: rigid faces of a mixed build touch, each its own", function()
  local scene = open_text [[
    scene.gravity = vec(0, 0, 0)
    local two = structure.tetrahedron():join(structure.tetrahedron():move(vec(5, 0, 0)))
    local group = scene:build(two, { as = function() return "rigid" end, shape = "hull", mass = 2 })
    scene:result("bodies", #group.bodies)
    scene:result("second", group.bodies[2].mass)
  ]]
  expect(scene:result "bodies"):equal(2)
  expect(scene:result "second"):near(1, 1e-12)
end)

test("a file's mesh is ground: a ball comes to rest in the bowl", function()
  local scene = open_text [[
    scene:ground { shape = shape.mesh { file = "bowl.obj", friction = 0.8 } }
    scene:ball { radius = 0.3, at = vec(1, 1.5, 0.4), name = "ball" }
  ]]
  local ball = scene:find "ball"
  scene:advance(0.5)
  expect(ball.position.y):above(0.2)
  scene:advance(10)
  expect(vec(ball.position.x, 0, ball.position.z):length()):below(0.6)
  expect(ball.position.y):above(0.25)
end)

test("a file's mesh is a structure: closed, with a hull of its own", function()
  local scene = open_text [[
    local bowl = structure.mesh("bowl.obj", { scale = 0.1 })
    scene:result("vertices", #bowl.vertices)
    scene:result("volume", shape.hull(bowl).volume)
    scene:result("notices", #scene.log)
  ]]
  expect(scene:result "vertices"):equal(2 * (6 * 24 + 1))
  -- its hull: below a paraboloid 0.27 m deep whose rim is 0.6 m across, and the wall's ring of 0.02 m around it
  expect(scene:result "volume"):near(0.5 * math.pi * 0.09 * 0.27 + math.pi * 0.09 * 0.02, 1e-3)
  expect(scene:result "notices"):equal(0)
end)

test("what cannot be is told with its line", function()
  for code, message in pairs {
    ['structure.mesh "no.obj"'] = "mesh: there is no file '",
    ['structure.mesh "../no.obj"'] = "mesh: '../no.obj' must be a file below the scene's folder or assets/meshes",
    ['structure.mesh("bowl.obj", { scale = 0 })'] = "mesh: scale must be > 0, got 0",
    ['structure.mesh("bowl.obj", { scale = 0/0 })'] = "mesh: scale must be a finite number, got NaN",
    ['structure.mesh(3)'] = "mesh: argument 1, the file, must be",
    ['shape.mesh { file = "bowl.obj", faces = {} }'] = "mesh: takes file, or vertices and faces, not both",
    ['shape.mesh { vertices = {}, faces = {}, scale = 2 }'] = "mesh: scale is of a file",
    ['shape.mesh { file = 3 }'] = "mesh: file must be",
    ['scene:build(structure.sheet(), { as = "rigid", shape = "hull" })'] = "build: shape: rigid part 1: A hull's points lie in a plane",
    ['scene:build(structure.cube(), { as = "panels", shape = "hull" })'] = "build: with shape = \"hull\", mass_in is \"points\"",
    ['scene:build(structure.cube(), { as = "panels", shape = "hull", mass_in = "points" })'] = "shape = \"hull\" is of rigid parts; rods and plates have none",
    ['scene:build(structure.cube(), { as = "deformable", shape = "hull" })'] = "is of rigid parts, and there are none",
    ['scene:build(structure.cube(), { as = "rigid", shape = "box" })'] = "build: shape must be \"hull\", got \"box\"",
    ['scene:build(structure.cube(), { as = "rigid", friction = 1 })'] = "build: friction is of shapes, and there are none",
    ['scene:build(structure.cube(), { as = "rigid", shape = "hull", friction = -1 })'] = "build: friction must be >= 0, got -1",
    ['shape.hull(structure.sheet())'] = "A hull's points lie in a plane",
  } do
    expect(function() open_text("local x\n" .. code) end):fails("text.lua:2")
    expect(function() open_text("local x\n" .. code) end):fails(message)
  end
end)

test("a hull thrown onto a floor without friction goes on as fast, wherever the origin of its points is", function()
  for _, origin in ipairs { "0.13, 0.07, 0", "0.13, 0, 0", "0, 0, -0.1", "0.5, -2, 1" } do
    for _, rate in ipairs { 60, 240 } do
      local scene = open_text(("local origin = vec(%s)\nscene.step = 1 / %d"):format(origin, rate) .. [[

        scene:floor { friction = 0 }
        local points = {}
        for _, x in ipairs { 0, 1 } do
          for _, z in ipairs { -0.1, 0.1 } do table.insert(points, vec(0.4 * x, 0, z) - origin) end
          table.insert(points, vec(0, 0.2, 0.2 * x - 0.1) - origin)
        end
        local hull = scene:body { mass = 1, at = vec(0, 1, 0) + origin, velocity = vec(1, 0, 0), spin = vec(1, 2, -1),
          shape = shape.hull(points, { friction = 0 }) }
        local from = hull.position.x
        scene:probe("gone", function() return hull.position.x - from end)
      ]])
      scene:advance(3)
      expect(scene:read("gone")):near(3, 1e-9)
    end
  end
end)
