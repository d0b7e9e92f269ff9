-- A net of stiff springs in a frame. Balls, boxes and jellies fall on it and bounce, of the springs' own: nothing here has
-- restitution. Drag them, throw them, or tear a hole into the net.
local n = scene:param("knots", 7, { min = 4, max = 24, step = 1, help = "knots along each edge of the net" })
local stiffness = scene:param("stiffness", 4000, { min = 200, max = 1e5, help = "of each thread of the net, N/m" })
local firmness = scene:param("jelly", 1500, { min = 100, max = 5e4, help = "stiffness of each spring of a jelly, N/m" })
local most = scene:param("things", 3, { min = 1, max = 20, step = 1, help = "how many there are, before the first one goes" })

scene.title, scene.duration, scene.step = "Trampoline", 20, 1 / 60
scene.camera = { at = vec(2.6, 3.1, 4.4), look_at = vec(0, 1.3, 0) }
scene:floor { height = 0, color = "#cfc7b8" }

local edge, gap = 2.6, 2.6 / (n - 1) -- m
local knot = scene:family("knot", { solid = true, mass = 4 / (n * n), radius = math.min(0.09, 0.3 * gap), friction = 0.6, layer = "net", color = "#3d5a80" })
local jelly = scene:family("jelly", { solid = true, mass = 0.08, radius = 0.09, friction = 0.5, color = "#8fd694" })
scene:collide("net", "net", false) -- springs keep its knots apart
local thread = force.spring { stiffness = stiffness, damping = stiffness / 800, implicit = true, length = 0.97 * gap }
local gel = force.spring { stiffness = firmness, damping = firmness / 1000, implicit = true }
local net = {}
for i = 1, n do
  net[i] = {}
  for j = 1, n do
    net[i][j] = scene:particle { family = knot, at = vec((i - 1) * gap - edge / 2, 1, (j - 1) * gap - edge / 2) }
    if i == 1 or j == 1 or i == n or j == n then scene:nail(net[i][j]) end
    if i > 1 then scene:connect(net[i - 1][j], net[i][j], thread) end
    if j > 1 then scene:connect(net[i][j - 1], net[i][j], thread) end
  end
end
local function bar(radius, from, to) scene:ground { shape = shape.capsule { radius = radius, from = from, to = to }, color = "#5b6770" } end
for _, s in ipairs { -1, 1 } do
  local rim = s * (edge / 2 + 0.16)
  bar(0.06, vec(rim, 1, -rim), vec(rim, 1, rim))
  bar(0.06, vec(-rim, 1, rim), vec(rim, 1, rim))
  for _, z in ipairs { -rim, rim } do bar(0.05, vec(rim, 0, z), vec(rim, 1, z)) end
end
local things, count = {}, 0
local function make_jelly(at)
  count = count + 1
  local cube = scene:group("jelly " .. count)
  for i = -1, 1 do for j = -1, 1 do for k = -1, 1 do cube:add(scene:particle { family = jelly, at = at + 0.19 * vec(i, j, k) }) end end end
  scene:connect_within(cube, 0.28, gel)
  return cube
end
local makers = {
  function(at) return scene:ball { radius = 0.28, mass = 3, at = at, friction = 0.5, color = "#ee6c4d" } end,
  make_jelly,
  function(at) return scene:box { size = 0.46, mass = 3, at = at, friction = 0.5, orientation = quat(vec(1, 0, 1), 0.6), color = "#e0b75e" } end,
}
local function drop()
  things[#things + 1] = makers[(#things + count) % #makers + 1](vec(1.2 * math.random() - 0.6, 3.4, 1.2 * math.random() - 0.6))
  if #things > most then table.remove(things, 1):remove() end
end
drop()
scene:every(2.2, drop)
scene:button("drop", drop)
scene:probe("highest", function()
  local high = 0
  for _, body in ipairs(scene.bodies) do high = math.max(high, body.position.y) end
  return high
end)
