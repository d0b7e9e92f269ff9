-- Newton's cradle: as many balls fly off at one side as fell in at the other. Drag any of them, or let more go at once.
local count = scene:param("balls", 5, { min = 2, max = 12, step = 1, help = "of the cradle" })
local raised = scene:param("raised", 2, { min = 1, max = 6, step = 1, help = "balls that are let go" })
local loss = scene:param("restitution", 1, { min = 0, max = 1, help = "of all balls" })

scene.title = "Newton's cradle"
scene.duration = 20
scene.camera = { at = vec(1.2, 1.1, 3.2), look_at = vec(0, 0.75, 0) }
scene:floor { color = "#d6d3cb" }

local radius, long, gap = 0.12, 1, 1e-5
local apart, top = 2 * radius + gap, 1.35
local half = (count - 1) * apart / 2

-- The frame stands behind and before the balls, and touches none.
local bars = {}
local reach, deep = half + 0.3, 0.35
for side = -1, 1, 2 do
  local z = deep * side
  bars[#bars + 1] = shape.capsule { radius = 0.025, from = vec(-reach, top, z), to = vec(reach, top, z) }
  for ending = -1, 1, 2 do
    bars[#bars + 1] = shape.capsule { radius = 0.025, from = vec(reach * ending, 0, z), to = vec(reach * ending, top, z) }
  end
end
scene:ground { shapes = bars, color = "#6d5235" }

-- Each ball hangs on two strings that part towards the frame, and so swings in a plane.
local balls = {}
for i = 1, count do
  local x = (i - 1) * apart - half
  local anchor = vec(x, top, 0)
  local turn = quat(vec(0, 0, 1), i <= raised and -0.6 or 0)
  balls[i] = scene:ball { radius = radius, density = 7800, friction = 0, restitution = loss, color = "#b9c2cc",
                          at = anchor + turn:rotate(vec(0, -long, 0)), orientation = turn, points = { eye = { at = vec(0, 0, 0), radius = 0.02 } } }
  for side = -1, 1, 2 do scene:string { balls[i].eye, vec(x, top, deep * side) } end
end

local function angle(i) -- from the vertical, rad
  local way = balls[i].position - vec((i - 1) * apart - half, top, 0)
  return math.atan(way.x, -way.y)
end
scene:probe("first", function() return angle(1) end)
scene:probe("last", function() return angle(count) end)
