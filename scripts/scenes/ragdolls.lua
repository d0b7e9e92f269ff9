-- Jointed figures tumble down a flight of stairs. Drag one by any part, carry it up again, or throw in another.
local count = scene:param("count", 5, { min = 1, max = 20, step = 1, help = "figures that may lie about; then the first one goes" })
local steps = scene:param("steps", 9, { min = 1, max = 20, step = 1, help = "of the stairs" })

scene.title, scene.duration, scene.step = "Ragdolls on stairs", 12, 1 / 480
scene.camera = { at = vec(6.5, 3.6, 8.5), look_at = vec(1.6, 1.3, 0) }
scene:floor { friction = 0.6, size = 30, color = "#cfd6da" }

local deep, rise, wide, parts = 0.45, 0.3, 3, {}
for i = 0, steps do
  local high, long = rise * math.min(steps, steps - i + 1), i == 0 and 2 or deep
  parts[i + 1] = shape.box(long, high, wide, { at = vec(deep * i - long / 2, high / 2, 0), friction = 0.3,
                                               color = i % 2 == 0 and "#a08f78" or "#b5a58c" })
end
scene:ground { shapes = parts }
local joints, skin, shirts = scene:family("joints", { radius = 0.05 }), "#d9a066", { "#c2413b", "#3f6f9f", "#6b8e5a", "#7a5a9e" }
local function ragdoll(at, velocity, shirt)
  local turn, limbs = quat(vec(0, 1, 0), 2 * math.pi * math.random()), {}
  --- A capsule from one place to another of the upright figure; more are points by name.
  local function limb(from, to, radius, color, more)
    local points = more or {}
    points.root, points.tip = { at = from, family = joints }, { at = to, family = joints }
    limbs[#limbs + 1] = scene:body { shape = shape.capsule { radius = radius, from = from, to = to, density = 985, friction = 0.3 },
                                     at = at, orientation = turn, velocity = velocity, color = color, points = points }
    return limbs[#limbs]
  end
  --- Hinges that bend within a range about the axis from side to side. Shoulders and hips turn about any.
  local axis = turn:rotate(vec(0, 0, 1))
  local function joint(a, b, upper, lower, min, max)
    scene:hinge(a, b, { axis = axis })
    scene:limit(lower, upper, { axis = axis, min = min, max = max })
  end
  local torso = limb(vec(0, 1, 0), vec(0, 1.38, 0), 0.15, shirt, {
    neck = vec(0, 1.55, 0), arm_1 = vec(0, 1.42, 0.24), arm_2 = vec(0, 1.42, -0.24), leg_1 = vec(0, 0.88, 0.1), leg_2 = vec(0, 0.88, -0.1) })
  local head = limb(vec(0, 1.55, 0), vec(0, 1.72, 0), 0.11, skin)
  joint(torso.neck, head.root, torso, head, -0.6, 0.6)
  for side, s in ipairs { 1, -1 } do
    local upper_arm = limb(vec(0, 1.42, 0.24 * s), vec(0, 1.14, 0.3 * s), 0.055, shirt)
    local forearm = limb(vec(0, 1.14, 0.3 * s), vec(0.03, 0.86, 0.32 * s), 0.045, skin)
    local thigh = limb(vec(0, 0.88, 0.1 * s), vec(0, 0.48, 0.12 * s), 0.075, "#39424e")
    local shin = limb(vec(0, 0.48, 0.12 * s), vec(0, 0.08, 0.12 * s), 0.06, "#39424e")
    scene:hinge(torso["arm_" .. side], upper_arm.root)
    joint(upper_arm.tip, forearm.root, upper_arm, forearm, 0, 2.2)
    scene:hinge(torso["leg_" .. side], thigh.root)
    joint(thigh.tip, shin.root, thigh, shin, -2.2, 0)
  end
  return limbs -- the torso first
end
local figures, thrown = {}, 0
local function throw_in()
  for _, limb in ipairs(#figures == count and table.remove(figures, 1) or {}) do if limb.alive then limb:remove() end end
  thrown = thrown + 1
  local at = vec(-0.8, rise * steps + 0.3, 1.2 * math.random() - 0.6)
  figures[#figures + 1] = ragdoll(at, vec(3, 0, 0), shirts[thrown % #shirts + 1])
end
throw_in()
scene:every(4, throw_in)
scene:button("throw in another", throw_in)
scene:probe("thrown in", function() return thrown end)
