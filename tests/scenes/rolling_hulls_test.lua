-- Hulls that roll, edge by edge, and stand on faces of many corners.

-- What its edges leave of the spin of a prism of n sides, of its radius 0.5 m, that rolls for so long [s] from a spin w [rad/s]:
-- each keeps the angular momentum about it.
local function kept(n, w, time)
  local a, t, now = 2 * math.pi / n, 0, w
  local inertia = (2 + math.cos(a)) / 6 -- by m r²
  while true do
    t = t + a / now
    if t > time then return now / w end
    now = now * (inertia + math.cos(a)) / (inertia + 1)
  end
end

local prism = [[
  scene.step = 1 / %d
  local n, w, ground = %d, %g, %q
  if ground == "plane" then
    scene:floor { friction = 0.6 }
  elseif ground == "box" then
    scene:ground { shape = shape.box { size = vec(40, 1, 4), at = vec(0, -0.5, 0), friction = 0.6 } }
  else
    scene:ground { shape = shape.mesh { vertices = { vec(-20, 0, -2), vec(20, 0, -2), vec(20, 0, 2), vec(-20, 0, 2) },
      faces = { { 1, 4, 3, 2 } }, friction = 0.6 } }
  end
  local corners = {}
  for i = 0, n - 1 do
    local a = 2 * math.pi * (i + 0.5) / n - math.pi / 2
    for side = -1, 1, 2 do corners[#corners + 1] = vec(0.5 * math.cos(a), 0.5 * math.sin(a), 0.25 * side) end
  end
  scene:body { name = "prism", mass = 1, shape = shape.hull(corners, { friction = 0.6 }), at = vec(0, 0.5 * math.cos(math.pi / n), 0),
    velocity = vec(0.5 * w, 0, 0), spin = vec(0, 0, -w) }
]]

for _, case in ipairs {
  { ground = "plane", rate = 60, n = 1000, w = 4 }, { ground = "plane", rate = 240, n = 200, w = 1 },
  { ground = "plane", rate = 240, n = 4000, w = 4 }, { ground = "plane", rate = 240, n = 50, w = 3 },
  { ground = "box", rate = 60, n = 1000, w = 4 }, { ground = "box", rate = 240, n = 200, w = 1 },
  { ground = "box", rate = 240, n = 50, w = 3 }, { ground = "mesh", rate = 60, n = 1000, w = 4 },
  { ground = "mesh", rate = 240, n = 200, w = 1 }, { ground = "mesh", rate = 240, n = 50, w = 3 },
} do
  test(("a prism of %d sides rolls on a %s at %d Hz as its edges let it"):format(case.n, case.ground, case.rate), function()
    local scene = open_text(prism:format(case.rate, case.n, case.w, case.ground))
    scene:advance(2)
    local prism = scene:find "prism"
    expect(-prism.spin.z / case.w):near(kept(case.n, case.w, 2), 0.025)
    expect(prism.position.y):near(0.5, 2e-3)
    expect(prism.spin.x):near(0, 0.2)
    expect(scene.ledger.push_out):below(1e-2)
  end)
end

test("of its slow spin a prism of 500 sides loses no more than a seventh to steps of 60 Hz, and gains none", function()
  local scene = open_text(prism:format(60, 500, 0.3, "plane"))
  scene:advance(2)
  local left = -scene:find("prism").spin.z / 0.3
  expect(left):above(0.857)
  expect(left):below(1)
end)

test("a prism of 1000 sides stands on its end", function()
  for _, ground in ipairs { "plane", "box", "mesh" } do
    local scene = open_text(prism:format(60, 1000, 0, ground) .. [[
      local it = scene:find "prism"
      it.orientation, it.position = quat(vec(1, 0, 0), math.pi / 2), vec(0, 0.25, 0)
    ]])
    scene:advance(2)
    local prism = scene:find "prism"
    expect((prism.position - vec(0, 0.25, 0)):length()):below(1e-6)
    expect(prism.spin:length()):below(1e-6)
  end
end)

test("a hull of many sides that turns as it lands stays down", function()
  for _, friction in ipairs { 0, 0.6 } do
    for _, rate in ipairs { 60, 240 } do
      local scene = open_text(prism:format(rate, 300, 4, "plane") .. ([[
        local it = scene:find "prism"
        it.position, it.velocity = vec(0, 1.5, 0), vec(0.9, 0, 0)
        it.friction = %g
      ]]):format(friction))
      scene:advance(0.44)
      local prism, rises, before = scene:find "prism", 0, scene.energy.total
      while scene.time < 1.2 do
        scene:step()
        rises = math.max(rises, prism.velocity.y)
      end
      expect(rises):below(0.1) -- the edge that it lands on may push it up with 0.02 m/s
      expect(scene.energy.total):below(before)
      expect(scene.error.energy):below(5e-3)
    end
  end
end)

test("hulls of many sides that turn as they meet do not rebound, and keep what they have of spin in all", function()
  for _, rate in ipairs { 60, 240 } do
    local scene = open_text(([[
      scene.step, scene.gravity = 1 / %d, vec(0, 0, 0)
      local corners = {}
      for i = 0, 99 do
        local a = 2 * math.pi * i / 100
        for side = -1, 1, 2 do corners[#corners + 1] = vec(0.3 * math.cos(a), 0.3 * math.sin(a), 0.1 * side) end
      end
      for side = -1, 1, 2 do
        scene:body { name = side < 0 and "left" or "right", mass = 1, shape = shape.hull(corners, { friction = 0 }), at = vec(0.5 * side, 0, 0),
          velocity = vec(-1.2 * side, 0, 0), spin = vec(0, 0, 4 * side), orientation = quat(vec(0, 0, 1), 0.7 * side) }
      end
    ]]):format(rate))
    local turning = scene.angular_momentum
    scene:advance(1)
    expect(scene:find("left").velocity.x):near(0, 0.06)
    expect(scene:find("right").velocity.x):near(0, 0.06)
    expect((scene.angular_momentum - turning):length()):below(1e-10)
  end
end)
