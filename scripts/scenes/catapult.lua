-- A trebuchet: a heavy weight pulls down the short arm, the long one swings up against a beam, and what lies in its bowl flies
-- at a wall of blocks. Then it is wound back for another, heavier one.
local weight = scene:param("weight", 1000, { min = 50, max = 10000, help = "that pulls, kg" })
local stone = scene:param("stone", 40, { min = 1, max = 200, help = "the first that flies, kg" })
local distance = scene:param("distance", 14, { min = 6, max = 60, help = "of the wall, m" })

scene.title, scene.duration = "Catapult", 10
scene.camera = { at = vec(19.5, 4.5, 9.5), look_at = vec(8, 1.9, 0) }
scene:floor { friction = 0.7, rolling = 0.01, color = "#b7c39a" }

-- Trestles hold the axle and the beam at which the arm stops, 15 degrees before the vertical.
local axle, short, long, up, across = vec(0, 2.4, 0), 0.9, 3, vec(-0.259, 0.966, 0), vec(0.966, 0.259, 0)
local beam, z = axle + 1.4 * up + 0.22 * across, vec(0, 0, 0.8)
local parts = { shape.capsule { radius = 0.12, from = beam - z, to = beam + z } }
for _, foot in ipairs { vec(-1.3, 0, 0), vec(1.3, 0, 0), beam } do
  parts[#parts + 1] = shape.capsule { radius = 0.09, from = axle + z, to = foot + z }
  parts[#parts + 1] = shape.capsule { radius = 0.09, from = axle - z, to = foot - z }
end
scene:ground { shapes = parts, color = "#8d6b45" }

local back = quat(vec(0, 0, 1), math.pi + 0.7) -- of the arm, whose x points to its bowl
local bowl, wall = vec(long - 0.25, 0, 0), 0.03
local function board(x, y, z, at) return shape.box(x, y, z, { at = bowl + at, density = 500 }) end
local arm = scene:body {
  at = axle, orientation = back, name = "arm",
  shapes = {
    shape.box(long + short, 0.16, 0.2, { at = vec((long - short) / 2, 0, 0), density = 500, color = "#a67c4e" }),
    board(0.5, wall, 0.5, vec(0, -0.1, 0)), board(wall, 0.2, 0.5, vec(0.25, -0.2, 0)), board(wall, 0.2, 0.5, vec(-0.25, -0.2, 0)),
    board(0.5, 0.2, wall, vec(0, -0.2, 0.25)), board(0.5, 0.2, wall, vec(0, -0.2, -0.25)),
  },
  points = { left = vec(0, 0, 0.7), right = vec(0, 0, -0.7), tip = vec(long, 0, 0), root = vec(-short, 0, 0) },
}
scene:nail(arm.left) scene:nail(arm.right)
local load = scene:box { size = vec(0.8, 0.8, 0.9), mass = weight, at = arm.root.position - vec(0, 0.6, 0), color = "#4b5563",
                         points = { eye = vec(0, 0.6, 0) } }
scene:hinge(arm.root, load.eye)

local low, shot, shots = arm.tip.position, nil, {}
scene:play(function(wait)
  while arm.alive do
    shot = scene:ball { radius = 0.17, mass = stone, friction = 0.5, color = "#374151",
                        at = axle + arm.orientation:rotate(bowl - vec(0, 0.115 + 0.17, 0)) }
    shots[#shots + 1] = shot
    if #shots > 6 then table.remove(shots, 1):remove() end
    local latch = scene:rod(arm.tip, vec(low.x, 0, 0))
    wait(1) latch:remove() wait(6)
    local from, since = arm.tip.position, scene.time
    local function wound(t) return from + (low - from) * math.min(1, (t - since) / 4) end
    local winch = scene:follow(arm.tip, wound, { max_force = 30 * weight })
    wait(5) winch:remove() stone = math.min(1.3 * stone, 400)
  end
end)
for row = 0, 5 do
  for column = -2, 2 - row % 2 do
    scene:box { size = vec(0.5, 0.5, 0.79), density = 80, color = ({ "#b5533c", "#c9714f", "#d98e63" })[(row + column) % 3 + 1],
                at = vec(distance, 0.25 + 0.5 * row, 0.8 * column + 0.4 * (row % 2)) }
  end
end
scene:probe("speed of the stone", function() return shot.alive and shot.velocity:length() or 0 end)
