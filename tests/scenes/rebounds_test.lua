-- What has restitution 1 and no friction keeps its energy, whatever it strikes, and wherever in the step it does.

--- What a scene has lost of its energy after so long, a part of it, and tells no more of as an error.
local function lost(text, values, time)
  local filled = text:gsub("%$(%w+)", values)
  local scene = open_text(filled)
  scene:advance(0.001)
  local before = scene.energy.total
  scene:advance(time)
  expect(scene.error.worst_energy):below(1e-3)
  return 1 - scene.energy.total / before
end

local room = [[
  scene.step = 1 / 60
  scene.plane = "xy"
  local corners = {}
  for i = 0, $sides do
    local angle = 2 * math.pi * i / $sides + 0.2
    corners[#corners + 1] = vec(5 * math.cos(angle), 5 * math.sin(angle), 0)
  end
  scene:ground { shape = shape.line(corners) }
  local ball = scene:ball { radius = 0.15, at = vec(0.3, -0.2, 0), restitution = 1, friction = 0, density = 10 }
  ball.velocity = vec(math.cos($angle), math.sin($angle), 0) * $speed
]]

test("a ball in a closed room of lines keeps its energy, along which of a line's triangles it goes", function()
  for _, speed in ipairs { 20, 60, 120 } do
    for _, sides in ipairs { 4, 5, 12 } do
      for angle = 0.1, 1.5, 0.2 do
        expect(math.abs(lost(room, { speed = speed, sides = sides, angle = angle }, 5))):below(2e-3)
      end
    end
  end
end)

local corner = [[
  scene.step = 1 / $hz
  if $flat then scene.plane = "xy" end
  scene:ground { shape = $ground }
  local box = scene:box { size = vec(0.4, 0.3, 0.35), density = 20, at = vec(0, 2, 0), restitution = 1, friction = 0,
                          orientation = quat(vec(0, 0, 1), $angle) }
  box.velocity = vec(0.7, -4, 0)
]]

local grounds = {
  plane = { "false", "shape.plane { at = vec(0, 0, 0), normal = vec(0, 1, 0) }" },
  box = { "false", "shape.box { size = vec(40, 2, 40), at = vec(0, -1, 0) }" },
  mesh = { "false", "shape.mesh({ vec(-20, 0, 20), vec(20, 0, 20), vec(20, 0, -20), vec(-20, 0, -20) }, { { 1, 2, 3 }, { 1, 3, 4 } })" },
  ["line in a plane"] = { "true", "shape.line { vec(-20, 0, 0), vec(20, 0, 0) }" },
  ["box in a plane"] = { "true", "shape.box { size = vec(40, 2, 40), at = vec(0, -1, 0) }" },
}

for name, ground in pairs(grounds) do
  test("a box that falls on its corners keeps its energy: " .. name, function()
    for hz, bound in pairs { [60] = 2e-3, [240] = 4e-4 } do
      for angle = 0.1, 1.5, 0.2 do
        expect(math.abs(lost(corner, { hz = hz, angle = angle, flat = ground[1], ground = ground[2] }, 3))):below(bound)
      end
    end
  end)
end

test("ten balls in a closed box keep their energy for 20 s, whatever they strike at once", function()
  for _, case in ipairs { { flat = "false", bound = 3e-3 }, { flat = "true", bound = 2e-2 } } do
    for seed = 1, 4 do
      expect(math.abs(lost([[
        scene.step, scene.seed, scene.gravity = 1 / 240, $seed, vec(0, 0, 0)
        local flat = $flat
        if flat then scene.plane = "xy" end
        for _, d in ipairs { vec(1, 0, 0), vec(0, 1, 0), vec(0, 0, 1) } do
          for side = -1, 1, 2 do
            if not (flat and d.z ~= 0) then scene:ground { shape = shape.plane { at = d * -side, normal = d * side } } end
          end
        end
        for i = 0, 9 do
          local ball = scene:ball { radius = 0.15, at = vec(-0.7 + 0.35 * (i % 5), -0.6 + 0.4 * (i // 5), flat and 0 or -0.6),
                                    restitution = 1, friction = 0 }
          ball.velocity = vec(math.random(), math.random(), flat and 0.5 or math.random()) * 4 - vec(2, 2, 2)
        end
      ]], { seed = seed, flat = case.flat }, 20))):below(case.bound)
    end
  end
end)

test("a bead that turns a corner and strikes a box in the same step passes its speed on", function()
  for _, hz in ipairs { 60, 240 } do
    for phase = 0, 11 do
      local scene = open_text(([[
        scene.step, scene.gravity = 1 / %d, vec(0, 0, 0)
        local ball = scene:ball { radius = 0.1, at = vec(-0.3 - 0.05 * %d / 12, 0, 0), velocity = vec(3, 0, 0), mass = 1,
                                  restitution = 1, friction = 0, points = { o = vec(0, 0, 0) } }
        scene:on_path(ball.o, { vec(-2, 0, 0), vec(0, 0, 0), vec(0, 9, 0) })
        scene:box { size = 0.5, at = vec(0, 0.36, 0), mass = 1, restitution = 1, friction = 0, name = "box" }
      ]]):format(hz, phase))
      scene:advance(0.5)
      expect(scene.bodies[1].velocity:length()):below(1e-6)
      expect(scene.bodies[2].velocity.y):near(3, 1e-6)
    end
  end
end)

local tied = {
  ["two welded boxes"] = { bound = 1e-9, text = [[
    local a = scene:box { size = 0.4, at = vec(0, 1.3, 0), density = 100, restitution = 1, friction = 0 }
    scene:weld(a, scene:box { size = 0.4, at = vec(0.4, 1.3, 0), density = 100, restitution = 1, friction = 0 })
  ]] },
  ["a bar on a nail"] = { bound = 5e-3, text = [[
    scene:nail(scene:box { size = vec(1, 0.2, 0.2), at = vec(0.5, 0.5, 0), density = 100, restitution = 1, friction = 0,
                           points = { end_ = vec(-0.5, 0, 0) } }.end_)
  ]] },
}

for name, case in pairs(tied) do
  test("what is tied leaves the floor with the speed with which it met it: " .. name, function()
    for _, hz in ipairs { 60, 240, 960 } do
      local scene = open_text(("scene.step = 1 / %d scene:floor {} "):format(hz) .. case.text)
      scene:advance(0.001)
      local before = scene.energy.total
      scene:advance(5)
      expect(scene.energy.total / before):near(1, case.bound)
    end
    local left = {}
    for _, hz in ipairs { 240, 960 } do
      local scene = open_text(("scene.step = 1 / %d scene:floor {} "):format(hz) .. case.text:gsub("restitution = 1", "restitution = 0.9"))
      scene:advance(2.2)
      left[#left + 1] = scene.energy.total
    end
    expect(left[1]):near(left[2], 2e-3 * left[2])
  end)
end

test("balls that graze each other part as the closed form says", function()
  for _, hz in ipairs { 60, 240 } do
    for _, speed in ipairs { 1, 10 } do
      for _, offset in ipairs { 0.15, 0.285, 0.298 } do
        for phase = 0, 0.9, 0.3 do
          local scene = open_text(([[
            local speed, hz = %g, %g
            scene.step, scene.gravity = 1 / hz, vec(0, 0, 0)
            local at = vec(-0.5 - %g * speed / hz, %g, 0)
            scene:ball { radius = 0.15, at = at, velocity = vec(speed, 0, 0), mass = 1, restitution = 1, friction = 0 }
            scene:ball { radius = 0.15, mass = 1, restitution = 1, friction = 0 }
          ]]):format(speed, hz, phase, offset))
          scene:advance(1.2 / speed)
          local struck, energy = scene.bodies[2].velocity, scene.energy.kinetic
          expect(energy):near(speed ^ 2 / 2, 1e-5 * speed ^ 2)
          expect(struck:length()):near(speed * math.sqrt(1 - (offset / 0.3) ^ 2), 1e-3 * speed)
        end
      end
    end
  end
end)

test("bodies that turn while they strike each other keep their angular momentum", function()
  local pairs_ = {
    { flat = false, a = [[shape = shape.box { size = vec(0.4, 0.3, 0.35), density = 500 }, at = vec(1.095, -0.102, -0.06),
        orientation = quat(vec(-0.84, 1.03, -0.91):normalized(), 3.05), velocity = vec(-3.315, 0.308, 0)]],
      b = [[shape = shape.cylinder(0.25, 0.08, { density = 500 }), at = vec(-1.1, 0.013, -0.02),
        orientation = quat(vec(-0.66, 1.99, -1.25):normalized(), 3.76), velocity = vec(3.329, -0.039, 0)]], bound = 2e-2 },
    { flat = true, a = [[shape = shape.box { size = vec(0.8, 0.1, 0.3), restitution = 1, friction = 0 }, at = vec(1, 0.05, 0),
        orientation = quat(vec(0, 0, 1), 0.9), velocity = vec(-6, 0, 0), spin = vec(0, 0, 9)]],
      b = [[shape = shape.box { size = vec(0.8, 0.1, 0.3), restitution = 1, friction = 0 }, at = vec(-1, 0, 0),
        orientation = quat(vec(0, 0, 1), 2.1), velocity = vec(6, 0.4, 0), spin = vec(0, 0, -7)]], bound = 1e-9 },
  }
  for _, case in ipairs(pairs_) do
    for _, hz in ipairs { 60, 240 } do
      local scene = open_text(("scene.gravity, scene.step = vec(0, 0, 0), 1 / %d\n"):format(hz)
        .. (case.flat and 'scene.plane = "xy"\n' or "") .. "scene:body { " .. case.a .. " }\nscene:body { " .. case.b .. " }")
      scene:advance(0.001)
      local start, size = scene.angular_momentum, 0
      for _, body in ipairs(scene.bodies) do size = size + body.angular_momentum:length() + body.position:cross(body.momentum):length() end
      scene:advance(0.9)
      expect((scene.angular_momentum - start):length()):below(case.bound * size)
    end
  end
end)

local balls_in_room = [[
  scene.step, scene.gravity, scene.seed = 1 / $hz, vec(0, 0, 0), $seed
  $room
  local function some() return 2 * math.random() - 1 end
  for i = 0, 9 do
    scene:ball { radius = 0.2, at = vec(-1.5 + i % 4, -1 + i // 4, 0), velocity = vec(some(), some(), $deep * some()) * $speed,
                 restitution = 1, friction = 0, density = 100 }
  end
]]
local rooms = {
  ["in a plane"] = [[
    scene.plane = "xy"
    scene:ground { shape = shape.line({ vec(-2, -2, 0), vec(2, -2, 0), vec(2, 2, 0), vec(-2, 2, 0), vec(-2, -2, 0) },
                                      { restitution = 1, friction = 0 }) }
  ]],
  ["in space"] = [[
    for axis = 1, 3 do
      for side = -1, 1, 2 do
        local at, size = { 0, 0, 0 }, { 6, 6, 6 }
        at[axis], size[axis] = 2.5 * side, 1
        scene:ground { at = vec(table.unpack(at)),
                       shape = shape.box { size = vec(table.unpack(size)), restitution = 1, friction = 0 } }
      end
    end
  ]],
}

for where, room in pairs(rooms) do
  local deep = where == "in space" and 1 or 0
  test("balls in a closed room keep their energy, though some meet several others in a step: " .. where, function()
    for seed = 1, 4 do
      expect(math.abs(lost(balls_in_room, { hz = 60, seed = seed, room = room, deep = deep, speed = 6 }, 10))):below(5e-3)
      expect(math.abs(lost(balls_in_room, { hz = 240, seed = seed, room = room, deep = deep, speed = 6 }, 10))):below(5e-4)
    end
  end)
end

test("a crowd of balls and boxes that run into each other keeps its energy and its angular momentum", function()
  for seed = 1, 5 do
    local scene = open_text(("scene.seed = %d\n"):format(seed) .. [[
      scene.step, scene.gravity = 1 / 60, vec(0, 0, 0)
      local function some() return 0.5 * (2 * math.random() - 1) end
      for i = 0, 24 do
        local x, y = 2 - i % 5, 2 - i // 5
        local rest = { at = vec(-0.6 * x, -0.6 * y, 0.1 * some()), velocity = vec(x + some(), y + some(), some()),
                       restitution = 1, friction = 0, density = 100 }
        if i % 2 == 0 then rest.radius = 0.15 scene:ball(rest) else rest.size = vec(0.3, 0.3, 0.3) scene:box(rest) end
      end
    ]])
    local energy, turning = scene.energy.total, scene.angular_momentum
    scene:advance(3)
    expect(math.abs(1 - scene.energy.total / energy)):below(1e-3)
    expect((scene.angular_momentum - turning):length()):below(1e-9)
  end
end)

local tumbling = [[
  scene.step, scene.seed = 1 / $hz, $seed
  $ground
  local function some() return 2 * math.random() - 1 end
  scene:box { size = vec(0.4, 0.4, 0.4), at = vec(0, 1.2, 0), orientation = quat(vec(some(), some(), some()):normalized(), 3 * some()),
              velocity = vec(some(), some(), some()), spin = vec(some(), some(), some()) * 3,
              restitution = 1, friction = 0, density = 100 }
]]

for what, ground in pairs { plane = "scene:floor { restitution = 1, friction = 0 }",
                            box = [[scene:ground { shape = shape.box { size = vec(60, 2, 60), restitution = 1, friction = 0 },
                                                   at = vec(0, -1, 0) }]] } do
  test("a box that tumbles on a " .. what .. " keeps its energy, though its corners strike one after the other", function()
    for seed = 1, 8 do
      for _, hz in ipairs { 60, 240 } do
        expect(math.abs(lost(tumbling, { hz = hz, seed = seed, ground = ground }, 5))):below(2e-3)
      end
    end
  end)
end

local head_on = [[
  scene.step, scene.gravity, scene.seed = 1 / 60, vec(0, 0, 0), $seed
  local function some() return 2 * math.random() - 1 end
  for side = -1, 1, 2 do
    scene:box { size = vec(0.4 + 0.2 * some(), 0.4 + 0.2 * some(), 0.4 + 0.2 * some()), at = vec(side, 0.3 * some(), 0.3 * some()),
                velocity = vec(-side * $speed, 0, 0), spin = vec(some(), some(), some()) * 5,
                orientation = quat(vec(some(), some(), some()):normalized(), 3 * some()), restitution = 1, friction = 0 }
  end
]]

for speed, bound in pairs { [5] = 4e-4, [15] = 1e-3, [40] = 1e-3 } do
  test("two boxes that meet head-on keep their angular momentum and energy, however they are turned: at " .. speed .. " m/s", function()
    local lost, of = 0, 200
    for seed = 1, of do
      local scene = open_text((head_on:gsub("%$(%w+)", { seed = seed, speed = speed })))
      local energy, turning = scene.energy.total, scene.angular_momentum
      scene:advance(2.5 / speed)
      local change = math.abs(1 - scene.energy.total / energy)
      expect(change):below(6e-2) -- where two corners strike within a sub-step
      lost = lost + change / of
      expect((scene.angular_momentum - turning):length()):below(1e-9 * scene.bodies[1].mass)
    end
    expect(lost):below(bound)
  end)
end

test("what a law pulls down rebounds to the height that it fell from, as under gravity", function()
  local scene = open_text([[
    scene.step, scene.gravity = 1 / 60, vec(0, 0, 0)
    scene:floor { restitution = 1, friction = 0 }
    local ball = scene:ball { name = "ball", radius = 0.1, points = { centre = vec(0, 0, 0) }, at = vec(0, 1.1, 0), restitution = 1, friction = 0 }
    scene:connect(ball.centre, vec(0, -1000, 0), force.spring { stiffness = ball.mass * 9.81e-3, length = 0.1 })
  ]])
  local ball, highest = scene:find "ball", 0
  for _ = 1, 600 do
    scene:step()
    if scene.time > 8 then highest = math.max(highest, ball.position.y) end
  end
  expect(highest):near(1.1, 2e-3)
  expect(scene.error.worst_energy):below(1e-5)
end)
