-- Boxes, balls and other things fall into a tray and pile up. Drag them, or pour in more.
local count = scene:param("count", 100, { min = 1, max = 2000, step = 1, help = "things" })
local friction = scene:param("friction", 0.5, { min = 0, max = 1.5, help = "of all of them" })

scene.title = "Pile"
scene.duration = 8
scene.camera = { at = vec(4.6, 4.6, 6.4), look_at = vec(0, 0.8, 0) }
scene:floor { height = -0.2, rolling = 0.01, color = "#cfd8d3" }

-- A tray: a bottom and four walls.
local wide, high, thick = 4, 0.8, 0.2
scene:ground {
  color = "#8d7a63",
  shapes = {
    shape.box(wide, thick, wide, { at = vec(0, -thick / 2, 0) }),
    shape.box(thick, high, wide, { at = vec(-wide / 2 - thick / 2, high / 2 - thick, 0) }),
    shape.box(thick, high, wide, { at = vec(wide / 2 + thick / 2, high / 2 - thick, 0) }),
    shape.box(wide + 2 * thick, high, thick, { at = vec(0, high / 2 - thick, -wide / 2 - thick / 2) }),
    shape.box(wide + 2 * thick, high, thick, { at = vec(0, high / 2 - thick, wide / 2 + thick / 2) }),
  },
}

local colors = { "#c2413b", "#e8833a", "#f2b45c", "#6b8e5a", "#3f6f9f", "#7a5a9e" }
local function some(low, high) return low + (high - low) * math.random() end

local makers = {
  function() return shape.box(some(0.25, 0.5), some(0.25, 0.5), some(0.25, 0.5), { friction = friction }) end,
  function() return shape.ball(some(0.14, 0.25), { friction = friction, restitution = 0.3 }) end,
  function() return shape.capsule(some(0.1, 0.16), some(0.2, 0.4), { friction = friction }) end,
  function() return shape.cylinder(some(0.14, 0.22), some(0.2, 0.45), { friction = friction }) end,
  function() return shape.hull(structure.dodecahedron { edge = some(0.14, 0.2) }, { friction = friction }) end,
}

local things = {}
local function drop(i, lowest) -- nine beside each other, and nothing in something else
  local turn = quat(vec(some(-1, 1), some(-1, 1), some(0.1, 1)), some(0, math.pi))
  local kind = i % 2 == 1 and 1 or i % 4 == 2 and 2 or 3 + i // 4 % 3 -- half of them boxes, a quarter balls
  things[#things + 1] = scene:body { shape = makers[kind](), orientation = turn, color = colors[i % #colors + 1],
                                     at = vec(0.95 * (i % 3 - 1) + some(-0.03, 0.03), lowest + 0.9 * (i // 9),
                                              0.95 * (i // 3 % 3 - 1) + some(-0.03, 0.03)) }
end
for i = 1, count do drop(i, 0.8) end

local function pour()
  local most = 2
  for _, one in ipairs(things) do most = math.max(most, one.position.y) end
  for i = 1, 20 do drop(i, most + 1) end
end
scene:every(10, function() if #things < 2 * count then pour() end end)
scene:button("pour in more", pour)
scene:probe("highest", function()
  local most = 0
  for _, one in ipairs(things) do most = math.max(most, one.position.y) end
  return most
end)
