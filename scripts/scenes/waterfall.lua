-- A waterfall: water leaves a ledge, runs down over the rocks from step to step and off over the ground. Turn the tap with the
-- slider.
local flow = scene:param("flow", 450, { min = 0, max = 2000, help = "drops per second" })

scene.title = "Waterfall"
scene.step = 1 / 240
scene.duration = 10
scene.camera = { at = vec(3.6, 2.4, 4.6), look_at = vec(0.7, 1.15, 0) }

local water = scene:family("water", { mass = 1e-3, radius = 0.03, look = "streak", solid = true, friction = 0.02, restitution = 0.2,
  layer = "water",
  color = function(age, life) -- glassy at the ledge, white where it falls, gone in the end
    local u = age / life
    return { 0.30 + 0.45 * u, 0.58 + 0.27 * u, 0.80 + 0.1 * u, 0.9 * (1 - u ^ 4) }
  end })
scene:collide("water", "water", false)
local mist = scene:family("mist", { mass = 1e-5, look = "glow",
  radius = function(age, life) return 0.06 + 0.3 * age / life end,
  color = function(age, life)
    local u = age / life
    return { 0.97, 0.98, 1, 0.4 * u * (1 - u) }
  end })

-- A cliff, a channel that leads to its edge, and rocks that stand out below it.
local rocks = {}
local function rock(x, y, z, size, turn)
  rocks[#rocks + 1] = shape.hull(structure.icosahedron { edge = 0.8 * size }, { at = vec(x, y, z), friction = 0.1,
    orientation = quat(vec(1, turn, 0.3), turn), color = #rocks % 2 == 0 and "#8b857b" or "#767066" })
end
rocks[1] = shape.box(1.2, 2.4, 2, { at = vec(-0.8, 1.2, 0), color = "#7d776d" })
for i = -2, 2 do
  for j = 0, 2 do rock(-0.32 + 0.05 * ((i + j) % 2), 0.35 + 0.75 * j, 0.45 * i, 0.4, i + 2 * j) end
end
for i, side in ipairs { -1, 1 } do rock(-0.35, 2.45, 0.62 * side, 0.42, i) rock(-0.9, 2.5, 0.75 * side, 0.45, i + 4) end
rock(0.3, 1.55, -0.25, 0.3, 1) rock(0.35, 1.3, 0.3, 0.32, 2) rock(0.6, 0.75, 0, 0.36, 3) rock(0.55, 0.5, -0.55, 0.3, 4)
rock(0.6, 0.45, 0.6, 0.3, 5) rock(1.1, 0.2, 0.25, 0.3, 6) rock(1.1, 0.15, -0.35, 0.26, 7) rock(1.5, 0.05, 0, 0.2, 8)
scene:ground { shapes = rocks }
scene:floor { friction = 0.05, color = "#c9c3b4" }

-- Mist hangs in the air and drifts away.
scene:field(mist, force.point { force = function(p, own, t)
  return p.mass * (vec(0, 9.81, 0) + 3 * (vec(0.35, 0.12, 0.1 * math.sin(t)) - p.velocity))
end })

local fall = scene:emitter { name = "fall", family = water, at = { vec(-0.6, 2.46, -0.4), vec(-0.5, 2.6, 0.4) },
  rate = flow, velocity = vec(1, 0, 0), spread = 0.15, lifetime = { min = 1.6, max = 2.4 } }
scene:emitter { family = mist, at = { vec(0.5, 0.1, -0.8), vec(1.3, 0.5, 0.8) }, rate = 40, velocity = vec(0.4, 0.6, 0),
  spread = 1, lifetime = { min = 1, max = 2.5 } }
scene:probe("drops", function() return fall.count end)
