-- A steam engine on springs: two pistons slide in its frame and turn a flywheel. Keys up and down let in more steam or less, left
-- and right turn it the other way. The frame dances most at 2 turns a second: go through that quickly. Drag the wheel, cut a rod.
local steam = scene:param("steam", 600, { min = 0, max = 2000, help = "push on each piston, N" })
local load = scene:param("load", 12, { min = 1, max = 100, help = "of the flywheel, N m s" })
scene.title, scene.duration, scene.camera = "Steam engine", 60, { at = vec(0.3, 0.9, 5.2), look_at = vec(0, 0.3, 0) }
local x, y, z, lean, throw, length = vec(1, 0, 0), vec(0, 1, 0), vec(0, 0, 1), math.pi / 4, 0.3, 1.0 -- rad, m, m
local iron, brass, steel, red = "#4a5560", "#c9a23f", "#b8bec4", "#a83a32"
scene:floor { height = -1.1, color = "#8a8f7a" }
scene:collide("engine", "engine", false)

-- The frame: a bed and two cylinders that lean apart, each of two bars, on four springs with dampers.
local along = { vec(-math.sin(lean), math.cos(lean), 0), vec(math.sin(lean), math.cos(lean), 0) }
local shapes, points = { shape.box(2.4, 0.16, 1, { at = -0.62 * y }), shape.box(0.24, 0.7, 0.1, { at = -0.2 * y - 0.4 * z }) }, { axle = vec(0, 0, 0) }
for i, up in ipairs(along) do
  for side = -1, 1, 2 do
    shapes[#shapes + 1] = shape.box(0.06, 1.1, 0.3, { at = 1.15 * up + side * 0.19 * z:cross(up), orientation = quat(z, i == 1 and lean or -lean) })
  end
  points["head" .. i] = 1.7 * up
end
for i = 1, 4 do points["foot" .. i] = vec(i % 2 == 0 and 1.1 or -1.1, -0.7, i > 2 and 0.4 or -0.4) end
local frame = scene:body { name = "frame", mass = 150, points = points, shapes = shapes, layer = "engine", color = iron }
for i = 1, 4 do
  local foot = frame["foot" .. i]
  scene:connect(foot, foot.position + 0.06 * y, force.spring { stiffness = 1e4, damping = 200, length = 0 })
end

-- The flywheel with its crank, and for each cylinder a rod and a piston that slides along the frame without turning in it.
local wheel = scene:body { name = "flywheel", mass = 60, layer = "engine", points = { hub = vec(0, 0, 0), pin = throw * x }, shapes = {
  shape.cylinder(0.5, 0.1, { at = -0.22 * z, orientation = quat(x, math.pi / 2), color = red }), shape.box(0.8, 0.14, 0.04, { at = -0.15 * z, color = steel }) } }
scene:hinge(frame.axle, wheel.hub, { axis = z })
local pins, cylinders = { wheel.pin }, {}
for i, up in ipairs(along) do
  local pin, way = wheel.pin.position, up:dot(wheel.pin.position)
  local at = (way + math.sqrt(length ^ 2 - pin:dot(pin) + way ^ 2)) * up -- so far along its line that the rod reaches the pin
  local piston = scene:body { name = "piston " .. i, at = at, mass = 5, layer = "engine", color = brass, points = { pin = vec(0, 0, 0) },
                              shapes = { shape.box(0.3, 0.2, 0.26, { orientation = quat(z, i == 1 and lean or -lean) }) } }
  local rod = scene:body { name = "rod " .. i, at = 0.5 * (at + pin), mass = 3, layer = "engine", color = steel,
                           points = { big = 0.5 * (pin - at), small = 0.5 * (at - pin) }, shapes = { shape.capsule { radius = 0.03, from = 0.5 * (pin - at), to = 0.5 * (at - pin) } } }
  scene:hinge(piston.pin, rod.small)
  pins[#pins + 1] = rod.big
  scene:slider(piston.pin, frame, { axis = up })
  cylinders[i] = { piston = piston.pin, head = frame["head" .. i], up = up }
end
scene:hinge(pins[1], pins[2], pins[3])

-- The valves: steam pushes a piston away from the head on its way down, and towards it on its way up.
local share, way, keys = 1, -1, scene.keys -- turns as a clock
scene:on("step", function(dt)
  share = math.max(0, math.min(1.5, share + ((keys.up and 1 or 0) - (keys.down and 1 or 0)) * dt))
  way = keys.left and 1 or keys.right and -1 or way
  local pin, braked = wheel.pin.position - wheel.hub.position, load * (wheel.spin - frame.spin)
  wheel:twist(-braked) frame:twist(braked)
  for _, c in ipairs(cylinders) do
    local up = c.head.position - frame.axle.position
    local push = -way * share * steam * up:cross(pin).z / (throw * up:length()) * up:normalized() -- as the crank goes, and so smooth
    c.piston:push(push) c.head:push(-push)
  end
end)
scene:probe("turns per second", function() return wheel.spin.z / (2 * math.pi) end)
