-- A house of cards: nothing but friction holds it. Pull a card out gently, or throw the ball; with friction too small it slips.
local storeys = scene:param("storeys", 4, { min = 1, max = 8, step = 1, help = "of the house" })
local lean = scene:param("lean", 0.4, { min = 0.1, max = 0.8, help = "of the cards, from the vertical, rad" })
local friction = scene:param("friction", 0.6, { min = 0, max = 1.5, help = "of cards and table" })

scene.title = "House of cards"
scene.duration = 14
scene.camera = { at = vec(1.8, 2.6, 8.6), look_at = vec(0, 1.8, 0) }
scene:floor { friction = friction, color = "#3f6b52" }

-- Two cards of 1 m lean against each other, edge to edge; pairs stand beside each other, and carry flat ones.
local long, thick, wide = 1, 0.012, 0.7
local half_width = 0.5 * (thick * math.cos(lean) + long * math.sin(lean)) -- of a card
local height = thick * math.sin(lean) + long * math.cos(lean)
local apart = 2 * long * math.sin(lean) + 0.06
local material = { density = 300, friction = friction }
local upright = shape.box(thick, long, wide, material)
local flat = shape.box(thick, apart - 0.002, wide, material)

local colors = { "#f4efe2", "#c2413b", "#f2b45c", "#2f4858" }
local cards = {}
local function put(card, x, y, angle)
  local pose = { at = vec(x, y, 0), orientation = quat(vec(0, 0, 1), angle) }
  cards[#cards + 1] = { pose = pose, body = scene:body { shape = card, at = pose.at, orientation = pose.orientation,
                                                         color = colors[#cards % #colors + 1] } }
end
for storey = 1, storeys do
  local bottom = (storey - 1) * (height + thick)
  local beside = storeys - storey + 1 -- pairs in this storey
  for i = 1, beside do
    local x = (i - (beside + 1) / 2) * apart
    put(upright, x - half_width, bottom + height / 2, -lean)
    put(upright, x + half_width, bottom + height / 2, lean)
    if i > 1 then put(flat, x - apart / 2, bottom + height + thick / 2, math.pi / 2) end
  end
end

local ball = scene:ball { radius = 0.12, density = 1500, at = vec(-4, 0.12, 0), color = "#e8833a" }
local function move(body, at, orientation, velocity)
  if body.alive then body.position, body.orientation, body.velocity, body.spin = at, orientation, velocity, vec(0, 0, 0) end
end
local function throw() move(ball, vec(-4, 0.8, 0), ball.orientation, vec(7, 2, 0)) end
local function build() -- again, and out of the ball's way
  move(ball, vec(-4, 0.12, 0), ball.orientation, vec(0, 0, 0))
  for _, card in ipairs(cards) do move(card.body, card.pose.at, card.pose.orientation, vec(0, 0, 0)) end
end
scene:at(8, throw)
scene:every(15, function() build() scene:after(6, throw) end)
scene:button("throw", throw)
scene:button("build again", build)
scene:probe("top of the house", function()
  local top = 0
  for _, card in ipairs(cards) do top = math.max(top, card.body.alive and card.body.position.y or 0) end
  return top
end)
