--- Laws of velocity on what is tied, at any strength.

local step = 1 / 240

--- Bars in a row along x, hinged at their ends, in `name`1, `name`2 …
local function bars(count)
  return ([[
    local bars = {}
    for i = 1, %d do
      bars[i] = scene:body { mass = 1, inertia = vec(0.1, 0.1, 0.1), at = vec(i - 0.5, 0, 0), name = "bar" .. i,
        points = { head = vec(-0.5, 0, 0), tail = vec(0.5, 0, 0) } }
      if i > 1 then scene:hinge(bars[i - 1].tail, bars[i].head) end
      bars[i]:kick(vec(0.3 * i, i %% 2 == 0 and 1 or -1, 0.5 * (i %% 3)))
    end
  ]]):format(count)
end

for _, integrator in ipairs { "verlet", "suzuki4" } do
  test("a magnetic force keeps the energy of hinged bodies at any strength with " .. integrator, function()
    for _, turn in ipairs { 0.02, 0.3, 1, 3 } do
      local scene = open_text(("scene.gravity, scene.integrator = vec(0, 0, 0), %q\n"):format(integrator) .. bars(3)
        .. ("scene:field(scene, force.point { force = function(p) return p.velocity:cross(vec(0.3, 0.2, 1) * %g) end })")
          :format(turn * 240))
      scene:advance(step)  -- makes the velocities what the hinges allow
      local before = scene.energy.kinetic
      scene:advance(2)
      expect(math.abs(scene.energy.kinetic / before - 1)):below(1e-10)
      expect(scene.ledger.damper):equal(0)
    end
  end)
end

test("drag of any strength only takes from hinged bodies, and turns none round", function()
  for _, drag in ipairs { 1, 1e3, 1e6 } do
    local scene = open_text("scene.gravity = vec(0, 0, 0)\n" .. bars(40)
      .. ("scene:field(scene, force.drag { linear = %g })"):format(drag))
    scene:advance(step)  -- makes the velocities what the hinges allow
    local energy = scene.energy.kinetic
    for _ = 1, 30 do
      scene:advance(step)
      expect(scene.energy.kinetic):below(energy + 1e-20)
      energy = scene.energy.kinetic
    end
    expect(scene.error.energy):below(1e-9)
  end
end)

test("a light dragged body slows a heavy one that it is hinged to as their masses say", function()
  for _, case in ipairs { { 1, 1e-9 }, { 100, 1e-6 }, { 2000, 1e-3 } } do
    local drag, bound = case[1], case[2]
    local scene = open_text(([[
      scene.gravity = vec(0, 0, 0)
      local heavy = scene:body { mass = 100, inertia = vec(1, 1, 1), points = { tail = vec(1, 0, 0) }, name = "heavy" }
      local light = scene:body { mass = 0.01, inertia = vec(1, 1, 1) * 1e-4, at = vec(1.5, 0, 0),
        points = { head = vec(-0.5, 0, 0), tail = vec(0.5, 0, 0) } }
      scene:hinge(heavy.tail, light.head)
      heavy:kick(vec(1000, 0, 0))
      light:kick(vec(0.1, 0, 0))
      scene:field(scene:group("dragged"):add(light.tail), force.drag { linear = %g })
    ]]):format(drag))
    scene:advance(1)
    local exact = math.exp(-drag / 100.01)
    expect(math.abs(scene:find("heavy").velocity.x / 10 - exact)):below(bound)
  end
end)

test("what tows a dragged thing bears the drag, and its hand gives what the drag takes", function()
  local scene = open_text [[
    scene.gravity = vec(0, 0, 0)
    local p = scene:particle { mass = 1, at = vec(-1, 0, 0), velocity = vec(2, 0, 0) }
    local q = scene:particle { mass = 1, velocity = vec(2, 0, 0) }
    scene:rod(p, q).name = "rod"
    scene:follow(q, function(t) return vec(2 * t, 0, 0) end)
    scene:field(scene:group("dragged"):add(p), force.drag { linear = 50 })
  ]]
  scene:advance(1)
  expect(scene:find("rod").force):near(100, 1e-9)
  expect(scene.ledger.hand):near(200, 1e-9)
  expect(scene.ledger.damper):near(-200, 1e-9)
end)

test("on a taut string a magnetic force keeps the speed", function()
  for _, turn in ipairs { -0.02, 1, 3 } do
    local scene = open_text(([[
      scene.gravity = vec(0, 0, 0)
      local p = scene:particle { mass = 1, at = vec(1, 0, 0), velocity = vec(0, 1, 0) }
      scene:string({ p, vec(0, 0, 0) }, { length = 1 }).name = "string"
      scene:field(scene, force.point { force = function(p) return p.velocity:cross(vec(0, 0, %g)) end })
    ]]):format(turn * 240))
    scene:advance(2)
    expect(scene.energy.kinetic):near(0.5, 1e-10)
    if turn > 0 then expect(scene:find("string").force):near(1 + turn * 240, 1e-5 * turn * 240) end
  end
end)

test("a motor that can hold against a wind holds, and one that cannot yields", function()
  for _, wind in ipairs { 0.5, 2 } do
    local scene = open_text(([[
      scene.gravity = vec(0, 0, 0)
      local vane = scene:body { mass = 1, inertia = vec(0.1, 0.1, 0.1), at = vec(0.5, 0, 0), name = "vane",
        points = { head = vec(-0.5, 0, 0), tail = vec(0.5, 0, 0) } }
      scene:nail(vane.head)
      scene:motor(vane, { axis = vec(0, 0, 1), speed = 0, max_torque = 1 })
      scene:field(scene:group("blown"):add(vane.tail),
        force.point { force = function(p) return (vec(0, 10, 0) - p.velocity) * %g end })
    ]]):format(wind / 10))
    scene:advance(2)
    local turned = scene:find("vane").position.y
    if wind < 1 then expect(math.abs(turned)):below(1e-12) else expect(turned):above(0.1) end
  end
end)

test("a stiff spring in thick oil relaxes at the rate of the two", function()
  for _, case in ipairs { { 1e6, 1e5 }, { 1e7, 1e6 }, { 1e8, 1e7 }, { 1e9, 1e8 }, { 1e8, 1e9 } } do
    local scene = open_text(([[
      scene.gravity = vec(0, 0, 0)
      local p = scene:particle { mass = 1, at = vec(2, 0, 0), name = "p" }
      scene:connect(p, vec(0, 0, 0), force.spring { stiffness = %g, length = 1 })
      scene:field(scene, force.drag { linear = %g })
    ]]):format(case[1], case[2]))
    scene:advance(0.1)
    expect(scene:find("p").position.x - 1):near(math.exp(-0.1 * case[1] / case[2]), 2e-4)
  end
end)

test("a magnetic force that grows with the speed keeps the energy too, of particles and of hinged bodies", function()
  for _, strength in ipairs { 24, 240, 2400 } do
    local law = ("scene:field(scene, force.point { force = function(p) local v = p.velocity "
      .. "return v:cross(vec(0.3, 0.2, 1) * (%g * v:dot(v))) end })"):format(strength)
    local free = open_text("scene.gravity = vec(0, 0, 0) scene:particle { velocity = vec(1, 0, 0) }" .. law)
    free:advance(0.5)
    expect(free.energy.kinetic):near(0.5, 1e-10)
    local hinged = open_text("scene.gravity = vec(0, 0, 0)\n" .. bars(3) .. law)
    hinged:advance(step)
    local before = hinged.energy.kinetic
    hinged:advance(0.5)
    expect(hinged.energy.kinetic / before):near(1, 1e-9)
  end
end)

test("a dissipative spring in thick oil relaxes at the rate of the two", function()
  local scene = open_text [[
    scene.gravity = vec(0, 0, 0)
    local p = scene:particle { mass = 1, at = vec(2, 0, 0), name = "p" }
    scene:connect(p, vec(0, 0, 0), force.spring { stiffness = 5e7, length = 1, implicit = "dissipative" })
    scene:field(scene, force.drag { linear = 1e7 })
  ]]
  scene:advance(0.4)
  expect(scene:find("p").position.x - 1):near(math.exp(-2), 5e-3)
end)

test("panels that redundant hinges tie meet a floor with friction and damping, and none takes a fallback step", function()
  local scene = open "scenes/buckyball.lua"
  scene:advance(0.9)
  expect(scene.stats.fallback_steps):equal(0)
  expect(scene.error.worst_energy):below(5e-3)
end)

test("a puppet on strings in drag takes no fallback step", function()
  local scene = open "scenes/puppet.lua"
  scene:advance(12)
  expect(scene.stats.fallback_steps):equal(0)
end)

test("in a ring of bodies a magnetic force keeps the energy where it turns them hundreds of times in a step", function()
  local scene = open_text [[
    scene.gravity, scene.step = vec(0, 0, 0), 1 / 120
    local bodies = {}
    for i = 1, 6 do
      local t, u = math.pi * (i - 1) / 3, math.pi * i / 3
      local from, to = vec(math.cos(t), math.sin(t), 0), vec(math.cos(u), math.sin(u), 0)
      local centre = (from + to) * 0.5
      bodies[i] = scene:body { mass = 1, inertia = vec(0.1, 0.1, 0.1), at = centre,
                               points = { head = { at = from - centre, mass = 0.1 }, tail = { at = to - centre, mass = 0.1 } } }
    end
    for i = 1, 6 do scene:hinge(bodies[i].tail, bodies[i % 6 + 1].head) end
    bodies[1].velocity, bodies[4].velocity = vec(0, 0, 6), vec(1, 2, 3)
    scene:field(scene, force.point { force = function(p) return p.velocity:cross(vec(300, 500, 1000)) end })
  ]]
  scene:step()  -- makes the velocities what the hinges allow
  local before = scene.energy.kinetic
  scene:advance(1)
  expect(scene.energy.kinetic / before):near(1, 1e-8)
end)

test("a cage of rods that falls on a floor of dry friction rolls as it does in short steps", function()
  local cage = open_text [[
    scene.step = 1 / 480
    local shape = structure.icosahedron { edge = 0.3 }:rotate(quat(vec(1, 0.3, 0.2), 0.4))
    local lowest = 0
    for _, p in ipairs(shape.vertices) do lowest = math.min(lowest, p.y) end
    local corners = scene:family("corners", { radius = 0.06 })
    scene:field(corners, force.wall { normal = vec(0, 1, 0), stiffness = 250, damping = 0.4, friction = 0.3 })
    built = scene:build(shape, { as = "articulated", mass = 1, at = vec(0, 0.2 - lowest, 0), family = corners, radius = 0.06 })
    scene:probe("height", function() local low, high = built:bounds() return high.y - low.y end)
  ]]
  cage:advance(2)
  -- converged: of 1/1920 s 0.3230 J and 0.46499 m, of 1/7680 s 0.3231 J and 0.46497 m
  expect(cage.energy.kinetic):near(0.3231, 0.01)
  expect(cage:read "height"):near(0.46497, 3e-4)
end)

test("what laws that do no work by velocity, and rows that draw together, give is booked", function()
  for _, tie in ipairs { "scene:join(rod.tail, ball)", "scene:string({ rod.tail, ball }, { length = 1 })" } do
    local scene = open_text([[
      local ball = scene:particle { at = vec(1, -1.5, -1.5), velocity = vec(2, 0, 1), mass = 0.6 }
      local rod = scene:body { mass = 1, inertia = vec(0.01, 0.1, 0.1), at = vec(2, 0, 0), points = { tail = vec(0.5, 0, 0) } }
      scene:field(scene, force.point { force = function(p) return p.velocity:cross(vec(0, 0, 3)) end })
      scene:probe("closure", function() return scene.ledger.closure or 0 end)
    ]] .. tie)
    scene:advance(1)
    expect(scene:read "closure"):below(1e-12)
  end
end)

test("friction of a belt takes things along at its velocity, on rods and alone", function()
  for _, tied in ipairs { true, false } do
    local scene = open_text(([[
      scene.gravity = vec(0, 0, 0)
      local all, belt = {}, vec(1, 0, 0)
      for i = 1, 6 do
        all[i] = scene:particle { at = vec(i * 0.5, 0, 0.1 * (i %% 2)), mass = 1, velocity = vec(0, 0, 0.3 * i) }
        if i > 1 and %s then scene:rod(all[i - 1], all[i]) end
      end
      scene:field(scene, force.point { force = function(p)
        local slips = p.velocity - belt
        return slips * (-3 / math.sqrt(slips:dot(slips) + 1e-12))
      end })
      scene:probe("fastest slip", function()
        local most = 0
        for _, p in ipairs(all) do most = math.max(most, (p.velocity - belt):length()) end
        return most
      end)
    ]]):format(tied))
    scene:advance(1.5)
    expect(scene:read "fastest slip"):below(1e-9)
    expect(#scene.log):equal(0)
  end
end)

test("a force that leaps with the velocity is followed to where it leaps", function()
  local scene = open_text [[
    scene.gravity = vec(0, 0, 0)
    scene:particle { velocity = vec(0.01, 0, 0), name = "p" }
    scene:field(scene, force.point { force = function(p)
      if p.velocity.x > 0.005 then return vec(-10, 0, 0) else return vec(10, 0, 0) end
    end })
  ]]
  scene:advance(0.1)
  expect(scene:find("p").velocity.x):near(0.005, 1e-6)
end)

local function hung_chain(law)
  return open_text(([[
    scene.step = 1 / 3840
    local links, all = scene:family("links", { radius = 0.05, mass = 0.1 }), {}
    scene:field(links, force.point { force = %s })
    for i = 1, 10 do
      all[i] = scene:particle { family = links, at = vec(0.2 * i, 0, 0), velocity = vec(math.cos(i), math.sin(2 * i), 0) }
      scene:rod(i > 1 and all[i - 1] or vec(0, 0, 0), all[i])
    end
    scene:probe("x", function() return all[10].position.x end)
  ]]):format(law))
end

test("a chain in quadratic drag is where shorter steps have it, to second order", function()
  local chain = hung_chain "function(p) return p.velocity * (-2 * p.velocity:length()) end"
  chain:advance(1)
  expect(chain:read "x"):near(1.76348559, 1e-7)  -- of 1/15360 s: 1.763485588
end)

test("a chain whose links stick along one axis and slide along the other keeps the energy in short steps", function()
  local chain = hung_chain [[function(p)
    local v = p.velocity
    return vec(-0.5 * v.x / math.sqrt(v.x * v.x + 1e-10), -0.5 * v.y / math.sqrt(v.y * v.y + 1e-10), 0)
  end]]
  chain:advance(1)
  expect(chain.error.worst_energy):below(1e-11)
  expect(chain:read "x"):near(0.41466, 2e-4)  -- of 1/15360 s, solved in another way: 0.414657
end)

for law, text in pairs {
  ["a drag by the square of the speed"] = "scene:field(scene, force.drag { quadratic = 1e-12 })",
  ["a drag without its quadratic part"] = "scene:field(scene, force.drag { linear = 0, quadratic = 0 })",
  ["a magnetic field that grows with the speed"] = [[
    scene:field(scene, force.point { force = function(p)
      return p.velocity:length() * p.velocity:cross(vec(0, 0, 1e-9))
    end })]],
  ["a damper by the square of the rate"] = [[
    scene:connect(p, q, force.pair { force = function(d, u) return 1e-12 * u:length() * u end })]],
} do
  test("from rest a first step is of all that acts, where a law has no slope at rest: " .. law, function()
    for _, damper in ipairs { "", "scene:connect(p, r, force.damper { damping = 1.5 })" } do
      local scene = open_text([[
        local p = scene:particle { at = vec(0, 0, 0), name = "p" }
        local q = scene:particle { at = vec(0, -1, 0) }
        local r = scene:particle { at = vec(1, -1, 0) }
        scene:rod(p, q) scene:rod(q, r)
      ]] .. damper .. "\n" .. text)
      local _ = scene.ledger
      scene:step()
      expect(scene.momentum.y):near(-3 * 9.81 * step, 1e-9)
      expect(scene.ledger.damper):near(0, 1e-9)
      scene:step()
      expect(scene.momentum.y):near(-6 * 9.81 * step, 1e-9)
    end
  end)
end

test("what a law has no slope by at rest is what it tends to: a drag is the same with a quadratic part of 0", function()
  local function at_one(drag)
    local scene = open_text([[
      local p = scene:particle { at = vec(1, 0, 0) }
      local q = scene:particle { at = vec(1, -1, 0), mass = 0.5 }
      local r = scene:particle { at = vec(2, -1, 0), mass = 0.7, name = "r" }
      scene:rod(p, vec(0, 0, 0)) scene:rod(p, q) scene:rod(q, r)
      scene:connect(p, r, force.damper { damping = 1.5 })
      scene:field(scene:group("air"):add(r), force.drag { ]] .. drag .. " })")
    scene:advance(1)
    return scene:find "r".position
  end
  expect(at_one "linear = 0.3, quadratic = 0"):near(at_one "linear = 0.3", 1e-9)
end)

for _, tie in ipairs {
  "scene:join(first.points[1], second.points[2])",
  "scene:limit(first.points[1], second.points[2], { max = 1.5 })",
} do
  for _, gravity in ipairs { 0, 9.81 } do
    test(("drawn together, with a damper between, bodies keep their momenta: %s, gravity %g"):format(tie, gravity), function()
      for _, damping in ipairs { 0.1, 5 } do
        for _, steps in ipairs { 60, 240 } do
          local scene = open_text(([[
            scene.gravity = vec(0, -%g, 0)
            local function body(x)
              return scene:body { at = vec(x, 0, 0), points = {
                { at = vec(-0.5, 0, 0), mass = 0.5 }, { at = vec(0.5, 0, 0), mass = 0.7 }, { at = vec(0, 0.4, 0.1), mass = 0.2 },
              } }
            end
            local first, second = body(0), body(1)
            %s
            scene:connect(first.points[1], second.points[3], force.damper { damping = %g })
          ]]):format(gravity, tie, damping), { ["scene.step"] = 1 / steps })
          local _ = scene.ledger
          local mass, centre = 2.8, vec(0.5 + 0.1 / 1.4, 0, 0.02 / 1.4)
          for i = 1, steps do
            scene:step()
            expect(scene.momentum):near(vec(0, -mass * gravity * i / steps, 0), 1e-9)
            expect(scene.angular_momentum):near(centre:cross(scene.momentum), 1e-9)
          end
          expect(scene.ledger.closure):below(1e-9)
        end
      end
    end)
  end
end
