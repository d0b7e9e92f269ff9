-- Stones in a bin, and a shovel that digs in them and tips them out beside it. Press "stop" and drag it yourself.
local count = scene:param("count", 150, { min = 1, max = 1000, step = 1, help = "stones" })
local friction = scene:param("friction", 0.5, { min = 0, max = 1.5, help = "of stones and shovel" })

scene.title = "Dig"
scene.duration = 27
scene.step = 1 / 120
scene.camera = { at = vec(2.6, 3.2, 4.6), look_at = vec(0.5, 0.4, 0) }
scene:floor { height = -0.1, color = "#cdd5c6" }

-- A bin without a lid.
local long, wide, high, thick = 2.4, 0.74, 0.6, 0.1
local function board(x, y, z, at) return shape.box(x, y, z, { at = at, friction = friction }) end
scene:ground { color = "#8d7a63", shapes = {
  board(long, thick, wide, vec(0, -thick / 2, 0)),
  board(thick, high, wide, vec(-(long + thick) / 2, high / 2 - thick, 0)),
  board(thick, high, wide, vec((long + thick) / 2, high / 2 - thick, 0)),
  board(long + 2 * thick, high, thick, vec(0, high / 2 - thick, -(wide + thick) / 2)),
  board(long + 2 * thick, high, thick, vec(0, high / 2 - thick, (wide + thick) / 2)),
} }

local function some(low, most) return low + (most - low) * math.random() end
local colors, stones = { "#9a8f80", "#b5a894", "#7f766a", "#c2b8a3", "#8c6f55" }, {}
for i = 1, count do
  local size = some(0.1, 0.17)
  local what = i % 3 == 0 and shape.ball(size / 2, { friction = friction, density = 2000 })
    or i % 3 == 1 and shape.box(size, some(0.7, 1) * size, some(0.7, 1) * size, { friction = friction, density = 2000 })
    or shape.hull(structure.dodecahedron { edge = 0.29 * size }, { friction = friction, density = 2000 })
  stones[i] = scene:body { shape = what, color = colors[i % #colors + 1], orientation = quat(vec(some(-1, 1), 1, some(-1, 1)), some(0, i % 3 == 1 and 0.15 or 3)),
                           at = vec(0.2 * (i % 10) - 0.9, 0.1 + 0.19 * (i // 30), 0.2 * (i // 10 % 3) - 0.2) }
end

-- The shovel: a plate with a back and two sides, held at its handle.
local function plate(x, y, z, at) return shape.box(x, y, z, { at = at, friction = friction, density = 3000 }) end
local shovel = scene:body {
  at = vec(-0.7, 1.3, 0), color = "#c2413b", name = "shovel",
  shapes = { plate(0.6, 0.03, 0.6, vec(0.1, 0, 0)), plate(0.03, 0.3, 0.6, vec(-0.2, 0.15, 0)),
             plate(0.5, 0.26, 0.03, vec(0.05, 0.13, 0.3)), plate(0.5, 0.26, 0.03, vec(0.05, 0.13, -0.3)) },
  points = { handle = { at = vec(-0.2, 0.3, 0), radius = 0.06 } },
}
-- Its handle is led from place to place, a second and a half from each to the next, and tipped: x and y [m], angle [rad].
local moves = { { -0.9, 1.6, -0.6 }, { -0.85, 0.6, -0.5 }, { -0.75, 0.4, -0.25 }, { 0.56, 0.4, -0.25 }, { 0.56, 0.75, 0.8 },
                { 0.5, 1.5, 0.7 }, { 1.7, 1.5, 0.7 }, { 1.7, 1.5, -1.5 }, { 0.3, 1.8, -0.6 } }
local function led(k)
  return function(t)
    local n, u = math.modf(t / 1.5)
    local from, to = moves[n % #moves + 1], moves[(n + 1) % #moves + 1]
    return from[k] + (to[k] - from[k]) * (3 - 2 * u) * u * u
  end
end
local x, y, tip = led(1), led(2), led(3)
local grip = scene:follow(shovel.handle, function(t) return vec(x(t), y(t), 0) end, { max_force = 5000 })
local turn = scene:orient(shovel, function(t) return quat(vec(0, 0, 1), tip(t)) end)
scene:button("stop", function() if grip.alive then grip:remove() turn:remove() end end)
scene:probe("dug out", function()
  local number = 0
  for _, one in ipairs(stones) do if one.position.x > long / 2 + thick then number = number + 1 end end
  return number
end)
