--- Laws of velocity on what is free, at any strength, against closed forms and backward Euler.

local step = 1 / 240

--- A particle of 1 kg at 10 m/s along x under `law`.
local function thrown(law, settings)
  return open_text("scene.gravity, scene.step = vec(0, 0, 0), " .. step .. "\n" .. (settings or "") .. [[
    local p = scene:particle { mass = 1, velocity = vec(10, 0, 0), name = "p" }
    scene:field(scene, ]] .. law .. ")")
end

--- Speeds after each step by the law, in closed form, and by backward Euler.
local drags = {
  linear = {
    law = function(c) return "force.drag { linear = " .. c .. " }" end,
    exact = function(c, t) return 10 * math.exp(-c * t) end,
    euler = function(c, v) return v / (1 + step * c) end,
  },
  quadratic = {
    law = function(c) return "force.drag { quadratic = " .. c / 10 .. " }" end,
    exact = function(c, t) return 10 / (1 + c * t) end,
    euler = function(c, v) return (math.sqrt(1 + 4 * step * c / 10 * v) - 1) / (2 * step * c / 10) end,
  },
}

for name, drag in pairs(drags) do
  test(name .. " drag of any strength turns nothing round, gives nothing, and errs less than twice what backward Euler does",
    function()
      for exponent = -3, 6 do
        local c = 10 ^ exponent / step
        local scene = thrown(drag.law(c))
        local p, last, euler = scene:find "p", 10, 10
        for n = 1, 20 do
          scene:advance(step)
          euler = drag.euler(c, euler)
          local v, exact = p.velocity.x, drag.exact(c, n * step)
          expect(v >= 0 and v <= last):is_true()
          expect(math.abs(v - exact)):below(2 * math.abs(euler - exact) + 1e-14)
          last = v
        end
        expect(p.velocity.y):equal(0)
      end
    end)
end

test("drag is of second order where it is slow for the step", function()
  local wrong = {}
  for n, steps in ipairs { 60, 120, 240 } do
    local scene = thrown("force.drag { linear = 6, quadratic = 0.6 }", "scene.step = 1 / " .. steps .. "\n")
    scene:advance(1)
    -- v' = -6 v - 0.6 v²
    local e = math.exp(-6)
    wrong[n] = math.abs(scene:find("p").velocity.x - 10 * e / (2 - e))
  end
  expect(wrong[1] / wrong[2]):near(4, 0.4)
  expect(wrong[2] / wrong[3]):near(4, 0.4)
end)

test("in strong drag things sink as fast as weight and drag say", function()
  local scene = open_text [[
    scene:particle { mass = 1, name = "p" }
    scene:field(scene, force.drag { linear = 24000 })
  ]]
  scene:advance(0.1)
  expect(scene:find("p").velocity.y):near(-9.81 / 24000, 1e-9)
end)

for _, integrator in ipairs { "verlet", "implicit", "suzuki4" } do
  test("a magnetic force keeps the speed at any strength with " .. integrator, function()
    for _, turn in ipairs { 0.02, 0.3, 1, 3 } do
      for _, call in ipairs { "", "for _ in pairs({}) do end" } do
        local scene = open_text(([[
          scene.gravity, scene.integrator = vec(0, 0, 0), %q
          scene:particle { mass = 1, at = vec(1, 0, 0), velocity = vec(0, 1, 0.5), name = "p" }
          scene:field(scene, force.point { force = function(p) %s return p.velocity:cross(vec(3, 1, %g)) end })
        ]]):format(integrator, call, turn * 240))
        scene:advance(call == "" and 10 or 0.5)
        expect(math.abs(scene.energy.kinetic / 0.625 - 1)):below(1e-12)
        if call == "" then expect(scene.ledger.damper):equal(0) end
      end
    end
  end)
end

test("in a turning frame what moves straight does so to second order", function()
  local wrong = {}
  for n, steps in ipairs { 60, 120, 240 } do
    local scene = open_text(([[
      local W = 2
      scene.gravity, scene.step = vec(0, 0, 0), 1 / %d
      scene:particle { mass = 1, at = vec(1, 0, 0), velocity = vec(0.2, -W, 0), name = "p" }
      scene:field(scene, force.point { force = function(p)
        local v, x = p.velocity, p.position
        return vec(2 * W * v.y + W * W * x.x, -2 * W * v.x + W * W * x.y, 0)
      end })
    ]]):format(steps))
    scene:advance(2)
    local along = 1 + 0.2 * scene.time
    local exact = vec(along * math.cos(2 * scene.time), -along * math.sin(2 * scene.time), 0)
    wrong[n] = (scene:find("p").position - exact):length()
  end
  expect(wrong[3]):below(1e-3)
  expect(wrong[1] / wrong[2]):near(4, 0.4)
  expect(wrong[2] / wrong[3]):near(4, 0.4)
end)

test("a damper of any strength stops what it ties, free or on hinged bodies, and keeps the momentum", function()
  for _, damping in ipairs { 1e3, 1e6, 1e9 } do
    local free = open_text(([[
      scene.gravity = vec(0, 0, 0)
      local p = scene:particle { mass = 1, velocity = vec(1, 0, 0), name = "p" }
      local q = scene:particle { mass = 2, at = vec(1, 0, 0), name = "q" }
      scene:connect(p, q, force.damper { damping = %g })
    ]]):format(damping))
    free:advance(10 / 240)
    expect(math.abs(free:find("p").velocity.x - free:find("q").velocity.x)):below(1e-3)
    expect((free.momentum - vec(1, 0, 0)):length()):below(1e-13)
    local hinged = open_text(([[
      scene.gravity = vec(0, 0, 0)
      local function bar(name, at)
        return scene:body { mass = 1, inertia = vec(0.1, 0.1, 0.1), at = at, name = name,
          points = { head = vec(-0.5, 0, 0), tail = vec(0.5, 0, 0) } }
      end
      local a, b = bar("a", vec(0, 0, 0)), bar("b", vec(1, 0, 0))
      scene:hinge(a.tail, b.head)
      a:kick(vec(0, 1, 0))
      b:kick(vec(0, -1, 0))
      scene:connect(a.head, b.tail, force.damper { damping = %g })
      scene:connect(a.tail, vec(0.5, 3, 0), force.damper { damping = %g })
    ]]):format(damping, damping))
    hinged:advance(10 / 240)
    local head, tail = hinged:find("a").head, hinged:find("b").tail
    local along = (tail.position - head.position):normalized()
    expect(math.abs((tail.velocity - head.velocity):dot(along))):below(3 / damping)  -- what its tension asks for
  end
end)

test("dampers between all pairs only take, and keep the momentum, however strong", function()
  for _, damping in ipairs { 1, 1e3, 1e6 } do
    local scene = open_text(([[
      scene.gravity = vec(0, 0, 0)
      local f = scene:family("f", { mass = 1 })
      for i = 1, 30 do
        scene:particle { family = f, at = vec(math.random(), math.random(), math.random()),
                         velocity = vec(math.random(), math.random(), math.random()) }
      end
      scene:interact(f, f, force.pair { cutoff = 2, tension = function(r, rate) return %g * rate end })
    ]]):format(damping))
    local before, energy = scene.momentum, scene.energy.kinetic
    for _ = 1, 30 do
      scene:advance(1 / 240)
      expect(scene.energy.kinetic <= energy * (1 + 1e-13)):is_true()
      energy = scene.energy.kinetic
    end
    expect((scene.momentum - before):length()):below(1e-12)
  end
end)

test("friction of a wall never speeds anything up", function()
  local scene = open_text [[
    scene:particle { at = vec(0, 5, 0), radius = 0.1, velocity = vec(0.05, 0, 0), name = "p" }
    scene:field(scene, force.wall { normal = vec(0, 1, 0), stiffness = 5e4, damping = 50, friction = 0.6 })
  ]]
  local p, speed = scene:find "p", 0.05
  for _ = 1, 3 * 240 do
    scene:advance(1 / 240)
    expect(p.velocity.x > -1e-15 and p.velocity.x <= speed + 1e-15):is_true()
    speed = p.velocity.x
  end
  expect(speed):below(1e-9)
end)

test("a slope holds what is rough enough, and what is not slides by the difference", function()
  for _, friction in ipairs { 0.7, 0.3 } do
    local scene = open_text(([[
      local slope = math.rad(30)
      local normal = vec(-math.sin(slope), math.cos(slope), 0)
      scene:particle { at = normal * (0.1 - 9.81 * math.cos(slope) / 5e4), radius = 0.1, name = "p" }
      scene:field(scene, force.wall { normal = normal, stiffness = 5e4, damping = 300, friction = %g })
    ]]):format(friction))
    local p = scene:find "p"
    local from = p.position
    scene:advance(10)
    local way, angle = (p.position - from):length(), math.rad(30)
    local slides = math.max(0, 0.5 * 9.81 * (math.sin(angle) - friction * math.cos(angle)) * 100)
    expect(way):near(slides, 1e-3 * slides + 1e-4)
  end
end)

test("a body of points without mass on a damped wall only loses", function()
  local scene = open_text [[
    scene:body { points = { { at = vec(0, 2, 0), mass = 10 }, { at = vec(0, 2.6, 0), mass = 10 },
      { at = vec(0, 2.3, -0.05), mass = 1 }, vec(0.2, 2.5, 0), vec(-0.2, 2.5, 0) } }
    scene:field(scene, force.wall { normal = vec(0, 1, 0), stiffness = 5e4, damping = 300 })
  ]]
  local start, damper = scene.energy.total, 0
  for _ = 1, 80 do
    scene:advance(0.1)
    expect(scene.ledger.damper <= damper + 1e-9 * start):is_true()
    damper = scene.ledger.damper
    expect(scene.energy.total):below(1.01 * start)
  end
end)

test("suzuki4 takes a law of velocity that does no work, and refuses one that may take some", function()
  local function with(force)
    return function()
      open_text([[scene.integrator = "suzuki4" scene:particle {}
        scene:field(scene, force.point { force = function(p) return ]] .. force .. [[ end })]]):advance(0.1)
    end
  end
  with "p.velocity:cross(p.position + vec(0, 0, 2))" ()
  expect(with "p.velocity:cross(vec(0, 0, 2)) - 0.1 * p.velocity"):fails("depends on velocities")
end)

test("a thermostat spreads what is in a harmonic well as its temperature says, at a step of a radian", function()
  local scene = open_text [[
    scene.gravity, scene.step = vec(0, 0, 0), 1
    local f = scene:family("f", { mass = 1 })
    for _ = 1, 500 do scene:particle { family = f } end
    scene:field(f, force.point { potential = function(p) return p.position:dot(p.position) / 2 end })
    scene:field(f, force.thermostat { rate = 0.5, temperature = 3 })
  ]]
  scene:advance(30)
  local sum, count = 0, 0
  for _ = 1, 40 do
    scene:advance(5)
    for _, p in ipairs(scene.particles) do
      local x = p.position
      sum, count = sum + x:dot(x) / 3, count + 1
    end
  end
  expect(sum / count):near(3, 0.06)
end)

test("rk4 stops where something is damped or turned faster than its steps can follow, and says what can", function()
  local function damped(by)
    local scene = open_text('scene.integrator, scene.gravity = "rk4", vec(0, 0, 0)\n' .. [[
      scene:particle { velocity = vec(10, 0, 0), name = "p" }
      scene:field(scene, force.drag { linear = ]] .. by .. " })")
    scene:advance(0.1)
    return scene:find("p").velocity.x
  end
  expect(damped(10)):near(10 * math.exp(-1), 1e-6)
  damped(500)
  expect(function() damped(1e4) end):fails '"verlet" can, or a shorter scene.step'
  local two = [[
    scene.integrator, scene.gravity, scene.step = "rk4", vec(0, 0, 0), 1 / 60
    local p, q = scene:particle { velocity = vec(1, 0, 0) }, scene:particle { at = vec(1, 0, 0) }
  ]]
  for _, law in ipairs {
    "scene:connect(p, q, force.damper { damping = 200 })",
    "scene:field(scene, force.point { force = function(p) return p.velocity:cross(vec(0, 0, 240)) - 0.5 * p.velocity end })",
  } do
    expect(function() open_text(two .. law):advance(1) end):fails '"verlet" can, or a shorter scene.step'
  end
end)

test("a drag below 0 is followed, booked and told", function()
  local scene = open_text [[
    scene.gravity = vec(0, 0, 0)
    scene:particle { velocity = vec(1, 0, 0), name = "p" }
    scene:field(scene, force.point { force = function(p) return 2 * p.velocity end })
  ]]
  scene:advance(1)
  expect(scene:find("p").velocity.x):near(math.exp(2), 1e-3)
  expect(scene.ledger.damper):near(0.5 * (math.exp(4) - 1), 0.1)
  expect(scene.log[1].text:find("gives energy to what it acts on", 1, true) ~= nil):is_true()
end)

test("a derivative that is not finite is done without", function()
  local scene = open_text [[
    scene.gravity = vec(0, 0, 0)
    scene:particle { velocity = vec(0, 1, 0), name = "p" }
    scene:field(scene, force.point { force = function(p)
      local v = p.velocity
      return vec(0, -v.y, 0) - 0.1 * vec(math.sqrt(math.abs(v.x)), 0, 0)
    end })
  ]]
  scene:advance(1)
  expect(scene:find("p").velocity.y):near(math.exp(-1), 1e-3)
end)

test("what a force without potential holds up against gravity, or turns in it, is booked with no error", function()
  for _, force in ipairs { "vec(0, 9.81, 0)", "p.velocity:cross(vec(0, 0, 20))" } do
    local scene = open_text([[
      scene:particle { mass = 1 }
      scene:field(scene, force.point { force = function(p) return ]] .. force .. [[ end })
      local _ = scene.ledger.closure
    ]])
    scene:advance(10)
    expect(scene.error.worst_energy):below(2e-3)
    expect(scene.ledger.closure):below(1e-10)
  end
end)

test("a spring without potential that explodes does not tell that its energy is right", function()
  local scene = open_text [[
    scene.gravity, scene.step = vec(0, 0, 0), 1 / 12
    scene:particle { mass = 1, at = vec(1, 0, 0) }
    scene:field(scene, force.point { force = function(p) return -1600 * p.position end })
  ]]
  scene:advance(1)
  expect(scene.error.worst_energy):above(0.5)
end)

test("a spring beside a damper of any strength relaxes at the rate of the two", function()
  for _, damping in ipairs { 1e4, 1e5 } do
    local scene = open_text(([[
      scene.gravity = vec(0, 0, 0)
      local p, q = scene:particle { name = "p" }, scene:particle { at = vec(1.5, 0, 0), name = "q" }
      scene:connect(p, q, force.spring { stiffness = 1e4, length = 1, damping = %g })
    ]]):format(damping))
    scene:advance(0.5)
    local length = (scene:find("q").position - scene:find("p").position):length()
    expect(length):near(1 + 0.5 * math.exp(-0.5 * 1e4 / damping), 5e-3)
    expect(scene.stats.fallback_steps):equal(0)
  end
end)

test("a law that divides by the speed is named with what is at rest, and no accuracy is advised", function()
  local scene = open_text [[
    scene.gravity = vec(0, 0, 0)
    scene:particle { at = vec(0, 0, 0.5), name = "stone" }
    scene:field(scene, force.point { name = "drag", force = function(p) return -p.velocity / p.velocity:length() end })
  ]]
  expect(function() scene:step() end):fails("drag: the force on particle 'stone' is not a finite number, at rest at " ..
    "(0, 0, 0.5) m, where v / |v| is 0 / 0: a direction of motion has no meaning there; the scene is stopped")
end)

test("the temperature that a thermostat in a well shows is that of velocities at whole steps", function()
  local scene = open_text [[
    scene.gravity = vec(0, 0, 0)
    scene.step = 1 / 60
    for i = 1, 1000 do scene:particle { at = vec(0, 0, 0), mass = 1 } end
    scene:field(scene, force.point { potential = function(p) return 1800 * p.position:dot(p.position) end })
    scene:field(scene, force.thermostat { temperature = 2, rate = 100 })
  ]]
  scene:advance(0.5)
  local sum = 0
  for _ = 1, 60 do
    scene:step()
    sum = sum + scene.temperature
  end
  expect(sum / 60):near(2 * (1 - 1 / 4), 0.03)
end)

test("a ball that friction holds on a slope keeps its place, and its energy error stays small", function()
  local scene = open_text [[
    scene.gravity = vec(0, 0, -9.81)
    local n = vec(0.3, 0, 1):normalized()
    scene:particle { at = n * 0.0999, mass = 1, radius = 0.1, name = "ball" }
    scene:field(scene, force.wall { normal = n, stiffness = 1e4, friction = 0.9, damping = 30 })
  ]]
  scene:advance(5)
  expect(scene:find("ball").velocity:length()):below(1e-6)
  expect(scene.error.energy):below(0.05)
end)

test("in a plane a magnetic force turns by what of it is along the normal, and keeps the energy", function()
  local scene = open_text [[
    scene.gravity, scene.plane = vec(0, 0, 0), "xy"
    scene:particle { mass = 1, velocity = vec(1, 0, 0) }
    scene:field(scene, force.point { force = function(p) return p.velocity:cross(vec(500, 300, 20)) end })
  ]]
  scene:advance(2)
  expect(scene.energy.kinetic):near(0.5, 1e-10)
end)

test("what creeps in strong damping that depends on the place has a small energy error", function()
  local scene = open_text [[
    scene.gravity = vec(0, 0, 0)
    scene:particle { mass = 1, at = vec(2, 0, 0), velocity = vec(1, 0, 0), name = "p" }
    scene:field(scene, force.point { force = function(p)
      local x, v = p.position.x, p.velocity.x
      return vec(-4e4 * x - 3e5 * x * x * v, 0, 0)
    end })
  ]]
  scene:advance(1)
  expect(scene:find("p").position.x):near(1.932, 1e-3)
  expect(scene.error.worst_energy):below(0.01)
end)

test("a magnetic force that turns what moves farther in a step than can be followed is told once", function()
  for _, case in ipairs { { 100, 0 }, { 1e5, 1 } } do
    local scene = open_text(("scene.gravity = vec(0, 0, 0) scene:particle { velocity = vec(1, 0, 0) }\n"
      .. "scene:field(scene, force.point { force = function(p) return p.velocity:cross(vec(0, 0, %g)) end })")
      :format(case[1]))
    scene:advance(0.1)
    local told = 0
    for _, line in ipairs(scene.log) do
      if line.text:find("farther in a step than it can follow", 1, true) then told = told + 1 end
    end
    expect(told):equal(case[2])
  end
end)
