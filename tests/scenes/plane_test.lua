--- What leaves the plane across z after each step, over some seconds: 0 exactly where nothing does.
local function strays(scene, seconds)
  local most, _ = 0, scene.ledger   -- which is kept from now on
  for _ = 1, math.floor(seconds * 20) do
    scene:advance(0.05)
    most = math.max(most, scene:read "strayed")
  end
  return most
end

local watched = [[
  local heights, known = {}, {}
  local function see(point, name)
    local z = point.position.z
    heights[#heights + 1] = { point, z }
  end
  function watch(...)
    for _, point in ipairs { ... } do see(point) end
  end
  scene:probe("strayed", function()
    local most = 0
    for _, seen in ipairs(heights) do
      if seen[1].alive then most = math.max(most, math.abs(seen[1].position.z - seen[2]), math.abs(seen[1].velocity.z)) end
    end
    return most
  end)
]]

local linkage = [[
  scene.plane = "xy"
  local function rod(at, options)
    options.at, options.mass, options.inertia = at, 1, vec(0.01, 0.1, 0.1)
    options.points = { head = vec(-0.5, 0, 0), tail = vec(0.5, 0, 0) }
    return scene:body(options)
  end
  local a = rod(vec(0.5, 0, 0.25), { name = "a" })
  local b = rod(vec(1, -0.5, 0.25), { orientation = quat(vec(0, 0, 1), -math.pi / 2), name = "b" })
  local c = rod(vec(0.5, -1, 0.25), { orientation = quat(vec(0, 0, 1), math.pi) * quat(vec(1, 0, 0), 0.7), name = "c" })
  scene:nail(a.head)
  scene:nail(c.tail, vec(0, -1, 0.25))
  scene:hinge(a.tail, b.head)
  scene:hinge(b.tail, c.head)
  watch(a.tail, b.tail, c.tail, a, b, c)
]]

test("a linkage stays in its plane to the bit, whatever pulls at it", function()
  for _, integrator in ipairs { "verlet", "implicit", "euler" } do
    local scene = open_text(watched .. linkage .. string.format([[
      scene.integrator = %q
      local stone = scene:particle { at = vec(2, 0, 1), velocity = vec(1, 2, 0) }
      local other = scene:particle { at = vec(2, 1, 0.5) }
      watch(stone, other)
      scene:connect(stone, other, force.spring { stiffness = 20 })
      scene:connect(b.tail, vec(1, -2, 3), force.spring { stiffness = 5 })
      scene:field(scene, force.point { force = function(p, own, t) return vec(1, math.sin(3 * t), 5) end })
      scene:motor(a, { speed = 2, max_torque = 3 })
      scene:every(0.1, function() stone:push(vec(1, 0, 7)) c:twist(vec(3, 2, 0.1)) end)
      local hand = scene:hand { path = function(t) return vec(1.2, -0.5 + 0.3 * math.sin(5 * t), t) end }
      scene:at(0.5, function() hand:grab(b.tail, { max_force = 30 }) end)
      scene:at(1.5, function() hand:release() end)
    ]], integrator))
    expect(strays(scene, 2)):equal(0)
    expect(scene.ledger.closure):below(1e-10)
    expect(scene.error.hinge_gap):below(1e-8)
  end
end)

test("loose things stay in it with rk4 and suzuki4, and bodies turn about its normal", function()
  for _, integrator in ipairs { "rk4", "suzuki4", "verlet" } do
    local scene = open_text(watched .. string.format([[
      scene.plane, scene.integrator = "xy", %q
      local top = scene:body { at = vec(0, 0, 2), orientation = quat(vec(1, 2, 0), 1), mass = 1, inertia = vec(1, 2, 3) * 0.1,
                               points = { arm = vec(1, 0.3, 0.2) }, spin = vec(0, 0, 3), name = "top" }
      local p = scene:particle { at = vec(1, 2, 0), velocity = vec(0, 1, 0) }
      watch(top, top.arm, p)
      scene:connect(top.arm, p, force.spring { stiffness = 3 })
    ]], integrator))
    expect(strays(scene, 2)):equal(0)
    local top = scene:find "top"
    expect(top.spin.x):equal(0)
    expect(top.spin.y):equal(0)
    expect(scene.error.worst_energy):below(1e-3)
    expect(scene.ledger.closure):below(1e-10)
  end
end)

test("a body turns freely at its rate", function()
  local scene = open_text [[
    scene.plane, scene.gravity = "xz", vec(0, 0, 0)
    scene:body { mass = 2, inertia = vec(1, 2, 3), orientation = quat(vec(1, 0, 0), 0.4), spin = vec(0, 1.5, 0), name = "body" }
  ]]
  scene:advance(2)
  local body = scene:find "body"
  local right = body.orientation:rotate(vec(1, 0, 0))
  expect(right.x):near(math.cos(3), 1e-4)
  expect(right.z):near(-math.sin(3), 1e-4)
  expect(body.spin.y):near(1.5, 1e-12)
end)

test("bodies are merged, split, frozen and shattered, and emitters spray, in the plane", function()
  local scene = open_text(watched .. [[
    scene.plane = "xy"
    local a = scene:body { mass = 1, inertia = vec(1, 1, 1), points = { { at = vec(1, 0, 1), mass = 1 }, { at = vec(-1, 0, 0), mass = 2 } },
                           spin = vec(0, 0, 2), velocity = vec(1, 0, 0) }
    local b = scene:body { at = vec(0, 3, 2), mass = 1, inertia = vec(1, 1, 1), points = { p = vec(1, 0, 0) }, spin = vec(0, 0, -1) }
    watch(a.points[1], a.points[2], b.p)
    local bits = scene:group "bits"
    for i = 1, 4 do
      local bit = scene:particle { at = vec(i, i * i, 0.5 * i), velocity = vec(i, -i, 0) }
      bits:add(bit)
      watch(bit)
    end
    scene:emitter { at = vec(0, 0, 1), rate = 50, velocity = vec(3, 4, 0), spread = 0.5, family = scene:family("spray", {}) }
    scene:field(scene, force.thermostat { temperature = 3, rate = 1 })
    scene:at(0.2, function() scene:merge(a, b) end)
    scene:at(0.4, function() scene:split(a, { a.points[1], a.points[2] }) end)
    local frozen
    scene:at(0.3, function() frozen = scene:freeze(bits) end)
    scene:at(0.6, function() scene:shatter(frozen) end)
    scene:at(0.7, function() scene:group("all"):add(bits) end)
    scene:probe("sprayed", function()
      local most = 0
      for _, p in ipairs(scene.particles) do
        if p.family then most = math.max(most, math.abs(p.position.z - 1), math.abs(p.velocity.z)) end
      end
      return most
    end)
  ]])
  expect(strays(scene, 1)):below(1e-12)
  expect(scene:read "sprayed"):equal(0)
  expect(scene.ledger.closure):below(1e-10)
end)

test("what leaves the plane is an error at its line", function()
  local body = 'scene.plane = "xy"\nlocal body = scene:body { mass = 1, inertia = vec(1, 1, 1), points = { p = vec(1, 0, 0) } }\n'
    .. 'local other = scene:body { at = vec(2, 0, 1), mass = 1, inertia = vec(1, 1, 1), points = { p = vec(-1, 0, 0), q = vec(-1, 0, -1) } }\n'
    .. 'local ball = scene:particle { at = vec(0, 1, 0) }\n'
  local wrong = {
    ['ball.velocity = vec(1, 0, 0.1)'] = 'velocity must have no z',
    ['ball.position = vec(0, 0, 1)'] = 'position must stay at z = 0 m, got 1 m',
    ['body.position = vec(0, 0, 1)'] = 'position must stay at z',
    ['body.origin = vec(0, 0, 1)'] = 'origin must stay at z',
    ['body.velocity = vec(0, 0, 1)'] = 'velocity must have no z',
    ['body.spin = vec(1, 0, 1)'] = 'spin must be along z',
    ['body.orientation = quat(vec(1, 0, 0), 1)'] = 'can be turned about z only',
    ['ball:kick(vec(0, 0, 1))'] = 'impulse must have no z',
    ['body:kick(vec(0, 0, 1))'] = 'impulse must have no z',
    ['scene:particle { velocity = vec(0, 0, 1) }'] = 'velocity must have no z',
    ['scene:body { mass = 1, spin = vec(1, 0, 0) }'] = 'spin must be along z',
    ['scene:body { mass = 1, velocity = vec(0, 0, 1) }'] = 'velocity must have no z',
    ['scene:emitter { rate = 1, velocity = vec(0, 0, 1) }'] = 'velocity must have no z',
    ['scene:hinge(body.p, other.p)'] = 'apart',
    ['scene:hinge(body.p, other.q, { axis = vec(1, 0, 0) })'] = 'hinge: scene.plane is "xy", so axis must be along z',
    ['scene:join(body.p, other.p)'] = 'join: scene.plane is "xy", so what it ties must stay at z = 0 m, got 1 m',
    ['scene:rod(body.p, other.p)'] = 'rod: scene.plane is "xy", so what it ties must stay at z',
    ['scene:string({ body.p, other.p })'] = 'string: scene.plane',
    ['scene:limit(body.p, other.p, { max = 2 })'] = 'limit: scene.plane',
    ['scene:nail(ball, vec(0, 0, 1))'] = 'nail: scene.plane',
    ['scene:nail(ball).at = vec(0, 0, 1)'] = 'position must stay at z',
    ['scene:follow(ball, vec(0, 0, 1))'] = 'follow: scene.plane',
    ['scene:on_path(ball, { vec(0, 0, 1), vec(1, 0, 1) })'] = 'on_path: scene.plane',
    ['scene:on_plane(ball, { normal = vec(0, 1, 1) })'] = 'normal must have no z',
    ['scene:motor(body, { axis = vec(1, 0, 0), speed = 1 })'] = 'axis must be along z',
    ['scene:limit(body, { axis = vec(1, 0, 0), max = 1 })'] = 'axis must be along z',
    ['scene:align(body, vec(0, 0, 1), vec(1, 0, 0))'] = 'the first axis must have no z',
    ['scene:orient(body, quat(vec(1, 0, 0), 1))'] = 'can be turned about z only',
    ['scene:connect(ball, other.p, force.spring { stiffness = 1 }, { implicit = true })'] = 'implicit = true needs ends at one height',
    ['scene.plane = "xz"'] = 'it is "xy" already',
    ['scene.plane = nil'] = 'it is "xy" already',
  }
  for code, text in pairs(wrong) do
    expect(function() open_text(body .. code) end):fails(text)
    expect(function() open_text(body .. code) end):fails(":5:")
  end
  expect(function() open_text 'scene.plane = "zx"' end):fails 'plane must be "xy", "xz" or "yz", got "zx"'
end)

test("a plane is refused where things do not fit, and they are as before", function()
  local scene = open_text [[
    local top = scene:body { mass = 1, inertia = vec(1, 2, 3), spin = vec(0, 1, 0) }
    local said = {}
    local function try(name) local ok, message = pcall(function() scene.plane = name end) said[#said + 1] = message end
    try "xy"
    top.spin = vec(0, 0, 0)
    local axle = scene:body { mass = 1, inertia = vec(1, 1, 1), points = { p = vec(0, 0, 0) } }
    scene:motor(axle, { axis = vec(0, 1, 0), speed = 1 })
    try "xy"
    scene:result("first", said[1])
    scene:result("second", said[2])
    scene:result("none", tostring(scene.plane))
    scene.plane = "xz"
    scene:result("plane", scene.plane)
    scene:result("gravity", scene.gravity.y)
  ]]
  local function result(name) return scene:result(name) end
  expect(result("first"):find("the spin of body 1 must be along z", 1, true) ~= nil):is_true()
  expect(result("second"):find("motor: scene.plane is \"xy\", so axis must be along z", 1, true) ~= nil):is_true()
  expect(result "none"):equal("nil")
  expect(result "plane"):equal("xz")
  expect(result "gravity"):equal(0)
end)

test("temperature counts what a plane leaves free", function()
  local scene = open_text [[
    scene.plane, scene.gravity = "xy", vec(0, 0, 0)
    scene:particle { velocity = vec(2, 0, 0) }
    scene:particle { at = vec(1, 0, 0), velocity = vec(-2, 0, 0) }
    scene:probe("temperature", function() return scene.temperature end)
  ]]
  scene:advance(0.01)
  expect(scene:read "temperature"):near(2 * 4 / 2, 1e-12)   -- 4 J, two particles of 2 less 2 of the common motion
end)
