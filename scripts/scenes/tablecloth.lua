-- A cloth of threads that do not stretch falls over a ball and the corner of a box, and slides off where it finds
-- no hold.
local n = scene:param("threads", 10, { min = 4, max = 40, step = 1, help = "threads along each edge" })
local friction = scene:param("friction", 0.4, { min = 0, max = 1, help = "of the cloth" })

scene.title = "Tablecloth"
scene.duration = 6
scene.camera = { at = vec(2.3, 2.1, 3.2), look_at = vec(0.15, 0.7, 0) }
scene:floor { height = 0, friction = 0.6, color = "#cfc7b8" }

local edge, mass = 1.8, 0.3 -- m, kg
local gap = edge / (n - 1)
local knot = scene:family("knot", { solid = true, friction = friction, layer = "cloth", mass = mass / (n * n), radius = 0.025, color = "#d8573c" })
scene:collide("cloth", "cloth", false) -- it folds through itself

scene:ground { shape = shape.ball { radius = 0.45, friction = 0.4 }, at = vec(-0.25, 0.75, 0), color = "#5b7c99" }
scene:block { size = vec(0.6, 0.8, 0.6), mass = 5, at = vec(0.75, 0.4, 0.1), color = "#a67c4e", name = "box" }

local function place(i, j) return vec((i - 1) * gap - edge / 2 + 0.15, 1.35, (j - 1) * gap - edge / 2) end
local knots = {}
for i = 1, n do
  knots[i] = {}
  for j = 1, n do
    knots[i][j] = scene:particle { family = knot, at = place(i, j) }
    if i > 1 then scene:rod(knots[i - 1][j], knots[i][j]) end
    if j > 1 then scene:rod(knots[i][j - 1], knots[i][j]) end
  end
end
-- Again and again it is laid out anew, a little aside, and falls.
local function lay_out()
  local aside = vec(0.8 * math.random() - 0.4, 0, 0.8 * math.random() - 0.4)
  for i, line in ipairs(knots) do
    for j, one in ipairs(line) do
      if one.alive then one.position, one.velocity = place(i, j) + aside, vec(0, 0, 0) end
    end
  end
end
scene:every(6, lay_out)
scene:button("lay it out", lay_out)
scene:probe("lowest", function()
  local low = math.huge
  for _, p in ipairs(knot.particles) do low = math.min(low, p.position.y) end
  return low
end)
