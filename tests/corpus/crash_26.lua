-- crash, seed 26: ended by signal 11 (Segmentation fault)
local t = {}
local function try(f) return pcall(f) end
try(function() t.body22 = scene:body { mass = 1000, inertia = vec(0.01, 0.1, 0.1), at = vec(1.974, 0.1316, 0.8143) + vec(6, 0, 0), points = { a = vec(-0.5, 0, 0), b = vec(0.5, 0, 0) } } end)
try(function() t.element26 = scene:field(scene, force.wind { velocity = vec(-0.4945, 3.927, 0.2454), linear = 0.3, quadratic = 0.1 }) end)
try(function() t.tie29 = scene:on_path(t.body22.b, { t.body22.b.position, vec(1.731, 1.312, -1.254), vec(-1.38, -0.7242, -1.806) }, { smooth = true, closed = false }) end)
