test("hydrophobic: drops form, and grow", function()
  local scene = open("scenes/hydrophobic.lua", { dumbbells = 60 })
  local before = scene.energy.potential
  scene:advance(15)
  expect(scene:read "largest drop"):above(3)
  expect(scene.energy.potential):below(before - 100)
  expect(scene:read "temperature"):near(0.35, 0.2)
end)

test("flock: those who flew anyhow come to fly one way", function()
  local scene = open("scenes/flock.lua", { birds = 60 })
  expect(scene:read "order"):below(0.2)
  scene:advance(24)
  expect(scene:read "order"):above(0.45)
end)

test("cloth: hangs without a torn thread in calm air, and tears where it is pulled", function()
  local scene = open("scenes/cloth.lua", { threads = 10, wind = 0, balls = false })
  scene:advance(2)
  expect(scene:read "torn threads"):equal(0)
  expect(scene.error.worst_constraint):below(1e-12)
  local lowest = math.huge
  for _, knot in ipairs(scene.particles) do lowest = math.min(lowest, knot.position.y) end
  expect(lowest):below(2.9)
  expect(lowest):above(0.5)
  scene.particles[50]:kick(vec(0, 0, 500))
  scene:advance(0.2)
  expect(scene:read "torn threads"):above(0)
end)

test("orbits: energy and angular momentum stay, and so do the planets", function()
  local scene = open("scenes/orbits.lua", { dust = 20 })
  local turning = scene.angular_momentum.y
  local distances = { 1, 1.6, 3.4, 4.4 }
  scene:advance(10)
  expect(scene.error.worst_energy):below(1e-6)
  expect(scene.angular_momentum.y):near(turning, 1e-11 * math.abs(turning))
  for i, distance in ipairs(distances) do
    expect((scene.particles[i + 1].position - scene.particles[1].position):length()):near(distance, 0.3 * distance)
  end
end)
