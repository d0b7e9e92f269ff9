-- What moves as a function of time says, under what it carries.

for _, rate in ipairs { 60, 240 } do
  test(("what sticks to a platform that speeds up stays where it is, at %d Hz"):format(rate), function()
    local scene = open_text(([[
      scene.step = 1 / %d
      local platform = scene:box { name = "platform", size = vec(4, 0.5, 4), mass = 10, at = vec(0, -0.25, 0), friction = 1, points = { p = vec(0, 0, 0) } }
      scene:follow(platform.p, function(t) return vec(1.5 * t * t, -0.25, 0) end)
      scene:orient(platform, quat(vec(0, 0, 1), 0))
      scene:box { name = "box", size = 0.5, mass = 1, at = vec(0, 0.25, 0), friction = 1 }
    ]]):format(rate))
    scene:advance(0.2)
    local way = scene:find("box").position.x - scene:find("platform").position.x
    scene:advance(2)
    expect(scene:find("box").position.x - scene:find("platform").position.x):near(way, 1e-6)
    local force = vec(0, 0, 0)
    for _, contact in ipairs(scene:find("box").contacts) do force = force + contact.force end
    expect(force.x):near(3, 0.05)
  end)

  for _, how in ipairs {
    { "scene:string({ box.top, vec(0, 6, 0) }, { length = function(t) return 5 - up(t) end })", "a winch" },
    { "scene:rod(box.top, vec(0, 6, 0), function(t) return 5 - up(t) end)", "a rod" },
    { "scene:follow(box.top, function(t) return vec(0, 1 + up(t), 0) end)", "a follow" },
  } do
    test(("%s that begins to pull and ends at once gives its speed, no more, at %d Hz"):format(how[2], rate), function()
      local scene = open_text(([[
        scene.step = 1 / %d
        local function up(t) return 0.8 * (math.max(0, math.min(2, t) - 1)) end
        local box = scene:box { name = "box", size = 1, density = 300, at = vec(0, 0.5, 0), points = { top = vec(0, 0.5, 0) } }
        %s
      ]]):format(rate, how[1]))
      local most, least = 0, 0
      for _ = 1, 3 * rate do
        scene:step()
        local v = scene:find("box").velocity.y
        most, least = math.max(most, v), math.min(least, v)
      end
      expect(most):near(0.8, 1e-3)
      expect(least):above(-0.8)  -- a string goes slack, and the box falls into it
      expect(scene:find("box").velocity:length()):below(1e-6)
    end)
  end
end

test("a box on a hanging bridge of hinged planks does not sink through it, at 60 Hz", function()
  local scene = open_text [[
    scene.step = 1 / 60
    local previous
    for i = 1, 8 do
      local p = scene:box { size = vec(0.46, 0.08, 1.4), density = 600, at = vec(0.47 * i - 0.235, 0, 0),
        points = { l1 = vec(-0.235, 0, 0.6), l2 = vec(-0.235, 0, -0.6), r1 = vec(0.235, 0, 0.6), r2 = vec(0.235, 0, -0.6) } }
      for k = 1, 2 do
        local l, r, out = p["l" .. k], p["r" .. k], vec(0.05, 0, 0)
        if previous then scene:hinge(previous["r" .. k], l) else scene:string({ l, l.position - out }, { length = 0.06 }) end
        if i == 8 then scene:string({ r, r.position + out }, { length = 0.06 }) end
      end
      previous = p
    end
    scene:box { size = 0.5, density = 2000, at = vec(1.88, 0.8, 0), name = "box" }
  ]]
  scene:advance(3)
  local then_ = scene:find("box").position.y
  scene:advance(3)
  expect(scene:find("box").position.y):near(then_, 0.01)
  expect(scene.error.penetration):below(1e-3)
end)

for along, axis in pairs { ["to and fro"] = "vec(1, 0, 0)", ["up and down"] = "vec(0, 1, 0)" } do
  test(("a platform that goes %s takes back what it gave to what rides on it"):format(along), function()
    local at_rate = {}
    for i, rate in ipairs { 60, 240 } do
      local scene = open_text(("scene.step, axis = 1 / %d, %s\n"):format(rate, axis) .. [[
        local deck = scene:box { size = vec(2, 0.2, 2), at = vec(0, 0.1, 0), points = { c = vec(0, 0, 0) } }
        scene:orient(deck)
        scene:follow(deck.c, function(t) return vec(0, 0.1, 0) + axis * (1 - math.cos(1.5 * t)) end)
        scene:box { size = vec(0.4, 0.4, 0.3), at = vec(0.1, 0.4, 0) }
      ]])
      scene:advance(8 * math.pi / 3)  -- two rounds
      expect(scene.error.worst_energy):below(7 / rate ^ 2)
      at_rate[i] = math.abs(scene.ledger.hand)
      expect(at_rate[i]):below(1e-3 * scene.energy.total)  -- 800 kg, of which up to 9 kJ went to and fro
    end
    expect(at_rate[2]):below(at_rate[1] / 8)  -- the second order of the step
  end)
end

test("what rests on a platform whose velocity jumps has no part in the work of that", function()
  for axis, work in pairs { ["vec(0, 1, 0)"] = 50 * 9.81 * 0.5, ["vec(1, 0, 0)"] = 0 } do
    local scene = open_text("scene.step, axis = 1 / 60, " .. axis .. [[

      local deck = scene:box { size = vec(2, 0.2, 2), mass = 50, at = vec(0, 0.1, 0), points = { c = vec(0, 0, 0) } }
      scene:orient(deck)
      scene:follow(deck.c, function(t) return vec(0, 0.1, 0) + axis * 0.5 * math.min(1, math.max(0, t - 0.5)) end)
      scene:box { size = 0.2, mass = 1e-6, at = vec(0.1, 0.3, 0) }
    ]])
    scene:advance(2)
    expect(scene.ledger.hand):near(work, 1e-3)
    expect(scene.ledger.contact):near(0, 1e-3)
    expect(scene.error.worst_energy):below(1e-9)
  end
end)
