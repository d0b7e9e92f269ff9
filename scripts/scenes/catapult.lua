-- A trebuchet: a heavy weight pulls down the short arm, the long one swings up against a beam, and what lies in its bowl flies
-- at a wall of blocks.
local weight = scene:param("weight", 1000, { min = 50, max = 10000, help = "that pulls, kg" })
local stone = scene:param("stone", 40, { min = 1, max = 200, help = "that flies, kg" })
local distance = scene:param("distance", 14, { min = 6, max = 60, help = "of the wall, m" })

scene.title = "Catapult"
scene.duration = 10
scene.camera = { at = vec(19.5, 4.5, 9.5), look_at = vec(8, 1.9, 0) }
scene:floor { friction = 0.7, color = "#b7c39a" }

-- Two trestles hold the axle and, above, the beam at which the arm stops, 15 degrees before the vertical.
local axle, short, long = vec(0, 2.4, 0), 0.9, 3
local up, across = vec(-0.259, 0.966, 0), vec(0.966, 0.259, 0)
local beam = axle + 1.4 * up + 0.22 * across
local parts = { shape.capsule { radius = 0.12, from = beam - vec(0, 0, 0.8), to = beam + vec(0, 0, 0.8) } }
for side = -1, 1, 2 do
  local z = vec(0, 0, 0.8 * side)
  for _, foot in ipairs { vec(-1.3, 0, 0), vec(1.3, 0, 0), beam } do
    parts[#parts + 1] = shape.capsule { radius = 0.09, from = axle + z, to = foot + z }
  end
end
scene:ground { shapes = parts, color = "#8d6b45" }

-- The arm, drawn back: x points to its bowl.
local back = quat(vec(0, 0, 1), math.pi + 0.7)
local bowl, wall = vec(long - 0.25, 0, 0), 0.03
local arm = scene:body {
  at = axle, orientation = back, name = "arm",
  shapes = {
    shape.box(long + short, 0.16, 0.2, { at = vec((long - short) / 2, 0, 0), density = 500, color = "#a67c4e" }),
    shape.box(0.5, wall, 0.5, { at = bowl - vec(0, 0.1, 0), density = 500 }),
    shape.box(wall, 0.2, 0.5, { at = bowl + vec(0.25, -0.2, 0), density = 500 }),
    shape.box(wall, 0.2, 0.5, { at = bowl + vec(-0.25, -0.2, 0), density = 500 }),
    shape.box(0.5, 0.2, wall, { at = bowl + vec(0, -0.2, 0.25), density = 500 }),
    shape.box(0.5, 0.2, wall, { at = bowl + vec(0, -0.2, -0.25), density = 500 }),
  },
  points = { left = vec(0, 0, 0.7), right = vec(0, 0, -0.7), tip = vec(long, 0, 0), root = vec(-short, 0, 0) },
}
scene:nail(arm.left)
scene:nail(arm.right)
local load = scene:box { size = vec(0.8, 0.8, 0.9), mass = weight, at = arm.root.position - vec(0, 0.6, 0), color = "#4b5563",
                           points = { eye = vec(0, 0.6, 0) } }
scene:hinge(arm.root, load.eye)
local shot = scene:ball { radius = 0.17, mass = stone, friction = 0.5, color = "#374151", name = "stone",
                          at = axle + back:rotate(bowl - vec(0, 0.115 + 0.17, 0)) }

local latch = scene:rod(arm.tip, vec(arm.tip.position.x, 0, 0))
scene:at(1, function() latch:remove() end)

local colors = { "#b5533c", "#c9714f", "#d98e63" }
for row = 0, 5 do
  for column = -2, 2 - row % 2 do
    scene:box { size = vec(0.5, 0.5, 0.79), density = 80, at = vec(distance, 0.25 + 0.5 * row, 0.8 * column + 0.4 * (row % 2)),
                  color = colors[(row + column) % 3 + 1] }
  end
end
scene:probe("speed of the stone", function() return shot.velocity:length() end)
scene:probe("way of the stone", function() return shot.position.x end)
