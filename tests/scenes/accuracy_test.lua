-- Steps of fourth order, and sub-steps chosen by the wanted error.
local function wheel(settings)
  return open_text(settings .. [[
    scene.gravity = vec(0, 0, 0)
    scene:body { mass = 1, inertia = vec(1, 1, 2), spin = vec(0, 0, 50), name = "wheel" }
    scene:body { mass = 1, inertia = vec(1, 1, 2), at = vec(9, 0, 0), name = "still" }
  ]])
end

--- Angle that the wheel lacks after a second.
local function lag(scene)
  scene:advance(1)
  local axis = scene:find("wheel").orientation:rotate(vec(1, 0, 0))
  local wrong = math.atan(axis.y, axis.x) - 50
  return math.abs(wrong - 2 * math.pi * math.floor(wrong / (2 * math.pi) + 0.5))
end

test("a fast wheel lags behind at fixed steps, and not where an accuracy is wanted, which says what it took", function()
  local fixed, accurate = wheel "", wheel "scene.accuracy = 1e-3\n"
  expect(lag(fixed)):near(50 * (50 / 240) ^ 2 / 12, 0.01)
  expect(lag(accurate)):below(1e-3)
  expect(fixed.stats.most_sub_steps):equal(1)
  expect(fixed.stats.most_sub_steps_of):equal("")
  expect(accurate.stats.most_sub_steps):above(7)
  expect(accurate.stats.most_sub_steps_of):equal("body 'wheel'")
  expect(accurate.stats.sub_steps):equal(1)
end)

test("suzuki4 swings two links a thousand times closer than verlet does", function()
  local function place(settings)
    local scene = open_text(settings .. [[
      local a = scene:body { mass = 1, inertia = vec(0.002, 0.08, 0.08), at = vec(0.5, 0, 0),
        points = { head = vec(-0.5, 0, 0), tail = vec(0.5, 0, 0) } }
      local b = scene:body { mass = 1, inertia = vec(0.002, 0.08, 0.08), at = vec(1.5, 0, 0), name = "end",
        points = { head = vec(-0.5, 0, 0), tail = vec(0.5, 0, 0) } }
      scene:nail(a.head)
      scene:hinge(a.tail, b.head)
    ]])
    scene:advance(1)
    return scene:find("end").position
  end
  local exact = place 'scene.step, scene.integrator = 1 / 1000, "suzuki4"\n'
  local second = (place "scene.step = 1 / 120\n" - exact):length()
  local fourth = (place 'scene.step, scene.integrator = 1 / 120, "suzuki4"\n' - exact):length()
  expect(fourth):below(second / 1000)
end)

local oscillator = [[
  scene.gravity, scene.step = vec(0, 0, 0), 1 / 100
  local p = scene:particle { at = vec(1, 0, 0), name = "p" }
  scene:connect(p, vec(0, 0, 0), force.spring { stiffness = (2 * math.pi) ^ 2, length = 0 })
]]

test("what swings through its anchor takes as many sub-steps there as elsewhere", function()
  local scene = open_text(oscillator .. "scene.accuracy = 1e-3\n")
  local most = 0
  for i = 1, 300 do
    scene:advance(1 / 100)
    most = math.max(most, scene.stats.sub_steps)
  end
  expect(most):below(17)
  expect(scene:find("p").position.x):near(math.cos(2 * math.pi * scene.time), 3e-3)
  expect(#scene.log):equal(0)
end)

test("an accuracy that the most sub-steps do not give is told", function()
  local scene = open_text(oscillator .. "scene.accuracy = 1e-9\n")
  scene:advance(0.5)
  expect(scene.log[1].text):equal("scene.accuracy is not reached: not even the most sub-steps are enough")
end)

test("a stiff impact within a step is seen before it, so that what meets exchanges velocities", function()
  local function second(settings)
    local scene = open_text([[
      scene.gravity = vec(0, 0, 0)
      local balls = scene:family "balls"
      scene:interact(balls, balls, force.pair {
        cutoff = 0.2,
        potential = function(r) return 1e6 / 2 * (0.2 - r) ^ 2 end,
      })
      scene:particle { family = balls, velocity = vec(1, 0, 0) }
      scene:particle { family = balls, at = vec(0.5017, 0, 0), name = "second" }
    ]] .. settings)
    scene:advance(1)
    return scene:find("second").velocity.x
  end
  expect(second "scene.accuracy = 1e-3"):near(1, 1e-3)
  expect(second ""):above(2)
end)
