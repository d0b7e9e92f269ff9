-- What came to rest sleeps until something moves it, and the ledger tells what dampers took.
local pendulum = [[
local rod = scene:body {
  mass = 1, inertia = vec(0.0017, 0.0842, 0.0842), at = vec(0.5, 0, 0), name = "rod",
  points = { head = vec(-0.5, 0, 0), tail = vec(0.5, 0, 0) },
}
scene:nail(rod.head)
if scene:param("damped", true) then scene:field(scene, force.drag { linear = 3 }) end
]]

test("a damped pendulum falls asleep where it hangs, and a kick wakes it", function()
  local scene = open_text(pendulum)
  expect(scene.ledger.damper):equal(0)
  scene:advance(2)
  expect(scene.stats.asleep):equal(0)
  scene:advance(20)
  expect(scene.stats.asleep):equal(1)
  expect(scene.energy.kinetic):equal(0)
  expect(scene.ledger.damper):near(-0.5 * 9.81, 1e-3)
  expect(scene.ledger.closure):below(1e-10)
  local rod = scene:find "rod"
  rod:kick(vec(0.1, 0, 0))
  scene:advance(0.1)
  expect(scene.stats.asleep):equal(0)
  expect(rod.velocity:length()):above(0.01)
end)

test("an undamped pendulum never does", function()
  local scene = open_text(pendulum, { damped = false })
  scene:advance(20)
  expect(scene.stats.asleep):equal(0)
end)
