-- What is driven by a function of time with kinks: its velocity jumps, and no tie that does not give loses energy then.

local function scene_of(rate, driven)
  return open_text(("scene.step = 1 / %d\n"):format(rate) .. [[
    local arm = scene:body { name = "arm", mass = 2, inertia = vec(0.1, 0.2, 0.2), at = vec(0.5, 0, 0), points = { a = vec(-0.5, 0, 0), b = vec(0.5, 0, 0) } }
    local link = scene:body { name = "link", mass = 1, inertia = vec(0.05, 0.1, 0.1), at = vec(1.5, 0, 0), points = { a = vec(-0.5, 0, 0), b = vec(0.5, 0, 0) } }
    local function begin(t) return math.max(0, t - 0.51) end
    scene:hinge(arm.b, link.a)
  ]] .. driven)
end

local driven = {
  ["a point that begins to move"] = { "scene:follow(arm.a, function(t) return vec(2 * begin(t), 0, 0) end)", 2e-4 },
  ["a point that stops"] = { "scene:follow(arm.a, function(t) return vec(2 * math.min(t, 1), 0, 0) end)", 1e-3 },
  ["a point that is shaken"] = { "scene:follow(arm.a, function(t) return vec(0.3 * math.abs(math.sin(7 * t)), 0, 0) end)", 2e-2 },
  ["an arm that begins to turn"] = { "scene:nail(arm.a) scene:motor(arm, { axis = vec(0, 0, 1), angle = function(t) return 3 * begin(t) end })", 3e-3 },
  ["a link that begins to turn"] = { "scene:nail(arm.a) scene:orient(link, function(t) return quat(vec(0, 0, 1), 2 * begin(t)) end)", 2e-4 },
}
for what, case in pairs(driven) do
  test(what .. " is given what it gains", function()
    for _, rate in ipairs { 60, 240 } do
      local scene = scene_of(rate, case[1])
      scene:advance(3)
      expect(scene.error.worst_energy):below(case[2])
    end
  end)
end

test("a load that a winch begins to lift, and stops, takes m g h of it", function()
  local scene = open_text [[
    local box = scene:box { name = "box", size = 1, density = 300, at = vec(0, 0.5, 0), points = { top = vec(0, 0.5, 0) } }
    local eye = scene:particle { at = vec(0, 6, 0) }
    scene:nail(eye)
    scene:rod(box.top, eye, function(t) return 5 - math.min(1.6, math.max(0, t - 1) * 0.8) end)
  ]]
  local start = scene.energy.total
  scene:advance(4)
  expect(scene.ledger.hand):near(300 * 9.81 * 1.6, 1e-3)
  expect(scene.energy.total - start):near(scene.ledger.hand, 1e-3)
end)

test("what hangs on a point that stops at once turns on with its angular momentum about it", function()
  for _, rate in ipairs { 60, 240, 960 } do
    local scene = open_text(("scene.step = 1 / %d\n"):format(rate) .. [[
      scene.gravity = vec(0, 0, 0)
      local arm = scene:body { name = "arm", mass = 2, inertia = vec(0.1, 0.2, 0.2), at = vec(0.5, 0, 0), points = { a = vec(-0.5, 0, 0) } }
      scene:follow(arm.a, function(t) return vec(0, 2 * math.min(t, 1), 0) end)
    ]])
    scene:advance(0.5)
    local arm = scene:find "arm"
    local spin = arm.spin.z
    scene:advance(0.5)
    local reach = arm.orientation:rotate(vec(0.5, 0, 0))
    scene:advance(0.1)
    local moment = 0.2 + 2 * 0.25
    expect(arm.spin.z):near(spin + 2 * reach.x * 2 / moment, 1e-9)
  end
end)
