-- What touches beside hinges and motors, and what rests: hard cases.
test("a motor that meets a wall presses with its torque, and gives no more than its power", function()
  for _, torque in ipairs { 1, 40, 1000 } do
    for _, rate in ipairs { 60, 240 } do
      local scene = open_text(("local torque = %d scene.step = 1 / %d"):format(torque, rate) .. [[

        scene.gravity = vec(0, 0, 0)
        scene:ground { shape = shape.box(0.5, 1, 1), at = vec(0.9, 1.05, 0) }
        local arm = scene:body { shape = shape.box(1, 0.1, 0.1, { at = vec(0.5, 0, 0) }), points = { root = vec(0, 0, 0) }, name = "arm" }
        local post = scene:body { mass = 1, inertia = vec(1, 1, 1), points = { top = vec(0, 0, 0) } }
        scene:nail(post.top) scene:orient(post)
        scene:hinge(arm.root, post.top, { axis = vec(0, 0, 1) })
        scene:motor(arm, post, { axis = vec(0, 0, 1), speed = 3, max_torque = torque })
      ]])
      scene:advance(3)
      local arm, moment = scene:find "arm", 0
      for _, contact in ipairs(arm.contacts) do moment = moment + contact.at:cross(contact.force).z end
      expect(moment / -torque):near(1, 1e-6)
      expect(arm.spin:length()):below(1e-6)
      expect(scene.ledger.motor):below(15.1 + 3 * torque * 2 / rate) -- ½ I ω² and two steps of its power
      expect(scene.stats.unsolved_islands):equal(0)
    end
  end
end)

test("limbs on hinges beside each other fly on: nothing presses across a gap that hinges hold open", function()
  local scene = open_text [[
    scene.gravity = vec(0, 0, 0)
    local at, v = vec(0, 2, 0), vec(10, 0, 0)
    local torso = scene:body { shape = shape.ball { radius = 0.15, at = vec(0, 0.2, 0) }, at = at, velocity = v,
      spin = vec(3, 0.9, 1.5), points = { a = vec(0, 0, 0.1), b = vec(0, 0, -0.1) } }
    for name, z in pairs { a = 0.1, b = -0.1 } do
      local leg = scene:body { shape = shape.capsule { radius = 0.075, from = vec(0, 0, z), to = vec(0, -0.4, z * 1.2) }, at = at,
        velocity = v, spin = vec(0, 0, 40 * z), points = { root = vec(0, 0, z) } }
      scene:hinge(torso[name], leg.root)
    end
  ]]
  scene:advance(0.01)
  local start = scene.energy.total
  scene:advance(0.5)
  expect(scene.energy.total):below(start * (1 + 1e-9))
  expect(scene.error.energy):below(1e-9)
  expect(scene.stats.unsolved_islands):equal(0)
end)

test("a ball between two walls of one body is pinched by neither until it meets it", function()
  local scene = open_text [[
    scene.gravity, scene.step = vec(0, 0, 0), 1 / 60
    local walls = {}
    for i, side in ipairs { 1, -1 } do walls[i] = shape.box(0.03, 0.5, 0.5, { at = vec(0.25 * side, 0, 0) }) end
    scene:body { shapes = walls, mass = 20 }
    scene:ball { radius = 0.17, mass = 15, velocity = vec(0, 10, 0), name = "ball" }
  ]]
  scene:advance(1)
  expect(scene:find("ball").velocity):near(vec(0, 10, 0), 1e-12)
end)

test("boxes that touch sideways in a pyramid stay, and the energy error of what rests is small", function()
  local scene = open_text [[
    scene:floor {}
    for row = 1, 10 do
      for i = 1, 11 - row do scene:box { size = 1, mass = 1, at = vec(i + 0.5 * row, row - 0.5, 0), name = "b" .. row .. "_" .. i } end
    end
  ]]
  scene:advance(1)
  local settled = scene:find("b10_1").position
  expect(settled):near(vec(6, 9.5, 0), 5e-6) -- once, as loads find their ways
  scene:advance(2)
  expect(scene:find("b10_1").position):near(settled, 1e-8)
  expect(scene.error.penetration):below(1e-6)
  expect(scene.error.energy):below(1e-3)
  expect(scene.stats.unsolved_islands):equal(0)
end)

test("in the cradle two balls fly off where two come, and the energy stays", function()
  local cradle = open("scenes/cradle.lua", { raised = 2 })
  cradle:advance(1)
  expect(cradle:read "first"):near(0, 0.01)
  expect(cradle:read "last"):near(0.6, 0.01)
  cradle:advance(20)
  expect(cradle.error.energy):below(1e-3)
end)

test("a marble with friction against rolling comes to rest", function()
  local scene = open_text [[
    scene:floor { rolling = 0.02 }
    scene:ball { radius = 0.2, at = vec(0, 0.2, 0), velocity = vec(1, 0, 0), spin = vec(0, 0, -5), name = "marble" }
  ]]
  scene:advance(3)
  expect(scene:find("marble").velocity:length()):below(1e-8)
  expect(scene:find("marble").position.x):near(0.5 / (5 / 7 * 9.81 * 0.02 / 0.2), 1e-2)
end)

test("boxes of up to three million times a link's mass fall on a chain: its hinges hold, and no energy comes from nowhere", function()
  for _, search in ipairs { "auto", "exact", "fast" } do
    for _, density in ipairs { 10, 1e3, 1e5 } do
      local scene = open_text(("local density = %g\n"):format(density) .. [[
        scene:floor {}
        chain = {}
        for i = 1, 12 do
          chain[i] = scene:body { shape = shape.box(0.05, 0.012, 0.012, { density = 1 }), at = vec(0.05 * i - 0.3, 0.3, 0),
            points = { a = vec(-0.025, 0, 0), b = vec(0.025, 0, 0) } }
          if i > 1 then scene:hinge(chain[i - 1].b, chain[i].a) end
        end
        for i = 1, 6 do
          scene:body { shape = shape.box(0.06, 0.06, 0.06, { density = density }), at = vec(0.07 * i - 0.24, 0.6 + 0.08 * i, 0.005 * i) }
        end
        scene.contact = "]] .. search .. '"')
      local open = 0
      while scene.time < 1 do
        scene:advance(1 / 240)
        for i = 2, 12 do open = math.max(open, (scene.bodies[i - 1].b.position - scene.bodies[i].a.position):length()) end
      end
      expect(open):below(1e-12)
      expect(scene.error.worst_energy):below(1e-3)
    end
  end
end)

test("things on hinges that turn and meet keep the angular momentum of all", function()
  for _, rate in ipairs { 60, 240 } do
    local scene = open_text(("scene.step = 1 / %d"):format(rate) .. [[

      scene.gravity = vec(0, 0, 0)
      local box = shape.box(0.4, 0.2, 0.3)
      local one = scene:body { shape = box, spin = vec(3, 5, 7), velocity = vec(1, 0, 0), points = { tip = vec(0.25, 0, 0) } }
      local two = scene:body { shape = box, at = vec(0.5, 0, 0), spin = vec(-2, 6, 1), points = { tip = vec(-0.25, 0, 0) } }
      scene:hinge(one.tip, two.tip)
      scene:body { shape = box, at = vec(1.2, 0.05, 0.02), velocity = vec(-3, 0, 0) }
    ]])
    scene:advance(1 / rate)
    local start, met = scene.angular_momentum, 0
    while scene.time < 0.5 do
      scene:advance(1 / rate)
      met = met + scene.stats.contacts
    end
    expect(met):above(0)
    expect((scene.angular_momentum - start):length()):below(1e-11 * start:length())
  end
end)

test("a paddle that is turned among balls turns as it is told, in sub-steps too", function()
  local scene = open_text [[
    scene.step = 1 / 60
    scene:floor {}
    for i = 0, 19 do scene:ball { radius = 0.1, at = vec(0.3 + 0.21 * (i % 5), 0.1, 0.21 * (i // 5) - 0.3) } end
    local paddle = scene:body { shape = shape.box(2, 0.2, 0.05), at = vec(0, 0.12, 0), points = { axle = vec(0, 0, 0) }, name = "paddle" }
    scene:nail(paddle.axle)
    scene:orient(paddle, function(t) return quat(vec(0, 1, 0), 2 * t) end)
  ]]
  local paddle, most = scene:find "paddle", 0
  for _ = 1, 90 do
    scene:advance(1 / 60)
    local wanted = quat(vec(0, 1, 0), 2 * scene.time)
    most = math.max(most, (paddle.orientation:rotate(vec(1, 0, 0)) - wanted:rotate(vec(1, 0, 0))):length())
  end
  expect(most):below(1e-12)
  expect(scene.error.worst_energy):below(1e-2)
end)

test("drops that fall on a floor keep their books to round-off, with gravity and a law between them", function()
  local scene = open_text [[
    local drops = scene:family("drops", { solid = true, restitution = 0.3, mass = 0.02, radius = 0.04 })
    scene:floor {}
    for i = 1, 40 do scene:particle { family = drops, at = vec(0.1 * i, 0.3 + 0.013 * i, 0), velocity = vec(0.3, 0, 0) } end
  ]]
  scene:advance(2)
  expect(scene.error.worst_energy):below(1e-13)
end)

--- A box that tips over an edge for a third of a second.
local function tipping(rate)
  local scene = open_text(("scene.step = 1 / %d"):format(rate) .. [[

    scene:floor { friction = 1 }
    scene:body { shape = shape.box { size = vec(0.2, 1, 0.2), friction = 1 }, at = vec(0, 0.5, 0), spin = vec(0, 0, -1.6),
      velocity = vec(0.8, 0.16, 0), points = { corner = vec(0.1, -0.5, 0) } }
  ]])
  local start = scene.bodies[1].corner.position
  scene:advance(1 / 3)
  return scene, (scene.bodies[1].corner.position - start):length()
end

test("what tips over an edge stays on it: its corner creeps in the second order of the step", function()
  local _, coarse = tipping(240)
  local _, fine = tipping(960)
  expect(coarse):below(1e-5)
  expect(coarse / fine):above(12)
end)

test("what tips over an edge turns as its equation says: in the second order of the step, and its energy stays", function()
  -- ½ I ω² + m g r sin is kept about the corner; I = m (0.2² + 1²)/3
  local angle, rate, h = math.atan(0.5, -0.1), 1.6, 1e-5 -- of the centre, by Heun's method
  local function pull(a) return -9.81 * math.sqrt(0.26) * math.cos(a) / ((0.04 + 1) / 3) end
  for _ = 1, 33333 do
    local ahead = rate - h * pull(angle)
    angle, rate = angle - h * (rate + ahead) / 2, rate - h * (pull(angle) + pull(angle - h * ahead)) / 2
  end
  local coarse, fine = tipping(240), tipping(960)
  expect(coarse.error.energy):below(1e-4)
  expect(math.abs(coarse.bodies[1].spin.z + rate)):below(1e-4)
  expect(math.abs(fine.bodies[1].spin.z + rate)):below(2e-5)
end)

test("a box on a turntable stays where friction holds it, and hinged links rebound with all of their energy", function()
  local scene = open_text [[
    local post = scene:body { mass = 1, inertia = vec(1, 1, 1), points = { c = vec(0, 0, 0) } }
    local table_ = scene:body { shape = shape.cylinder { radius = 2, length = 0.2, axis = vec(0, 1, 0), friction = 0.4 }, mass = 50, points = { c = vec(0, 0, 0) } }
    scene:nail(post.c) scene:orient(post)
    scene:hinge(table_.c, post.c, { axis = vec(0, 1, 0) })
    scene:motor(table_, post, { axis = vec(0, 1, 0), speed = 1 })
    scene:box { size = 0.2, mass = 1, at = vec(1, 0.2, 0), friction = 0.4, velocity = vec(0, 0, -1), spin = vec(0, 1, 0), name = "box" }
  ]]
  local box = scene:find "box"
  local function radius() return math.sqrt(box.position.x ^ 2 + box.position.z ^ 2) end
  scene:advance(0.5)
  local start = radius()
  scene:advance(2)
  expect(math.abs(radius() - start)):below(1e-6)

  local links = open_text [[
    scene.gravity = vec(0, 0, 0)
    scene:floor { friction = 0, restitution = 1 }
    local a = scene:body { shape = shape.capsule { radius = 0.05, from = vec(-0.5, 0, 0), to = vec(0.5, 0, 0), friction = 0 }, mass = 1,
      inertia = vec(0.1, 0.1, 0.1), at = vec(0, 1.2, 0), orientation = quat(vec(0, 0, 1), 0.3), velocity = vec(0, -2, 0), points = { r = vec(0.5, 0, 0) } }
    local b = scene:body { mass = 1, inertia = vec(0.1, 0.1, 0.1), at = a.r.position, velocity = vec(0, -2, 0), points = { l = vec(0, 0, 0) } }
    scene:hinge(a.r, b.l)
  ]]
  links:step()
  local whole = links.energy.kinetic
  links:advance(0.8)
  expect(links.bodies[1].velocity.y):above(0)
  expect(links.energy.kinetic / whole):near(1, 2e-3)
end)

test("ties tell what they bear of contacts, and break by it", function()
  local function hung(breaks_at)
    local scene = open_text(("scene.step = 1 / 240 local most = %g"):format(breaks_at) .. [[

      local plate = scene:box { size = vec(1, 0.1, 1), mass = 2, name = "plate", points = { c = vec(0, 0, 0) } }
      scene:orient(plate)
      scene:box { size = 0.5, mass = 20, at = vec(0, 0.3, 0) }
      local rod = scene:rod(plate.c, vec(0, 3, 0))
      rod.breaks_at = { force = most }
      scene:probe("tension", function() return rod.alive and rod.force or 0 end)
    ]])
    scene:advance(0.5)
    return scene
  end
  local scene = hung(300)
  expect(scene:read "tension"):near(22 * 9.81, 1e-6)
  expect(hung(200):find("plate").position.y):below(-0.5)
end)

test("of a blow or a push that is far too much a tie bears nothing, and each step length says so", function()
  local ties = {
    nail = "scene:nail(sign.c, bears)",
    rod = "scene:rod(sign.c, vec(1, 0, 0), bears)",
    weld = "scene:weld(sign, scene:box { size = 0.3, mass = 1e6, at = vec(0, 5, 0) }, bears)",
    hinge = "local wall = scene:box { size = 0.3, mass = 1e6, at = vec(0, 5, 0), points = { c = vec(0, -5, 0) } }"
      .. " scene:hinge(sign.c, wall.c, bears)",
    none = "",
  }
  for _, rate in ipairs { 60, 240, 777 } do
    local function struck(tie, bears)
      local scene = open_text(([[
        scene.plane, scene.gravity, scene.step = "xy", vec(0, 0, 0), 1 / %d
        local bears = { breaks_at = { force = %g } }
        local sign = scene:box { size = 0.3, at = vec(0, 0, 0), name = "sign", points = { c = vec(0, 0, 0) } }
        scene:ball { radius = 0.3, at = vec(-2, 0, 0), velocity = vec(5, 0, 0), density = 1000, name = "ball" }
        scene:on("broke", function() scene:result("broke", scene.time) end)
      ]]):format(rate, bears) .. tie)
      scene:advance(1)
      return scene
    end
    local free = struck(ties.none, 100)
    for name, tie in pairs(ties) do
      local scene = struck(tie, 100)
      expect(scene:find("sign").velocity):near(free:find("sign").velocity, 1e-9)
      expect(scene:find("ball").velocity):near(free:find("ball").velocity, 1e-9)
      if name ~= "none" then expect(scene:result("broke")):near(0.31, 0.02) end
    end
    expect(struck(ties.nail, 1e9):find("ball").velocity:length()):below(1e-9)
    local hardly = 2000 / 3 * rate * 0.74 -- N: less than what stops the ball in a step
    expect(struck(ties.nail, hardly):find("ball").velocity):near(free:find("ball").velocity, 1e-9)
    local twisted = open_text(([[
      scene.plane, scene.gravity, scene.step = "xy", vec(0, 0, 0), 1 / %d
      local wall = scene:box { size = 0.2, at = vec(0, 0, 0), mass = 1e7 }
      local sign = scene:box { size = vec(0.1, 4, 0.1), at = vec(0.15, 0, 0), mass = 5, name = "sign" }
      scene:weld(wall, sign, { breaks_at = { force = 83.3 * %d, torque = 10 } })
      scene:ball { radius = 0.2, at = vec(2, 1.8, 0), velocity = vec(-5, 0, 0), mass = 20, name = "ball" }
    ]]):format(rate, rate))
    twisted:advance(1)
    expect(twisted:find("ball").velocity.x):near(-4.4718574, 1e-3)
    local pushed = open_text(([[
      scene.gravity, scene.step = vec(0, 0, 0), 1 / %d
      local a, b = scene:box { size = 1, mass = 1, name = "a" }, scene:box { size = 1, mass = 1, at = vec(1.5, 0, 0), name = "b" }
      scene:weld(a, b, { breaks_at = { force = 10 } })
      scene:at(0.1, function() a:push(vec(-2 / scene.step, 0, 0)) end)
    ]]):format(rate))
    pushed:advance(0.2)
    expect(pushed:find("a").velocity):near(vec(-2, 0, 0), 1e-12)
    expect(pushed:find("b").velocity):near(vec(0, 0, 0), 1e-12)
  end
end)

test("a chain of brittle hinges breaks where it is struck, and the rest of it knows nothing of that", function()
  local scene = open_text [[
    scene.plane, scene.gravity = "xy", vec(0, 0, 0)
    local previous
    for i = 1, 21 do
      local bar = scene:box { size = vec(0.9, 0.2, 0.2), at = vec(i - 11, 0, 0), name = "bar" .. i, density = 1000,
                              points = { l = vec(-0.5, 0, 0), r = vec(0.5, 0, 0) } }
      if previous then scene:hinge(previous.r, bar.l, { breaks_at = { force = 100 } }) end
      previous = bar
    end
    scene:ball { radius = 0.3, at = vec(0, 2, 0), velocity = vec(0, -20, 0), density = 5000 }
  ]]
  scene:advance(0.2)
  expect(scene:find("bar11").velocity.y):below(-10)
  for _, i in ipairs { 1, 5, 9, 13, 17, 21 } do expect(scene:find("bar" .. i).velocity:length()):below(1e-9) end
  expect(scene.error.worst_energy):below(1e-9)
end)

test("a stack of five stands, of any size from 10 um to 1 km", function()
  for _, size in ipairs { 1e-5, 1e-4, 1e-2, 1, 1e3 } do
    local scene = open_text(("scene.step = 1 / 60\nscene:floor {}\nfor i = 1, 5 do scene:box { size = %g, at = vec(0, %g * (i - 0.5), 0) } end"):format(size, size))
    scene:advance(1)
    for i, box in ipairs(scene.bodies) do expect((box.position - vec(0, size * (i - 0.5), 0)):length()):below(1e-6 * size) end
  end
end)

local function thin_rods(seed, length, thickness, rest)
  return open_text(("scene.seed, scene.step = %d, 1 / 60 local length, thickness = %g, %g"):format(seed, length, thickness) .. [[

    for i = 1, 20 do
      local round, high = 2 * math.pi * math.random(), 2 * math.random() - 1
      local along = vec(math.cos(round), 0, math.sin(round)) * math.sqrt(1 - high * high) + vec(0, high, 0)
      local at = vec(0.4 * length * (math.random() - 0.5), 1 + 0.24 * length * i, 0.4 * length * (math.random() - 0.5))
      scene:capsule { radius = thickness / 2, from = at - along * (length / 2), to = at + along * (length / 2), density = 1400 }
    end
  ]] .. rest)
end

test("thin rods that fall on a floor and on each other gain no energy in long steps", function()
  local taken_back = 0
  for seed = 1, 3 do
    for _, size in ipairs { { 0.05, 0.002 }, { 0.25, 0.0018 } } do
      local scene = thin_rods(seed, size[1], size[2], "scene:floor {}")
      scene:advance(1)
      expect(scene.error.energy):below(3e-3)
      taken_back = taken_back + scene.stats.gains_taken_back
    end
  end
  expect(taken_back):above(0)
end)

test("thin rods that meet in the air keep momentum and angular momentum, whatever gains are taken from them", function()
  local energy, seeds = 0, 3
  for seed = 1, seeds do
    local scene = thin_rods(seed, 0.25, 0.0018, [[
      scene.gravity = vec(0, 0, 0)
      for _, rod in ipairs(scene.bodies) do rod.velocity = (vec(0, 2, 0) - rod.position) * 6 end
    ]])
    scene:step()
    local momentum, turning = scene.momentum, scene.angular_momentum
    scene:advance(1)
    energy = energy + scene.error.energy / seeds
    expect((scene.momentum - momentum):length()):below(1e-12)
    expect((scene.angular_momentum - turning):length()):below(1e-9 * turning:length())
  end
  expect(energy):below(0.02)
end)

test("balls that graze each other keep their energy when nothing takes any", function()
  for _, offset in ipairs { 0.1, 0.2, 0.25, 0.27 } do
    for _, from in ipairs { -1, -1.0021, -1.0062, -1.0083, -1.01 } do
      local scene = open_text(([[
        scene.gravity = vec(0, 0, 0)
        scene:ball { radius = 0.15, at = vec(%g, 0, 0), velocity = vec(3, 0, 0), mass = 1, restitution = 1, friction = 0 }
        scene:ball { radius = 0.15, at = vec(0, %g, 0), mass = 1, restitution = 1, friction = 0 }
      ]]):format(from, offset))
      scene:advance(1)
      expect(scene.energy.kinetic):near(4.5, 1e-5)
      expect(scene.bodies[2].velocity:length()):near(3 * (1 - (offset / 0.3) ^ 2) ^ 0.5, 1e-2)
    end
  end
end)

test("what a push holds on a floor at rest without gravity has no energy error", function()
  local scene = open_text [[
    scene.gravity = vec(0, 0, 0)
    scene:floor {}
    local box = scene:box { size = 0.5, at = vec(0, 0.25, 0) }
    scene:on("step", function() box:push(vec(0, -1000, 0)) end)
  ]]
  scene:advance(1)
  expect(scene.error.worst_energy):below(1e-9)
end)
