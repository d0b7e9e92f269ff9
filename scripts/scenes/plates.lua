-- A heavy ball flies through plates that stand one behind the other; each breaks where it is hit, into pieces that are smaller
-- there. Drag a piece, throw another ball, or break everything into smaller pieces still.
local plates = scene:param("plates", 3, { min = 1, max = 8, step = 1, help = "that stand in a row" })
local pieces = scene:param("pieces", 18, { min = 2, max = 80, step = 1, help = "of each plate" })
local speed = scene:param("speed", 14, { min = 2, max = 60, help = "of the ball, m/s" })
local strength = scene:param("strength", 5, { min = 0, max = 200, help = "blow that a plate stands, N s" })

scene.title = "Plates"
scene.duration = 6
scene.camera = { at = vec(-1.5, 2.6, 7.5), look_at = vec(1.2, 0.8, 0) }
scene:floor { friction = 0.6, rolling = 0.01, color = "#cfd4d8" }

local colors = { "#8fc1d9", "#d9b48f", "#a9d98f", "#c49bd9" }
scene.store.broken = 0

local function break_up(plate, at)
  local color = plate.color
  for _, piece in ipairs(scene:shatter(plate, { pieces = pieces, seed = scene.store.broken + 1, at = at })) do piece.color = color end
  scene.store.broken = scene.store.broken + 1
end

local function set_up()
  for i = 1, plates do
    local plate = scene:box {
      size = vec(0.06, 1.6, 1.6), at = vec(1.2 * i - 1, 0.8, 0), density = 1000, friction = 0.5,
      color = colors[(i - 1) % #colors + 1],
    }
    -- What is told is told in the step after the blow, and a plate that is gone is told of no more. The floor, too, gives a
    -- large impulse, but at no speed.
    scene:on("touched", plate, function(touch)
      if touch.impulse > strength and touch.speed > 0.5 and plate.alive then break_up(plate, touch.at) end
    end)
  end
end
local function throw(height)
  scene:ball { radius = 0.18, density = 7800, at = vec(-3, height, 0.1), velocity = vec(speed, 1.2, 0), color = "#444b52" }
end
local function throw_somewhere() throw(0.4 + 0.8 * math.random()) end
set_up()
throw(1)

-- What is broken is cleared away, and others stand there.
scene:every(8, function()
  for _, body in ipairs(scene.bodies) do body:remove() end
  set_up()
  scene:after(1, throw_somewhere)
end)
scene:button("throw", throw_somewhere)
scene:probe("broken plates", function() return scene.store.broken end)
scene:probe("bodies", function() return #scene.bodies end)
