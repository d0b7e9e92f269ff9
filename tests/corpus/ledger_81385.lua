-- ledger, seed 81385: of the kinetic energy no line explains 0.06771283589678113
local t = {}
local function try(f) return pcall(f) end
try(function() scene.accuracy = 1e-4 end)
try(function() t.shape1 = scene:floor { height = -2.117, friction = 0.6296 } end)
try(function() t.body2 = scene:box { size = 0.7468, friction = 0.3163, at = vec(1.9, -2.345, 1.663), spin = vec(-2.316, 4.605, -0.6139), orientation = quat(vec(0, 0, 1), 2.266), points = { a = vec(-0.5039, 0, 0), b = vec(0.5039, 0, 0) } } end)
try(function() t.particle12 = scene:particle { at = vec(-1.21, -1.33, -1.082), velocity = vec(0.5757, -1.416, 0.7649), family = t.family10 } end)
try(function() t.particle16 = scene:particle { at = vec(0.8436, 0.9389, -0.04486), velocity = vec(0.156, -0.8736, 1.344), family = t.family5 } end)
try(function() t.tie26 = scene:align(t.body2, vec(0, 1, 0), vec(0, 1, 0), { angle = 0 }) end)
try(function() t.element27 = scene:connect(t.particle16, t.particle12, force.pair { potential = function(r) return 15.95 * (r - 1) ^ 2 end }) end)
