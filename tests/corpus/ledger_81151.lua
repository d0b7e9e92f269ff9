-- ledger, seed 81151: of the kinetic energy no line explains 1.5313985616740373e-06
local t = {}
local function try(f) return pcall(f) end
try(function() scene.integrator = 'implicit' end)
try(function() t.shape1 = scene:ground { shape = shape.box(4, 0.5, 4), at = vec(-0.6766, -0.5962, -1.799) } end)
try(function() t.family6 = scene:family('family6', { attributes = { charge = 0.7868 }, mass = 1.257, radius = 0.1, solid = true }) end)
try(function() t.particle9 = scene:particle { at = vec(0.1226, -0.7304, -1.882), velocity = vec(-0.08653, 0.3195, -0.9813), family = t.family6 } end)
try(function() t.particle11 = scene:particle { at = vec(-0.004435, -1.057, -1.585), velocity = vec(-0.652, -1.218, 0.8853), family = t.family6 } end)
try(function() t.element22 = scene:bonding { families = t.family6, near = 0.5, below = 5, above = 10, law = force.spring { stiffness = 20 } } end)
