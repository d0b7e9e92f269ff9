--- What forces that depend on velocities take from things that are tied, against closed forms.

--- A bar on a nail that turns about `axis` at 3 rad/s with its far end in a family "end".
local function turning_bar(step, axis, code)
  local scene = open_text("scene.step = " .. step .. [[ 
    local axis = ]] .. axis .. [[ 
    local bar = scene:body { mass = 1, inertia = vec(0.1, 0.1, 0.1), spin = axis * 3,
                             velocity = axis:cross(vec(0.5, 0, 0)) * 3,
                             points = { nail = vec(-0.5, 0, 0), tip = vec(0.5, 0, 0) } }
    scene:nail(bar.nail)
    local tips = scene:family "tips"
    bar.tip.particle.family = tips
    local _ = scene.ledger.closure
  ]] .. code)
  return scene
end

local inertia = 0.1 + 0.25  -- about the nail

test("a hinged pendulum in a viscous medium loses what its closed form says, to second order", function()
  local lost = 0.5 * inertia * 9 * (1 - math.exp(-2 * 0.7 / inertia))
  local wrong = {}
  for n, steps in ipairs { 60, 120, 240 } do
    local scene = turning_bar(1 / steps, "vec(0, 0, 1)", [[
      scene.gravity = vec(0, 0, 0)
      scene:field(tips, force.drag { linear = 0.7 })
    ]])
    scene:advance(1)
    wrong[n] = math.abs(scene.ledger.damper + lost)
    expect(scene.error.worst_energy):below(4e-4 * (60 / steps) ^ 2)
    expect(scene.ledger.closure):below(1e-10)
  end
  expect(wrong[1]):below(5e-4)
  expect(wrong[1] / wrong[2]):near(4, 0.2)
  expect(wrong[2] / wrong[3]):near(4, 0.2)
end)

test("a bar that turns with its end on a rough floor is stopped as friction says", function()
  local load = 0.5 * 9.81
  local slower = 0.3 * load / inertia  -- rad/s²
  for _, steps in ipairs { 240, 960 } do
    local scene = turning_bar(1 / steps, "vec(0, 1, 0)", [[
      local load = 0.5 * 9.81
      scene:field(tips, force.wall { through = vec(0, load / 1e4, 0), normal = vec(0, 1, 0), stiffness = 1e4,
                                     damping = 10, friction = 0.3 })
    ]])
    scene:advance(0.4)
    expect(scene.ledger.damper):near(0.5 * inertia * ((3 - 0.4 * slower) ^ 2 - 9), 1e-4)
    scene:advance(1.5)
    expect(scene.ledger.damper):near(-0.5 * inertia * 9, 1e-4)
    expect(scene.error.worst_energy):below(1e-4)
    expect(scene.ledger.closure):below(1e-10)
  end
end)

test("steps in which feet meet the floor, stick and slip lose nothing that is not booked", function()
  local scene = open_text [[
    scene.plane, scene.step = "xy", 1 / 960
    local feet = scene:family "feet"
    local cart = scene:body { at = vec(0, 1, 0), mass = 2, inertia = vec(1, 1, 1), points = { vec(-1, 0, 0), vec(1, 0, 0) } }
    for i = 1, 2 do
      local spokes = { vec(0, 0, 0) }
      for n = 1, 5 do
        spokes[n + 1] = { at = vec(math.cos(n * 2 * math.pi / 5), math.sin(n * 2 * math.pi / 5), 0), mass = 0.2, family = feet }
      end
      local wheel = scene:body { at = cart.points[i].position, points = spokes }
      scene:hinge(wheel.points[1], cart.points[i])
      scene:motor(wheel, cart, { speed = -1.5, max_torque = 60 })
    end
    scene:field(feet, force.wall { normal = vec(0, 1, 0), stiffness = 5e3, damping = 30, friction = 0.8, slip = 0.01 })
  ]]
  local _ = scene.ledger.closure
  scene:advance(2)
  local ledger = scene.ledger
  expect(ledger.closure):below(1e-10)
  expect(ledger.damper):below(-5)
  expect(math.abs(ledger.projection)):below(0.01)
  expect(math.abs(ledger.truncation.wall)):below(0.05)
  expect(scene.error.worst_energy):below(5e-3)
end)

test("a law of place and velocity in one tells its energy error like one of place alone", function()
  for _, stiffness in ipairs { 5184, 57600, 235000 } do
    local function error_of(force)
      local scene = open_text("local k = " .. stiffness .. [[
        scene.gravity = vec(0, 0, 0)
        local p = scene:particle { mass = 1, at = vec(0.5, 0, 0) }
        scene:field(scene, force.point { force = function(p) return vec(]] .. force .. [[, 0, 0) end })
      ]])
      scene:advance(0.1)
      return scene.error.worst_energy
    end
    local alone = error_of("-k * p.position.x")
    expect(error_of("-k * p.position.x - 0.3 * p.velocity.x")):near(alone, 0.1 * alone)
    expect(error_of("-k * p.position.x - 1e-9 * p.velocity.x * p.velocity:length()")):near(alone, 0.1 * alone)
  end
end)
