-- A top on its tip: it leans, turns about the vertical and nods, and does not fall while it spins. Touch it.
local rate = scene:param("spin", 120, { min = 0, max = 400, help = "spin about its own axis, rad/s" })
local lean = scene:param("lean", 0.35, { min = 0, max = 1.2, help = "angle from the vertical, rad" })

scene.title = "Top"
scene.duration = 10
scene.step = 1 / 1000
scene.camera = { at = vec(1.1, 1.0, 2.2), look_at = vec(0, 0.45, 0) }

local tilt = quat(vec(0, 0, 1), -lean)
local axis = tilt:rotate(vec(0, 1, 0))

-- A wooden disc with a rim of sixteen masses, on a thin stick; the tip is an anchor without mass.
local points = { tip = vec(0, 0, 0), knob = { at = vec(0, 0.9, 0), mass = 0.02, radius = 0.05, color = "#c2413b" } }
local rim, radius = 16, 0.42
for i = 1, rim do
  local a = 2 * math.pi * i / rim
  points[i] = {
    at = vec(radius * math.cos(a), 0.5, radius * math.sin(a)), mass = 0.05, radius = 0.035,
    color = i % 4 == 0 and "#f2b45c" or "#3f6f9f",
  }
end

local top = scene:body { points = points, orientation = tilt, spin = axis * rate, color = "#e8833a", name = "top" }
scene:nail(top.tip)

local function leaning() -- angle from the vertical, rad
  local up = (top.knob.position - top.tip.position):normalized()
  return math.acos(math.min(1, up.y))
end

scene:probe("lean", leaning)
scene:probe("spin about the vertical", function() return top.angular_momentum.y end)
scene:button("flick", function() top:twist(axis * 5) end)
