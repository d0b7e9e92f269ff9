-- What turns about an axis that is none of its own, and what rolls on something that turns: right to the second order of the step.

local function after(seconds, rate, text)
  local scene = open_text(("scene.step = 1 / %d\n"):format(rate) .. text)
  local before = scene.energy.total
  scene:advance(seconds)
  return scene, scene.energy.total / before - 1
end

test("a top in steady precession on a smooth floor keeps its spin about its axis, and its energy", function()
  local scene, gain = after(4, 240, [[
    scene:floor { friction = 0 }
    local lean, pitch, A, C, l, r = 1, 6, 0.02, 0.008, 0.2, 0.02
    local spin = (9.81 * l + A * pitch ^ 2 * math.cos(lean)) / (C * pitch)
    local a, c = math.sqrt(C * 1.5), math.sqrt((A - C / 2) * 3)
    local points = {}
    for i, at in ipairs { vec(a, l, 0), vec(-a, l, 0), vec(0, l, a), vec(0, l, -a), vec(0, l + c, 0), vec(0, l - c, 0) } do
      points[i] = { at = at, mass = 1 / 6 }
    end
    local axis = vec(math.sin(lean), math.cos(lean), 0)
    top = scene:body { at = vec(0, r, 0), orientation = quat(vec(0, 0, 1), -lean), points = points, shape = shape.ball { radius = r, friction = 0 } }
    top.spin = axis * (spin - pitch * math.cos(lean)) + vec(0, pitch, 0)
    top.velocity = vec(0, 0, 0)
    scene:probe("spin", function() return top.spin:dot((top.position - top.origin):normalized()) / spin end)
  ]])
  expect(scene:read("spin")):near(1, 1e-3)
  expect(gain):near(0, 2e-3)
end)

test("a ball of unequal moments that rolls keeps its energy", function()
  local _, gain = after(4, 240, [[
    local radius, mass, spin = 0.3, 2, vec(6, 2, 4)
    scene:floor { friction = 5 }
    scene:ball { radius = radius, mass = mass, inertia = vec(1, 1.5, 2) * (0.4 * mass * radius * radius / 1.5), friction = 5,
      at = vec(0, radius, 0), spin = spin, velocity = spin:cross(vec(0, radius, 0)) }
  ]])
  expect(gain):near(0, 2e-5)
end)

test("a ball that spins on the spot on a turning table stays there", function()
  for _, rate in ipairs { 60, 240 } do
    local scene = after(3, rate, [[
      local turn, radius = 4, 0.1
      local plate = scene:cylinder { radius = 5, length = 0.5, at = vec(0, -0.25, 0), density = 1e4, friction = 2, points = { c = vec(0, 0, 0) }, spin = vec(0, turn, 0) }
      scene:nail(plate.c)
      scene:motor(plate, { axis = vec(0, 1, 0), speed = turn })
      ball = scene:ball { radius = radius, at = vec(1, radius, 0), friction = 2, mass = 1, spin = vec(turn / radius, 0, 0), name = "ball" }
    ]])
    expect(scene:find("ball").position):near(vec(1, 0.1, 0), 1e-4)
  end
end)

test("balls between a floor and a plate that turns go round at half of its rate, and stay at their radius", function()
  for _, rate in ipairs { 60, 240 } do
    local scene = after(10, rate, [[
      local turn, radius = 4, 0.1
      scene:floor { friction = 1 }
      local plate = scene:cylinder { radius = 1.5, length = 0.1, at = vec(0, 0.25, 0), mass = 30, friction = 1, spin = vec(0, turn, 0) }
      scene:motor(plate, { axis = vec(0, 1, 0), speed = turn })
      for i = 0, 2 do
        local angle = i * 2 * math.pi / 3
        local out, along = vec(math.cos(angle), 0, -math.sin(angle)), vec(-math.sin(angle), 0, -math.cos(angle))
        scene:ball { radius = radius, mass = 1, friction = 1, at = out + vec(0, radius, 0), velocity = along * (turn / 2),
          spin = out * (-turn / (2 * radius)), name = "ball " .. i }
      end
    ]])
    for i = 0, 2 do
      local at = scene:find("ball " .. i).position
      expect(math.sqrt(at.x ^ 2 + at.z ^ 2)):near(1, 1e-4)
    end
  end
end)

test("matches that fall on a floor at 60 Hz gain no more than a part of their energy, however they strike it", function()
  for seed = 1, 20 do
    local scene = open_text(("scene.seed, scene.step = %d, 1 / 60\n"):format(seed) .. [[
      scene:floor { friction = 0.5 }
      local function r() return 2 * math.random() - 1 end
      scene:body { at = vec(0, 1, 0), velocity = vec(r(), 0, r()), spin = vec(5 * r(), 5 * r(), 5 * r()),
        orientation = quat(vec(r(), r(), r()), 3 * r()), shape = shape.box(0.043, 0.002, 0.002) }
    ]])
    local start, last = scene.energy.total, scene.energy.total
    for _ = 1, 120 do
      scene:step()
      expect(scene.energy.total - last):below(0.05 * start)
      last = scene.energy.total
    end
  end
end)

for _, what in ipairs { "ball", "cylinder", "capsule" } do
  test("a " .. what .. " that rolls over flush boxes goes on at its height and speed", function()
    for _, rate in ipairs { 60, 240 } do
      for _, speed in ipairs { 0.4, 0.5, 0.7, 1, 1.6, 3 } do
        local scene = open_text(([[
          scene.step = 1 / %d
          local speed, what, radius = %g, %q, 0.2
          for i = 0, 10 do
            scene:ground { shape = shape.box { size = vec(0.37, 1, 4), at = vec(-0.3 + i * 0.37, -0.5, 0), friction = 0.6 } }
          end
          scene:body { name = "it", mass = 1, shape = shape[what] { radius = radius, length = what ~= "ball" and 0.5 or nil, friction = 0.6 },
            at = vec(0, radius, 0), velocity = vec(speed, 0, 0), spin = vec(0, 0, -speed / radius), orientation = quat(vec(1, 0, 0), math.pi / 2) }
        ]]):format(rate, speed, what))
        local it, off = scene:find "it", 0
        while it.position.x < 3 do
          scene:step()
          off = math.max(off, math.abs(it.position.y - 0.2))
        end
        expect(off):below(5e-6)
        expect(1 - it.velocity.x / speed):below(1e-3)
      end
    end
  end)
end
