test("a snapshot of an opened scene may outlive the test that took it", function()
  local scene = open_text("scene:particle { at = vec(0, 1, 0) }")
  local kept = scene:snapshot()
  scene:advance(0.5)
  local fallen = scene.particles[1].position.y
  scene:restore(kept)
  expect(scene.particles[1].position.y):equal(1)
  scene:advance(0.5)
  expect(scene.particles[1].position.y):equal(fallen)
end)

local step = 1 / 240  -- s

local function falling(more)
  return open_text("scene.history = 0.5\nlocal ball = scene:particle { name = 'ball' }\n" .. more)
end

test("scene:rewind goes back by a time, and on again to the bits of a run that never did", function()
  local scene = falling [[
    local asked, back
    scene:on("step", function()
      if asked and not back then
        back = asked - scene.time
        scene:probe("back", function() return back end)
      elseif not asked and scene.time > 1 then
        asked = scene.time
        scene:rewind(0.25)
      end
    end)]]
  local other = falling ""
  scene:advance(2) other:advance(2)
  expect(scene:read "back"):near(0.25, 1e-9)
  expect(scene.time):near(2, 1e-9)
  expect(scene.hash):equal(other.hash)
end)

test("scene:rewind tells what is kept, where it is asked for more or nothing is", function()
  expect(function() open_text("scene:at(0.1, function() scene:rewind(1) end)"):advance(1) end)
    :fails "rewind: no states are kept; say for how long by scene.history, in s"
  expect(function() falling("scene:at(1, function() scene:rewind(2) end)"):advance(2) end)
    :fails "rewind: states are kept from 0.5 s on, and 2 s ago is before that"
  expect(function() open_text "scene.history = -1" end):fails "history must be from 0 to 60 s, got -1"
end)

test("scene.hash is the same for equal states, and another for others", function()
  local a, b = falling "", falling ""
  a:advance(0.3) b:advance(0.3)
  expect(a.hash):equal(b.hash)
  expect(#a.hash):equal(16)
  b:advance(step)
  expect(a.hash == b.hash):equal(false)
end)

test("scene.store may hold the parameters of a law, stats and the ledger", function()
  local scene = open_text [[
    local p = scene:particle { at = vec(0, 1, 0) }
    local store = scene.store
    store.own = scene:connect(p, vec(0, 0, 0), force.spring { stiffness = 1, length = 1 }).parameters
    store.stats, store.ledger = scene.stats, scene.ledger
    scene:on("step", function()
      store.own.stiffness = store.own.stiffness + 1
      scene:result("stiffness", store.own.stiffness)
    end)]]
  scene:advance(0.1)
  local before, kept = scene:result "stiffness", scene:snapshot()
  scene:advance(0.1)
  scene:restore(kept)
  scene:step()
  expect(scene:result "stiffness"):equal(before + 1)
  expect(function() open_text "\nscene.stats.points = 3" end):fails ":2: scene: stats can be read, not written"
end)
