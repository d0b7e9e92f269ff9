-- A workshop of gears: a train and a planetary gear, a screw that lifts a stone, a rack, a tackle. Drag any of it, cut any of it.
local speed = scene:param("speed", 3, { min = 0, max = 12, help = "of the crank, rad/s" })
local sun_speed = scene:param("sun", 0, { min = -6, max = 6, help = "of the sun of the planetary gear, rad/s" })
scene.title, scene.duration, scene.camera = "Gears", 30, { at = vec(0.3, 0.6, 9), look_at = vec(0.3, 0, 0) }
local x, y, z = vec(1, 0, 0), vec(0, 1, 0), vec(0, 0, 1)
--- A wheel that turns about z, of `n` spokes; what is seen of it lies before its hub or behind it.
local function wheel(at, radius, color, mass, before, n)
  local points, moment = { hub = { at = vec(0, 0, 0), mass = 0.1 } }, 0.5 * mass * radius * radius
  for i = 1, n or 5 do
    local angle = 2 * math.pi * i / (n or 5)
    points[i] = 0.75 * radius * vec(math.cos(angle), math.sin(angle), 0) + (before or 0) * z
  end
  return scene:body { at = at, mass = mass, inertia = vec(moment / 2, moment / 2, moment), points = points, color = color }
end
local function on_axle(body, axis, point)
  scene:nail(point or body.hub)
  scene:align(body, axis or z, axis or z, { angle = 0 })
  return body
end
-- The train: wheels that mesh turn against each other, the larger one slower; the last turns a ring.
local ring = on_axle(wheel(vec(0.45, 0.7, 0), 1.0, "#999999", 2, -0.3))
local crank, middle = on_axle(wheel(vec(-2.9, 0.7, 0), 0.35, "#c2413b", 1)), on_axle(wheel(vec(-1.85, 0.7, 0), 0.7, "#e8833a", 2))
local low, idler = on_axle(wheel(vec(-1.85, -0.65, 0), 0.65, "#8a5a9e", 2)), on_axle(wheel(vec(-0.85, 0.7, 0), 0.3, "#c2413b", 1))
for _, g in ipairs { { crank, middle, 2 }, { middle, low, 0.65 / 0.7 }, { middle, idler, 0.3 / 0.7 }, { idler, ring, 1 / 0.3 } } do
  scene:gear(g[1], g[2], { ratio = -g[3], axis = z })
end
local motor = scene:motor(crank, { axis = z, speed = speed, max_torque = 80 })
local slider = scene:particle { at = vec(-1.85, -1.3, 0), mass = 1.5, radius = 0.08, color = "#6b8e5a" }
scene:on_path(slider, { vec(-3.6, -1.3, 0), vec(0, -1.3, 0) })
scene:rack(low, slider, { radius = 0.65, axis = z, along = x })
scene:on("step", function() -- at the ends of the rack the crank turns round
  local off = slider.position.x + 1.85
  if math.abs(off) > 1.05 and off * slider.velocity.x > 0 then motor.speed = -motor.speed end
end)
-- The planetary gear: three planets on an arm roll between a sun and the ring.
local sun = on_axle(wheel(ring.position, 0.3, "#e0b040", 0.5, 0.05))
local arm = on_axle(wheel(ring.position, 0.55 / 0.75, "#3f6f9f", 1.6, 0, 3))
for i = 1, 3 do
  local planet = wheel(arm.points[i].position, 0.25, "#6b8e5a", 0.4, 0.05)
  scene:hinge(arm.points[i], planet.hub, { axis = z })
  scene:gear(planet, sun, { ratio = -0.3 / 0.25, axis = z, carrier = arm })
  scene:gear(planet, ring, { ratio = 0.8 / 0.25, axis = z, carrier = arm })
end
scene:motor(sun, { axis = z, speed = sun_speed, max_torque = 200 })
-- Round a corner: the ring turns an upright screw four times as fast; it lifts a stone that cannot turn.
local spindle = scene:body { at = vec(2.1, 1.4, 0), mass = 1, inertia = vec(0.02, 0.02, 0.02), color = "#c9b458", points = { head = y / 5, tip = -y / 5 } }
on_axle(spindle, y, spindle.head)
scene:gear(spindle, ring, { ratio = 4, axis = y, axis_b = z })
local nut = scene:body { at = vec(2.1, -0.2, 0), mass = 3, inertia = vec(0.05, 0.05, 0.05), color = "#777777",
                         points = { hub = vec(0, 0, 0), vec(-0.3, -0.3, 0.3), vec(0.3, -0.3, 0.3), vec(0.3, -0.3, -0.3), vec(-0.3, -0.3, -0.3) } }
for _, normal in ipairs { x, z } do scene:on_plane(nut.hub, { normal = normal }) end
scene:orient(nut)
scene:screw(nut.hub, spindle.tip, { lead = 0.25, axis = y })
-- The tackle: the heavy stone hangs on two turns of the rope; the light one holds it by swinging.
local light = scene:particle { at = vec(3.5, 0.4, 0), mass = 1, radius = 0.13, color = "#c2413b" }
local heavy = scene:particle { at = vec(3.8, -0.6, 0), mass = 2.4, radius = 0.2, color = "#3f6f9f" }
scene:pulley(light, vec(2.9, 1.5, 0), vec(3.8, 1.5, 0), heavy, { ratio = 2 })
scene:probe("crank speed", function() return crank.spin.z end)
scene:probe("height of the stone", function() return nut.position.y end)
