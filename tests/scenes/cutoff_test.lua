--- A law's cutoff where it ties two: no force and no energy beyond.

local function two(law, r)
  local scene = open_text(([[
    scene.gravity = vec(0, 0, 0)
    local p = scene:particle { mass = 1, name = "p" }
    local q = scene:particle { mass = 1, at = vec(%g, 0, 0), velocity = vec(1e-9, 0, 0) }
    scene:connect(p, q, %s)
  ]]):format(r, law))
  local potential = scene.energy.potential
  scene:step()
  return scene:find("p").velocity.x, potential
end

test("a connection pulls within the cutoff that its law was given, and not beyond", function()
  for _, law in ipairs {
    "force.pair { cutoff = 0.3, potential = function(r) return 1e3 * (0.3 - r) ^ 2 end }",
    "force.pair { cutoff = 0.3, tension = function(r) return 1e3 * (r - 0.3) end }",
    "force.pair { cutoff = 0.3, force = function(d) return d * (1e3 * (1 - 0.3 / d:length())) end }",
    "force.gravitation { constant = 10, cutoff = 0.3 }",
    "force.table { distances = { 0.1, 0.2, 0.3 }, tensions = { -200, -100, 0 } }",
    "force.pair { cutoff = 0.3, name = 'called', tension = function(r) local x = { [true] = 1 } return x[r > 0] * 1e3 * (r - 0.3) end }",
  } do
    local near, far = two(law, 0.2), two(law, 3)
    expect(math.abs(near)):above(1e-3)
    expect(far):equal(0)
    local _, potential = two(law, 3)
    expect(potential):equal(0)
  end
end)

test("what flies out of the cutoff of a connection keeps its energy", function()
  local scene = open_text [[
    scene.gravity = vec(0, 0, 0)
    local p, q = scene:particle { mass = 1 }, scene:particle { mass = 1, at = vec(0.1, 0, 0), name = "q" }
    scene:connect(p, q, force.pair { cutoff = 0.3, potential = function(r) return 10 * (0.3 - r) ^ 2 end })
  ]]
  scene:advance(2)
  expect(scene:find("q").velocity.x):near(math.sqrt(10) * 0.2, 1e-4)
  expect(scene.error.worst_energy):below(1e-3)
end)
