--- scene.accuracy is kept, or it is said that it is not: against Runge and Kutta's fourth-order steps, written here.

--- State after `time` [s] of y' = f(t, y), from `y`, in `steps`.
local function runge_kutta(f, y, time, steps)
  local h = time / steps
  local function moved(k, by)
    local z = {}
    for i = 1, #y do z[i] = y[i] + by * k[i] end
    return z
  end
  for n = 0, steps - 1 do
    local t = n * h
    local a = f(t, y)
    local b = f(t + h / 2, moved(a, h / 2))
    local c = f(t + h / 2, moved(b, h / 2))
    local d = f(t + h, moved(c, h))
    for i = 1, #y do y[i] = y[i] + h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]) end
  end
  return y
end

--- A particle of 1 kg in a plane, under the acceleration that `law` gives and the Lua function `acceleration` repeats.
local cases = {
  { name = "a force of time from rest", at = { 0, 0 }, velocity = { 0, 0 }, size = 0.2,
    law = "scene:field(scene, force.point { force = function(p, own, t) return vec(60 * math.cos(25 * t), 0, 0) end })",
    acceleration = function(t) return 60 * math.cos(25 * t), 0 end },
  { name = "v × B", at = { 1, 0 }, velocity = { 0, 1 }, size = 0.1,
    law = "scene:field(scene, force.point { force = function(p) return p.velocity:cross(vec(0, 0, 20)) end })",
    acceleration = function(_, _, _, u, v) return 20 * v, -20 * u end },
  { name = "a quartic well from rest", at = { 1, 0 }, velocity = { 0, 0 }, size = 2,
    law = "scene:field(scene, force.point { potential = function(p) return 4 * p.position.x ^ 4 end })",
    acceleration = function(_, x) return -16 * x ^ 3, 0 end },
  { name = "a spring of 1e6 N/m", at = { 1, 0 }, velocity = { 0, 0 }, size = 2, time = 0.1,
    law = "scene:field(scene, force.point { potential = function(p) return 5e5 * p.position.x ^ 2 end })",
    acceleration = function(_, x) return -1e6 * x, 0 end },
  { name = "an orbit of eccentricity 0.9", at = { 1.9, 0 }, velocity = { 0, 10 * math.sqrt(0.1 / 1.9) }, size = 2,
    law = "scene:connect(p, vec(0, 0, 0), force.pair { potential = function(r) return -100 / r end })",
    acceleration = function(_, x, y)
      local r3 = (x * x + y * y) ^ 1.5
      return -100 * x / r3, -100 * y / r3
    end },
  { name = "a fly-by of charges", at = { -3, 0.02 }, velocity = { 6, 0 }, size = 6,
    law = "scene:connect(p, vec(0, 0, 0), force.pair { potential = function(r) return 10 / r end })",
    acceleration = function(_, x, y)
      local r3 = (x * x + y * y) ^ 1.5
      return 10 * x / r3, 10 * y / r3
    end },
  { name = "friction as a tanh", at = { 0, 0 }, velocity = { 3, 0 }, size = 0.5,
    law = "scene:field(scene, force.point { force = function(p) return vec(-4 * math.tanh(p.velocity.x / 0.5), 0, 0) end })",
    acceleration = function(_, _, _, u) return -4 * math.tanh(u / 0.5), 0 end },
  { name = "a ball on a stiff spring that drags", at = { 0, 1 }, velocity = { 0, 0 }, size = 1,
    law = [[scene:field(scene, force.point { force = function(p)
      local y = p.position.y
      return vec(0, where(y < 0, math.max(-1e4 * y - 3 * p.velocity.y, 0), 0) - 9.81, 0)
    end })]],
    acceleration = function(_, _, y, _, v) return 0, (y < 0 and math.max(-1e4 * y - 3 * v, 0) or 0) - 9.81 end },
}

for _, case in ipairs(cases) do
  test("accuracy is kept, or missed aloud: " .. case.name, function()
    local time = case.time or 1
    local function slope(t, y)
      local ax, ay = case.acceleration(t, y[1], y[2], y[3], y[4])
      return { y[3], y[4], ax, ay }
    end
    local exact = runge_kutta(slope, { case.at[1], case.at[2], case.velocity[1], case.velocity[2] }, time, 200000)
    for _, accuracy in ipairs { 1e-4, 1e-6 } do
      local scene = open_text(([[
        scene.gravity, scene.step, scene.accuracy = vec(0, 0, 0), 1 / 100, %g
        local p = scene:particle { mass = 1, at = vec(%.17g, %.17g, 0), velocity = vec(%.17g, %.17g, 0), name = "p" }
      ]]):format(accuracy, case.at[1], case.at[2], case.velocity[1], case.velocity[2]) .. case.law)
      scene:advance(time)
      local at = scene:find("p").position
      local error = math.sqrt((at.x - exact[1]) ^ 2 + (at.y - exact[2]) ^ 2) / case.size / time
      local said = false
      for _, line in ipairs(scene.log) do said = said or line.text:find("scene.accuracy is not reached", 1, true) end
      if not said then expect(error):below(2 * accuracy) end
    end
  end)
end

test("a step in which two meet at 30 m/s is done again, and leaves them with each other's velocity or a warning", function()
  local scene = open_text [[
    scene.gravity, scene.accuracy = vec(0, 0, 0), 1e-3
    local f = scene:family("f", { mass = 1 })
    scene:particle { family = f, at = vec(-3.00046, 0, 0), velocity = vec(30, 0, 0), name = "p" }
    scene:particle { family = f, at = vec(0, 0, 0), name = "q" }
    scene:interact(f, f, force.wca { epsilon = 100, sigma = 0.02 })
  ]]
  scene:advance(0.2)
  expect(scene:find("q").velocity.x):near(30, 0.03)
  expect(scene:find("p").velocity.x):near(0, 0.03)
  expect(scene.stats.rejected_steps):above(0)
end)

test("what has nothing to do with the others takes no sub-step from them", function()
  local function sub_steps(more)
    local scene = open_text([[
      scene.gravity, scene.step, scene.accuracy = vec(0, 0, 0), 1 / 100, 1e-4
      local p = scene:particle { at = vec(1, 0, 0) }
      scene:connect(p, vec(0, 0, 0), force.spring { stiffness = 40, length = 0 })
    ]] .. more)
    scene:advance(1)
    return scene.stats.sub_steps
  end
  local alone = sub_steps ""
  expect(alone):above(1)
  for _, more in ipairs {
    "scene:field(scene, force.drag { linear = 1e-9 })",
    "scene:connect(scene:particle { at = vec(1e4, 0, 0) }, vec(1e4, 1, 0), force.spring { stiffness = 1 })",
    "for i = 1, 100 do scene:connect(scene:particle { at = vec(i, 5, 0) }, vec(i, 6, 0), force.spring { stiffness = 1 }) end",
    "scene:field(scene, force.thermostat { rate = 1e-9, temperature = 1e-9 })",
  } do
    expect(sub_steps(more)):above(alone - 1)
  end
end)

test("accuracy asked of a step serves a scene of microseconds", function()
  local scene = open_text [[
    scene.gravity, scene.step, scene.accuracy, scene.accuracy_per = vec(0, 0, 0), 1e-7, 1e-6, "step"
    local p = scene:particle { at = vec(1e-6, 0, 0), name = "p" }
    scene:connect(p, vec(0, 0, 0), force.spring { stiffness = 1e12, length = 0 })
  ]]
  scene:advance(1e-5)
  expect(scene:find("p").position.x / 1e-6):near(math.cos(10), 1e-3)
  expect(scene.stats.sub_steps):below(33)
  expect(function() open_text 'scene.accuracy_per = "hour"' end):fails 'accuracy_per must be "second" or "step"'
end)

--- Sub-steps of the scene on average over a second at accuracy 1e-6, and the error that was missed.
local function mean_sub_steps(text)
  local scene = open_text("scene.gravity, scene.step, scene.accuracy = vec(0, 0, 0), 1 / 100, 1e-6\n" .. text)
  local sum = 0
  for _ = 1, 100 do
    scene:advance(1 / 100)
    sum = sum + scene.stats.sub_steps
  end
  return sum / 100, scene.stats.missed_accuracy
end

local binary = [[
  local f = scene:family("f", { mass = 1 })
  scene:interact(f, f, force.pair { cutoff = 3, potential = function(r) return -1 / r end })
  local p = scene:particle { family = f, at = vec(0.5, 0, 0), velocity = vec(0, 0.7, 0) }
  local q = scene:particle { family = f, at = vec(-0.5, 0, 0), velocity = vec(0, -0.7, 0) }
  local function both(change) change(p) change(q) end
]]

test("a pair takes as many sub-steps wherever it is, goes or falls, and beside whatever is far", function()
  local alone = mean_sub_steps(binary)
  expect(alone):above(4)
  for _, more in ipairs {
    "scene:particle { family = f, at = vec(1e4, 0, 0), velocity = vec(1000, 0, 0) }",
    "both(function(a) a.velocity = a.velocity + vec(0, 1e4, 0) end)",
    "both(function(a) a.position = a.position + vec(1e5, 0, 0) end)",
    "scene.gravity = vec(0, -100, 0)",
    "scene.box = vec(1000, 1000, 1000)",
    "scene:field(scene, force.point { potential = function(p) return 100 * p.position.y end })",
    "scene:field(scene, force.point { force = function(p, own, t) return vec(1e-9 * math.cos(3 * t), 0, 0) end })",
    "scene:field(scene, force.thermostat { rate = 1e-9, temperature = 1e-9 })",
  } do
    local with = mean_sub_steps(binary .. more)
    expect(with):above(alone - 0.1)
    expect(with):below(4 * alone)
  end
end)

test("a gyration takes as many sub-steps with a drift along the field or across it", function()
  local turning = [[
    local p = scene:particle { mass = 1, at = vec(1, 0, 0), velocity = vec(0, 1, 0) }
    scene:field(scene, force.point { force = function(p) return p.velocity:cross(vec(0, 0, 20)) end })
  ]]
  local alone = mean_sub_steps(turning)
  for _, more in ipairs {
    "p.velocity = vec(0, 1, 1000)",
    "p.position = vec(1e6, 0, 0)",
    "scene.gravity = vec(0, 0, -10)",
    "p.velocity = vec(0, -99, 0) scene:field(scene, force.point { force = function() return vec(2000, 0, 0) end })",
  } do
    expect((mean_sub_steps(turning .. more))):above(0.9 * alone)
  end
end)

test("a force whose period divides the step is seen, and from rest no size is told before there is one", function()
  for _, multiple in ipairs { 1, 4 } do
    local w = 200 * math.pi * multiple
    local scene = open_text(([[
      scene.gravity, scene.step, scene.accuracy = vec(0, 0, 0), 1 / 100, 1e-4
      scene:particle { mass = 1, name = "p" }
      scene:field(scene, force.point { force = function(p, own, t) return vec(60 * math.sin(%.17g * t), 0, 0) end })
    ]]):format(w))
    scene:advance(1)
    expect(scene.stats.sub_steps):equal(256)
    local error = math.abs(scene:find("p").position.x - 60 / w) / (120 / w ^ 2)
    expect(scene.stats.missed_accuracy):above(error / 2)
  end
  local slow = open_text [[
    scene.gravity, scene.step, scene.accuracy = vec(0, 0, 0), 1 / 60, 1e-4
    scene:particle { mass = 1, name = "p" }
    scene:field(scene, force.point { force = function(p, own, t) return vec(60 * math.sin(25 * t), 0, 0) end })
  ]]
  slow:advance(2)
  expect(slow.stats.missed_accuracy):equal(0)
  expect(slow:find("p").position.x):near(60 / 25 * (2 - math.sin(50) / 25), 4e-5)
end)

test("a planet of eccentricity 0.99 is told to be wrong by no less than half of what it is", function()
  local scene = open_text(([[
    scene.gravity, scene.step, scene.accuracy = vec(0, 0, 0), 1 / 100, 1e-6
    local p = scene:particle { mass = 1, at = vec(1.99, 0, 0), velocity = vec(0, %.17g, 0), name = "p" }
    scene:connect(p, vec(0, 0, 0), force.pair { potential = function(r) return -100 / r end })
  ]]):format(10 * math.sqrt(0.01 / 1.99)))
  scene:advance(1)
  local low, high = math.pi + 10 - 1, math.pi + 10 + 1  -- Kepler's equation of the eccentric anomaly
  for _ = 1, 60 do
    local E = (low + high) / 2
    if E - 0.99 * math.sin(E) < math.pi + 10 then low = E else high = E end
  end
  local x, y = 0.99 - math.cos(low), -math.sqrt(1 - 0.99 ^ 2) * math.sin(low)
  local at = scene:find("p").position
  local error = math.sqrt((at.x - x) ^ 2 + (at.y - y) ^ 2) / 2
  expect(error):above(1e-3)
  expect(scene.stats.missed_accuracy):above(error / 2)
end)

test("a gas with a cutoff and a thermostat takes few sub-steps", function()
  local scene = open_text [[
    scene.gravity, scene.box, scene.step, scene.accuracy = vec(0, 0, 0), vec(6, 6, 6), 0.004, 1e-3
    local f = scene:family("f", { mass = 1 })
    scene:interact(f, f, force.lennard_jones { epsilon = 1, sigma = 1, cutoff = 2.5 })
    for i = 0, 4 do for j = 0, 4 do for k = 0, 4 do
      scene:particle { family = f, at = 1.2 * vec(i, j, k) }
    end end end
    scene:field(scene, force.thermostat { rate = 1, temperature = 1 })
  ]]
  scene:advance(0.4)
  expect(scene.stats.sub_steps):below(17)
  expect(scene.stats.missed_accuracy):equal(0)
end)

test("what is not finite at rest names its law, and no accuracy", function()
  local scene = open_text [[
    scene.gravity = vec(0, 0, 0)
    scene:particle {}
    scene:field(scene, force.point { force = function(p) return p.position / p.position:length() end })
  ]]
  local ok, message = pcall(function() scene:advance(1) end)
  expect(ok):equal(false)
  expect(tostring(message):find("is not a finite number", 1, true) ~= nil):is_true()
  expect(tostring(message):find("scene.accuracy", 1, true)):equal(nil)
end)

test("scene.accuracy_per alone is said to do nothing, once", function()
  local scene = open_text 'scene.accuracy_per = "step"'
  scene:advance(0.1)
  expect(#scene.log):equal(1)
  expect(scene.log[1].text):equal 'scene.accuracy_per = "step" does nothing without scene.accuracy'
end)

test("a body that turns too fast for the most sub-steps is told, however fast", function()
  for _, spin in ipairs { 30, 300, 3000 } do
    local scene = open_text(([[
      scene.gravity, scene.step, scene.accuracy = vec(0, 0, 0), 1 / 10, 1e-9
      scene:body { mass = 1, inertia = vec(1, 1.5, 2), spin = vec(%d, %d, %d), name = "top" }
    ]]):format(spin, spin, spin))
    scene:advance(0.3)
    expect(scene.stats.missed_accuracy):above(1e-9)
    expect(scene.log[1].text:find("the turning of body 'top' would need a shorter scene.step", 1, true) ~= nil):is_true()
  end
end)

test("a string that goes taut leaves what goes along it, however many sub-steps", function()
  for start = 1, 12 do
    local y, vx, vy = -1.40 - 0.0081 * start, 0.3 + 0.05 * start, -2 + 0.07 * start
    for _, accuracy in ipairs { 1e-3, 1e-6, 1e-10 } do
      local scene = open_text(([[
        scene.gravity, scene.step, scene.accuracy = vec(0, 0, 0), 1 / 100, %g
        local p = scene:particle { mass = 1, at = vec(0, %g, 0), velocity = vec(%g, %g, 0), name = "p" }
        scene:string({ vec(0, 0, 0), p }, { length = 1.5 })
      ]]):format(accuracy, y, vx, vy))
      scene:advance(0.15)
      -- the angular momentum about the other end is kept
      expect(scene:find("p").velocity:length()):near(math.abs(y * vx) / 1.5, 1e-9)
    end
  end
end)

--- A bar of 1 m that hangs at what moves by a function of time: how its hinge is moved, and the acceleration of that.
local arm = [[
  local arm = scene:body { mass = 3, inertia = vec(0.1, 0.1, 0.1), points = { o = vec(0, 0, 0), tip = vec(0.5, 0, 0) } }
  scene:nail(arm.o)
  local function swing(t) return 0.5 - 0.5 * math.cos(4 * t) end
  local bar = hang(vec(0.5, 0, 0))
  scene:hinge(arm.tip, bar.o)
]]
local function of_arm(t)
  local turn, rate, change = 0.5 - 0.5 * math.cos(4 * t), 2 * math.sin(4 * t), 8 * math.cos(4 * t)
  local c, s = math.cos(turn), math.sin(turn)
  return 0.5 * (-change * s - rate ^ 2 * c), 0.5 * (change * c - rate ^ 2 * s)
end
local driven = {
  { name = "a follow", acceleration = function(t) return 7.5 * math.cos(5 * t), 0 end, text = [[
    scene:follow(hang(vec(0, 0, 0)).o, function(t) return vec(0.3 - 0.3 * math.cos(5 * t), 0, 0) end) ]] },
  { name = "a rod that changes length", acceleration = function(t) return 0, -9 * math.cos(6 * t) end, text = [[
    local slider = scene:particle { at = vec(0, 0, 0), mass = 1 }
    scene:on_path(slider, { vec(0, -2, 0), vec(0, 1, 0) })
    scene:rod(slider, vec(0, 2, 0)).length = function(t) return 2.25 - 0.25 * math.cos(6 * t) end
    scene:hinge(slider, hang(vec(0, 0, 0)).o) ]] },
  { name = "an orientation", acceleration = of_arm, text = arm .. [[
    scene:orient(arm, function(t) return quat(vec(0, 0, 1), swing(t)) end) ]] },
  { name = "a motor by angle", acceleration = of_arm, text = arm .. [[
    scene:motor(arm, { axis = vec(0, 0, 1), angle = swing }) ]] },
  { name = "a motor by speed", acceleration = of_arm, text = arm .. [[
    scene:motor(arm, { axis = vec(0, 0, 1), speed = function(t) return 2 * math.sin(4 * t) end }) ]] },
}

for _, case in ipairs(driven) do
  test("accuracy is kept, or missed aloud, by what follows a function of time: " .. case.name, function()
    local state = runge_kutta(function(t, y)
      local x, z = case.acceleration(t)
      return { y[2], -0.5 * ((9.81 + z) * math.sin(y[1]) + x * math.cos(y[1])) / 0.35 }
    end, { 0, 0 }, 2, 20000)
    for _, accuracy in ipairs { 1e-3, 1e-5 } do
      local scene = open_text("scene.step, scene.accuracy = 1 / 60, " .. accuracy .. [[
        local function hang(at)
          return scene:body { at = at - vec(0, 0.5, 0), mass = 1, inertia = vec(0.1, 0.01, 0.1), name = "bar",
                              points = { o = vec(0, 0.5, 0), tip = vec(0, -0.5, 0) } }
        end ]] .. case.text)
      scene:advance(2)
      local bar = scene:find("bar")
      local way = bar.tip.position - bar.o.position
      local error = (way - vec(math.sin(state[1]), -math.cos(state[1]), 0)):length()
      expect(error / 2):below(2 * math.max(accuracy, scene.stats.missed_accuracy))
      expect(scene.stats.missed_accuracy):below(10 * accuracy)
    end
  end)
end

test("the error of what stops before there is a size to compare it with is told once there is one", function()
  for _, steps in ipairs { 10, 60 } do
    local scene = open_text("scene.step, scene.accuracy = 1 / " .. steps .. [[, 1e-4
      scene.gravity = vec(0, 0, 0)
      local p = scene:particle { mass = 1, velocity = vec(10, 0, 0), name = "p" }
      scene:field(scene, force.drag { quadratic = 500 })
    ]])
    scene:advance(1)
    local way = math.log(1 + 500 * 10) / 500
    expect(scene.stats.missed_accuracy):above(math.abs(scene:find("p").position.x / way - 1))
    expect(scene.stats.missed_accuracy):below(0.5)
  end
end)
