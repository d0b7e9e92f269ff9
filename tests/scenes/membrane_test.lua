--- Smallest and middle eigenvalue of a symmetric matrix, and the direction of the smallest.
local function flattest(xx, yy, zz, xy, xz, yz)
  local mean = (xx + yy + zz) / 3
  local size = math.sqrt(((xx - mean) ^ 2 + (yy - mean) ^ 2 + (zz - mean) ^ 2 + 2 * (xy ^ 2 + xz ^ 2 + yz ^ 2)) / 6)
  local a, b, c = vec(xx - mean, xy, xz) / size, vec(xy, yy - mean, yz) / size, vec(xz, yz, zz - mean) / size
  local angle = math.acos(math.max(-1, math.min(1, a:dot(b:cross(c)) / 2))) / 3
  local least, most = mean + 2 * size * math.cos(angle + 2 * math.pi / 3), mean + 2 * size * math.cos(angle)
  local rows = { vec(xx - least, xy, xz), vec(xy, yy - least, yz), vec(xz, yz, zz - least) }
  local normal = vec(0, 0, 0)
  for i = 1, 3 do
    local across = rows[i]:cross(rows[i % 3 + 1])
    if across:length() > normal:length() then normal = across end
  end
  return least, 3 * mean - least - most, normal / normal:length()
end

--- How much the surroundings of the amphiphiles, up to a reach round the ends of their tails, are sheets of two layers.
local function sheets(scene, edge, reach)
  local function near(d) return d - edge * math.floor(d / edge + 0.5) end
  local ends, directors = {}, {} -- last tail beads; from there to the head, of length 1
  for i, body in ipairs(scene.bodies) do
    local head, last = body.points[1].position, body.points[3].position
    ends[i], directors[i] = last, (head - last) / 2
  end
  local sum = { flatness = 0, order = 0, lesser_side = 0, heads_outside = 0 }
  for i = 1, #ends do
    local at, along, middle = {}, {}, vec(0, 0, 0)
    for j = 1, #ends do
      local d = ends[j] - ends[i]
      d = vec(near(d.x), near(d.y), near(d.z))
      if d:length() < reach then
        at[#at + 1], along[#along + 1] = d, directors[j]
        middle = middle + d
      end
    end
    middle = middle / #at
    local xx, yy, zz, xy, xz, yz = 0, 0, 0, 0, 0, 0
    for k = 1, #at do
      local d = at[k] - middle
      xx, yy, zz = xx + d.x ^ 2, yy + d.y ^ 2, zz + d.z ^ 2
      xy, xz, yz = xy + d.x * d.y, xz + d.x * d.z, yz + d.y * d.z
    end
    if #at > 4 then
      local least, next_one, normal = flattest(xx, yy, zz, xy, xz, yz)
      local order, up, outside = 0, 0, 0
      for k = 1, #at do
        local c, height = along[k]:dot(normal), (at[k] - middle):dot(normal)
        order = order + 1.5 * c ^ 2 - 0.5
        if c > 0 then up = up + 1 end
        if math.abs(height + 2 * c) > math.abs(height) then outside = outside + 1 end
      end
      sum.flatness = sum.flatness + least / next_one
      sum.order = sum.order + order / #at
      sum.lesser_side = sum.lesser_side + math.min(up, #at - up) / #at
      sum.heads_outside = sum.heads_outside + outside / #at
    else
      sum.flatness = sum.flatness + 1 -- alone, or nearly so
    end
  end
  for name, value in pairs(sum) do sum[name] = value / #ends end
  return sum
end

test("membrane: from a random start amphiphiles form sheets of two layers, heads outside", function()
  local count = 80
  local scene = open("scenes/membrane.lua", { amphiphiles = count })
  local edge = 1.9 * count ^ (1 / 3)
  local energy, start = scene:read "energy of an amphiphile", sheets(scene, edge, 3)
  expect(start.order):near(0, 0.1)
  scene:advance(60)
  local now = sheets(scene, edge, 3)
  expect(scene:read "energy of an amphiphile"):below(energy - 6)
  expect(scene:read "largest surface"):above(0.9)
  expect(now.flatness):below(0.6 * start.flatness)
  expect(now.order):above(0.35)
  expect(now.lesser_side):above(0.3)
  expect(now.heads_outside):above(0.9)
end)
