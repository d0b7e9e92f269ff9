-- A top on its tip: it leans, turns about the vertical and nods, and does not fall while it spins. Touch it.
local rate = scene:param("spin", 120, { min = 0, max = 400, help = "spin about its own axis, rad/s" })
local lean = scene:param("lean", 0.35, { min = 0, max = 1.2, help = "angle from the vertical, rad" })

scene.title = "Top"
scene.duration = 10
scene.step = 1 / 1000
scene.camera = { at = vec(1.1, 1.0, 2.2), look_at = vec(0, 0.45, 0) }

local tilt = quat(vec(0, 0, 1), -lean)
local axis = tilt:rotate(vec(0, 1, 0))

-- A turned body: rings of points give its outline, the widest one its mass; the tip is an anchor without mass.
local points = {
  tip = { at = vec(0, 0, 0), radius = 0.03, color = "#3a3f47" },
  knob = { at = vec(0, 0.72, 0), mass = 0.02, radius = 0.07, color = "#f2b45c" },
}
local sides = 24
local function ring(height, radius, mass, size)
  for i = 1, sides do
    local a = 2 * math.pi * i / sides
    points[#points + 1] = {
      at = vec(radius * math.cos(a), height, radius * math.sin(a)), mass = mass,
      radius = i % 6 == 0 and size or 0, color = i % 6 == 0 and "#f2b45c" or "#c2413b",
    }
  end
end
ring(0.50, 0.42, 0.8 / sides, 0.04)
local outline = { 0.06, 0.03, 0.22, 0.16, 0.36, 0.32, 0.44, 0.40, 0.56, 0.40, 0.62, 0.32, 0.67, 0.16 } -- heights, radii
for i = 1, #outline, 2 do ring(outline[i], outline[i + 1], 0, 0) end

local top = scene:body { points = points, orientation = tilt, spin = axis * rate, color = "#e8833a", name = "top" }
scene:nail(top.tip)

local function leaning() -- angle from the vertical, rad
  local up = (top.knob.position - top.tip.position):normalized()
  return math.acos(math.min(1, up.y))
end

scene:probe("lean", leaning)
scene:probe("spin about the vertical", function() return top.angular_momentum.y end)
scene:button("flick", function() top:twist(axis * 5) end)
