local two = [[
  scene.gravity = vec(0, 0, 0)
  local function rod(name, x, v)
    return scene:body { name = name, at = vec(x, 0, 0), velocity = vec(v, 0, 0),
      points = { tip = { at = vec(0.5, 0, 0), mass = 1 }, tail = { at = vec(-0.5, 0, 0), mass = 1 } } }
  end
  local a, b = rod("a", -2, 1), rod("b", 2, -1)
]]

test("merge: one body of two, and the lost energy is a line of the ledger", function()
  local scene = open_text(two .. [[
    local tip = b.tip
    scene:at(1, function()
      assert(scene:merge(a, b) == a and not b.alive and tip.alive and tip.body == a)
      scene:result("lost", scene.ledger.merge)
    end)
  ]])
  scene:advance(1.1)
  expect(#scene.bodies):equal(1)
  expect(scene:find("a").mass):near(4, 1e-12)
  expect(scene:result "lost"):near(-2, 1e-12)
  expect(scene.energy.kinetic):near(0, 1e-12)
end)

test("split: the part moves on as it did", function()
  local scene = open_text [[
    scene.gravity = vec(0, 0, 0)
    local bar = scene:body { name = "bar", spin = vec(0, 0, 2), points = {
      left = { at = vec(-1, 0, 0), mass = 1 }, middle = { at = vec(0, 0, 0), mass = 1 }, right = { at = vec(1, 0, 0), mass = 1 } } }
    scene:at(0.5, function()
      local off = scene:split(bar, { bar.right })
      off.name = "off"
    end)
  ]]
  local before = scene.angular_momentum.z
  scene:advance(1)
  expect(scene:find("off").velocity:length()):near(2, 1e-9)
  expect(scene:find("bar").velocity:length()):near(1, 1e-9)
  expect(scene.angular_momentum.z):near(before, 1e-12)
end)

test("freeze, shatter and connect_within", function()
  local scene = open_text [[
    scene.gravity = vec(0, 0, 0)
    local block = scene:group "block"
    for x = 0, 1 do for y = 0, 1 do for z = 0, 1 do
      block:add(scene:particle { at = vec(x, y, z), velocity = vec(y, z, x) })
    end end end
    scene:result("ties", #scene:connect_within(block, 1.1, force.spring { stiffness = 1 }))
    block:break_connections()
    scene:result("left", #scene.connections)
    local body = scene:freeze(block)
    scene:result("points", #body.points)
    scene:at(0.5, function() scene:result("pieces", #scene:shatter(body)) end)
  ]]
  local momentum, spin = scene.momentum, scene.angular_momentum
  scene:advance(1)
  expect(scene:result "ties"):equal(12)
  expect(scene:result "left"):equal(0)
  expect(scene:result "points"):equal(8)
  expect(scene:result "pieces"):equal(8)
  expect(scene.momentum):near(momentum, 1e-12)
  expect(scene.angular_momentum):near(spin, 1e-12)
end)

test("join: tells when the points met", function()
  local scene = open_text(two .. [[
    local told = ""
    scene:on("joined", function(hinge) told = told .. hinge.name .. " joined " end)
    scene:join(a.tip, b.tail, { name = "knee", on_met = function(hinge)
      told = told .. hinge.name .. " met "
      assert(hinge.is_hinge and #hinge.bodies == 2)
    end })
    scene:probe("told", function() scene:result("told", told) return 0 end)
  ]])
  scene:advance(4)
  expect(scene:result "told"):equal "knee met knee joined "
end)

test("wrong merges, splits and joins are told with their line, and leave the scene as it was", function()
  for code, message in pairs {
    ["scene:merge(a, a)"] = "merge: both are body 'a'; it needs two bodies",
    ["scene:merge(a, 3)"] = "merge: argument 2 must be a body, got a number",
    ["scene:split(a, {})"] = "split: no points were given",
    ["scene:split(a, { a.tip, a.tail })"] = "split: these are all points of body 'a'",
    ["scene:split(a, { b.tip })"] = "is not of body 'a'",
    ["scene:join(a.tip, a.tail)"] = "join: both points belong to body 'a'",
    ["scene:join(a.tip, b.tip, { at = 3 })"] = "join: at must be a vec [m], got a number",
    ["b:remove() scene:merge(a, b)"] = "body 'b' was removed at 0 s by text.lua:8",
    ["scene:bonding { families = 3 }"] = "bonding: families must be a family, got a number",
    ["scene:group('g'):heat(1)"] = "heat: there is nothing to heat",
  } do
    expect(function() open_text(two .. "\n" .. code) end):fails(message)
  end
end)

test("connect_within: where one tie fails, none is made", function()
  local scene = open_text [[
    local group, ion = scene:group "g", scene:family("ion", { attributes = { charge = 1 } })
    for i = 1, 4 do group:add(scene:particle { at = vec(i, 0, 0), family = ion }) end
    group:add(scene:particle { at = vec(5, 0, 0) })
    local law = force.pair { potential = function(r, a, b) return a.charge * b.charge * r end }
    local well, message = pcall(function() scene:connect_within(group, 1.1, law) end)
    scene:result("message", message)
    scene:result("ties", #scene.connections)
  ]]
  expect(scene:result "message" :find("has no attribute 'charge'", 1, true) ~= nil):is_true()
  expect(scene:result "ties"):equal(0)
end)

test("freeze: bodies and particles become one", function()
  local scene = open_text(two .. [[
    local wreck = scene:group "wreck"
    wreck:add(a, b, scene:particle { at = vec(0, 1, 0) })
    scene:result("points", #scene:freeze(wreck).points)
    scene:result("bodies", #scene.bodies)
  ]])
  expect(scene:result "points"):equal(5)
  expect(scene:result "bodies"):equal(1)
end)

local swinging = [[
  scene.gravity = vec(0, 0, 0)
  local car = scene:group "car"
  local body = scene:box { name = "body", size = vec(2, 0.4, 1), at = vec(0, 1, 0), velocity = vec(1, 0, 0), spin = vec(0, 0.5, 0), points = { vec(-0.8, -0.3, 0), vec(0.8, -0.3, 0) } }
  car:add(body)
  for i = 1, 2 do
    local wheel = scene:box { size = vec(0.3, 0.3, 0.1), at = body.points[i].position, spin = vec(0, 0, -3), points = { vec(0, 0, 0) } }
    scene:hinge(body.points[i], wheel.points[1], { axis = vec(0, 0, 1) })
    car:add(wheel)
  end
  local bob = scene:particle { name = "bob", at = vec(0, -0.5, 0), mass = 0.5 }
  scene:rod(body.points[1], bob)
  car:add(bob)
]]

test("a group that is moved and turned as one goes on as it would have, hinges and all", function()
  local here, there = open_text(swinging), open_text(swinging .. [[
    scene:at(0.5, function() scene:find "car":move(vec(5, 2, -1), quat(vec(0, 0, 1), 1)) end)
  ]])
  here:advance(1)
  there:advance(1)
  local turn, shift = quat(vec(0, 0, 1), 1), nil
  for i, body in ipairs(here.bodies) do
    local other = there.bodies[i]
    shift = shift or other.position - turn:rotate(body.position)
    expect((other.position - turn:rotate(body.position) - shift):length()):below(1e-9)
    expect((other.velocity - turn:rotate(body.velocity)):length()):below(1e-9)
    expect((other.spin - turn:rotate(body.spin)):length()):below(1e-9)
  end
  expect((there:find("bob").position - turn:rotate(here:find("bob").position) - shift):length()):below(1e-9)
  expect(there.stats.fallback_steps):equal(0)
  expect(there.energy.total):near(here.energy.total, 1e-9)
end)

test("what is no way, no turn or no group of things is not moved", function()
  for code, message in pairs {
    ["car:move(vec(0/0, 0, 0))"] = "must be a finite vec",
    ["car:move(3)"] = "vec",
    ["car:move(vec(1, 0, 0), 3)"] = "quat",
    ["scene:group('none'):move(vec(1, 0, 0))"] = "move: there is nothing to move",
    ["car:move(vec(1.7e308, 0, 0)) car:move(vec(1.7e308, 0, 0))"] = "a position",
  } do
    expect(function() open_text(swinging .. code) end):fails(message)
  end
end)
