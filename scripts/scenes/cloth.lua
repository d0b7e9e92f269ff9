-- A sheet of springs in the wind, held at two corners. Balls are thrown at it, each faster than the one before, until one goes
-- through; then a new sheet is hung. Drag it, and tear it: its threads break when they are pulled too far.
local n = scene:param("threads", 16, { min = 4, max = 120, step = 1, help = "threads along each edge" })
local wind = scene:param("wind", 4, { min = 0, max = 30, help = "speed of the wind, m/s" })
local balls = scene:param("balls", true, { help = "whether balls are thrown" })

scene.title, scene.duration, scene.step = "Cloth", 20, 1 / 480
scene.camera = { at = vec(2.6, 2.9, 4.2), look_at = vec(0, 2.3, 0.2) }

local edge, mass, gap = 2, 0.4, 2 / (n - 1) -- m, kg, m
local cloth = scene:family("cloth", { color = "#d8573c", radius = 0.3 * gap, mass = mass / (n * n), solid = true, layer = "cloth" })
scene:collide("cloth", "cloth", false)
local thread = force.spring { stiffness = 40, damping = 0.01 }
local limit = { breaks_at = { length = 2 * gap } }
local shear, bend = { breaks_at = { length = 3 * gap }, stiffness = 20 }, { breaks_at = { length = 4 * gap }, stiffness = 4 }
local corners, middle, torn, speed = {}, nil, 0, 5 -- of the first ball, m/s
local function hang()
  local knots = {}
  for _, knot in ipairs(cloth.particles) do knot:remove() end
  for i = 1, n do
    knots[i] = {}
    for j = 1, n do knots[i][j] = scene:particle { family = cloth, at = vec((i - 1) * gap - edge / 2, 3.2, (j - 1) * gap - edge / 2) } end
  end
  for i, row in ipairs(knots) do
    local function tie(j, di, dj, how)
      local other = knots[i + di] and knots[i + di][j + dj]
      if other then scene:connect(row[j], other, thread, how) end
    end
    for j = 1, n do
      tie(j, 1, 0, limit) tie(j, 0, 1, limit)
      tie(j, 1, 1, shear) tie(j, 1, -1, shear)
      tie(j, 2, 0, bend) tie(j, 0, 2, bend)
    end
  end
  corners, middle, torn, speed = { scene:nail(knots[1][1]), scene:nail(knots[n][1]) }, knots[n // 2][n // 2], 0, 5
end
hang()
scene:field(cloth, force.point {
  parameters = { wind = wind, drag = 0.03 / (n * n) },
  force = function(p, own, t)
    local gust = 0.5 + 0.5 * math.sin(1.3 * t + 2 * p.position.x) * math.sin(0.7 * t)
    return own.drag * (vec(0.3, 0, 1) * (own.wind * gust) - p.velocity)
  end,
})

-- A ball every 5 s, of 0.5 kg, from behind or from the front.
local ball, way = nil, 1
local function throw()
  if ball and ball.alive then ball:remove() end
  if torn > 4 then return hang() end
  ball = scene:ball { radius = 0.2, mass = 0.5, at = vec(0, 2.2, -2.5 * way), velocity = vec(0, 12.3 / speed, speed * way), color = "#3f6f9f" }
  way, speed = -way, 1.8 * speed
end
if balls then scene:every(5, throw) end
scene:every(1, function() if balls and middle.alive and middle.position.y < -1 then hang() end end) -- it flew off
scene:button("let go", function() for _, nail in ipairs(corners) do if nail.alive then nail:remove() end end end)
scene:button("hang a new one", hang)
scene:on("broke", function() torn = torn + 1 end)
scene:probe("torn threads", function() return torn end)
