-- Two sheets of rigid parts on hinges, pulled by the same grips. The squares turn, and their sheet becomes wider all
-- ways; the trellis beside it becomes thinner, as most things do: its Poisson's ratio is (length / height)².
local stretch, trellis = require "stretch", require "trellis"
local n = scene:param("cells", 6, { min = 2, max = 12, step = 2, help = "squares along each edge" })
local strain = scene:param("strain", 0.24, { min = 0.01, max = 0.26, help = "largest, by the grips" })
local lean = scene:param("lean", 50, { min = 10, max = 70, help = "of the trellis' bars at first, degrees" })

assert((1 + strain) * math.cos(math.rad(lean)) < 0.99, "the bars are too short to be drawn so far: more lean or less strain")

scene.title = "Auxetic"
scene.gravity = vec(0, 0, 0)
scene.duration = 12
scene.camera = { at = vec(0, 0, 8.4), look_at = vec(0, 0, 0) }

local length, angle, left, right = 3.2, 0.1, vec(-2.2, 0, 0), vec(2.2, 0, 0)
local squares = structure.rotating_squares {
  columns = n, rows = n, angle = angle, edge = length / (n * (math.cos(angle) + math.sin(angle))),
}
local sheet = scene:build(squares, { as = "panels", at = left, color = "#3f6fb0", name = "squares" })

stretch("squares", sheet.particles, left, strain)
stretch("trellis", trellis(n, length, math.rad(lean), right, "#4c9f70"), right, strain)
