-- ledger, seed 610: of the kinetic energy no line explains 4.142445009658346e-06
local t = {}
local function try(f) return pcall(f) end
try(function() t.body1 = scene:body { mass = 1, inertia = vec(0.01, 0.1, 0.1), at = vec(0.5326, 1.395, 0) + vec(1, 0, 0), points = { a = vec(-0.5, 0, 0), b = vec(0.5, 0, 0) } } end)
try(function() t.body3 = scene:body { mass = 1, inertia = vec(0.01, 0.1, 0.1), at = vec(0.5326, 1.395, 0) + vec(2, 0, 0), points = { a = vec(-0.5, 0, 0), b = vec(0.5, 0, 0) } } end)
try(function() t.tie4 = scene:hinge(t.body1.b, t.body3.a, { collide = true }) end)
try(function() t.body5 = scene:body { mass = 1, inertia = vec(0.01, 0.1, 0.1), at = vec(0.5326, 1.395, 0) + vec(3, 0, 0), points = { a = vec(-0.5, 0, 0), b = vec(0.5, 0, 0) } } end)
try(function() t.tie6 = scene:hinge(t.body3.b, t.body5.a, {  }) end)
try(function() t.body7 = scene:body { mass = 1, inertia = vec(0.01, 0.1, 0.1), at = vec(0.5326, 1.395, 0) + vec(4, 0, 0), points = { a = vec(-0.5, 0, 0), b = vec(0.5, 0, 0) } } end)
try(function() t.tie8 = scene:hinge(t.body5.b, t.body7.a, { breaks_at = { force = 50 } }) end)
try(function() t.body9 = scene:body { mass = 1, inertia = vec(0.01, 0.1, 0.1), at = vec(0.5326, 1.395, 0) + vec(5, 0, 0), points = { a = vec(-0.5, 0, 0), b = vec(0.5, 0, 0) } } end)
try(function() t.tie10 = scene:hinge(t.body7.b, t.body9.a, { axis = vec(0, 0, 1) }) end)
try(function() t.body11 = scene:body { mass = 1, inertia = vec(0.01, 0.1, 0.1), at = vec(0.5326, 1.395, 0) + vec(6, 0, 0), points = { a = vec(-0.5, 0, 0), b = vec(0.5, 0, 0) } } end)
try(function() t.tie12 = scene:hinge(t.body9.b, t.body11.a, {  }) end)
try(function() t.element25 = scene:field(scene, force.point { force = function(p) local y = tonumber(string.format('%.9g', p.position.y)) return vec(0, -y, 0) end }) end)
try(function() scene:at(0.03103, function() try(function() t.tie30 = scene:limit(t.body1.b, t.body11.a, { min = 0.2, max = 0.8682 }) end) end) end)
