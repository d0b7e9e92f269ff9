-- Hill climb. Right gives gas, left brakes and goes back; in the air they turn the car (of a gamepad: the triggers). Cans hold
-- fuel; without it, or on its roof, the ride is over, and return begins anew. How far it went is kept.
scene.title, scene.duration = "Hill climb", 60
scene.plane = "xy"
scene.step = 1 / 480

local long, spacing = 600, 0.5
local function height(x)
  local rise = math.min(1, math.max(0, x / 60)) -- steeper further on
  return (0.4 + 1.8 * rise) * (math.sin(0.35 * x) + 0.6 * math.sin(0.83 * x + 1)) * math.min(1, math.max(0, x / 8))
end
local line, colors = {}, { "#7d9b57", "#c2413b", "#2f343c" }
for i = -40, long / spacing do line[#line + 1] = vec(i * spacing, i <= -39 and 6 or height(i * spacing), 0) end
scene:ground { shape = shape.line(line, { friction = 0.9 }), color = colors[1] }

local axis = vec(0, 0, 1)
local car = scene:body { at = vec(0, 1.15, 0), mass = 250, color = colors[2], name = "car",
  shapes = { shape.box(2.4, 0.35, 0.9, { layer = "car" }),
             shape.polygon { points = { vec(-0.9, 0.17, 0), vec(0.5, 0.17, 0), vec(0.1, 0.7, 0), vec(-0.6, 0.7, 0) }, thickness = 0.8, color = "#e8e4da", layer = "roof" } },
  points = { back = vec(-0.2, -0.1, 0), front = vec(0.2, -0.1, 0), strut_back = vec(-0.95, 0.35, 0), strut_front = vec(0.95, 0.35, 0) } }
local motors = {}
for _, way in ipairs { -1, 1 } do
  local root = way < 0 and car.back or car.front
  local arm = scene:body { at = root.position, mass = 8, inertia = vec(0.2, 0.2, 0.2), color = "#4b5563",
                           points = { root = vec(0, 0, 0), hub = vec(0.75 * way, -0.35, 0) } }
  scene:hinge(root, arm.root)
  scene:limit(arm, car, { min = -0.5, max = 0.5 })
  local strut = way < 0 and car.strut_back or car.strut_front
  scene:connect(arm.hub, strut, force.spring { stiffness = 9000, length = 0.95, implicit = true })
  scene:connect(arm.hub, strut, force.damper { damping = 900, implicit = true })
  local wheel = scene:cylinder { radius = 0.42, length = 0.3, axis = axis, mass = 18, friction = 1.2, color = colors[3], layer = "car",
                                 at = arm.hub.position, points = { hub = vec(0, 0, 0) } }
  scene:hinge(arm.hub, wheel.hub)
  motors[#motors + 1] = scene:motor(wheel, arm, { speed = 0, max_torque = 5 })
end
scene:collide("car", "car", false)
scene:collide("car", "roof", false)

local fuel, far, over, cans = 1, 0, false, {}
for x = 40, long - 20, 40 do
  cans[#cans + 1] = { at = vec(x, height(x) + 1, 0), full = true }
end
local function again() fuel, far, over = 1, 0, false for _, can in ipairs(cans) do can.full = true end scene:reset() end
scene:on("key", "return", again)
local function finish(why)
  if over then return end
  over = why
  scene.saved.best = math.max(far, scene.saved.best or 0)
  scene:sound("noise", { volume = 0.5, pitch = 0.5 })
end
scene:on("touched", "roof", function() finish("on the roof") end)

scene:on("step", function(dt)
  local gas = scene.keys.right and 1 or scene.pad.right_trigger
  local brake = scene.keys.left and 1 or scene.pad.left_trigger
  local drive = (over or fuel <= 0) and 0 or gas - brake
  for _, motor in ipairs(motors) do
    motor.speed = drive == 0 and 0 or -45 * drive
    motor.max_torque = drive == 0 and (car.velocity:length() < 0.5 and 80 or 8) or 260 * math.abs(drive)
  end
  if drive ~= 0 then
    fuel = math.max(0, fuel - 0.03 * dt)
    car:twist(axis * (260 * drive))
  end
  if fuel == 0 and car.velocity:length() < 0.3 then finish("out of fuel") end
  far = math.max(far, car.position.x)
  for _, can in ipairs(cans) do
    if can.full and (car.position - can.at):length() < 1.6 then
      can.full, fuel = false, 1
      scene:sound("blip", { pitch = 1.5 })
    elseif can.full then
      scene.draw:point(can.at, { size = 14, color = "#e0a020" })
    end
  end
  local screen = { space = "screen", size = 22 }
  scene.draw:text(vec(16, 60, 0), string.format("%.0f m   best %.0f m\nfuel %s", far, scene.saved.best or 0, string.rep("|", math.ceil(30 * fuel))), screen)
  if over then scene.draw:text(vec(16, 130, 0), over .. ": return begins anew", screen) end
end)
scene.camera = { at = vec(2, 3, 17), look_at = vec(2, 1.8, 0), ease = 0.25 }
scene.camera.follow = car
scene:probe("far", function() return far end)
scene:probe("fuel", function() return fuel end)
