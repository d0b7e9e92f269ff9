--- Damped springs that are solved with what they tie, at any stiffness and damping: they never give energy, and settle
--- as closed forms say or, where the step is too long to follow that, at once.

--- Advances by `steps`, expecting that the energy [J] never rises; returns those at the start and the end.
local function take_energy(scene, steps)
  local first = scene.energy.total
  local last, rise = first, 0
  for _ = 1, steps do
    scene:step()
    rise = math.max(rise, scene.energy.total - last)
    last = scene.energy.total
  end
  expect(rise / first):below(1e-12)
  return first, last
end

--- Two particles of 1 kg on a spring of 10 m, hω = `z` and damping ratio `zeta`, stretched by `q` [m] and parting at `v`
--- [m/s].
local function pair(step, z, zeta, q, v, implicit)
  local w, reduced = z / step, 0.5
  return open_text(([[
    scene.gravity, scene.step = vec(0, 0, 0), %.17g
    local a = scene:particle { mass = 1, velocity = vec(%.17g, 0, 0) }
    local b = scene:particle { mass = 1, at = vec(%.17g, 0, 0), velocity = vec(%.17g, 0, 0) }
    scene:connect(a, b, force.spring { stiffness = %.17g, damping = %.17g, length = 10 }, { implicit = %s })
    scene:probe("stretch", function() return b.position.x - a.position.x - 10 end)
    scene:probe("rate", function() return b.velocity.x - a.velocity.x end)
  ]]):format(step, -v / 2, 10 + q, v / 2, w * w * reduced, 2 * zeta * w * reduced, implicit))
end

--- Stretch [m] and rate [m/s] after a time [s], of angular frequency `w`.
local function closed_form(w, zeta, q, v, time)
  if zeta < 1 then
    local wd = w * math.sqrt(1 - zeta ^ 2)
    local sine = (v + zeta * w * q) / wd
    local decay, c, s = math.exp(-zeta * w * time), math.cos(wd * time), math.sin(wd * time)
    local at = decay * (q * c + sine * s)
    return at, -zeta * w * at + decay * wd * (sine * c - q * s)
  elseif zeta == 1 then
    local decay, slope = math.exp(-w * time), v + w * q
    return (q + slope * time) * decay, slope * decay - w * (q + slope * time) * decay
  end
  local fast = -w * (zeta + math.sqrt(zeta ^ 2 - 1))
  local slow = w * w / fast
  local part = (v - slow * q) / (fast - slow)
  local a, b = (q - part) * math.exp(slow * time), part * math.exp(fast * time)
  return a + b, slow * a + fast * b
end

test("a damped spring loses energy as its closed form says, and never gains any, at every hω and h c/m", function()
  local step = 1 / 60
  for _, implicit in ipairs { "true", "'dissipative'" } do
    for _, z in ipairs { 1e-3, 0.1, 1, 10, 1e3, 1e6 } do
      for _, damping in ipairs { 1e-3, 0.1, 1, 10, 1e3, 1e6 } do  -- h c/m
        for _, q in ipairs { 0.1, 0 } do
          local w, zeta = z / step, damping / (2 * z)
          local v = q == 0 and math.min(0.1 * w, 1) or 0
          local first, last = take_energy(pair(step, z, zeta, q, v, implicit), 10)
          local q1, v1 = closed_form(w, zeta, q, v, 10 * step)
          local exact = 0.25 * (w * w * q1 * q1 + v1 * v1) / first
          expect(last / first):below(exact + 0.06)
          if implicit == "true" then expect(last / first):above(exact - 0.06) end
          if exact < 1e-6 then expect(last / first):below(2e-5) end
        end
      end
    end
  end
end)

test("a damped spring that the step resolves moves as its closed form says, to second order", function()
  local w, zeta = 20, 0.1
  local q, v = closed_form(w, zeta, 0.1, 0.5, 0.5)
  local wrong = {}
  for n, steps in ipairs { 80, 160, 320, 640 } do
    local scene = pair(1 / steps, w / steps, zeta, 0.1, 0.5, "true")
    scene:advance(0.5)
    wrong[n] = math.abs(scene:read "stretch" - q) + math.abs(scene:read "rate" - v) / w
  end
  expect(wrong[1]):below(6e-3)
  for n = 1, 3 do expect(wrong[n] / wrong[n + 1]):near(4, 0.25) end
end)

test("a damper that is much too strong for the step stops what parts, and keeps the momentum", function()
  for _, masses in ipairs { { 1, 1 }, { 1, 1000 }, { 1e-3, 1e-3 } } do
    local scene = open_text(([[
      scene.gravity, scene.step = vec(0, 0, 0), 1 / 240
      local a = scene:particle { mass = %g, velocity = vec(1, 0, 0) }
      local b = scene:particle { mass = %g, at = vec(1, 0, 0) }
      scene:connect(a, b, force.damper { damping = 1e6 })
      scene:probe("rate", function() return b.velocity.x - a.velocity.x end)
    ]]):format(masses[1], masses[2]))
    take_energy(scene, 10)
    expect(math.abs(scene:read "rate")):below(1e-3)
    expect(scene.momentum.x / masses[1]):near(1, 1e-13)
  end
end)

test("a weight sinks on a dashpot that the step cannot follow at the speed that its closed form says", function()
  local scene = open_text [[
    scene.step = 1 / 60
    local weight = scene:particle { mass = 2, at = vec(0, -1, 0), name = "weight" }
    scene:connect(weight, vec(0, 0, 0), force.damper { damping = 1e4 })
  ]]
  scene:advance(0.5)
  local speed = 2 * 9.81 / 1e4
  expect(scene:find("weight").velocity.y):near(-speed, 1e-9 * speed)
  local before = scene:find("weight").position.y
  scene:advance(1)
  expect(before - scene:find("weight").position.y):near(speed, 1e-9 * speed)
end)

test("a damper of any law beside a stiff spring never gives energy", function()
  local laws = { "1e3 * rate * math.abs(rate)", "rate * math.abs(rate)", "1e6 * rate + 1e4 * math.max(0, rate) * rate" }
  for _, law in ipairs(laws) do
    for _, steps in ipairs { 60, 240 } do
      local scene = open_text(([[
        scene.gravity, scene.step = vec(0, 0, 0), 1 / %d
        local a = scene:particle { velocity = vec(-0.5, 0.1, 0) }
        local b = scene:particle { at = vec(1.001, 0, 0), velocity = vec(0.5, 0, 0) }
        scene:connect(a, b, force.spring { stiffness = 1e6, length = 1, implicit = true })
        scene:connect(a, b, force.pair { tension = function(r, rate) return %s end, implicit = true })
      ]]):format(steps, law))
      take_energy(scene, 60)
    end
  end
end)

test("a law that is spring and damper in one settles as the two do", function()
  local function rates(law)
    local scene, list = open_text([[
      scene.gravity, scene.step = vec(0, 0, 0), 1 / 60
      local a = scene:particle { velocity = vec(-0.5, 0.1, 0) }
      local b = scene:particle { at = vec(1.001, 0, 0), velocity = vec(0.5, 0, 0) }
      scene:connect(a, b, ]] .. law .. [[)
      scene:probe("rate", function() return (b.velocity - a.velocity):dot((b.position - a.position):normalized()) end)
    ]]), {}
    for i = 1, 10 do
      scene:step()
      list[i] = scene:read "rate"
    end
    return list
  end
  local two = rates "force.spring { stiffness = 1e6, damping = 2e3, length = 1 }"
  local one = rates "force.pair { tension = function(r, rate) return 1e6 * (r - 1) + 2e3 * rate end }"
  for i = 1, 10 do expect(one[i]):near(two[i], 1e-4) end
  expect(math.abs(two[10])):below(1e-6)
end)

--- What such springs tie, with stiffness and damping as `spring(length)` has them.
local tied = {
  ["two particles, one of them light"] = [[
    local a = scene:particle { mass = 1e-3, velocity = vec(0, 0.3, 0) }
    local b = scene:particle { mass = 1, at = vec(1, 0, 0), velocity = vec(0.5, 0, 0.2) }
    scene:connect(a, b, spring(1))
  ]],
  ["a particle and a place"] = [[
    scene:connect(scene:particle { at = vec(1.0001, 0, 0), velocity = vec(0.5, 0.8, 0) }, vec(0, 0, 0), spring(1))
  ]],
  ["two bodies off centre"] = [[
    local a = scene:body { mass = 1, inertia = vec(0.1, 0.2, 0.3), spin = vec(1, 2, 3),
                           points = { p = vec(0.3, 0.4, 0.1) } }
    local b = scene:body { mass = 2, inertia = vec(0.3, 0.2, 0.1), at = vec(2, 0, 0), spin = vec(-1, 2, 0),
                           velocity = vec(0.3, 0.2, -0.4), points = { p = vec(-0.3, 0.2, 0.1) } }
    scene:connect(a.p, b.p, spring(1.0001 * (a.p.position - b.p.position):length()))
  ]],
  ["hinged bars"] = [[
    local last
    for i = 1, 5 do
      local bar = scene:body { mass = 1, inertia = vec(0.0017, 0.0842, 0.0842), at = vec(i - 0.5, 0, 0),
                               velocity = vec(0, 2 * i - 1, 0), spin = vec(0, 0, 2),
                               points = { a = vec(-0.5, 0, 0), m = vec(0, 0.2, 0), b = vec(0.5, 0, 0) } }
      if last then
        scene:hinge(last.b, bar.a)
        scene:connect(last.m, bar.m, spring(1))
      else
        scene:nail(bar.a)
      end
      last = bar
    end
  ]],
  ["a chain of them"] = [[
    local last
    for i = 0, 10 do
      local velocity = vec(math.sin(3 * i), math.cos(2 * i), 0)
      local p = scene:particle { mass = 1 + i % 3, at = vec(i, 0, 0), velocity = velocity }
      if last then scene:connect(last, p, spring(1)) end
      last = p
    end
  ]],
}
local free = { "two particles, one of them light", "two bodies off centre", "a chain of them" }

for name, code in pairs(tied) do
  test("damped springs of any strength never give energy: " .. name, function()
    for _, stiffness in ipairs { 1e4, 1e6, 1e9 } do
      for _, damping in ipairs { 1, 1e3, 1e6 } do
        local scene = open_text(([[
          scene.gravity, scene.step = vec(0, 0, 0), 1 / 60
          local function spring(length)
            return force.spring { stiffness = %g, damping = %g, length = length, implicit = true }
          end
          local _ = scene.ledger.closure
        ]]):format(stiffness, damping) .. code)
        local momentum, angular = scene.momentum, scene.angular_momentum
        take_energy(scene, 60)
        expect(scene.ledger.closure):below(1e-10)
        if name ~= "hinged bars" then expect(scene.error.worst_energy):below(1e-8) end
        for _, loose in ipairs(free) do
          if name == loose then
            expect((scene.momentum - momentum):length()):below(1e-13)
            expect((scene.angular_momentum - angular):length()):below(1e-8)
          end
        end
      end
    end
  end)
end

test("a solved tension that bends with the distance keeps the energy as its integral has it", function()
  for _, case in ipairs {
    { "1e5 * x * x * x", function(x) return 1e5 / 4 * x ^ 4 end },
    { "1e6 * (math.exp(x) - 1)", function(x) return 1e6 * (math.exp(x) - x - 1) end },
  } do
    local scene = open_text([[
      scene.gravity = vec(0, 0, 0)
      local p = scene:particle { mass = 1, at = vec(2, 0, 0), name = "p" }
      scene:connect(p, vec(0, 0, 0), force.pair { implicit = true,
        tension = function(r) local x = r - 1 return ]] .. case[1] .. [[ end })
    ]])
    local function energy()
      local p = scene:find "p"
      return 0.5 * p.velocity:dot(p.velocity) + case[2](p.position:length() - 1)
    end
    local before = energy()
    scene:advance(1)
    expect(energy() / before):near(1, 1e-5)
  end
end)
