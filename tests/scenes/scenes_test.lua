test("chain: hinges hold and energy stays, however heavy its end", function()
  for _, ratio in ipairs { 1, 1000, 1e6 } do
    local chain = open("scenes/chain.lua", { links = 20, ratio = ratio })
    chain:advance(3)
    expect(chain.error.worst_hinge_gap):below(1e-9)
    expect(chain.error.worst_energy):below(1e-8)
    expect(chain.stats.fallback_steps):equal(0)
  end
end)

test("chain: the end swings down as far as the chain is long", function()
  local chain = open("scenes/chain.lua", { links = 20 })
  local lowest = 4
  for _ = 1, 240 * 5 do
    chain:step()
    lowest = math.min(lowest, chain:read "tip height")
  end
  expect(lowest):near(-16, 0.5)
end)

test("walker: it walks, upright and in its plane", function()
  local walker = open("scenes/walker.lua")
  local _ = walker.energy
  walker:advance(5)
  expect(walker:read "way"):below(-1.2)
  expect(walker.error.worst_hinge_gap):below(1e-10)
  expect(walker.error.worst_energy):below(3e-3)
  for _, body in ipairs(walker.bodies) do expect(body.position.z):equal(0) end
end)

test("pendulum: the rods keep their length", function()
  local pendulum = open("scenes/pendulum.lua")
  pendulum:advance(5)
  expect(pendulum.error.constraint):below(1e-10)
  expect(pendulum.error.worst_energy):below(1e-9)
end)

test("pendulum: a small swing has the period of the closed form", function()
  local scene = open_text [[
    local bob = scene:particle { at = vec(0.01, -math.sqrt(1 - 0.0001), 0) }
    scene:rod(vec(0, 0, 0), bob)
    scene:probe("x", function() return bob.position.x end)
  ]]
  local crossings, last = {}, 0.01
  for i = 1, 240 * 10 do
    scene:step()
    local x = scene:read "x"
    if last > 0 and x <= 0 then crossings[#crossings + 1] = (i - x / (x - last)) / 240 end
    last = x
  end
  local period = (crossings[#crossings] - crossings[1]) / (#crossings - 1)
  expect(period):near(2 * math.pi * math.sqrt(1 / 9.81) * (1 + 0.01 ^ 2 / 16), 1e-4)
end)

test("top: leans and turns, but does not fall while it spins", function()
  local top = open("scenes/top.lua")
  top:advance(5)
  expect(top:read "lean"):below(0.6)
  expect(top.error.worst_energy):below(1e-7)
end)

test("top: without spin it falls", function()
  local top = open("scenes/top.lua", { spin = 0 })
  top:advance(1)
  expect(top:read "lean"):above(1.5)
end)

test("top: what gravity cannot turn stays", function()
  local top = open("scenes/top.lua")
  local before = top.angular_momentum.y
  top:advance(3)
  expect(top.angular_momentum.y):near(before, 1e-9 * before)
end)

test("skipping rope: swings round its hands, and its hinges hold", function()
  local rope = open("scenes/skipping_rope.lua")
  local low, high = math.huge, -math.huge
  for i = 1, 960 * 6 do
    rope:step()
    if i > 960 * 4 then
      low, high = math.min(low, rope:read "middle height"), math.max(high, rope:read "middle height")
    end
  end
  expect(low):below(0.6)
  expect(high):above(1.9)
  expect(rope.error.worst_hinge_gap):below(1e-9)
end)

test("a notice is told once", function()
  local scene = open_text [[
    local told = 0
    local a = scene:particle { at = vec(0, 0, 0) }
    scene:on("step", function() if a.alive then a:remove() end end)
    scene:on("removed", function() told = told + 1 end)
    scene:probe("told", function() return told end)
  ]]
  for _ = 1, 5 do scene:step() end
  expect(scene:read "told"):equal(1)
end)

test("fire: burns steadily above its hearth, and its smoke goes with the wind", function()
  local fire = open("scenes/fire.lua", { wind = 1 })
  fire:advance(4)
  local flames = fire:find("flame").particles
  expect(#flames):near(900 * 0.8, 60)
  local height, smoke = 0, 0
  for _, p in ipairs(flames) do height = height + p.position.y / #flames end
  expect(height):above(0.3)
  expect(height):below(1.2)
  for _, p in ipairs(fire:find("smoke").particles) do smoke = math.max(smoke, p.position.x) end
  expect(smoke):above(1)
  expect(fire:read "embers"):above(5)
end)

test("waterfall: as many drops live as flow in a lifetime; they fall on the ground, not through it", function()
  local fall = open("scenes/waterfall.lua", { flow = 300 })
  fall:advance(3)
  expect(fall:read "drops"):near(600, 25)
  local lowest, run = math.huge, 0
  for _, p in ipairs(fall:find("water").particles) do
    lowest, run = math.min(lowest, p.position.y), math.max(run, p.position.x)
  end
  expect(lowest):above(-0.05)
  expect(run):above(1.2)
end)

test("cards: the house stands by friction until a ball is thrown at it, is built again, and slips where friction is too small", function()
  local house = open("scenes/cards.lua")
  house:advance(1)
  local stands = house:read "top of the house"
  house:advance(6.9)
  expect(house:read "top of the house"):near(stands, 1e-5)
  house:advance(2)
  expect(house:read "top of the house"):below(0.5 * stands)
  house:advance(7.1)
  expect(house:read "top of the house"):near(stands, 1e-3)
  local slippery = open("scenes/cards.lua", { friction = 0.1 })
  slippery:advance(3)
  expect(slippery:read "top of the house"):below(1)
end)

test("conveyor: parcels go round on the belts", function()
  local conveyor = open("scenes/conveyor.lua")
  conveyor:advance(15)
  expect(conveyor:read "on the belts"):above(13)
  expect(conveyor:read "mean speed"):above(0.5)
  expect(conveyor:read "mean speed"):below(1.25)
end)

test("marbles: they find their way down the rails and are put back", function()
  local run = open("scenes/marbles.lua")
  run:advance(25)
  expect(run:read "rounds"):above(7)
end)

test("ragdolls: figures come down the stairs, and their hinges hold", function()
  local ragdolls = open("scenes/ragdolls.lua")
  ragdolls:advance(9)
  expect(ragdolls:read "thrown in"):equal(3)
  expect(ragdolls.bodies[1].position.y):below(0.6)
  expect(ragdolls.error.worst_hinge_gap):below(1e-10)
  expect(ragdolls.stats.fallback_steps):equal(0)
end)

test("dig: the shovel brings stones out of the bin", function()
  local dig = open("scenes/dig.lua")
  dig:advance(12)
  expect(dig:read "dug out"):above(1)
end)

test("tablecloth and dominoes are laid out and stood up again", function()
  local dominoes = open("scenes/dominoes.lua", { count = 10 })
  dominoes:advance(3)
  expect(dominoes:read "fallen"):equal(10)
  dominoes:advance(2)
  expect(dominoes:read "fallen"):equal(0)
  dominoes:advance(4)
  expect(dominoes:read "fallen"):equal(10)
  local cloth = open("scenes/tablecloth.lua", { threads = 5 })
  cloth:advance(6.1)
  expect(cloth:read "lowest"):above(0.9)
end)

test("trampoline: what falls on it bounces by its springs alone, and nothing goes through", function()
  local trampoline = open("scenes/trampoline.lua")
  trampoline:advance(1.2)
  expect(trampoline:read "highest"):above(1.5)
  trampoline:advance(4)
  expect(trampoline:read "highest"):above(0.6)
  expect(trampoline.error.worst_penetration):below(0.05)
  expect(trampoline.error.worst_energy):below(0.03)
end)

test("plates: the ball breaks each, and no piece goes through the floor", function()
  local plates = open("scenes/plates.lua", { plates = 2, pieces = 10 })
  plates:advance(0.1)
  expect(plates:read "broken plates"):equal(0)
  plates:advance(1.9)
  expect(plates:read "broken plates"):equal(2)
  expect(plates:read "bodies"):equal(21)
  for _, body in ipairs(plates.bodies) do expect(body.position.y):above(0) end
  expect(plates.error.energy):below(1e-3)
end)

test("the sandbox stands, and falls asleep, in a plane and in space", function()
  for dimensions = 2, 3 do
    local sandbox = open("scenes/sandbox.lua", { dimensions = dimensions })
    sandbox:advance(7) -- the ball comes to rest at 4.9 s in space
    expect(sandbox.energy.kinetic):equal(0)
    expect(sandbox.error.worst_energy):below(1e-5)
    local highest = 0
    for _, body in ipairs(sandbox.bodies) do highest = math.max(highest, body.position.y) end
    expect(highest):near(2.2, 1e-3)
  end
end)

test("the pile begins with nothing in something else", function()
  local pile = open("scenes/pile.lua")
  pile:advance(0.1)
  expect(pile.error.penetration):below(1e-6)
  pile:advance(3)
  expect(pile.error.worst_energy):below(1e-4)
end)

test("clock: it keeps time, and its pendulum swings on", function()
  local clock = open "scenes/clock.lua"
  clock:advance(20)
  expect(clock:read "seconds shown"):near(20, 0.5)
  local widest = 0
  for _ = 1, 480 * 2 do
    clock:step()
    widest = math.max(widest, clock:read "swing")
  end
  expect(widest):above(0.1)
  expect(clock.error.worst_energy):below(2e-3)
  expect(clock.error.worst_penetration):below(1e-3)
end)
