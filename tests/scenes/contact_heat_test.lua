-- What friction and impact take of whom, and how contacts are solved.
local function sum(scene)
  local all = 0
  for _, one in ipairs(scene.contact_heat) do all = all + one.heat end
  return all
end

test("a box that slides until it stops: all of its energy is heat of it and the floor", function()
  local scene = open_text [[
    scene:floor { name = "floor" }
    scene:block { size = 1, at = vec(0, 0.5, 0), velocity = vec(3, 0, 0), mass = 2, name = "box" }
  ]]
  expect(#scene.contact_heat):equal(0)
  scene:advance(1)
  local heat = scene.contact_heat
  expect(#heat):equal(1)
  expect(heat[1].a):equal(scene:find "box")
  expect(heat[1].b):equal(scene:find "floor")
  expect(heat[1].heat):near(9, 9e-6)
end)

test("the heat of all pairs is what the ledger's line contact lost since it was asked for", function()
  local scene = open_text [[
    scene:floor {}
    for i = 1, 12 do scene:block { size = 0.8, at = vec(0.2 * (i % 3), 0.9 * i - 0.4, 0.1 * (i % 4)), name = "box " .. i } end
    scene:at(1, function() scene:find "box 3":remove() end)
  ]]
  scene:advance(0.3)
  local before = scene.ledger.contact
  expect(sum(scene)):equal(0)
  scene:advance(0.6)
  expect(before - scene.ledger.contact):above(20)
  expect(sum(scene)):near(before - scene.ledger.contact, 1e-9)
  scene:advance(0.3)
  expect(sum(scene)):near(before - scene.ledger.contact, 1e-9)
  expect(scene.contact_heat[1].a):equal(nil)
  -- A blow that goes through a pair may leave some of its heat on it, or take some.
  expect(scene.contact_heat[1].heat):above(-1e-3 * sum(scene))
  expect(scene.contact_heat[2].a.alive):is_true()
end)

test("steps that are done again count once, and a snapshot goes back with its heat", function()
  local scene = open_text [[
    scene.accuracy = 1e-6
    scene:floor {}
    scene:block { size = 1, at = vec(0, 0.5, 0), velocity = vec(3, 0, 0) }
    local a, b = scene:particle { at = vec(0, 5, 0) }, scene:particle { at = vec(0.1, 5, 0), velocity = vec(0, 3, 0) }
    scene:connect(a, b, force.gravitation { constant = 2 })
  ]]
  expect(sum(scene)):equal(0)
  scene:advance(0.4)
  expect(scene.stats.rejected_steps):above(0)
  expect(sum(scene)):near(-scene.ledger.contact, 1e-9)
  local start, heat = scene:snapshot(), sum(scene)
  scene:advance(0.2)
  expect(sum(scene)):above(heat + 1)
  scene:restore(start)
  expect(sum(scene)):equal(heat)
end)

test("a contact tells its whole force, however many sub-steps the step had", function()
  local scene = open_text [[
    scene.step = 1 / 60
    scene:floor {}
    scene:block { size = 1, at = vec(0, 0.5, 0), velocity = vec(30, 0, 0), mass = 2, name = "box" }
  ]]
  scene:advance(0.2)
  expect(scene.stats.sub_steps):above(1)
  local force = vec(0, 0, 0)
  for _, contact in ipairs(scene:find("box").contacts) do force = force + contact.force end
  expect(force.y):near(2 * 9.81, 1e-4)
  expect(force.x):near(-9.81, 1e-4)
end)

test("scene.contact says how contacts are solved, and refuses what it does not know", function()
  open_text [[assert(scene.contact == "auto") scene.contact = "exact" assert(scene.contact == "exact")]]
  local function overlap_of_stack(search)
    local scene = open_text(search .. [[
      scene:floor {}
      for i = 0, 7 do scene:block { size = 1, at = vec(0, 0.5 + i, 0) } end
    ]])
    scene:advance(0.5)
    return scene.error.penetration
  end
  expect(overlap_of_stack 'scene.contact = "exact"'):equal(overlap_of_stack "")
  expect(overlap_of_stack 'scene.contact = "fast"'):above(10 * overlap_of_stack "")
  expect(function() open_text [[scene.contact = "quick"]] end):fails(
    'scene: contact must be "auto", "exact" or "fast", got "quick"')
  expect(function() open_text [[scene.contact = 1]] end):fails("contact must be a string, got a number")
end)

test("the ledger closes where shapes touch, and where what overlaps is pushed out against gravity", function()
  local scene = open_text [[
    scene.step = 1 / 60
    scene:floor {}
    for i = 1, 20 do scene:block { size = 0.8, at = vec(0.2 * (i % 3), 0.7 * i, 0.1 * (i % 4)) } end
  ]]
  local ledger = scene.ledger
  scene:advance(1)
  ledger = scene.ledger
  expect(ledger.push_out):above(1e3)
  expect(ledger.contact):below(-1e3)
  expect(ledger.closure):below(1e-10)
  expect(ledger.truncation.gravity):near(0, 1e-6)
end)

test("contacts and those who are told of touch know the heat of the step, once heat is asked for", function()
  local scene = open_text [[
    local told, heat = 0, 0
    scene:probe("told", function() return told end)
    scene:probe("heat", function() return heat end)
    local floor = scene:floor { friction = 0 }
    scene:ball { radius = 0.5, at = vec(0, 0.7, 0), mass = 2, velocity = vec(0, -3, 0), friction = 0, name = "ball" }
    scene:box { size = 1, at = vec(5, 0.5, 0), mass = 3, velocity = vec(2, 0, 0), name = "box" }
    scene:on("touched", scene:find "ball", function(touch)
      told, heat = told + 1, touch.heat
    end)
    floor.friction = 0.5
  ]]
  scene:step()
  expect(scene:find("box").contacts[1].heat):equal(nil)
  expect(#scene.contact_heat):equal(0)
  local slid = 0
  for _ = 1, 60 do
    scene:step()
    slid = slid + scene:find("box").contacts[1].heat
  end
  expect(scene:read "told"):equal(1)
  expect(scene:read "heat"):near(9 + 2 * 9.81 * 0.2, 1e-9)
  local pair
  for _, one in ipairs(scene.contact_heat) do if one.a == scene:find "box" then pair = one end end
  expect(slid):near(pair.heat, 1e-12)
  scene:advance(2)
  expect(scene:find("box").contacts[1].heat):near(0, 1e-9)
end)
