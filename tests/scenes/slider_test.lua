-- Sliders: what slides along a body, or along the world.
local x, y, z = vec(1, 0, 0), vec(0, 1, 0), vec(0, 0, 1)

--- Bodies `a` and `b`, far from all else and not turning, each with its `middle` and an `end`.
local function open_with(code)
  return open_text([[
    local x, y, z = vec(1, 0, 0), vec(0, 1, 0), vec(0, 0, 1)
    local function block(name, at, mass)
      return scene:body { at = at, mass = mass or 1, inertia = vec(0.2, 0.3, 0.4) * (mass or 1), name = name,
                          points = { middle = vec(0, 0, 0), edge = vec(0.3, 0.2, 0.1) } }
    end
  ]] .. code)
end

test("slider: a bead on a rod that turns steadily goes out as cosh", function()
  local scene = open_with [[
    scene.gravity = vec(0, 0, 0)
    local rod = block("rod", vec(0, 0, 0))
    scene:nail(rod.middle)
    scene:align(rod, z, z, { angle = 0 })
    scene:motor(rod, { axis = z, speed = 2 })
    local bead = scene:particle { at = vec(0.1, 0, 0), velocity = vec(0, 0.2, 0), mass = 0.5 }
    scene:slider(bead, rod, { axis = x, name = "bead" })
  ]]
  scene:advance(1.5)
  expect(scene:find("bead").slid):near(0.1 * (math.cosh and math.cosh(3) or (math.exp(3) + math.exp(-3)) / 2) - 0.1, 1e-4)
end)

test("slider: two bodies that slide along each other in space keep momenta and energy", function()
  local scene = open_with [[
    scene.gravity = vec(0, 0, 0)
    local a, b = block("a", vec(0, 0, 0)), block("b", vec(0.5, 0.4, 0.1), 3)
    scene:slider(a.edge, b, { axis = vec(1, 2, 0.5), name = "slider" })
    scene:connect(a.middle, b.middle, force.spring { stiffness = 40, length = 0.5 })
    a.velocity, a.spin, b.spin = vec(1, 0, -1), vec(1, 3, 2), vec(1, 3, 2)
  ]]
  scene:advance(0.01)
  local momentum, spin = scene.momentum, scene.angular_momentum
  local a, b = scene:find "a", scene:find "b"
  scene:advance(10)
  expect(scene.momentum):near(momentum, 1e-9)
  expect(scene.angular_momentum):near(spin, 1e-9)
  expect(scene.error.energy):below(2e-4)
  expect(scene.error.worst_constraint):below(1e-9)
  expect(a.spin):near(b.spin, 1e-9)
  expect(math.abs(scene:find("slider").slid)):above(1e-3)
end)

test("slider: on a slope of the world it falls by g sin", function()
  local scene = open_with [[
    local a = block("a", vec(0, 0, 0))
    scene:slider(a.edge, { axis = vec(4, -3, 0), name = "slider" })
  ]]
  scene:advance(1)
  local slider = scene:find "slider"
  expect(slider.slid):near(0.5 * 9.81 * 0.6, 1e-6)
  expect(slider.force):near(vec(9.81 * 0.6 * 0.8, 9.81 * 0.8 * 0.8, 0), 1e-6)
  expect(scene:find("a").spin):near(vec(0, 0, 0), 1e-12)
  expect(slider.carrier):equal(nil)
end)

test("slider: a block on a wedge that may move takes the wedge along, as Newton has it", function()
  local scene = open_with [[
    local wedge, a = block("wedge", vec(0, 0, 0), 3), block("a", vec(0.2, 0.5, 0), 1)
    scene:slider(wedge.middle, { axis = x })
    scene:slider(a.middle, wedge, { axis = vec(4, -3, 0), name = "slider" })
  ]]
  scene:advance(1)
  local sine, cosine = 0.6, 0.8
  local wedge = -9.81 * sine * cosine / (3 + sine * sine)
  expect(scene:find("wedge").velocity):near(vec(wedge, 0, 0), 1e-6)
  expect(scene.momentum.x):near(0, 1e-9)
end)

test("slider: it stops at its ends, and pulls what it slides on along", function()
  local scene = open_with [[
    scene.gravity = vec(0, 0, 0)
    local a, b = block("a", vec(0, 0, 0)), block("b", vec(1, 0, 0))
    scene:slider(a.middle, b, { axis = x, min = -0.2, max = 0.5, name = "slider" })
    a.velocity = vec(2, 0, 0)
  ]]
  scene:advance(0.2)
  expect(scene:find("slider").slid):near(0.4, 1e-9)
  expect(scene:find("b").velocity):near(vec(0, 0, 0), 1e-9)
  scene:advance(1)
  expect(scene:find("slider").slid):near(0.5, 1e-6)
  expect(scene:find("b").velocity):near(vec(1, 0, 0), 1e-9)
  expect(scene:find("a").velocity):near(vec(1, 0, 0), 1e-9)
  expect(scene.error.energy):below(1e-9)
end)

test("slider: a length as a function of time lifts, and tells the force that it takes", function()
  local scene = open_with [[
    local frame, a = block("frame", vec(0, 0, 0)), block("a", vec(0, 1, 0), 2)
    scene:nail(frame.middle)
    scene:align(frame, x, x, { angle = 0 })
    scene:align(frame, y, y, { angle = 0 })
    scene:slider(a.middle, frame, { axis = y, length = function(t) return 0.5 * t * t end, name = "lift" })
  ]]
  scene:advance(1)
  local lift = scene:find "lift"
  expect(lift.slid):near(0.5, 1e-9)
  expect(lift.length):near(0.5, 1e-9)
  expect(lift.force):near(vec(0, 2 * 10.81, 0), 1e-4)
  expect(scene:find("a").velocity.y):near(1, 1e-6)
  expect(scene.error.energy):below(1e-6)
end)

test("slider: a length that jumps takes back as much work as it gave", function()
  local scene = open_with [[
    scene.gravity = vec(0, 0, 0)
    local a, b = block("a", vec(0, 0, 0)), block("b", vec(1, 0, 0))
    scene:slider(a.middle, b, { axis = x, length = function(t) return t > 1 and 0.02 or 0 end })
  ]]
  scene:advance(2)
  expect(scene.energy.kinetic):near(0, 1e-9)
  expect(scene.error.worst_energy):below(1e-6)
end)

test("slider: a length that is written draws it there, and one that slid is kept from then on", function()
  local scene = open_with [[
    scene.gravity = vec(0, 0, 0)
    local a, b = block("a", vec(0, 0, 0)), block("b", vec(1, 0, 0))
    local slider = scene:slider(a.middle, b, { axis = x, name = "slider" })
    scene:at(0.5, function() slider.length = 0.3 end)
  ]]
  scene:advance(3)
  expect(scene:find("slider").slid):near(0.3, 1e-6)
  expect(scene:find("b").position.x - scene:find("a").position.x):near(0.7, 1e-6)
  expect(scene.momentum):near(vec(0, 0, 0), 1e-9)
end)

test("slider: a pin in a slot turns; what does not turn keeps its orientation to the carrier", function()
  local scene = open_with [[
    scene.gravity = vec(0, 0, 0)
    local a, b, c = block("a", vec(0, 0, 0)), block("b", vec(1, 0, 0)), block("c", vec(0, 3, 0))
    scene:slider(a.middle, b, { axis = y, turns = true })
    scene:slider(c.middle, b, { axis = y })
    a.spin = vec(0, 0, 2)
    b.spin = vec(0, 1, 0)
  ]]
  scene:advance(1)
  expect(scene:find("a").spin.z):near(2, 0.2)
  expect(scene:find("c").spin):near(scene:find("b").spin, 1e-9)
  expect(scene.error.worst_constraint):below(1e-9)
end)

test("slider: in a plane it slides as in space", function()
  local code = [[
    local cart, bob = block("cart", vec(0, 0, 0), 2), scene:particle { at = vec(1, 0, 0), name = "bob" }
    scene:slider(cart.middle, { axis = x, min = -2, max = 0.1 })
    scene:rod(bob, cart.middle)
  ]]
  local flat, space = open_with("scene.plane = 'xy' " .. code), open_with(code)
  flat:advance(2)
  space:advance(2)
  expect(flat:find("cart").position):near(space:find("cart").position, 1e-9)
  expect(flat:find("bob").position):near(space:find("bob").position, 1e-9)
  expect(flat.error.energy):below(1e-4)
end)

test("slider: it breaks at a load, and ends with its carrier", function()
  local scene = open_with [[
    local a, b = block("a", vec(0, 0, 0), 4), block("b", vec(0, 3, 0))
    scene:slider(a.middle, { axis = x, breaks_at = { force = 30 }, name = "weak" })
    scene:slider(b.middle, a, { axis = x, name = "strong" })
    scene:at(0.5, function() a:remove() end)
  ]]
  scene:advance(0.1)
  expect(scene:find "weak"):equal(nil)
  expect(scene:find("strong").enabled):equal(true)
  scene:advance(1)
  expect(scene:find "strong"):equal(nil)
end)

test("slider: bad options are refused", function()
  local function refused(call, message)
    expect(function() open_with("local a, b = block('a', vec(0, 0, 0)), block('b', vec(1, 0, 0)) " .. call) end):fails(message)
  end
  refused("scene:slider(a.middle, b)", "axis must be given")
  refused("scene:slider(a.middle, a, { axis = x })", "both are body")
  refused("scene:slider(a.middle, b, { axis = vec(0, 0, 0) })", "axis")
  refused("scene:slider(a.middle, b, { axis = x, length = 1, max = 2 })", "either keeps a length or has ends")
  refused("scene:slider(a.middle, b, { axis = x, min = 1, max = 0 })", "min")
  refused("scene:slider(a.middle, b, { axis = x, length = 0 }).max = 1", "keeps a length")
  refused("scene.plane = 'xy' scene:slider(a.middle, b, { axis = z })", "axis")
end)

test("slider: what it carries presses with its weight and what speeds it up, at steps of one and of several drifts", function()
  for _, rate in ipairs { 60, 120, 240 } do
    local scene = open_text(([[
      scene.step = 1 / %d
      local table = scene:body { mass = 20, shape = shape.box(2, 0.2, 2), points = { middle = vec(0, 0, 0) } }
      scene:slider(table.middle, { axis = vec(0, 1, 0), length = function(t) return 0.1 * (1 - math.cos(6 * t)) end, name = "lift" })
      scene:box { name = "rider", size = 0.5, mass = 3, at = vec(0, 0.35, 0) }
    ]]):format(rate))
    local rider, lift, last = scene:find "rider", scene:find "lift"
    while scene.time < 1 do
      scene:step()
      local force = 0
      for _, contact in ipairs(rider.contacts) do force = force + contact.force.y end
      local lifts = (rider.velocity.y - (last or 0)) * rate + 9.81
      if last then expect(force):near(3 * lifts, 0.02) end
      if last then expect(lift.force.y):near(23 * lifts, 0.2) end
      last = rider.velocity.y
    end
    expect(scene.error.worst_energy):below(5e-3)
  end
end)
