--- A scene in which something cannot be, beside a pendulum that must not notice. Returns it after three seconds.
local function beside(code)
  local pendulum = [[
    local bob = scene:particle { at = vec(5, -1, 2), name = "bob" }
    scene:rod(bob, vec(4, 0, 0))
    local bar = scene:body { mass = 1, inertia = vec(0.02, 0.1, 0.1), name = "bar",
                             points = { left = vec(-0.5, 0, 0), right = vec(0.5, 0, 0) } }
  ]]
  local alone, scene = open_text(pendulum), open_text(pendulum .. code)
  alone:advance(3)
  scene:advance(3)
  expect(scene:find("bob").position):equal(alone:find("bob").position)
  expect(scene:find("bob").velocity):equal(alone:find("bob").velocity)
  return scene
end

local function warnings(scene)
  local texts = {}
  for _, line in ipairs(scene.log) do
    if line.kind == "warning" then texts[#texts + 1] = line.text end
  end
  return texts
end

local function is_told(code, what)
  local scene = beside(code)
  local told = warnings(scene)
  expect(#told):equal(1)
  expect(told[1]:find(what) ~= nil):is_true()
  expect(told[1]:find "cannot be kept" ~= nil):is_true()
  expect(scene.stats.fallback_steps):above(0)
end

test("nails further apart than the body between them are told, once, by name", function()
  is_told([[
    scene:nail(bar.left, { name = "first" })
    scene:nail(bar.right, vec(3, 0, 0), { name = "second" })
  ]], "nail '%a+'")
end)

test("so is a rod of a length that no loop can have", function()
  is_told([[
    scene:nail(bar.left)
    local strut = scene:rod(bar.right, vec(-0.5, 0, 0))
    strut.length, strut.name = 2, "strut"
  ]], "cannot be kept")
end)

test("and a body that is to keep two orientations", function()
  is_told([[
    scene:orient(bar, { name = "one" })
    scene:orient(bar, quat(vec(0, 0, 1), 1), { name = "other" })
  ]], "orient '%a+'")
end)

test("a chain pulled further than it reaches is told, and forgiven when it comes back", function()
  local scene = beside [[
    scene:nail(bar.left)
    scene:follow(bar.right, function(t) return vec(t < 1 and 0.5 + t or math.max(0.5, 2.5 - t), 0, 0) end)
  ]]
  expect(#warnings(scene)):equal(1)
  expect(scene.error.constraint):below(1e-10)
end)

--- A body that a motor turns against a limit; `most` is its torque.
local function against_limit(most)
  return open_text("local most = " .. most .. [[
    scene.gravity = vec(0, 0, 0)
    local body = scene:body { mass = 1, inertia = vec(0.1, 0.1, 0.1), name = "body" }
    scene:motor(body, { axis = vec(0, 0, 1), speed = 2, max_torque = most, name = "motor" })
    scene:limit(body, { axis = vec(0, 0, 1), min = -1, max = 1, name = "limit" })
    local _ = scene.ledger.closure
  ]])
end

test("a motor that meets a limit stands there, whatever its torque, and books what it did", function()
  for _, most in ipairs { "nil", "1", "5", "100", "1e5", "1e12" } do
    local scene = against_limit(most)
    scene:advance(1)
    expect(scene:find("limit").value):near(1, 1e-9)
    expect(scene:find("body").spin:length()):below(1e-9)
    expect(scene.stats.fallback_steps + scene.stats.halved_steps):equal(0)
    local setting_out = most == "nil" and 0 or 0.5 * 0.1 * 2 ^ 2  -- one without a limit turns from the start
    expect(scene.ledger.motor):near(setting_out, 0.01)
    expect(scene.ledger.limit):near(-0.5 * 0.1 * 2 ^ 2, 0.01)  -- the meeting takes all motion
    expect(scene.ledger.closure):below(1e-10)
    expect(scene.error.worst_energy):below(1e-9)
    local told = warnings(scene)
    expect(#told):equal(most == "nil" and 1 or 0)
    if most == "nil" then expect(told[1]):equal "motor 'motor' stalls: limit 'limit' does not let it turn" end
    scene:find("motor").speed = -1
    scene:advance(1.5)
    expect(scene:find("limit").value):near(-0.5, most == "1" and 0.1 or 0.02)
  end
end)

test("a motor that stalls exerts what it can, and the limit bears it", function()
  for _, most in ipairs { 1, 100, 1e5 } do
    local scene = against_limit(most)
    scene:advance(1)
    local function about_z(torque) return type(torque) == "number" and torque or torque.z end
    expect(about_z(scene:find("motor").torque)):near(most, 1e-6 * most)
    expect(about_z(scene:find("limit").torque)):near(-most, 1e-6 * most)
  end
end)

test("of two motors the one that can exert less yields", function()
  local scene = open_text [[
    scene.gravity = vec(0, 0, 0)
    local body = scene:body { mass = 1, inertia = vec(0.1, 0.1, 0.1), name = "body" }
    scene:motor(body, { axis = vec(0, 0, 1), speed = 2 })
    scene:motor(body, { axis = vec(0, 0, 1), speed = -3, max_torque = 1e4, name = "weak" })
    local _ = scene.ledger
  ]]
  scene:advance(1)
  expect(scene:find("body").spin.z):near(2, 1e-6)
  expect(scene.stats.fallback_steps):equal(0)
  expect(scene.ledger.closure):below(1e-10)
end)

test("a crank stands while a limit holds the rocker that it moves, and turns back", function()
  local told = 0
  for _, most in ipairs { "nil", "50", "1e3", "1e5" } do
    local scene = open_text("local most, _ = " .. most .. ", scene.ledger" .. [[

      scene.plane = "xy"
      local function bar(from, to, name)
        local d = (to - from) / 2
        return scene:body { at = (from + to) / 2, mass = 1, inertia = vec(0.1, 0.1, 0.1), name = name,
                            points = { a = -d, b = d } }
      end
      local A, B, C, D = vec(0, 0, 0), vec(0, 0.5, 0), vec(2, 1.2, 0), vec(2, 0, 0)
      local crank, rod, rocker = bar(A, B, "crank"), bar(B, C, "rod"), bar(C, D, "rocker")
      scene:nail(crank.a)
      scene:nail(rocker.b)
      scene:hinge(crank.b, rod.a)
      scene:hinge(rod.b, rocker.a)
      scene:motor(crank, { axis = vec(0, 0, 1), speed = -2, max_torque = most, name = "motor" })
      scene:limit(rocker, { axis = vec(0, 0, 1), min = -0.3, max = 0.3, name = "limit" })
    ]])
    scene:advance(2)
    expect(scene:find("limit").value):near(-0.3, 1e-9)
    expect(scene:find("crank").spin:length()):below(1e-9)
    expect(scene.error.constraint):below(1e-10)
    expect(scene.stats.fallback_steps):equal(0)
    expect(scene.ledger.closure):below(1e-12)
    expect(scene.error.worst_energy):below(1e-6)
    told = told + #warnings(scene)
    if most == "nil" then expect(warnings(scene)[1]):equal "motor 'motor' stalls: limit 'limit' does not let it turn" end
    scene:find("motor").speed = 2
    scene:advance(0.1)
    expect(scene:find("crank").spin.z):near(2, 1e-6)
  end
  expect(told):equal(1)
end)

test("what contradicts itself books no more work than the motion can have, and closes", function()
  local bar = [[
    scene.gravity = vec(0, 0, 0)
    local bar = scene:body { mass = 1, inertia = vec(0.02, 0.1, 0.1), spin = vec(0, 0, 1),
                             points = { left = vec(-0.5, 0, 0), right = vec(0.5, 0, 0) } }
    local _ = scene.ledger.closure
  ]]
  for _, code in ipairs {
    "scene:nail(bar.left) scene:nail(bar.right, vec(3, 0, 0))",
    "scene:nail(bar.left) scene:rod(bar.right, vec(-0.5, 0, 0)).length = 2",
    "scene:orient(bar) scene:orient(bar, quat(vec(0, 0, 1), 1))",
    "scene:follow(bar.left, function(t) return vec(t - 0.5, 0, 0) end) scene:follow(bar.right, function(t) return vec(0.5, 0, t) end)",
    "scene:nail(bar.left) scene:follow(bar.right, function(t) return vec(t < 1 and 0.5 + t or math.max(0.5, 2.5 - t), 0, 0) end)",
  } do
    local scene = open_text(bar .. code)
    scene:advance(3)
    expect(math.abs(scene.ledger.hand)):below(100)
    expect(math.abs(scene.ledger.motor)):below(1)
    expect(math.abs(scene.ledger.fallback_step)):below(100)
    expect(scene.ledger.closure):below(1e-10)
    expect(scene.error.worst_energy):below(1.1)
  end
end)

test("a scene at rest has no error of its energy", function()
  local scene = open_text [[
    local left, right = scene:particle { at = vec(0, 0, 3) }, scene:particle { at = vec(2, 0, 3) }
    local middle = scene:particle { at = vec(1, 0, 2) }
    scene:nail(left)
    scene:nail(right)
    scene:rod(left, middle)
    scene:rod(right, middle)
  ]]
  scene:advance(1)
  expect(scene.error.worst_energy):below(1e-6)
end)

test("a chain that is taut between two nails takes one fallback step a step", function()
  local scene = open_text [[
    local last
    for n = 1, 10 do
      local link = scene:body { mass = 1, inertia = vec(0.01, 0.1, 0.1), at = vec(n - 0.5, 0, 0),
                                points = { a = vec(-0.5, 0, 0), b = vec(0.5, 0, 0) } }
      if last then scene:hinge(last.b, link.a) else scene:nail(link.a) end
      last = link
    end
    scene:nail(last.b)
  ]]
  scene:advance(2)
  expect(scene.stats.steps):equal(480)
  expect(scene.stats.fallback_steps):below(1.1 * 480)
  expect(scene.stats.newton_iterations):below(100 * 480)
  expect(scene.error.constraint):below(1e-8)
end)

test("what swings on a string goes on swinging while something else in its articulate contradicts itself", function()
  local function swing(code)
    local scene = open_text([[
      local bar = scene:body { mass = 1, inertia = vec(0.1, 0.1, 0.1), points = { c = vec(0, 0, 0), l = vec(-1, 0, 0) } }
      scene:nail(bar.c)
      scene:orient(bar)
      local ball = scene:particle { at = vec(0.5, -math.sqrt(0.75), 0), velocity = vec(0, 0, 1), name = "ball" }
      scene:string({ bar.c, ball }, { length = 1 })
    ]] .. code)
    scene:advance(2)
    return scene
  end
  local sound, torn = swing "", swing "scene:orient(bar, quat(vec(0, 0, 1), 1))"
  expect(sound.stats.fallback_steps):equal(0)
  expect(torn.stats.fallback_steps):above(400)
  local function energy(scene)
    local ball = scene:find "ball"
    return 0.5 * ball.velocity:dot(ball.velocity) + 9.81 * ball.position.y
  end
  expect(energy(torn)):near(energy(sound), 0.03)
  expect((torn:find("ball").position - sound:find("ball").position):length()):below(0.03)
end)

test("fallback steps of a taut chain whose end trembles only lose energy", function()
  for _, step in ipairs { 1 / 60, 1 / 240 } do
    local scene = open_text("scene.step = " .. step .. [[

      local last
      for n = 1, 6 do
        local link = scene:body { mass = 1, inertia = vec(0.0017, 0.0842, 0.0842), at = vec(n - 0.5, 0, 0),
                                  points = { a = vec(-0.5, 0, 0), e = vec(0.5, 0, 0) } }
        if last then scene:hinge(last.e, link.a) else scene:nail(link.a) end
        last = link
      end
      scene:follow(last.e, function(t) return vec(6 - 1e-6 + 1e-6 * math.sin(9 * t), 0, 0) end)
      local _ = scene.ledger
    ]])
    local before = 0
    for _ = 1, math.floor(2 / step) do
      scene:step()
      local now = scene.ledger.fallback_step
      expect(now):below(before + 1e-12)
      before = now
    end
    expect(scene.stats.fallback_steps):above(0)
    expect(scene.ledger.closure):below(1e-10)
  end
end)

test("a free loop that contradicts itself flies on as it flew", function()
  local scene = open_text [[
    scene.gravity = vec(0, 0, 0)
    local function bar(x, name)
      return scene:body { mass = 1, inertia = vec(0.02, 0.1, 0.1), at = vec(x, 0, 0), name = name, velocity = vec(1, 2, 3),
                          spin = vec(0, 0, x), points = { a = vec(-0.5, 0, 0), b = vec(0.5, 0, 0) } }
    end
    local one, other = bar(-0.5, "one"), bar(0.5, "other")
    scene:hinge(one.b, other.a)
    scene:rod(one.a, other.b).length = 3
  ]]
  local p, L = scene.momentum, scene.angular_momentum
  for _ = 1, 240 do
    scene:step()
    expect((scene.momentum - p):length()):below(1e-12 * p:length())
    expect((scene.angular_momentum - L):length()):below(1e-11)
  end
  expect(scene.stats.fallback_steps):above(100)
end)

test("what contradicts itself moves on with noise elsewhere, which has each step in two halves", function()
  local scene = open_text [[
    scene.gravity = vec(0, 0, 0)
    local a = scene:particle { at = vec(0, 0, 0), mass = 1, velocity = vec(1, 0, 0), name = "a" }
    local b = scene:particle { at = vec(1, 0, 0), mass = 1, velocity = vec(1, 0, 0), name = "b" }
    scene:rod(a, b).length = 1.2
    scene:rod(a, b).length = 0.8
    scene:particle { at = vec(9, 9, 9), mass = 1 }
    scene:field(scene, force.thermostat { temperature = 1e-12, rate = 1e-12 })
  ]]
  scene:advance(1)
  expect(scene.stats.fallback_steps):above(scene.stats.steps)
  local middle = (scene:find("a").position + scene:find("b").position) / 2
  expect(middle):near(vec(1.5, 0, 0), 1e-9)
end)

test("a spring too stiff to be solved is named, once", function()
  local scene = open_text [[
    local function particle(x) return scene:particle { at = vec(x, 0, 0), mass = 1 } end
    scene:connect(particle(0), particle(1), force.spring { stiffness = 1e13, length = 1.01, name = "girder" })
  ]]
  scene:advance(1)
  expect(scene.stats.fallback_steps):above(0)
  expect(#warnings(scene)):equal(1)
  expect(warnings(scene)[1]:find("is too stiff for the step", 1, true) ~= nil):equal(true)
end)

test("a chain drawn straight between two nails is told, by what bears most; with a millimetre of slack it is not", function()
  for slack, told in pairs { [0] = 1, [0.001] = 0 } do
    local scene = open_text(([[
      local previous
      for i = 1, 12 do
        local plank = scene:box { size = vec(0.5, 0.06, 1), at = vec(0.5 * i, 0, 0), density = 600,
                                  points = { l = vec(-0.25, 0, 0), r = vec(0.25, 0, 0) } }
        if previous then scene:hinge(previous.r, plank.l) else scene:nail(plank.l, vec(0.25 + %g, 0, 0)) end
        previous = plank
      end
      scene:nail(previous.r)
    ]]):format(slack))
    scene:advance(0.5)
    expect(#warnings(scene)):equal(told)
    if told == 1 then expect(warnings(scene)[1]:find("drawn straight between two nails", 1, true) ~= nil):equal(true) end
  end
end)

test("closing the gap of a hinge made over one is an edit, which leaves no energy error", function()
  local scene = open_text [[
    local a = scene:body { at = vec(0, 0, 0), mass = 1, inertia = vec(0.1, 0.1, 0.1),
                           points = { p = vec(0.5, 0, 0), q = vec(-0.5, 0, 0) } }
    local b = scene:body { at = vec(1.8, 0.5, 0), mass = 1, inertia = vec(0.1, 0.1, 0.1), velocity = vec(0, 3, 0),
                           spin = vec(0, 1, 4), points = { p = vec(-0.5, 0, 0) } }
    scene:nail(a.q)
    scene.tolerance = 1
    scene:hinge(a.p, b.p)
    local _ = scene.ledger
  ]]
  local before = scene.energy.total
  scene:advance(1)
  expect(scene.error.energy):below(1e-9)
  expect(scene.ledger.edit):near(scene.energy.total - before, 1e-9)
  expect(math.abs(scene.ledger.edit)):above(0.1)
end)

for _, tie in ipairs { "string { p, vec(0, 0, 0), vec(0.5, 0, 0), q }", "pulley(p, vec(0, 0, 0), vec(0.5, 0, 0), q)" } do
  test("a weight that is drawn to its anchor stays there, at rest: " .. tie:match "%a+", function()
    for _, steps in ipairs { 60, 240, 1000 } do
      local scene = open_text([[
        local p = scene:particle { mass = 3, at = vec(0, -1, 0), name = "p" }
        local q = scene:particle { mass = 1, at = vec(0.5, -1, 0), name = "q" }
        local rope = scene:]] .. tie .. [[
        scene:probe("tension", function() return rope.alive and rope.force or 0 end)
        scene:at(1.5, function() rope:remove() end)
      ]], { ["scene.step"] = 1 / steps })
      local _ = scene.ledger
      local p, q = scene:find "p", scene:find "q"
      scene:advance(1.2)
      expect(p.position):near(vec(0, -2, 0), 1e-4)
      expect(q.position):near(vec(0.5, 0, 0), 1e-6)
      expect(scene.energy.kinetic):below(1e-12)
      expect(scene:read "tension"):near(3 * 9.81, 1e-6)
      expect(scene.ledger.limit):near(-19.62, 3e-3)
      expect(scene.error.energy):below(1e-9)
      scene:advance(0.5)
      expect(q.position.y):near(-0.5 * 9.81 * 0.2 ^ 2, 1e-6)
    end
  end)
end

test("a heavy end of a string that is drawn to its anchor goes past it, and loses to the other what an impact takes", function()
  for _, steps in ipairs { 60, 240, 960 } do
    local scene = open_text([[
      scene.gravity = vec(0, 0, 0)
      local p = scene:particle { at = vec(1, 0, 0), velocity = vec(1, 0.5, 0), name = "p" }
      local q = scene:particle { mass = 1.2, at = vec(0, 0, 1), velocity = vec(0, 0, -1) }
      scene:string({ p, vec(0, 0, 0), q }, { length = 2 })
    ]], { ["scene.step"] = 1 / steps })
    local _ = scene.ledger
    scene:advance(2)
    expect(scene:find "p".position:cross(scene:find "p".velocity).z):near(0.5, 1e-9)
    expect(scene.energy.kinetic):near(0.0411, 2e-4)
    expect(scene.ledger.limit):near(scene.energy.kinetic - 0.625 - 0.6, 1e-6)
    expect(scene.error.energy):below(1e-6)
  end
end)

test("a weight that is drawn to its anchor lets the other swing about its own", function()
  for _, steps in ipairs { 60, 240, 960 } do
    local scene = open_text([[
      local p = scene:particle { mass = 1, at = vec(math.sin(1), -math.cos(1), 0), name = "p" }
      local q = scene:particle { mass = 1.2, at = vec(2, -1, 0), name = "q" }
      scene:pulley(p, vec(0, 0, 0), vec(2, 0, 0), q, { ratio = 2 })
    ]], { ["scene.step"] = 1 / steps })
    local p, q = scene:find "p", scene:find "q"
    scene:advance(1.1)
    local angle, rate = math.atan(p.position.x, -p.position.y), p.position:cross(p.velocity).z / 9
    for _ = 1, 1000 do
      rate = rate - 9.81 / 3 * math.sin(angle) * 0.4e-3
      angle = angle + rate * 0.4e-3
    end
    scene:advance(0.4)
    expect(q.position):near(vec(2, 0, 0), 1e-6)
    expect(p.position):near(vec(3 * math.sin(angle), -3 * math.cos(angle), 0), 0.6 / steps)
    expect(p.velocity):near(vec(3 * rate * math.cos(angle), 3 * rate * math.sin(angle), 0), 3 / steps)
  end
end)

test("what cannot move is not told to: a mass on two rods in one line", function()
  for _, steps in ipairs { 60, 240 } do
    local scene = open_text([[
      local p = scene:particle { name = "p" }
      scene:rod(p, vec(-1, 0, 0))
      scene:rod(p, vec(1, 0, 0))
    ]], { ["scene.step"] = 1 / steps })
    local p = scene:find "p"
    for _ = 1, 10 do
      local before = p.position
      scene:advance(0.1)
      expect((p.position - before):length()):below(2e-5)
      expect(p.velocity:length()):below(1e-3)
    end
  end
end)

test("what floats free and cannot be solved keeps its momenta, though it loses energy", function()
  local scene = open_text [[
    scene.gravity = vec(0, 0, 0)
    local heavy = scene:particle { at = vec(0, 0, 0), mass = 1 }
    local light = scene:particle { at = vec(1, 0, 0), mass = 1e-6, velocity = vec(0.3, 1, 0) }
    local stiff = force.pair { name = "stiff", potential = function(r, a, b, own) return 0.25 * own.k * (r * r - 1) ^ 2 end, parameters = { k = 1e13 } }
    scene:connect(heavy, light, stiff)
    local body = scene:body { at = vec(2, 3, 0), mass = 1, inertia = vec(1, 2, 3), spin = vec(0, 1, 0.5), points = { vec(0, -1, 0) } }
    local link = scene:body { at = vec(2, 1.5, 0), mass = 1e-6, inertia = vec(1, 2, 3) * 1e-6, spin = vec(3, 1, 0), points = { vec(0, 0.5, 0), vec(0, -0.5, 0) } }
    scene:hinge(body.points[1], link.points[1])
    local soft = force.pair { name = "soft", potential = function(r, a, b, own) return 0.5 * own.k * (r - 1) ^ 2 end, parameters = { k = 1e-4 } }
    scene:connect(link.points[2], light, soft)
  ]]
  local momentum, angular_momentum, energy = scene.momentum, scene.angular_momentum, scene.energy.total
  scene:advance(10)
  expect(scene.stats.fallback_steps):above(100)
  expect((scene.momentum - momentum):length()):below(1e-12)
  expect((scene.angular_momentum - angular_momentum):length()):below(1e-9)
  expect(scene.energy.total):below(energy * (1 + 1e-6))
end)
