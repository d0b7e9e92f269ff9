-- Amphiphiles: one head that likes water, two tails that shun it. From a random start they form surfaces.
local count = scene:param("amphiphiles", 240, { min = 30, max = 4000, step = 1, help = "number of amphiphiles" })
local warmth = scene:param("temperature", 0.9, { min = 0, max = 3, help = "temperature, in units of the attraction" })

scene.title, scene.duration, scene.pace = "Membrane", 400, 4
scene.gravity, scene.step = vec(0, 0, 0), 0.02

-- Sizes and laws of Cooke, Kremer and Deserno (2005), with straight, rigid amphiphiles.
local edge = 1.9 * count ^ (1 / 3)
scene.box = vec(edge, edge, edge)
scene.camera = { at = vec(1.9 * edge, 1.5 * edge, 3.1 * edge), look_at = vec(0.5, 0.45, 0.5) * edge }

local head = scene:family("head", { color = "#2f78b7", radius = 0.45 })
local tail = scene:family("tail", { color = "#f0c05a", radius = 0.5 })
local amphiphiles = scene:group "amphiphiles"
-- No two beads begin nearer than 0.95: of each the cells of an edge of about 1 around it are searched.
local cells, across = {}, math.floor(edge)
local function near(d) return d - edge * math.floor(d / edge + 0.5) end -- to the nearest image
local function cell(at, dx, dy, dz)
  local function one(x, d) return (math.floor(x / edge * across) + d) % across end
  return (one(at.x, dx) * across + one(at.y, dy)) * across + one(at.z, dz)
end
local function free(at)
  for n = 0, 26 do
    for _, bead in ipairs(cells[cell(at, n // 9 - 1, n // 3 % 3 - 1, n % 3 - 1)] or {}) do
      local d = bead - at
      if vec(near(d.x), near(d.y), near(d.z)):length() < 0.95 then return false end
    end
  end
  return true
end
for i = 1, count do
  local at, turn, along
  repeat
    at = edge * vec(math.random(), math.random(), math.random())
    turn = quat(vec(math.random() - 0.5, math.random() - 0.5, math.random() - 0.5), 6.28 * math.random())
    along = turn:rotate(vec(1, 0, 0))
  until free(at) and free(at - along) and free(at + along)
  for k = -1, 1 do
    local here = cell(at + k * along, 0, 0, 0)
    cells[here] = cells[here] or {}
    table.insert(cells[here], at + k * along)
  end
  amphiphiles:add(scene:body {
    at = at, orientation = turn,
    points = {
      { at = vec(-1, 0, 0), mass = 1, family = head, color = "#2f78b7", radius = 0.45 },
      { at = vec(0, 0, 0), mass = 1, family = tail, color = "#f0c05a", radius = 0.5 },
      { at = vec(1, 0, 0), mass = 1, family = tail, color = "#f0c05a", radius = 0.5 },
    },
  })
end

scene:interact(head, head, force.wca { epsilon = 1, sigma = 0.95 })
scene:interact(head, tail, force.wca { epsilon = 1, sigma = 0.95 })
scene:interact(tail, tail, force.hydrophobic { strength = 1, size = 1, range = 1.6 })
scene:field(scene, force.thermostat { temperature = warmth, rate = 0.3 })
scene:probe("energy of an amphiphile", function() return scene.energy.potential / count end)
scene:probe("largest surface", function() return #amphiphiles:clusters(1.6)[1] / count end)
