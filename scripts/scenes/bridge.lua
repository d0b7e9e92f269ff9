-- A truss bridge of steel bars, springs a thousand times too stiff for ordinary steps. The load grows until a bar breaks.
local bays = scene:param("bays", 8, { min = 2, max = 40, step = 2, help = "bays of the truss" })
local stiffness = scene:param("stiffness", 2e7, { min = 1e3, max = 1e9, help = "of a bar, N/m" })
local strength = scene:param("strength", 6e4, { min = 1e3, max = 1e6, help = "force at which a bar breaks, N" })

scene.title = "Truss bridge"
scene.step = 1 / 120
scene.duration = 10
scene.camera = { at = vec(0, 1.6, 9.5), look_at = vec(0, -0.2, 0) }

local joints = scene:family("joints", { mass = 40, radius = 0.09, color = "#d8dee9" })
local steel = force.spring { stiffness = stiffness, implicit = true }
local hold = force.damper { damping = 400 }

local function joint(x, y, z)
  return scene:particle { at = vec(x, y, z), family = joints }
end
local function bar(a, b)
  scene:connect(a, b, steel, { breaks_at = { force = strength } })
  scene:connect(a, b, hold)
end

local bottom, top = {}, {}
for side = 1, 2 do
  local z = side == 1 and -0.6 or 0.6
  bottom[side], top[side] = {}, {}
  for i = 0, bays do
    bottom[side][i] = joint(i - bays / 2, 0, z)
    if i > 0 and i < bays then top[side][i] = joint(i - bays / 2, 1, z) end
  end
  for i = 1, bays do
    local low, high = bottom[side], top[side]
    bar(low[i - 1], low[i])
    if high[i] then bar(low[i], high[i]) end
    if high[i - 1] and high[i] then bar(high[i - 1], high[i]) end
    if i <= bays / 2 then
      if high[i] then bar(low[i - 1], high[i]) end
    else
      if high[i - 1] then bar(high[i - 1], low[i]) end
    end
  end
  scene:nail(bottom[side][0])
  scene:nail(bottom[side][bays])
end
for i = 0, bays do
  bar(bottom[1][i], bottom[2][i])
  if top[1][i] then bar(top[1][i], top[2][i]) end
  if i > 0 then bar(bottom[1][i - 1], bottom[2][i]) bar(bottom[2][i - 1], bottom[1][i]) end
  if top[1][i] and top[1][i - 1] then bar(top[1][i - 1], top[2][i]) bar(top[2][i - 1], top[1][i]) end
end

local middle, whole = { bottom[1][bays / 2], bottom[2][bays / 2] }, true
scene:on("broke", function() whole = false end)
scene:on("step", function()
  for _, p in ipairs(middle) do p:push(vec(0, whole and -6000 * scene.time or 0, 0)) end
end)
scene:probe("sag", function() return -middle[1].position.y end)
