-- Jointed figures tumble down a flight of stairs. Drag one by any part, carry it up again, or throw in another.
local count = scene:param("count", 3, { min = 1, max = 20, step = 1, help = "figures" })
local steps = scene:param("steps", 9, { min = 1, max = 20, step = 1, help = "of the stairs" })

scene.title = "Ragdolls on stairs"
scene.duration = 12
scene.camera = { at = vec(6.5, 3.6, 8.5), look_at = vec(1.2, 1.4, 0) }
scene:floor { friction = 0.6, color = "#cfd6da" }

local deep, rise, wide, parts = 0.6, 0.3, 3, {}
for i = 1, steps do
  local high = rise * (steps - i + 1)
  parts[i] = shape.box(deep, high, wide, { at = vec(deep * (i - 0.5), high / 2, 0), friction = 0.5,
                                           color = i % 2 == 0 and "#a08f78" or "#b5a58c" })
end
parts[#parts + 1] = shape.box(2, rise * steps, wide, { at = vec(-1, rise * steps / 2, 0), friction = 0.5, color = "#a08f78" })
scene:ground { shapes = parts }
local joints = scene:family("joints", { radius = 0.05 })
local skin, shirts = "#d9a066", { "#c2413b", "#3f6f9f", "#6b8e5a", "#7a5a9e" }
local function ragdoll(at, velocity, shirt)
  local turn = quat(vec(0, 1, 0), 2 * math.pi * math.random())
  --- A limb of a capsule from one place to another of the upright figure; more are points by name.
  local function limb(from, to, radius, color, more)
    local points = more or {}
    points.root, points.tip = { at = from, family = joints }, { at = to, family = joints }
    return scene:body { shape = shape.capsule { radius = radius, from = from, to = to, density = 985, friction = 0.5 },
                        at = at, orientation = turn, velocity = velocity, color = color, points = points }
  end
  --- Joins, and bends within a range about the figure's axis from side to side.
  local function joint(a, b, upper, lower, min, max)
    scene:hinge(a, b)
    scene:limit(lower, upper, { axis = turn:rotate(vec(0, 0, 1)), min = min, max = max })
  end
  local torso = limb(vec(0, 1.0, 0), vec(0, 1.38, 0), 0.15, shirt, {
    neck = vec(0, 1.55, 0), arm_1 = vec(0, 1.42, 0.24), arm_2 = vec(0, 1.42, -0.24), leg_1 = vec(0, 0.88, 0.1), leg_2 = vec(0, 0.88, -0.1) })
  local head = limb(vec(0, 1.55, 0), vec(0, 1.72, 0), 0.11, skin)
  joint(torso.neck, head.root, torso, head, -0.6, 0.6)
  for side, s in ipairs { 1, -1 } do
    local upper_arm = limb(vec(0, 1.42, 0.24 * s), vec(0, 1.14, 0.3 * s), 0.055, shirt)
    local forearm = limb(vec(0, 1.14, 0.3 * s), vec(0.03, 0.86, 0.32 * s), 0.045, skin)
    local thigh = limb(vec(0, 0.88, 0.1 * s), vec(0, 0.48, 0.12 * s), 0.075, "#39424e")
    local shin = limb(vec(0, 0.48, 0.12 * s), vec(0, 0.08, 0.12 * s), 0.06, "#39424e")
    joint(torso["arm_" .. side], upper_arm.root, torso, upper_arm, -1.5, 2.6)
    joint(upper_arm.tip, forearm.root, upper_arm, forearm, 0, 2.2)
    joint(torso["leg_" .. side], thigh.root, torso, thigh, -0.5, 1.8)
    joint(thigh.tip, shin.root, thigh, shin, -2.2, 0)
  end
  return torso
end
local torsos = {}
local function throw_in(i)
  local at = vec(-0.8, rise * steps + 0.3 + 2 * (i - 1), 1.2 * math.random() - 0.6)
  torsos[#torsos + 1] = ragdoll(at, vec(2.2, 0, 0), shirts[#torsos % #shirts + 1])
end
for i = 1, count do throw_in(i) end
scene:button("throw in another", function() throw_in(1) end)
scene:probe("lowest torso", function()
  local low = math.huge
  for _, torso in ipairs(torsos) do low = math.min(low, torso.position.y) end
  return low
end)
