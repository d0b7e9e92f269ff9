-- A car with springs drives over hills: four wheels on arms, each with a spring, a damper and a motor. Keys j and l turn its
-- speed down and up; drag it where you like.
local speed = scene:param("speed", 12, { min = -30, max = 30, help = "of the wheels, rad/s" })
local stiffness = scene:param("stiffness", 2.5e4, { min = 5e3, max = 2e5, help = "of a spring, N/m" })
local roughness = scene:param("roughness", 0.5, { min = 0, max = 1, help = "height of the hills, m" })

scene.title = "Car on hills"
scene.duration = 30
scene.step = 1 / 480 -- wheels that roll over edges gain by the step

local function height(x, z)
  local rise = math.min(1, math.max(0, (math.abs(x + 190) - 3) / 4)) -- level where it starts
  return rise * roughness * (math.sin(0.45 * x) + 0.5 * math.sin(1.1 * x + 0.7) * math.cos(0.3 * z) + 0.3 * math.sin(0.8 * z))
end
scene:ground {
  shape = shape.heights { columns = 801, rows = 41, spacing = 0.5, height = height, friction = 0.9 }, color = "#8aa06a",
}

local start = vec(-190, 0.62, 0)
local chassis = scene:body {
  at = start, name = "car", color = "#c2413b", mass = 900,
  shapes = { shape.box(2.6, 0.3, 1.1, { at = vec(0, 0.1, 0) }),
             shape.box(1.3, 0.4, 1, { at = vec(-0.2, 0.45, 0), color = "#e8e4da" }) },
  points = { nose = vec(1.3, 0.1, 0), front_1 = vec(0.55, 0, 0.62), front_2 = vec(0.55, 0, -0.62), back_1 = vec(-0.55, 0, 0.62),
             back_2 = vec(-0.55, 0, -0.62), tower_front_1 = vec(1, 0.45, 0.62), tower_front_2 = vec(1, 0.45, -0.62),
             tower_back_1 = vec(-1, 0.45, 0.62), tower_back_2 = vec(-1, 0.45, -0.62) },
}
local spring = force.spring { stiffness = stiffness, length = 0.54, implicit = true }
local damper = force.damper { damping = 1800, implicit = true }
local axis = vec(0, 0, 1)
local motors, wheels = {}, {}
for _, corner in ipairs { "front_1", "front_2", "back_1", "back_2" } do
  local root = chassis[corner]
  local way = corner:find "front" and 1 or -1
  local arm = scene:body { at = root.position, mass = 20, inertia = vec(0.2, 0.2, 0.2), color = "#4b5563",
                           points = { root = vec(0, 0, 0), hub = vec(0.45 * way, -0.1, 0) } }
  scene:hinge(root, arm.root, { axis = axis })
  scene:limit(arm, chassis, { axis = axis, min = -0.5, max = 0.5 })
  scene:connect(arm.hub, chassis["tower_" .. corner], spring)
  scene:connect(arm.hub, chassis["tower_" .. corner], damper)
  local side = root.position.z > 0 and 1 or -1
  local wheel = scene:cylinder { radius = 0.4, length = 0.24, axis = axis, density = 250, friction = 1, color = "#2f343c",
                                 at = arm.hub.position + axis * (0.2 * side), points = { hub = axis * (-0.2 * side) } }
  scene:hinge(arm.hub, wheel.hub, { axis = axis })
  motors[#motors + 1] = scene:motor(wheel, arm, { axis = axis, speed = -speed, max_torque = 400 })
  wheels[#wheels + 1] = wheel
end
scene.camera = { at = start + vec(2.5, 2.6, 7), look_at = start, follow = chassis }

local function turn_up(by)
  for _, motor in ipairs(motors) do motor.speed = motor.speed - by end
end
scene:on("key", "j", function() turn_up(-3) end)
scene:on("key", "l", function() turn_up(3) end)
scene:probe("way", function() return chassis.position.x - start.x end)
scene:probe("speed", function() return chassis.velocity:length() end)
scene:probe("upright", function() return chassis.orientation:rotate(vec(0, 1, 0)).y end)
