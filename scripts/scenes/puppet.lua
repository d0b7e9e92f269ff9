-- The pantin: a jointed figure on strings. A choreography has it wave, walk and bow; drag it, cut a string, and it goes on.
local tempo = scene:param("tempo", 1, { min = 0.2, max = 3, help = "of the dance, relative" })

scene.title, scene.duration = "Puppet", 30
scene.camera = { at = vec(0.8, 2.0, 5.4), look_at = vec(0, 1.65, 0) }
local function part(name, from, to, mass, color, more)
  local points = { from = { at = from, mass = mass / 2, color = color }, to = { at = to, mass = mass / 2, color = color } }
  for key, at in pairs(more or {}) do
    points[key] = { at = at, mass = mass / 4, color = color, radius = key == "face" and 0.14 or nil }
  end
  return scene:body { name = name, points = points }
end
local wood, cloth = "#d9a066", "#d8573c"
local torso = part("torso", vec(0, 1.2, 0), vec(0, 1.8, 0), 2, cloth, {
  left_arm = vec(-0.22, 1.75, 0), right_arm = vec(0.22, 1.75, 0), left_leg = vec(-0.13, 1.2, 0), right_leg = vec(0.13, 1.2, 0),
})
local head = part("head", vec(0, 1.8, 0), vec(0, 2.15, 0), 0.4, wood, { face = vec(0, 2.0, 0) })
scene:hinge(torso.to, head.from)
local ends = { head = head.to, seat = torso.from }
for side, x in pairs { left = -1, right = 1 } do
  local function limb(kind, root, joint, tip, mass)
    local upper = part(side .. " " .. kind, root, joint, mass, cloth)
    local lower = part(side .. " lower " .. kind, joint, tip, mass, wood)
    scene:hinge(torso[side .. "_" .. kind], upper.from)
    scene:hinge(upper.to, lower.from)
    return lower
  end
  ends[side .. " hand"] = limb("arm", vec(0.22 * x, 1.75, 0), vec(0.32 * x, 1.42, 0), vec(0.36 * x, 1.1, 0), 0.25).to
  ends[side .. " knee"] = limb("leg", vec(0.13 * x, 1.2, 0), vec(0.14 * x, 0.8, 0.03), vec(0.14 * x, 0.4, 0), 0.5).from
end
scene:field(scene, force.drag { linear = 0.5 })
local strings, lengths = {}, {}
for name, point in pairs(ends) do
  local bar = vec(1.3 * point.position.x, 3, name == "seat" and -0.35 or 0.12)
  strings[name] = scene:string({ point, bar }, { name = name .. " string", time_constant = 0.12 / tempo })
  lengths[name] = strings[name].length
end
local function pull(name, by)
  if strings[name].alive then strings[name].length = lengths[name] - by end
end

scene:every(0.05 / tempo, function()
  local t = scene.time * tempo % 8 -- it waves for 2.4, walks for 3.6 and bows
  local walks, step = t >= 2.4 and t < 6, (t - 2.4) // 0.6
  for i, side in ipairs { "right", "left" } do
    local up = walks and step % 2 == i - 1 and (t - 2.4) % 0.6 < 0.45 and 0.3 or 0
    pull(side .. " knee", up)
    pull(side .. " hand", side == "right" and t < 2.4 and (t // 0.4 % 2 == 0 and 0.75 or 0.35) or up)
  end
  pull("head", t >= 6 and t < 7 and -0.5 or 0)
end)

for _, name in ipairs { "right hand", "head" } do
  scene:probe(name, function() return ends[name].alive and ends[name].position.y or 0 end)
end
