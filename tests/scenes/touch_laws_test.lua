-- Laws of velocity and dampers on what rests.
for _, rate in ipairs { 60, 240 } do
  for _, tied in ipairs { false, true } do
    test(("drag lets %s that rests press with its weight at %d Hz"):format(tied and "a hinged box" or "a box", rate), function()
      local scene = open_text(([[
        scene.step = 1 / %d
        scene:floor {}
        local box = scene:box { size = 0.4, mass = 2, at = vec(0, 0.2, 0), name = "box", points = { p = vec(0.3, 0, 0) } }
        if %s then
          local other = scene:box { size = 0.4, mass = 2, at = vec(0.6, 0.2, 0), points = { p = vec(-0.3, 0, 0) } }
          scene:hinge(box.p, other.p)
        end
        scene:field(scene, force.drag { linear = 100 })
      ]]):format(rate, tostring(tied)))
      scene:advance(0.5)
      local damped, force = scene.ledger.damper, 0
      for _, body in ipairs(scene.bodies) do
        for _, contact in ipairs(body.contacts) do force = force + contact.force.y end
      end
      expect(force):near(#scene.bodies * 2 * 9.81, 0.01)
      scene:advance(0.6)
      expect(scene.ledger.damper):near(damped, 1e-4)
    end)
  end
end

for _, rate in ipairs { 60, 240 } do
  test("a damped spring that is solved presses what rests by what it is compressed at " .. rate .. " Hz", function()
    local scene = open_text(([[
      scene.step = 1 / %d
      scene.integrator = "implicit"
      scene:floor {}
      local box = scene:box { size = 0.4, mass = 2, at = vec(0, 0.2, 0), name = "box", points = { c = vec(0, 0, 0) } }
      local post = scene:particle { at = vec(0, 2, 0), mass = 1 }
      scene:nail(post)
      scene:connect(box.c, post, force.spring { stiffness = 1000, length = 2.2, damping = 200 })
    ]]):format(rate))
    scene:advance(1)
    local force = 0
    for _, contact in ipairs(scene:find("box").contacts) do force = force + contact.force.y end
    expect(force):near(2 * 9.81 + 1000 * (2.2 - (2 - scene:find("box").position.y)), 1e-6)
    expect(scene.error.worst_energy):below(1e-3)
  end)
end

for _, tied in ipairs { false, true } do
  test(("what no longer touches anything, since shapes are gone, falls under drag as if it never had, %s"):format(tied and "tied" or "alone"), function()
    local scene = open_text(([[
      scene.step = 1 / 60
      scene:floor { name = "floor" }
      local box = scene:box { size = 0.4, mass = 2, at = vec(0, 0.2, 0), name = "box", points = { c = vec(0, 0, 0) } }
      if %s then scene:hinge(box.c, scene:particle { at = vec(0, 0.2, 0), mass = 1 }) end
      scene:field(scene, force.drag { linear = 100 })
    ]]):format(tostring(tied)))
    scene:advance(0.2)
    local box = scene:find "box"
    scene:find("floor"):remove()
    while #box.colliders > 0 do box.colliders[1]:remove() end
    scene:advance(1)
    expect(box.velocity.y):near(-(tied and 3 or 2) * 9.81 / 100, 1e-9)
  end)
end

test("a cart on springs that kick keeps its books on hills", function()
  local scene = open_text [[
    scene.step = 1 / 480
    scene:ground { shape = shape.heights { columns = 101, rows = 11, spacing = 0.5, friction = 1, height = function(x) return 0.3 * math.sin(0.9 * x) end } }
    local axis = vec(0, 0, 1)
    local cart = scene:box { size = vec(3, 0.4, 1.4), at = vec(-15, 1.6, 0), mass = 800, velocity = vec(6, 0, 0) }
    for _, x in ipairs { -1.1, 1.1 } do for _, z in ipairs { -0.85, 0.85 } do
      local hub = vec(x, -0.5, z)
      local knuckle = scene:body { at = cart.origin + hub, mass = 15, inertia = vec(0.5, 0.5, 0.5), velocity = vec(6, 0, 0), points = { hub = vec(0, 0, 0) } }
      local mount, root = cart:add_point { at = vec(x, 0.5, z) }, cart:add_point { at = hub - vec(x, 0, 0) }
      scene:hinge(root, knuckle:add_point { at = vec(-x, 0, 0) }, { axis = axis })
      scene:connect(mount, knuckle.hub, force.spring { stiffness = 13000, length = 1.15 })
      local wheel = scene:cylinder { radius = 0.4, length = 0.25, axis = axis, at = cart.origin + hub, mass = 20, friction = 1, velocity = vec(6, 0, 0), spin = vec(0, 0, -15), points = { hub = vec(0, 0, 0) } }
      scene:hinge(knuckle.hub, wheel.hub, { axis = axis })
    end end
  ]]
  scene:advance(3)
  expect(scene.error.worst_energy):below(2e-3)
end)

for integrator, enough in pairs { implicit = 1e-4, verlet = 1e-3 } do
  test("what opens an overlap against a spring does its energy's work, and the error is the step's: " .. integrator, function()
    local scene = open_text(("scene.integrator = %q\n"):format(integrator) .. [[
      scene.step = 1 / 960
      scene:floor {}
      local low = scene:ball { radius = 0.2, at = vec(0, 0.1, 0), mass = 1 }
      local high = scene:ball { radius = 0.2, at = vec(0.2, 1, 0), mass = 2 }
      scene:connect(low:add_point { at = vec(0, 0, 0) }, high:add_point { at = vec(0, 0, 0) }, force.spring { stiffness = 50, length = 1.2 })
    ]])
    local _ = scene.ledger
    scene:advance(0.5)
    expect(scene.ledger.push_out):above(1)
    expect(scene.ledger.closure):below(1e-10)
    expect(scene.error.worst_energy):below(enough)
  end)
end
