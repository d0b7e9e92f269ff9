-- A coin spun on its edge: it slows down, lies down, and the lower it lies the faster the point on which it rolls goes round, until
-- it rings and stops (Euler's disc). Rolling and spinning friction take its energy; it slips only at the start.
local rate = scene:param("spin", 40, { min = 5, max = 80, help = "about the vertical at the start, rad/s" })
local rolling = scene:param("rolling", 0.2, { min = 0, max = 2, help = "friction against rolling, mm" }) / 1000
local spinning = scene:param("spinning", 1, { min = 0, max = 5, help = "friction against spinning, mm" }) / 1000

scene.title = "Coin"
scene.duration = 15
scene.step = 1 / 3000
scene:floor { friction = 0.5, size = 2, color = "#cbb894" }

local radius, thickness, tilt = 0.05, 0.008, 1.45
local coin = scene:body {
  shapes = {
    shape.cylinder { radius = radius, length = thickness, density = 8000, friction = 0.5, rolling = rolling, spinning = spinning,
                     color = "#d9b44a" },
  },
  at = vec(0, radius * math.sin(tilt) + 0.5 * thickness * math.cos(tilt), 0), orientation = quat(vec(1, 0, 0), tilt),
  spin = vec(0, rate, 0), name = "coin",
}
scene.camera = { at = vec(0.05, 0.16, 0.3), look_at = vec(0, 0.02, 0), follow = coin }

local function face() return coin.orientation:rotate(vec(0, 1, 0)) end
local pitch, last = 0, face()
scene:on("step", function()
  local now = face()
  local turned = math.atan(now.x * last.z - now.z * last.x, now.x * last.x + now.z * last.z)
  if now.x ^ 2 + now.z ^ 2 > 1e-8 then pitch = pitch + 0.01 * (math.abs(turned) / scene.step - pitch) end
  last = now
end)
scene:probe("pitch", function() return pitch end)
scene:probe("lies at", function() return math.acos(math.min(1, math.abs(face().y))) end)
scene:probe("spin", function() return coin.spin:length() end)

local function start()
  coin.position = vec(0, radius * math.sin(tilt) + 0.5 * thickness * math.cos(tilt), 0)
  coin.orientation, coin.velocity, coin.spin = quat(vec(1, 0, 0), tilt), vec(0, 0, 0), vec(0, rate, 0)
  last = face()
end
scene:every(15, start)
scene:button("spin it again", start)
