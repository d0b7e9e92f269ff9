-- Single blows at any phase of the step, against closed forms: they act where and when the two meet.

local function scene_of(text, ...) return open_text(text:format(...)) end

for _, rate in ipairs { 60, 240 } do
  for _, e in ipairs { 0, 1 } do
    test(("a ball that is struck aslant flies along the line of centres, at %d Hz, restitution %g"):format(rate, e), function()
      local radius, speed, off = 0.03, 5, 0.04
      local out = math.asin(off / (2 * radius))                   -- of the line of centres
      local along = speed * math.cos(out) * (1 + e) / 2           -- of the struck one, along it
      for phase = 0, 9 do
        local scene = scene_of([[
          scene.step = 1 / %d
          scene.gravity = vec(0, 0, 0)
          scene:ball { name = "cue", radius = 0.03, at = vec(%.17g, %.17g, 0), velocity = vec(5, 0, 0), friction = 0, restitution = %g }
          scene:ball { name = "other", radius = 0.03, friction = 0, restitution = %g }
        ]], rate, -0.5 - 0.013 * phase, off, e, e)
        scene:advance(0.3)
        local cue, other = scene:find "cue", scene:find "other"
        expect(other.velocity.x):near(along * math.cos(out), 1e-4 * speed)
        expect(other.velocity.y):near(-along * math.sin(out), 1e-4 * speed)
        expect(cue.velocity.x):near(speed - along * math.cos(out), 1e-4 * speed)
        expect(math.max(cue.spin:length(), other.spin:length())):below(1e-2)
      end
    end)

    test(("a box that flies aslant into a ball does not spin it without friction, at %d Hz, restitution %g"):format(rate, e), function()
      for phase = 0, 4 do
        for _, first in ipairs { "box", "ball" } do
          local t = 0.1 + 0.003 * phase
          local box = ('scene:box { name = "box", size = 1, mass = 1, at = vec(%.17g, %.17g, 0), velocity = vec(20, 20, 0), friction = 0, restitution = %g }\n')
            :format(-20 * t, -0.5 - 20 * t, e)
          local ball = ('scene:ball { name = "ball", mass = 1, radius = 0.05, at = vec(0, 0.05, 0), friction = 0, restitution = %g }\n'):format(e)
          local scene = open_text(("scene.step = 1 / %d\nscene.gravity = vec(0, 0, 0)\n"):format(rate) ..
            (first == "box" and box .. ball or ball .. box))
          scene:advance(0.4)
          expect(scene:find("ball").velocity.y):near(10 * (1 + e), 1e-2)
          expect(scene:find("ball").spin:length()):below(1e-2)
        end
      end
    end)
  end

  test(("a bar whose tip meets a post turns about it and flies on, at %d Hz"):format(rate), function()
    for _, speed in ipairs { 5, 20, 60 } do
      for phase = 0, 3 do
        local scene = scene_of([[
          scene.step = 1 / %d
          scene.gravity = vec(0, 0, 0)
          scene:ground { shape = shape.ball(0.05, { friction = 0 }), at = vec(0.95, -0.05, 0) }
          scene:box { name = "bar", size = vec(2, 0.05, 0.05), mass = 1, at = vec(0, %.17g, 0), velocity = vec(0, %g, 0), friction = 0 }
        ]], rate, 1 + 0.3 * phase * speed / rate, -speed)
        scene:advance(2 / speed + 0.05)
        local inertia = (4 + 0.05 ^ 2) / 12
        local impulse = speed / (1 + 0.95 ^ 2 / inertia)
        local bar = scene:find "bar"
        expect(-bar.velocity.y):near(speed - impulse, 5e-3 * speed)
        expect(bar.spin.z):near(impulse * 0.95 / inertia, 2e-2 * speed)
      end
    end
  end)
end

test("a taut linkage that is struck gains nothing, however near it is to straight", function()
  for _, slack in ipairs { 0, 1e-3 } do
    for _, rate in ipairs { 60, 240 } do
      local scene = scene_of([[
        scene.step = 1 / %d
        local function plank(x) return scene:box { size = vec(1, 0.1, 1), density = 600, at = vec(x, -0.05, 0), points = { l = vec(-0.5, 0, 0), r = vec(0.5, 0, 0) } } end
        local a, b = plank(-0.5), plank(0.5)
        scene:hinge(a.r, b.l)
        scene:nail(a.l)
        scene:nail(b.r, b.r.position - vec(%g, 0, 0))
        scene:box { size = 0.5, density = 500, at = vec(0, 0.75, 0) }
      ]], rate, slack)
      local start, most = scene.energy.total, -math.huge
      for _ = 1, rate do
        scene:step()
        most = math.max(most, scene.energy.total - start)
      end
      expect(most):below(0.05 * 302)
    end
  end
end)

for _, rate in ipairs { 60, 240 } do
  test(("what loses nothing at a blow keeps its energy whatever its shape, at %d Hz"):format(rate), function()
    for _, body in ipairs {
      "scene:box { size = 1, at = vec(0, 3, 0), orientation = quat(vec(1, 2, 3):normalized(), 0.7), restitution = 1, friction = 0 }",
      "scene:capsule { radius = 0.2, length = 1, at = vec(0, 3, 0), orientation = quat(vec(0, 0, 1), 1.2), restitution = 1, friction = 0 }",
    } do
      local scene = scene_of("scene.step = 1 / %d\nscene:floor { friction = 0, restitution = 1 }\n%s", rate, body)
      local start = scene.energy.total
      scene:advance(5.9)
      expect(scene.energy.total):near(start, 0.02 * start)
    end
  end)
end

test("what breaks in one step is told in the order in which it was made", function()
  local opened = open_text [[
    scene.gravity = vec(0, -1000, 0)
    local function hung(x) return scene:particle { at = vec(x, 0, 0) } end
    local ties = {
      scene:connect(hung(1), vec(1, 1, 0), force.spring { stiffness = 1e4 }, { name = "first", breaks_at = { force = 1 } }),
      scene:rod(hung(2), vec(2, 1, 0), { name = "second", breaks_at = { force = 1 } }),
      scene:connect(hung(3), vec(3, 1, 0), force.spring { stiffness = 1e4 }, { name = "third", breaks_at = { force = 1 } }),
    }
    local p, q = hung(4), hung(6)
    scene:nail(p)
    local left = scene:body { at = vec(4, 0, 0), mass = 1, inertia = vec(1, 1, 1), points = { end_ = vec(0, 0, 0) } }
    ties[4] = scene:hinge(p, left.end_, { name = "fourth", breaks_at = { force = 1 } })
    ties[5] = scene:rod(q, vec(6, 1, 0), { name = "fifth", breaks_at = { force = 1 } })
    local told = {}
    scene:on("broke", function(thing) told[#told + 1] = tostring(thing):match "'(.-)'" end)
    scene:at(0.1, function() assert(table.concat(told, " ") == "first second third fourth fifth", table.concat(told, " ")) end)
  ]]
  opened:advance(0.2)
end)

for _, rate in ipairs { 60, 240, 480, 1000, 2000 } do
  test(("a box that falls on a corner which sticks turns about it at %d Hz"):format(rate), function()
    local turn, speed, spin = 1, 3, 2                                                                               -- as it strikes
    local arm = vec(-0.5 * math.cos(turn) + 0.25 * math.sin(turn), -0.5 * math.sin(turn) - 0.25 * math.cos(turn), 0) -- of the corner
    local inertia = (1 ^ 2 + 0.5 ^ 2) / 12                                                                          -- about the middle
    local spin_after = (arm.x * speed + inertia * spin) / (inertia + arm:length() ^ 2)
    for phase = 0, 4 do
      local time = 0.3 + 0.0043 * phase
      local scene = scene_of([[
        scene.plane, scene.step, scene.gravity = "xy", 1 / %d, vec(0, 0, 0)
        scene:floor { friction = 1 }
        scene:box { name = "box", size = vec(1, 0.5, 0.5), mass = 1, at = vec(0, %.17g, 0), orientation = quat(vec(0, 0, 1), %.17g), velocity = vec(0, %.17g, 0), spin = vec(0, 0, %.17g), friction = 1 }
      ]], rate, speed * time - arm.y, turn - spin * time, -speed, spin)
      scene:advance(0.34)
      expect(scene:find("box").spin.z):near(spin_after, 1e-4 * spin)
    end
  end)
end

test("two boxes that meet with crossing edges part along the normal of both edges", function()
  for seed = 1, 40 do
    local scene = open_text(([[
      scene.step, scene.gravity, scene.seed = 1 / 240, vec(0, 0, 0), %d
      local function some(low, high) return low + (high - low) * math.random() end
      local x, y, z = vec(1, 0, 0), vec(0, 1, 0), vec(0, 0, 1)
      local turn_a = quat(z, math.rad(some(3, 87)))                                              -- both edges are level
      local turn_b = quat(y, math.rad(some(10, 170))) * quat(z, math.rad(some(3, 87)))
      local on_a, on_b = turn_a:rotate(vec(-0.5, -0.5, some(-0.45, 0.45))), turn_b:rotate(vec(0.5, 0.5, some(-0.45, 0.45)))
      scene:box { size = 1, mass = 1, at = -on_b, orientation = turn_b, friction = 0, restitution = 0.7 }
      scene:box { name = "a", size = 1, mass = 1, at = vec(0, 0.3, 0) - on_a, orientation = turn_a, velocity = vec(0, -3, 0), friction = 0, restitution = 0.7 }
      scene:result("lightness", 2 + 6 * (on_a.x ^ 2 + on_a.z ^ 2 + on_b.x ^ 2 + on_b.z ^ 2))
    ]]):format(seed))
    scene:advance(0.11)
    local a, impulse = scene:find "a", 1.7 * 3 / scene:result "lightness"
    expect((a.velocity - vec(0, impulse - 3, 0)):length()):below(1e-3 * impulse)
  end
end)
