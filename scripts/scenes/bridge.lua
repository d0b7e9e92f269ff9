-- A truss bridge of steel bars, springs a thousand times too stiff for ordinary steps, and trucks that cross it, each half as
-- heavy again as the one before. When a bar breaks, a new bridge is built.
local truss = require "truss"
local weight = scene:param("weight", 1200, { min = 100, max = 1e5, help = "of the first truck, kg" })
local stiffness = scene:param("stiffness", 2e7, { min = 1e5, max = 1e9, help = "of a bar, N/m" })
local strength = scene:param("strength", 3.6e4, { min = 1e3, max = 1e6, help = "force at which a bar breaks, N" })

scene.title, scene.duration, scene.step = "Truss bridge", 60, 1 / 360
scene.camera = { at = vec(2.2, 1.2, 10), look_at = vec(0, -0.6, 0) }
scene:floor { height = -3, color = "#a9cfe0", layer = "water" }
scene:collide("water", "falls", false) -- what falls into the river is gone
for _, x in ipairs { -8.02, 8.02 } do
  scene:ground { shape = shape.box(8, 3, 3, { at = vec(x, -1.5, 0), friction = 0.9 }), color = "#9c9484" }
end

local joints = scene:family("joints", { mass = 40, radius = 0.08, color = "#d8dee9" })
local steel = force.spring { stiffness = stiffness, damping = 400, implicit = true }
local function bar(a, b) scene:connect(a, b, steel, { breaks_at = { force = strength } }) end
local function plate(at)
  return scene:box { size = vec(0.99, 0.12, 1.4), at = at, mass = 60, friction = 0.9, layer = "falls", color = "#6b7280",
                     points = { vec(-0.5, 0, -0.75), vec(0.5, 0, -0.75), vec(-0.5, 0, 0.75), vec(0.5, 0, 0.75) } }
end

--- A truck with a wheel as wide as itself on each axle.
local truck, plates, load, whole
local function drive_up()
  local body = scene:body { at = vec(-7, 0.45, 0), mass = load, color = "#c2413b", layer = "falls",
    shapes = { shape.box(1.5, 0.16, 0.8), shape.box(0.4, 0.5, 0.8, { at = vec(0.5, 0.33, 0) }) },
    points = { vec(-0.5, -0.2, 0), vec(0.5, -0.2, 0) } }
  truck = { body }
  for i, point in ipairs(body.points) do
    truck[i + 1] = scene:cylinder { radius = 0.2, length = 0.9, axis = vec(0, 0, 1), at = point.position, mass = 100, friction = 0.9,
                                    layer = "falls", color = "#2f343c", points = { vec(0, 0, 0) } }
    scene:hinge(point, truck[i + 1].points[1], { axis = vec(0, 0, 1) })
    scene:motor(truck[i + 1], body, { axis = vec(0, 0, 1), speed = -9, max_torque = load })
  end
end
local function start()
  for _, body in ipairs(scene.bodies) do body:remove() end
  for _, particle in ipairs(scene.particles) do particle:remove() end
  load, whole, plates = weight, true, truss(8, joints, bar, plate)
  drive_up()
end
start()
scene:on("broke", function()
  if not whole then return end
  whole = false
  for _, piece in ipairs(plates) do for _, hinge in ipairs(piece.hinges) do hinge:cut(piece) end end
  scene:after(4, start)
end)
scene:on("step", function()
  if whole and truck[1].position.x > 6 then
    for _, thing in ipairs(truck) do thing:remove() end
    load = 1.5 * load
    drive_up()
  end
  scene.draw:text(truck[1].position + vec(-0.4, 1.1, 0), ("%.1f t"):format(load / 1000), { size = 16 })
end)
scene:probe("load", function() return load end)
