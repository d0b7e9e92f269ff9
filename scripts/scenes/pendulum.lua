-- A pendulum beside a double one: the first keeps time, the second is chaos. Each end draws where it was in the last seconds.
-- Drag a ball and let it go; a tap on the key j gives the single one a push.
scene.title = "Pendulum and double pendulum"
scene.duration = 20
scene.dark = true
scene.camera = { at = vec(0.2, -0.5, 7.5), look_at = vec(0.2, -0.5, 0) }

local rods = scene:group "rods"

local function pendulum(pivot, colours)
  local above, bobs = pivot, {}
  for i, colour in ipairs(colours) do
    local bob = scene:particle { at = pivot + vec(i, 0, 0), mass = 1, radius = 0.13, color = colour }
    rods:add(scene:rod(above, bob))
    above, bobs[i] = bob, bob
  end
  return bobs
end

local single = pendulum(vec(-2, 0, 0), { "#5b9bd5" })[1]
local double = pendulum(vec(1, 0, 0), { "#e8833a", "#f2c14e" })

-- A trail: where a ball was, every 1/60 s for 4 s, the older the fainter.
local function trail(ball, red, green, blue)
  local places, newest, kept = {}, 0, 240
  scene:every(1 / 60, function()
    newest = newest + 1
    places[newest], places[newest - kept] = ball.alive and ball.position or nil, nil
  end)
  scene:on("step", function()
    for i = math.max(2, newest - kept + 2), newest do
      local from, to = places[i - 1], places[i]
      if from and to then
        scene.draw:line(from, to, { color = { red, green, blue, 1 - (newest - i) / kept }, width = 2 })
      end
    end
  end)
end
trail(single, 0.36, 0.61, 0.84)
trail(double[2], 0.95, 0.76, 0.3)

local function angle(from, to) -- from the downward vertical, rad
  local d = to - from
  return math.atan(d.x, -d.y)
end
scene:probe("single angle", function() return angle(vec(-2, 0, 0), single.position) end)
scene:probe("first angle", function() return angle(vec(1, 0, 0), double[1].position) end)
scene:probe("second angle", function() return angle(double[1].position, double[2].position) end)

scene:on("key", "j", function() single:kick(vec(0, 0, 1)) end)
