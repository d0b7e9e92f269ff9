-- What is driven by a function of time with kinks: its velocity jumps, and no tie that does not give loses energy then.

local function scene_of(rate, driven)
  return open_text(("scene.step = 1 / %d\n"):format(rate) .. [[
    local arm = scene:body { name = "arm", mass = 2, inertia = vec(0.1, 0.2, 0.2), at = vec(0.5, 0, 0), points = { a = vec(-0.5, 0, 0), b = vec(0.5, 0, 0) } }
    local link = scene:body { name = "link", mass = 1, inertia = vec(0.05, 0.1, 0.1), at = vec(1.5, 0, 0), points = { a = vec(-0.5, 0, 0), b = vec(0.5, 0, 0) } }
    local function begin(t) return math.max(0, t - 0.51) end
    scene:hinge(arm.b, link.a)
  ]] .. driven)
end

local driven = {
  ["a point that begins to move"] = { "scene:follow(arm.a, function(t) return vec(2 * begin(t), 0, 0) end)", 2e-4 },
  ["a point that stops"] = { "scene:follow(arm.a, function(t) return vec(2 * math.min(t, 1), 0, 0) end)", 1e-3 },
  ["a point that is shaken"] = { "scene:follow(arm.a, function(t) return vec(0.3 * math.abs(math.sin(7 * t)), 0, 0) end)", 2e-2 },
  ["an arm that begins to turn"] = { "scene:nail(arm.a) scene:motor(arm, { axis = vec(0, 0, 1), angle = function(t) return 3 * begin(t) end })", 3e-3 },
  ["a link that begins to turn"] = { "scene:nail(arm.a) scene:orient(link, function(t) return quat(vec(0, 0, 1), 2 * begin(t)) end)", 2e-4 },
}
for what, case in pairs(driven) do
  test(what .. " is given what it gains", function()
    for _, rate in ipairs { 60, 240 } do
      local scene = scene_of(rate, case[1])
      scene:advance(3)
      expect(scene.error.worst_energy):below(case[2])
    end
  end)
end

test("a load that a winch begins to lift, and stops, takes m g h of it", function()
  local scene = open_text [[
    local box = scene:box { name = "box", size = 1, density = 300, at = vec(0, 0.5, 0), points = { top = vec(0, 0.5, 0) } }
    local eye = scene:particle { at = vec(0, 6, 0) }
    scene:nail(eye)
    scene:rod(box.top, eye, function(t) return 5 - math.min(1.6, math.max(0, t - 1) * 0.8) end)
  ]]
  local start = scene.energy.total
  scene:advance(4)
  expect(scene.ledger.hand):near(300 * 9.81 * 1.6, 1e-3)
  expect(scene.energy.total - start):near(scene.ledger.hand, 1e-3)
end)

test("what hangs on a point that stops at once turns on with its angular momentum about it", function()
  for _, rate in ipairs { 60, 240, 960 } do
    local scene = open_text(("scene.step = 1 / %d\n"):format(rate) .. [[
      scene.gravity = vec(0, 0, 0)
      local arm = scene:body { name = "arm", mass = 2, inertia = vec(0.1, 0.2, 0.2), at = vec(0.5, 0, 0), points = { a = vec(-0.5, 0, 0) } }
      scene:follow(arm.a, function(t) return vec(0, 2 * math.min(t, 1), 0) end)
    ]])
    scene:advance(0.5)
    local arm = scene:find "arm"
    local spin = arm.spin.z
    scene:advance(0.5)
    local reach = arm.orientation:rotate(vec(0.5, 0, 0))
    scene:advance(0.1)
    local moment = 0.2 + 2 * 0.25
    expect(arm.spin.z):near(spin + 2 * reach.x * 2 / moment, 1e-9)
  end
end)

--- A spring elsewhere, for which the scene takes sub-steps.
local elsewhere = [[
  scene.gravity, scene.step, scene.accuracy = vec(0, 0, 0), 1 / 60, 1e-4
  scene:connect(scene:particle { at = vec(60, 0, 0) }, vec(61.5, 0, 0), force.spring { stiffness = 400, length = 1 })
]]

test("what follows a function of time bears the same force where the scene takes sub-steps", function()
  local scene = open_text(elsewhere .. [[
    local z = vec(0, 0, 1)
    local function wheel(at)
      local body = scene:body { at = at, mass = 1, inertia = vec(2, 2, 2), points = { centre = vec(0, 0, 0) } }
      scene:nail(body.centre)
      scene:align(body, z, z, { angle = 0 })
      return body
    end
    local function mass(at) return scene:particle { mass = 2, at = at } end
    local follow = scene:follow(mass(vec(0, 30, 0)), function(t) return vec(1.5 * t ^ 2, 30, 0) end)
    local by_speed = scene:motor(wheel(vec(10, 0, 0)), { axis = z, speed = function(t) return 3 * t end })
    local by_angle = scene:motor(wheel(vec(12, 0, 0)), { axis = z, angle = function(t) return 1.5 * t ^ 2 end })
    local rod = scene:rod(mass(vec(20, -1, 0)), vec(20, 0, 0), function(t) return 1 + 1.5 * t ^ 2 end)
    local box = scene:box { size = 1, density = 12, at = vec(30, 0, 0) }
    local orient = scene:orient(box, function(t) return quat(z, 1.5 * t ^ 2) end)
    local string = scene:string({ mass(vec(40, -3, 0)), vec(40, 0, 0) }, { length = function(t) return 3 - 1.5 * t ^ 2 end })
    scene:probe("force", function() return follow.force.x - rod.force + string.force end)
    scene:probe("torque", function() return by_speed.torque.z + by_angle.torque.z + orient.torque.z end)
  ]])
  scene:step()
  for _ = 1, 20 do
    scene:advance(3 / 60)
    expect(scene.stats.sub_steps):above(1)
    expect(scene:read "force"):near(18, 1e-3)
    expect(scene:read "torque"):near(18, 1e-6)
  end
end)

test("the torque told of what turns a body by time is what its angular momentum gains", function()
  local turns = { "10 * t, 10", "4 * t + 3 * t ^ 2, 4 + 6 * t", "2 * math.sin(5 * t), 10 * math.cos(5 * t)" }
  local ties = { "scene:motor(wheel, { axis = z, angle = turn })", "scene:orient(wheel, function(t) return quat(z, (turn(t))) end)",
                 "scene:motor(wheel, { axis = z, speed = function(t) return select(2, turn(t)) end })" }
  for _, turn in ipairs(turns) do
    for _, tie in ipairs(ties) do
      local scene = open_text(([[
        scene.gravity, scene.step = vec(0, 0, 0), 1 / 60
        local z = vec(0, 0, 1)
        local function turn(t) return %s end
        local wheel = scene:body { mass = 1, inertia = vec(2, 2, 2), spin = select(2, turn(0)) * z }
        local tie = %s
        scene:probe("torque", function() return tie.torque.z end)
        scene:probe("spin", function() return wheel.spin.z end)
        scene:probe("spin wanted", function() return select(2, turn(scene.time)) end)
      ]]):format(turn, tie))
      scene:step()
      for _ = 1, 90 do
        local before = scene:read "spin"
        scene:step()
        expect(scene:read "torque"):near(2 * (scene:read "spin" - before) * 60, 1e-6)
        expect(scene:read "spin"):near(scene:read "spin wanted", 0.1)
      end
    end
  end
end)

test("what is drawn in takes no energy from nowhere where the scene takes sub-steps", function()
  for _, tie in ipairs { "scene:nail(box.o, vec(1, 0, 0))", "scene:limit(box.o, vec(2, 0, 0), { max = 1 })",
                         "scene:on_plane(box.o, { through = vec(0, 1, 0) })", "scene:follow(box.o, vec(1, 0, 0))",
                         "scene:join(box.o, scene:box { size = 1, at = vec(3, 0, 0), mass = 2, points = { p = vec(-0.5, 0.2, 0) } }.p)" } do
    local scene = open_text(elsewhere .. "local box = scene:box { size = vec(1, 1, 2), mass = 1, points = { o = vec(0, 0, 0) } }\n" .. tie)
    scene:advance(1.5)
    expect(scene.stats.most_sub_steps):above(1)
    expect(scene.error.worst_energy):below(5e-3)
  end
end)

test("an angle that is drawn in from its making on takes its energy from the tie alone", function()
  for _, tie in ipairs { "scene:orient(box, quat(z, 1))", "scene:align(box, vec(1, 0, 0), vec(1, 0, 0), { angle = 1 })",
                         "scene:nail(box.o) scene:align(box, z, z, { angle = 0 }) scene:motor(box, { axis = z, angle = 1 })",
                         "scene:nail(box.o) scene:align(box, z, z, { angle = 0 }) scene:limit(box, { axis = z, min = 1, max = 2 })" } do
    local scene = open_text([[
      scene.gravity, scene.step = vec(0, 0, 0), 1 / 60
      local z = vec(0, 0, 1)
      local box = scene:box { size = vec(1, 1, 2), mass = 1, points = { o = vec(0, 0, 0) } }
    ]] .. tie)
    scene:advance(2)
    expect(scene.error.worst_energy):below(1e-3)
  end
end)

test("a motor of an angle never turns harder than its torque, and comes to rest where it is to be", function()
  for _, hz in ipairs { 60, 240, 1000 } do
    for _, case in ipairs { { torque = 100, time_constant = 0.02 }, { torque = 10, time_constant = 0.1 } } do
      local scene = open_text(([[
        scene.step, scene.plane, scene.gravity = 1 / %d, "xy", vec(0, 0, 0)
        local arm = scene:box { size = 1, density = 12 } -- 2 kg m2
        local motor = scene:motor(arm, { angle = 0, max_torque = %g, time_constant = %g })
        scene:at(0.5, function() motor.angle = 1 end)
        local spin, hardest, farthest = 0, 0, 0
        scene:on("step", function(dt)
          hardest = math.max(hardest, math.abs(motor.torque.z), math.abs(2 * (arm.spin.z - spin) / dt))
          farthest = math.max(farthest, motor.turned)
          spin = arm.spin.z
          scene:result("hardest", hardest)
          scene:result("farthest", farthest)
          scene:result("turned", motor.turned)
        end)
      ]]):format(hz, case.torque, case.time_constant))
      scene:advance(4)
      expect(scene:result "hardest"):below(1.01 * case.torque)
      expect(scene:result "farthest"):below(1.6)
      expect(scene:result "turned"):near(1, 1e-6)
      expect(scene.error.energy):below(1e-3)
    end
  end
end)

test("a motor that was off, or whose wheel was turned by hand, goes on at its speed without a jerk", function()
  for _, rate in ipairs { 90, 240, 1000 } do
    local scene = open_text(([[
      scene.step, scene.gravity = 1 / %d, vec(0, 0, 0)
      local wheel = scene:box { name = "wheel", size = vec(1, 0.2, 0.2), mass = 1, points = { hub = vec(0, 0, 0) } }
      scene:nail(wheel.hub)
      local motor = scene:motor(wheel, { axis = vec(0, 0, 1), speed = 6, max_torque = 500 })
      scene:at(0.31, function() motor.enabled = false end)
      scene:at(0.62, function() motor.enabled = true end)
      scene:at(0.8, function() wheel.orientation = quat(vec(0, 0, 1), 1) end)
    ]]):format(rate))
    scene:advance(0.1)
    while scene.time < 1 do
      scene:step()
      expect(scene:find("wheel").spin.z):near(6, 1e-9)
    end
  end
end)

test("an arm whose angle stops within a step is still from the next on, whenever it stops", function()
  for phase = 0, 4 do
    local scene = open_text(([[
      scene.gravity = vec(0, 0, 0)
      local arm = scene:box { name = "arm", size = vec(1, 0.2, 0.2), mass = 1, points = { hub = vec(-0.5, 0, 0) } }
      scene:nail(arm.hub)
      scene:motor(arm, { axis = vec(0, 0, 1), angle = function(t) return -2 * math.min(t, %g) end })
    ]]):format(0.2 + phase / 1200))
    scene:advance(0.2 + 2 / 240)
    for _ = 1, 10 do
      scene:step()
      expect(math.abs(scene:find("arm").spin.z)):below(1e-9)
    end
    expect(scene.error.worst_energy):below(1e-4)
  end
end)

test("a motor of a speed comes to it as fast as its torque can, and never goes past it", function()
  for _, torque in ipairs { 20, 26, 28, 40, 53, 55, 200 } do
    local rate, inertia, wanted, spin = 100, 0.09, -3, 0
    local scene = open_text(([[
      scene.step, scene.gravity = 1 / %d, vec(0, 0, 0)
      local wheel = scene:body { name = "wheel", mass = 2, inertia = vec(0.05, 0.05, %g), points = { hub = vec(0, 0, 0) } }
      scene:nail(wheel.hub)
      local motor = scene:motor(wheel, { axis = vec(0, 0, 1), speed = -3, max_torque = %g })
      scene:at(0.1, function() motor.speed = 3 end)
    ]]):format(rate, inertia, torque))
    for i = 1, 30 do
      if i > 10 then wanted = 3 end
      local most = torque / (inertia * rate)
      spin = spin + math.max(-most, math.min(most, wanted - spin))
      scene:step()
      expect(scene:find("wheel").spin.z):near(spin, 1e-9)
    end
  end
end)

test("a string that a script pays out in each step bears as one whose length is a function of time", function()
  for _, rate in ipairs { 60, 240, 777 } do
    local scene = open_text(([[
      scene.step = 1 / %d
      local load = scene:ball { radius = 0.1, mass = 2, at = vec(0, 2, 0), points = { top = vec(0, 0, 0) } }
      rope = scene:string({ vec(0, 4, 0), load.top }, { length = 2, name = "rope" })
      local speed = 0.5 -- m/s
      scene:behave(load, { step = function(_, dt) rope.length = rope.length + speed * dt end })
      local least, most = math.huge, 0
      scene:behave(load, { step = function()
        if scene.time < 0.3 then return end
        least, most = math.min(least, rope.force), math.max(most, rope.force)
      end })
      scene:at(1, function() scene:result("least", least) scene:result("most", most) end)
    ]]):format(rate))
    scene:advance(1.1)
    expect(scene:result("least")):near(2 * 9.81, 1e-6)
    expect(scene:result("most")):near(2 * 9.81, 1e-6)
    expect(scene:find("rope").taken):near(scene:find("rope").length, 1e-12)
  end
end)

test("a string that is written longer twice between two steps, or in a step of another length, is slack by the whole", function()
  local scene = open_text [[
    local load = scene:ball { radius = 0.1, at = vec(0, 2, 0), points = { top = vec(0, 0, 0) } }
    local rope = scene:string({ vec(0, 4, 0), load.top }, { length = 2, name = "rope" })
    scene:at(0.1, function() rope.length = 2.5 rope.length = 3 end)
    scene:at(0.1 + scene.step, function() scene.step = 1 / 60 end)
    scene:at(0.3, function() scene:result("taken", rope.taken) scene:result("time", scene.time) end)
  ]]
  scene:advance(0.4)
  expect(scene:result("taken")):near(2 + 0.5 * 9.81 * (scene:result("time") - 0.1) ^ 2, 1e-3)
  scene:advance(2)
  expect(scene:find("rope").taken):near(3, 1e-9)
end)
