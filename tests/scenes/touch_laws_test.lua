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
