-- What lies flush is as one: faces and edges at its seams are hidden.

local shapes = {
  box = "shape.box { size = vec(0.4, 0.3, 0.35), density = 500, friction = 0, restitution = $e }",
  hull = "shape.hull(structure.dodecahedron { edge = 0.15 }, { density = 500, friction = 0, restitution = $e })",
  capsule = "shape.capsule(0.1, 0.4, { density = 500, friction = 0, restitution = $e })",
  cylinder = "shape.cylinder(0.15, 0.3, { density = 500, friction = 0, restitution = $e })",
}

local tiles = [[
  scene.step = 1 / $hz
  for i = -4, 20 do
    scene:ground { shape = shape.box { size = vec(0.5, 1, 4), friction = 0, restitution = $e }, at = vec(0.5 * i, -0.5, 0) }
  end
  local axis = vec(math.sin($number), math.cos(1.7 * $number), math.sin(2.3 * $number)):normalized()
  scene:body { name = "thrown", shape = $shape, at = vec(-1 + 0.07 * $number, 0.5, 0),
               orientation = quat(axis, 0.9 * $number), velocity = vec($speed, 0, 0) }
]]

local function filled(text, values)
  for _ = 1, 2 do text = text:gsub("%$(%w+)", values) end
  return text
end

for kind, shape in pairs(shapes) do
  for _, hz in ipairs { 60, 240 } do
    test(("a %s that bounces over seams at %d Hz keeps its speed along them"):format(kind, hz), function()
      for _, e in ipairs { 0, 0.6 } do
        for number = 1, 9 do
          local speed = 1 + number % 3
          local scene = open_text(filled(tiles, { shape = shape, hz = hz, e = e, number = number, speed = speed }))
          scene:advance(2)
          expect(scene:find("thrown").velocity.x):near(speed, 0.02 * speed)
        end
      end
    end)
  end
end

local groove = [[
  for side = -1, 1, 2 do
    scene:ground { shape = shape.box { size = vec(2, 1, 2), friction = 0 }, orientation = quat(vec(0, 0, 1), side * $slope),
                   at = vec(side * (math.cos($slope) + 0.5 * math.sin($slope)), math.sin($slope) - 0.5 * math.cos($slope), 0) }
  end
  scene:box { name = "in it", size = vec(0.4, 0.4, 0.4), friction = 0, at = vec(0.1, 0.8, 0), orientation = quat(vec(0, 0, 1), $turn) }
]]

test("what falls into a groove of two boxes stays in it", function()
  for _, slope in ipairs { 0.1, 0.4, math.pi / 4, 1.0 } do
    for _, turn in ipairs { 0, 0.4, math.pi / 4 } do
      local scene = open_text(filled(groove, { slope = slope, turn = turn }))
      scene:advance(5)
      expect(scene:find("in it").position.y):above(0.15)
      expect(scene.error.worst_penetration):below(1e-3)
    end
  end
end)

test("a wall that stands beside a floor, or on it, stops what slides and what falls along it", function()
  for _, foot in ipairs { 0, 1 } do
    local scene = open_text(filled([[
      scene:ground { shape = shape.box { size = vec(4, 1, 4), friction = 0 }, at = vec(-2 + $foot, -0.5, 0) }
      scene:ground { shape = shape.box { size = vec(1, 4, 4), friction = 0 }, at = vec(0.5, 2 - (1 - $foot), 0) }
      scene:box { name = "slides", size = vec(0.4, 0.4, 0.4), friction = 0, at = vec(-2, 0.2, 0), velocity = vec(3, 0, 0) }
      scene:box { name = "falls", size = vec(0.4, 0.4, 0.4), friction = 0, at = vec(-0.2, 1, 1), velocity = vec(2, 0, 0) }
    ]], { foot = foot }))
    scene:advance(2)
    for _, name in ipairs { "slides", "falls" } do
      expect(scene:find(name).position.x):near(-0.2, 1e-3)
      expect(scene:find(name).position.y):near(0.2, 1e-3)
      expect(scene:find(name).velocity:length()):below(1e-3)
    end
  end
end)

test("a tile that stands out of a floor stops what slides against it", function()
  local scene = open_text([[
    scene:ground { shape = shape.box { size = vec(2, 1, 4), friction = 0 }, at = vec(-1, -0.5, 0) }
    scene:ground { shape = shape.box { size = vec(2, 1, 4), friction = 0 }, at = vec(1, -0.45, 0) }
    scene:box { name = "slides", size = vec(0.4, 0.4, 0.4), friction = 0, at = vec(-1, 0.2, 0), velocity = vec(1, 0, 0) }
  ]])
  scene:advance(2)
  expect(scene:find("slides").position.x):below(-0.19)
end)

test("what bounces over the seams of one body of flush boxes keeps its speed along them", function()
  for number = 1, 8 do
    local scene = open_text(filled([[
      scene.step = 1 / 60
      scene:floor { height = -1, friction = 1 }
      local boxes = {}
      for i = -4, 20 do boxes[#boxes + 1] = shape.box { size = vec(0.5, 1, 4), friction = 0, density = 1e5, at = vec(0.5 * i - 4, -0.5, 0) } end
      scene:body { at = vec(4, 0, 0), shapes = boxes }
      scene:body { name = "thrown", shape = $shape, at = vec(-1 + 0.07 * $number, 0.5, 0), velocity = vec(2, 0, 0),
                   orientation = quat(vec(math.sin($number), 1, math.cos($number)):normalized(), 0.9 * $number) }
    ]], { shape = number % 2 == 0 and shapes.hull or shapes.box, number = number, e = 0.5 }))
    scene:advance(2)
    expect(scene:find("thrown").velocity.x):near(2, 0.01)
  end
end)
