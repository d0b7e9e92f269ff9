-- Keys and gamepads that are held, and what games need besides: sounds, levels, what is saved.
test("a key is held from the next step on until it is released", function()
  local scene = open_text [[
    local held, down, up = 0, 0, 0
    scene:on("key", "left", function() down = down + 1 end)
    scene:on("key_up", "left", function() up = up + 1 end)
    scene:on("step", function()
      if scene.keys.left then held = held + 1 end
      scene:result("held", held) scene:result("down", down) scene:result("up", up)
    end)
  ]]
  for _ = 1, 3 do scene:step() end
  expect(scene:result("held")):equal(0)
  scene:hold("left")
  for _ = 1, 5 do scene:step() end
  scene:release("left")
  for _ = 1, 5 do scene:step() end
  expect(scene:result("held")):equal(5)
  expect(scene:result("down")):equal(1)
  expect(scene:result("up")):equal(1)
end)

test("words of a key's name may be joined, and a wrong name says what there is", function()
  local scene = open_text [[
    scene:on("step", function() scene:result("fast", scene.keys.left_shift and scene.keys["keypad 4"]) end)
  ]]
  scene:hold("left shift")
  scene:hold("keypad_4")
  scene:step()
  expect(scene:result("fast")):is_true()
  expect(function() open_text [[print(scene.keys.lefft)]] end):fails("Did you mean 'left'?")
  expect(function() open_text [[print(scene.keys.A)]] end):fails("there is no key 'A'")
  expect(function() open_text [[scene.keys.left = true]] end):fails("keys: cannot write unknown field 'left'")
  expect(function() open_text [[print(scene.pad.left_z)]] end):fails("Did you mean 'left_x'?")
  expect(function() scene:hold("pad.left_x", 2) end):fails("must be from -1 to 1, got 2")
end)

test("a key that is waited for must be one that there is, by any name of it", function()
  local scene = open_text [[
    local down = 0
    for _, name in ipairs { "left_shift", "keypad 4", "j", "é", "+", "ctrl+z", "ctrl+shift+left_ctrl" } do
      scene:on("key", name, function() down = down + 1 scene:result("down", down) end)
    end
  ]]
  for _, name in ipairs { "left shift", "keypad_4", "j", "é", "+" } do scene:hold(name) end
  scene:step()
  expect(scene:result("down")):equal(5)
  local function waits_for(name) return function() open_text("\nscene:on('key', '" .. name .. "', print)") end end
  expect(waits_for "spcae"):fails(":2: keys: there is no key 'spcae'. Did you mean 'space'?")
  expect(waits_for "ctrl+delte"):fails("Did you mean 'delete'?")
  expect(waits_for "Space"):fails("there is no key 'Space'")
  expect(waits_for "pad.k"):fails(":2: pad: unknown 'k'.")
end)

test("a gamepad's axes and buttons are at rest until they are held", function()
  local scene = open_text [[
    scene:on("step", function()
      scene:result("x", scene.pad.left_x) scene:result("a", scene.pad.a) scene:result("gas", scene.pad.right_trigger)
    end)
  ]]
  scene:step()
  expect(scene:result("x")):equal(0)
  expect(scene:result("a")):equal(false)
  scene:hold("pad.left_x", -0.25)
  scene:hold("pad.a")
  scene:step()
  expect(scene:result("x")):equal(-0.25)
  expect(scene:result("a")):is_true()
  expect(scene:result("gas")):equal(0)
  scene:release("pad.left_x")
  scene:step()
  expect(scene:result("x")):equal(0)
end)

test("a gamepad's button that is pressed is told once, as a key is, and again once it was let go", function()
  local scene = open_text [[
    local down, up, any = 0, 0, ""
    scene:on("key", "pad.a", function() down = down + 1 end)
    scene:on("key_up", "pad.a", function() up = up + 1 end)
    scene:on("key", function(name) any = any .. name .. " " end)
    scene:on("step", function() scene:result("down", down) scene:result("up", up) scene:result("any", any) end)
  ]]
  local function told(down, up)
    expect(scene:result("down")):equal(down)
    expect(scene:result("up")):equal(up)
  end
  scene:hold("pad.a")
  scene:hold("pad.right_trigger", 0.2)
  for _ = 1, 3 do scene:step() end
  told(1, 0)
  scene:hold("pad.a")
  scene:hold("pad.right_trigger", 0.9)
  scene:step()
  told(1, 0)
  scene:release("pad.a")
  scene:step()
  told(1, 1)
  scene:hold("pad.a")
  scene:step()
  told(2, 1)
  expect(scene:result("any")):equal("pad.a pad.right_trigger pad.a ")
  expect(scene.taken):equal("pad.a")
end)

test("a key that is held twice is pressed once", function()
  local scene = open_text [[
    local down = 0
    scene:on("key", "j", function() down = down + 1 end)
    scene:on("step", function() scene:result("down", down) end)
  ]]
  local function after_step() scene:step() return scene:result("down") end
  scene:hold("j")
  scene:hold("j")
  expect(after_step()):equal(1)
  scene:hold("j")
  expect(after_step()):equal(1)
  scene:release("j")
  scene:hold("j")
  scene:hold("j")
  expect(after_step()):equal(2)
  scene:hold("j", 0)
  expect(after_step()):equal(2)
  scene:hold("j")
  expect(after_step()):equal(3)
end)

test("a test presses a button of the scene", function()
  local scene = open_text [[
    local pressed = 0
    scene:button("more", function() pressed = pressed + 1 end)
    scene:button("less", function() pressed = pressed - 1 end)
    scene:on("step", function() scene:result("pressed", pressed) end)
  ]]
  scene:press("more")
  scene:step()
  expect(scene:result("pressed")):equal(1)
  scene:step()
  expect(scene:result("pressed")):equal(1)
  scene:press("more")
  scene:press("more")
  scene:press("less")
  scene:step()
  expect(scene:result("pressed")):equal(2)
  expect(function() scene:press("mor") end):fails("press: there is no button 'mor'. Did you mean 'more'? There are: more, less")
  expect(function() open_text(""):press("more") end):fails("press: there is no button 'more'. There are none")
end)

test("a test reads and writes what a scene saves, before it and after", function()
  local play = [[
    scene.saved.plays = (scene.saved.plays or 0) + 1
    scene:on("step", function() scene:result("best", scene.saved.best or 0) end)
  ]]
  local first = open_text(play)
  expect(first.saved.plays):equal(1)
  first.saved.best = 7
  first:step()
  expect(first:result("best")):equal(7)
  expect(open_text(play).saved.best):equal(nil)
  local later = open_text(play, nil, { plays = 3, best = 2.5 })
  later:step()
  expect(later.saved.plays):equal(4)
  expect(later:result("best")):equal(2.5)
  local again = open_text(play, {}, first.saved)
  expect(again.saved.plays):equal(2)
  expect(first.saved.plays):equal(2)
  expect(function() first.saved.best = {} end):fails("saved: best must be a number, a boolean, a string or nil, got a table")
  expect(function() open_text(play, nil, { best = {} }) end):fails("saved: best must be a number")
  expect(function() open_text(play, nil, 3) end):fails("open_text: argument 3, what is saved, must be a table, got a number")
  expect(function() open_text(play, nil, { 3 }) end):fails("argument 3, what is saved, must have names that are strings")
end)

test("what is held goes back with the state", function()
  local scene = open_text [[
    scene:on("step", function() scene:result("up", scene.keys.up) end)
  ]]
  scene:hold("up")
  scene:step()
  local before = scene:snapshot()
  scene:release("up")
  scene:step()
  expect(scene:result("up")):equal(false)
  scene:restore(before)
  scene:step()
  expect(scene:result("up")):is_true()
end)

test("a key that was read stays the scene's when the state goes back", function()
  local scene = open_text [[
    scene:on("step", function() scene:result("up", scene.keys.up) end)
    local once
    scene:at(0.1, function() if not once then once = true scene:reset() end end)
  ]]
  scene:hold("up")
  scene:advance(0.2)
  expect(scene.taken):equal("up")
end)

test("a law cannot read keys", function()
  expect(function()
    open_text [[scene:field(scene, force.point { force = function(p) return vec(scene.keys.left and 1 or 0, 0, 0) end })]]
  end):fails("a law cannot read what is held of keys")
end)

test("sounds begin in a step, and are gone in the next", function()
  local scene = open_text [[
    scene:at(0, function() scene:sound("wood") scene:sound("blip", { volume = 0.5, pitch = 2 }) end)
  ]]
  scene:step()
  expect(table.concat(scene.sounds, " ")):equal("wood blip")
  scene:step()
  expect(#scene.sounds):equal(0)
  expect(function() open_text [[scene:sound("wod")]] end):fails("Did you mean 'wood'?")
  expect(function() open_text [[scene:sound("none.wav")]] end):fails("there is no file")
  expect(function() open_text [[scene:sound("../x.wav")]] end):fails("must be a file below the scene's folder")
  expect(function() open_text [[scene:sound("wood", { volume = 2 })]] end):fails("volume must be from 0 to 1, got 2")
  expect(function() open_text [[scene:sound("wood", { pitch = 0 })]] end):fails("pitch must be from 0.125 to 8, got 0")
end)

test("what touches is heard as its density says, and its motion stays the same", function()
  local code = [[
    scene:floor()
    local steel = scene:ball { radius = 0.1, density = 7800, at = vec(0, 0.5, 0) }
    local plank = scene:box { size = 0.2, density = 600, at = vec(2, 1, 0) }
  ]]
  local silent, heard, glass = open_text(code), open_text(code .. "scene.contact_sounds = true"),
                               open_text(code .. "scene.contact_sounds = 'glass'")
  local said, of_glass = {}, {}
  for _ = 1, 180 do
    silent:step() heard:step() glass:step()
    for _, name in ipairs(heard.sounds) do said[#said + 1] = name end
    for _, name in ipairs(glass.sounds) do of_glass[#of_glass + 1] = name end
    expect(heard.hash):equal(silent.hash)
  end
  expect(said[1]):equal("metal")
  expect(said[2]):equal("wood")
  expect(of_glass[1]):equal("glass")
end)

test("a scene may open another when the step is done", function()
  local scene = open_text [[scene:at(0, function() scene:open("touch_test.lua") scene:result("after", true) end)]]
  expect(scene.next):equal(nil)
  scene:step()
  expect(scene:result("after")):is_true()
  expect(scene.next:match("touch_test.lua$")):equal("touch_test.lua")
  expect(scene.finished):is_true()
  expect(function() open_text [[scene:open("../other.lua")]] end):fails("must be a file below the scene's folder")
  expect(function() open_text [[scene:open("level2")]] end):fails("must end in .lua")
  local two = 'scene:open("touch_test.lua") scene:open("touch_test.lua")\nscene:open("names_test.lua")'
  expect(function() open_text(two) end):fails("text.lua:2: open: the next scene is touch_test.lua already")
end)

test("a scene opens another with parameters, which a test can open it with", function()
  local scene = open_text [[
    local score = scene:param("score", 3)
    scene:at(0, function() scene:open("controls_test.lua", { score = score + 1, name = "Ann", fast = true }) end)]]
  expect(next(scene.next_parameters)):equal(nil)
  scene:step()
  expect(scene.next_parameters.score):equal(4)
  expect(scene.next_parameters.name):equal("Ann")
  expect(scene.next_parameters.fast):is_true()
  expect(scene.log[#scene.log].text):equal('text.lua:2: the next scene is controls_test.lua with fast = true, name = Ann, score = 4')
  local level = 'scene:param("score", 0) scene:param("name", "") scene:param("fast", false)'
  open_text(level, scene.next_parameters)
  expect(function() open_text('scene:param("scores", 0)', { score = 4 }) end):fails("open_text: score=4: the scene has no parameter 'score'. Did you mean 'scores'?")
end)

test("parameters that a scene is opened with are plain values by their names", function()
  local function fails(parameters, message)
    expect(function() open_text('scene:open("touch_test.lua", ' .. parameters .. ")") end):fails("text.lua:1: open: " .. message)
  end
  fails("3", "argument 2, the parameters, must be a table, got a number")
  fails("{ 3 }", "argument 2, the parameters, must have names that are strings")
  fails("{ at = vec(0, 0, 0) }", "parameter at must be a number, true or false, or a string, got a vec")
  fails("{ x = 1 / 0 }", "parameter x must be a finite number, got infinity")
  fails('{ ["scene.step"] = 1 }', "a parameter has no '=' or '.' in its name, got 'scene.step'")
  local two = 'scene:open("touch_test.lua", { x = 1 }) scene:open("touch_test.lua", { x = 1 })\nscene:open("touch_test.lua", { x = 2 })'
  expect(function() open_text(two) end):fails("text.lua:2: open: the next scene is touch_test.lua already, with other parameters")
end)

test("the mouse is told what a test says, and without one there is none", function()
  local code = [[
    local pressed, released = 0, 0
    scene:on("step", function()
      local mouse = scene.mouse
      if mouse.left_pressed then pressed = pressed + 1 end
      if mouse.left_released then released = released + 1 end
      scene:result("there", mouse.position ~= nil) scene:result("left", mouse.left) scene:result("right", mouse.right)
      scene:result("x", mouse.position and mouse.position.x or 0) scene:result("wheel", mouse.wheel)
      scene:result("pressed", pressed) scene:result("released", released)
    end)
  ]]
  local scene = open_text(code)
  scene:step()
  expect(scene:result("there")):equal(false)
  expect(scene:result("left")):equal(false)
  expect(scene.taken):equal("mouse.left, mouse.position, mouse.right, mouse.wheel")
  scene:mouse { at = vec(3, 2, 1), left = true, wheel = 2 }
  scene:step()
  expect(scene:result("x")):equal(3)
  expect(scene:result("left")):is_true()
  expect(scene:result("right")):equal(false)
  expect(scene:result("wheel")):equal(2)
  local held = scene:snapshot()
  scene:step() scene:step()
  expect(scene:result("wheel")):equal(0)
  expect(scene:result("pressed")):equal(1)
  scene:mouse { right = true }
  scene:step() scene:step()
  expect(scene:result("x")):equal(3)
  expect(scene:result("left")):equal(false)
  expect(scene:result("right")):is_true()
  expect(scene:result("released")):equal(1)
  scene:restore(held)
  scene:step()
  expect(scene:result("left")):is_true()
  expect(scene:result("pressed")):equal(1)
  expect(function() scene:mouse { at = vec(0, 0 / 0, 0) } end):fails("at must be a finite vec")
  expect(function() scene:mouse { wheel = 1 / 0 } end):fails("wheel must be")
  expect(function() scene:mouse { middel = true } end):fails("Did you mean 'middle'?")
  expect(function() open_text [[scene.mouse.left = true]] end):fails("mouse: left can be read, not written")
  expect(function() open_text [[print(scene.mouse.lef)]] end):fails("Did you mean 'left'?")
end)

test("what is saved stays when the state goes back", function()
  local scene = open_text [[
    assert(scene.saved.best == nil)
    scene.saved.best, scene.saved.name, scene.saved.won = 12, "me", true
    scene.saved.none = nil
    scene:on("step", function()
      scene.saved.best = scene.saved.best + 1
      scene:result("best", scene.saved.best) scene:result("name", scene.saved.name) scene:result("won", scene.saved.won)
    end)
  ]]
  local before = scene:snapshot()
  scene:step()
  scene:restore(before)
  scene:step()
  expect(scene:result("best")):equal(14)
  open_text [[scene.saved.a, scene.saved.b = 3, 0.5 assert(tostring(scene.saved.a) == "3" and scene.saved.b == 0.5)]]
  expect(scene:result("name")):equal("me")
  expect(scene:result("won")):is_true()
  expect(function() open_text [[scene.saved.x = {}]] end):fails("saved: x must be a number, a boolean, a string or nil, got a table")
  expect(function() open_text [[scene.saved.x = 0/0]] end):fails("x must be a finite number")
end)

test("a camera is given at once, or field by field", function()
  local scene = open_text [[
    local p = scene:particle()
    scene.camera = { at = vec(0, 1, 9), zoom = 2 }
    scene.camera.follow, scene.camera.ease = p, 0.5
    assert(scene.camera.at == vec(0, 1, 9) and scene.camera.follow == p and scene.camera.zoom == 2)
    assert(scene.camera.ease == 0.5 and scene.camera.look_at == nil)
    scene.camera.follow = nil
    assert(scene.camera.follow == nil)
  ]]
  expect(function() open_text [[scene.camera = { at = vec(1, 0, 0), look_at = vec(1, 0, 0) }]] end)
    :fails("text.lua:1: scene: camera: at and look_at must not be the same place")
  expect(function() open_text [[scene.camera.zoom = 0]] end):fails("zoom must be > 0")
  expect(function() open_text [[scene.camera.ease = -1]] end):fails("ease must be from 0 to 60 s, got -1")
  expect(function() open_text [[scene.camera.follow = 3]] end):fails("must be a thing of the scene")
end)
