-- A workshop: a motor turns a crank, whose rod drives a slider along a rail; a weight hangs on a string over two pulleys;
-- a cart of the roller coaster runs round its track; a door swings on its hinges between two stops. Drag anything.
local torque = scene:param("torque", 40, { min = 0, max = 200, help = "greatest torque of the motor, N m" })
local speed = scene:param("speed", 4, { min = -15, max = 15, help = "speed of the crank, rad/s" })

scene.title, scene.duration = "Machines", 20
scene.camera = { at = vec(0.6, 1.2, 9), look_at = vec(0.2, 0.5, 0) }

local function bar(from, to, mass, color)
  local half = 0.5 * (to - from)
  local l2 = mass * (to - from):dot(to - from) / 12
  local inertia = half.x ~= 0 and vec(0.05 * l2, l2, l2) or vec(l2, 0.05 * l2, l2)
  return scene:body { at = from + half, mass = mass, inertia = inertia, color = color,
                      points = { a = -half, b = half } }
end

-- Crank, rod and slider.
local crank = bar(vec(-3, 0, 0), vec(-2.5, 0, 0), 1, "#c2413b")
local rod = bar(vec(-2.5, 0, 0), vec(-1, 0, 0), 0.5, "#3f6f9f")
local slider = scene:particle { at = vec(-1, 0, 0), mass = 2, radius = 0.12, color = "#e8833a" }
scene:nail(crank.a)
scene:hinge(crank.b, rod.a)
scene:hinge(rod.b, slider)
scene:on_path(slider, { vec(-2.6, 0, 0), vec(-0.6, 0, 0) })
local motor = scene:motor(crank, { axis = vec(0, 0, 1), speed = speed, max_torque = torque })

-- The slider's string goes over two pulleys and lifts a weight.
local weight = scene:particle { at = vec(0.6, -0.6, 0), mass = 0.7, radius = 0.14, color = "#6b8e5a" }
scene:string({ slider, vec(-0.3, 0, 0), vec(-0.3, 1.6, 0), vec(0.6, 1.6, 0), weight })

-- A track, and a cart on it.
local track = {}
for i = 0, 39 do
  local u = 2 * math.pi * i / 40
  track[#track + 1] = vec(2.4 + 1.2 * math.sin(u), 1.1 - 0.9 * math.cos(u), 0.5 * math.sin(2 * u))
end
local cart = scene:particle { at = track[12], mass = 1, radius = 0.1, color = "#8a5a9e" }
scene:on_path(cart, track, { smooth = true, closed = true })

-- a door on a hinge with an axis stops at a right angle to either side.
local wall = scene:body { at = vec(1.2, -1.2, 0), mass = 5, inertia = vec(1, 0.02, 1), color = "#777",
                          points = { low = vec(0, -0.7, 0), high = vec(0, 0.7, 0) } }
local door = scene:body { at = vec(1.75, -1.2, 0), mass = 3, inertia = vec(0.5, 0.8, 0.4), color = "#b98a50",
                          points = { low = vec(-0.55, -0.7, 0), high = vec(-0.55, 0.7, 0), rim = vec(0.55, 0, 0),
                                     top = vec(0.55, 0.7, 0), sill = vec(0.55, -0.7, 0) } }
scene:nail(wall.low)
scene:orient(wall)
scene:hinge(wall.low, door.low, { axis = vec(0, 1, 0) })
scene:limit(door, wall, { axis = vec(0, 1, 0), min = -math.pi / 2, max = math.pi / 2 })
door:kick(vec(0, 0, 4), door.rim.position)

scene:probe("crank speed", function() return crank.spin.z end)
scene:probe("torque", function() return motor.torque.z end)
scene:probe("weight height", function() return weight.position.y end)
scene:probe("cart speed", function() return cart.velocity:length() end)

local labels = { ["motor and crank"] = vec(-3.5, -0.7, 0), ["slider on a rail"] = vec(-1.7, -0.4, 0), ["weight on a string"] = vec(-0.6, 2, 0),
                 ["cart on a track"] = vec(1.9, 1.2, 0), ["door that stops at a right angle"] = vec(1.9, -0.9, 0) }
scene:on("step", function() for label, at in pairs(labels) do scene.draw:text(at, label, { size = 15 }) end end)
