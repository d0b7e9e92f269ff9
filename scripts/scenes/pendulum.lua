-- A pendulum beside a double one: the first keeps time, the second is chaos. Drag a ball and let it go.
scene.title = "Pendulum and double pendulum"
scene.duration = 20
scene.camera = { at = vec(0.6, -0.5, 7.5), look_at = vec(0.6, -0.7, 0) }

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

local single = pendulum(vec(-2, 0, 0), { "#3f6f9f" })[1]
local double = pendulum(vec(1, 0, 0), { "#e8833a", "#c2413b" })

local function angle(from, to) -- from the downward vertical, rad
  local d = to - from
  return math.atan(d.x, -d.y)
end

scene:probe("single angle", function() return angle(vec(-2, 0, 0), single.position) end)
scene:probe("first angle", function() return angle(vec(1, 0, 0), double[1].position) end)
scene:probe("second angle", function() return angle(double[1].position, double[2].position) end)

-- A tap on the key j gives the single one a push.
scene:on("key", "j", function() single:kick(vec(0, 0, 1)) end)
