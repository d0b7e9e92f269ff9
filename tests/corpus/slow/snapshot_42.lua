-- snapshot, seed 42: put back: other bits after step 21
local t = {}
local function try(f) return pcall(f) end
try(function() scene.step = 1 / 60 end)
try(function() t.shape1 = scene:floor { height = -2, surface_velocity = vec(1, 0, 0) } end)
try(function() t.body3 = scene:box { size = vec(0.9, 0.2, 0.2), at = vec(1.023, -1.921, -0.585) + vec(1, 0, 0), points = { a = vec(-0.5, 0, 0), b = vec(0.5, 0, 0) }, friction = 0.1995, restitution = 0.5518 } end)
try(function() t.tie4 = scene:nail(t.body3.a) end)
try(function() t.body5 = scene:box { size = vec(0.9, 0.2, 0.2), at = vec(1.023, -1.921, -0.585) + vec(2, 0, 0), points = { a = vec(-0.5, 0, 0), b = vec(0.5, 0, 0) } } end)
try(function() t.tie6 = scene:hinge(t.body3.b, t.body5.a, { collide = true }) end)
try(function() t.body7 = scene:box { size = vec(0.9, 0.2, 0.2), at = vec(1.023, -1.921, -0.585) + vec(3, 0, 0), points = { a = vec(-0.5, 0, 0), b = vec(0.5, 0, 0) }, friction = 1.284 } end)
try(function() t.tie8 = scene:hinge(t.body5.b, t.body7.a, { collide = true }) end)
try(function() t.body9 = scene:box { size = vec(0.9, 0.2, 0.2), at = vec(1.023, -1.921, -0.585) + vec(4, 0, 0), points = { a = vec(-0.5, 0, 0), b = vec(0.5, 0, 0) }, restitution = 0.6001 } end)
try(function() t.tie10 = scene:hinge(t.body7.b, t.body9.a, {  }) end)
try(function() t.body11 = scene:box { size = vec(0.9, 0.2, 0.2), at = vec(1.023, -1.921, -0.585) + vec(5, 0, 0), points = { a = vec(-0.5, 0, 0), b = vec(0.5, 0, 0) } } end)
try(function() t.tie12 = scene:hinge(t.body9.b, t.body11.a, { axis = vec(0, 0, 1) }) end)
try(function() t.tie13 = scene:follow(t.body11.b, (function(from) return function(time) return from + vec(-0.1294, 0.7018, -0.321) * time end end)(t.body11.b.position)) end)
try(function() t.tie19 = scene:motor(t.body9, t.body3, { axis = vec(0, 1, 0), speed = function(time) return time < 0.00885 and 3.419 or -4.206 end }) end)
try(function() t.tie20 = scene:on_path(t.body7.a, { t.body7.a.position, vec(0.623, -1.002, -0.3667), vec(-0.7418, 1.3, -1.256) }, { smooth = true, closed = true }) end)
try(function() t.tie21 = scene:nail(t.body7.b) end)
