-- Couplings, limits and motors among what touches.
local g = 9.81

local function scene_at(rate, text)
  return open_text(("scene.step = 1 / %d\nlocal x, y, z = vec(1, 0, 0), vec(0, 1, 0), vec(0, 0, 1)\n"):format(rate) .. text)
end

for _, rate in ipairs { 60, 240 } do
  local at_rate = " at " .. rate .. " Hz"

  test("strings carry a load that rests on the plate that they hold" .. at_rate, function()
    local scene = scene_at(rate, [[
      local plate = scene:box { size = vec(1, 0.1, 1), mass = 1, at = vec(0, 1, 0), points = { l = vec(-0.5, 0.05, 0), r = vec(0.5, 0.05, 0) } }
      scene:align(plate, z, nil, z)
      scene:string({ plate.l, vec(-0.5, 4, 0) }, { name = "left" })
      scene:string { plate.r, vec(0.5, 4, 0) }
      scene:box { size = 0.4, mass = 10, at = vec(0, 1.25, 0), name = "load" }
    ]])
    scene:advance(5)
    expect(scene:find("load").position.y):near(1.25, 1e-8)
    expect(scene:find("left").force):near(5.5 * g, 1e-4)
    expect(scene.error.worst_penetration):below(1e-8)
    expect(scene.error.worst_energy):below(1e-7)
  end)

  test("a load on one side of a pulley lifts the other side" .. at_rate, function()
    local scene = scene_at(rate, [[
      local plate = scene:box { size = vec(1, 0.1, 1), mass = 1, at = vec(0, 1, 0), points = { p = vec(0, 0.05, 0) } }
      local weight = scene:box { size = 0.4, mass = 2, at = vec(3, 1, 0), points = { p = vec(0, 0.2, 0) } }
      scene:pulley(plate.p, vec(0, 6, 0), vec(3, 6, 0), weight.p, { name = "pulley" })
      scene:orient(plate)
      scene:orient(weight)
      scene:box { size = 0.4, mass = 10, at = vec(0, 1.25, 0), name = "load" }
    ]])
    scene:advance(0.5)
    local acceleration = (11 - 2) / 13 * g
    expect(scene:find("load").position.y):near(1.25 - 0.125 * acceleration, 1e-8)
    expect(scene:find("pulley").force):near(2 * (g + acceleration), 1e-5)
  end)

  test("a rack turns its wheel under a load that rests on it" .. at_rate, function()
    local scene = scene_at(rate, [[
      local wheel = scene:body { mass = 1, inertia = vec(0.1, 0.1, 0.1), at = vec(0, 3, 0), points = { hub = vec(0, 0, 0) } }
      scene:nail(wheel.hub)
      scene:align(wheel, z, nil, z)
      local rod = scene:box { size = vec(1, 0.1, 1), mass = 1, at = vec(-0.5, 1, 0), points = { p = vec(0, 0.05, 0) } }
      scene:orient(rod)
      scene:on_plane(rod.p, { normal = x })
      scene:on_plane(rod.p, { normal = z })
      scene:rack(wheel, rod.p, { radius = 0.5, axis = z, along = y })
      scene:box { size = 0.4, mass = 10, at = vec(-0.5, 1.25, 0), name = "load" }
    ]])
    scene:advance(0.5)
    expect(scene:find("load").position.y):near(1.25 - 0.125 * 11 * g / (11 + 0.1 / 0.25), 1e-5)
    expect(scene.error.worst_energy):below(1e-7)
  end)

  for _, most in ipairs { 200, 1e4 } do
    test(("a motor of at most %g N m holds a beam that carries a box"):format(most) .. at_rate, function()
      local scene = scene_at(rate, ([[
        local beam = scene:box { size = vec(2, 0.1, 0.5), mass = 1, at = vec(1, 1, 0), points = { hub = vec(-1, 0, 0) }, name = "beam" }
        scene:nail(beam.hub)
        scene:align(beam, z, nil, z)
        scene:motor(beam, { axis = z, speed = 0, max_torque = %g, name = "motor" })
        scene:box { size = 0.4, mass = 10, at = vec(1.5, 1.25, 0) }
      ]]):format(most))
      scene:advance(1)
      expect(scene:find("beam").position.y):near(1, 1e-11)
      expect(scene:find("motor").torque.z):near(g + 10 * g * 1.5, 1e-3)
      expect(scene.error.worst_energy):below(1e-6)
    end)
  end

  test("a motor that is too weak for a load by contact gives what it can" .. at_rate, function()
    local scene = scene_at(rate, [[
      local beam = scene:box { size = vec(2, 0.1, 0.5), mass = 1, at = vec(1, 1, 0), points = { hub = vec(-1, 0, 0) }, name = "beam" }
      scene:nail(beam.hub)
      scene:align(beam, z, nil, z)
      scene:motor(beam, { axis = z, speed = 0, max_torque = 60, name = "motor" })
      scene:ball { radius = 0.1, mass = 10, at = vec(1.5, 1.15, 0), friction = 0 }
    ]])
    scene:advance(0.1)
    local inertia = (4 + 0.01) / 12 + 1 + 10 * 1.5 ^ 2
    local acceleration = (g + 10 * g * 1.5 - 60) / inertia
    expect(scene:find("beam").spin.z):near(-acceleration * 0.1, 2e-3 * acceleration * 0.1)
    expect(scene:find("motor").torque.z):near(60, 1e-9)
  end)

  test("a limit stops a blow towards it and lets one from it go" .. at_rate, function()
    local function after_blow(way)
      local scene = scene_at(rate, ([[
        scene.gravity = vec(0, 0, 0)
        local bar = scene:box { size = vec(2, 0.1, 0.5), mass = 1, at = vec(1, 0, 0), points = { hub = vec(-1, 0, 0) }, name = "bar" }
        scene:nail(bar.hub)
        scene:align(bar, z, nil, z)
        scene:limit(bar, { axis = z, min = 0, max = 1 })
        scene:ball { radius = 0.2, mass = 1, at = vec(1.5, %g, 0), velocity = vec(0, %g, 0), name = "ball", restitution = 1, friction = 0 }
      ]]):format(-0.3 * way, 2 * way))
      scene:advance(0.1)
      return scene:find("bar").spin.z, scene:find("ball").velocity.y
    end
    local spin, speed = after_blow(-1)
    expect(spin):near(0, 1e-12)
    expect(speed):near(2, 1e-8)
    spin, speed = after_blow(1)
    local inertia = (4 + 0.01) / 12 + 1
    expect(spin):near(2 * 2 * 1.5 / (inertia + 1.5 ^ 2), 1e-9)
    expect(speed):near(2 - 2 * 2 * inertia / (inertia + 1.5 ^ 2), 1e-9)
  end)

  test("a string at its end stops a blow that would stretch it and lets one that slackens it go" .. at_rate, function()
    local function after_blow(way)
      local scene = scene_at(rate, ([[
        scene.gravity = vec(0, 0, 0)
        local box = scene:box { size = 0.4, mass = 1, at = vec(0, 0, 0), points = { p = vec(0, 0, 0) }, name = "box" }
        scene:string { box.p, vec(0, 3, 0) }
        scene:ball { radius = 0.2, mass = 1, at = vec(0, %g, 0), velocity = vec(0, %g, 0), name = "ball", restitution = 1 }
      ]]):format(-0.6 * way, 2 * way))
      scene:advance(0.3)
      return scene:find("box").velocity.y, scene:find("ball").velocity.y
    end
    local box, ball = after_blow(-1)
    expect(box):near(0, 1e-12)
    expect(ball):near(2, 1e-9)
    box, ball = after_blow(1)
    expect(box):near(2, 1e-12)
    expect(ball):near(0, 1e-12)
  end)
end

for _, rate in ipairs { 60, 240 } do
  test("a motor without a limit that jams gives no energy without end at " .. rate .. " Hz", function()
    local scene = scene_at(rate, [[
      scene:floor { friction = 0.5 }
      local last
      for i = 1, 3 do
        local link = scene:box { size = vec(1, 0.2, 0.3), mass = 2, at = vec(i, 0.1, 0), points = { l = vec(-0.5, 0, 0), r = vec(0.5, 0, 0) } }
        if last then scene:hinge(last.r, link.l, { axis = z }) end
        if i == 2 then scene:motor(link, last, { axis = z, speed = 3 }) end
        last = link
      end
    ]])
    scene:advance(3)
    expect(math.abs(scene.ledger.motor)):below(1e6)
  end)
end

for threads, seconds in pairs { [5] = 4, [7] = 10 } do
  test("a net of " .. threads .. " x " .. threads .. " rods that is laid over a ball and a box again and again is thrown off by neither", function()
    local scene = open_text(("local n = %d\n"):format(threads) .. [[
      scene:floor { height = 0, friction = 0.6 }
      local edge, knots = 1.8, {}
      local gap = edge / (n - 1)
      local knot = scene:family("knot", { solid = true, friction = 0.4, layer = "net", mass = 0.3 / (n * n), radius = 0.025 })
      scene:collide("net", "net", false)
      scene:ground { shape = shape.ball { radius = 0.45, friction = 0.4 }, at = vec(-0.25, 0.75, 0) }
      scene:block { size = vec(0.6, 0.8, 0.6), mass = 5, at = vec(0.75, 0.4, 0.1) }
      local function place(i, j) return vec((i - 1) * gap - edge / 2 + 0.15, 1.35, (j - 1) * gap - edge / 2) end
      for i = 1, n do
        knots[i] = {}
        for j = 1, n do
          knots[i][j] = scene:particle { family = knot, at = place(i, j) }
          if i > 1 then scene:rod(knots[i - 1][j], knots[i][j]) end
          if j > 1 then scene:rod(knots[i][j - 1], knots[i][j]) end
        end
      end
      scene:every(2, function()
        local aside = vec(0.8 * math.random() - 0.4, 0, 0.8 * math.random() - 0.4)
        for i, line in ipairs(knots) do
          for j, one in ipairs(line) do one.position, one.velocity = place(i, j) + aside, vec(0, 0, 0) end
        end
      end)
    ]])
    local most = 0
    while scene.time < seconds do
      scene:step()
      most = math.max(most, scene.energy.kinetic)
    end
    expect(most):below(0.3 * g * 1.35)
    expect(scene.error.worst_constraint):below(1e-9)
    expect(scene.error.worst_energy):below(0.03)
  end)
end

test("a drum takes up a chain that lies on the floor, with a ball at its end, and no link sinks into it", function()
  local scene = open_text [[
    scene.step = 1 / 60
    scene:floor {}
    local drum = scene:cylinder { radius = 0.4, length = 1, axis = vec(0, 0, 1), density = 500, friction = 0.5, at = vec(0, 4, 0),
                                  points = { hub = vec(0, 0, 0), rim = vec(0.43, 0, 0) } }
    scene:nail(drum.hub)
    scene:orient(drum, function(t) return quat(vec(0, 0, 1), -0.8 * t) end)
    local eye = drum.rim
    for i = 1, 40 do
      local half = (eye.position.y > 0.7 and vec(0, -0.15, 0) or vec(0.15, 0, 0)) / 2
      local link = scene:body { shapes = { shape.capsule { radius = 0.03, from = half * -0.8, to = half * 0.8, density = 1000, friction = 0.5 } },
                                at = eye.position + half, points = { head = -half, tail = half } }
      scene:hinge(eye, link.head)
      eye = link.tail
    end
    local load = scene:ball { radius = 0.25, mass = 5, at = eye.position + vec(0.25, 0, 0), points = { eye = vec(-0.25, 0, 0) } }
    scene:hinge(eye, load.eye)
  ]]
  scene:advance(6)
  expect(scene.error.worst_penetration):below(0.003)
  expect(scene.error.worst_energy):below(0.001)
end)

test("two boxes whose corners are joined round their sides meet without touching: momenta are kept, work is small", function()
  for _, hertz in ipairs { 60, 240, 1000 } do
    for _, options in ipairs { "{}", "{ max_force = 2 }" } do
      local scene = open_text(([[
        scene.gravity, scene.step = vec(0, 0, 0), 1 / %d
        local points = { far = vec(0.5, 0.1, 0) }
        local a = scene:box { size = vec(1, 0.2, 0.2), mass = 1, points = points }
        local b = scene:box { size = vec(1, 0.2, 0.2), mass = 2, points = points, at = vec(1.5, 0.6, 0) }
        scene:join(a.far, b.far, %s)
      ]]):format(hertz, options))
      for _ = 1, 40 do
        scene:advance(0.1)
        expect(scene.angular_momentum:length()):below(1e-12)
        expect(scene.momentum:length()):below(1e-12)
      end
      expect(scene.ledger.hand):below(5)
      expect(scene.error.worst_energy):below(1e-4)
      expect(#scene.hinges):equal(1)
    end
  end
end)

test("what slides on a floor is stopped by a limit or a string where that ends, and loses its energy to it", function()
  for _, tie in ipairs { "scene:limit(box.h, vec(-2, 0.25, 0), { min = 1.2 })", "scene:string({ box.h, vec(2, 0.25, 0) }, { length = 2.8 })" } do
    for _, rate in ipairs { 60, 240, 4000 } do
      local scene = open_text(("scene.step = 1 / %d\n"):format(rate) .. [[
        scene:floor { friction = 0 }
        local box = scene:box { name = "box", size = 0.5, at = vec(0, 0.25, 0), mass = 1, friction = 0, velocity = vec(-2.6, 0, 0), points = { h = vec(0, 0, 0) } }
        scene:on("step", function() local _ = scene.ledger, scene.contact_heat end)
      ]] .. tie)
      scene:advance(1)
      expect(scene:find("box").position.x):near(-0.8, 1e-5)
      expect(scene.ledger.limit):near(-0.5 * 2.6 ^ 2, 1e-6)
      expect(scene.ledger.contact):near(0, 1e-6)
    end
  end
end)

test("a ball that rebounds beside a tie that takes no part in it keeps its speed along the floor", function()
  for _, tie in ipairs { "scene:string({ ball.c, vec(-8, 0.1, 0) }, { length = 90 })", "scene:on_plane(ball.c, { normal = vec(0, 0, 1) })", "scene:orient(ball)" } do
    for _, rate in ipairs { 60, 240 } do
      local scene = open_text(("scene.step = 1 / %d\n"):format(rate) .. [[
        scene:floor { restitution = 1, friction = 0 }
        local ball = scene:ball { radius = 0.1, at = vec(0, 1, 0), mass = 1, restitution = 1, friction = 0, velocity = vec(1, 0, 0), points = { c = vec(0, 0, 0) } }
      ]] .. tie)
      scene:advance(5)
      expect(scene.bodies[1].velocity.x):near(1, 1e-9)
      expect(scene.energy.total):near(10.31, 1e-3)
    end
  end
end)

for _, rate in ipairs { 60, 240 } do
  test(("a bar on a nail that strikes a block keeps its energy when nothing takes any at %d Hz"):format(rate), function()
    local scene = scene_at(rate, [[
      scene.plane, scene.gravity = "xy", vec(0, 0, 0)
      local bar = scene:box { size = vec(1, 0.1, 0.1), mass = 1, at = vec(0.5, 0, 0), velocity = vec(0, 3.85, 0), spin = vec(0, 0, 7.7), restitution = 1, friction = 0, points = { hub = vec(-0.5, 0, 0) } }
      scene:nail(bar.hub)
      scene:box { size = 0.2, mass = 1, at = vec(0, 0.8, 0), restitution = 1, friction = 0, name = "struck" }
    ]])
    local start = scene.energy.kinetic
    scene:advance(1)
    expect(scene:find("struck").velocity:length()):above(3)
    expect(scene.energy.kinetic):near(start, 1e-3)
  end)
end

local arm_on_floor = [[
  scene.plane, scene.step = "xy", 1 / $hz
  scene:floor { friction = 0.8 }
  local arm = scene:box { name = "arm", size = vec(3, 0.2, 0.3), at = vec(1.5, 0.5, 0), points = { root = vec(-1.5, 0, 0) } }
  scene:nail(arm.root)
  scene:motor(arm, { $wanted, max_torque = $torque })
]]

for wanted, text in pairs { ["to an angle"] = "angle = function(t) return -math.min(0.5, 0.2 * t) end", ["at a speed"] = "speed = -0.2" } do
  test("a motor that presses an arm on the floor with all its torque does nothing once it rests: " .. wanted, function()
    for _, hz in ipairs { 60, 100, 240, 333 } do
      for _, torque in ipairs { 2e4, 2e5, 1e6 } do
        local scene = open_text((arm_on_floor:gsub("%$(%w+)", { hz = hz, wanted = text, torque = torque })))
        scene:advance(3)
        local done, at = scene.ledger.motor, scene:find("arm").position
        scene:advance(2)
        expect(scene.ledger.motor):near(done, 1)
        expect((scene:find("arm").position - at):length()):below(1e-6)
        expect(scene.error.energy):below(1e-4)
        expect(scene.error.penetration):below(1e-5)
      end
    end
  end)
end

for _, rate in ipairs { 60, 240 } do
  test(("bars that motors turn, and that rebound off the floor, gain no energy at %d Hz"):format(rate), function()
    for _, torque in ipairs { 10, 50 } do
      local scene = scene_at(rate, ([[
        scene.plane = "xy"
        scene:floor { friction = 1 }
        local hub = scene:box { size = vec(2, 0.4, 1), at = vec(0, 1.2, 0), mass = 10, points = { vec(-0.8, -0.3, 0), vec(0.8, -0.3, 0) } }
        for i = 1, 2 do
          local bar = scene:box { size = vec(0.8, 0.3, 0.8), at = hub.points[i].position, mass = 2, restitution = 0.8, points = { hub = vec(0, 0, 0) } }
          scene:hinge(hub.points[i], bar.hub)
          scene:motor(bar, hub, { speed = -10, max_torque = %g })
        end
      ]]):format(torque))
      scene:advance(10)
      expect(scene.error.energy):below(3e-3)
    end
  end)
end

test("what a motor and a nail are told to bear is the mean of the step, however many sub-steps blows make of it", function()
  local scene = open_text [[
    scene.step, scene.plane = 1 / 60, "xy"
    local wheel = scene:cylinder { name = "wheel", radius = 0.3, length = 0.2, axis = vec(0, 0, 1), mass = 2, at = vec(0, 1, 0), points = { hub = vec(0, 0, 0) }, friction = 0.5, restitution = 0.6 }
    scene:nail(wheel.hub, { name = "nail" })
    scene:motor(wheel, { name = "motor", axis = vec(0, 0, 1), speed = -8, max_torque = 20 })
    scene:box { name = "box", size = 0.3, mass = 5.5, at = vec(-0.1, 2.2, 0), friction = 0.7 }
  ]]
  local wheel, motor, nail, box = scene:find "wheel", scene:find "motor", scene:find "nail", scene:find "box"
  local strikes = 0
  for _ = 1, 60 do
    local before = box.velocity
    scene:step()
    expect(math.abs(motor.torque.z)):below(20 * (1 + 1e-9))
    local pressed = 5.5 * ((box.velocity - before) * 60 + vec(0, 9.81, 0)) -- by the wheel
    if pressed:length() > 100 then strikes = strikes + 1 end
    expect((nail.force - pressed - vec(0, 2 * 9.81, 0)):length()):below(1e-6 + 1e-3 * pressed:length())
  end
  expect(strikes):above(0)
end)
