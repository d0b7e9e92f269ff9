-- Claw. The claw goes where the pointer is, and each click closes or opens it; with a finger the same. Or with two hands: a and d
-- (left stick) move it, up and down (right stick) its ropes, space (the pad's a) grips. Fetch what you can in 90 s; gold counts 5.
scene.title, scene.duration, scene.plane = "Claw", 60, "xy"
scene.contact_sounds = true
scene.camera = { at = vec(-0.6, 3.2, 15.5), look_at = vec(-0.6, 3.2, 0) }

local function wall(width, height, x, y, color) return shape.box(width, height, 1.4, { at = vec(x, y, 0), friction = 0.6, color = color or "#7a4f2b" }) end
scene:ground { shapes = { wall(10, 0.4, -0.6, -0.2), wall(0.3, 2.2, -5.6, 0.7), wall(0.25, 2, 2.2, 1), wall(0.3, 2.2, 4.4, 0.7),
                          wall(10.3, 0.2, -0.6, 7, "#e0a030") } }
local rail, steel = 6.7, "#c2413b"

-- Two ropes hold the head level; at each of its ends hangs a jaw on a hinge, with a motor that may not squeeze too hard.
local air = scene:family "air"
scene:field(air, force.drag { linear = 60 })
local function knot(x) return { at = vec(x, 0.12, 0), family = air } end
local head = scene:body { at = vec(-1.5, 4, 0), mass = 60, name = "head", color = steel, layer = "claw", shape = shape.box(1, 0.24, 0.5),
                          points = { left = knot(-0.4), right = knot(0.4), pin_left = vec(-0.35, -0.08, 0), pin_right = vec(0.35, -0.08, 0) } }
local jaws, ropes, leads = {}, {}, {}
for i, side in ipairs { -1, 1 } do
  local pin, end_of_rope = side < 0 and head.pin_left or head.pin_right, side < 0 and head.left or head.right
  local function arm(x1, y1, x2, y2) return shape.capsule { radius = 0.07, from = vec(side * x1, y1, 0), to = vec(side * x2, y2, 0), friction = 1 } end
  local jaw = scene:body { at = pin.position, mass = 4, color = "#b8bec6", layer = "claw", points = { pin = vec(0, 0, 0) },
                           shapes = { arm(0, 0, 0.22, -0.55), arm(0.22, -0.55, 0.12, -1.05), arm(0.12, -1.05, -0.12, -1.2) } }
  scene:hinge(pin, jaw.pin)
  scene:limit(jaw, head, { min = side < 0 and -0.4 or 0, max = side < 0 and 0 or 0.4 })
  jaws[i] = scene:motor(jaw, head, { speed = 2 * side, max_torque = 80 })
  local wheel = scene:particle { at = vec(end_of_rope.position.x, rail, 0), mass = 50, radius = 0.16, color = "#3a3f45" }
  leads[i] = scene:follow(wheel, wheel.position)
  ropes[i] = scene:string({ wheel, end_of_rope }, { length = rail - end_of_rope.position.y })
end
scene:collide("claw", "claw", false)

-- Each prize has a post to stand on, with room for the jaws beside it, and is put back there when it was fetched or fell.
local prizes, colors, posts = {}, { "#3f8fd0", "#6b8e5a", "#8a5a9e", "#e8833a", "#ffcf3f" }, {}
for i = 1, 5 do posts[i] = vec(-4.4 + 1.35 * (i - 1), 1, 0) end
local function prize(i)
  local corners, gold = {}, math.random() < 0.2
  local count = gold and 8 or 4 + math.floor(3 * math.random())
  for k = 1, count do
    local turn = 2 * math.pi * (k - 0.5) / count - math.pi / 2 -- it stands on an edge
    corners[k] = vec(0.36 * math.cos(turn), 0.36 * math.sin(turn), 0)
  end
  local made = scene:body { at = posts[i] + vec(0, 0.5, 0), mass = 4, shape = shape.polygon { points = corners, thickness = 0.6, friction = 0.9 },
                            name = "prize " .. i, color = gold and colors[5] or colors[math.floor(1 + 4 * math.random())] }
  made.data.worth = gold and 5 or 1
  prizes[i] = made
end
for i, top in ipairs(posts) do
  scene:ground { shapes = { wall(0.22, top.y, top.x, top.y / 2) } }
  prize(i)
end

local x, v, u, rope, grip, score, left, seen = head.position.x, 0, 0, rail - 4.12, false, 0, 90, nil
local keys, pad, mouse = scene.keys, scene.pad, scene.mouse
local aim -- where the pointer wants the middle of the claw
local function squeeze() grip = not grip end
scene:on("key", "space", squeeze)
local function one(value) return math.max(-1, math.min(1, value)) end
local function steer()
  local at = mouse.position
  if at and (not seen or (at - seen):length() > 1e-6) then aim, seen = at, at end
  if mouse.left_pressed then squeeze() end
  local along = (keys.d and 1 or 0) - (keys.a and 1 or 0) + pad.left_x
  local up = (keys.up and 1 or 0) - (keys.down and 1 or 0) + pad.right_y
  if along ~= 0 or up ~= 0 then aim = nil end
  if aim then return one(1.5 * (aim.x - x)), one(2 * (aim.y + 1.05 - (rail - rope))) end
  return one(along), one(up)
end
scene:on("step", function(dt)
  local along, up = steer()
  v, u = v + (2.4 * along - v) * 2 * dt, u + (2 * up - u) * 3 * dt -- slower than what falls: the ropes stay taut
  x, rope = math.max(-4.6, math.min(3.4, x + v * dt)), math.max(0.6, math.min(5.6, rope - u * dt))
  if u < 0 and (leads[1].target - head.left.position):length() < rope - 0.04 then u, rope = 0, rope + u * dt end -- it rests on something
  for i, side in ipairs { -1, 1 } do
    leads[i].target, ropes[i].length, jaws[i].speed = vec(x + 0.4 * side, rail, 0), rope, (grip and -3 or 2) * side
  end
  for i, thing in ipairs(prizes) do
    local at = thing.position
    if at.y < 0.6 and thing.velocity:length() < 0.2 then
      if at.x > 2.3 then score = score + thing.data.worth scene:sound("glass", { pitch = thing.data.worth > 1 and 2 or 1 }) end
      thing:remove()
      prize(i)
    end
  end
  if score > 0 or left < 90 then left = left - dt end
  if left < 0 then
    scene.saved.best = math.max(score, scene.saved.best or 0)
    score, left = 0, 90
  end
  scene.draw:text(vec(16, 60, 0), ("score %.0f\nbest %.0f\n%.0f s"):format(score, scene.saved.best or 0, left), { space = "screen", size = 20 })
end)
scene:probe("score", function() return score end)
