-- Springs that are solved, among what touches.
local g = 9.81

local function scene_at(rate, text)
  return open_text(("scene.step = 1 / %d\n"):format(rate) .. text)
end

for _, rate in ipairs { 60, 240 } do
  local at_rate = " at " .. rate .. " Hz"

  for _, stiffness in ipairs { 2e3, 6e4 } do
    test(("a cube of particles and springs of %g N/m bounces off a box"):format(stiffness) .. at_rate, function()
      local scene = scene_at(rate, ([[
        scene:floor {}
        local jelly = scene:family("jelly", { solid = true, mass = 0.05, radius = 0.06, layer = "jelly" })
        scene:collide("jelly", "jelly", false)
        scene:block { size = 0.3, mass = 5, at = vec(0.2, 0.15, 0.2) }
        local cube = scene:group("cube")
        for i = 0, 2 do for j = 0, 2 do for k = 0, 2 do
          cube:add(scene:particle { family = jelly, at = vec(0.15 * i, 1 + 0.15 * j, 0.15 * k) })
        end end end
        scene:connect_within(cube, 0.27, force.spring { stiffness = %g, implicit = true })
      ]]):format(stiffness))
      scene:advance(2)
      expect(scene.error.worst_penetration):below(0.05 * 0.12)
      expect(scene.error.worst_energy):below(0.08)
    end)
  end

  test("boxes fall on a table with light feet on springs" .. at_rate, function()
    local scene = scene_at(rate, [[
      scene:floor {}
      local table = scene:block { size = vec(2, 0.1, 2), mass = 5, at = vec(0, 0.8, 0) }
      local function leg(foot, x, z)
        local from, to = foot:add_point(vec(0, 0, 0)), table:add_point(vec(x, -0.05, z))
        scene:connect(from, to, force.spring { stiffness = 1e5, damping = 50, implicit = true, length = (to.position - from.position):length() })
      end
      for _, x in ipairs { -1, 1 } do for _, z in ipairs { -1, 1 } do
        local foot = scene:ball { radius = 0.1, mass = 0.01, at = vec(0.9 * x, 0.1, 0.9 * z) }
        leg(foot, 0.9 * x, 0.9 * z)
        leg(foot, 0.5 * x, 0.9 * z)
        leg(foot, 0.9 * x, 0.5 * z)
      end end
      for i = 1, 4 do scene:block { size = 0.4, mass = 3, at = vec(0.1 * i, 0.8 + 0.9 * i, 0.05 * i) } end
    ]])
    scene:advance(4)
    expect(scene.error.worst_penetration):below(0.02 * 0.1)
    expect(scene.error.worst_energy):below(2e-3)
  end)

  for _, mass in ipairs { 1, 30 } do
    test(("a box and a ball of %g kg fall on a net of springs"):format(mass) .. at_rate, function()
      local scene = scene_at(rate, ([[
        local net = scene:family("net", { solid = true, mass = 0.02, radius = 0.05, friction = 0.6, layer = "net" })
        scene:collide("net", "net", false)
        local spring = force.spring { stiffness = 3e4, damping = 5, implicit = true, length = 0.25 }
        local knots = {}
        for i = 0, 6 do
          knots[i] = {}
          for j = 0, 6 do
            knots[i][j] = scene:particle { family = net, at = vec(0.26 * i, 1.5, 0.26 * j) }
            if i * j * (6 - i) * (6 - j) == 0 then scene:nail(knots[i][j]) end
            if i > 0 then scene:connect(knots[i - 1][j], knots[i][j], spring) end
            if j > 0 then scene:connect(knots[i][j - 1], knots[i][j], spring) end
          end
        end
        scene:block { size = 0.5, mass = %g, at = vec(0.9, 3, 0.8) }
        scene:ball { radius = 0.25, mass = %g, at = vec(0.5, 4.5, 0.9) }
      ]]):format(mass, mass))
      scene:advance(4)
      expect(scene.error.worst_penetration):below(0.02)
      expect(scene.error.worst_energy):below(0.01)
    end)
  end

  test("a block on a spring over a foot swings as if the foot were nailed" .. at_rate, function()
    local scene = scene_at(rate, [[
      scene:floor {}
      local foot = scene:block { size = 0.2, mass = 0.01, at = vec(0, 0.1, 0) }
      local block = scene:block { size = 0.2, mass = 4, at = vec(0, 1, 0), name = "block" }
      scene:orient(foot)
      scene:orient(block)
      scene:connect(foot:add_point(vec(0, 0, 0)), block:add_point(vec(0, 0, 0)), force.spring { stiffness = 1600, implicit = true, length = 0.9 })
    ]])
    local lowest, highest = 1, 0
    while scene.time < 3 do
      scene:step()
      local y = scene:find("block").position.y
      lowest, highest = math.min(lowest, y), math.max(highest, y)
    end
    expect(lowest):near(1 - 2 * 4 * g / 1600, 5e-4)
    expect(highest):near(1, 5e-4)
    expect(scene.error.worst_energy):below(1e-5)
  end)
end
