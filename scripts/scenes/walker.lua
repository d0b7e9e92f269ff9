-- Theo Jansen's walking mechanism: six legs on one crank, in a plane, walk over steps and up and down slopes. Turn its speed,
-- or drag it by any joint.
scene.title, scene.duration = "Strandbeest", 20
scene.plane, scene.step, scene.contact = "xy", 1 / 480, "exact"
local speed = scene:param("speed", 2, { min = -6, max = 6, help = "of the crank, rad/s" })
local friction = scene:param("friction", 0.8, { min = 0, max = 2, help = "of feet and floor" })

-- His "eleven holy numbers", m.
local a, b, c, d, e, f = 0.380, 0.415, 0.393, 0.401, 0.558, 0.394
local g, h, i, j, k, l, m = 0.367, 0.657, 0.490, 0.500, 0.619, 0.078, 0.150
--- The place at two distances from two others, left of the way between them.
local function left(p, q, from_p, from_q)
  local way = q - p
  local n = way:length()
  local along = (n * n + from_p * from_p - from_q * from_q) / (2 * n)
  return p + way * (along / n) + vec(-way.y, way.x, 0) * (math.sqrt(from_p * from_p - along * along) / n)
end
local crank_at, mirrored = vec(0, 1, 0), 1
--- A rod between two places, or a plate of three, of the leg that is being made. A lower leg is solid, beside those of others.
local function link(places, beside)
  local points, shapes = {}, {}
  for n, at in ipairs(places) do points[n] = { at = vec(mirrored * at.x, at.y, 0) + crank_at, mass = 0.1 } end
  for n = 1, beside and 2 or 0 do
    shapes[n] = shape.capsule { radius = 0.03, from = points[n].at, to = points[3].at, at = vec(0, 0, beside), friction = friction }
  end
  return scene:body { points = points, shapes = beside and shapes, color = "#d9c39a" }.points
end

local pins, sides = {}, { vec(-a, -l, 0), vec(a, -l, 0) }
for n = 1, 3 do pins[n] = { at = quat(vec(0, 0, 1), 2 * math.pi * n / 3):rotate(vec(m, 0, 0)), mass = 0.2 } end
local crank = scene:body { at = crank_at, mass = 0.2, points = { vec(0, 0, 0), table.unpack(pins) }, color = "#c2413b" }
local chassis = scene:body { at = crank_at, mass = 2, inertia = vec(0.2, 0.2, 0.2), points = { vec(0, 0, 0), sides[1], sides[2] } }
scene:hinge(crank.points[1], chassis.points[1])
scene:motor(crank, chassis, { speed = speed, max_torque = 60 })
for n, pin in ipairs(pins) do
  for side = 1, 2 do
    mirrored = side == 1 and 1 or -1
    local A, C = sides[1], vec(mirrored * pin.at.x, pin.at.y, 0)
    local B, F = left(A, C, b, j), left(C, A, k, c)
    local D = left(A, B, d, e)
    local G = left(F, D, g, f)
    local upper, lower = link { A, B, D }, link({ F, G, left(F, G, i, h) }, 0.1 * (n - 2))
    local push, pull, swing, down = link { C, B }, link { C, F }, link { A, F }, link { D, G }
    for _, joint in ipairs { { crank.points[n + 1], push[1], pull[1] }, { chassis.points[side + 1], upper[1], swing[1] }, { upper[2], push[2] },
                             { upper[3], down[1] }, { lower[1], pull[2], swing[2] }, { lower[2], down[2] } } do
      scene:hinge(table.unpack(joint))
    end
  end
end
-- The way, the same to both sides every 20 m: a step up, level, a slope up, level, a slope down. x and y, m.
local line = {}
for piece = -6, 5 do
  for _, at in ipairs { { 0, 0 }, { 2.98, 0 }, { 3, 0.05 }, { 6, 0.05 }, { 11, 0.55 }, { 13, 0.55 }, { 18.5, 0 } } do
    line[#line + 1] = vec(20 * piece + at[1], at[2], 0)
  end
end
scene:ground { shape = shape.line(line, { friction = friction }), color = "#9fb38a" }
scene.camera = { at = vec(0.5, 1.5, 4.6), look_at = vec(0, 0.8, 0), follow = chassis }
scene:probe("way", function() return chassis.position.x end)
