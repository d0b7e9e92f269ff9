-- A sun, four planets and a belt of dust, all by Newton's law of gravitation. Throw a planet off its course.
local dust = scene:param("dust", 400, { min = 0, max = 5000, step = 1, help = "grains of the belt" })

scene.title = "Orbits"
scene.duration = 60
scene.dark = true
scene.gravity = vec(0, 0, 0)
scene.step = 0.002 -- of a year; lengths in astronomical units, masses in suns
scene.camera = { at = vec(0, 5.5, 7.5), look_at = vec(0, -0.2, 0) }

local G = 4 * math.pi ^ 2 -- au³ / (sun year²): one au, one year
local suns = scene:family("suns", { color = "#f7b733", radius = 0.28, mass = 1 })
local planets = scene:family("planets", { radius = 0.1 })
local grains = scene:family("grains", { color = "#9aa4b2", radius = 0.025, mass = 1e-12 })

local sun = scene:particle { family = suns, name = "sun" }

--- Puts a thing on a circle round the sun; `tilt` turns its orbit, `part` scales its speed.
local function on_orbit(family, distance, angle, tilt, part, options)
  local turn = quat(vec(math.cos(3 * angle), 0, math.sin(3 * angle)), tilt)
  options.family = family
  options.at = turn:rotate(vec(distance * math.cos(angle), 0, distance * math.sin(angle)))
  options.velocity = turn:rotate(vec(-math.sin(angle), 0, math.cos(angle))) * (part * math.sqrt(G / distance))
  return scene:particle(options)
end

on_orbit(planets, 1.0, 0.3, 0.00, 1, { mass = 3e-6, color = "#3b82c4" })
on_orbit(planets, 1.6, 2.5, 0.03, 0.95, { mass = 3e-7, color = "#c8553d" })
on_orbit(planets, 3.4, 4.4, 0.02, 1, { mass = 1e-3, color = "#d9a066", radius = 0.2 })
on_orbit(planets, 4.4, 1.2, 0.05, 0.92, { mass = 3e-4, color = "#8fb996", radius = 0.15 })
for i = 1, dust do
  local angle, distance = 2 * math.pi * math.random(), 2.1 + 0.7 * math.random()
  on_orbit(grains, distance, angle, 0.08 * (math.random() - 0.5), 1 + 0.02 * (math.random() - 0.5), {})
end

local gravitation = force.gravitation { constant = G, softening = 0.01 }
scene:interact(suns, planets, gravitation)
scene:interact(planets, planets, gravitation)
scene:interact(suns, grains, gravitation)
scene:interact(planets, grains, gravitation)

scene:probe("energy", function() return scene.energy.total end)
scene:probe("angular momentum", function() return scene.angular_momentum.y end)
