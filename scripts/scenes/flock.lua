-- A flock: each bird sees its neighbours, keeps its distance, flies where they fly and stays with them.
-- The view follows the red one. Be the hawk: drag one.
local count = scene:param("birds", 250, { min = 2, max = 10000, step = 1, help = "number of birds" })

scene.title = "Flock"
scene.duration = 60
scene.gravity = vec(0, 0, 0)
scene.step = 1 / 60

local room = 1.7 * count ^ (1 / 3) -- m, radius of the sky

local birds = scene:family("birds", { color = "#3a7ca5", radius = 0.14, mass = 1 })
local flock = scene:group "flock"
scene.dark = true
local function any() return 2 * math.random() - 1 end
for i = 1, count do
  flock:add(scene:particle {
    family = birds, at = vec(any(), any(), any()) * (0.6 * room), velocity = vec(any(), any(), any()) * 4,
    color = i == 1 and "#ff5a4a" or i % 9 == 0 and "#e8a33a" or "#5aa9d6",
  })
end
local first = flock.particles[1]
scene.camera = { at = vec(0, 0.5 * room, 2.1 * room), look_at = vec(0, 0, 0), follow = first, ease = 0.5 }

-- A bird's head is its ball; its body trails behind, as long as the way of 0.12 s.
scene:on("step", function()
  for bird in flock:each() do
    local head = bird.position
    scene.draw:line(head, head - bird.velocity * 0.12, { color = bird.color, width = bird == first and 5 or 3 })
  end
end)

scene:interact(birds, birds, force.flock { sight = 4, separation = 3, alignment = 1.5, cohesion = 0.25 })

-- Each bird likes a speed of 6 m/s, turns back at the edge of the sky, and wanders a little.
scene:field(birds, force.point {
  parameters = { speed = 6, room = room },
  force = function(p, own, t)
    local v, x = p.velocity, p.position
    local cruise = v * (0.4 * (1 - v:dot(v) / own.speed ^ 2))
    local out = math.max(x:length() / own.room - 0.8, 0)
    return cruise - x * (12 * out / own.room) + vec(noise(), noise(), noise())
  end,
})

--- How far all fly one way: 1 all, 0 none.
scene:probe("order", function()
  local sum, speed = vec(0, 0, 0), 0
  for bird in flock:each() do
    sum = sum + bird.velocity
    speed = speed + bird.velocity:length()
  end
  return sum:length() / speed
end)
