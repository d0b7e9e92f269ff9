-- Particles that touch: solid families.
local function fails(code, message)
  expect(function() open_text(code):advance(0.1) end):fails(message)
end

test("a solid family says how it touches; each wrong option is refused", function()
  local scene = open_text [[
    local sand = scene:family("sand", { solid = true, radius = 0.1, friction = 0.3, restitution = 0.2, layer = "loose", })
    local air = scene:family("air")
    assert(sand.solid and sand.friction == 0.3 and sand.restitution == 0.2 and sand.layer == "loose")
    assert(not air.solid and air.friction == nil and air.restitution == nil and air.layer == nil)
    sand.friction, sand.restitution, sand.layer = 0.4, 0, nil
    assert(sand.friction == 0.4 and sand.restitution == 0 and sand.layer == nil)
  ]]
  scene:advance(0.1)
  fails([[scene:family("a", { friction = 0.5 })]], "family 'a': friction is of what is solid; give it solid = true, too")
  fails([[scene:family("a", { solid = 1 })]], "solid must be true or false")
  fails([[scene:family("a", { solid = true, friction = -1 })]], "friction must be")
  fails([[scene:family("a", { solid = true, friction = 0 / 0 })]], "friction")
  fails([[scene:family("a", { solid = true, restitution = 1.1 })]], "restitution must be from 0 to 1, got 1.1")
  fails([[scene:family("a", { solid = true, layer = "" })]], "layer must not be empty")
  fails([[scene:family("a", { solid = true, radius = 0 })]], "needs a radius > 0 m, got 0")
  fails([[scene:family("a", { solid = true, radius = function(age) return 0.1 + age end })]], "cannot follow its age")
  fails([[scene:particle { family = scene:family("a", { solid = true }), radius = 0 }]], "needs a radius > 0 m")
  fails([[scene:emitter { family = scene:family("a", { solid = true }), rate = 1, radius = 0 }]], "needs a radius > 0 m")
  fails([[scene:family("air").friction = 0.1]], "friction is of what is solid, and it is not")
end)

test("a solid particle lies on the floor and tells so; it is told of to who listens for it, its family or its layer", function()
  local scene = open_text [[
    local floor = scene:floor { name = "floor" }
    local sand = scene:family("sand", { solid = true, radius = 0.1, layer = "loose" })
    local p = scene:particle { family = sand, at = vec(0, 0.2, 0), mass = 2, name = "p" }
    told = 0
    for _, filter in ipairs { p, sand, "loose", floor } do
      scene:on("touched", filter, function(touch)
        assert(filter == floor and touch.a == floor and touch.b == p or touch.a == p and touch.b == floor)
        told = told + 1
      end)
    end
    scene:probe("told", function() return told end)
  ]]
  scene:advance(1)
  expect(scene:read "told"):equal(4)
  local p = scene:find "p"
  expect(p.position.y):near(0.1, 1e-7)
  expect(#p.contacts):equal(1)
  local contact = p.contacts[1]
  expect(contact.with):equal(scene:find "floor")
  expect(contact.at):near(vec(0, 0, 0), 1e-6)
  expect(contact.normal):near(vec(0, 1, 0), 1e-12)
  expect(contact.force):near(vec(0, 2 * 9.81, 0), 1e-6)
end)

test("what a family lies on carries it: a box under grains tells the weight of all", function()
  local scene = open_text [[
    scene:floor {}
    local sand = scene:family("sand", { solid = true, radius = 0.05, layer = "sand", mass = 0.5 })
    scene:collide("sand", "sand", false)
    local box = scene:block { size = vec(1, 0.2, 1), at = vec(0, 0.1, 0), mass = 3, name = "box" }
    for i = 1, 16 do scene:particle { family = sand, at = vec(0.2 * (i % 4) - 0.3, 0.25, 0.2 * (i // 4) - 0.5) } end
  ]]
  scene:advance(1)
  local weight = 0
  for _, contact in ipairs(scene:find("box").contacts) do weight = weight + math.max(0, contact.force.y) end
  expect(weight):near((3 + 8) * 9.81, 1e-5)
  expect(scene.error.penetration):below(1e-5)
end)

test("tablecloth: it lies on what it fell on, its threads keep their length to 1e-6 m, and energy only falls", function()
  local cloth = open("scenes/tablecloth.lua", { threads = 8 })
  local last, rise = cloth.energy.total, 0
  for _ = 1, 240 do
    cloth:step()
    rise, last = math.max(rise, cloth.energy.total - last), cloth.energy.total
  end
  expect(cloth.error.worst_constraint):below(1e-6)
  expect(rise):below(1e-4)
  expect(cloth:read "lowest"):above(0.024)
end)

test("brook: drops run over the bed and not through it, and the wheel turns with them", function()
  local brook = open("scenes/brook.lua", { flow = 140 })
  brook:advance(4)
  local spin = 0
  for _ = 1, 40 do
    brook:advance(0.05)
    spin = spin + brook:read "spin of the wheel" / 40
  end
  expect(spin):above(0.2)
  expect(brook:read "drops"):above(300)
end)

test("solid: what is pushed out of a floor is in the ledger", function()
  local scene = open_text [[
    scene:floor { height = 0 }
    local grains = scene:family("grains", { solid = true, radius = 0.1, mass = 2 })
    scene:particle { at = vec(0, -0.3, 0), velocity = vec(0.4, 0.3, -0.8), family = grains }
  ]]
  local _ = scene.ledger.closure
  scene:advance(0.02)
  expect(scene.ledger.push_out):above(0.01)
  expect(scene.ledger.closure):below(1e-10)
end)

local function closure_after(seconds, text)
  local scene = open_text(text)
  local _ = scene.ledger.closure
  scene:advance(seconds)
  return scene.ledger.closure
end

test("solid: the ledger of what rests, bounces and slides stays closed", function()
  for _, start in ipairs { "at = vec(0, 0.1, 0)", "at = vec(0, 0.5, 0), velocity = vec(1, 0, 0)" } do
    expect(closure_after(1, [[
      scene:floor { height = 0, friction = 0.5, restitution = 0.5 }
      local grains = scene:family("grains", { solid = true, radius = 0.1, mass = 2 })
      scene:particle { family = grains, ]] .. start .. [[ }
    ]])):below(1e-12)
  end
end)

test("touch: the ledger of what a spring presses on the floor stays closed, and the spring has given nothing", function()
  local scene = open_text [[
    scene:floor { height = 0, friction = 0.5 }
    local box = scene:box { size = vec(1, 1, 1), at = vec(0, 0.5, 0), points = { top = vec(0, 0.5, 0) } }
    scene:connect(box.top, vec(0, 3, 0), force.spring { stiffness = 500, length = 4, name = "spring" })
  ]]
  local _ = scene.ledger.closure
  scene:advance(1)
  expect(scene.ledger.closure):below(1e-12)
  for _, error in pairs(scene.ledger.truncation) do expect(math.abs(error)):below(1e-3) end -- J
  expect(math.abs(scene.ledger.integrator)):below(1e-12)
end)

test("dumb-bells of solid particles that crash into each other keep their angular momentum to 2e-3 of what turns", function()
  for tie, bound in pairs { ["scene:rod(a, b)"] = 2e-3, ["scene:string({ a, b }, { length = 0.45 })"] = 2e-3,
                            ["scene:connect(a, b, force.spring { stiffness = 2e4, damping = 5, implicit = true })"] = 2e-3,
                            [""] = 2e-5 } do
    local scene = open_text([[
      scene.gravity, scene.step = vec(0, 0, 0), 1 / 60
      local family = scene:family("f", { solid = true, radius = 0.1, mass = 1, friction = 0, restitution = 0.3 })
      local function anywhere() return vec(math.random() - 0.5, math.random() - 0.5, math.random() - 0.5) end
      for _ = 1, 24 do
        local at = anywhere() * 2
        local a = scene:particle { family = family, at = at, velocity = -1.5 * at + anywhere() * 2 }
        local b = scene:particle { family = family, at = at + anywhere():normalized() * 0.4, velocity = -1.5 * at + anywhere() * 2 }
        ]] .. tie .. [[

      end
    ]])
    scene:step()
    local start = scene.angular_momentum
    scene:advance(4)
    local turning = 0
    for _, p in ipairs(scene.particles) do turning = turning + p.mass * p.position:cross(p.velocity):length() end
    expect((scene.angular_momentum - start):length()):below(bound * turning)
  end
end)
