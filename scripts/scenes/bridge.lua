-- A truss bridge of steel bars, springs a thousand times too stiff for ordinary steps, and trucks that cross it, each half as
-- heavy again as the one before. When a bar breaks, a new bridge is built.
local weight = scene:param("weight", 1200, { min = 100, max = 1e5, help = "of the first truck, kg" })
local stiffness = scene:param("stiffness", 2e7, { min = 1e5, max = 1e9, help = "of a bar, N/m" })
local strength = scene:param("strength", 3.6e4, { min = 1e3, max = 1e6, help = "force at which a bar breaks, N" })

scene.title, scene.duration = "Truss bridge", 60
scene.step = 1 / 360
scene.camera = { at = vec(2.2, 1.2, 10), look_at = vec(0, -0.6, 0) }

-- A river between two banks.
scene:floor { height = -3, color = "#a9cfe0", layer = "water" }
scene:collide("water", "falls", false) -- what falls in is gone
for _, way in ipairs { -1, 1 } do
  scene:ground { shape = shape.box(8, 3, 3, { at = vec(8.02 * way, -1.5, 0), friction = 0.9 }), color = "#9c9484" }
end

local joints = scene:family("joints", { mass = 40, radius = 0.08, color = "#d8dee9" })
local steel = force.spring { stiffness = stiffness, damping = 400, implicit = true }
local function bar(a, b)
  if not (a and b) then return end
  scene:connect(a, b, steel, { breaks_at = { force = strength } })
end

local plates = {}
--- Two trusses of eight bays, 1 m each, and over each bay a plate of the road, on hinges.
local function build()
  local road, deep = { {}, {} }, { {}, {} }
  for side, z in ipairs { -0.75, 0.75 } do
    local r, d = road[side], deep[side]
    for i = 0, 8 do
      r[i] = scene:particle { at = vec(i - 4, -0.06, z), family = joints }
      if i > 0 and i < 8 then d[i] = scene:particle { at = vec(i - 4, -1.1, z), family = joints } end
    end
    for i = 1, 8 do
      bar(r[i], d[i])
      bar(d[i - 1], d[i])
      if i <= 4 then bar(r[i - 1], d[i]) else bar(d[i - 1], r[i]) end
    end
    scene:nail(r[0])
    scene:on_plane(r[8], { normal = vec(0, 1, 0) }) -- it may slide, as on rollers
  end
  for i = 1, 8 do
    bar(road[1][i], deep[2][i])
    bar(road[2][i], deep[1][i])
    bar(deep[1][i], deep[2][i])
    bar(deep[1][i - 1], deep[2][i])
    bar(deep[2][i - 1], deep[1][i])
    local plate = scene:box { size = vec(0.99, 0.12, 1.4), at = vec(i - 4.5, -0.06, 0), mass = 60, friction = 0.9, layer = "falls", color = "#6b7280",
      points = { vec(-0.5, 0, -0.75), vec(0.5, 0, -0.75), vec(-0.5, 0, 0.75), vec(0.5, 0, 0.75) } }
    plates[i] = plate
    for n, point in ipairs(plate.points) do scene:hinge(road[(n + 1) // 2][i - n % 2], point) end
  end
end

--- A truck with a wheel as wide as itself on each axle.
local truck, load, whole
local function drive_up()
  truck = scene:body { at = vec(-7, 0.45, 0), mass = load, color = "#c2413b", layer = "falls",
    shapes = { shape.box(1.5, 0.16, 0.8), shape.box(0.4, 0.5, 0.8, { at = vec(0.5, 0.33, 0) }) },
    points = { vec(-0.5, -0.2, 0), vec(0.5, -0.2, 0) } }
  for _, point in ipairs(truck.points) do
    local wheel = scene:cylinder { radius = 0.2, length = 0.9, axis = vec(0, 0, 1), at = point.position, mass = 100, friction = 0.9, layer = "falls",
                                   color = "#2f343c", points = { vec(0, 0, 0) } }
    scene:hinge(point, wheel.points[1], { axis = vec(0, 0, 1) })
    scene:motor(wheel, truck, { axis = vec(0, 0, 1), speed = -9, max_torque = load })
  end
end
local function start()
  for _, body in ipairs(scene.bodies) do body:remove() end
  for _, particle in ipairs(scene.particles) do particle:remove() end
  load, whole = weight, true
  build()
  drive_up()
end
start()
scene:on("broke", function()
  if not whole then return end
  whole = false
  for _, plate in ipairs(plates) do for _, hinge in ipairs(plate.hinges) do hinge:cut(plate) end end
  scene:after(4, start)
end)
scene:on("step", function()
  if whole and truck.position.x > 6 then
    for _, hinge in ipairs(truck.hinges) do for _, body in ipairs(hinge.bodies) do if body ~= truck then body:remove() end end end
    truck:remove()
    load = 1.5 * load
    drive_up()
  end
  scene.draw:text(truck.position + vec(-0.4, 1.1, 0), ("%.1f t"):format(load / 1000), { size = 16 })
end)
scene:probe("load", function() return load end)
