-- Names, choices and values that could only lead to a mistake are refused, with what to write.
local things = [[
  local a, b = scene:particle { at = vec(0, 0, 0) }, scene:particle { at = vec(1, 0, 0) }
  local body = scene:body { points = { head = { at = vec(0, 0, 0), mass = 1 } } }
]]

local wrong = {
  ["scene:probe('', function() return 1 end)"] = "probe: argument 1, the name, must not be empty",
  ["scene:probe('time', function() return 1 end)"] = "probe: argument 1, the name, must not be 'time'",
  ["scene:result('', 1)"] = "result: argument 1, the name, must not be empty",
  ["scene:button('', print)"] = "button: argument 1, the name, must not be empty",
  ["scene:param('', 1)"] = "param: argument 1, the name, must not be empty",
  ["scene:param('kind', 'red', { choices = {} })"] = "param: choices must have at least one value, got none",
  ["scene:result('a', {})"] = "result: argument 2, the value, must be a number, true or false, or a string, got a table",
  ["scene:open('nofile.lua')"] = "open: there is no file 'nofile.lua' in the scene's folder",
  ["body.head = 5"] = "body: head can be read, not written",
  ["body.haed = 5"] = "body: cannot write unknown field 'haed'. Did you mean 'head'?",
  ["scene.duration = 0"] = "scene: duration must be > 0 s, got 0",
}

for code, message in pairs(wrong) do
  test("refused: " .. code, function()
    expect(function() open_text(things .. code) end):fails("text.lua:3: ")
    expect(function() open_text(things .. code) end):fails(message)
  end)
end

test("duration goes back to what it is when none is given", function()
  open_text [[
    assert(scene.duration == nil)
    scene.duration = 3
    scene.duration = nil
    assert(scene.duration == nil)
  ]]
end)

test("a group without a point has no bounds", function()
  open_text(things .. [[
    local group = scene:group "things"
    local low, high = group:bounds()
    assert(low == nil and high == nil)
    low, high = group:add(a, b):bounds()
    assert(low == vec(0, 0, 0) and high == vec(1, 0, 0))
  ]])
end)

test("what has no name is found by the number that messages call it", function()
  open_text [[
    scene:floor {}
    local first = scene:box { size = 1, at = vec(0, 0.5, 0), points = { a = vec(0, 0, 0) } }
    local p, named = scene:particle { at = vec(4, 1, 0) }, scene:box { size = 1, at = vec(0, 3, 0), name = "named" }
    local field = scene:field(scene, force.drag { linear = 0.1 })
    for _, thing in ipairs { first, p, field } do
      local number = tonumber(tostring(thing):match("%d+$"))
      assert(scene:find(number) == thing)
    end
    assert(scene:find(1e6) == nil and tostring(named) == "body 'named'")
    first:remove()
    assert(scene:find(2) == nil)
  ]]
  expect(function() open_text("scene:find(1.5)") end):fails("must be a whole one from 1 to 9e15, got 1.5")
  expect(function() open_text("scene:find(0)") end):fails("must be a whole one from 1 to 9e15, got 0")
  expect(function() open_text("scene:find(true)") end):fails("must be a name, or the number of a thing, got a boolean")
end)
