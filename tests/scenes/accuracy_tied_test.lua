--- scene.accuracy of what is tied, when something happens to it in the middle of a run: kept, or told to be missed.

--- Angle from the line down, and its rate, of a pendulum of 1 m after `time` [s] in `g(t, angle)` [m/s²] along x and down, by
--- Runge and Kutta's fourth-order steps.
local function swing(angle, rate, from, to, g)
  local steps = 20000
  local h = (to - from) / steps
  local function turned(t, a)
    local side, down = g(t, a)
    return side * math.cos(a) - down * math.sin(a)
  end
  for n = 0, steps - 1 do
    local t = from + n * h
    local k1, l1 = rate, turned(t, angle)
    local k2, l2 = rate + h / 2 * l1, turned(t + h / 2, angle + h / 2 * k1)
    local k3, l3 = rate + h / 2 * l2, turned(t + h / 2, angle + h / 2 * k2)
    local k4, l4 = rate + h * l3, turned(t + h, angle + h * k3)
    angle, rate = angle + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4), rate + h / 6 * (l1 + 2 * l2 + 2 * l3 + l4)
  end
  return angle, rate
end

local rod = [[
  local p = scene:particle { mass = 1, at = vec(0, -1, 0), name = "p" }
  scene:rod(p, vec(0, 0, 0))
]]
local earth = function() return 0, 9.81 end
local time = 1.5  -- s

local cases = {
  { name = "a kick", text = rod .. [[scene:at(0.55, function() scene:find("p"):kick(vec(20, 0, 0)) end)]],
    angle = function() return swing(0, 20, 0.55, time, earth) end },
  { name = "another velocity", text = rod .. [[scene:at(0.55, function() scene:find("p").velocity = vec(-12, 0, 0) end)]],
    angle = function() return swing(0, -12, 0.55, time, earth) end },
  { name = "gravity to another side", text = rod .. [[scene:at(0.55, function() scene.gravity = vec(300, -9.81, 0) end)]],
    angle = function() return swing(0, 0, 0.55, time, function() return 300, 9.81 end) end },
  { name = "a nail that begins to shake", text = [[
      local q = scene:particle { mass = 1, at = vec(0, 0, 0), name = "q" }
      local p = scene:particle { mass = 1, at = vec(0, -1, 0), name = "p" }
      local nail = scene:follow(q, vec(0, 0, 0))
      scene:rod(p, q)
      scene:at(0.55, function() nail.target = function(t) return vec(0.1 * math.sin(40 * (t - 0.55)), 0, 0) end end)
    ]],
    angle = function()
      return swing(0, -4, 0.55, time, function(t) return 160 * math.sin(40 * (t - 0.55)), 9.81 end)
    end },
  { name = "a string that goes taut", text = [[
      local p = scene:particle { mass = 1, at = vec(0.3, 0, 0), name = "p" }
      scene:string({ p, vec(0, 0, 0) }, { length = 1 })
    ]],
    angle = function()
      local down = math.sqrt(0.91)
      local taut = math.sqrt(2 * down / 9.81)
      return swing(math.atan(0.3, down), -9.81 * taut * 0.3, taut, time, earth)
    end },
}

for _, case in ipairs(cases) do
  test("accuracy of what is tied is kept, or missed aloud: " .. case.name, function()
    local angle = case.angle()
    for _, accuracy in ipairs { 1e-3, 1e-4, 1e-5, 1e-6 } do
      local scene = open_text("scene.step, scene.accuracy = 1 / 60, " .. accuracy .. "\n" .. case.text)
      scene:advance(time)
      local p, q = scene:find "p", scene:find "q"
      local place = q and p.position - q.position or p.position
      local missed = (place - vec(math.sin(angle), -math.cos(angle), 0)):length()
      expect(missed):below(2 * time * math.max(accuracy, scene.stats.missed_accuracy))
    end
  end)
end

test("a motor whose speed jumps within a step turns as far as it says, or tells by how much it misses", function()
  for _, jump in ipairs { 0.337, 0.5, 0.721 } do
    for _, accuracy in ipairs { 1e-2, 1e-4 } do
      local scene = open_text(([[
        scene.gravity, scene.step, scene.accuracy = vec(0, 0, 0), 1 / 60, %g
        local arm = scene:body { mass = 1, inertia = vec(1, 2, 3), points = { nail = vec(0, 0, 0), tip = vec(1, 0, 0) },
                                 name = "arm" }
        scene:motor(arm, { axis = vec(0, 0, 1), name = "motor", speed = function(t) return where(t < %g, 0, 10) end })
      ]]):format(accuracy, jump))
      scene:advance(1)
      local missed = math.abs(scene:find("motor").turned - 10 * (1 - jump))
      expect(missed):below(2 * math.max(accuracy, scene.stats.missed_accuracy))
    end
  end
end)

test("a kick in the second step of a rod's life is seen as in any other", function()
  local scene = open_text("scene.step, scene.accuracy = 1 / 64, 1e-4\n" .. rod
    .. [[scene:at(1 / 64, function() scene:find("p"):kick(vec(50, 0, 0)) end)]])
  scene:advance(1 / 32)
  local angle = swing(0, 50, 1 / 64, 1 / 32, earth)
  local missed = (scene:find("p").position - vec(math.sin(angle), -math.cos(angle), 0)):length()
  expect(missed):below(2 * math.max(1e-4, scene.stats.missed_accuracy) / 32)
end)

test("a force that stays as it is makes as small an error on a rod as gravity does", function()
  local angle = swing(0, 0, 0, 1, function() return 1000, 9.81 end)
  for _, accuracy in ipairs { 1e-2, 1e-3, 1e-4 } do
    local scene = open_text("scene.step, scene.accuracy = 1 / 64, " .. accuracy .. "\n" .. rod
      .. "scene:field(scene, force.point { potential = function(p) return -1000 * p.position.x end })")
    scene:advance(1)
    local missed = (scene:find("p").position - vec(math.sin(angle), -math.cos(angle), 0)):length()
    expect(missed):below(2 * math.max(accuracy, scene.stats.missed_accuracy))
  end
end)

test("a step that had to be cut to be solved is judged as others are", function()
  local angle = swing(0, 0, 0, 0.125, function(_, a)
    local x, y = 2 - math.sin(a), math.cos(a)
    local r = math.sqrt(x * x + y * y)
    local pull = 1e4 * (r - 1) / r
    return pull * x, 9.81 - pull * y
  end)
  local scene = open_text("scene.step, scene.accuracy = 1 / 64, 1e-3\n" .. rod
    .. "scene:connect(p, vec(2, 0, 0), force.spring { stiffness = 1e4, length = 1 })")
  scene:advance(0.125)
  local missed = (scene:find("p").position - vec(math.sin(angle), -math.cos(angle), 0)):length()
  expect(missed):below(2 * math.max(1e-3, scene.stats.missed_accuracy))
end)

test("a stiff spring whose law knows the time is divided with the scene's steps where an accuracy is wanted", function()
  local function place(settings)
    local scene = open_text("scene.gravity = vec(0, 0, 0) " .. settings .. [[
      local p = scene:particle { mass = 1, at = vec(1, 0, 0), name = "p" }
      scene:connect(p, vec(0, 0, 0), force.pair { implicit = scene.integrator ~= "rk4",
        tension = function(r, rate, a, b, own, t) return 1e4 * (r - 1) + 300 * math.sin(60 * t) end })
    ]])
    scene:advance(0.5)
    return scene:find("p").position.x, scene.stats.missed_accuracy
  end
  local fine = place "scene.step, scene.integrator = 1 / 20000, 'rk4'"
  local x, missed = place "scene.step, scene.accuracy = 1 / 60, 1e-4"
  expect(math.abs(x - fine)):below(2 * 0.5 * math.max(1e-4, missed))
end)

test("a target that begins to move at once within a step is followed as well as is asked, or what is missed is told", function()
  for _, kink in ipairs { 12.1, 12.27, 12.5, 12.71, 12.93 } do
    local from = kink / 64
    local angle = swing(0, -20, from, 0.25, earth)  -- in the frame of the target, which goes at 20 m/s
    local place = vec(20 * (0.25 - from) + math.sin(angle), -math.cos(angle), 0)
    for _, accuracy in ipairs { 1e-2, 1e-3, 1e-5 } do
      local scene = open_text(([[
        scene.step, scene.accuracy = 1 / 64, %g
        local pivot = scene:particle { mass = 1, at = vec(0, 0, 0) }
        local bob = scene:particle { mass = 1, at = vec(0, -1, 0), name = "bob" }
        scene:rod(pivot, bob)
        scene:follow(pivot, function(t) return vec(where(t < %.17g, 0, 20 * (t - %.17g)), 0, 0) end)
      ]]):format(accuracy, from, from))
      scene:advance(0.25)
      local missed = (scene:find("bob").position - place):length()
      expect(missed):below(2 * 0.25 * math.max(accuracy, scene.stats.missed_accuracy))
    end
  end
end)

test("a mechanism that is held at rest has no energy error, at height 0 and without gravity, too", function()
  for _, gravity in ipairs { "vec(0, -9.81, 0)", "vec(0, 0, 0)" } do
    for _, ties in ipairs { "scene:orient(a)", "local z = vec(0, 0, 1) scene:motor(a, { axis = z, angle = 0 }) scene:align(a, z, z, { angle = 0 })" } do
      local scene = open_text(("scene.gravity = %s\n"):format(gravity) .. [[
        local a = scene:body { mass = 2, inertia = vec(1, 1, 1), at = vec(0.5, 0, 0), points = { o = vec(-0.5, 0, 0) } }
        scene:nail(a.o)
      ]] .. ties)
      scene:advance(1)
      expect(scene.error.worst_energy):below(1e-6)
    end
  end
end)

test("planets about a nailed sun take the sub-steps of planets about a free one", function()
  for _, at in ipairs { 0, 1, 1000 } do
    local scene = open_text(([[
      scene.gravity, scene.accuracy = vec(0, 0, 0), 1e-4
      local family = scene:family("planets", {})
      local o = vec(%g, 0, 0)
      scene:nail(scene:particle { family = family, mass = 1000, at = o })
      for i = 1, 3 do
        scene:particle { family = family, mass = 1, at = o + vec(i, 0, 0), velocity = vec(0, i ^ -0.5, 0) }
      end
      scene:interact(family, family, force.gravitation { constant = 1e-3 })
    ]]):format(at))
    scene:advance(5)
    expect(scene.stats.most_sub_steps):equal(1)
    expect(scene.stats.missed_accuracy):equal(0)
    expect(scene.stats.fallback_steps):equal(0)
  end
end)

test("a force of time on what is held is no error", function()
  local scene = open_text [[
    scene.gravity, scene.accuracy = vec(0, 0, 0), 1e-4
    scene:nail(scene:particle { mass = 1, at = vec(1, 0, 0) })
    scene:follow(scene:particle { mass = 1, at = vec(2, 0, 0) }, function(t) return vec(2, 0.1 * t, 0) end)
    scene:on_plane(scene:particle { mass = 1, at = vec(3, 0, 0) }, { normal = vec(1, 0, 0) })
    scene:field(scene, force.point { force = function(p, own, t) return vec(60 * math.cos(25 * t), 0, 0) end })
  ]]
  scene:advance(1)
  expect(scene.stats.most_sub_steps):equal(1)
  expect(scene.stats.missed_accuracy):equal(0)
end)

test("what a plane holds takes the sub-steps of what moves in it freely", function()
  local function run(tie)
    local scene = open_text([[
      scene.gravity, scene.accuracy = vec(0, 0, 0), 1e-4
      local p = scene:particle { mass = 1, at = vec(1, 0, 0), velocity = vec(0, 0.7, 0), name = "p" }
      scene:field(scene, force.point {
        potential = function(q) return 4 * q.position.x ^ 4 + 30 * q.position.y ^ 4 end })
    ]] .. tie)
    scene:advance(4)
    return scene
  end
  local held, free = run "scene:on_plane(p, { normal = vec(0, 0, 1) })", run ""
  expect(held.stats.most_sub_steps):equal(free.stats.most_sub_steps)
  expect(held.stats.missed_accuracy):equal(0)
  expect(held:find("p").position):near(free:find("p").position, 1e-12)
end)
