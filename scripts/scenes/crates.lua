-- Crates, bricks, beach balls and birds with pictures. A ball flies into the pile every four seconds; the button throws one, too.
-- The pictures lie in assets/pictures; ones of yours may lie beside your scene.
local rows = scene:param("rows", 4, { min = 1, max = 9, step = 1, help = "crates at the bottom of the pile" })

scene.title = "Crates"
scene.camera = { at = vec(-4.6, 3, 8), look_at = vec(0.7, 1.35, 0) }

scene:floor { picture = { file = "grass.png", width = 2 } }
scene:ground { shape = shape.box(9, 2.2, 0.4), at = vec(0.5, 1.1, -2), picture = { file = "bricks.png", width = 1 } }
scene:ground { shape = shape.cylinder(0.25, 2.6), at = vec(-4, 1.3, -2), picture = { file = "bricks.png", width = 0.8 } }
scene:ground { shape = shape.cylinder(0.25, 2.6), at = vec(5, 1.3, -2), picture = { file = "bricks.png", width = 0.8 } }

for row = 1, rows do
  for i = row, rows do
    local x = (i - 0.5 * (rows + row)) * 0.72 + 1
    scene:box { size = 0.68, at = vec(x, 0.68 * (row - 0.5), 0), density = 60, picture = "crate.png" }
  end
end

local balls = {}
local function throw()
  local ball = scene:ball { radius = 0.3, at = vec(-6, 1.5, 0.6), velocity = vec(10, 3, -0.6), spin = vec(0, 2, -9),
    density = 300, restitution = 0.6, rolling = 0.01, picture = "beach_ball.png" }
  table.insert(balls, ball)
  local oldest = #balls > 8 and table.remove(balls, 1)
  if oldest and oldest.alive then oldest:remove() end
end
scene:every(4, throw)
scene:button("throw", throw)

-- Sprites face the camera.
local birds = scene:family("birds", { radius = 0.15, mass = 0.1, sprite = { file = "bird.png", width = 0.5 } })
for i = 1, 5 do
  scene:particle { family = birds, at = vec(1 - 2.3 * i, 3.1, -2 + 0.6 * i), velocity = vec(1.3, 0, 0) }
end
scene:field(birds, force.point { force = function(p, own, t)
  return vec(0, 0.981 + 0.4 * (3.1 - p.position.y) - 0.1 * p.velocity.y + 0.15 * math.sin(2 * t + 2 * p.position.z), 0)
end })
scene:on("step", function()
  for _, bird in ipairs(birds.particles) do
    if bird.position.x > 8 then bird.position = vec(-8, bird.position.y, bird.position.z) end
  end
end)
