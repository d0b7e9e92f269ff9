-- A marble run: marbles circle in a funnel, drop through it onto rails, and roll down them from side to side. What reaches the
-- ground is put back on top. Stop one with a finger, or make the rails steeper.
local count = scene:param("count", 8, { min = 1, max = 40, step = 1, help = "marbles" })
local slope = scene:param("slope", 0.12, { min = 0.03, max = 0.3, help = "of the rails, rad" })

scene.title, scene.duration = "Marble run", 40
scene.camera = { at = vec(0.7, 1.9, 3.0), look_at = vec(-0.05, 1, 0) }
scene:floor { color = "#d9d2c4", size = 12 }

-- Rails of two capsules, each pair below the end of the one before, with boards that keep marbles on them.
local radius, gauge, long, drop, base, parts = 0.032, 0.045, 1.4, 0.26, 1.5, {}
for i = 1, 5 do
  local way = i % 2 == 1 and 1 or -1
  local from = vec(-way * 0.5 * long, base - drop * (i - 1), 0)
  local to = from + vec(way * (long - 0.11), -slope * (long - 0.11), 0)
  local along = quat(vec(0, 0, 1), -way * math.atan(slope))
  for side = -1, 1, 2 do
    local aside = vec(0, 0, side * gauge / 2)
    parts[#parts + 1] = shape.capsule { radius = 0.012, from = from + aside, to = to + aside, color = "#b98a50" }
    local beside = 0.5 * (from + to) + vec(0, 0.09, 0.065 * side)
    parts[#parts + 1] = shape.box(long, 0.02, 0.01, { at = beside, orientation = along, color = "#d9a066" })
  end
  parts[#parts + 1] = shape.box(0.02, drop + 0.1, 0.14, { at = vec(way * (0.5 * long + 0.01), to.y - 0.06, 0), color = "#3f6f9f" })
end

-- The funnel: a bowl of triangles that grows steeper towards its hole.
local sides, hole, rim, mouth = 48, 0.055, 0.42, vec(-0.5 * long + 0.1, base + 0.12, 0)
local vertices, faces = {}, {}
for r = 0, 8 do
  local u = r / 8
  for s = 0, sides - 1 do
    local a, wide, b, next = 2 * math.pi * s / sides, hole + (rim - hole) * u, (r - 1) * sides + 1, (s + 1) % sides
    vertices[#vertices + 1] = mouth + vec(wide * math.cos(a), 0.3 * u ^ 0.6, wide * math.sin(a))
    if r > 0 then faces[#faces + 1] = { b + s, b + next, b + sides + next, b + sides + s } end
  end
end
parts[#parts + 1] = shape.mesh { vertices = vertices, faces = faces, friction = 0.05, color = "#9fb4c0" }
scene:ground { shapes = parts }

local colors = { "#c2413b", "#3f6f9f", "#6b8e5a", "#f2b45c", "#7a5a9e" }
local marbles, rounds = {}, 0
local function start(marble)
  marble.position = mouth + vec(0, 0.36, rim - 0.08)
  marble.velocity, marble.spin = vec(1.1, 0, 0), vec(0, 0, 0)
end
for i = 1, count do
  marbles[i] = scene:ball { radius = radius, density = 2500, restitution = 0.3, friction = 0.15, color = colors[i % #colors + 1],
                            at = vec(2 + 0.1 * i, radius, 0) }
  scene:at(1.2 * i - 1.1, marbles[i], start)
end
scene:every(1.2, function()
  for _, marble in ipairs(scene.time > 1.2 * count and marbles or {}) do
    if marble.position.y < 0.1 then
      rounds = rounds + 1
      return start(marble)
    end
  end
end)
scene:probe("rounds", function() return rounds end)
