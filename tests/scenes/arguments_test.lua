-- What is given to a call beyond what it takes is refused.
local things = [[
  local a, b = scene:particle { at = vec(0, 0, 0) }, scene:particle { at = vec(1, 0, 0) }
  local function f() end
]]

local wrong = {
  ["scene:at(1, f, 5)"] = "at: its action comes last, got a number after it",
  ["scene:at(1, a, f, 5)"] = "at: takes at most 3 arguments, got 4",
  ["scene:after(1, f, { again = true })"] = "after: its action comes last, got a table after it",
  ["scene:every(1, f, 5)"] = "every: its action comes last, got a number after it",
  ["scene:over(0, 1, f, 5)"] = "over: its action comes last, got a number after it",
  ["scene:when(f, f, {}, 5)"] = "when: its table of options comes last, got a number after it",
  ["scene:play(f, 5)"] = "play: its script comes last, got a number after it",
  ["scene:on('step', f, 5)"] = "on: the function comes last",
  ["scene:on('key', 'a', f, 5)"] = "on: takes at most 3 arguments, got 4",
  ["scene:connect({ a, b }, force.damper { damping = 1 }, {}, 5)"] = "connect: its table of options comes last, got a number after it",
  ["read_table('a.csv', 5)"] = "read_table: takes at most 1 argument, got 2",
  ["quat(vec(0, 0, 1), 1, 2)"] = "quat: takes at most 2 arguments, got 3",
  ["quat(vec(0, 0, 1), 1):inverse(1)"] = "quat:inverse: takes no arguments, got 1",
  ["quat(vec(0, 0, 1), 1):rotate(vec(0, 0, 1), 1)"] = "quat:rotate: takes at most 1 argument, got 2",
  ["vec(0, 0, 1):length(1)"] = "vec:length: takes no arguments, got 1",
  ["vec(0, 0, 1):normalized(1)"] = "vec:normalized: takes no arguments, got 1",
  ["vec(0, 0, 1):dot(vec(0, 0, 1), 1)"] = "vec:dot: takes at most 1 argument, got 2",
  ["vec(0, 0, 1):cross(vec(0, 0, 1), 1)"] = "vec:cross: takes at most 1 argument, got 2",
  ["force.spring({ stiffness = 1 }, { length = 1 })"] = "force.spring: takes at most 1 argument, got 2",
  ["force.pair({ potential = function(r) return r end }, 1)"] = "force.pair: takes at most 1 argument, got 2",
  ["force.point({ force = function(p) return vec(0, 0, 0) end }, 1)"] = "force.point: takes at most 1 argument, got 2",
  ["structure.cube({ edge = 1 }, 2)"] = "cube: takes at most 1 argument, got 2",
  ["structure.molecule('c60.xyz', { scale = 1 }, 2)"] = "molecule: takes at most 2 arguments, got 3",
  ["shape.plane({}, 2)"] = "plane: takes at most 1 argument, got 2",
  ["scene:field(scene, force.point { force = function(p) return p.velocity * p.velocity:length(2) end })"] = "vec:length: takes no arguments, got 1",
}

for code, message in pairs(wrong) do
  test("more than a call takes is refused: " .. code, function()
    expect(function() open_text(things .. code) end):fails("text.lua:3: ")
    expect(function() open_text(things .. code) end):fails(message)
  end)
end

test("more than an expectation, a test or an opened scene takes is refused", function()
  local function f() end
  local function fails(call, message) expect(call):fails(message) end
  fails(function() expect(("a"):gsub("a", "b")) end, "expect: takes at most 1 argument, got 2; a call that comes last gives all its values")
  fails(function() expect(1):equal(1, 2) end, "equal: takes at most 1 argument, got 2")
  fails(function() expect(1):near(1, 0.1, 2) end, "near: takes at most 2 arguments, got 3")
  fails(function() expect(1):below(2, 3) end, "below: takes at most 1 argument, got 2")
  fails(function() expect(1):above(0, 3) end, "above: takes at most 1 argument, got 2")
  fails(function() expect(true):is_true("so") end, "is_true: takes no arguments, got 1")
  fails(function() expect(f):fails("a", "b") end, "fails: takes at most 1 argument, got 2")
  fails(function() test("a", f, 5) end, "test: takes at most 2 arguments, got 3")
  fails(function() open("a.lua", {}, {}, 5) end, "open: takes at most 3 arguments, got 4")
  fails(function() open_text("", {}, {}, 5) end, "open_text: takes at most 3 arguments, got 4")
  expect("a", nil):equal("a")
end)

test("nil at the end of a call is nothing", function()
  open_text(things .. [[
    scene:at(1, f, nil)
    scene:on("step", f, nil)
    assert(vec(3, 4, 0):length(nil) == 5)
    structure.cube({ edge = 1 }, nil)
    force.spring({ stiffness = 1 }, nil)
  ]])
end)
