-- A sheet of springs in the wind, held at two corners. Drag it, and tear it: its threads break when they are pulled too far.
local n = scene:param("threads", 28, { min = 4, max = 120, step = 1, help = "threads along each edge" })
local wind = scene:param("wind", 4, { min = 0, max = 30, help = "speed of the wind, m/s" })

scene.title = "Cloth"
scene.duration = 20
scene.step = 1 / 1200
scene.camera = { at = vec(1.4, 2.9, 3.9), look_at = vec(0, 2.45, 0.2) }

local edge, mass = 2, 0.4 -- m, kg
local gap = edge / (n - 1)
local cloth = scene:family("cloth", { color = "#d8573c", radius = 0.3 * gap, mass = mass / (n * n) })
local thread = force.spring { stiffness = 40, damping = 0.01 }
local knots = {}
for i = 1, n do
  knots[i] = {}
  for j = 1, n do
    knots[i][j] = scene:particle { family = cloth, at = vec((i - 1) * gap - edge / 2, 3.2, (j - 1) * gap - edge / 2) }
  end
end

local limit = { breaks_at = { length = 3 * gap } }
local shear, bend = { breaks_at = { length = 4.5 * gap }, stiffness = 20 }, { breaks_at = { length = 6 * gap }, stiffness = 4 }
for i = 1, n do
  for j = 1, n do
    if i < n then scene:connect(knots[i][j], knots[i + 1][j], thread, limit) end
    if j < n then scene:connect(knots[i][j], knots[i][j + 1], thread, limit) end
    if i < n and j < n then
      scene:connect(knots[i][j], knots[i + 1][j + 1], thread, shear)
      scene:connect(knots[i + 1][j], knots[i][j + 1], thread, shear)
    end
    if i < n - 1 then scene:connect(knots[i][j], knots[i + 2][j], thread, bend) end
    if j < n - 1 then scene:connect(knots[i][j], knots[i][j + 2], thread, bend) end
  end
end

local corners = { scene:nail(knots[1][1]), scene:nail(knots[n][1]) }
scene:field(cloth, force.point {
  parameters = { wind = wind, drag = 0.03 / (n * n) },
  force = function(p, own, t)
    local gust = 0.5 + 0.5 * math.sin(1.3 * t + 2 * p.position.x) * math.sin(0.7 * t)
    return own.drag * (vec(0.3, 0, 1) * (own.wind * gust) - p.velocity)
  end,
})

scene:button("let go", function()
  for _, nail in ipairs(corners) do if nail.alive then nail:remove() end end
end)
local torn = 0
scene:on("broke", function() torn = torn + 1 end)
scene:probe("torn threads", function() return torn end)
