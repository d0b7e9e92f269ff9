test("an arm swings with its energy, and keeps its hinge while a hand pulls", function()
  local scene = open_text [[
    local a = scene:body { mass = 1, inertia = vec(0.01, 0.1, 0.1), at = vec(0.5, 0, 0), name = "a",
                           points = { head = vec(-0.5, 0, 0), tail = vec(0.5, 0, 0) } }
    local b = scene:body { mass = 1, inertia = vec(0.01, 0.1, 0.1), at = vec(1.5, 0, 0), name = "b",
                           points = { head = vec(-0.5, 0, 0), tail = vec(0.5, 0, 0) } }
    scene:hinge(a.tail, b.head, { name = "elbow" })
    scene:nail(a.head)
    local hand = scene:hand { path = function(t) return vec(2, t, 0) end }
    scene:at(0.1, function() hand:grab(b.tail, { max_force = 50 }) end)
    scene:at(0.5, function() hand:release() end)
    scene:at(1, function() scene:find("elbow"):cut() end)
  ]]
  scene:advance(0.09)
  expect(scene.error.worst_energy):below(1e-9)
  expect(scene:find("a").position.y):below(0)
  scene:advance(0.81)
  expect(#scene.hinges):equal(1)
  expect(scene.error.worst_hinge_gap):below(1e-10)
  scene:advance(0.2)
  expect(#scene.hinges):equal(0)
  expect(#scene.bodies):equal(2)
  expect(scene:find("b").velocity.y):below(scene:find("a").velocity.y)
end)

test("scenes of the product take their parameters", function()
  local chain = open("scenes/chain.lua", { links = 5, ["scene.step"] = 1 / 60 })
  chain:step()
  expect(chain.time):near(1 / 60, 1e-15)
  expect(#chain.bodies):equal(5)
  expect(function() open("scenes/chain.lua", { lynx = 5 }) end):fails("no parameter 'lynx'")
end)

test("an error names the file, the line, the value and what is allowed", function()
  expect(function() open_text "\n\nscene:body { mass = -1 }" end):fails("text.lua:3: body: mass must be > 0 kg, got -1")
end)

test("what had another name once answers to it, and says so once", function()
  local scene = open_text [[
    scene:particle {}
    scene:on("step", function()
      assert(scene.stats.safe_steps == scene.stats.fallback_steps and scene.stats.safe_steps == 0)
      assert(scene.ledger.safe_step == scene.ledger.fallback_step and scene.stats.no_such_name == nil)
    end)
  ]]
  scene:advance(0.1)
  local told = {}
  for _, line in ipairs(scene.log) do table.insert(told, line.text) end
  expect(table.concat(told, "; ")):equal("'safe_steps' is called 'fallback_steps' now; 'safe_step' is called 'fallback_step' now")
end)

test("scene.dark is a boolean, false at first", function()
  local scene = open_text [[
    local first = scene.dark
    scene.dark = true
    scene:result("dark", not first and scene.dark)
  ]]
  expect(scene:result "dark"):equal(true)
  expect(function() open_text "scene.dark = 1" end):fails("dark must be a boolean, got")
end)
