-- Parameters of laws are checked alike wherever they are given.
local things = [[
  local a, b = scene:particle { at = vec(0, 0, 0) }, scene:particle { at = vec(1, 0, 0) }
  local dust = scene:family("dust", { attributes = { charge = 1 } })
]]

local wrong = {
  ["scene:connect(a, b, force.spring { stiffness = 1 }, { stiffness = -1 })"] = "connect: spring: stiffness must be >= 0 N/m, got -1",
  ["scene:connect(a, b, force.spring { stiffness = 1 }, { length = -1 })"] = "connect: spring: length must be >= 0 m, got -1",
  ["scene:connect(a, b, force.spring { stiffness = 1 }).parameters.stiffness = -1"] = "parameters: spring: stiffness must be >= 0 N/m, got -1",
  ["scene:connect(a, b, force.damper { damping = 1 }).parameters.damping = -1"] = "parameters: damper: damping must be >= 0 N s/m, got -1",
  ["scene:field(dust, force.drag { linear = 1 }).parameters.linear = -1"] = "parameters: drag: linear must be >= 0 N s/m, got -1",
  ["scene:field(dust, force.thermostat { rate = 1, temperature = 1 }).parameters.temperature = -1"] = "parameters: thermostat: temperature must be >= 0 K, got -1",
  ["scene:interact(dust, dust, force.repel { stiffness = 1 }).parameters.stiffness = -1"] = "parameters: repel: stiffness must be >= 0 N/m^1.5, got -1",
  ["scene:interact(dust, dust, force.hydrophobic { strength = 1, size = 1 }).parameters.attraction = 2"] = "parameters: hydrophobic: attraction must be from -1 to 1, got 2",
  ["scene:interact(dust, dust, force.lennard_jones { epsilon = 1, sigma = 1 }).parameters.sigma = 0"] = "parameters: lennard_jones: sigma must be > 0 m, got 0",
  ["scene:field(dust, force.wall { normal = vec(0, 1, 0), stiffness = 1 }).parameters.normal_y = 0"] = "parameters: wall: normal must not be 0, and with normal_y = 0 all its parts are",
}

for code, message in pairs(wrong) do
  test("a law's parameter out of range is refused: " .. code, function()
    expect(function() open_text(things .. code) end):fails("text.lua:3: " .. message)
  end)
end

test("a law's parameter within its range is written, and one that was refused is as it was", function()
  open_text(things .. [[
    local spring = scene:connect(a, b, force.spring { stiffness = 1 }, { stiffness = 0 })
    pcall(function() spring.parameters.stiffness = -1 end)
    assert(spring.parameters.stiffness == 0)
    spring.parameters.stiffness = 3
    assert(spring.parameters.stiffness == 3)
    local wall = scene:field(dust, force.wall { normal = vec(0, 1, 0), stiffness = 1 })
    wall.parameters.normal_x = 1
    wall.parameters.normal_y = 0
    assert(wall.parameters.normal_y == 0)
    scene:interact(dust, dust, force.pair { cutoff = 1, parameters = { k = 1 }, potential = function(r, p, q, own) return own.k * r end }).parameters.k = -4
  ]])
end)

test("the parameters of a law are listed, and handed over", function()
  open_text(things .. [[
    local spring = scene:connect(a, b, force.spring { stiffness = 2, length = 1 })
    local told = ""
    for name, value in pairs(spring.parameters) do told = told .. name .. "=" .. value .. " " end
    assert(told == "length=1.0 stiffness=2.0 ", told)
    assert(next(spring.parameters) == "length")
    spring.parameters.stiffness = 5
    local other = scene:connect(a, vec(0, 2, 0), force.spring { stiffness = 1, length = 3 }, spring.parameters)
    assert(other.parameters.stiffness == 5 and other.parameters.length == 1)
    local none = scene:field(scene, force.point { force = function(p) return vec(0, 1, 0) end })
    assert(next(none.parameters) == nil)
  ]])
end)
