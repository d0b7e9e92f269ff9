-- A crystal is heated. When it is hot enough all its bonds break at once, and it flows apart. Break a corner off before:
-- what is gone by then cannot melt.
local cells = scene:param("cells", 3, { min = 1, max = 6, step = 1, help = "of the crystal along each edge" })
local melting = scene:param("melting", 0.02, { min = 0.01, max = 0.2, help = "temperature at which its bonds break, J" })
local heating = scene:param("heating", 0.01, { min = 0, max = 0.1, help = "of the bath, J/s" })
local latest = scene:param("latest", 8, { min = 0, max = 100, help = "time at which they break in any case, s" })
local broken = scene:param("broken", 0, { min = 0, max = 1, help = "part that is broken off after 1 s" })

scene.title = "Melt"
scene.step = 1 / 960
scene.duration = 12
scene.camera = { at = vec(1.5, 1.3, 3.4), look_at = vec(0, 0.4, 0) }

local edge, mass = 0.25, 0.01 -- m, kg
local atoms = scene:family("atoms", { color = "#7fb4e6", radius = 0.42 * edge, mass = mass })
local lattice = structure.lattice { kind = "fcc", cells = cells, edge = edge }
local count, lowest = #lattice.vertices, 0
for _, p in ipairs(lattice.vertices) do lowest = math.min(lowest, p.y) end

local crystal = scene:build(lattice, {
  as = "deformable", family = atoms, mass = mass * count, at = vec(0, 0.42 * edge - lowest, 0), name = "crystal",
  law = force.spring { stiffness = 60 },
})
-- Atoms that are not bound attract each other a little, and keep off each other.
scene:interact(atoms, atoms, force.lennard_jones { epsilon = 0.04, sigma = 0.85 * edge, exclude = 1 })
scene:field(atoms, force.wall { normal = vec(0, 1, 0), through = vec(0, 0, 0), stiffness = 400, damping = 0.2, friction = 0.2 })
local bath = scene:field(atoms, force.thermostat { rate = 2, temperature = 0.005 })

scene:every(0.05, function() bath.parameters.temperature = math.min(0.028, 0.005 + heating * scene.time) end)
local function melt(c)
  c:break_connections()
  for _, atom in ipairs(c.particles) do if atom.alive then atom.color = "#e8833a" end end
end
scene:when({ temperature_above = melting, of = crystal }, crystal, melt)
scene:at(latest, crystal, melt)
-- What is broken off takes its bonds along; an event of a crystal that is gone is dropped, and the log tells who took it.
local function break_off(part)
  local atoms_of_it = crystal.particles
  for i = 1, math.floor(part * count) do if atoms_of_it[i].alive then atoms_of_it[i]:remove() end end
end
if broken > 0 then scene:at(1, crystal, function() break_off(broken) end) end
scene:button("break a part off", function() break_off(0.2) end)

scene:probe("height", function() -- m, mean of the atoms
  local sum, all = 0, scene.particles
  for _, atom in ipairs(all) do sum = sum + atom.position.y end
  return #all > 0 and sum / #all or 0
end)
scene:probe("temperature", function() return crystal.alive and crystal.temperature or 0 end)
scene:probe("bonds", function() return #scene.connections end)
