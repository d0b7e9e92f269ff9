-- A flock: each bird sees its neighbours, keeps its distance, flies where they fly and stays with them.
-- The view follows the red one. Be the hawk: drag one.
local count = scene:param("birds", 250, { min = 2, max = 10000, step = 1, help = "number of birds" })

scene.title, scene.duration = "Flock", 60
scene.gravity = vec(0, 0, 0)
scene.step = 1 / 60

local room = 1.7 * count ^ (1 / 3) -- m, radius of the sky

local birds = scene:family("birds", { color = "#3a7ca5", radius = 0.1, mass = 1 })
local flock = scene:group "flock"
scene.dark = true
local function any() return 2 * math.random() - 1 end
for i = 1, count do
  flock:add(scene:particle {
    family = birds, at = vec(any(), any(), any()) * (i == 1 and 0 or 0.6 * room), velocity = vec(any(), any(), any()) * 4,
    color = i == 1 and "#ff5a4a" or i % 9 == 0 and "#e8a33a" or "#5aa9d6",
  })
end
local first = flock.particles[1]
scene.camera = { at = first.position + vec(0, 0.3, 1.4) * room, look_at = first.position, follow = first }

-- A bird's head is its ball; its wings beat, and its tail trails behind.
scene:on("step", function()
  local t, up = scene.time, vec(0, 1, 0)
  for bird in flock:each() do
    local head, ahead = bird.position, bird.velocity:normalized()
    local side, beat = ahead:cross(up) * 0.5, up * (0.3 * math.sin(14 * t + head.x + head.z))
    local look = { color = bird.color, width = bird == first and 4 or 2.5 }
    local back = head - ahead * 0.2
    scene.draw:line(head, back + side + beat, look)
    scene.draw:line(head, back - side + beat, look)
    scene.draw:line(head, head - ahead * 0.6, look)
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
