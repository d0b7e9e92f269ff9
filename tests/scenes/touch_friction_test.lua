-- What stands by friction alone, on both sides of the least friction that it stands with.
local function stands(text, friction, rate, name)
  local scene = open_text(("scene.step = 1 / %d\nlocal friction = %.17g\nscene:floor { friction = friction }\n"):format(rate, friction) .. text)
  local before = scene:find(name).position.y
  scene:advance(5)
  expect(scene.error.worst_energy):below(1e-6)
  return math.abs(scene:find(name).position.y - before) < 1e-6
end

-- Seven equal stones of half a ring. A joint at the angle φ bears V = (3.5 − j) w of the stones above and the thrust H, at the angle
-- |atan(V/H) + φ − 90°| to its normal: the least friction is the least over H of the largest over j = 0 … 3, φ = j 180°/7.
local arch_limit = 0.298171
local arch = [[
  for i = 0, 6 do
    local points = {}
    for _, r in ipairs { 1, 1.4 } do
      for _, angle in ipairs { i * math.pi / 7, (i + 1) * math.pi / 7 } do
        for _, z in ipairs { -0.25, 0.25 } do points[#points + 1] = vec(r * math.cos(angle), r * math.sin(angle), z) end
      end
    end
    scene:body { shape = shape.hull { points = points, friction = friction, density = 1000 }, name = "stone " .. i }
  end
]]

-- A ladder at θ to a smooth wall: the wall gives H = w (tan θ − thickness/length)/2.
local lean, thickness = 0.4, 0.05
local ladder_limit = 0.5 * (math.tan(lean) - thickness)
local ladder = ([[
  local lean, a, b = %.17g, 0.5 * %.17g, 0.5
  scene:floor { normal = vec(-1, 0, 0), friction = 0 }
  scene:box { size = vec(2 * a, 2 * b, 0.6), mass = 1, friction = friction, name = "ladder",
    at = vec(-a * math.cos(lean) - b * math.sin(lean), a * math.sin(lean) + b * math.cos(lean), 0),
    orientation = quat(vec(0, 0, 1), -lean) }
]]):format(lean, thickness)

-- Two cards with round ends, ℓ between the centres of these, lean at each other at θ from the upright: each gives the other
-- H = w ℓ sin θ / 2 (r + ℓ cos θ).
local apart, rounding = 1, 0.02
local house_limit = 0.5 * apart * math.sin(lean) / (rounding + apart * math.cos(lean))
local house = ([[
  local lean, l, r = %.17g, %.17g, %.17g
  for _, side in ipairs { -1, 1 } do
    scene:body { name = side < 0 and "card" or nil,
      at = vec(side * (r + 0.5 * l * math.sin(lean)), r + 0.5 * l * math.cos(lean), 0), orientation = quat(vec(0, 0, 1), side * lean),
      shapes = {
        shape.box { size = vec(2 * r, l, 0.6), friction = friction },
        shape.cylinder { radius = r, length = 0.6, axis = vec(0, 0, 1), at = vec(0, -0.5 * l, 0), friction = friction },
        shape.cylinder { radius = r, length = 0.6, axis = vec(0, 0, 1), at = vec(0, 0.5 * l, 0), friction = friction } } }
  end
]]):format(lean, apart, rounding)

for _, rate in ipairs { 60, 240 } do
  test("two cards that lean at each other stand with 2 % more than their least friction, and fall with 2 % less, at " .. rate .. " Hz", function()
    expect(stands(house, 1.02 * house_limit, rate, "card")):equal(true)
    expect(stands(house, 0.98 * house_limit, rate, "card")):equal(false)
  end)

  test("an arch of seven stones stands with 2 % more than its least friction, and falls with 2 % less, at " .. rate .. " Hz", function()
    expect(stands(arch, 1.02 * arch_limit, rate, "stone 3")):equal(true)
    expect(stands(arch, 0.98 * arch_limit, rate, "stone 3")):equal(false)
  end)

  test("a ladder at a smooth wall stands with 2 % more than its least friction, and slips with 2 % less, at " .. rate .. " Hz", function()
    expect(stands(ladder, 1.02 * ladder_limit, rate, "ladder")):equal(true)
    expect(stands(ladder, 0.98 * ladder_limit, rate, "ladder")):equal(false)
  end)
end

-- A thin disc that lies at α rolls round on its edge with its centre at rest, at Ω² sin α = 4 g/R (Euler's disc).
local function rolls_round(ground, angle, radius, thickness)
  local pitch = math.sqrt(4 * 9.81 / (radius * math.sin(angle)))
  local scene = open_text(([[
    scene.step = 1 / 240
    %s
    local angle, pitch, radius, thickness = %.17g, %.17g, %.17g, %.17g
    scene:body { shape = shape.cylinder { radius = radius, length = thickness, density = 1000, friction = 1 }, name = "disc",
      at = vec(0, radius * math.sin(angle) + 0.5 * thickness * math.cos(angle), 0), orientation = quat(vec(0, 0, 1), -angle),
      spin = vec(math.cos(angle), -math.sin(angle), 0) * (-pitch * math.sin(angle)) }
  ]]):format(ground, angle, pitch, radius, thickness))
  local disc, before, kinetic = scene:find("disc"), scene.energy.total, scene.energy.kinetic
  local _, last, turned = scene.ledger, 0, 0
  while scene.time < 2 do
    scene:step()
    local face = disc.orientation:rotate(vec(0, 1, 0))
    local at = math.atan(face.z, face.x)
    turned, last = turned + (at - last + math.pi) % (2 * math.pi) - math.pi, at
  end
  return turned / -2 / pitch, (before - scene.energy.total) / kinetic, scene.ledger.push_out
end

for _, ground in ipairs {
  { "the floor", "scene:floor { friction = 1 }" },
  { "a box", "scene:ground { shape = shape.box { size = vec(9, 1, 9), at = vec(0, -0.5, 0), friction = 1 } }" },
} do
  for _, angle in ipairs { 0.06, 0.15, 0.3, 1 } do
    test(("a disc that lies at %g rad on %s rolls round on its edge and loses nothing"):format(angle, ground[1]), function()
      local pitch, lost, pushed = rolls_round(ground[2], angle, 0.5, 0.02)
      expect(pitch):near(1, 0.01)
      expect(lost):below(1e-3)
      expect(pushed):near(0, 1e-6)
    end)
  end

  test("a thick disc on " .. ground[1] .. " loses what its start costs, and rolls round on its edge", function()
    local _, lost, pushed = rolls_round(ground[2], 0.15, 0.3, 0.1)
    expect(lost):below(0.05)
    expect(pushed):near(0, 1e-6)
  end)
end

test("what has rolling and spinning friction comes to rest and falls asleep, alone and in a bin", function()
  local alone = open_text([[
    scene.step = 1 / 60
    scene:floor { friction = 0.5, restitution = 0.3 }
    for i = 1, 20 do
      scene:ball { radius = 0.2, at = vec(3 * i, 0.3 + 0.03 * i, 0), velocity = vec(0.1 * i, 0, 0.05 * i), spin = vec(i, 2, 0.3),
                   restitution = 0.3, friction = 0.5, rolling = 0.002, spinning = 0.002, density = 300 }
    end
  ]])
  alone:advance(50)
  expect(alone.stats.asleep):equal(20)
  local bin = open_text([[
    scene.step, scene.seed = 1 / 60, 23
    scene:floor { friction = 0.5, restitution = 0.3 }
    for side = -1, 1, 2 do
      scene:ground { shape = shape.box { size = vec(0.2, 2, 3), friction = 0.5, restitution = 0.3 }, at = vec(1.4 * side, 1, 0) }
      scene:ground { shape = shape.box { size = vec(3, 2, 0.2), friction = 0.5, restitution = 0.3 }, at = vec(0, 1, 1.4 * side) }
    end
    local function some() return 2 * math.random() - 1 end
    for i = 0, 29 do
      local rest = { at = vec(0.55 * (i % 4) - 0.8, 0.4 + 0.55 * (i // 12), 0.6 * (i // 4 % 3) - 0.6), restitution = 0.3,
                     orientation = quat(vec(some(), some(), some()):normalized(), 3 * some()),
                     friction = 0.5, rolling = 0.002, spinning = 0.002, density = 300 }
      if i % 2 == 0 then rest.radius = 0.2 scene:ball(rest) else rest.size = vec(0.3, 0.3, 0.3) scene:box(rest) end
    end
  ]])
  bin:advance(15)
  expect(bin.stats.asleep):equal(30)
end)

test("a ball rolls on a slope that is steeper than its rolling friction by a thousandth, and sleeps on one that is less steep", function()
  for _, steeper in ipairs { 1e-3, -1e-3 } do
    local scene = open_text(("local slope = %.12g\n"):format(0.002 / 0.2 * (1 + steeper)) .. [[
      scene.gravity = vec(9.81 * math.sin(math.atan(slope)), -9.81 * math.cos(math.atan(slope)), 0)
      scene:floor { friction = 0.5 }
      scene:ball { name = "ball", radius = 0.2, at = vec(0, 0.2, 0), friction = 0.5, rolling = 0.002, spinning = 0.002 }
    ]])
    scene:advance(10)
    expect(scene.stats.asleep):equal(steeper > 0 and 0 or 1)
  end
end)

--- A car of four wheels, each hinged at these places beside its middle, which brakes with its front wheels at 0.5 s.
local function braking_car(places)
  return ([[
    scene:floor { friction = 0.8 }
    local body = scene:box { name = "body", size = vec(2.4, 0.4, 1), at = vec(0, 0.6, 0), density = 300, velocity = vec(15, 0, 0), layer = "car" }
    scene:collide("car", "car", false)
    for x = -0.9, 0.9, 1.8 do
      for z = -0.6, 0.6, 1.2 do
        local wheel = scene:cylinder { radius = 0.35, length = 0.15, axis = vec(0, 0, 1), at = vec(x, 0.35, z), density = 300, friction = 0.8,
                                       velocity = vec(15, 0, 0), spin = vec(0, 0, -15 / 0.35), layer = "car" }
        for _, place in ipairs { $places } do
          scene:hinge(body:add_point(vec(x, -0.25, z + place)), wheel:add_point(vec(0, 0, place)), { axis = vec(0, 0, 1) })
        end
        if x > 0 then scene:at(0.5, function() scene:motor(wheel, body, { axis = vec(0, 0, 1), speed = 0 }) end) end
      end
    end
  ]]):gsub("%$places", places)
end

local mirrored = {
  ["a car that brakes with its front wheels"] = braking_car("0"),
  ["a car whose hinges stand beside its wheels"] = braking_car("-0.3, -0.2"),
  ["a plank on two belts that run towards each other"] = [[
    scene:ground { shapes = {
      shape.box(0.4, 0.4, 0.6, { at = vec(-0.5, -0.2, 0), friction = 0.3, surface_velocity = vec(4, 0, 0) }),
      shape.box(0.4, 0.4, 0.6, { at = vec(0.5, -0.2, 0), friction = 0.3, surface_velocity = vec(-4, 0, 0) }) } }
    scene:box { name = "body", size = vec(3, 0.1, 0.5), at = vec(0.2, 0.05, 0), friction = 0.3, density = 500 }
  ]],
  ["a sled on four balls, the front ones rough"] = [[
    scene:floor { friction = 1 }
    local shapes = { shape.box { size = vec(1, 0.1, 0.4), density = 500 } }
    for x = -0.4, 0.4, 0.8 do
      for z = -0.15, 0.15, 0.3 do
        shapes[#shapes + 1] = shape.ball(0.05, { at = vec(x, -0.1, z), friction = x > 0 and 0.5 or 0.01, density = 100 })
      end
    end
    scene:body { name = "body", shapes = shapes, at = vec(0, 0.15, 0), velocity = vec(6, 0, 0) }
  ]],
}

for what, text in pairs(mirrored) do
  test("what is the same on both sides goes straight, however many points it stands on: " .. what, function()
    for _, hz in ipairs { 60, 240 } do
      local scene = open_text(("scene.step = 1 / %d\n"):format(hz) .. text)
      scene:advance(1.5)
      local body = scene:find "body"
      expect(body.orientation.y):near(0, 1e-5)
      expect(body.position.z):near(0, 1e-5)
    end
  end)
end

for friction in pairs { [0.6] = true, [1.2] = true } do
  test("a stick that slides tip first into a rough floor sticks and vaults over, at any step: friction " .. friction, function()
    for _, hz in ipairs { 60, 240, 960 } do
      local scene = open_text((([[
        scene.step = 1 / $hz
        scene:floor { friction = $friction }
        scene:body { name = "stick", orientation = quat(vec(0, 0, 1), math.rad(-30)), velocity = vec(-5, 0, 0),
                     at = vec(0.5 * math.cos(math.rad(60)), 0.03 + 0.5 * math.sin(math.rad(60)), 0),
                     shapes = { shape.capsule(0.02, 1, { friction = $friction, density = 100 }),
                                shape.ball(0.05, { friction = $friction, density = 8000 }) } }
      ]]):gsub("%$(%w+)", { hz = hz, friction = friction })))
      scene:advance(0.09)
      expect(scene:find("stick").spin.z):near(7.96, 0.05)  -- a plastic blow in the plane, by hand
      expect(scene.error.energy):below(1e-9)
    end
  end)
end

test("what is welded bears alike on all its feet, and a string between things at rest pulls nothing", function()
  local scene = open_text [[
    scene:floor { friction = 0 }
    local bar = scene:box { name = "bar", size = vec(1.8, 0.1, 0.2), at = vec(0, 0.65, 0), density = 300 }
    for x = -0.8, 0.8, 1.6 do
      for side = -1, 1, 2 do
        local leg = scene:body { at = vec(x, 0.6, 0.4 * side), layer = "leg", shapes = {
          shape.box(0.1, 0.1, 0.6), shape.ball(0.1, { at = vec(0, -0.5, -0.1) }), shape.ball(0.1, { at = vec(0, -0.5, 0.1) }) } }
        scene:weld(bar, leg)
      end
    end
    scene:collide("leg", "leg", false)
  ]]
  scene:advance(1)
  local least, most = math.huge, 0
  for _, leg in ipairs(scene.bodies) do
    for _, contact in ipairs(leg.contacts) do
      local load = contact.force:length()
      if load > 0 then least, most = math.min(least, load), math.max(most, load) end
    end
  end
  expect(most):above(0)
  expect(least / most):near(1, 0.02)

  scene = open_text [[
    scene:floor { friction = 1 }
    local a = scene:box { size = vec(0.4, 0.8, 0.4), at = vec(-1, 0.4, 0), points = { f = vec(0.2, 0, 0) } }
    local b = scene:box { size = vec(0.4, 0.8, 0.4), at = vec(1, 0.4, 0), points = { f = vec(-0.2, 0, 0) } }
    local rope = scene:string { a.f, b.f }
    scene:probe("pull", function() return rope.force end)
  ]]
  for _ = 1, 20 do
    scene:step()
    expect(scene:read "pull"):near(0, 1e-6)
  end
end)
