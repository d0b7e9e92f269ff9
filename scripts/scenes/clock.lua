-- A clock: a weight drives the escape wheel. At each swing the anchor of the pendulum lets one tooth go and catches another, and
-- the tooth that slips off pushes the pendulum on (George Graham's escapement, about 1715). The red hand turns once a minute.
local load = scene:param("weight", 0.3, { min = 0.05, max = 2, help = "that drives it, kg" })
local long = scene:param("length", 0.99, { min = 0.6, max = 1.2, help = "of the pendulum, m" })

scene.title, scene.duration = "Clock", 60
scene.plane, scene.step, scene.contact = "xy", 1 / 480, "exact"
scene.contact_sounds = "wood"
scene.camera = { at = vec(0.15, -0.05, 2.9), look_at = vec(0.1, -0.05, 0) }

local z, teeth, radius, drum = vec(0, 0, 1), 15, 0.35, 0.06
local half = math.rad(42) -- from the middle to a pallet: the two are three and a half teeth apart
local function at(angle, far) return far * vec(math.cos(angle), math.sin(angle), 0) end
local function disc(far, color, depth) return shape.cylinder { radius = far, length = 0.02, axis = z, at = depth * z, color = color } end

-- The escape wheel turns clockwise; its teeth lean forward, so that their tips alone touch.
local parts = { disc(0.8 * radius, "#c9a227", -0.06), disc(drum, "#8a6d1d", -0.1) }
for i = 1, teeth do
  local a = 2 * math.pi * i / teeth
  local tooth = { at(a, radius), at(a + 0.06, 0.75 * radius), at(a + 0.22, 0.75 * radius) }
  parts[#parts + 1] = shape.polygon { points = tooth, thickness = 0.04, friction = 0.05, color = "#c9a227" }
end
local wheel = scene:body { mass = 0.1, shapes = parts, points = { hub = vec(0, 0, 0) }, name = "wheel" }
scene:nail(wheel.hub)

-- The anchor, on the tangents to the wheel at the pallets. A tooth rests on the side of a pallet until its corner lets it go
-- and it slides down the slope of its end.
local reach, pitch = radius * math.tan(half), 2 * math.pi * radius / teeth
local thick, slope, lock = 0.39 * pitch, 0.13 * reach, 0.03 * reach
local rod, air = -long * vec(0, 1, 0), scene:family "air"
scene:field(air, force.drag { linear = 0.15 })
parts = { shape.capsule { radius = 0.008, from = 0.1 * z, to = rod + 0.1 * z, density = 100, color = "#8d99a6" },
          shape.cylinder { radius = 0.1, length = 0.04, axis = z, at = rod + 0.1 * z, density = 2000, color = "#c9a227" } }
for _, way in ipairs { -1, 1 } do
  local out, down = vec(way * math.cos(half), -math.sin(half), 0), vec(-way * math.sin(half), -math.cos(half), 0)
  local near, far = reach - way * thick / 2, reach + way * thick / 2 -- the side that locks, and the one that lets go
  local corner, back = lock - slope / 2, -0.25 * radius
  parts[#parts + 1] = shape.polygon { thickness = 0.04, friction = 0.05, density = 500, color = "#a33b2f",
    points = { out * near + down * corner, out * far + down * (corner + slope), out * far + down * back, out * near + down * back } }
  parts[#parts + 1] = shape.capsule { radius = 0.02, from = vec(0, 0, 0), to = out * reach + down * back, density = 500, color = "#a33b2f" }
end
local pendulum = scene:body { at = vec(0, radius / math.cos(half), 0), shapes = parts, points = { pivot = vec(0, 0, 0), bob = { at = rod, family = air } },
                              orientation = quat(z, 0.16), name = "pendulum" }
scene:nail(pendulum.pivot)

-- The weight's string goes from the drum over a pulley.
local weight
local function wind()
  if weight then weight:remove() end
  weight = scene:particle { at = vec(0.6, 0.3, 0), mass = load, radius = 0.07, color = "#4b5563" }
  scene:on_path(weight, { vec(0.6, 0.4, 0), vec(0.6, -1, 0) })
  scene:rack(wheel, weight, { radius = drum, along = vec(0, 1, 0) })
end
wind()
scene:button("wind", wind)

-- The hands are geared to the wheel; the dial is drawn.
local hands = {}
for i, ratio in ipairs { 1 / 2, 1 / 120 } do
  local depth, far = (0.14 + 0.02 * i) * z, i == 1 and 0.31 or 0.24
  local shown = shape.capsule { radius = 0.006 * i, from = depth, to = vec(0, far, 0) + depth, sensor = true }
  hands[i] = scene:body { mass = 0.01, shape = shown, points = { hub = vec(0, 0, 0) }, color = i == 1 and "#d8573c" or "#2f343c" }
  scene:nail(hands[i].hub)
  scene:gear(hands[i], wheel, { ratio = ratio })
end
scene:on("step", function()
  for i = 1, 60 do
    local a = math.pi * i / 30
    scene.draw:line(at(a, i % 5 == 0 and 0.36 or 0.385), at(a, 0.4), { color = "#555555", width = i % 15 == 0 and 4 or 2 })
  end
  local rope = { vec(drum, 0, 0), vec(0.6, 0.02, 0), weight.alive and weight.position }
  for i = 1, weight.alive and 2 or 0 do scene.draw:line(rope[i], rope[i + 1], { color = "#8a6d1d" }) end
end)
scene:probe("swing", function() return 2 * math.asin(pendulum.orientation.z) end) -- rad
