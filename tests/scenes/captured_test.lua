--- What a law reads from outside, where the scene changes it in the middle of a run.

local function speed(setup, law)
  local scene = open_text("scene.gravity = vec(0, 0, 0)\n" .. setup .. [[
    local p = scene:particle { mass = 2, name = "p" }
    scene:field(scene, force.point { force = function(p) return ]] .. law .. " end })")
  scene:advance(1)
  return scene:find("p").velocity, scene
end

test("a local that an event switches on and off acts from then on and no longer", function()
  local v = speed([[
    local boost = 0
    scene:at(0.5, function() boost = 100 end)
    scene:at(0.75, function() boost = 0 end)
  ]], "vec(boost, 0, 0)")
  expect(v.x):near(100 * 0.25 / 2, 1e-9)
end)

test("so do a global, a value in a table, a vec, and what another function reads", function()
  local v, scene = speed([[
    gust = 0
    local wind, deep = { now = vec(0, 0, 0) }, { inside = { strength = 0 } }
    local function strength() return deep.inside.strength end
    scene:at(0.25, function() wind.now = vec(1, 0, 0) end)
    scene:at(0.5, function() deep.inside.strength = 2 end)
    scene:at(0.75, function() gust = 3 end)
  ]], "wind.now + vec(0, strength(), gust)")
  expect((v - vec(0.75, 1, 0.75) / 2):length()):below(1e-9)
  expect(#scene.log):equal(0)
end)

test("a law that reads what changes in each step follows it, and is told to be slow once", function()
  local v, scene = speed([[
    local steps = 0
    scene:on("step", function() steps = steps + 1 end)
  ]], "vec(steps, 0, 0)")
  expect(v.x):near(0.5 * 240 * 241 / 240 / 2, 1e-9)
  local told = 0
  for _, line in ipairs(scene.log) do
    if line.text:find("one of its parameters", 1, true) then told = told + 1 end
  end
  expect(told):equal(1)
end)

test("a global that the scene changes in each step does not make a law slow that does not read it", function()
  local v, scene = speed([[
    steps = 0
    scene:on("step", function() steps = steps + 1 end)
  ]], "vec(math.cos(0 * p.position.x), 0, 0)")
  expect(v.x):near(0.5, 1e-9)
  expect(#scene.log):equal(0)
end)

test("a law beside a large table of the game follows what it reads, wherever in it that is, and at once", function()
  for _, at in ipairs { "game.wind", "game.tiles[70][70]" } do
    local scene = open_text(([[
      scene.gravity = vec(0, 0, 0)
      local game = { wind = 1, tiles = {}, moves = 0 }
      for i = 1, 70 do game.tiles[i] = {} for j = 1, 70 do game.tiles[i][j] = 1 end end
      local p = scene:particle { mass = 1, name = "p" }
      scene:field(scene, force.point { force = function(p) return vec(%s, 0, 0) end })
      scene:on("step", function() game.moves = game.moves + 1 end)
      scene:at(0.5, function() %s = -1 end)
      scene:at(0.75, function() %s = 3 end)
    ]]):format(at, at, at))
    scene:advance(1)
    expect(scene:find("p").velocity.x):near(0.5 - 0.25 + 0.75, 1e-9)
    expect(#scene.log):equal(0)
  end
end)

test("a table that grows large while the scene runs hides nothing of what a law reads", function()
  local v, scene = speed([[
    local list = { 0 }
    scene:at(0.25, function() for i = 2, 6000 do list[i] = i end end)
    scene:at(0.5, function() list[1] = 2 end)
    scene:at(0.75, function() list[1] = 4 end)
  ]], "vec(list[1], 0, 0)")
  expect(v.x):near((0.25 * 2 + 0.25 * 4) / 2, 1e-9)
  expect(#scene.log):equal(0)
end)

test("scene.time in a law is the time of its kick, whether it is traced or called", function()
  for _, more in ipairs { "", "0 * other.mass + " } do
    local v, scene = speed("local other = scene:particle {}", "vec(" .. more .. "math.sin(9 * scene.time), 0, 0)")
    local n, h = 240, 1 / 240
    local sum = 0
    for i = 1, n - 1 do sum = sum + math.sin(9 * i * h) end
    expect(v.x):near((sum + 0.5 * math.sin(9)) * h / 2, 1e-12)
    expect(#scene.log):equal(more == "" and 0 or 1)
  end
end)

test("a potential that reads scene.time has no energy, as one that takes the time", function()
  for _, more in ipairs { "", "0 * other.mass + " } do
    local v, scene = speed("local other = scene:particle {} scene:field(scene, force.point { potential = function(p) return " ..
      more .. "scene.time * p.position.x end })", "vec(0, 0, 0)")
    expect(scene.energy.potential):equal(0)
    expect(v.x):near(-0.25, 1e-4)
    expect(scene.error.worst_energy):below(1e-4)
  end
end)

test("a law that looks up in a table what differs from particle to particle, or with the time, is called, and told", function()
  local scene = open_text [[
    scene.gravity = vec(0, 0, 0)
    local strength, thrust = { [7] = 5 }, { [1] = 3 }
    local grains = scene:family("grains", { radius = 0.1, attributes = { kind = 0 } })
    local rockets = scene:family("rockets", { radius = 0.1 })
    scene:particle { family = rockets, mass = 1, name = "rocket" }
    for i = 1, 40 do scene:particle { family = grains, mass = 1, at = vec(i, 0, 0), kind = i == 20 and 7 or 3, name = "grain " .. i } end
    scene:field(grains, force.point { force = function(p) return vec(strength[p.kind] or 0, 0, 0) end })
    scene:field(rockets, force.point { force = function(p, own, t) return vec(thrust[math.floor(t)] or 0, 0, 0) end })
    local list = { 1, 2 }
    scene:field(rockets, force.point { force = function(p)
      local sum = 0
      for i = 1, 3 do sum = sum + (list[i] or 0) end
      return vec(0, sum, 0)
    end })
  ]]
  scene:advance(2)
  expect(scene:find("grain 20").velocity.x):near(10, 1e-9)
  expect(scene:find("grain 21").velocity.x):near(0, 1e-9)
  expect(scene:find("rocket").velocity.x):near(3, 0.02)
  expect(scene:find("rocket").velocity.y):near(6, 1e-9)
  expect(#scene.log):equal(2)
  expect((scene.log[1].text:find("a table is read at a value that differs from pair to pair", 1, true))):above(0)
end)
