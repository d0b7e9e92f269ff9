local function frame(code)
  return open_text([[
    local wall = scene:body { mass = 1, inertia = vec(1, 1, 1), name = "wall", points = { at = vec(0, 0, 0) } }
    scene:nail(wall.at)
    scene:orient(wall)
    local arm = scene:body { mass = 2, inertia = vec(0.01, 0.2, 0.2), at = vec(0.5, 0, 0), name = "arm",
                             points = { root = vec(-0.5, 0, 0), tip = vec(0.5, 0, 0) } }
  ]] .. code)
end

test("a weld tells its load, and breaks at it", function()
  local scene = frame [[
    local weld = scene:weld(arm, wall, { name = "weld" })
    local told
    scene:on("broke", function(thing, force, story)
      told = tonumber(story:match "^weld 'weld'.* by its load of ([%d.]+) N$")
    end)
    scene:probe("told", function() return told or 0 end)
    scene:at(0.5, function() weld.breaks_at = { force = 19 } end)
  ]]
  scene:advance(0.4)
  expect(scene:find("weld").force.y):near(2 * 9.81, 1e-6)
  expect(scene:find("weld").torque.z):near(2 * 9.81 * 0.25, 1e-6)
  scene:advance(0.2)
  expect(scene:find("weld")):equal(nil)
  expect(scene:read "told"):near(2 * 9.81, 1e-6)
end)

test("a hinge turns about its axis only, breaks at its load, and may rest", function()
  local scene = frame [[
    local hinge = scene:hinge(wall.at, arm.root, { axis = vec(0, 0, 1), name = "hinge", breaks_at = { force = 1e4 } })
    arm.spin = vec(3, 2, 1)
    scene:at(1, function() hinge.enabled = false end)
    scene:at(1.5, function() hinge.breaks_at = nil end)
  ]]
  scene:advance(0.9)
  local arm = scene:find("arm")
  expect(math.abs(arm.spin.x) + math.abs(arm.spin.y)):below(1e-9)
  expect(scene.error.worst_constraint):below(1e-10)
  scene:advance(1)
  expect(arm.position.y):below(-1)
end)

test("motors, limits and aligns take numbers or functions of time", function()
  local scene = frame [[
    scene:hinge(wall.at, arm.root)
    local motor = scene:motor(arm, wall, { axis = vec(0, 0, 1), angle = function(t) return 0.5 * t end, name = "motor" })
    scene:limit(arm, { axis = vec(0, 0, 1), max = 0.25, name = "limit" })
    local free = scene:body { mass = 1, inertia = vec(1, 2, 3), at = vec(3, 0, 0) }
    scene:align(free, vec(1, 0, 0), vec(0, 1, 0), { angle = 1 })
    scene:at(0.4, function() motor.angle = 0.2 end)
  ]]
  scene:advance(2.5)
  expect(scene:find("motor").turned):near(0.2, 1e-6)
  expect(scene:find("limit").value):near(0.2, 1e-6)
end)

test("a string slides and goes slack, a bead keeps to its path, a point to its plane", function()
  local scene = open_text [[
    local a, b = scene:particle { at = vec(-1, -1, 0), mass = 2, name = "a" }, scene:particle { at = vec(1, -1, 0) }
    scene:string({ a, vec(-1, 0, 0), vec(1, 0, 0), b }, { name = "string" })
    local bead = scene:particle { at = vec(0, 0, 1), name = "bead" }
    scene:on_path(bead, { vec(0, 0, 1), vec(1, -1, 1), vec(2, 0, 1) }, { smooth = true })
    scene:on_plane(scene:particle { name = "sliding" }, { normal = vec(0, 1, 0) })
  ]]
  scene:advance(0.3)
  expect(scene:find("a").position.y):near(-1 - 0.5 * 9.81 / 3 * 0.09, 1e-9)
  expect(scene:find("string").force):near(2 * 2 * 9.81 / 3, 1e-7)
  expect(scene:find("sliding").position.y):near(0, 1e-12)
  expect(scene.error.worst_constraint):below(1e-10)
end)

test("a lift rests at the end of its path, and its string has the counterweight to bear", function()
  for _, step in ipairs { 1 / 60, 1 / 240 } do
    local scene = open_text("scene.step = " .. step .. [[

      local cabin = scene:particle { at = vec(0, 0, 0), mass = 300, name = "cabin" }
      local counterweight = scene:particle { at = vec(2, 6, 0), mass = 250 }
      scene:on_path(cabin, { vec(0, 0, 0), vec(0, 6, 0) }, { name = "rail" })
      scene:string({ cabin, vec(0, 8, 0), vec(2, 8, 0), counterweight }, { name = "rope" })
    ]])
    for _ = 1, 120 do
      scene:step()
      expect(scene:find("rope").force):near(250 * 9.81, 1e-5)
      expect(scene:find("rail").force.y):near(50 * 9.81, 1e-5)
    end
    expect(scene.stats.fallback_steps + scene.stats.halved_steps):equal(0)
    expect(scene.error.worst_energy):below(1e-6)
  end
end)

test("a wheel on a nail within round-off of its centre spins on", function()
  for _, off in ipairs { 0, 5e-19, 1e-17, 1e-15, 1e-13, 1e-11, 1e-9, 1e-7 } do
    local scene = open_text(([[
      local wheel = scene:cylinder { radius = 0.4, length = 0.1, axis = vec(0, 0, 1), mass = 2, spin = vec(0, 0, 5), points = { c = vec(%g, -%g, 0) } }
      scene:nail(wheel.c)
    ]]):format(off, off))
    scene:advance(1)
    expect(scene.bodies[1].spin:length()):near(5, 1e-6)
    expect(scene.stats.fallback_steps):equal(0)
  end
end)

test("a tie that is refused is not there", function()
  local scene = open_text [[
    local p = scene:particle { at = vec(0, 2, 0) }
    local made = pcall(function() scene:rod(p, vec(0, 0, 0), { breaks_at = { torque = 1 } }) end)
    scene:result("made", made)
  ]]
  scene:advance(1)
  expect(scene:result "made"):equal(false)
  expect(scene.particles[1].velocity.y):near(-9.81, 1e-6)
end)

test("what cannot be is an error at its line", function()
  local function fails(code, text)
    expect(function() open_text("local p = scene:particle()\n" .. code) end):fails(text)
  end
  fails("scene:motor(p, { axis = vec(0, 0, 1), speed = 1 })", "text.lua:2: motor: argument 1 must be a body")
  fails("scene:on_path(p, { vec(0, 0, 0) })", "text.lua:2: on_path: a path needs two positions or more, got 1")
  fails("scene:limit(p, vec(0, 1, 0), { length = 1, max = 2 })", "text.lua:2: limit: give length or max, which are the same, not both")
  fails("shape.ball(1, { radius = 2 })", "text.lua:2: ball: its radius is given twice")
  fails("scene:nail(p, vec(0, 0, 0), {}, { time_constant = 1 })", "text.lua:2: nail: takes at most 3 arguments, got 4")
  fails("scene:group('all', { p })", "text.lua:2: group: takes at most 1 argument, got 2")
  fails("p:remove(p)", "text.lua:2: remove: takes no arguments, got 1")
  fails("scene:on_plane(p, { time_constant = -1 })", "text.lua:2: on_plane: time_constant must be > 0 s")
  local bar = "local b = scene:body { mass = 1, inertia = vec(1, 1, 1), points = { o = vec(0, 0, 0) } }\n"
  fails(bar .. "scene:motor(b, { axis = vec(0, 0, 1), speed = 1, angle = 1 })", "motor: give its speed or its angle, not both")
  fails(bar .. "scene:hinge(b.o, p, { breaks_at = { length = 1 } })", "hinge: breaks_at: unknown field 'length'")
  fails(bar .. "scene:hinge(b.o, p, { breaks_at = { torque = 1 } })", "breaks_at.torque: it has no axis, and bears no torque")
  fails(bar .. "scene:rod(p, vec(0, 1, 0), { breaks_at = { torque = 1 } })", "breaks_at.torque: it bears no torque; give `force`")
  fails(bar .. "scene:orient(b, quat(vec(0, 0, 1), 1), { breaks_at = { force = 1 } })", "breaks_at.force: it bears no force; give `torque`")
  fails(bar .. "scene:limit(b, { axis = vec(0, 0, 1), max = 1, breaks_at = { length = 1 } })", "breaks_at.length: it has no length; give `torque`")
  fails("scene:limit(p, vec(0, 1, 0), { min = 2, max = 1 })", "text.lua:2: limit: min must be below max")
  fails("scene:string({ p })", "text.lua:2: string: needs two points or more, got 1")
  fails("scene:weld(p, p)", "text.lua:2: weld: argument 1 must be a body")
end)

test("a string on one body ties nothing, and lets the body be cut loose", function()
  local scene = open_text [[
    local bar = scene:body { mass = 1, inertia = vec(1, 1, 1), name = "bar",
                             points = { a = vec(-1, 0, 0), b = vec(1, 0, 0) } }
    scene:string { bar.a, bar.b }
    local hinge = scene:hinge(bar.a, scene:body { mass = 1, inertia = vec(1, 1, 1), at = vec(-1, 0, 0),
                                                  points = { o = vec(0, 0, 0) } }.o)
    scene:at(0.1, function() hinge:cut() end)
  ]]
  scene:advance(1)
  expect(scene:find("bar").position.y):near(-0.5 * 9.81, 1e-9)
  expect(scene.stats.articulates):equal(0)
end)

test("suzuki4 refuses a spring with damping", function()
  expect(function()
    open_text [[
      scene.integrator = "suzuki4"
      scene:connect(scene:particle(), vec(1, 0, 0), force.spring { stiffness = 1, damping = 0.1 })
    ]]:advance(0.1)
  end):fails("depends on velocities")
end)

test("what breaks or is removed is told as the thing that the script holds", function()
  local scene = open_text [[
    local function particle(x) return scene:particle { at = vec(x, 0, 0) } end
    local weak = { breaks_at = { force = 5 } }
    local ties = {
      rod = scene:rod(particle(0), vec(0, 1, 0), weak), nail = scene:nail(particle(1), weak), follow = scene:follow(particle(2), vec(2, 0, 0), weak),
      string = scene:string({ particle(3), vec(3, 1, 0) }, weak), on_plane = scene:on_plane(particle(4), weak),
    }
    local gone = scene:rod(particle(5), vec(5, 1, 0))
    local function tell(thing)
      for name, tie in pairs(ties) do if tie == thing then scene:result(name, true) end end
      if thing == gone then scene:result("gone", true) end
    end
    scene:on("broke", tell)
    scene:on("removed", tell)
    scene:at(0.05, function() gone:remove() end)
  ]]
  scene:advance(0.2)
  for _, name in ipairs { "rod", "nail", "follow", "string", "on_plane", "gone" } do expect(scene:result(name)):equal(true) end
end)

test("what breaks by its length says its length", function()
  local scene = open_text [[
    scene.gravity = vec(0, 0, 0)
    scene:on("broke", function(thing, force, story) scene:result(story:match "^%a+", story:match "by its (.*)$") end)
    local function pair(y, v)
      return scene:particle { at = vec(0, y, 0) }, scene:particle { at = vec(1, y, 0), velocity = vec(v, 0, 0) }
    end
    local a, b = pair(0, 0)
    scene:rod(a, b, function(t) return 1 + t end).breaks_at = { length = 1.5 }
    local c, d = pair(1, 1)
    scene:connect(c, d, force.spring { stiffness = 0.01 }, { breaks_at = { length = 1.5 } })
  ]]
  scene:advance(1)
  expect(tonumber(scene:result "rod":match "^length of ([%d.]+) m$")):near(1.5, 0.01)
  expect(tonumber(scene:result "connection":match "^length of ([%d.]+) m$")):near(1.5, 0.01)
end)

test("a motor starts a linkage of four bars at its speed, and all that moves then is its work", function()
  local scene = open_text [[
    scene.gravity = vec(0, 0, 0)
    local _ = scene.ledger
    local function bar(a, b)
      local d = b - a
      local l = d:length()
      return scene:body {
        mass = l, inertia = vec(0.01, l ^ 3 / 12, l ^ 3 / 12), at = (a + b) * 0.5,
        orientation = quat(vec(0, 0, 1), math.atan(d.y, d.x)), points = { a = vec(-l / 2, 0, 0), b = vec(l / 2, 0, 0) },
      }
    end
    local crank = bar(vec(0, 0, 0), vec(0, 0.5, 0))
    local coupler, rocker = bar(vec(0, 0.5, 0), vec(1.5, 1, 0)), bar(vec(1.5, 1, 0), vec(1.5, 0, 0))
    scene:nail(crank.a)
    scene:nail(rocker.b)
    scene:hinge(crank.b, coupler.a)
    scene:hinge(coupler.b, rocker.a)
    scene:motor(crank, { axis = vec(0, 0, 1), speed = -6 })
    crank.name = "crank"
  ]]
  scene:advance(1 / 240)
  local ledger = scene.ledger
  expect(scene:find("crank").spin.z):near(-6, 1e-6)
  expect(ledger.edit + ledger.motor):near(scene.energy.kinetic, 1e-4)
  scene:advance(2)
  expect(scene.error.worst_energy):below(1e-6)
end)

test("a motor turns what swings aside at its speed, and takes or gives no energy but its work", function()
  local scene = open_text [[
    scene.gravity = vec(0, 0, 0)
    local rod = scene:body {
      mass = 1, inertia = vec(0.01, 0.08, 0.08), at = vec(0.5, 0, 0), points = { a = vec(-0.5, 0, 0) }, spin = vec(0, 2, 0),
    }
    scene:nail(rod.a)
    scene:motor(rod, { axis = vec(0, 0, 1), speed = 3 })
  ]]
  scene:advance(2)
  expect(scene.error.worst_energy):below(1e-9)
end)

test("the ledger of a frame that cannot move closes too", function()
  local scene = open_text [[
    local _ = scene.ledger
    local function bar(x, y, angle)
      return scene:body { mass = 1, inertia = vec(0.01, 0.1, 0.1), at = vec(x, y, 0), orientation = quat(vec(0, 0, 1), angle),
        points = { a = vec(-0.5, 0, 0), b = vec(0.5, 0, 0) } }
    end
    local left, right = bar(0.25, math.sqrt(3) / 4, math.pi / 3), bar(0.75, math.sqrt(3) / 4, -math.pi / 3)
    scene:hinge(left.b, right.a)
    scene:nail(left.a)
    scene:nail(right.b)
  ]]
  scene:advance(1)
  expect(scene.ledger.closure):below(1e-10)
end)

test("the ledger of what turns freely closes too", function()
  local scene = open_text [[
    local _ = scene.ledger
    scene.gravity = vec(0, 0, 0)
    local a = scene:body { mass = 1, inertia = vec(0.05, 0.06, 0.08), spin = vec(0.3, 0.2, 0.1) }
    local b = scene:body { mass = 2, inertia = vec(0.1, 0.09, 0.08), at = vec(2, 0, 0), spin = vec(0.3, -0.2, 0.1) }
    scene:align(a, vec(1, 0, 0), b, vec(0, 1, 0))
  ]]
  scene:advance(1)
  expect(scene.ledger.closure):below(1e-10)
end)

test("a thin rod that meets the limit of its angle swings back from it, wherever that is", function()
  for i = 0, 15 do
    local scene = open_text([[
      local rod = scene:body { points = { a = { mass = 1 }, b = { at = vec(1, 0, 0), mass = 1 } }, name = "rod" }
      scene:nail(rod.a)
      scene:limit(rod, { axis = vec(0, 0, 1), min = ]] .. -1.6 - 0.1 * i .. [[, max = 2 })
    ]])
    scene:advance(3)
    expect(scene.stats.fallback_steps):equal(0)
    expect(scene.error.worst_energy):below(1e-3)
  end
end)

test("a limit of the turn about an axis holds while that tilts over, and takes energy by its impacts alone", function()
  for tilt = 0, 2, 0.5 do
    local scene = open_text("local tilt = " .. tilt .. [[
      local rod = scene:body { mass = 1, inertia = vec(0.01, 0.1, 0.1), spin = vec(3, 0, 5), name = "rod",
        at = vec(0.5 * math.cos(tilt), 0, -0.5 * math.sin(tilt)), orientation = quat(vec(0, 1, 0), tilt),
        points = { o = vec(-0.5, 0, 0) } }
      scene:nail(rod.o)
      scene:limit(rod, { axis = vec(0, 0, 1), min = -0.5, max = 0.5, name = "limit" })
      local _ = scene.ledger
    ]])
    scene:advance(1)
    expect(scene.stats.fallback_steps):equal(0)
    expect(scene.error.worst_energy):below(1e-10)
    expect(math.abs(scene:find("limit").value)):below(0.5 + 1e-9)
  end
end)

test("a rod that breaks breaks when its load says, not at the end of the step", function()
  -- A pendulum let go at the level of its pivot bears 3 m g sin of its angle below it: 2 m g at a sine of 2/3.
  local g, sine = 9.81, 2 / 3
  local speed, cosine = math.sqrt(2 * g * sine), math.sqrt(1 - sine * sine)
  local vx, vy = -speed * sine, -speed * cosine
  for _, steps in ipairs { 60, 240 } do
    local scene = open_text(([[
      scene.step, scene.plane, scene.gravity = 1 / %d, "xy", vec(0, -9.81, 0)
      local bob = scene:particle { at = vec(1, 0, 0), mass = 1, name = "bob" }
      scene:rod(vec(0, 0, 0), bob).breaks_at = { force = 2 * 9.81 }
    ]]):format(steps))
    scene:advance(1)
    local bob = scene:find "bob"
    -- x of the parabola where it now is, by how far it fell since
    local fallen = -bob.position.y - sine
    local t = (vy + math.sqrt(vy * vy + 2 * g * fallen)) / g
    expect(bob.position.x):near(cosine + vx * t, steps == 60 and 3e-3 or 2e-4)
    expect(scene.error.energy):below(1e-12)
  end
end)

test("a limit is met without a bounce beside a thermostat too", function()
  for _, start in ipairs { 0.5, 0.501, 0.5025, 0.503 } do
    local scene = open_text(([[
      scene.gravity = vec(0, 0, 0)
      scene:field(scene, force.thermostat { rate = 1e-9, temperature = 0 })
      local bob = scene:particle { at = vec(%s, 0, 0), velocity = vec(1, 0, 0), name = "bob" }
      scene:limit(bob, vec(0, 0, 0), { max = 0.7 })
    ]]):format(start))
    scene:advance(0.5)
    expect(math.abs(scene:find("bob").velocity.x)):below(1e-6)
  end
end)

test("a force on what is held at the origin, where nothing has a length and nothing falls, is borne and told exactly", function()
  for _, tie in ipairs { "scene:nail(p)", "scene:on_plane(p, { normal = vec(1, 0, 0) })",
                         "scene:follow(p, function(t) return vec(0, 0, 0) end)" } do
    for _, pull in ipairs { 1e-6, 10, 1e6 } do
      local way = pull / 1e-3 / 240 ^ 2  -- m, in a step of 1/240 s, were it free
      local scene = open_text(([[
        scene.gravity = vec(0, 0, 0)
        local p = scene:particle { mass = 1e-3, at = vec(0, 0, 0), name = "p" }
        scene:field(scene, force.point { potential = function(q) return -%g * q.position.x end })
      ]]):format(pull) .. tie)
      scene:advance(0.5)
      expect(scene.stats.fallback_steps):equal(0)
      expect(scene.error.worst_energy):below(1e-4)
      expect(scene:find("p").position:length()):below(1e-12 * way)
      expect(scene:find("p").velocity:length()):below(1e-12 * way)
    end
  end
end)

test("a hinge of three breaks by what the member bears that the other two hold", function()
  local function holds(limit)
    local scene = open_text(([[
      local function link(x)
        local link = scene:body { at = vec(x / 2, 0.5, 0), mass = 0.01, inertia = vec(1, 1, 1) * 1e-3,
                                  points = { top = vec(x / 2, 0.5, 0), foot = vec(-x / 2, -0.5, 0) } }
        scene:nail(link.top)
        return link
      end
      local left, right = link(0.2), link(-0.2)
      local bob = scene:body { at = vec(0, -1, 0), mass = 6, inertia = vec(1, 1, 1), points = { top = vec(0, 1, 0) } }
      local hinge = scene:hinge(left.foot, right.foot, bob.top, { name = "hinge", breaks_at = { force = %g } })
      scene:at(0.4, function()
        scene:result("holds", hinge.alive and hinge.is_hinge and 1 or 0)
        if hinge.alive and hinge.is_hinge then scene:result("load", hinge:force(bob):length()) end
      end)
    ]]):format(limit))
    scene:advance(0.5)
    return scene:result "holds" == 1, scene
  end
  local whole, scene = holds(60)
  expect(whole):is_true()
  expect(scene:result "load"):near(6 * 9.81, 1e-6)
  for _, limit in ipairs { 31, 40, 58 } do
    local still = holds(limit)
    expect(still):equal(false)
  end
end)
