-- Two sheets of rigid parts on hinges, pulled by the same grips. The squares turn, and their sheet becomes wider all
-- ways; the trellis beside it becomes thinner.
local stretch, trellis = require "stretch", require "trellis"
local n = scene:param("cells", 6, { min = 2, max = 12, step = 2, help = "squares along each edge" })
local strain = scene:param("strain", 0.24, { min = 0.01, max = 0.26, help = "largest, by the grips" })

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
stretch("trellis", trellis(n, length, math.rad(50), right, "#4c9f70"), right, strain)
