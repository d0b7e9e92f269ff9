-- ledger, seed 70092: of the kinetic energy no line explains 1.0925362940917147e-06
local t = {}
local function try(f) return pcall(f) end
try(function() t.particle7 = scene:particle { at = vec(-0.5517, -0.8384, -1.72), velocity = vec(-0.6066, 1.939, 1.275) } end)
try(function() t.body15 = scene:body { mass = 1, inertia = vec(0.01, 0.1, 0.1), at = vec(1.225, -0.8827, -0.2227) + vec(2, 0, 0), points = { a = vec(-0.5, 0, 0), b = vec(0.5, 0, 0) } } end)
try(function() t.element23 = scene:field(scene, force.point { force = function(p) return vec(0.4966, 0.6021, -0.8471):cross(p.velocity) * p.mass end }) end)
try(function() t.tie24 = scene:string({ t.particle7, t.body15.b }, { length = 1.92 }) end)
