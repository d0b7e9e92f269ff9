-- Writes a random scene: the text is its result "source", one statement a line, so that lines can be dropped one by one.
-- Each statement is tried by itself; what the engine refuses with an error is passed over.
-- What events make gets a new name, so that a scene that goes back in time finds what it had then.

scene.seed = scene:param("seed", 1)

local lines = {}
local made = 0
local plane = math.random() < 0.15
local names = { body = {}, point = {}, particle = {}, tie = {}, element = {}, family = {}, group = {}, emitter = {}, shape = {} }

local function chance(part) return math.random() < part end
local function pick(list) return list[math.random(#list)] end
local function number(low, high) return string.format("%.4g", low + (high - low) * math.random()) end
local function vector(size)
  local x, y, z = number(-size, size), number(-size, size), number(-size, size)
  return string.format("vec(%s, %s, %s)", x, y, plane and "0" or z)
end
local function axis() return plane and "vec(0, 0, 1)" or pick { "vec(0, 0, 1)", "vec(0, 1, 0)", "vec(1, 0, 0)", vector(1) } end
local function spin(size) return plane and "vec(0, 0, " .. number(-size, size) .. ")" or vector(size) end
local function some(kind) return #names[kind] > 0 and pick(names[kind]) or "t.nothing" end
local function new(kind)
  made = made + 1
  local name = "t." .. kind .. made
  table.insert(names[kind], name)
  return name
end
local function say(...) lines[#lines + 1] = "try(function() " .. string.format(...) .. " end)" end

local function any_point() return chance(0.8) and some "point" or some "particle" end
local function any_end() return chance(0.8) and any_point() or vector(3) end
local function any_thing()
  return some(pick { "body", "body", "point", "particle", "tie", "element", "family", "group", "emitter", "shape" })
end

-- Functions that are traced, and ones that cannot be.
local function of_time(size)
  return pick {
    string.format("function(time) return %s + %s * math.sin(%s * time) end", number(-size, size), number(-size, size), number(0.5, 9)),
    string.format("function(time) return time < %s and %s or %s end", number(0, 0.4), number(-size, size), number(-size, size)),
    string.format("function(time) return tonumber(string.format('%%.9g', %s * time)) end", number(-size, size)),
    number(-size, size),
  }
end
local function path(from)
  local way = pick {
    string.format("%s * math.sin(%s * time)", vector(1), number(0.5, 9)),
    string.format("%s * time", vector(2)),
    string.format("%s * (time < %s and 0 or 1)", vector(1), number(0, 0.4)),
  }
  if chance(0.2) then return vector(3) end
  return string.format("(function(from) return function(time) return from + %s end end)(%s)", way, from)
end

local function common_options()
  local text = ""
  if chance(0.3) then text = text .. ", cutoff = " .. number(0.5, 4) end
  if chance(0.1) then text = text .. ", one_sided = true" end
  if chance(0.1) then text = text .. ", exclude = " .. math.random(3) end
  if chance(0.15) then text = text .. ", shift = false" end
  if chance(0.2) then text = text .. ", implicit = " .. pick { "true", "'dissipative'" } end
  return text
end
local function own_pair_law()
  local body = pick {
    "potential = function(r) return " .. number(0, 20) .. " * (r - 1) ^ 2 end",
    "potential = function(r, a, b) return a.mass * b.mass / (r + 0.1) end",
    "potential = function(r, a, b, own) return own.k * (r - 1) ^ 4 end, parameters = { k = " .. number(0, 5) .. " }",
    "potential = function(r, a, b, own, time) return math.cos(time) * r ^ 2 end",
    "potential = function(r) if r < 1 then return (1 - r) ^ 2 else return 0 end end",
    "potential = function(r) return tonumber(string.format('%.12g', 3 * (r - 1) ^ 2)) end",
    "tension = function(r, rate) return " .. number(0, 9) .. " * (r - 1) + " .. number(0, 2) .. " * rate end",
    "tension = function(r) return tonumber(string.format('%.9g', 5 * (r - 1))) end",
    "tension = function(r) return math.max(0, math.min(3, r - 1)) end",
    "force = function(d, u) return " .. number(0, 9) .. " * d + " .. number(0, 2) .. " * u end",
    "force = function(d, u) return " .. axis() .. ":cross(u) end",
    "force = function(d, u) local x = tonumber(string.format('%.9g', d.x)) return vec(x, 0, 0) end",
  }
  return "force.pair { " .. body .. common_options() .. " }"
end
local function pair_law()
  if chance(0.5) then return own_pair_law() end
  local body = pick {
    "spring { stiffness = " .. pick { number(1, 50), number(1e3, 1e6) } .. ", length = " .. number(0.2, 2) .. ", damping = " .. number(0, 5),
    "spring { stiffness = " .. number(1, 200),
    "damper { damping = " .. number(0, 20),
    "gravitation { constant = " .. number(0.1, 5) .. ", softening = " .. number(0.05, 0.5),
    "morse { depth = 5, steepness = 2, length = " .. number(0.5, 2),
    "yukawa { strength = 2, screening = 0.5",
    "wca { epsilon = 1, sigma = " .. number(0.1, 0.6),
    "lennard_jones { epsilon = 1, sigma = " .. number(0.1, 0.4),
    "hydrophobic { strength = 1, size = 0.3",
    "repel { stiffness = 1000",
    "flock { sight = 2, separation = 0.1, alignment = 1, cohesion = 0.5",
    "table { distances = { 0.5, 1, 2 }, tensions = { -5, 0, 3 }",
  }
  return "force." .. body .. common_options() .. " }"
end
local function point_law()
  return "force." .. pick {
    "drag { linear = " .. number(0, 2) .. ", quadratic = " .. number(0, 1) .. " }",
    "wind { velocity = " .. vector(5) .. ", linear = 0.3, quadratic = 0.1 }",
    "vortex { axis = " .. axis() .. ", circulation = 5, core = 0.5, linear = 0.2 }",
    "buoyancy { density = 1000, surface = 0.5 }",
    "thermostat { rate = 2, temperature = " .. number(0, 3) .. " }",
    "wall { normal = vec(0, 1, 0), through = vec(0, -2, 0), stiffness = 1e3, damping = 5, friction = 0.3 }",
    "point { potential = function(p) return " .. number(0, 5) .. " * p.position:dot(p.position) end }",
    "point { force = function(p, own, time) return " .. axis() .. " * math.sin(5 * time) end }",
    "point { force = function(p) return " .. axis() .. ":cross(p.velocity) * p.mass end }",
    "point { force = function(p) return p.velocity * tonumber(string.format('%.9g', -0.1 * p.mass)) end }",
    "point { force = function(p) local y = tonumber(string.format('%.9g', p.position.y)) return vec(0, -y, 0) end }",
  }
end

local function material()
  local text = ""
  if chance(0.4) then text = text .. ", friction = " .. number(0, 1.5) end
  if chance(0.3) then text = text .. ", restitution = " .. number(0, 1) end
  if chance(0.1) then text = text .. ", rolling = 0.02, spinning = 0.01" end
  if chance(0.05) then text = text .. ", sensor = true" end
  if chance(0.15) then text = text .. ", layer = '" .. pick { "one", "two" } .. "'" end
  return text
end
local function motion()
  local text = ""
  if chance(0.5) then text = text .. ", velocity = " .. vector(4) end
  if chance(0.4) then text = text .. ", spin = " .. spin(6) end
  if chance(0.3) then text = text .. ", orientation = quat(" .. axis() .. ", " .. number(-3, 3) .. ")" end
  if chance(0.2) then text = text .. ", mass = " .. pick { number(0.1, 5), "1000", "0.001" } end
  return text
end
local function any_shape()
  return pick {
    "shape.ball(" .. number(0.1, 0.5), "shape.box(" .. number(0.1, 1) .. ", 0.4, 0.6", "shape.capsule(0.2, " .. number(0.1, 1),
    "shape.cylinder(0.3, " .. number(0.1, 1),
    "shape.hull({ vec(0, 0.5, 0), vec(0.4, 0, 0), vec(-0.3, 0, 0.2), vec(0, -0.2, -0.5), vec(0, 0, 0.4) }",
    "shape.polygon({ vec(-0.4, -0.2, 0), vec(0.4, -0.3, 0), vec(0.1, 0.5, 0) }, 0.5",
  } .. ", { at = " .. vector(0.2) .. material() .. " })"
end

local function with_points(body)
  for _, end_of in ipairs { "a", "b" } do table.insert(names.point, body .. "." .. end_of) end
end
local function body(at)
  local b = new "body"
  local x = number(0.2, 1)
  local points = string.format("points = { a = vec(-%s, 0, 0), b = vec(%s, 0, 0)%s }", x, x, chance(0.3) and ", c = { at = " .. vector(0.5) .. ", mass = 0.5 }" or "")
  local rest = ", at = " .. (at or vector(3)) .. motion() .. ", " .. points
  local shaped = material() .. (chance(0.1) and ", picture = 'crate.png'" or "")
  say("%s = scene:%s }", b, pick {
    "ball { radius = " .. number(0.1, 0.6) .. shaped .. rest,
    "box { size = vec(" .. number(0.2, 1) .. ", 0.5, 0.4)" .. shaped .. rest,
    "box { size = " .. number(0.3, 0.8) .. shaped .. rest,
    "capsule { radius = 0.2, length = " .. number(0.1, 1) .. shaped .. rest,
    "cylinder { radius = 0.4, length = " .. number(0.05, 1) .. shaped .. rest,
    "body { shape = " .. any_shape() .. rest,
    "body { shapes = { " .. any_shape() .. ", " .. any_shape() .. " }" .. rest,
    "body { inertia = vec(0.1, 0.1, 0.1), mass = 1" .. rest:gsub(", mass = [%d.e+-]+", ""),
    "body { inertia = vec(0.1, 0.1, 0.1), mass = " .. pick { "1", "100" } .. rest:gsub(", mass = [%d.e+-]+", ""),
  })
  with_points(b)
  return b
end
local function chain()
  local links, at = math.random(2, 8), vector(2)
  local bare, last = chance(0.6), nil
  for i = 1, links do
    local b = new "body"
    local where = string.format("at = %s + vec(%d, 0, 0), points = { a = vec(-0.5, 0, 0), b = vec(0.5, 0, 0) }", at, i)
    if bare then
      say("%s = scene:body { mass = %s, inertia = vec(0.01, 0.1, 0.1), %s }", b, i == links and pick { "1", "1000" } or "1", where)
    else
      say("%s = scene:box { size = vec(0.9, 0.2, 0.2), %s%s }", b, where, material())
    end
    with_points(b)
    if last then say("%s = scene:hinge(%s.b, %s.a, { %s })", new "tie", last, b, pick { "", "axis = vec(0, 0, 1)", "collide = true", "breaks_at = { force = 50 }" }) end
    if not last and chance(0.7) then say("%s = scene:nail(%s.a)", new "tie", b) end
    last = b
  end
  if chance(0.3) then say("%s = scene:follow(%s.b, %s)", new "tie", last, path(last .. ".b.position")) end
end

local function particles()
  if #names.family == 0 or chance(0.3) then
    say("%s = scene:family('family%d', { attributes = { charge = %s }, mass = %s, radius = 0.1%s })", new "family", made, number(-1, 1),
        number(0.1, 2), chance(0.4) and ", solid = true" .. material():gsub(", rolling.-0.01", ""):gsub(", sensor = true", "") or "")
  end
  for _ = 1, math.random(6) do
    local family = chance(0.7) and ", family = " .. some "family" or ""
    say("%s = scene:particle { at = %s, velocity = %s%s%s }", new "particle", vector(2), vector(2), family,
        chance(0.1) and ", lifetime = " .. number(0.05, 0.5) or "")
  end
end
local function emitter()
  say("%s = scene:emitter { at = %s, rate = %s, velocity = %s, spread = 0.3, lifetime = %s, max = 30%s }", new "emitter",
      pick { vector(2), "{ " .. vector(1) .. ", " .. vector(1) .. " }", some "point" },
      pick { number(5, 100), "function(time) return 50 * math.sin(5 * time) ^ 2 end" }, vector(3),
      pick { number(0.05, 0.4), "{ min = 0.05, max = 0.4 }", "math.huge" }, chance(0.6) and ", family = " .. some "family" or "")
end
local function structures()
  local built = pick {
    "structure.sheet { columns = 3, rows = 3, edge = 0.4 }, { as = 'deformable', law = force.spring { stiffness = 50, damping = 0.5 }, mass = 1",
    "structure.lattice { cells = 2, edge = 0.4 }, { as = 'deformable', law = force.spring { stiffness = 200 }, mass = 2",
    "structure.cube { edge = 0.6 }, { as = 'rigid', shape = 'hull', mass = 1",
    "structure.ring { sides = 6, radius = 1 }, { as = 'articulated', mass = 1",
    "structure.icosahedron { edge = 0.7 }, { as = 'articulated', mass = 3",
    "structure.rotating_squares { columns = 2, rows = 2, edge = 0.5 }, { as = 'panels', mass = 2",
  }
  say("%s = scene:build(%s, at = %s, name = 'built%d' })", new "group", built, vector(2), made)
end
local function grounds()
  say("%s = scene:%s }%s", new "shape", pick {
    "floor { height = " .. number(-4, 0) .. material(),
    "floor { height = -2, surface_velocity = vec(1, 0, 0)",
    "ground { shape = shape.box(4, 0.5, 4), at = " .. vector(2),
    "ground { shape = shape.heights { columns = 6, rows = 6, height = function(x, z) return 0.3 * math.sin(x) end }, at = vec(0, -2, 0)",
    "ground { shape = shape.line { points = { vec(-4, 0, 0), vec(0, -1, 0), vec(4, 0, 0) } }, at = vec(0, -1, 0)",
  }, "")
end

local function constraint()
  local a, b, c, p, q = some "body", some "body", some "body", any_point(), any_point()
  local breaks = chance(0.2) and ", breaks_at = { force = " .. number(1, 100) .. " }" or ""
  say("%s = scene:%s", new "tie", pick {
    string.format("nail(%s%s)", p, chance(0.3) and ", " .. vector(2) or ""),
    string.format("follow(%s, %s, { max_force = %s })", p, path(p .. ".position"), number(1, 500)),
    string.format("rod(%s, %s)", p, any_end()),
    string.format("rod(%s, %s, %s)", p, any_end(), of_time(1)),
    string.format("weld(%s, %s, { name = 'weld'%s })", a, b, breaks),
    string.format("orient(%s, quat(%s, %s))", a, axis(), number(-2, 2)),
    string.format("orient(%s, function(time) return quat(%s, time) end)", a, axis()),
    string.format("align(%s, %s, %s, %s)", a, axis(), b, axis()),
    string.format("align(%s, vec(0, 1, 0), vec(0, 1, 0), { angle = 0 })", a),
    string.format("motor(%s, %s, { axis = %s, speed = %s%s })", a, b, axis(), of_time(5), chance(0.5) and ", max_torque = " .. number(0.1, 20) or ""),
    string.format("motor(%s, { axis = %s, angle = %s%s })", a, axis(), of_time(2), chance(0.5) and ", max_torque = " .. number(0.1, 20) or ""),
    string.format("limit(%s, %s, { axis = %s, min = -0.5, max = %s })", a, b, axis(), number(-0.4, 2)),
    string.format("limit(%s, %s, { min = 0.2, max = %s })", p, q, number(0.3, 4)),
    string.format("on_plane(%s, { normal = %s })", p, axis()),
    string.format("string({ %s, %s, %s })", p, vector(2), q),
    string.format("string({ %s, %s }, { length = %s })", p, any_end(), of_time(2)),
    string.format("on_path(%s, { %s.position, %s, %s }, { smooth = %s, closed = %s })", p, p, vector(2), vector(2), chance(0.5), chance(0.5)),
    string.format("join(%s, %s%s)", p, q, chance(0.3) and ", { at = " .. vector(1) .. " }" or ""),
    string.format("gear(%s, %s, { ratio = %s, axis = %s%s })", a, b, number(-3, 3), axis(), chance(0.3) and ", carrier = " .. c or ""),
    string.format("rack(%s, %s, { radius = %s, axis = %s, along = vec(1, 0, 0) })", a, p, number(0.2, 1), axis()),
    string.format("pulley(%s, %s, %s, %s, { ratio = %s })", p, vector(3), any_end(), q, number(0.5, 3)),
    string.format("screw(%s, %s, { lead = 0.1, axis = %s })", some "point", some "point", axis()),
    string.format("slider(%s, %s, { axis = %s, turns = %s, min = -0.5, max = %s })", p, a, axis(), chance(0.5), number(0.1, 2)),
    string.format("slider(%s, { axis = %s, length = %s })", p, axis(), of_time(1)),
  })
end

local function law()
  local l = pick {
    function() return string.format("interact(%s, %s, %s)", some "family", some "family", pair_law()) end,
    function() return string.format("connect(%s, %s, %s%s)", any_end(), any_point(), pair_law(), chance(0.2) and ", { breaks_at = { length = 3, force = 100 } }" or "") end,
    function() return string.format("connect(%s, %s, %s)", some "particle", some "particle", pair_law()) end,
    function() return string.format("connect({ %s, %s, %s }, force.angle { stiffness = 2 })", some "particle", any_point(), any_point()) end,
    function() return string.format("connect({ %s, %s, %s, %s }, force.torsion { stiffness = 2 })", some "particle", any_point(), any_point(), any_point()) end,
    function() return string.format("connect({ %s, %s, %s }, force.many { count = 3, potential = function(p) return (p[1].position - p[3].position):length() end })", some "particle", any_point(), any_point()) end,
    function() return string.format("field(%s, %s)", pick { "scene", some "family", some "group" }, point_law()) end,
    function() return string.format("field(scene, %s)", point_law()) end,
    function() return string.format("bonding { families = %s, near = 0.5, below = 5, above = 10, %s }", some "family", pick { "law = force.spring { stiffness = 20 }", "hinge = true" }) end,
  }
  say("%s = scene:%s", new "element", l())
end
local function group()
  local members = {}
  for _ = 1, math.random(5) do members[#members + 1] = ":add(" .. any_thing() .. ")" end
  say("%s = scene:group('group%d')%s", new "group", made, table.concat(members))
end

-- What events do; a new name for all that they make.
local function edit()
  local b = some "body"
  return pick {
    function() return string.format("%s = scene:merge(%s, %s)", new "body", some "body", some "body") end,
    function() return string.format("%s = scene:split(%s, %s.points[1])", new "body", b, b) end,
    function() return string.format("%s = scene:split(%s, { through = %s.position, normal = %s })", new "body", b, b, axis()) end,
    function() return string.format("scene:shatter(%s)", b) end,
    function() return string.format("scene:shatter(%s, { pieces = %d })", b, math.random(2, 6)) end,
    function() return string.format("%s = scene:freeze(%s)", new "body", some "group") end,
    function() return string.format("%s = scene:weld(%s, %s)", new "tie", some "body", some "body") end,
    function() return string.format("%s = scene:join(%s, %s)", new "tie", any_point(), any_point()) end,
    function() return string.format("%s:cut()", some "tie") end,
    function() return string.format("%s:cut_hinges()", some "group") end,
    function() return string.format("%s:break_connections()", some "group") end,
    function() return string.format("%s:heat(%s)", some "group", number(-2, 5)) end,
    function() return string.format("%s:remove()", any_thing()) end,
    function() return string.format("%s:remove()", some "body") end,
    function() return string.format("%s:remove_point(%s.a)", b, b) end,
    function() return string.format("%s:add_point { at = %s, mass = 0.2, name = 'extra' }", b, vector(0.5)) end,
    function() return string.format("%s:kick(%s)", b, vector(3)) end,
    function() return string.format("%s:push(%s)", any_point(), vector(50)) end,
    function() return string.format("%s:twist(%s)", b, spin(5)) end,
    function() return string.format("%s.velocity = %s", b, vector(3)) end,
    function() return string.format("%s.position = %s", b, vector(3)) end,
    function() return string.format("%s.mass = %s", b, number(0.1, 5)) end,
    function() return string.format("%s.enabled = %s", some(pick { "tie", "element", "emitter" }), chance(0.5)) end,
    function() return string.format("%s.length = %s", some "tie", number(0.2, 3)) end,
    function() return string.format("%s.speed = %s", some "tie", number(-4, 4)) end,
    function() return string.format("scene.gravity = %s", vector(10)) end,
    function() return string.format("scene.step = 1 / %d", math.random(60, 500)) end,
    function() return string.format("scene.integrator = '%s'", pick { "verlet", "suzuki4", "implicit", "adaptive" }) end,
    function() return string.format("scene.accuracy = %s", pick { "1e-3", "1e-2", "nil" }) end,
    function() return string.format("local h = scene:hand { path = function(time) return %s + %s * time end } h:grab(%s, { max_force = 50 })", vector(2), vector(1), any_point()) end,
    function() return string.format("%s = scene:particle { at = %s, family = %s }", new "particle", vector(2), some "family") end,
    function() body() return table.remove(lines):match("^try%(function%(%) (.*) end%)$") end,
    function() constraint() return table.remove(lines):match("^try%(function%(%) (.*) end%)$") end,
    function() law() return table.remove(lines):match("^try%(function%(%) (.*) end%)$") end,
    function() return string.format("scene:snapshot() scene.store.taken = (scene.store.taken or 0) + 1") end,
    function() return string.format("if not scene.store.before then scene.store.before = true %s = scene:ray { from = %s, direction = %s } end", "local hit", vector(5), vector(1)) end,
    function() return string.format("for _, thing in ipairs(scene:near(%s, 2)) do thing.color = '#f00' end", vector(1)) end,
  }()
end
local function event()
  local doing = "try(function() " .. edit() .. " end)"
  say(pick {
    function() return string.format("scene:at(%s, function() %s end)", number(0, 0.6), doing) end,
    function() return string.format("scene:at(%s, function() %s end)", number(0, 0.3), doing) end,
    function() return string.format("scene:at(%s, function() %s %s end)", number(0, 0.3), doing, "try(function() " .. edit() .. " end)") end,
    function() return string.format("scene:every(%s, function() %s end)", number(0.02, 0.3), doing) end,
    function() return string.format("scene:over(%s, %s, function(u) try(function() %s:push(vec(20 * u, 0, 0)) end) end)", number(0, 0.2), number(0.2, 0.5), any_point()) end,
    function() return string.format("scene:when(function() return %s.position.y < %s end, function() %s end)", some "body", number(-2, 2), doing) end,
    function() return string.format("scene:when({ distance_below = 1, of = { %s, %s } }, function() %s end, { again = true })", any_point(), any_point(), doing) end,
    function() return string.format("scene:when({ energy_above = %s }, function() %s end)", number(0, 100), doing) end,
    function() return string.format("scene:play(function(wait) wait(%s) %s wait(%s) %s end)", number(0, 0.2), doing, number(0, 0.2), "try(function() " .. edit() .. " end)") end,
    function() return string.format("scene:on('touched', %s, function(touch) %s end)", some "body", doing) end,
    function() return string.format("scene:on('broke', function(thing) %s end)", doing) end,
    function() return string.format("scene:on('removed', function(thing) %s end)", doing) end,
    function() return string.format("scene:on('step', function(dt) try(function() %s:push(%s) end) end)", any_point(), vector(20)) end,
    function() return string.format("scene:behave(%s, { step = function(self) try(function() self.target:push(%s) end) end })", any_thing(), vector(20)) end,
    function() return string.format("scene:probe('probe%d', function() return %s.position.y end)", #lines, some "body") end,
  }():gsub("%%", "%%%%"))
end

local function settings()
  say("scene.gravity = %s", pick { "vec(0, -9.81, 0)", "vec(0, 0, 0)", vector(10) })
  say("scene.step = 1 / %d", pick { 60, 120, 240, 1000 })
  if plane then table.insert(lines, 1, "try(function() scene.plane = 'xy' end)") end
  if chance(0.3) then say("scene.integrator = '%s'", pick { "verlet", "suzuki4", "implicit", "adaptive", "euler", "rk4" }) end
  if chance(0.15) then say("scene.accuracy = %s", pick { "1e-3", "1e-2", "1e-4" }) end
  if chance(0.1) then say("scene.energy_return = false") end
  if chance(0.2) then say("scene.contact = '%s'", pick { "exact", "fast" }) end
  if chance(0.05) then say("scene.box = vec(5, 5, 5)") end
  if chance(0.1) then say("scene:collide('one', 'two', %s)", pick { "false", "{ friction = 0, restitution = 1 }" }) end
  if chance(0.05) then say("scene.history = 0.1") end
end

settings()
if chance(0.6) then grounds() end
for _ = 1, math.random(3, 12) do
  pick { body, body, body, chain, particles, particles, emitter, structures, group }()
end
for _ = 1, math.random(0, 10) do pick { constraint, constraint, law }() end
for _ = 1, math.random(0, 10) do event() end

scene:result("source", table.concat(lines, "\n"))
