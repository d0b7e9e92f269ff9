-- crash, seed 1036: ended by signal 11 (Segmentation fault)
local t = {}
local function try(f) return pcall(f) end
try(function() t.body17 = scene:box { size = vec(0.9, 0.2, 0.2), at = vec(-1.881, 1.725, -0.4618) + vec(1, 0, 0), points = { a = vec(-0.5, 0, 0), b = vec(0.5, 0, 0) }, friction = 1.149, sensor = true } end)
try(function() t.body18 = scene:box { size = vec(0.9, 0.2, 0.2), at = vec(-1.881, 1.725, -0.4618) + vec(2, 0, 0), points = { a = vec(-0.5, 0, 0), b = vec(0.5, 0, 0) }, friction = 0.2991 } end)
try(function() t.tie19 = scene:hinge(t.body17.b, t.body18.a, { breaks_at = { force = 50 } }) end)
try(function() t.tie24 = scene:on_path(t.body17.b, { t.body17.b.position, vec(-1.997, 1.571, 1.49), vec(-0.1372, 1.462, 0.591) }, { smooth = false, closed = false }) end)
try(function() t.element27 = scene:field(scene, force.vortex { axis = vec(0, 0, 1), circulation = 5, core = 0.5, linear = 0.2 }) end)
