-- The differential of a car's axle: the engine turns a cage, in which a small wheel rolls between the two half axles. They need
-- not turn alike, only their mean is that of the cage. Every 6 s a brake holds another wheel: the other turns twice as fast.
local speed = scene:param("speed", 3, { min = -10, max = 10, help = "of the cage, rad/s" })

scene.title, scene.duration = "Differential", 24
scene.camera = { at = vec(0.6, 2.2, 5.2), look_at = vec(0, 0.1, 0) }
local x, y, z = vec(1, 0, 0), vec(0, 1, 0), vec(0, 0, 1)

--- A round body about an axis of the world, with spokes, that nothing touches.
local function wheel(at, axis, radius, width, color)
  local function of(r, wide, tint, turn)
    return shape.cylinder { radius = r, length = wide, axis = axis, orientation = turn, color = tint, layer = "gears" }
  end
  local along = axis.x ~= 0 and y or axis.y ~= 0 and x or x
  return scene:body { at = at, mass = 4, color = color, points = { hub = vec(0, 0, 0) },
    shapes = { of(radius, width, color), shape.box(vec(0.1, 0.1, 0.1) + along * (1.9 * radius), { at = axis * (0.5 * width), layer = "gears", color = "#f4efe2" }) } }
end
scene:collide("gears", "gears", false)
local function on_axle(body, axis)
  scene:nail(body.hub) scene:align(body, axis, axis, { angle = 0 })
end

-- Half axles: a wheel outside, a bevel gear inside, turning as one body.
local halves = {}
for i, way in ipairs { -1, 1 } do
  local half = wheel(vec(1.6 * way, 0, 0), x * way, 0.75, 0.25, i == 1 and "#3f6f9f" or "#c2413b")
  local gear = wheel(vec(0.45 * way, 0, 0), x * -way, 0.3, 0.1, i == 1 and "#7fb0dd" or "#e98b80")
  local axle = scene:body { at = vec(way, 0, 0), color = "#8b8f98", mass = 1, shape = shape.cylinder { radius = 0.06, length = 1.2, axis = x, layer = "gears" } }
  halves[i] = scene:merge(scene:merge(half, gear), axle)
  on_axle(halves[i], x)
end

-- The cage: a ring that carries the small wheel's axle. A pinion of the engine turns it round a corner.
local cage = scene:body { at = vec(0, 0, 0), mass = 6, color = "#e0b040", points = { hub = vec(0, 0, 0), pin = vec(0, 0.42, 0) }, shapes = {
  shape.cylinder { radius = 0.7, length = 0.08, axis = x, at = vec(-0.75, 0, 0), layer = "gears", color = "#e0b04066" },
  shape.box(0.8, 0.06, 0.12, { at = vec(-0.4, 0.55, 0), layer = "gears" }), shape.box(0.8, 0.06, 0.12, { at = vec(-0.4, -0.55, 0), layer = "gears" }) } }
on_axle(cage, x)
local spider = wheel(vec(0, 0.42, 0), y, 0.3, 0.1, "#6b8e5a")
scene:hinge(cage.pin, spider.hub, { axis = y })
local engine = wheel(vec(-0.75, 0, 0.95), z, 0.25, 0.3, "#4b5563")
on_axle(engine, z)
scene:gear(engine, cage, { ratio = -0.7 / 0.25, axis = z, axis_b = x })
scene:motor(engine, { axis = z, speed = -speed * 0.7 / 0.25, max_torque = 60 })

-- Against the cage the halves turn one as the other turns back, by the wheel between them.
scene:gear(halves[1], spider, { ratio = 1, axis = x, axis_b = y, carrier = cage })
scene:gear(halves[2], spider, { ratio = -1, axis = x, axis_b = y, carrier = cage })
local brakes = {}
for i, half in ipairs(halves) do brakes[i] = scene:motor(half, { axis = x, speed = 0, max_torque = 0.5 }) end
local function hold(side) for i, brake in ipairs(brakes) do brake.max_torque = side == i and 200 or 0.5 end end
scene:every(6, function() hold(math.floor(scene.time / 6 + 0.5) % 3) end) -- none, left, right
scene:on("step", function()
  for i, half in ipairs(halves) do
    scene.draw:text(half.position + vec(-0.3, 1.15, 0), ("%.1f rad/s%s"):format(half.spin.x, brakes[i].max_torque > 1 and "\nheld" or ""), { size = 17 })
  end
  scene.draw:text(vec(-0.6, 1.05, 0), ("cage %.1f rad/s"):format(cage.spin.x), { size = 17, color = "#a07a18" })
end)
for i, side in ipairs { "left", "right" } do scene:probe(side, function() return halves[i].spin.x end) end
scene:probe("cage", function() return cage.spin.x end)
