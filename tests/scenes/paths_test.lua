-- Beads and other things that keep to a path.

test("a bead keeps its speed round corners of its path, wherever in a step they are", function()
  for _, degrees in ipairs { 5, 30, 45, 60, 75, 90, 120, 150, 175, 180 } do
    for _, before in ipairs { 1, 1.01, 1.02, 1.03, 1.04 } do
      local scene = open_text(([[
        scene.gravity, scene.step = vec(0, 0, 0), 1 / 60
        local angle = math.rad(%g)
        local bead = scene:particle { at = vec(-%g, 0, 0), velocity = vec(3, 0, 0) }
        scene:on_path(bead, { vec(-2, 0, 0), vec(0, 0, 0), 6 * vec(math.cos(angle), math.sin(angle), 0) })
      ]]):format(degrees, before))
      scene:advance(1)
      expect(scene.particles[1].velocity:length()):near(3, 1e-9)
      expect(scene.stats.fallback_steps):equal(0)
    end
  end
end)

test("a bead goes round polygons, and keeps its speed at every corner", function()
  for _, sides in ipairs { 3, 4, 5, 6, 8, 12 } do
    local scene = open_text(([[
      scene.gravity = vec(0, 0, 0)
      local corners = {}
      for k = 1, %d do corners[k] = quat(vec(0, 0, 1), 2 * math.pi * k / %d):rotate(vec(1, 0, 0)) end
      local bead = scene:particle { at = (corners[1] + corners[2]) / 2, velocity = 3 * (corners[2] - corners[1]):normalized() }
      scene:on_path(bead, corners, { closed = true })
    ]]):format(sides, sides))
    for _ = 1, 40 do
      scene:advance(0.25)
      expect(scene.particles[1].velocity:length()):near(3, 1e-9)
    end
  end
end)

test("what hangs on a bead, and beads on a rod, go round a square and keep their energy", function()
  for what, code in pairs {
    pendulum = "scene:rod(bead, scene:particle { at = vec(1, -0.5, 0.3), mass = 0.5 })",
    box = "scene:hinge(bead, scene:box({ size = vec(0.2, 0.6, 0.1), mass = 1, at = vec(1, -0.3, 0), points = { top = vec(0, 0.3, 0) } }).top)",
    rod = "local other = scene:particle { at = vec(0.8, 0, 0), velocity = vec(8, 0, 0) } scene:on_path(other, corners, { closed = true }) scene:rod(bead, other)",
  } do
    for _, rate in ipairs { 60, 240, 960 } do
      local scene = open_text(([[
        scene.step = 1 / %d
        local corners = { vec(0, 0, 0), vec(2, 0, 0), vec(2, 2, 0), vec(0, 2, 0) }
        local bead = scene:particle { at = vec(1, 0, 0), velocity = vec(8, 0, 0) }
        scene:on_path(bead, corners, { closed = true })
      ]]):format(rate) .. code)
      scene:advance(3)
      expect(scene.error.worst_energy):below(1e-8)
      expect(scene.error.worst_constraint):below(1e-10)
      expect(scene.stats.fallback_steps):equal(0)
    end
  end
end)

test("a bead in a valley between straight pieces goes to and fro over its corner, comes to rest there by drag, and presses on it", function()
  for _, drag in ipairs { 0, 2 } do
    local scene = open_text(([[
      local bead = scene:particle { at = vec(-1, 1, 0) }
      scene:on_path(bead, { vec(-2, 2, 0), vec(0, 0, 0), vec(1, 3, 0) }, { name = "valley" })
      if %g > 0 then scene:field(scene, force.drag { linear = %g }) end
    ]]):format(drag, drag))
    if drag == 0 then
      scene:advance(20)
      expect(scene.error.worst_energy):below(1e-10)
      expect(scene.particles[1].velocity:length()):above(0.1)
    else
      scene:advance(30)
      expect(scene.particles[1].position:length()):below(1e-6)
      expect(scene.particles[1].velocity:length()):below(1e-6)
      expect(scene:find("valley").force.y):near(9.81, 1e-6)
    end
    expect(scene.stats.fallback_steps):equal(0)
  end
end)

test("a bead goes over more corners than are looked at in a step", function()
  local scene = open_text [[
    scene.gravity, scene.step = vec(0, 0, 0), 1 / 60
    local corners = {}
    for k = 0, 4000 do corners[k + 1] = vec(0.01 * k, k % 2 == 0 and 0 or 0.01, 0) end
    local bead = scene:particle { at = vec(0.005, 0.005, 0), velocity = vec(5, 5, 0) }
    scene:on_path(bead, corners)
  ]]
  scene:advance(2)
  expect(scene.particles[1].velocity:length()):near(50 ^ 0.5, 1e-8)
  expect(scene.stats.fallback_steps):equal(0)
end)

test("a bead that begins beside its path by round-off, where two pieces meet, goes round it", function()
  for _, off in ipairs { -1e-10, -1e-15, 1e-15, 1e-12, 1e-10 } do
    local scene = open_text(([[
      scene.gravity = vec(0, 0, 0)
      local circle = {}
      for k = 0, 63 do circle[k + 1] = quat(vec(0, 0, 1), 2 * math.pi * k / 64):rotate(vec(1, 0, 0)) end
      local bead = scene:particle { at = vec(1 + %.17g, 0, 0), velocity = vec(0, 10, 0) }
      scene:on_path(bead, circle, { smooth = true, closed = true })
    ]]):format(off))
    scene:advance(1)
    expect(scene.stats.fallback_steps):equal(0)
    expect(scene.error.worst_energy):below(1e-9)
    expect(math.atan(scene.particles[1].position.y, scene.particles[1].position.x)):near(10 - 4 * math.pi, 0.002)
  end
end)

test("a bead keeps its speed round corners with steps that go backwards, and one that hangs on it turns a track's end in a plane", function()
  for _, phase in ipairs { 0.9, 0.95, 1, 1.03 } do
    local scene = open_text(([[
      scene.gravity, scene.step, scene.integrator = vec(0, 0, 0), 1 / 60, "suzuki4"
      local bead = scene:particle { at = vec(%g, 0, 0), velocity = vec(8, 0, 0) }
      scene:on_path(bead, { vec(0, 0, 0), vec(2, 0, 0), vec(2, 2, 0), vec(0, 2, 0) }, { closed = true })
    ]]):format(phase))
    scene:advance(3)
    expect(scene.particles[1].velocity:length()):near(8, 1e-9)
  end
  local scene = open_text [[
    scene.plane, scene.gravity = "xy", vec(0, 0, 0)
    local bead = scene:particle { at = vec(0.5, 0, 0), velocity = vec(5, 0, 0) }
    scene:on_path(bead, { vec(0, 0, 0), vec(2, 0, 0), vec(0, 0, 0) }, { closed = false })
    scene:rod(bead, scene:particle { at = vec(0.5, -0.7, 0), mass = 0.5 })
  ]]
  scene:advance(0.5)
  expect(scene.energy.kinetic):near(12.5, 1e-7)
end)

test("a point begins at the place of its path that it is on, however near a corner or another piece", function()
  local scene = open_text [[
    scene.gravity = vec(0, 0, 0)
    local track = { vec(0, 0, 0), vec(100, 0, 0), vec(100, 2, 0), vec(0, 2, 0) }
    for _, x in ipairs { 1, 20, 50, 95, 98, 99.99 } do
      local path = scene:on_path(scene:particle { at = vec(x, 0, 0) }, track)
      scene:result(tostring(x), path.along)
    end
  ]]
  for _, x in ipairs { 1, 20, 50, 95, 98, 99.99 } do expect(scene:result(tostring(x))):near(x / 100, 1e-12) end
end)

test("a kick along a closed path is kept, as along an open one", function()
  for _, closed in ipairs { false, true } do
    local scene = open_text(([[
      scene.gravity = vec(0, 0, 0)
      local bead = scene:particle { at = vec(0.3, 0, 0), name = "bead" }
      scene:on_path(bead, { vec(0, 0, 0), vec(1, 0, 0), vec(1, 1, 0), vec(0, 1, 0) }, { closed = %s })
      scene:at(0.1, function() bead:kick(vec(1, 0, 0)) end)
    ]]):format(closed))
    scene:advance(0.3)
    expect(scene:find("bead").velocity.x):near(1, 1e-9)
  end
end)

test("beads on springs that run through each other between corners keep to the accuracy wanted", function()
  local scene = open_text([[
    scene.plane, scene.accuracy, scene.step = "xy", 1e-4, 1 / 1000
    local corners = { vec(0, 0, 0), vec(2, 0, 0), vec(2, 2, 0), vec(0, 2, 0) }
    local last
    for k = 0, 4 do
      local bead = scene:particle { at = vec(0.2 + 0.3 * k, 0, 0), velocity = vec(8, 0, 0) }
      scene:on_path(bead, corners, { closed = true })
      if last then scene:connect(last, bead, force.spring { stiffness = 300 }) end
      last = bead
    end
  ]])
  scene:advance(0.96)
  for _, line in ipairs(scene.log) do expect((line.text:find("not reached", 1, true))):equal(nil) end
  expect(scene.error.worst_energy):below(3e-4)
end)
