-- A trellis of rigid bars becomes thinner where it is pulled, as most things do. Its Poisson's ratio is
-- (length / height)², so it grows with every pull.
local stretch, trellis = require "stretch", require "trellis"
local n = scene:param("bars", 6, { min = 1, max = 12, step = 1, help = "bars each way, less one" })
local lean = scene:param("lean", 55, { min = 10, max = 80, help = "of the bars at first, degrees" })
local strain = scene:param("strain", 0.4, { min = 0.01, max = 2, help = "largest, by the grips" })

scene.title = "Non-auxetic"
scene.gravity = vec(0, 0, 0)
scene.duration = 12
scene.camera = { at = vec(0, 0, 9), look_at = vec(0, 0, 0) }

local angle = math.rad(lean)
assert((1 + strain) * math.cos(angle) < 0.99, "the bars are too short to be drawn so far: less lean or less strain")
stretch("trellis", trellis(n, 3.4, angle, vec(0, 0, 0), "#4c9f70"), vec(0, 0, 0), strain)
