-- A skipping rope: two hands turn it. Take either end out of its hand, or a hand by its end, and turn it yourself.
local links = scene:param("links", 36, { min = 8, max = 200, step = 1, help = "number of links" })
local rate = scene:param("rate", 1.3, { min = 0, max = 3, help = "turns per second" })
local span, slack, swing = 3.4, 1.45, 0.28 -- m between the hands, rope per span, m radius of the hands

scene.title = "Skipping rope"
scene.step = 1 / 960 -- a light rope whips fast
scene.duration = 12
scene.camera = { at = vec(0.7, 1.9, 5.6), look_at = vec(0, 1.2, 0) }

-- The rope hangs in a zigzag at first: equal links between the hands.
local length = span * slack / links
local step, drop = span / links, math.sqrt(length ^ 2 - (span / links) ^ 2)
local mass = 0.012 * 36 / links -- kg
local bead = 0.3 * length -- m, drawn radius
local colours = { "#c2413b", "#e8833a", "#3f6f9f" }

local function corner(i)
  return vec(-span / 2 + i * step, 1.25 - (i % 2) * drop, 0)
end

local rope = scene:group "rope"
local first, middle, previous
for i = 1, links do
  local a, b = corner(i - 1), corner(i)
  local colour = colours[(i - 1) // 4 % #colours + 1]
  local link = scene:body {
    points = {
      head = { at = vec(-length / 2, 0, 0), mass = mass / 2, radius = bead },
      tail = { at = vec(length / 2, 0, 0), mass = mass / 2, radius = bead },
    },
    at = (a + b) / 2, orientation = quat(vec(0, 0, 1), math.atan(b.y - a.y, b.x - a.x)),
    color = "#6b4f3a",
  }
  if previous then rope:add(scene:hinge(previous.tail, link.head, { radius = 1.1 * bead, color = colour })) end
  rope:add(link)
  first, previous = first or link, link
  if i == links // 2 then middle = link end
end

local function hand(x, point)
  local turning = scene:hand {
    path = function(t)
      local soft = math.min(1, t / 2) -- both start gently
      local a = 2 * math.pi * rate * t * soft
      return vec(x, 1.25 - swing * soft * math.cos(a), swing * soft * math.sin(a))
    end,
  }
  turning:grab(point, { max_force = 200 })
end
hand(-span / 2, first.head)
hand(span / 2, previous.tail)

scene:probe("middle height", function() return middle.alive and middle.position.y or 0 end)
