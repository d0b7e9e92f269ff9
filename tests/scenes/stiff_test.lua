--- A bob on a steel wire: swings at steps a thousand times too long for the wire.
local function wire(options)
  return open_text(([[
    scene.step = 1 / 60
    local bob = scene:particle { at = vec(1, 0, 0), mass = 2, name = "bob" }
    local wire = scene:connect(vec(0, 0, 0), bob, force.spring { stiffness = 1e9, length = 1 }, { %s })
    scene:probe("tension", function() return wire.force end)
  ]]):format(options))
end

test("a connection solved with what it ties keeps its energy, whatever its stiffness", function()
  local scene = wire "implicit = true"
  scene:advance(5)
  expect(scene.error.worst_energy):below(1e-8)
  expect(scene:find("bob").position:length()):near(1, 1e-6)
  expect(scene.stats.fallback_steps):equal(0)
end)

test("its tension is the load of a pendulum: three weights at the lowest place", function()
  local scene, most = wire "implicit = true", 0
  for _ = 1, 120 do
    scene:step()
    most = math.max(most, scene:read "tension")
  end
  expect(most):near(3 * 2 * 9.81, 0.3)
end)

test("an explicit connection that is too stiff is solved by itself, and the log says so once", function()
  local scene, lines = wire "", 0
  scene:advance(2)
  for _, line in ipairs(scene.log) do
    if line.text:find("are solved with what they tie", 1, true) then lines = lines + 1 end
  end
  expect(lines):equal(1)
  expect(scene.error.worst_energy):below(1e-8)
end)

test("what is solved for its damping is told with its damping, what only stands beside it not at all", function()
  local scene = open_text [[
    local a, b = scene:particle { mass = 0.001 }, scene:particle { mass = 0.001, at = vec(1, 0, 0) }
    scene:nail(a)
    scene:connect(a, b, force.spring { stiffness = 1e5 })
    scene:connect(a, b, force.damper { damping = 300 })
    scene:connect(a, b, force.damper { damping = 1e-3 })
  ]]
  scene:advance(0.1)
  local told = {}
  for _, line in ipairs(scene.log) do told[#told + 1] = line.text:match "connections as .- as connection %d+ (%(.-%))" end
  expect(table.concat(told, " ")):equal "(1e+05 N/m) (300 N s/m)"
end)

test("solved dissipatively a spring comes to rest", function()
  local scene = open_text [[
    scene.gravity, scene.step = vec(0, 0, 0), 1 / 60
    local a, b = scene:particle {}, scene:particle { at = vec(1.3, 0, 0), name = "b" }
    scene:connect(a, b, force.spring { stiffness = 2000, length = 1, implicit = "dissipative" })
  ]]
  scene:advance(10)
  expect(scene.energy.total):below(1e-3)
  expect(scene.error.worst_energy):below(1e-8)
end)

test("implicit is true, false or dissipative, and for laws of the distance of two", function()
  expect(function() wire "implicit = 3" end):fails 'implicit must be true, false or "dissipative", got a number'
  expect(function()
    open_text [[
      local p = { scene:particle {}, scene:particle { at = vec(1, 0, 0) }, scene:particle { at = vec(1, 1, 0) } }
      scene:connect(p, force.angle { stiffness = 1 }, { implicit = true })
    ]]
  end):fails "implicit = true needs a law of the distance of two particles"
end)

test("bridge: bears a truck, breaks under the next, and is built anew, without a fallback step", function()
  local bridge = open("scenes/bridge.lua", { weight = 2700 })
  bridge:advance(8)
  expect(bridge:read "load"):near(4050, 1e-9)
  bridge:advance(8)
  expect(bridge:read "load"):near(2700, 1e-9)
  expect(bridge.error.worst_energy):below(1e-3)
  expect(bridge.stats.fallback_steps):equal(0)
end)

test("a stiff spring pulls a hinge by any of its members alike, and energy is kept", function()
  local ends = { "p.b", "q.a", "hinge" }
  local heights = {}
  for _, point in ipairs(ends) do
    local scene = open_text([[
      local function rod(x)
        return scene:body { mass = 1, inertia = vec(0.001, 0.08, 0.08), at = vec(x, 0, 0),
          points = { a = vec(-0.5, 0, 0), b = vec(0.5, 0, 0) } }
      end
      local p, q = rod(0.5), rod(1.5)
      local hinge = scene:hinge(p.b, q.a)
      scene:connect(]] .. point .. [[, vec(0, 2, 0), force.spring { stiffness = 1e4, length = 1 })
      q.name = "q"
    ]])
    scene:advance(1)
    expect(scene.error.worst_energy):below(1e-9)
    heights[#heights + 1] = scene:find("q").position.y
  end
  expect(heights[2]):equal(heights[1])
  expect(heights[3]):equal(heights[1])
end)
