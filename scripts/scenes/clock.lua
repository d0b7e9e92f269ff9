-- A clock: a weight drives the escape wheel. At each swing the anchor of the pendulum lets one tooth go and catches another, and
-- the tooth that slips off pushes the pendulum on (George Graham's escapement, about 1715). Hold the pendulum, or make it longer.
local load = scene:param("weight", 0.3, { min = 0.05, max = 2, help = "that drives it, kg" })
local long = scene:param("length", 0.993, { min = 0.6, max = 1.2, help = "of the pendulum, m" })

scene.title, scene.duration = "Clock", 60
scene.plane, scene.step, scene.contact = "xy", 1 / 480, "exact"
scene.camera = { at = vec(0.12, -0.08, 2.3), look_at = vec(0.12, -0.08, 0) }

local z, teeth, radius, drum, brass = vec(0, 0, 1), 15, 0.35, 0.06, "#c9a227"
local half = math.rad(42) -- from the middle to a pallet: the two are three and a half teeth apart
local pivot, reach, pitch = vec(0, radius / math.cos(half), 0), radius * math.tan(half), 2 * math.pi * radius / teeth
local thick, slope, lock = 0.39 * pitch, 0.13 * reach, 0.03 * reach
local function at(angle, far) return far * vec(math.cos(angle), math.sin(angle), 0) end
local function disc(far, place, density, color) return shape.cylinder { radius = far, length = 0.02, axis = z, at = place, density = density, color = color } end
local function plate(points, color) return shape.polygon { points = points, thickness = 0.04, friction = 0.05, density = 500, color = color } end

-- The escape wheel turns clockwise; its teeth lean forward, so that their tips alone touch. One rests on the left pallet.
local parts = { disc(0.75 * radius, -0.06 * z, 500, brass), disc(drum, -0.1 * z, 500, "#8a6d1d") }
for i = 1, teeth do
  local a = 2 * math.pi * i / teeth + math.pi / 2 + half + thick / (2 * radius) + 0.01
  parts[#parts + 1] = plate({ at(a, radius), at(a + 0.06, 0.72 * radius), at(a + 0.22, 0.72 * radius) }, brass)
end
local wheel = scene:body { mass = 0.1, shapes = parts, points = { hub = vec(0, 0, 0) }, name = "wheel" }
scene:nail(wheel.hub)

-- The anchor, on the tangents to the wheel at the pallets, and the pendulum. A tooth rests on the side of a pallet until its
-- corner lets it go, and slides down the slope of its end.
local bob, air, red = vec(0, -long, 0), scene:family "air", "#a33b2f"
parts = { shape.capsule { radius = 0.008, from = 0.1 * z, to = bob + 0.1 * z, density = 100, color = "#8d99a6" }, disc(0.1, bob + 0.1 * z, 4000, brass) }
for _, way in ipairs { -1, 1 } do
  local out, down = vec(way * math.cos(half), -math.sin(half), 0), vec(-way * math.sin(half), -math.cos(half), 0)
  local near, far, corner, back = reach - way * thick / 2, reach + way * thick / 2, lock - slope / 2, -0.25 * radius
  parts[#parts + 1] = plate({ out * near + down * corner, out * far + down * (corner + slope), out * far + down * back, out * near + down * back }, red)
  parts[#parts + 1] = shape.capsule { radius = 0.02, from = vec(0, 0, 0), to = out * reach + down * back, density = 500, color = red }
end
local pendulum = scene:body { at = pivot, shapes = parts, points = { pivot = vec(0, 0, 0), bob = { at = bob, family = air } },
                              orientation = quat(z, 0.16), name = "pendulum" }
scene:nail(pendulum.pivot)
scene:field(air, force.drag { linear = 0.15 })

-- The weight hangs on the drum over a pulley; where it is down it is wound up.
local weight, turned = nil, 0 -- the latter in rad
local function wind()
  if weight and weight.alive then weight:remove() end
  weight = scene:particle { at = vec(0.56, 0.3, 0), mass = load, radius = 0.06, color = "#4b5563" }
  scene:rack(wheel, weight, { radius = drum, along = vec(0, 1, 0) })
end
wind()
scene:button("wind", wind)
scene:on("step", function(dt)
  if not weight.alive or weight.position.y < -0.7 then wind() end
  turned = turned - wheel.spin.z * dt
  for i = 1, 60 do scene.draw:line(at(math.pi * i / 30, i % 5 == 0 and 0.37 or 0.39), at(math.pi * i / 30, 0.4), { color = "#777777" }) end
  scene.draw:line(vec(0, 0, 0), at(math.pi / 2 - turned / 2, 0.3), { color = "#d8573c", width = 4 }) -- once a minute
  for _, from in ipairs { vec(drum, 0, 0), weight.position } do scene.draw:line(from, vec(0.56, 0, 0), { color = "#8a6d1d" }) end
end)
scene:probe("seconds shown", function() return 15 * turned / math.pi end)
scene:probe("swing", function() return 2 * math.asin(pendulum.orientation.z) end)
