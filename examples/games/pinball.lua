-- Pinball. Left and right (or a and d, or a gamepad's shoulders) move the flippers; hold space (or the pad's a) and let go to
-- shoot the ball. What the bumpers give counts, and the best score is kept for the next time.
scene.title, scene.duration = "Pinball", 60
scene.plane = "xy"
scene.step = 1 / 480
scene.contact_sounds = true
scene.camera = { at = vec(0, 3.5, 23), look_at = vec(0, 3.5, 0) }

local middle, wood, lane = -0.36, "#7a4f2b", vec(2.68, 0.5, 0)
local function wall(width, height, x, y) return shape.box(width, height, 1, { at = vec(x, y, 0), restitution = 0.4, color = wood }) end
local function wedge(...) return shape.polygon { points = { ... }, thickness = 1, restitution = 0.4, color = wood } end
scene:ground { layer = "table", shapes = {
  wall(0.3, 10.6, -3.15, 5), wall(0.3, 10.6, 3.15, 5), wall(0.15, 7.3, 2.35, 3.65), wall(6.6, 0.3, 0, 10.15), wall(0.6, 0.3, 2.7, 0.15),
  wedge(vec(3, 8, 0), vec(3, 10, 0), vec(1, 10, 0)), wedge(vec(-3, 8.8, 0), vec(-1.8, 10, 0), vec(-3, 10, 0)),
  wedge(vec(-3, 3, 0), vec(-3, 1.6, 0), vec(middle - 1.4, 1.75, 0)), wedge(vec(2.27, 3, 0), vec(2.27, 1.6, 0), vec(middle + 1.4, 1.75, 0)),
} }

-- A flipper hangs between its two ends; a strong motor drives it from one to the other.
local function flipper(way)
  local tip = vec(-way * 1.05 * math.cos(0.45), -1.05 * math.sin(0.45), 0)
  local body = scene:body { at = vec(middle + way * 1.3, 1.72, 0), mass = 1, color = "#e8b33a", name = way < 0 and "left" or "right",
                            shapes = { shape.capsule { radius = 0.12, from = vec(0, 0, 0), to = tip, friction = 0.3, restitution = 0.2 } },
                            points = { pin = vec(0, 0, 0) }, layer = "flipper" }
  scene:nail(body.pin)
  scene:limit(body, { min = way < 0 and 0 or -0.95, max = way < 0 and 0.95 or 0 })
  return scene:motor(body, { speed = 8 * way, max_torque = 60 })
end
scene:collide("flipper", "table", false)
local left, right = flipper(-1), flipper(1)

local bumpers = {}
for i, at in ipairs { vec(-1.6, 6.6, 0), vec(0.9, 6.8, 0), vec(-0.35, 5, 0), vec(-0.3, 8.3, 0) } do
  bumpers[i] = scene:ground { color = i == 4 and "#3f8fd0" or "#c2413b",
                              shape = shape.cylinder { radius = 0.42, length = 0.8, axis = vec(0, 0, 1), restitution = 0.6 }, at = at }
  bumpers[i].name = i == 4 and "big" or "small"
end
local ball = scene:ball { radius = 0.16, mass = 0.5, at = lane, color = "#dde3e8", friction = 0.1, restitution = 0.3, name = "ball" }

local score, balls, pull, lit = 0, 3, 0, {}
for _, bumper in ipairs(bumpers) do
  scene:on("touched", bumper, function(touch)
    local away = touch.b == ball and -touch.normal or touch.normal
    ball:kick(3 * ball.mass * away)
    score = score + (bumper.name == "big" and 500 or 100)
    lit[bumper] = scene.time
    scene:sound("blip", { volume = 0.5, pitch = bumper.name == "big" and 2 or 1.3 })
  end)
end

local function in_lane() return ball.position.x > 2.4 and ball.position.y < 1 and ball.velocity:length() < 1 end
local function lost()
  balls = balls - 1
  scene:sound("rubber")
  if balls == 0 then
    scene.saved.best = math.max(score, scene.saved.best or 0)
    score, balls = 0, 3
  end
  ball.position, ball.velocity, ball.spin = lane, vec(0, 0, 0), vec(0, 0, 0)
end

scene:on("step", function(dt)
  local keys, pad = scene.keys, scene.pad
  left.speed = (keys.left or keys.a or pad.left_shoulder) and 22 or -8
  right.speed = (keys.right or keys.d or pad.right_shoulder) and -22 or 8
  if keys.space or pad.a then
    pull = math.min(1, pull + dt)
  elseif pull > 0 then
    if in_lane() then ball:kick(vec(0, ball.mass * (9 + 7 * pull), 0)) end
    pull = 0
  end
  if ball.position.y < -0.4 then lost() end
  for bumper, since in pairs(lit) do bumper.color = scene.time - since < 0.15 and "#fff1a8" or (bumper.name == "big" and "#3f8fd0" or "#c2413b") end
  local draw, screen = scene.draw, { space = "screen", size = 22 }
  draw:text(vec(16, 60, 0), string.format("score %.0f\nballs %.0f\nbest %.0f", score, balls, scene.saved.best or 0), screen)
  if in_lane() then draw:text(vec(16, 160, 0), "space: shoot" .. string.rep("|", math.floor(20 * pull)), screen) end
end)
scene:probe("score", function() return score end)
scene:probe("balls", function() return balls end)
