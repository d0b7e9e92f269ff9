-- Pictures and sprites as scripts give them, read them and change them. What is wrong with files is in
-- tests/bindings/lua_picture_options_test.cpp, what is seen in tests/window/sheets_test.cpp.
local function first(code)
  return open_text(code).bodies[1]
end

local function result(code)
  local scene = open_text(code)
  scene:advance(0.02)
  return scene:result "x"
end

test("a picture is given to any body with a shape, by its name or with a width", function()
  expect(first("scene:ball { radius = 1, picture = 'beach_ball.png' }").picture):equal("beach_ball.png")
  expect(first("scene:capsule { radius = 1, length = 1, picture = 'crate.png' }").picture):equal("crate.png")
  expect(first("scene:cylinder { radius = 1, length = 1, picture = 'crate.png' }").picture):equal("crate.png")
  local tiled = first("scene:box { size = 1, picture = { file = 'bricks.png', width = 0.5 } }").picture
  expect(tiled.file):equal("bricks.png")
  expect(tiled.width):equal(0.5)
  expect(first("scene:box { size = 1 }").picture == nil):is_true()
end)

test("with a picture the usual color is white; one that is given counts, and is the shape's before the body's", function()
  expect(first("scene:box { size = 1, picture = 'crate.png' }").color):equal("#ffffff")
  expect(first("scene:box { size = 1, picture = 'crate.png', color = '#f00' }").color):equal("#ff0000")
  local code = "scene:body { picture = 'crate.png', %s shape = shape.ball(1, { %s }) }"
  expect(first(code:format("", "")).picture):equal("crate.png")
  expect(first(code:format("", "")).color):equal("#ffffff")
  expect(first(code:format("", "picture = 'bricks.png'")).picture):equal("bricks.png")
  expect(first(code:format("color = '#0f0',", "")).color):equal("#00ff00")
  expect(first(code:format("color = '#0f0',", "color = '#00f'")).color):equal("#0000ff")
end)

test("a picture is written while the scene runs, and taken away", function()
  expect(result [[
    local body = scene:body { shapes = { shape.box(1, 1, 1), shape.ball(1) } }
    local slab = scene:ground { shape = shape.box(9, 1, 9), at = vec(0, -3, 0) }
    body.picture = { file = "bricks.png", width = 0.5 }
    body.sprite = { file = "bird.png", width = 2 }
    slab.picture = "crate.png"
    local all = body.picture.file .. body.sprite.file .. slab.picture
    body.picture, body.sprite, slab.picture = nil, nil, nil
    scene:result("x", all .. tostring(body.picture) .. tostring(body.sprite) .. tostring(slab.picture))
  ]]):equal("bricks.pngbird.pngcrate.pngnilnilnil")
end)

test("floors and grounds have pictures, families sprites", function()
  expect(result [[
    local floor = scene:floor { picture = "grass.png" }
    local wall = scene:ground { shape = shape.box(1, 1, 1), picture = "bricks.png" }
    local birds = scene:family("birds", { sprite = { file = "bird.png", width = 0.5 } })
    scene:result("x", floor.picture.width .. wall.picture .. birds.sprite.width .. floor.color)
  ]]):equal("1.0bricks.png0.5#ffffff")
end)

test("what is wrong with a picture that is written changes nothing", function()
  expect(result [[
    local body = scene:box { size = 1, picture = "crate.png" }
    local fine, message = pcall(function() body.picture = "gone.png" end)
    scene:result("x", body.picture .. tostring(fine) .. tostring(message):match("body: picture: there is no file"))
  ]]):equal("crate.pngfalsebody: picture: there is no file")
end)
