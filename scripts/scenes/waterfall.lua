-- A waterfall: drops leave a ledge, burst on the rocks below and run off over the ground. Turn the tap with the slider.
local flow = scene:param("flow", 900, { min = 0, max = 4000, help = "drops per second" })

scene.title = "Waterfall"
scene.step = 1 / 960
scene.duration = 10
scene.camera = { at = vec(3.4, 2.4, 5.2), look_at = vec(0.7, 1.35, 0) }

local water = scene:family("water", { mass = 1e-3, radius = 0.018, look = "streak",
  color = function(age, life) -- glassy at the ledge, white where it falls, gone in the end
    local u = age / life
    return { 0.30 + 0.45 * u, 0.58 + 0.27 * u, 0.80 + 0.1 * u, 0.85 * (1 - u ^ 4) }
  end })
local rock = scene:family("rock", { color = "#8b857b" })
local mist = scene:family("mist", { mass = 1e-5, look = "glow",
  radius = function(age, life) return 0.06 + 0.3 * age / life end,
  color = function(age, life)
    local u = age / life
    return { 0.97, 0.98, 1, 0.5 * u * (1 - u) }
  end })

-- The cliff with its ledge, and the rocks that the water falls on.
local function stone(x, y, z, radius)
  scene:nail(scene:particle { at = vec(x, y, z), mass = 50, radius = radius, family = rock })
end
for i = -2, 2 do
  for j = 0, 3 do stone(-0.5 - 0.1 * ((i + j) % 2), 0.3 + 0.62 * j, 0.55 * i, 0.42) end
end
stone(0.62, 0.15, -0.35, 0.32)
stone(0.55, 0.2, 0.3, 0.36)
stone(1.0, 0.05, 0.02, 0.24)
stone(0.85, 0, 0.75, 0.2)
stone(0.8, 0, -0.85, 0.22)

scene:interact(water, rock, force.repel { stiffness = 400 })
scene:field(water, force.wall { through = vec(0, 0, 0), normal = vec(0, 1, 0), stiffness = 30, damping = 0.06, friction = 0.05 })
scene:field(water, force.drag { linear = 2e-4 })
-- Mist hangs in the air and drifts away.
scene:field(mist, force.point { force = function(p, own, t)
  return p.mass * (vec(0, 9.81, 0) + 3 * (vec(0.35, 0.12, 0.1 * math.sin(t)) - p.velocity))
end })

local fall = scene:emitter { name = "fall", family = water, at = { vec(-0.1, 2.62, -0.75), vec(0, 2.68, 0.75) },
  rate = flow, velocity = vec(0.75, 0, 0), spread = 0.12, lifetime = { min = 1.6, max = 2.4 } }
scene:emitter { family = mist, at = { vec(0.4, 0.1, -0.8), vec(1.1, 0.4, 0.8) }, rate = 40, velocity = vec(0.4, 0.6, 0),
  spread = 1, lifetime = { min = 1, max = 2.5 } }
scene:probe("drops", function() return fall.count end)
