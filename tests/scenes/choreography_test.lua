test("combine: the bodies meet at P, hang together, and are pulled apart, again and again", function()
  local scene = open("scenes/combine.lua")
  local P = vec(0, 2, 0)
  while scene:read "meetings" < 1 and scene.time < 8 do scene:step() end
  expect(#scene.hinges):equal(1)
  expect((scene.hinges[1].position - P):length()):below(1e-3)
  expect(scene:read "distance of the tips"):below(1e-6)
  scene:advance(24)
  expect(scene:read "meetings"):above(2)
  expect(scene:read "partings"):above(1)
  expect(scene.stats.safe_steps):equal(0)
end)

test("combine: a body that a person removes ends the play, and nothing else", function()
  local scene = open("scenes/combine.lua")
  scene:advance(4)
  scene:find("a"):remove()
  scene:advance(8)
  expect(scene:find("b").alive):is_true()
end)

test("puppet: it waves and walks, and its hinges hold", function()
  local scene = open("scenes/puppet.lua")
  local low, high = 9, 0
  for _ = 1, 240 * 12 do
    scene:step()
    local y = scene:read "right hand"
    low, high = math.min(low, y), math.max(high, y)
  end
  expect(high - low):above(0.5)
  expect(scene:read "head"):above(1.5)
  expect(scene.error.worst_hinge_gap):below(1e-9)
end)

test("puppet: it dances on when a string is cut and an arm is gone", function()
  local scene = open("scenes/puppet.lua")
  scene:advance(1)
  scene:find("left knee string"):remove()
  scene:find("right arm"):remove()
  scene:find("right lower arm"):remove()
  scene:advance(8)
  expect(scene:read "head"):above(1)
end)

test("bonding: hot particles come apart, cold ones that are near are tied again", function()
  local scene = open_text [[
    scene.gravity = vec(0, 0, 0)
    local gas, group = scene:family "gas", scene:group "gas"
    for x = 1, 3 do for y = 1, 3 do for z = 1, 3 do
      group:add(scene:particle { family = gas, at = vec(x, y, z), name = "ball" })
    end end end
    scene:bonding { families = gas, near = 1.1, below = 0.1, above = 1, law = force.spring { stiffness = 10 } }
    scene:at(0.1, group, function(g) g:heat(100) end)
    scene:at(0.2, group, function(g) g:heat(-0.99 * 1.5 * 26 * g.temperature) end)
    scene:probe("bonds", function() return #scene.connections end)
  ]]
  scene:advance(0.05)
  expect(scene:read "bonds"):equal(54)
  scene:advance(0.1)
  expect(scene:read "bonds"):equal(0)
  scene:advance(0.3)
  expect(scene:read "bonds"):above(0)
end)

test("play: waits by wait alone", function()
  local scene = open_text "scene:play(function(wait) coroutine.yield() end)"
  expect(function() scene:advance(0.1) end):fails("text.lua:1: play: it waits by wait(…), not by coroutine.yield")
end)

test("when: what is gone has no energy to be below", function()
  local scene = open_text [[
    local pair, fired = scene:group "pair", 0
    local a, b = scene:particle(), scene:particle { at = vec(1, 0, 0) }
    pair:add(a, b)
    scene:when({ energy_below = -1e9, of = pair }, function() fired = 1 end)
    scene:at(0.1, function() a:remove() end)
    scene:probe("fired", function() return fired end)
  ]]
  scene:advance(0.3)
  expect(scene:read "fired"):equal(0)
end)
