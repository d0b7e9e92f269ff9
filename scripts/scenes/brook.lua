-- A brook: drops spring up, run over rocks, turn a wheel, and splash on the floor. They touch what
-- they meet as small balls.
local flow = scene:param("flow", 60, { min = 0, max = 2000, help = "drops per second" })

scene.title = "Brook"
scene.step = 1 / 240
scene.duration = 12
scene.camera = { at = vec(2.9, 3.1, 4.4), look_at = vec(0.5, 0.75, 0) }

local water = scene:family("water", { solid = true, friction = 0.02, restitution = 0.2, layer = "water",
  mass = 0.02, radius = 0.04, color = "#5aa2d8" })
scene:collide("water", "water", false) -- a law keeps drops apart, instead
scene:interact(water, water, force.repel { stiffness = 100 })

-- The bed falls towards +x; rocks stand in it.
local function bed(x, z) return 1.1 - 0.3 * x + 0.4 * z * z + 0.04 * math.sin(9 * x) * math.cos(7 * z) end
scene:ground { color = "#8b857b", shape = shape.heights { columns = 45, rows = 21, spacing = 0.1, height = bed, friction = 0.5 } }
scene:floor { color = "#c9c3b4", size = 16 }
local rocks = { shape.box(0.1, 0.6, 2, { at = vec(-2.25, bed(-2.2, 0) + 0.1, 0) }) } -- and a weir, above
for _, at in ipairs { vec(-1.1, 0, 0.12), vec(-0.5, 0, -0.3), vec(-0.3, 0, 0.4), vec(0.25, 0, 0), vec(1.5, 0, 0.3), vec(1.6, 0, -0.3) } do
  rocks[#rocks + 1] = shape.ball { radius = 0.16, at = vec(at.x, bed(at.x, at.z), at.z), friction = 0.5 }
end
scene:ground { shapes = rocks, color = "#6e675d" }

-- A wheel with paddles, across the brook, on an axle that stands in the world.
local paddles = {}
for i = 0, 7 do
  local turn = quat(vec(0, 0, 1), math.pi / 4 * i)
  paddles[#paddles + 1] = shape.box(0.4, 0.03, 0.7, { at = turn:rotate(vec(0.2, 0, 0)), orientation = turn, density = 300, color = "#a67c4e" })
end
local wheel = scene:body { shapes = paddles, at = vec(0.9, bed(0.9, 0) + 0.5, 0), name = "wheel",
  points = { front = vec(0, 0, 0.4), back = vec(0, 0, -0.4) } }
scene:nail(wheel.front)
scene:nail(wheel.back)

local spring = scene:emitter { family = water, at = { vec(-1.8, 1.9, -0.2), vec(-1.7, 2.0, 0.2) }, rate = flow, velocity = vec(1, 0, 0),
  spread = 0.3, lifetime = 4 }
scene:probe("drops", function() return spring.count end)
scene:probe("spin of the wheel", function() return wheel.spin.z end)
