-- Scenes of structures made real.

test("buckyball: what is rigid keeps its shape, springs give and come back, rods on hinges fall in", function()
  local scene = open("scenes/buckyball.lua")
  local function size(form) return scene:read(form) end
  local whole, least = size "deformable", math.huge
  for _ = 1, 2.5 * 960 do
    scene:step()
    least = math.min(least, size "deformable")
  end
  local ball = 0.2 * 7.1242 -- m: no two atoms of the molecule are farther apart than 7.1242 Å
  for _, form in ipairs { "rigid", "panels" } do
    expect(size(form)):above(0.94 * ball)
    expect(size(form)):below(ball + 1e-6)
  end
  expect(least):below(0.95 * whole)
  expect(size "deformable"):above(0.8 * whole)
  expect(size "articulated"):below(0.5 * ball)
  expect(scene.error.worst_hinge_gap):below(1e-9)
end)

test("auxetic: rotating squares have Poisson's ratio -1 at every strain", function()
  local scene = open("scenes/auxetic.lua")
  for _ = 1, 10 do
    scene:advance(0.3)
    expect(scene:read "squares"):near(-1, 1e-9)
    expect(scene:read "trellis"):above(0.5)
  end
  expect(scene:read "squares strain"):above(0.2)
  expect(scene.error.worst_hinge_gap):below(1e-9)
end)

test("auxetic: sheets go on when all their hinges are cut", function()
  local scene = open("scenes/auxetic.lua")
  local probes = { "squares strain", "trellis strain" }
  scene:advance(0.5)
  for _, probe in ipairs(probes) do expect(scene:read(probe)):above(0.001) end
  for _, hinge in ipairs(scene.hinges) do hinge:cut() end
  scene:advance(0.1)
  expect(#scene.hinges):equal(0)
  expect(scene.time):near(0.6, 1e-9)
  for _, probe in ipairs(probes) do expect(scene:read(probe)):above(-1) end
end)

test("auxetic: the trellis follows the closed form of its bars", function()
  for _, lean in ipairs { 40, 55, 70 } do
    local scene = open("scenes/auxetic.lua", { lean = lean, strain = 0.2 })
    local across = math.tan(math.rad(lean)) -- height / length at first; each bar keeps its length
    for _ = 1, 5 do
      scene:advance(0.5)
      local along = scene:read "trellis strain"
      local height = math.sqrt(1 + across ^ 2 - (1 + along) ^ 2)
      expect(scene:read "trellis"):near((1 - height / across) / along, 1e-7)
    end
  end
end)

test("melt: the crystal stands until it is hot or its time has come, and then flows apart", function()
  for _, params in ipairs { { cells = 2, heating = 0.03, latest = 100 }, { cells = 2, heating = 0, latest = 1 } } do
    local scene = open("scenes/melt.lua", params)
    local bonds, height = scene:read "bonds", scene:read "height"
    scene:advance(0.4)
    expect(scene:read "bonds"):equal(bonds)
    expect(scene:read "height"):above(0.9 * height)
    scene:advance(3)
    expect(scene:read "bonds"):equal(0)
    if params.heating > 0 then expect(scene:read "height"):below(0.8 * height) end
  end
end)

test("melt: what was broken off before melts no more, and the event of a crystal that is gone is dropped", function()
  local half = open("scenes/melt.lua", { cells = 2, heating = 0, latest = 2, broken = 0.5 })
  local bonds = half:read "bonds"
  half:advance(1.5)
  expect(half:read "bonds"):below(0.6 * bonds)
  half:advance(1)
  expect(half:read "bonds"):equal(0)
  local gone = open("scenes/melt.lua", { cells = 1, heating = 0, latest = 2, broken = 1 })
  gone:advance(2.5)
  local dropped = {}
  for _, line in ipairs(gone.log) do
    if line.kind == "dropped" then dropped[#dropped + 1] = line.text end
  end
  expect(#dropped):equal(1)
  expect(dropped[1]:find("melt.lua", 1, true) ~= nil):is_true()
end)

test("molecules and polyhedra in every form keep momentum", function()
  for _, form in ipairs { "rigid", "articulated", "panels" } do
    local scene = open_text(([[
      scene.gravity = vec(0, 0, 0)
      scene:build(structure.icosahedron(), { as = %q, mass = 3, velocity = vec(1, 2, 3) }).bodies[1]:kick(vec(0, 1, 0))
    ]]):format(form))
    scene:advance(1)
    expect(scene.momentum):near(vec(3, 7, 9), 1e-11)
    expect(scene.error.worst_hinge_gap):below(1e-9)
  end
end)

test("a molecule joined with a shape is a shape; a lattice of loose ends alone is refused", function()
  open_text [[
    local both = structure.molecule("water.xyz"):join(structure.cube())
    assert(#scene:build(both, { as = "rigid" }).particles == #both.vertices)
  ]]
  expect(function() open_text [[structure.lattice { kind = "honeycomb" }]] end):fails("lattice: so few cells leave only loose ends")
end)

test("cutting hinges and freezing reach what is in groups of a group", function()
  local scene = open_text [[
    scene.gravity = vec(0, 0, 0)
    local function box(x, y, hinge) return scene:box { size = 1, at = vec(x, y, 0), points = { h = vec(hinge, 0, 0) } } end
    local a, b, c, d = box(0, 0, 0.5), box(1, 0, -0.5), box(0, 9, 0.5), box(1, 9, -0.5)
    scene:hinge(a.h, b.h)
    local of_bodies = scene:group("outer"):add(scene:group("inner"):add(a, b))
    local of_hinge = scene:group("outer of a hinge"):add(scene:group("inner of a hinge"):add(scene:hinge(c.h, d.h)))
    scene:at(0.1, function() of_bodies:cut_hinges() scene:result("after bodies", #scene.hinges) end)
    scene:at(0.2, function() of_hinge:cut_hinges() scene:result("after hinge", #scene.hinges) end)
    scene:at(0.3, function() scene:freeze(of_bodies) scene:result("bodies", #scene.bodies) end)
  ]]
  scene:advance(0.4)
  expect(scene:result "after bodies"):equal(1)
  expect(scene:result "after hinge"):equal(0)
  expect(scene:result "bodies"):equal(3)
end)
