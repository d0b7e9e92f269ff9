-- Dumbbells of oil and water: like attracts like, unlike push apart. Pull the drops apart; they find each other again.
local count = scene:param("dumbbells", 60, { min = 5, max = 1000, step = 1, help = "number of dumbbells" })
local warmth = scene:param("temperature", 0.35, { min = 0, max = 2, help = "temperature, in units of the attraction" })

scene.title = "Oil and water"
scene.duration = 60
scene.gravity = vec(0, 0, 0)
scene.step = 0.01

local oil = scene:family("oil", { color = "#e8a33a", radius = 0.5 })
local water = scene:family("water", { color = "#3a8fd0", radius = 0.5 })
local kinds = { { oil, oil }, { water, water }, { oil, water } } -- what the two ends of a dumbbell are of

local size = 2.2 * count ^ (1 / 3)
scene.camera = { at = vec(0.8 * size, 1.0 * size, 2.6 * size), look_at = vec(0, 0, 0) }

local dumbbells = scene:group "dumbbells"
local per_row = math.ceil(count ^ (1 / 3))
for i = 0, count - 1 do
  local x, y, z = i % per_row, i // per_row % per_row, i // (per_row * per_row)
  local ends = kinds[i % #kinds + 1]
  dumbbells:add(scene:body {
    at = 2.2 * (vec(x, y, z) - vec(1, 1, 1) * (per_row - 1) / 2),
    orientation = quat(vec(math.random() - 0.5, math.random() - 0.5, math.random() - 0.5), 6 * math.random()),
    points = {
      { at = vec(-0.5, 0, 0), mass = 1, family = ends[1], radius = 0.5, color = ends[1] == oil and "#e8a33a" or "#3a8fd0" },
      { at = vec(0.5, 0, 0), mass = 1, family = ends[2], radius = 0.5, color = ends[2] == oil and "#e8a33a" or "#3a8fd0" },
    },
  })
end

scene:interact(oil, oil, force.hydrophobic { strength = 1, size = 1 })
scene:interact(water, water, force.hydrophobic { strength = 0.4, size = 1 })
scene:interact(oil, water, force.hydrophobic { strength = 1, size = 1, attraction = -1 })

scene:field(scene, force.thermostat { temperature = warmth, rate = 0.5 })
scene:field(scene, force.point { potential = function(p) return 0.02 * p.position:dot(p.position) end })

scene:probe("temperature", function() return scene.temperature end)
scene:probe("largest drop", function() return #dumbbells:clusters(1.4)[1] end)
