-- The virtual chain: rigid links on hinges, pinned at one end. Drag any point of it, cut it where you like.
local links = scene:param("links", 20, { min = 1, max = 2000, step = 1, help = "number of links" })
local ratio = scene:param("ratio", 1, { min = 1, max = 1e6, help = "mass of the ball at the end, in masses of a link" })

scene.title = "Virtual chain"
scene.duration = 10
scene.camera = { at = vec(0, 4 - 0.3 * links, 1.9 * links + 4), look_at = vec(0, 4 - 0.45 * links, 0) }

local mass, length, width = 1, 1, 0.1 -- kg, m, m
local across = mass * (length ^ 2 + width ^ 2) / 12
local inertia = vec(mass * width ^ 2 / 6, across, across)

local chain = scene:group "chain"
local previous
for i = 1, links do
  local link = scene:body {
    mass = mass, inertia = inertia, at = vec((i - 0.5) * length, 4, 0),
    points = { head = vec(-length / 2, 0, 0), tail = vec(length / 2, 0, 0) },
    color = i % 2 == 0 and "#e8833a" or "#f2b45c",
  }
  if previous then
    chain:add(scene:hinge(previous.tail, link.head))
  else
    scene:nail(link.head)
  end
  chain:add(link)
  previous = link
end

if ratio > 1 then
  local heavy, radius = ratio * mass, 0.5
  local ball = scene:body {
    mass = heavy, inertia = vec(1, 1, 1) * (0.4 * heavy * radius ^ 2), at = vec(links * length + radius, 4, 0),
    points = { top = vec(-radius, 0, 0), middle = vec(0, 0, 0) }, color = "#3f6f9f",
  }
  chain:add(scene:hinge(previous.tail, ball.top))
end

scene:button("let go", function() chain:cut_hinges() end)
scene:probe("tip height", function() return previous.alive and previous.tail.position.y or 0 end)
