-- Four belts carry parcels round a square: boxes whose surface moves. Turn their speed, drag a parcel, pour on more.
local speed = scene:param("speed", 1.2, { min = 0, max = 3, help = "of the belts, m/s" })
local count = scene:param("count", 16, { min = 1, max = 60, step = 1, help = "parcels" })

scene.title = "Conveyor"
scene.duration = 40
scene.camera = { at = vec(4.2, 5.2, 6.2), look_at = vec(0, 0.2, 0.2) }
scene:floor { color = "#d5d9de" }

-- Each belt ends at the side of the next, along a square; all have a rail outside, and there is one within the square.
local half, wide, high, rail = 2.4, 1.2, 0.6, 0.14
local parts = {}
for i = 0, 3 do
  local turn = quat(vec(0, 1, 0), i * math.pi / 2)
  local function part(size, at, options)
    options.at, options.orientation = turn:rotate(at), turn
    parts[#parts + 1] = shape.box(size.x, size.y, size.z, options)
  end
  local length = 2 * half - wide
  part(vec(length, high, wide), vec(-wide / 2, high / 2, half - wide / 2),
       { friction = 0.7, surface_velocity = turn:rotate(vec(speed, 0, 0)), color = i % 2 == 0 and "#48525f" or "#5b6675" })
  part(vec(2 * half + 0.1, rail, 0.05), vec(0, high + rail / 2, half + 0.025), { friction = 0.05, color = "#c9a23a" })
  part(vec(2 * (half - wide), rail, 0.05), vec(0, high + rail / 2, half - wide - 0.025), { friction = 0.05, color = "#c9a23a" })
end
scene:ground { shapes = parts }

local colors = { "#c98b52", "#b5733c", "#d9a066", "#8d7a63", "#c2413b", "#3f6f9f" }
local function some(low, high_) return low + (high_ - low) * math.random() end
local parcels = {}
local function drop(height)
  local size = vec(some(0.25, 0.55), some(0.15, 0.4), some(0.25, 0.55))
  local side = quat(vec(0, 1, 0), math.random(0, 3) * math.pi / 2)
  parcels[#parcels + 1] = scene:box {
    size = size, density = 200, friction = 0.5, color = colors[#parcels % #colors + 1],
    at = side:rotate(vec(some(-1.2, 1.2), high + height, half - wide / 2)), orientation = quat(vec(0, 1, 0), some(0, 3)) }
end
for i = 1, count do drop(0.5 * i) end

scene:button("pour in more", function() for i = 1, 5 do drop(1 + 0.5 * i) end end)
scene:probe("mean speed", function()
  local sum = 0
  for _, one in ipairs(parcels) do sum = sum + one.velocity:length() / #parcels end
  return sum
end)
scene:probe("on the belts", function()
  local number = 0
  for _, one in ipairs(parcels) do if one.position.y > high then number = number + 1 end end
  return number
end)
