-- What a hinge is: a ring of member points of different bodies, with local data each and global data they share. Pull it, cut it.
local spread = 0.4
scene:param("spread", spread, { min = 0.1, max = 0.6, help = "how far members are drawn from their hinge, m",
  on_change = function(v) spread = v end })

scene.title = "Rings"
scene.duration = 14
scene.gravity = vec(0, 0, 0)
scene.camera = { at = vec(0, 2.9, 8.6), look_at = vec(0, 2.6, 0) }

local hub, turning = vec(0, 2.6, 0), vec(0, 0, 0.45)

local function stick(name, from, angle, length, color)
  local middle = from + vec(math.cos(angle), math.sin(angle), 0) * (length / 2)
  return scene:body {
    name = name, at = middle, orientation = quat(vec(0, 0, 1), angle), spin = turning, velocity = turning:cross(middle - hub),
    points = { tail = { at = vec(-length / 2, 0, 0), mass = 0.5, color = color }, head = { at = vec(length / 2, 0, 0), mass = 1, color = color } },
  }
end

local up, third = math.pi / 2, 2 * math.pi / 3
local a, b, c = stick("a", hub, up, 1.4, "#d8573c"), stick("b", hub, up + third, 1.5, "#2f78b7"), stick("c", hub, up - third, 1.5, "#3f9a63")
local d = stick("d", a.head.position, up + 0.7, 1, "#e0a030")
local e = stick("e", b.head.position, up + third, 1, "#2fa3a0")
local f = stick("f", c.head.position, up - third - 0.7, 1, "#8a5ab5")
local g = stick("g", c.head.position, up - third + 0.7, 1, "#c8578c")

scene:hinge(a.tail, b.tail, c.tail, { name = "hub" })
scene:hinge(a.head, d.tail, { name = "upper" })
scene:hinge(b.head, e.tail, { name = "left" })
scene:hinge(c.head, f.tail, g.tail, { name = "right" })

-- Members stand round their hinge, between the bodies; each leads to its body, and by an arrow to the next of the ring.
local function show(hinge)
  local at, points, places = hinge.position, hinge.points, {}
  local first = points[1].body.position - at
  for i = 1, #points do
    local angle = math.atan(first.y, first.x) + math.pi * (2 * i - 1) / #points
    places[i] = at + vec(math.cos(angle), math.sin(angle), 0) * spread
  end
  for i, point in ipairs(points) do
    local place, next_place = places[i], places[i % #points + 1]
    scene.draw:line(place, point.body.position, { color = point.color, width = 1 })
    scene.draw:arrow(place, place + (next_place - place) * 0.86)
    scene.draw:point(place, { color = point.color, size = 13 })
    scene.draw:text(place + (place.x < at.x and vec(-0.62, 0.16, 0) or vec(0.08, 0.16, 0)), ("%s: %.1f kg\n%.2f N"):format(point.body.name, point.mass,
      hinge:force(point.body):length()), { size = 16 })
  end
  scene.draw:text(at + vec(-0.4, 0.5 + spread, 0), ("%s: ring of %d\n%.1f kg, %.2f m/s"):format(hinge.name, #points,
    hinge.mass, hinge.velocity:length()), { color = "#d04a3c", size = 16 })
end

scene:on("step", function()
  for _, hinge in ipairs(scene.hinges) do show(hinge) end
  scene.draw:text(vec(14, -70, 0), "over a ring: global data, shared\nat a dot: local data, a member's own", { space = "screen", size = 18 })
end)
