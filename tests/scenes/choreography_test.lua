test("combine: the bodies meet at P, hang together, and are pulled apart, again and again", function()
  local scene = open("scenes/combine.lua")
  local P = vec(0, 2, 0)
  while scene:read "meetings" < 1 and scene.time < 8 do scene:step() end
  expect(#scene.hinges):equal(1)
  expect((scene.hinges[1].position - P):length()):below(1e-3)
  expect(scene:read "distance of the tips"):below(1e-6)
  scene:advance(24)
  expect(scene:read "meetings"):above(2)
  expect(scene:read "partings"):above(1)
  expect(scene.stats.fallback_steps):equal(0)
end)

test("combine: a body that a person removes ends the play, and nothing else", function()
  local scene = open("scenes/combine.lua")
  scene:advance(4)
  scene:find("a"):remove()
  scene:advance(8)
  expect(scene:find("b").alive):is_true()
end)

test("puppet: it waves and walks, and its hinges hold", function()
  local scene = open("scenes/puppet.lua")
  local low, high = 9, 0
  for _ = 1, 240 * 12 do
    scene:step()
    local y = scene:read "right hand"
    low, high = math.min(low, y), math.max(high, y)
  end
  expect(high - low):above(0.5)
  expect(scene:read "head"):above(1.5)
  expect(scene.error.worst_hinge_gap):below(1e-9)
end)

test("puppet: it dances on when a string is cut and an arm is gone", function()
  local scene = open("scenes/puppet.lua")
  scene:advance(1)
  scene:find("left knee string"):remove()
  scene:find("right arm"):remove()
  scene:find("right lower arm"):remove()
  scene:advance(8)
  expect(scene:read "head"):above(1)
end)

test("bonding: hot particles come apart, cold ones that are near are tied again", function()
  local scene = open_text [[
    scene.gravity = vec(0, 0, 0)
    local gas, group = scene:family "gas", scene:group "gas"
    for x = 1, 3 do for y = 1, 3 do for z = 1, 3 do
      group:add(scene:particle { family = gas, at = vec(x, y, z), name = "ball" })
    end end end
    scene:bonding { families = gas, near = 1.1, below = 0.1, above = 1, law = force.spring { stiffness = 10 } }
    scene:at(0.1, group, function(g) g:heat(100) end)
    scene:at(0.2, group, function(g) g:heat(-0.99 * 1.5 * 26 * g.temperature) end)
    scene:probe("bonds", function() return #scene.connections end)
  ]]
  scene:advance(0.05)
  expect(scene:read "bonds"):equal(54)
  scene:advance(0.1)
  expect(scene:read "bonds"):equal(0)
  scene:advance(0.3)
  expect(scene:read "bonds"):above(0)
end)

test("bonding: the hinges of a chain melt, and are made again of the ends that are near when it is cold", function()
  local scene = open_text [[
    scene.gravity = vec(0, 0, 0)
    local joint, chain, last = scene:family "joint", scene:group "chain", nil
    for i = 1, 6 do
      local link = scene:body { at = vec(i, 0, 0), points = {
        head = { at = vec(-0.5, 0, 0), mass = 1, family = joint }, tail = { at = vec(0.5, 0, 0), mass = 1, family = joint } } }
      if last then scene:hinge(last.tail, link.head) end
      chain:add(link)
      last = link
    end
    scene:bonding { families = joint, near = 0.3, below = 0.01, above = 0.1, hinge = true }
    scene:at(0.5, chain, function(c) c:heat(8) end)
    scene:after(0.55, chain, function(c) c:heat(-0.9999 * 0.5 * 27 * c.temperature) end)
    scene:probe("hinges", function() return #scene.hinges end)
  ]]
  scene:advance(0.51)
  expect(scene:read "hinges"):equal(0)
  scene:advance(2)
  expect(scene:read "hinges"):equal(5)
  expect(scene.error.hinge_gap):below(1e-9)
end)

test("bonding: hinges of two families part and come together as what they were", function()
  local scene = open_text [[
    scene.gravity = vec(0, 0, 0)
    local plug, socket, other = scene:family "plug", scene:family "socket", scene:family "other"
    local function end_of(family, x) return { at = vec(x, 0, 0), mass = 1, family = family } end
    local function rod(x, left, right)
      return scene:body { at = vec(x, 0, 0), points = { left = end_of(left, -0.5), right = end_of(right, 0.5) } }
    end
    local a, b, c = rod(0, other, plug), rod(1, socket, other), rod(2, other, other)
    scene:hinge(a.right, b.left)
    local own = scene:hinge(b.right, c.left)
    local all, hot = scene:group "all", true
    all:add(a, b, c)
    scene:bonding { families = { plug, socket }, near = 0.3, below = 0.01, above = 0.02, hinge = true }
    scene:at(0.1, all, function(g) g:heat(20) end)
    scene:at(0.12, all, function(g) g:heat(-0.99999 * 0.5 * 9 * g.temperature) end)
    scene:at(0.11, function()
      scene:result("hot", #scene.hinges)
      assert(own.alive and a.right.particle.family == plug and b.left.particle.family == socket)
    end)
  ]]
  scene:advance(2)
  expect(scene:result "hot"):equal(1)
  expect(#scene.hinges):equal(2)
end)

test("bonding: ties implicitly where asked, and says what it cannot do", function()
  local gas = "local gas = scene:family 'gas'\n"
  local function fails(rest, message)
    expect(function() open_text(gas .. "scene:bonding { families = gas, near = 1, below = 1, above = 2, " .. rest .. "}") end)
      :fails(message)
  end
  fails("", "text.lua:2: bonding: what is near and cold is tied by law = … or joined by hinge = true; give one")
  fails("hinge = true, law = force.spring { stiffness = 1 }", "give one")
  fails("hinge = true, implicit = true", "implicit is for the connections of a law")
  fails("hinge = true, time_constant = 0", "bonding: time_constant must be > 0 s")
  fails("law = force.spring { stiffness = 1 }, time_constant = 1", "time_constant is for hinge = true")
  local scene = open_text(gas .. [[
    scene.gravity, scene.step = vec(0, 0, 0), 0.1
    scene:particle { family = gas } scene:particle { family = gas, at = vec(1, 0, 0) }
    scene:bonding { families = gas, near = 2, below = 1, above = 2, implicit = true,
                    law = force.spring { stiffness = 1e6, length = 1.01 } }
  ]])
  scene:advance(5)
  expect(scene.energy.total):below(100)
end)

test("play: waits by wait alone", function()
  local scene = open_text "scene:play(function(wait) coroutine.yield() end)"
  expect(function() scene:advance(0.1) end):fails("text.lua:1: play: it waits by wait(…), not by coroutine.yield")
end)

test("when: what is gone has no energy to be below", function()
  local scene = open_text [[
    local pair, fired = scene:group "pair", 0
    local a, b = scene:particle(), scene:particle { at = vec(1, 0, 0) }
    pair:add(a, b)
    scene:when({ energy_below = -1e9, of = pair }, function() fired = 1 end)
    scene:at(0.1, function() a:remove() end)
    scene:probe("fired", function() return fired end)
  ]]
  scene:advance(0.3)
  expect(scene:read "fired"):equal(0)
end)

test("an event runs at the beginning of the first step whose time is not before it, whatever sets it", function()
  for _, step in ipairs { "1/240", "1/60", "0.1", "1e-3", "0.07" } do
    local scene = open_text("scene.step = " .. step .. [[

      local worst_early, worst_late, count = 0, 0, 0
      local function due(t)
        worst_early, worst_late = math.max(worst_early, t - scene.time), math.max(worst_late, scene.time - t - scene.step)
        count = count + 1
      end
      for _, t in ipairs { 0, 0.1, 0.3, 0.35, 1 / 3, 0.7, 1, 1.1 } do scene:at(t, function() due(t) end) end
      scene:at(0.35, function()
        local now = scene.time
        scene:after(0.3, function() due(now + 0.3) end)
      end)
      local k = 0
      scene:every(0.1, function() k = k + 1 due(0.1 * k) end)
      local time = 0
      scene:play(function(wait) for _ = 1, 6 do wait(0.2) time = time + 0.2 due(time) end end)
      scene:probe("early", function() return worst_early end)
      scene:probe("late", function() return worst_late end)
      scene:probe("count", function() return count end)
    ]])
    scene:advance(1.4)
    expect(scene:read "early"):below(1e-15)
    expect(scene:read "late"):below(1e-15)
    expect(scene:read "count"):equal(8 + 1 + 13 + 6)
  end
end)

test("what is due on a step's boundary acts from exactly then, and not in a run that ends there", function()
  local scene = open_text [[
    scene.step, scene.gravity = 0.125, vec(0, 0, 0)
    local function ball(z) return scene:particle { at = vec(0, 0, z) } end
    local function rod(z) return scene:body { at = vec(0, 0, z), points = { { at = vec(0, 0, 0), mass = 1 }, { at = vec(0, 1, 0), mass = 1 } } } end
    local kicked, pushed, a, b = ball(0), ball(1), rod(2), rod(2)
    local hinge = scene:hinge(a.points[1], b.points[1])
    scene:at(0.5, kicked, function(b) b:kick(vec(1, 0, 0)) end)
    scene:at(0.5, pushed, function(b) b:push(vec(8, 0, 0)) end)
    scene:at(0.5, hinge, function(h) h:cut() end)
    scene:probe("kicked", function() return kicked.position.x end)
    scene:probe("pushed", function() return pushed.position.x end)
    scene:probe("hinges", function() return #scene.hinges end)
  ]]
  scene:advance(0.5)
  expect(scene.time):equal(0.5)
  expect(scene:read "hinges"):equal(1)
  scene:advance(0.5)
  expect(scene:read "kicked"):equal(0.5)
  expect(scene:read "pushed"):equal(0.5 * 8 * 0.125 ^ 2 + 0.375)
  expect(scene:read "hinges"):equal(0)
end)

test("an over is told at the beginning of each step what part of it has passed, from 0 to 1", function()
  local scene = open_text [[
    scene.step = 0.125
    local list = ""
    scene:over(0.25, 0.75, function(u) list = list .. scene.time .. ": " .. u .. " " scene:result("list", list) end)
    scene:over(0.9, 0.95, function(u) list = list .. scene.time .. ": " .. u scene:result("list", list) end)
  ]]
  scene:advance(2)
  expect(scene:result "list"):equal("0.25: 0.0 0.375: 0.25 0.5: 0.5 0.625: 0.75 0.75: 1.0 1.0: 1.0")
end)

test("a lifetime ends at the beginning of the first step by which it is over, and ages stay within it until then", function()
  local scene = open_text [[
    scene.step, scene.gravity = 0.125, vec(0, 0, 0)
    local body = { points = { { at = vec(0, 0, 0), mass = 1 }, { at = vec(1, 0, 0), mass = 1 } } }
    local a, b = scene:body(body), scene:body(body)
    local hinge = scene:hinge(a.points[1], b.points[1], { lifetime = 0.3 })
    local whole, half = scene:particle { lifetime = 0.5 }, scene:particle { lifetime = 0.3, radius = function(age, life) return 1 - age / life end }
    local ended = ""
    local function tell(thing) ended = ended .. (thing == whole and "whole " or thing == half and "half " or "hinge ") scene:result("ended", ended) end
    scene:on("removed", tell) scene:on("cut", tell)
    scene:probe("radius", function() return half.alive and half.radius or 0 end)
    scene:probe("living", function() return (whole.alive and 1 or 0) + (half.alive and 10 or 0) + #scene.hinges * 100 end)
  ]]
  local living = {}
  for _ = 1, 5 do
    scene:step()
    living[#living + 1] = scene:read "living"
    expect(scene:read "radius"):above(-1e-9)
  end
  for i, wanted in ipairs { 111, 111, 111, 1, 0 } do expect(living[i]):equal(wanted) end
end)

test("crane: it plays by itself, until somebody does", function()
  local crane = open "scenes/crane.lua"
  crane:advance(20)
  expect(crane:read "aboard"):equal(1)
  crane:hold "f"
  crane:advance(3)
  crane:release "f"
  local rests = crane:find("magnet").position.y
  crane:advance(20)
  expect(crane:find("magnet").position.y):near(rests, 0.5)
  expect(crane:read "aboard"):equal(1)
end)

test("what an emitter on a turning body throws off leaves where and as fast as the body is at its birth", function()
  for _, hertz in ipairs { 60, 240 } do
    local scene = open_text(([[
      scene.gravity, scene.step = vec(0, 0, 0), 1 / %d
      local wheel = scene:box { size = 1, velocity = vec(3, 0, 0), spin = vec(0, 0, 10), points = { rim = vec(1, 0, 0) } }
      scene:emitter { at = wheel.rim, rate = 47 }
    ]]):format(hertz))
    scene:advance(1)
    local seen = 0
    for _, p in ipairs(scene.particles) do
      if not p.points[1].body then
        local born = scene.time - p.age
        local angle = 10 * born
        local out, along = vec(math.cos(angle), math.sin(angle), 0), vec(-math.sin(angle), math.cos(angle), 0)
        expect(p.velocity):near(vec(3, 0, 0) + 10 * along, 2e-2)
        expect(p.position - p.velocity * p.age):near(vec(3 * born, 0, 0) + out, 2e-2)
        seen = seen + 1
      end
    end
    expect(seen):above(40)
  end
end)

test("the name and the data of what broke or was removed can be read while that is told", function()
  local scene = open_text [[
    local p, q = scene:particle { name = "p" }, scene:particle { name = "q", at = vec(1, 0, 0) }
    local tie = scene:connect(p, q, force.spring { stiffness = 1, length = 1 }, { name = "tie", breaks_at = { length = 1.1 } })
    local ring = scene:hinge(p, scene:body { mass = 1, inertia = vec(1, 1, 1), points = { vec(0, 0, 0) } }.points[1], { name = "ring" })
    tie.data.worth, q.data.worth, ring.data.worth = 3, 4, 5
    local told = ""
    local function tell(thing)
      scene:snapshot()
      told = told .. thing.name .. thing.data.worth .. " "
      scene:result("told", told)
      assert(not thing.alive)
    end
    scene:on("broke", tell) scene:on("removed", tell) scene:on("cut", tell)
    scene:at(0.05, function() q.velocity = vec(9, 0, 0) end)
    scene:at(0.2, function() q:remove() ring:cut() end)
    scene:at(0.3, function() assert(q.name == "q" and tie.name == "tie") print(q.data) end)
  ]]
  scene:advance(0.25)
  expect(scene:result "told"):equal "tie3 q4 ring5 "
  scene:advance(0.1)
  expect(scene.log[#scene.log].text:find("particle 'q' was removed at 0.2", 1, true) ~= nil):is_true()
end)

test("an error of a function of Pantin that is called back has the line where it was given", function()
  for _, given in ipairs { 'scene:on("step", scene.finish)', "scene:at(0, scene.save)", "scene:after(0.01, p, p.push)",
                           'scene:probe("x", scene.find)', "scene:every(0.01, scene.near)" } do
    local scene = open_text("local p = scene:particle {}\n" .. given)
    local good, why = pcall(function() scene:advance(0.1) end)
    expect(good):equal(false)
    expect(why:sub(1, 12)):equal("text.lua:2: ")
  end
end)
