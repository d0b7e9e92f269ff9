-- What the page on touch says of its limits.
local function energy_error(sides, rate)
  local scene = open_text(([[
    scene.step = 1 / %d
    scene:floor {}
    local radius, sides, points = 0.3, %d, {}
    for i = 1, sides do
      local angle = 2 * math.pi * (i - 0.5) / sides
      for _, z in ipairs { -0.3, 0.3 } do points[#points + 1] = vec(radius * math.cos(angle), radius * math.sin(angle), z) end
    end
    scene:body { shape = shape.hull { points = points }, mass = 1, at = vec(0, radius * math.cos(math.pi / sides), 0),
      velocity = vec(1, 0, 0), spin = vec(0, 0, -1 / radius) }
  ]]):format(rate, sides))
  scene:advance(1)
  return scene.error.energy
end

for _, sides in ipairs { 12, 48, 96 } do
  test("a prism of " .. sides .. " sides that rolls keeps its energy, as far as the second order of the step", function()
    expect(energy_error(sides, 240)):below(2e-4)
    expect(energy_error(sides, 960)):below(2e-5)
  end)
end
