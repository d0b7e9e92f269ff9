test("wind: a particle comes to the speed of the air", function()
  local scene = open_text [[
    scene.gravity = vec(0, 0, 0)
    leaf = scene:particle { mass = 0.1, name = "leaf" }
    scene:behave(leaf, require "wind", { velocity = vec(2, 0, 0), drag = 0.5 })
  ]]
  scene:advance(0.2)
  expect(scene:find("leaf").velocity.x):near(2 * (1 - math.exp(-1)), 0.02)
  scene:advance(3)
  expect(scene:find("leaf").velocity.x):near(2, 1e-5)
end)

test("heater: gives its power, and stops at its temperature", function()
  local scene = open_text [[
    scene.gravity = vec(0, 0, 0)
    local gas = scene:group "gas"
    for i = 1, 30 do gas:add(scene:particle { at = vec(i, 0, 0) }) end
    scene:behave(gas, require "heater", { power = 4, temperature = 0.2 })
    scene:probe("temperature", function() return gas.temperature end)
  ]]
  scene:advance(1)
  expect(scene:read "temperature"):near(2 * 4 / 87, 1e-3)
  scene:advance(6)
  expect(scene:read "temperature"):near(0.2, 1e-3)
end)

test("grips: hold what they hold, move it apart, and let go", function()
  local scene = open_text [[
    scene.gravity = vec(0, 0, 0)
    local a, b = scene:particle { name = "a" }, scene:particle { at = vec(1, 0, 0), name = "b" }
    local hold = scene:behave(scene, require "grips", { left = { a }, right = { b }, way = 0.5, time = 1 })
    scene:at(2, function() hold:cancel() end)
  ]]
  scene:advance(1.5)
  expect(scene:find("a").position.x):near(-0.5, 1e-9)
  expect(scene:find("b").position.x):near(1.5, 1e-9)
  scene:find("a"):kick(vec(0, 1, 0))
  scene:advance(2.5)
  scene:find("a"):kick(vec(0, 1, 0))
  scene:advance(3)
  expect(scene:find("a").velocity.y):near(1, 1e-9)
end)

test("gait: motors swing to and fro", function()
  local scene = open_text [[
    scene.gravity = vec(0, 0, 0)
    local leg = scene:body { mass = 1, inertia = vec(1, 1, 1), points = { hip = vec(0, 0, 0), foot = vec(0, -1, 0) } }
    scene:nail(leg.hip)
    local motor = scene:motor(leg, { axis = vec(0, 0, 1), speed = 0 })
    scene:behave(leg, require "gait", { motors = { { motor, swing = 0.5, phase = 0 } }, frequency = 1 })
    scene:probe("foot", function() return leg.foot.position.x end)
  ]]
  scene:advance(0.25)
  expect(scene:read "foot"):near(math.sin(0.5), 0.01)
  scene:advance(0.5)
  expect(scene:read "foot"):near(-math.sin(0.5), 0.02)
end)

test("puppeteer: strings are pulled in turn, and given back", function()
  local scene = open_text [[
    local a = scene:particle { at = vec(0, 0, 0) }
    local line = scene:string({ a, vec(0, 1, 0) }, { time_constant = 0.02 })
    local pull = scene:behave(a, require "puppeteer", { strings = { line }, lift = 0.3, tempo = 0.5 })
    scene:at(2.6, function() pull:cancel() end)
    scene:probe("height", function() return a.position.y end)
  ]]
  local high = 0
  for _ = 1, 480 do
    scene:step()
    high = math.max(high, scene:read "height")
  end
  expect(high):near(0.3, 0.03)
  scene:advance(3)
  expect(scene:read "height"):near(0, 0.02)
end)

test("a behaviour starts, steps and stops with its target", function()
  local scene = open_text [[
    local said = ""
    local p = scene:particle { name = "p" }
    local sub = scene:behave(p, {
      start = function(self) said = said .. "start " assert(self.target == p and self.options.x == 3) end,
      step = function(self, dt) assert(dt == scene.step) self.count = (self.count or 0) + 1 end,
      stop = function(self) scene:result("x", said .. "stop " .. self.count) end,
    }, { x = 3 })
    scene:at(5.5 / 240, function() p:remove() end)
  ]]
  scene:advance(0.1)
  expect(scene:result "x"):equal "start stop 6"
  expect(function() open_text "scene:behave(scene, {})" end):fails "behave: the behaviour has no start, step or stop"
  expect(function() open_text "scene:behave(3, {})" end):fails "behave: argument 1, the target"
  expect(function() open_text "scene:behave(scene, { step = 3 })" end):fails "behave: step must be a function"
end)

test("wind: blows on all that a structure was built of, whatever ties it", function()
  local scene = open_text [[
    scene.gravity = vec(0, 0, 0)
    local net = scene:build(structure.cube(), { as = "deformable", mass = 1, law = force.spring { stiffness = 10 } })
    local frame = scene:build(structure.cube(), { as = "articulated", mass = 1, at = vec(3, 0, 0) })
    for _, group in ipairs { net, frame } do scene:behave(group, require "wind", { velocity = vec(1, 0, 0) }) end
    scene:probe("net", function() return net.momentum.x / 0.8 end)
    scene:probe("frame", function() return frame.momentum.x / 1.2 end)
  ]]
  scene:advance(0.1)
  expect(scene:read "net"):near(0.095, 0.003)
  expect(scene:read "frame"):near(0.095, 0.003)
end)

test("heater: cools to rest, and what falls together gets no common motion from heat", function()
  local scene = open_text [[
    local gas = scene:group "gas"
    for i = 1, 26 do gas:add(scene:particle { at = vec(i, 0, 0), mass = 0.01 }) end
    scene:at(0.35, function() gas:heat(0.01) end)
    scene:at(0.5, function() scene:behave(gas, require "heater", { power = -1 }) end)
    scene:probe("drift", function() return gas.momentum.x + gas.momentum.z end)
    scene:probe("temperature", function() return gas.temperature end)
  ]]
  scene:advance(0.45)
  expect(scene:read "temperature"):near(0.02 / 75, 1e-9)
  expect(math.abs(scene:read "drift")):below(1e-14)
  scene:advance(0.3)
  expect(scene:read "temperature"):below(1e-12)
end)
