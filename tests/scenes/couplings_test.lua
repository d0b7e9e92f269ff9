-- Gears, racks, pulleys and screws as scripts make them; closed forms are in tests/engine/coupling_constraints_test.cpp.
local function open_with(code)
  return open_text([[
    local z = vec(0, 0, 1)
    local function on_axle(body)
      scene:nail(body.hub)
      scene:align(body, z, z, { angle = 0 })
      return body
    end
    local function disc(at, moment, name, points)
      return scene:body { at = at, mass = 1, inertia = vec(0.5, 0.5, 1) * moment, name = name,
                          points = points or { hub = vec(0, 0, 0) } }
    end
    local a, b = on_axle(disc(vec(0, 0, 0), 0.2, "a")), on_axle(disc(vec(1, 0, 0), 0.4, "b"))
    local p, q = scene:particle { at = vec(0, 1, 0) }, scene:particle { at = vec(1, 1, 0) }
  ]] .. code)
end

test("gear: a motor on one wheel turns the other, and says what it is", function()
  local scene = open_with [[
    scene:gear(a, b, { ratio = -2, axis = z, name = "pair" })
    scene:motor(a, { axis = z, speed = 4 })
  ]]
  scene:advance(2)
  local gear = scene:find "pair"
  expect(scene:find("b").spin.z):near(-2, 1e-9)
  expect(gear.a):equal(scene:find "a")
  expect(gear.carrier):equal(nil)
  expect(gear.turned):near(8, 1e-3)
  expect(tostring(gear)):equal "gear 'pair'"
end)

test("gear: it breaks at a torque, and the other wheel stays behind", function()
  local scene = open_with [[
    scene:gear(a, b, { ratio = -2, axis = z, name = "pair", breaks_at = { torque = 1 } })
    scene:on("step", function() a:twist(vec(0, 0, 50)) end)
  ]]
  scene:advance(0.5)
  expect(scene:find "pair"):equal(nil)
  expect(math.abs(scene:find("b").spin.z)):below(0.25 * scene:find("a").spin.z)
end)

test("gear: a new ratio meshes where the wheels are, and one of time turns without a jump", function()
  local scene = open_with [[
    local gear = scene:gear(a, b, { ratio = -2, axis = z })
    scene:motor(a, { axis = z, speed = 4 })
    scene:at(1, function() gear.ratio = 4 end)
    scene:at(2, function() gear.ratio = function(t) return 4 + (t - 2) end end)
  ]]
  scene:advance(1.9)
  expect(scene:find("b").spin.z):near(1, 1e-9)
  scene:advance(1.1)
  expect(scene:find("b").spin.z):near(0.8, 1e-3)
end)

test("gear: off and on again it meshes where the wheels are, and a slack rope keeps its length", function()
  local scene = open_with [[
    scene.gravity = vec(0, 0, 0)
    local gear = scene:gear(a, b, { ratio = -2, axis = z })
    local rope = scene:pulley(p, vec(0, 4, 0), vec(1, 4, 0), q, { length = 9, name = "rope" })
    a.spin, b.spin = vec(0, 0, 4), vec(0, 0, -2)
    scene:at(0.5, function() gear.enabled, rope.enabled = false, false end)
    scene:at(0.6, function() b.spin = vec(0, 0, 7) end)
    scene:at(0.7, function() b.spin = vec(0, 0, -2) end)
    scene:at(1.0, function() gear.enabled, rope.enabled = true, true end)
    scene:probe("turned", function() return gear.turned end)
  ]]
  scene:advance(1.5)
  expect(scene.stats.fallback_steps):equal(0)
  expect(scene:find("a").spin.z):near(4, 1e-9)
  expect(scene:read "turned"):near(6, 1e-3)
  expect(scene:find("rope").length):equal(9)
end)

test("a planetary gear turns as Willis's formula says, with more planets than it needs", function()
  local scene = open_with [[
    local at = vec(3, 0, 0)
    local sun, ring = on_axle(disc(at, 0.1)), on_axle(disc(at, 0.1))
    local arm = on_axle(disc(at, 0.1, "arm", { { at = vec(0.5, 0, 0) }, { at = vec(-0.3, 0.4, 0) },
                                               { at = vec(-0.3, -0.4, 0) }, hub = vec(0, 0, 0) }))
    for i = 1, 3 do
      local pin = arm.points[i]
      local planet = disc(pin.position, 0.01)
      scene:hinge(pin, planet.hub, { axis = z })
      scene:gear(planet, sun, { ratio = -0.3 / 0.2, axis = z, carrier = arm })
      scene:gear(planet, ring, { ratio = 0.7 / 0.2, axis = z, carrier = arm })
    end
    scene:motor(sun, { axis = z, speed = 5 })
    scene:motor(ring, { axis = z, speed = -1 })
  ]]
  scene:advance(3)
  expect(scene:find("arm").spin.z):near(0.3 * 5 - 0.7 * 1, 1e-6)
  expect(scene.stats.fallback_steps):equal(0)
end)

test("pulley: a tackle holds a stone of twice the weight", function()
  local scene = open_with [[
    q.mass = 2 * p.mass
    scene:pulley(p, vec(0, 4, 0), vec(1, 4, 0), q, { ratio = 2, name = "rope" })
  ]]
  scene:advance(2)
  local rope = scene:find "rope"
  expect(rope.b.position.y):near(1, 1e-9)
  expect(rope.force):near(rope.a.particle.mass * 9.81, 1e-9)
  expect(rope.length):near(9, 1e-12)
end)

test("what is asked wrongly of a coupling is refused by name", function()
  local cases = {
    { "scene:gear(a, a, { ratio = 1, axis = z })", "it needs two bodies" },
    { "scene:gear(a, b, { axis = z })", "gear: ratio must be given" },
    { "scene:gear(a, b, { ratio = 2 })", "gear: axis must be given" },
    { "scene:gear(a, b, { ratio = 0 / 0, axis = z })", "ratio must be a finite number" },
    { "scene:gear(a, b, { ratio = 2, axis = z, carier = a })", "unknown field 'carier'" },
    { "scene:rack(a, p, { radius = 0, axis = z, along = vec(1, 0, 0) })", "radius must not be 0" },
    { "scene:rack(a, p, { radius = 1, axis = z })", "rack: along must be given" },
    { "scene:pulley(p, vec(0, 3, 0), vec(1, 3, 0), q, { ratio = -1 })", "ratio must be > 0" },
    { "scene:pulley(p, p, vec(1, 3, 0), q)", "its own anchor" },
    { "scene:screw(a.hub, p, { lead = 1, axis = z })", "must be of bodies" },
  }
  for _, case in ipairs(cases) do expect(function() open_with(case[1]) end):fails(case[2]) end
end)

test("in a plane wheels turn about its normal, and a screw has no way", function()
  local code = [[
    scene.plane = "xy"
    local function disc(at, name)
      local made = scene:body { at = at, mass = 1, inertia = vec(1, 1, 1), name = name, points = { hub = vec(0, 0, 0) } }
      scene:nail(made.hub)
      return made
    end
    local a, b = disc(vec(0, 0, 0)), disc(vec(1, 0, 0), "b")
    scene:gear(a, b, { ratio = -3 })
    scene:motor(a, { speed = 3 })
  ]]
  local scene = open_text(code)
  scene:advance(1)
  expect(scene:find("b").spin.z):near(-1, 1e-9)
  expect(function() open_text(code .. "scene:gear(a, b, { ratio = 1, axis = vec(1, 0, 0) })") end):fails "must be along z"
  expect(function() open_text(code .. "scene:screw(a.hub, b.hub, { lead = 1, axis = vec(0, 0, 1) })") end):fails "must have no z"
end)

test("a string that is wound in works by hand", function()
  local scene = open_text [[
    scene.step = 1 / 240
    local p = scene:particle { at = vec(0, 0, 0), mass = 3 }
    scene:string({ p, vec(0, 3, 0) }, { length = function(t) return 3 - 0.5 * t * t end })
  ]]
  local before, _ = scene.energy.total, scene.ledger
  scene:advance(1)
  expect(scene.ledger.hand):near(scene.energy.total - before, 1e-3)
  expect(scene.ledger.limit):near(0, 1e-3)
end)

test("couplings: what is drawn into a string or a pulley that is too short comes in smoothly, and its work is told", function()
  local scene = open_text [[
    local a = scene:particle { name = "a", at = vec(0, -2, 0) }
    scene:string({ vec(0, 0, 0), a }, { length = 1 })
    local l = scene:particle { name = "l", at = vec(10, -2, 0) }
    local r = scene:particle { name = "r", at = vec(12, -2, 0) }
    scene:pulley(l, vec(10, 0, 0), vec(12, 0, 0), r, { length = 3 })
  ]]
  scene:advance(0.2)
  local left = 3 * math.exp(-2)  -- (1 + t/τ) exp(-t/τ) of 1 m, after two time constants
  expect(-scene:find("a").position.y - 1):near(left, 1e-2)
  expect(-scene:find("l").position.y - scene:find("r").position.y - 3):near(left, 1e-2)
  scene:advance(2.8)
  expect(scene:find("a").velocity:length()):below(1e-3)
  expect(scene.error.worst_energy):below(1e-5)
end)

test("gear, rack: a motor with a limit that turns wheels without load gives nothing", function()
  for _, most in ipairs { 1e3, 1e9 } do
    local scene = open_with([[
      scene.gravity = vec(0, 0, 0)
      scene.step = 1 / 60
      a.spin, b.spin, q.velocity = -30 * z, 6 * z, vec(-3, 0, 0)
      scene:gear(a, b, { ratio = -5, axis = z })
      scene:slider(q, { axis = vec(1, 0, 0) })
      scene:rack(b, q, { radius = 0.5, axis = z, along = -1 * vec(1, 0, 0) })
      scene:motor(b, { axis = z, speed = 6, max_torque = ]] .. most .. [[, name = "motor" })
    ]])
    scene:advance(2)
    expect(scene:find("motor").torque.z):near(0, 1e-6)
    expect(scene.error.worst_energy):below(3e-3)
  end
end)

test("gear: a motor at its limit speeds wheels up as one would that is held by nothing", function()
  local scene = open_with [[
    scene.gravity = vec(0, 0, 0)
    scene:gear(a, b, { ratio = -2, axis = z })
    scene:motor(a, { axis = z, speed = 1e5, max_torque = 30 })
  ]]
  scene:advance(2)
  expect(scene:find("a").spin.z):near(30 * 2 / (0.2 + 0.4 / 4), 6)
  expect(scene.error.worst_energy):below(5e-3)
end)
