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
local cards = scene:group "cards"
local function put(card, x, y, angle)
  cards:add(scene:body { shape = card, at = vec(x, y, 0), orientation = quat(vec(0, 0, 1), angle),
                         color = colors[#cards % #colors + 1] })
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

local function throw()
  scene:ball { radius = 0.12, density = 1500, at = vec(-4, 0.8, 0), velocity = vec(7, 2, 0), color = "#e8833a" }
end
scene:at(8, throw)
scene:button("throw", throw)
scene:probe("top of the house", function()
  local top = 0
  for one in cards:each() do top = math.max(top, one.position.y) end
  return top
end)
