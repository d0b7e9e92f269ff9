-- A workshop of gears: a crank turns a train of wheels and a planetary gear, round a corner a screw that lifts a stone, and a
-- rack that runs to and fro. Two more stones hang on a tackle. Drag any of it, cut any of it.
local speed = scene:param("speed", 3, { min = 0, max = 12, help = "of the crank, rad/s" })
local sun_speed = scene:param("sun", 0, { min = -6, max = 6, help = "of the sun of the planetary gear, rad/s" })

scene.title = "Gears"
scene.duration = 30
scene.camera = { at = vec(0.3, 0.6, 9), look_at = vec(0.3, 0, 0) }

local x, y, z = vec(1, 0, 0), vec(0, 1, 0), vec(0, 0, 1)

--- A wheel that turns about z; what is seen of it lies before its hub or behind it.
local function wheel(at, radius, color, mass, before)
  local points = { hub = { at = vec(0, 0, 0), mass = 0.1 } }
  for i = 1, 5 do
    local angle = 2 * math.pi * i / 5
    points[i] = 0.75 * radius * vec(math.cos(angle), math.sin(angle), 0) + (before or 0) * z
  end
  local moment = 0.5 * mass * radius * radius
  return scene:body { at = at, mass = mass, inertia = vec(moment / 2, moment / 2, moment), points = points, color = color }
end
local function on_axle(body)
  scene:nail(body.hub)
  scene:align(body, z, z, { angle = 0 })
  return body
end

-- The train: wheels that mesh turn against each other, the larger one slower.
local crank = on_axle(wheel(vec(-2.9, 0.7, 0), 0.35, "#c2413b", 1))
local middle = on_axle(wheel(vec(-1.85, 0.7, 0), 0.7, "#e8833a", 2))
local low = on_axle(wheel(vec(-1.85, -0.65, 0), 0.65, "#8a5a9e", 2))
local idler = on_axle(wheel(vec(-0.85, 0.7, 0), 0.3, "#c2413b", 1))
scene:gear(crank, middle, { ratio = -0.7 / 0.35, axis = z })
scene:gear(middle, low, { ratio = -0.65 / 0.7, axis = z })
scene:gear(middle, idler, { ratio = -0.3 / 0.7, axis = z })
local motor = scene:motor(crank, { axis = z, speed = speed, max_torque = 80 })

-- The rack: at its ends the crank turns round.
local slider = scene:particle { at = vec(-1.85, -1.3, 0), mass = 1.5, radius = 0.08, color = "#6b8e5a" }
scene:on_path(slider, { vec(-3.6, -1.3, 0), vec(0, -1.3, 0) })
scene:rack(low, slider, { radius = 0.65, axis = z, along = x })
scene:on("step", function()
  local at, v = slider.position.x, slider.velocity.x
  if (at > -0.8 and v > 0) or (at < -2.9 and v < 0) then motor.speed = -motor.speed end
end)

-- The planetary gear: three planets on an arm roll between a sun and a ring; the idler turns the ring from outside.
local centre = vec(0.45, 0.7, 0)
local ring = on_axle(wheel(centre, 1.0, "#999999", 2, -0.3))
local sun = on_axle(wheel(centre, 0.3, "#e0b040", 0.5, 0.05))
local pins = { hub = { at = vec(0, 0, 0), mass = 0.1 } }
for i = 1, 3 do
  local angle = 2 * math.pi * i / 3
  pins[i] = { at = 0.55 * vec(math.cos(angle), math.sin(angle), 0), mass = 0.2 }
end
local arm = on_axle(scene:body { at = centre, mass = 1, inertia = vec(0.05, 0.05, 0.1), points = pins, color = "#3f6f9f" })
scene:gear(idler, ring, { ratio = -1.0 / 0.3, axis = z })
for i = 1, 3 do
  local planet = wheel(arm.points[i].position, 0.25, "#6b8e5a", 0.4, 0.05)
  scene:hinge(arm.points[i], planet.hub, { axis = z })
  scene:gear(planet, sun, { ratio = -0.3 / 0.25, axis = z, carrier = arm })
  scene:gear(planet, ring, { ratio = 0.8 / 0.25, axis = z, carrier = arm })
end
scene:motor(sun, { axis = z, speed = sun_speed, max_torque = 200 })

-- Round a corner: the ring turns an upright screw four times as fast; it lifts a stone that cannot turn.
local spindle = scene:body { at = vec(2.1, 1.4, 0), mass = 1, inertia = vec(0.02, 0.02, 0.02), color = "#c9b458",
                             points = { head = vec(0, 0.2, 0), tip = vec(0, -0.2, 0) } }
scene:nail(spindle.head)
scene:align(spindle, y, y, { angle = 0 })
scene:gear(spindle, ring, { ratio = 4, axis = y, axis_b = z })
local nut = scene:body { at = vec(2.1, -0.2, 0), mass = 3, inertia = vec(0.05, 0.05, 0.05), color = "#777777",
                         points = { hub = vec(0, 0, 0), vec(-0.3, -0.3, 0.3), vec(0.3, -0.3, 0.3), vec(0.3, -0.3, -0.3),
                                    vec(-0.3, -0.3, -0.3) } }
scene:on_plane(nut.hub, { normal = x })
scene:on_plane(nut.hub, { normal = z })
scene:orient(nut)
scene:screw(nut.hub, spindle.tip, { lead = 0.25, axis = y })

-- The tackle: the heavy stone hangs on two turns of the rope; the light one holds it by swinging.
local light = scene:particle { at = vec(3.5, 0.4, 0), velocity = vec(0, 0, 0), mass = 1, radius = 0.13, color = "#c2413b" }
local heavy = scene:particle { at = vec(3.8, -0.6, 0), mass = 2.4, radius = 0.2, color = "#3f6f9f" }
local rope = scene:pulley(light, vec(2.9, 1.5, 0), vec(3.8, 1.5, 0), heavy, { ratio = 2 })

scene:probe("crank speed", function() return crank.spin.z end)
scene:probe("arm speed", function() return arm.spin.z end)
scene:probe("height of the stone", function() return nut.position.y end)
scene:probe("pull of the rope", function() return rope.force end)
