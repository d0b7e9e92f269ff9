-- Steps of fourth order, and sub-steps chosen by the wanted error.
local function wheel(settings)
  return open_text(settings .. [[
    scene.gravity = vec(0, 0, 0)
    scene:body { mass = 1, inertia = vec(1, 1.5, 2), spin = vec(0, 0, 50), name = "wheel" }
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
  local fixed, accurate = wheel "", wheel "scene.accuracy = 1e-6\n"
  expect(lag(fixed)):near(50 * (50 / 240) ^ 4 / 120, 3e-5)
  expect(lag(accurate)):below(1e-6)
  expect(fixed.stats.most_sub_steps):equal(1)
  expect(fixed.stats.most_sub_steps_of):equal("")
  expect(accurate.stats.most_sub_steps):above(7)
  expect(accurate.stats.most_sub_steps_of):equal("body 'wheel'")
  expect(accurate.stats.sub_steps):equal(1)
end)

local function two_links(settings)
  local scene = open_text(settings .. [[
    local a = scene:body { mass = 1, inertia = vec(0.002, 0.08, 0.08), at = vec(0.5, 0, 0),
      points = { head = vec(-0.5, 0, 0), tail = vec(0.5, 0, 0) } }
    local b = scene:body { mass = 1, inertia = vec(0.002, 0.08, 0.08), at = vec(1.5, 0, 0), name = "end",
      points = { head = vec(-0.5, 0, 0), tail = vec(0.5, 0, 0) } }
    scene:nail(a.head)
    scene:hinge(a.tail, b.head)
  ]])
  scene:advance(1)
  return scene
end
local function place(settings) return two_links(settings):find("end").position end

test("suzuki4 swings two links a thousand times closer than verlet does", function()
  local exact = place 'scene.step, scene.integrator = 1 / 1000, "suzuki4"\n'
  local second = (place "scene.step = 1 / 120\n" - exact):length()
  local fourth = (place 'scene.step, scene.integrator = 1 / 120, "suzuki4"\n' - exact):length()
  expect(fourth):below(second / 1000)
end)

test("adaptive swings them as near at any step, by few evaluations, and keeps the energy to what is asked", function()
  local exact = place 'scene.step, scene.integrator = 1 / 2000, "suzuki4"\n'
  for _, step in ipairs { "1 / 10", "1 / 60", "1 / 1000" } do
    local scene = two_links("scene.step, scene.integrator = " .. step .. ', "adaptive"\n')
    expect((scene:find("end").position - exact):length()):below(1e-7)
    expect(scene.error.energy):below(1e-6)
    expect(scene.stats.evaluations):above(100)
    expect(scene.stats.evaluations):below(600)
  end
  local loose = two_links 'scene.step, scene.integrator, scene.accuracy = 1 / 10, "adaptive", 1e-2\n'
  expect((loose:find("end").position - exact):length()):below(1e-2)
  expect(loose.stats.evaluations):below(200)
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
  local said = scene.log[1].text
  expect(said:find("scene.accuracy is not reached: 256 sub-steps of a step of 0.01 s leave an error of ", 1, true) ~= nil):is_true()
  expect(said:find("spring would need a shorter scene.step", 1, true) ~= nil):is_true()
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

test("a step that is done again, more finely, begins with the momenta that contacts changed of what is tied", function()
  local scene = open_text [[
    scene.accuracy = 1e-4
    scene:floor { height = -1.2, friction = 0.5 }
    local last
    for i = 1, 3 do
      local link = scene:box { size = vec(1, 0.2, 0.2), at = vec(i - 0.5, 0, 0), points = { head = vec(-0.5, 0, 0), tail = vec(0.5, 0, 0) } }
      if last then scene:hinge(last.tail, link.head) else scene:nail(link.head) end
      last = link
    end
    local fixed, bob = scene:particle { at = vec(0, 3, 0) }, scene:particle { at = vec(1, 3, 0) }
    scene:nail(fixed)
    scene:connect(fixed, bob, force.pair { potential = function(r) return 100 * (r - 1) ^ 2 end })
    for k = 1, 20 do
      scene:at(0.37 + 0.05 * k, function() bob:kick(vec(0.3, 0.2, 0) * k) end)
    end
  ]]
  local _ = scene.ledger
  scene:advance(1)
  expect(scene.stats.rejected_steps):above(0)
  expect(scene.ledger.closure):below(1e-10)
  expect(scene.error.worst_energy):below(1e-6)
end)

--- The largest difference of what holds a pendulum from its closed form m g cos + m v²/l, over the first of two seconds.
local function wrong_load(tie, settings)
  local scene = open_text([[
    local bob = scene:particle { at = vec(0.2, -math.sqrt(2.21), 0), name = "bob" }
    scene:field(scene, force.point { potential = function(p) return 10 * p.position.y end })
  ]] .. settings .. tie)
  local bob, tie, worst, _ = scene:find "bob", scene:find "tie", 0, scene.ledger
  for i = 1, 240 do
    scene:advance(1 / 240)
    local load = type(tie.force) == "number" and tie.force or tie.force:length()
    local p, v = bob.position, bob.velocity
    worst = math.max(worst, math.abs(load - (9.81 + 10) * -p.y / p:length() - v:dot(v) / 1.5))
  end
  expect(scene.error.worst_energy):below(1e-4)
  expect(scene.ledger.closure):below(1e-10)
  return worst
end

test("what is taut bears what a pendulum's rod does from the first step on, with sub-steps as without", function()
  for _, tie in ipairs {
    'scene:rod(bob, vec(0, 0, 0)).name = "tie"',
    'scene:string({ vec(0, 0, 0), bob }, { length = 1.5, name = "tie" })',
    'scene:limit(bob, vec(0, 0, 0), { max = 1.5, name = "tie" })',
  } do
    for _, accuracy in ipairs { "nil", "1e-3", "1e-4", "1e-5", "1e-6" } do
      expect(wrong_load(tie, "scene.accuracy = " .. accuracy .. "\n")):below(0.01)
    end
  end
end)

test("a string that goes taut stops what it stops for good, whatever sub-steps there are", function()
  for _, accuracy in ipairs { "nil", "1e-3", "1e-6" } do
    local scene = open_text("scene.accuracy = " .. accuracy .. [[
      scene.gravity = vec(0, 0, 0)
      local bob = scene:particle { at = vec(0, -1, 0), velocity = vec(0.3, -2, 0), name = "bob" }
      scene:string({ vec(0, 0, 0), bob }, { length = 1.5 })
      scene:field(scene, force.point { potential = function(p) return 0.1 * p.position.x end })
    ]])
    scene:advance(0.5)
    local p, v = scene:find("bob").position, scene:find("bob").velocity
    expect(p:length()):near(1.5, 1e-9)
    expect(v:dot(p)):near(0, 1e-6)
    expect(v:length()):below(0.8)
    expect(scene.ledger.limit):below(-1.5)
    expect(scene.error.worst_energy):below(1e-3)
  end
end)

test("where forces are too large for the step, what is told names scene.accuracy", function()
  local scene = open_text [[
    scene:particle { at = vec(0.01, 0, 0) }
    scene:field(scene, force.point { potential = function(p) return 1e7 * p.position.x ^ 2 end })
  ]]
  expect(function() scene:advance(1) end):fails "scene.accuracy = 1e-4 would choose sub-steps by the error that they make; the scene is stopped"
end)

test("a kick or a spin that is given in flight is had by a tree that moves by itself", function()
  for how, give in ipairs { "b:kick(vec(0, 0, 3))", "b.spin = vec(1, 2, 3)", "b.velocity = vec(0, 1, 1)", "b.c:kick(vec(0, 0, 3))" } do
    local told = {}
    for i, integrator in ipairs { "adaptive", "verlet" } do
      local scene = open_text(("scene.step, scene.integrator = 1 / 240, %q\n"):format(integrator) .. [[
        scene.gravity = vec(0, 0, 0)
        local a = scene:body { mass = 2, inertia = vec(0.1, 0.2, 0.3), at = vec(0.5, 0, 0), points = { e = vec(0.5, 0, 0) } }
        local b = scene:body { mass = 1, inertia = vec(0.1, 0.2, 0.3), at = vec(1.5, 0, 0), points = { c = vec(-0.5, 0, 0) } }
        scene:hinge(a.e, b.c)
        scene:at(0.4, function() ]] .. give .. " end)")
      scene:advance(1)
      expect(scene.error.worst_energy):below(1e-6)
      told[i] = { scene.angular_momentum, scene.energy.kinetic }
    end
    expect((told[1][1] - told[2][1]):length()):below(1e-6)
    expect(told[1][2]):near(told[2][2], 1e-3 * told[2][2])
    if how == 1 then
      expect(told[1][1].y):near(-4.5, 1e-12)
      expect(told[1][2]):near(3.375, 1e-12)
    end
  end
end)
