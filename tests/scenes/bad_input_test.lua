-- What cannot be is told with its file and line, and the scene is as it was.
local things = [[
  local a = scene:body { name = "a", points = { left = { at = vec(-1, 0, 0), mass = 1 }, right = { at = vec(1, 0, 0), mass = 1 } } }
  local gone = scene:particle { name = "gone" }
  gone:remove()
]]

local wrong = {
  ["scene:build(structure.rod {}, { as = 'panels' })"] = "build: \"panels\" makes plates of faces, and the structure has none",
  ["scene:merge(a, a)"] = "merge: both are body 'a'; it needs two bodies",
  ["scene:split(a, {})"] = "split: no points were given",
  ["scene:split(a, { a.left, a.right })"] = "split: these are all points of body 'a'",
  ["scene:join(a.left, a.right)"] = "join: both points belong to body 'a'",
  ["scene:at(-1, print)"] = "at: argument 1, the time, must be >= 0 s, got -1",
  ["scene:at(0 / 0, print)"] = "at: argument 1, the time, must be a finite number [s], got NaN",
  ["scene:every(0, print)"] = "every: argument 1, the period, must be > 0 s, got 0",
  ["scene:over(2, 1, print)"] = "over: argument 2, the end, must be after the beginning at 2 s, got 1 s",
  ["scene:at(1, gone, print)"] = "particle 'gone' was removed at 0 s by text.lua:3",
  ["scene:freeze(scene:group 'none')"] = "freeze: there is nothing in group 'none'",
  ["print(a.rihgt)"] = "body: unknown field 'rihgt'. Did you mean 'right'? Its own: ",
  ["structure.molecule 'nothing.xyz'"] = "molecule: there is no file",
}

for code, message in pairs(wrong) do
  test("bad input: " .. code, function()
    expect(function() open_text(things .. code) end):fails("text.lua:4: ")
    expect(function() open_text(things .. code) end):fails(message)
    local scene = open_text(things .. "pcall(function() " .. code .. " end)")
    expect(#scene.bodies):equal(1)
    expect(#scene.particles):equal(2)
    scene:advance(0.1)
  end)
end

test("bad input: a condition that errors is told with its line", function()
  expect(function() open_text("scene:when(function()\n return nil + 1 end, print)"):advance(0.1) end):fails "text.lua:2: "
end)

-- What an act can do to a thing so that no step is short enough.
local boundless = {
  ["box:kick(vec(1e200, 0, 0))"] = "the state of body 'box' is no longer a finite number at 0.104",
  ["box.velocity = vec(0, 1e200, 0)"] = "s: it moves at 1e+200 m/s and has an energy beyond all numbers;",
  ["grain:kick(vec(-1e200, 0, 0))"] = "it moves at 1e+200 m/s and has an energy",
  ["tied:kick(vec(1e200, 0, 0))"] = "it moves at 1e+200 m/s and has an energy",
  ["box.spin = vec(0, 0, 1e200)"] = "it turns with an angular momentum of 1.7e+199 kg m²/s and has",
  ["box:twist(vec(0, 1e200, 0))"] = "it is twisted by 1e+200 N m and has an energy",
  ["grain:push(vec(0, 0, 1e200))"] = "it is pushed by 1e+200 N and has an energy",
  ["box:push(vec(0, 0, 1e200))"] = "it is pushed by 1e+200 N and has an energy",
}

for code, message in pairs(boundless) do
  test("what is beyond all numbers is named: " .. code, function()
    local scene = open_text([[
      local box = scene:box { size = 1, mass = 1, at = vec(0, 2, 0), name = "box" }
      local grain, tied = scene:particle { at = vec(3, 0, 0), mass = 1 }, scene:particle { at = vec(5, 0, 0), mass = 1 }
      scene:rod(tied, vec(5, 1, 0))
      scene:at(0.1, function()
        ]] .. code .. " end)")
    expect(function() scene:advance(0.2) end):fails(message)
    expect(function() scene:advance(0.2) end):fails("the scene is stopped at its last good state; the last to act on the scene was text.lua:5, at 0.1 s")
  end)
end

-- Functions of time whose result a constraint cannot keep, with the line where each begins.
local kept = {
  ["rod: argument 3, the length: its result must be > 0 m, got 0"] = "scene:rod(a, b,\n f(1, 0))",
  ["string: length: its result must be > 0 m, got -1"] = "scene:string({ a, b }, { length =\n f(1, -1) })",
  ["string: length: its result must be a finite number, got NaN"] = "scene:string({ a, b }, { length =\n f(1, 0 / 0) })",
  ["rod: length: its result must be > 0 m, got -2"] = "scene:rod(a, b).length =\n f(1, -2)",
  ["gear: ratio: its result must not be 0"] = "scene:gear(c, d, { axis = vec(0, 0, 1), ratio =\n f(2, 0) })",
  ["gear: ratio: its result must not be 0 "] = "scene:gear(c, d, { axis = vec(0, 0, 1), ratio = 2 }).ratio =\n f(2, 0)",
  ["pulley: ratio: its result must be > 0"] = "scene:pulley(a, vec(0, 1, 0), vec(1, 1, 0), b, { ratio =\n f(1, -1) })",
}

for message, code in pairs(kept) do
  test("bad input: a function's result is told with its line, " .. message, function()
    local text = [[
      local a, b, f = scene:particle { at = vec(0, 0, 0) }, scene:particle { at = vec(1, 0, 0) }
      local c, d = scene:box { size = 1, at = vec(5, 0, 0) }, scene:box { size = 1, at = vec(9, 0, 0) }
    ]] .. code:gsub("f%(([^,]*), ([^)]*)%)", "function(t) return t > 0.05 and %2 or %1 end")
    expect(function() open_text(text):advance(0.1) end):fails("text.lua:4: " .. message)
    expect(function() open_text((text:gsub("t > 0.05 and", "true and"))) end):fails("text.lua:4: " .. message)
  end)
end

test("what is given after the options of a tie is refused", function()
  for _, code in ipairs {
    "scene:nail(p, { time_constant = 0.2 }, vec(0, 1, 0))",
    "scene:rod(p, q, { name = 'rod' }, 2)",
    "scene:motor(body, { axis = vec(0, 0, 1), speed = 1 }, body)",
  } do
    expect(function()
      open_text([[
        local p, q = scene:particle { at = vec(0, 0, 0) }, scene:particle { at = vec(1, 0, 0) }
        local body = scene:body { mass = 1, at = vec(3, 0, 0) }
      ]] .. code)
    end):fails("its options come last, got")
  end
end)
