-- A tower of bricks, and a wrecking ball that swings into it on a chain of rigid links. Drag a brick, or cut the chain.
local storeys = scene:param("storeys", 10, { min = 1, max = 40, step = 1, help = "layers of bricks" })
local weight = scene:param("weight", 400, { min = 10, max = 5000, help = "of the ball, kg" })
local links = scene:param("links", 12, { min = 2, max = 60, step = 1, help = "links of the chain" })

scene.title = "Tower and wrecking ball"
scene.duration = 8
scene.camera = { at = vec(2.5, 4.2, 13), look_at = vec(-0.6, 3, 0) }
scene:floor { friction = 0.6, color = "#d9cdb8" }

-- Three bricks a layer, each layer across the one below.
local brick = shape.box { size = vec(1.2, 0.3, 0.4), density = 500, friction = 0.6 }
local colors = { "#b5533c", "#c9714f", "#d98e63" }
local bricks = {}
for storey = 1, storeys do
  local turned = storey % 2 == 0
  for k = -1, 1 do
    local at = (turned and vec(0.4 * k, 0, 0) or vec(0, 0, 0.4 * k)) + vec(0, 0.3 * storey - 0.15, 0)
    local turn = quat(vec(0, 1, 0), turned and math.pi / 2 or 0)
    local one = scene:body { shape = brick, at = at, orientation = turn, color = colors[(storey + k) % 3 + 1] }
    bricks[#bricks + 1] = { body = one, at = at, turn = turn }
  end
end

-- The chain hangs from above, and begins stretched out to the left.
local top, length = vec(-1.6, 6, 0), 0.36
local way = vec(-0.96, -0.28, 0)
local link = shape.capsule { radius = 0.05, from = way * (-length / 2), to = way * (length / 2), density = 7800 }
local chain, last = scene:group "chain", nil
for i = 1, links do
  local one = scene:body { shape = link, at = top + way * (length * (i - 0.5)), color = "#4b5563",
                           points = { head = way * (-length / 2), tail = way * (length / 2) } }
  if last then scene:hinge(last.tail, one.head) else scene:nail(one.head) end
  chain:add(one)
  last = one
end
local radius = 0.45
local ball = scene:ball { radius = radius, mass = weight, at = top + way * (length * links + radius), color = "#374151",
                          points = { eye = way * -radius }, name = "ball" }
scene:hinge(last.tail, ball.eye)

-- Again and again a winch draws the ball back, and lets it go as soon as the tower is built again.
local start = ball.eye.position
local function draw_back()
  if not ball.alive then return end
  local from, since = ball.eye.position, scene.time
  local function drawn(t) return from + (start - from) * math.min(1, (t - since) / 4) end
  local winch = scene:follow(ball.eye, drawn, { max_force = 30 * weight })
  scene:after(5, winch, function()
    winch:remove()
    for _, b in ipairs(bricks) do
      if b.body.alive then b.body.position, b.body.orientation, b.body.velocity, b.body.spin = b.at, b.turn, vec(0, 0, 0), vec(0, 0, 0) end
    end
  end)
end
scene:every(11, draw_back)
scene:button("draw the ball back", draw_back)
scene:button("cut the chain", function() chain:cut_hinges() end)
scene:probe("speed of the ball", function() return ball.velocity:length() end)
