-- Lander. Up burns fuel and lifts, left and right turn (of a gamepad: the right trigger and the left stick). Come down on the
-- pad, upright and slowly, and the next level is opened; each has less fuel and rougher ground.
local level = scene.saved.level or 1
scene.title, scene.duration = "Lander, level " .. level, 60
scene.plane = "xy"
scene.gravity = vec(0, -1.62, 0)
scene.seed = level

-- The ground: random, but level where the pad is.
local pad_x, half, line = math.floor(-25 + 50 * math.random()), 3, {}
local phase, rough = 6 * math.random(), 1 + 0.35 * level
local function rock(x) return rough * (math.sin(0.21 * x + phase) + 0.5 * math.sin(0.53 * x + 2 * phase) + 0.25 * math.sin(1.7 * x)) end
for x = -60, 60 do
  local near = math.max(0, math.min(1, (math.abs(x - pad_x) - half) / 4))
  line[#line + 1] = vec(x, near * rock(x) + (1 - near) * rock(pad_x), 0)
end
scene:ground { shape = shape.line(line, { friction = 0.8 }), color = "#8c8577" }
local pad = scene:ground { shape = shape.box(2 * half, 0.2, 2, { friction = 1 }), at = vec(pad_x, rock(pad_x) + 0.1, 0), color = "#3fa35b" }

local leg = { restitution = 0.1, friction = 0.8, color = "#9aa3ad" }
local ship = scene:body { at = vec(-pad_x, 18, 0), velocity = vec(2, 0, 0), mass = 1000, color = "#d8dce2", name = "ship", shapes = {
  shape.polygon { points = { vec(-0.9, -0.5, 0), vec(0.9, -0.5, 0), vec(0.6, 0.6, 0), vec(0, 1, 0), vec(-0.6, 0.6, 0) }, thickness = 1.2 },
  shape.box(0.2, 0.9, 1.2, { at = vec(-1, -0.75, 0), friction = leg.friction, restitution = leg.restitution, color = leg.color }),
  shape.box(0.2, 0.9, 1.2, { at = vec(1, -0.75, 0), friction = leg.friction, restitution = leg.restitution, color = leg.color }),
} }
local _ = scene.keys.up, scene.keys.left, scene.keys.right -- the scene's from the start
local fuel, told, rested = math.max(0.4, 1.1 - 0.1 * level), nil, 0

scene:on("touched", ship, function(touch)
  scene:sound("metal", { volume = math.min(1, 0.2 + touch.speed / 5), pitch = 0.4 })
  if touch.speed > 2.5 and not told then
    told = "broken"
    scene.saved.level = 1
    for _, piece in ipairs(scene:shatter(ship, { pieces = 12, at = touch.at })) do piece.color = "#b8bec6" end
    scene:after(3, function() scene:open("lander.lua") end)
  end
end)

local noise_at = 0
local function burn(power, dt)
  local up = ship.orientation:rotate(vec(0, 1, 0))
  ship:push(up * (4000 * power))
  fuel = math.max(0, fuel - 0.05 * power * dt)
  local nozzle = ship.position - up * 0.6
  scene.draw:line(nozzle, nozzle - up * (1.5 + math.sin(60 * scene.time) * 0.3) * power, { width = 7, color = "#ffb02e" })
  if scene.time > noise_at then
    scene:sound("noise", { volume = 0.25 * power, pitch = 0.3 })
    noise_at = scene.time + 0.12
  end
end

--- Whether it stands on the pad.
local function landed()
  local at = ship.position
  return math.abs(at.x - pad_x) < half and ship.velocity:length() < 0.05 and ship.orientation:rotate(vec(0, 1, 0)).y > 0.95
         and at.y - pad.position.y < 2
end

scene:on("step", function(dt)
  local screen = { space = "screen", size = 22 }
  scene.draw:text(vec(16, 60, 0), string.format("level %.0f   best %.0f\nfuel %s", level, scene.saved.best or 0, string.rep("|", math.ceil(30 * fuel))), screen)
  if told then return scene.draw:text(vec(16, 130, 0), told, screen) end
  local turn = scene.pad.left_x + (scene.keys.right and 1 or 0) - (scene.keys.left and 1 or 0)
  ship:twist(vec(0, 0, -900 * turn - 700 * ship.spin.z))
  local power = scene.keys.up and 1 or scene.pad.right_trigger
  if power > 0 and fuel > 0 then burn(power, dt) end
  local v = ship.velocity
  scene.draw:text(vec(16, 130, 0), string.format("%.1f m/s down, %.1f m/s aside", -v.y, math.abs(v.x)), screen)
  rested = landed() and rested + dt or 0
  if rested > 1 then
    told = "landed"
    scene.saved.level, scene.saved.best = level + 1, math.max(level, scene.saved.best or 0)
    scene:sound("glass", { pitch = 0.5 })
    scene:after(2, function() scene:open("lander.lua") end)
  end
end)
scene.camera = { at = vec(0, 11, 55), look_at = vec(0, 9, 0), ease = 1 }
scene:probe("fuel", function() return fuel end)
scene:probe("height", function() return ship.alive and ship.position.y or 0 end)
