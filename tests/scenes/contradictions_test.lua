--- A scene in which something cannot be, beside a pendulum that must not notice. Returns it after three seconds.
local function beside(code)
  local pendulum = [[
    local bob = scene:particle { at = vec(5, -1, 2), name = "bob" }
    scene:rod(bob, vec(4, 0, 0))
    local bar = scene:body { mass = 1, inertia = vec(0.02, 0.1, 0.1), name = "bar",
                             points = { left = vec(-0.5, 0, 0), right = vec(0.5, 0, 0) } }
  ]]
  local alone, scene = open_text(pendulum), open_text(pendulum .. code)
  alone:advance(3)
  scene:advance(3)
  expect(scene:find("bob").position):equal(alone:find("bob").position)
  expect(scene:find("bob").velocity):equal(alone:find("bob").velocity)
  return scene
end

local function warnings(scene)
  local texts = {}
  for _, line in ipairs(scene.log) do
    if line.kind == "warning" then texts[#texts + 1] = line.text end
  end
  return texts
end

local function is_told(code, what)
  local scene = beside(code)
  local told = warnings(scene)
  expect(#told):equal(1)
  expect(told[1]:find(what) ~= nil):is_true()
  expect(told[1]:find "cannot be kept" ~= nil):is_true()
  expect(scene.stats.safe_steps):above(0)
end

test("nails further apart than the body between them are told, once, by name", function()
  is_told([[
    scene:nail(bar.left, { name = "first" })
    scene:nail(bar.right, vec(3, 0, 0), { name = "second" })
  ]], "nail '%a+'")
end)

test("so is a rod of a length that no loop can have", function()
  is_told([[
    scene:nail(bar.left)
    local strut = scene:rod(bar.right, vec(-0.5, 0, 0))
    strut.length, strut.name = 2, "strut"
  ]], "cannot be kept")
end)

test("and a body that is to keep two orientations", function()
  is_told([[
    scene:orient(bar, { name = "one" })
    scene:orient(bar, quat(vec(0, 0, 1), 1), { name = "other" })
  ]], "orient '%a+'")
end)

test("a chain pulled further than it reaches is told, and forgiven when it comes back", function()
  local scene = beside [[
    scene:nail(bar.left)
    scene:follow(bar.right, function(t) return vec(t < 1 and 0.5 + t or math.max(0.5, 2.5 - t), 0, 0) end)
  ]]
  expect(#warnings(scene)):equal(1)
  expect(scene.error.constraint):below(1e-10)
end)

test("a motor of limited torque that meets a limit stands there, and books what it did", function()
  local scene = open_text [[
    scene.gravity = vec(0, 0, 0)
    local body = scene:body { mass = 1, inertia = vec(0.1, 0.1, 0.1), name = "body" }
    scene:motor(body, { axis = vec(0, 0, 1), speed = 2, max_torque = 5 })
    scene:limit(body, { axis = vec(0, 0, 1), min = -1, max = 1, name = "limit" })
  ]]
  scene:advance(1)
  expect(scene:find("limit").value):near(1, 1e-4)
  expect(scene:find("body").spin:length()):below(1e-9)
  expect(math.abs(scene.ledger.motor)):below(1)
  expect(scene.error.worst_energy):below(10)
end)

test("a scene at rest has no error of its energy", function()
  local scene = open_text [[
    local left, right = scene:particle { at = vec(0, 0, 3) }, scene:particle { at = vec(2, 0, 3) }
    local middle = scene:particle { at = vec(1, 0, 2) }
    scene:nail(left)
    scene:nail(right)
    scene:rod(left, middle)
    scene:rod(right, middle)
  ]]
  scene:advance(1)
  expect(scene.error.worst_energy):below(1e-6)
end)
