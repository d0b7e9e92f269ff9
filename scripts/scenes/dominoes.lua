-- Dominoes in a spiral: a tap on the first makes all of them fall. Drag any of them; the button taps again.
local count = scene:param("count", 120, { min = 2, max = 600, step = 1, help = "dominoes" })
local spacing = scene:param("spacing", 0.24, { min = 0.1, max = 0.4, help = "between them, m" })

scene.title = "Dominoes"
scene.duration = 12
scene.step = 1 / 480
scene.camera = { at = vec(0, 5.2, 6.8), look_at = vec(0, 0, 0.5) }
scene:floor { friction = 0.7, color = "#dfe5e8" }

local stone = shape.box { size = vec(0.08, 0.5, 0.25), density = 700, friction = 0.3 }
local colors = { "#c2413b", "#e8833a", "#f2b45c", "#6b8e5a", "#3f6f9f", "#7a5a9e" }

-- Along a spiral, at equal ways.
local dominoes, angle = {}, 0
for i = 1, count do
  local radius = 1 + 0.13 * angle
  local at = vec(radius * math.cos(angle), 0.25, radius * math.sin(angle))
  local along = vec(0.13 * math.cos(angle) - radius * math.sin(angle), 0,
                    0.13 * math.sin(angle) + radius * math.cos(angle))
  dominoes[i] = scene:body { shape = stone, at = at, orientation = quat(vec(0, 1, 0), math.atan(-along.z, along.x)),
                             color = colors[(i - 1) // 20 % #colors + 1] }
  angle = angle + spacing / along:length()
end

local function tap()
  local first, second = dominoes[1], dominoes[2]
  local way = (second.position - first.position):normalized()
  first:kick(way * (0.6 * first.mass), first.position + vec(0, 0.24, 0))
end
scene:at(0.5, tap)
scene:button("tap", tap)

-- When all have lain for a while they are stood up again, and tapped.
local places = {}
for i, one in ipairs(dominoes) do places[i] = { one.position, one.orientation } end
local function stand_up()
  for i, one in ipairs(dominoes) do
    one.position, one.orientation = places[i][1], places[i][2]
    one.velocity, one.spin = vec(0, 0, 0), vec(0, 0, 0)
  end
  scene:after(1, tap)
end
scene:button("stand them up", stand_up)

local function fallen()
  local number = 0
  for _, one in ipairs(dominoes) do
    if one.orientation:rotate(vec(0, 1, 0)).y < 0.8 then number = number + 1 end
  end
  return number
end
scene:probe("fallen", fallen)
scene:when(function() return fallen() == count end, function()
  scene:result("all fell until", scene.time)
  scene:after(3, stand_up)
end, { again = true })
