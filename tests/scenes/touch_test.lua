-- What touches beside hinges and motors, and what rests: hard cases.
test("a motor that meets a wall presses with its torque, and gives no more than its power", function()
  for _, torque in ipairs { 1, 40, 1000 } do
    for _, rate in ipairs { 60, 240 } do
      local scene = open_text(("local torque = %d scene.step = 1 / %d"):format(torque, rate) .. [[

        scene.gravity = vec(0, 0, 0)
        scene:ground { shape = shape.box(0.5, 1, 1), at = vec(0.9, 1.05, 0) }
        local arm = scene:body { shape = shape.box(1, 0.1, 0.1, { at = vec(0.5, 0, 0) }), points = { root = vec(0, 0, 0) }, name = "arm" }
        local post = scene:body { mass = 1, inertia = vec(1, 1, 1), points = { top = vec(0, 0, 0) } }
        scene:nail(post.top) scene:orient(post)
        scene:hinge(arm.root, post.top, { axis = vec(0, 0, 1) })
        scene:motor(arm, post, { axis = vec(0, 0, 1), speed = 3, max_torque = torque })
      ]])
      scene:advance(3)
      local arm, moment = scene:find "arm", 0
      for _, contact in ipairs(arm.contacts) do moment = moment + contact.at:cross(contact.force).z end
      expect(moment / -torque):near(1, 1e-6)
      expect(arm.spin:length()):below(1e-6)
      expect(scene.ledger.motor):below(15.1 + 3 * torque * 2 / rate) -- ½ I ω² and two steps of its power
      expect(scene.stats.unsolved_islands):equal(0)
    end
  end
end)

test("limbs on hinges beside each other fly on: nothing presses across a gap that hinges hold open", function()
  local scene = open_text [[
    scene.gravity = vec(0, 0, 0)
    local at, v = vec(0, 2, 0), vec(10, 0, 0)
    local torso = scene:body { shape = shape.ball { radius = 0.15, at = vec(0, 0.2, 0) }, at = at, velocity = v,
      spin = vec(3, 0.9, 1.5), points = { a = vec(0, 0, 0.1), b = vec(0, 0, -0.1) } }
    for name, z in pairs { a = 0.1, b = -0.1 } do
      local leg = scene:body { shape = shape.capsule { radius = 0.075, from = vec(0, 0, z), to = vec(0, -0.4, z * 1.2) }, at = at,
        velocity = v, spin = vec(0, 0, 40 * z), points = { root = vec(0, 0, z) } }
      scene:hinge(torso[name], leg.root)
    end
  ]]
  scene:advance(0.01)
  local start = scene.energy.total
  scene:advance(0.5)
  expect(scene.energy.total):below(start * (1 + 1e-9))
  expect(scene.error.energy):below(1e-9)
  expect(scene.stats.unsolved_islands):equal(0)
end)

test("a ball between two walls of one body is pinched by neither until it meets it", function()
  local scene = open_text [[
    scene.gravity, scene.step = vec(0, 0, 0), 1 / 60
    local walls = {}
    for i, side in ipairs { 1, -1 } do walls[i] = shape.box(0.03, 0.5, 0.5, { at = vec(0.25 * side, 0, 0) }) end
    scene:body { shapes = walls, mass = 20 }
    scene:ball { radius = 0.17, mass = 15, velocity = vec(0, 10, 0), name = "ball" }
  ]]
  scene:advance(1)
  expect(scene:find("ball").velocity):near(vec(0, 10, 0), 1e-12)
end)

test("boxes that touch sideways in a pyramid stay, and the energy error of what rests is small", function()
  local scene = open_text [[
    scene:floor {}
    for row = 1, 10 do
      for i = 1, 11 - row do scene:box { size = 1, mass = 1, at = vec(i + 0.5 * row, row - 0.5, 0), name = "b" .. row .. "_" .. i } end
    end
  ]]
  scene:advance(1)
  local settled = scene:find("b10_1").position
  expect(settled):near(vec(6, 9.5, 0), 5e-6) -- once, as loads find their ways
  scene:advance(2)
  expect(scene:find("b10_1").position):near(settled, 1e-8)
  expect(scene.error.penetration):below(1e-6)
  expect(scene.error.energy):below(1e-3)
  expect(scene.stats.unsolved_islands):equal(0)
end)

test("in the cradle two balls fly off where two come, and the energy stays", function()
  local cradle = open("scenes/cradle.lua", { raised = 2 })
  cradle:advance(1)
  expect(cradle:read "first"):near(0, 0.01)
  expect(cradle:read "last"):near(0.6, 0.01)
  cradle:advance(20)
  expect(cradle.error.energy):below(1e-3)
end)

test("a marble with friction against rolling comes to rest", function()
  local scene = open_text [[
    scene:floor { rolling = 0.02 }
    scene:ball { radius = 0.2, at = vec(0, 0.2, 0), velocity = vec(1, 0, 0), spin = vec(0, 0, -5), name = "marble" }
  ]]
  scene:advance(3)
  expect(scene:find("marble").velocity:length()):below(1e-8)
  expect(scene:find("marble").position.x):near(0.5 / (5 / 7 * 9.81 * 0.02 / 0.2), 1e-2)
end)
