--- Two particles at distance r, tied by a law that is written in Lua; the scene tells the tension.
local function tension_of(law, r)
  local scene = open_text(([[
    scene.gravity = vec(0, 0, 0)
    scene.step = 1e-16
    local f = scene:family("f", { attributes = { charge = 1.5 } })
    local a = scene:particle { family = f, at = vec(0.3, -0.2, 0.1) }
    local b = scene:particle { family = f, at = vec(0.3, -0.2, 0.1) + %.17g * vec(0.6, 0, 0.8), velocity = vec(1, 0, 0) }
    local tie = scene:connect(a, b, %s)
    scene:probe("tension", function() return tie.force end)
  ]]):format(r, law))
  scene:step()
  return scene:read "tension"
end

--- Velocity that a law gives to the particles of a small cloud in one step.
local function kicks_of(law)
  local scene = open_text(([[
    scene.gravity = vec(0, 0, 0)
    local f = scene:family("f", { radius = 0.5, attributes = { charge = 1.5 } })
    for i = 1, 27 do
      local at = vec(i %% 3, i // 3 %% 3, i // 9) + 0.2 * vec(math.sin(i), math.sin(2 * i), math.cos(i))
      scene:particle { family = f, at = at, charge = 1 + 0.1 * (i %% 2) }
    end
    scene:interact(f, f, %s)
  ]]):format(law))
  scene:step()
  local kicks = {}
  for i, p in ipairs(scene.particles) do kicks[i] = p.velocity end
  return kicks, scene
end

test("the same law in five ways gives the same force", function()
  local ways = {
    "force.pair { tension = function(r, rate, a, b) return 24 * a.charge * b.charge * (1 / r^7 - 2 / r^13) end }",
    "force.pair { strict = true, potential = function(r, a, b) local s = 1 / r return 4 * a.charge * b.charge * (s^12 - s^6) end }",
    "force.pair { strict = true, potential = function(r, a, b) local s = 1 / r return where(r < 1.3, 4 * a.charge * b.charge * (s^12 - s^6), 4 * a.charge * b.charge * (s^12 - s^6)) end }",
    "force.pair { strict = true, potential = function(r, a, b) local s = 1 / r if r < 1.3 then return 4 * a.charge * b.charge * (s^12 - s^6) end return 4 * b.charge * a.charge * s^6 * (s^6 - 1) end }",
    "force.pair { potential = function(r, a, b) if r == 77 then return 0 end local s = 1 / r return 4 * a.charge * b.charge * (s^12 - s^6) end }",
  }
  for _, r in ipairs { 0.7, 0.9, 1.1, 1.29, 1.31, 2 } do
    local largest_term = 48 * 1.5 ^ 2 * math.max(1 / r ^ 13, 0.5 / r ^ 7)
    local closed = 24 * 1.5 ^ 2 * (1 / r ^ 7 - 2 / r ^ 13)
    for _, law in ipairs(ways) do expect(tension_of(law, r)):near(closed, 1e-12 * largest_term) end
  end
  local first = kicks_of(ways[1])
  local largest = 0
  for i = 1, #first do largest = math.max(largest, first[i]:length()) end
  for way = 2, #ways do
    local kicks = kicks_of(ways[way])
    for i = 1, #first do expect((kicks[i] - first[i]):length()):below(1e-12 * largest) end
  end
end)

test("library laws of two particles have their closed form", function()
  local r = 1.1
  local s6 = r ^ -6
  local laws = {
    { "force.spring { stiffness = 7, length = 1 }", 0.7 },
    { "force.spring { stiffness = 7, length = 1, damping = 2 }", 0.7 + 2 * 0.6 },
    { "force.damper { damping = 2 }", 2 * 0.6 },
    { "force.gravitation { constant = 3 }", 3 / r ^ 2 },
    { "force.gravitation { constant = 3, softening = 0.5 }", 3 * r / (r ^ 2 + 0.25) ^ 1.5 },
    { "force.coulomb { constant = 3 }", -3 * 1.5 ^ 2 / r ^ 2 },
    { "force.lennard_jones { epsilon = 2, sigma = 1 }", -24 * 2 * (2 * s6 ^ 2 - s6) / r },
    { "force.wca { epsilon = 2, sigma = 1 }", -24 * 2 * (2 * s6 ^ 2 - s6) / r },
    { "force.morse { depth = 2, steepness = 3, length = 1 }", 2 * 2 * 3 * (math.exp(-0.3) - math.exp(-0.6)) },
    { "force.buckingham { repulsion = 5, steepness = 2, attraction = 3 }", -10 * math.exp(-2.2) + 18 / r ^ 7 },
    { "force.yukawa { strength = 2, screening = 0.5 }", -2 * math.exp(-2.2) * (1 / r ^ 2 + 2 / r) },
    { "force.table { distances = { 0, 1, 2 }, potentials = { 0, 3, 6 } }", 3 },
  }
  for _, case in ipairs(laws) do expect(tension_of(case[1], r)):near(case[2], 1e-12 * 30) end
end)

test("every library law between pairs keeps the momentum", function()
  local laws = {
    "force.spring { stiffness = 7, length = 1, damping = 2 }", "force.damper { damping = 2 }",
    "force.gravitation { constant = 3, softening = 0.1 }", "force.coulomb { constant = 3 }",
    "force.lennard_jones { epsilon = 2, sigma = 1 }", "force.wca { epsilon = 2, sigma = 1 }",
    "force.morse { depth = 2, steepness = 3, length = 1 }",
    "force.buckingham { repulsion = 5, steepness = 2, attraction = 0.1 }",
    "force.yukawa { strength = 2, screening = 0.5 }", "force.hydrophobic { strength = 1, size = 1 }",
    "force.repel { stiffness = 100 }", "force.table { distances = { 0, 1, 2 }, tensions = { -1, 3, 0 } }",
    "force.flock { sight = 3, separation = 1, alignment = 1, cohesion = 1, one_sided = false }",
  }
  for _, law in ipairs(laws) do
    local kicks, scene = kicks_of(law)
    local size = 0
    for _, kick in ipairs(kicks) do size = size + kick:length() end
    if not law:find "damper" then expect(size):above(1e-4) end
    expect(scene.momentum:length()):below(1e-12 * math.max(size, 1))
  end
end)

test("an orbit of eccentricity 0.6 keeps its energy, to second order in the step", function()
  local function worst(steps)
    local scene = open_text(([[
      scene.gravity = vec(0, 0, 0)
      scene.step = 2 * math.pi / %d
      local sun = scene:particle { mass = 1, name = "sun" }
      local planet = scene:particle { mass = 1e-9, at = vec(0.4, 0, 0), velocity = vec(0, 2, 0) }
      scene:connect(sun, planet, force.pair { potential = function(r, a, b) return -a.mass * b.mass / r end })
    ]]):format(steps))
    for _ = 1, 20 * steps do scene:step() end
    return scene.error.worst_energy
  end
  local coarse, fine = worst(500), worst(1000)
  expect(fine):below(3e-3)
  expect(coarse / fine):near(4, 0.5)
end)

test("the ledger tells what each law gave, and which have no energy", function()
  local scene = open_text [[
    scene.gravity = vec(0, 0, 0)
    local f = scene:family "f"
    local a = scene:particle { family = f, at = vec(0, 0, 0) }
    local b = scene:particle { family = f, at = vec(1, 0, 0) }
    local push = scene:interact(f, f, force.pair { name = "push", potential = function(r) return 2 / r end })
    scene:field(f, force.point { name = "breeze", force = function(p) return vec(0, 0, 1) end })
    scene:probe("push energy", function() return push.energy end)
  ]]
  expect(scene:read "push energy"):near(2, 1e-14)
  scene:advance(1)
  local ledger = scene.ledger
  expect(ledger.laws.push):near(2 - scene:read "push energy", 1e-3)
  expect(ledger.laws.push):above(0.5)
  expect(#ledger.without_energy):equal(1)
  expect(ledger.without_energy[1]):equal("breeze")
  expect(ledger.open):near(1, 0.01) -- 1 N on 1 kg for 1 s gives 0.5 J to each of the two
  expect(scene.energy.kinetic):near(ledger.laws.push + ledger.open, 1e-4)
end)

test("what breaks is told once, with its force, and is gone", function()
  local scene = open_text [[
    scene.gravity = vec(0, 0, 0)
    local a = scene:particle {}
    local b = scene:particle { at = vec(1, 0, 0), velocity = vec(1, 0, 0) }
    local tie = scene:connect(a, b, force.spring { stiffness = 1 }, { breaks_at = { force = 0.3 } })
    scene:connect(a, b, force.spring { stiffness = 1e-3 }, { breaks_at = { length = 2 } })
    local told, pull = 0, 0
    scene:on("broke", function(thing, force) told = told + 1 if thing == tie then pull = force end end)
    scene:probe("told", function() return told end)
    scene:probe("pull", function() return pull end)
  ]]
  scene:advance(3)
  expect(scene:read "told"):equal(2)
  expect(scene:read "pull"):near(0.3, 0.01)
  expect(#scene.connections):equal(0)
end)

test("parameters are written while a law acts, without a new trace", function()
  local scene = open_text [[
    scene.gravity = vec(0, 0, 0)
    local p = scene:particle {}
    local wind = scene:field(scene, force.point {
      parameters = { strength = 1 }, strict = true,
      force = function(p, own) return vec(own.strength, 0, 0) end,
    })
    scene:at(0.5, function() wind.parameters.strength = 10 end)
    scene:at(0.7, function() wind.enabled = false end)
    scene:probe("speed", function() return p.velocity.x end)
  ]]
  scene:advance(1)
  expect(scene:read "speed"):near(0.5 + 10 * 0.2, 0.06)
end)

test("a law that cannot be traced is called, says so once with its line, and strict refuses it", function()
  local source = [[
    local f = scene:family "f"
    for i = 1, 4 do scene:particle { family = f, at = vec(i, 0, 0) } end
    scene:interact(f, f, force.pair { %s potential = function(r)
      if r == 1 then return 1 end
      return r
    end })
  ]]
  local scene = open_text(source:format "")
  for _ = 1, 5 do scene:step() end
  local warnings = {}
  for _, line in ipairs(scene.log) do
    if line.text:find "cannot be traced" then warnings[#warnings + 1] = line.text end
  end
  expect(#warnings):equal(1)
  expect(warnings[1]:find("text.lua:4", 1, true) ~= nil):is_true()
  expect(function() open_text(source:format "strict = true,") end):fails("text.lua:4")
end)

test("a law that reads what a position of the world has not is refused where it is put to use", function()
  local laws = {
    { "force.gravitation { constant = 1 }", "mass" },
    { "force.repel { stiffness = 10 }", "radius" },
    { "force.pair { potential = function(r, a, b) return a.mass * b.mass * r end }", "mass" },
    { "force.pair { tension = function(r, rate, a, b) return b.age end }", "age" },
    { "force.pair { force = function(d, u, a, b) if b.radius == 1 then return d end return -d end }", "radius" },
  }
  for _, law in ipairs(laws) do
    local source = "local p = scene:particle { at = vec(1, 2, 0) }\nscene:connect(p, vec(0, 3, 0), " .. law[1] .. ")"
    for _, words in ipairs { "text.lua:2", "'" .. law[2] .. "'", "the position vec(0, 3, 0) m of the world" } do
      expect(function() open_text(source) end):fails(words)
    end
  end
  local scene = open_text [[
    local p = scene:particle { at = vec(1, 2, 0), mass = 3 }
    local law = force.pair { potential = function(r, a) return a.mass * r end }
    scene:connect(p, vec(0, 3, 0), law)
    scene:connect(p, vec(0, 4, 0), law)
  ]]
  scene:advance(0.1)
end)

test("particles that are bonded are left out as far as exclude says", function()
  local function pairs_felt(exclude)
    local scene = open_text(([[
      scene.gravity = vec(0, 0, 0)
      local f = scene:family "f"
      local last
      for i = 1, 4 do
        local p = scene:particle { family = f, at = vec(i, 0, 0) }
        if last then scene:connect(last, p, force.spring { stiffness = 0 }) end
        last = p
      end
      local felt = scene:interact(f, f, force.pair { exclude = %d, potential = function(r) return 0 * r + 1 end })
      scene:probe("pairs", function() return felt.energy end)
    ]]):format(exclude))
    return scene:read "pairs"
  end
  for exclude = 0, 3 do expect(pairs_felt(exclude)):equal(({ 6, 3, 1, 0 })[exclude + 1]) end
end)

test("a field acts on its family, its group or all", function()
  local scene = open_text [[
    scene.gravity = vec(0, 0, 0)
    local f = scene:family "f"
    local g = scene:group "g"
    local a = scene:particle { name = "a", family = f }
    local b = scene:particle { name = "b", at = vec(5, 0, 0) }
    local c = scene:particle { name = "c", at = vec(9, 0, 0) }
    g:add(b)
    local function pull(x, y, z) return force.point { force = function() return vec(x, y, z) end } end
    scene:field(f, pull(1, 0, 0))
    scene:field(g, pull(0, 1, 0))
    scene:field(scene, pull(0, 0, 1))
  ]]
  scene:advance(1)
  expect(scene:find("a").velocity):near(vec(1, 0, 1), 0.01)
  expect(scene:find("b").velocity):near(vec(0, 1, 1), 0.01)
  expect(scene:find("c").velocity):near(vec(0, 0, 1), 0.01)
end)

test("a particle that goes takes its connections along", function()
  local scene = open_text [[
    local a, b, c = scene:particle {}, scene:particle { at = vec(1, 0, 0) }, scene:particle { at = vec(2, 0, 0) }
    scene:connect(a, b, force.spring { stiffness = 1 })
    scene:connect(b, c, force.spring { stiffness = 1 })
    scene:connect({ a, b, c }, force.angle { stiffness = 1 })
    scene:connect(a, c, force.spring { stiffness = 1 })
    scene:at(0.1, function() b:remove() end)
  ]]
  expect(#scene.connections):equal(4)
  scene:advance(0.2)
  expect(#scene.connections):equal(1)
  expect(#scene.particles):equal(2)
end)

test("bad laws are told by their line", function()
  local function law(text)
    return function()
      open_text('local f = scene:family "f"\nscene:particle { family = f }\n' ..
                'scene:particle { family = f, at = vec(1, 0, 0) }\nscene:interact(f, f, ' .. text .. ')'):step()
    end
  end
  expect(law "force.pair { potential = function() end }"):fails("text.lua:4: the law must return a number [J], got nil")
  expect(law "force.pair { potential = function() return 'much' end }"):fails("must return a number [J], got a string")
  expect(law "force.pair { force = function(d) return d.x end }"):fails("must return a vec [N], got a number")
  expect(law "force.pair { potential = function(r, a) return a.charge * r end }"):fails("family 'f' has no attribute 'charge'")
  expect(law "force.pair { cutoff = -1, potential = function(r) return r end }"):fails("cutoff must be > 0 m, got -1")
  expect(law "force.lennard_jones { epsilon = 1 }"):fails("lennard_jones: sigma [m] is missing")
  expect(law "force.lennard_jones { epsilon = -1, sigma = 1 }"):fails("epsilon must be >= 0 J, got -1")
  expect(law "force.lennard_jones { epsilon = 1, sigma = 1, sgma = 2 }"):fails("sgma")
  expect(law "force.pair { potential = function(r) local s = 0 for i = 1, r do s = s + i end return s * r end }")
    :fails("write math.floor(x), or give the law as a tension")
  expect(law "force.pair { potential = function(r) return strength * r end }")
    :fails("arithmetic needs numbers, got nil (a name that nothing was given to?)")
  expect(law "function(r) return r end"):fails("write force.pair{ potential = function … }")
  expect(law "force.table { distances = { 1, 1 }, potentials = { 0, 1 } }"):fails("force.table: its positions must rise")
end)

test("a message names a place once", function()
  for _, law in ipairs { "function() end", "function() return 0 / 0 end", "function(r) local t return t.x * r end" } do
    local ok, why = pcall(open_text, ([[
      local f = scene:family "f"
      scene:interact(f, f, force.pair { potential = %s })]]):format(law))
    expect(ok):equal(false)
    local _, places = why:gsub("text%.lua:", "")
    expect(places):equal(1)
  end
end)

test("two particles at one place, torn apart by a force that is not a number, are told with their distance", function()
  local scene = open_text [[
    local f = scene:family "f"
    scene:particle { family = f }
    scene:particle { family = f }
    scene:interact(f, f, force.pair { force = function(d) return d / d:length() ^ 3 end })
  ]]
  expect(function() scene:step() end):fails "is not a finite number, at a distance of 0 m; the scene is stopped"
end)

test("the ledger is kept once it was read, and closes", function()
  local scene = open_text [[
    local a = scene:particle { at = vec(0, 0, 0) }
    local b = scene:particle { at = vec(1.5, 0, 0), velocity = vec(0, 1, 0) }
    scene:connect(a, b, force.spring { stiffness = 20, length = 1 })
    scene:nail(scene:particle { at = vec(3, 0, 0) })
  ]]
  expect(scene.ledger.closure):equal(nil)
  scene:advance(1)
  local ledger = scene.ledger
  expect(ledger.since):equal(0)
  expect(ledger.closure):below(1e-10)
  expect(ledger.gravity):near((9.81 ^ 2 + 8.81 ^ 2 - 1) / 2, 1e-6)
  expect(math.abs(ledger.truncation.spring)):below(1e-2)
  expect(math.abs(ledger.truncation.spring)):above(0)
  expect(ledger.hand + ledger.event + ledger.projection):near(0, 1e-12)
end)

test("a particle that is tied, or joined to another, while a law pulls at it goes on as if it had been from the start", function()
  local ties = {
    "scene:rod(p, vec(1, -1, 0))", "scene:nail(p)", "scene:hinge(p, r)", "scene:on_plane(p, { normal = vec(0, 1, 1) })",
    "scene:string({ p, vec(1, -1, 0) })", "scene:follow(p, function(t) return vec(1, 0, 0) end)",
  }
  for _, tie in ipairs(ties) do
    local places = {}
    for _, when in ipairs { "start", "later" } do
      local scene = open_text([[
        scene.gravity = vec(0, 0, 0)
        local family = scene:family "family"
        local p = scene:particle { at = vec(1, 0, 0), family = family, name = "p" }
        local q = scene:particle { at = vec(2, 0, 0), family = family, mass = 5, name = "q" }
        local r = scene:particle { at = vec(1, 0, 0), mass = 2 }
        scene:interact(family, family, force.spring { stiffness = 6, length = 1 })
        local function tie() ]] .. tie .. [[ end
        if "]] .. when .. [[" == "start" then tie() else scene:at(0.05, tie) end
        scene:at(0.06, function() q:kick(vec(5, 5, 0)) end)
      ]])
      scene:advance(0.1)
      places[#places + 1] = scene:find("p").position
      places[#places + 1] = scene:find("q").position
      scene:advance(1)
      expect(scene.error.energy):below(1e-3)
      places[#places + 1] = scene:find("p").position
      places[#places + 1] = scene:find("q").position
    end
    for i = 1, 4 do expect((places[i] - places[4 + i]):length()):below(1e-6) end
  end
end)

test("a called potential that takes the time and does not use it has an energy, and one that uses it has none", function()
  local function scene_of(potential)
    local scene = open_text([[
      scene.gravity = vec(0, 0, 0)
      local a, b = scene:particle(), scene:particle { at = vec(2, 0, 0) }
      local function branch(x) if x == 1e9 then return 0 end return 1 end   -- == on a simulated value is not traced
      local tie = scene:connect(a, b, force.pair { potential = function(r, a, b, own, t) return ]] .. potential .. [[ end })
      scene:probe("own", function() return tie.energy or -1 end)
    ]])
    scene:advance(1)
    return scene
  end
  local still = scene_of "branch(r) * 8 * (r - 1) ^ 2"
  expect(still:read "own"):near(still.energy.potential, 1e-12)
  expect(still.energy.total):near(8, 1e-2)
  expect(still.error.energy):below(1e-2)
  for _, timed in ipairs { "branch(r) * (8 + math.sin(t)) * (r - 1) ^ 2", "branch(r) * (t > 100 and 9 or 8) * (r - 1) ^ 2" } do
    local scene = scene_of(timed)
    expect(scene:read "own"):equal(-1)
    expect(scene.energy.potential):equal(0)
    expect(scene.ledger.open):near(scene.energy.kinetic, 1e-9)
  end
end)

test("a law that goes by mass and acts on points of a body that have none is told, once", function()
  local bar = "local bar = scene:body { name = 'bar', mass = 1, inertia = vec(1, 1, 1), points = { vec(0, 0, 0), %s } }\n"
  local function warnings(source)
    local scene = open_text(source)
    for _ = 1, 3 do
      scene:step()
      scene:find("bar").mass = 2  -- the laws are arranged anew
    end
    local list = {}
    for _, line in ipairs(scene.log) do if line.kind == "warning" then list[#list + 1] = line.text end end
    return list
  end
  local anchors, weighty = bar:format "vec(1, 0, 0)", bar:format "{ at = vec(1, 0, 0), mass = 1 }"
  local bath = "scene:field(scene, force.thermostat { rate = 1, temperature = 1 })"
  local told = warnings(anchors .. bath)
  expect(#told):equal(1)
  expect(told[1]):equal("text.lua:2: thermostat: it goes by the mass of points, and those of body 'bar' that it acts on have none, so it does nothing to it; give the mass of the body to its points, as in points = { { at = vec(0, 0, 0), mass = 1 } }")
  expect(#warnings(weighty .. bath)):equal(0)
  expect(#warnings(weighty .. "local g = scene:group 'g' g:add(bar.points[1])\n" .. bath:gsub("scene,", "g,"))):equal(1)
  expect(#warnings(anchors .. "scene:field(scene, force.drag { linear = 1 })")):equal(0)
  expect(#warnings(anchors .. "scene:field(scene, force.point { force = function(p) return vec(0, -p.mass, 0) end })")):equal(1)
end)

test("a field on a body without points does nothing and is told, once", function()
  local function warnings(source)
    local scene = open_text("local box = scene:box { size = 0.2, mass = 1, name = 'box' }\n" .. source
      .. "\nscene:on('step', function() scene:ball { radius = 0.1, at = vec(0, 9 * scene.stats.steps, 0) } end)")
    for _ = 1, 3 do scene:step() end
    local list = {}
    for _, line in ipairs(scene.log) do if line.kind == "warning" then list[#list + 1] = line.text end end
    return list
  end
  local drag = "force.drag { linear = 10 })"
  for _, on in ipairs { "scene:field(scene, ", "local g = scene:group 'g' g:add(box) scene:field(g, " } do
    local told = warnings(on .. drag)
    expect(#told):equal(1)
    expect(told[1]):equal("text.lua:2: drag: laws act on particles, and body 'box' has no points, so it does nothing to it; give it one, as in points = { vec(0, 0, 0) }")
  end
  expect(#warnings("box:add_point { at = vec(0, 0, 0) }\nscene:field(scene, " .. drag)):equal(0)
  expect(#warnings("scene:particle {}\nscene:field(scene, " .. drag)):equal(0)
end)

test("the error of the energy is told alike before and after an edit by which laws act anew", function()
  for _, edit in ipairs { "scene:ball { radius = 0.1, at = vec(0, 9, 0) }", "q.position = vec(6, 0, 0)", "q:remove()",
                          "scene:connect(p, q, force.spring { stiffness = 1 })", "p.mass = 2" } do
    local scene = open_text([[
      scene.gravity = vec(0, 0, 0)
      local ions = scene:family("ions", { mass = 1, attributes = { charge = 1 } })
      scene:interact(ions, ions, force.coulomb { constant = 10 })
      local p = scene:particle { family = ions, at = vec(5, 0, 0) }
      local q = scene:particle { family = ions, at = vec(7, 0, 0) }
      scene:at(0.1, function()
        ]] .. edit .. [[

        scene:result("energy", scene.error.energy)
        scene:result("worst", scene.error.worst_energy)
        scene:result("laws", scene.ledger.law_edit)
      end)
    ]])
    scene:advance(0.2)
    expect(scene:result "energy"):below(1e-4)
    expect(scene:result "worst"):below(1e-4)
    expect(scene:result "laws"):near(scene.ledger.law_edit, 1e-9)
  end
end)
