-- ledger, seed 70039: of the kinetic energy no line explains 7.2400864698409795e-06
local t = {}
local function try(f) return pcall(f) end
try(function() t.family4 = scene:family('family4', { attributes = { charge = -0.9038 }, mass = 0.6423, radius = 0.1, solid = true, friction = 1.006 }) end)
try(function() t.particle7 = scene:particle { at = vec(0.8472, -1.561, -1.534), velocity = vec(1.837, -0.4114, 0.7709), family = t.family4, lifetime = 0.3347 } end)
try(function() t.body18 = scene:body { mass = 1, inertia = vec(0.01, 0.1, 0.1), at = vec(-0.6633, -0.0607, 0.3942) + vec(3, 0, 0), points = { a = vec(-0.5, 0, 0), b = vec(0.5, 0, 0) } } end)
try(function() t.tie38 = scene:join(t.body18.b, t.particle7) end)
try(function() t.element41 = scene:field(t.family4, force.point { force = function(p) local y = tonumber(string.format('%.9g', p.position.y)) return vec(0, -y, 0) end }) end)
