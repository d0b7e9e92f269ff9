-- What goes wrong in a step is told with the line that it comes from, where that is known.
local wrong = {
  ["scene.integrator = 'rk4'\nscene:nail(p)"] = "text.lua:2: scene: the integrator \"rk4\" moves only what no constraint ties: there is nail",
  ["scene:emitter { rate = 1e12 }"] = "text.lua:2: emitter",
  ["local source = scene:emitter { rate = 1 }\nsource.rate = 1e12"] = "text.lua:3: emitter",
  ["scene:emitter { name = 'spray', rate = function() return 1e12 end }"] = "text.lua:2: emitter 'spray': rate must be at most",
  ["scene:at(0.1, function()\np.velocity = vec(1e308, 1e308, 0) end)"] = "the last to act on the scene was text.lua:3, at 0.1 s",
}

for code, message in pairs(wrong) do
  test("told with its line: " .. code, function()
    local opened = open_text("local p = scene:particle { at = vec(0, 0, 0) }\n" .. code)
    expect(function() opened:advance(0.5) end):fails(message)
  end)
end
