-- C60 four times: a rigid body, springs, rods on hinges (which fall in), plates on hinges. All from one molecule, all on one floor.
local height = scene:param("height", 2, { min = 1, max = 6, help = "of the fall, m" })
local hold = scene:param("hold", 3, { min = 0, max = 50, help = "how hard the springs keep their angles, J" })

scene.title = "Buckyballs"
scene.step = 1 / 960
scene.duration = 8
scene.camera = { at = vec(-0.3, 1.9, 9.8), look_at = vec(-0.3, 1.1, 0) }

local c60 = structure.molecule("c60.xyz", { scale = 0.2 }):rotate(quat(vec(1, 0.3, 0.2), 0.4))
local lowest = 0
for _, p in ipairs(c60.vertices) do lowest = math.min(lowest, p.y) end

local floor = force.wall { through = vec(0, 0, 0), normal = vec(0, 1, 0), stiffness = 250, damping = 0.4, friction = 0.3, slip = 0.01 }
local springs = { edge = force.spring { stiffness = 400, damping = 0.1 }, angle = force.angle { stiffness = hold } }
local balls = {}
local function drop(form, x, color, laws)
  local atoms = scene:family(form, { color = color, radius = 0.06 })
  scene:field(atoms, floor)
  balls[form] = scene:build(c60, {
    as = form, mass = 1, at = vec(x, height - lowest, 0), family = atoms, color = color, radius = 0.06, laws = laws, name = form,
  })
  scene:probe(form, function() -- m, its size upright
    local low, high = balls[form]:bounds()
    return high.y - low.y
  end)
end
drop("rigid", -2.7, "#d8573c")
drop("deformable", -0.9, "#e0a33a", springs)
drop("articulated", 0.9, "#4c9f70")
drop("panels", 2.7, "#3f6fb0")
