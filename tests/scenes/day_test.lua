-- A scripted day: what waits and what has been survives a snapshot.

local day = [[
  scene.gravity = vec(0, 0, 0)
  local lamp = scene:particle { at = vec(0, 0, 0), velocity = vec(1, 0, 0), name = "lamp" }
  lamp.data.told = ""
  local function tell(what) 
    return function()
      lamp.data.told = lamp.data.told .. string.format("%s %.4f, ", what, scene.time)
      scene:result("told", lamp.data.told)
    end
  end
  scene:at(0.3, tell "morning")
  scene:after(0.9, tell "evening")
  scene:every(0.25, tell "bell")
  scene:over(0.4, 0.6, lamp, function(u) lamp.mass = 1 + u end)
  scene:when({ distance_above = 0.7, of = { lamp, vec(0, 0, 0) } }, tell "far")
  local early = scene:at(0.1, function() scene:at(0.8, tell "made by an event") end)
  local never = scene:at(0.95, tell "cancelled")
  scene:at(0.2, function() never:cancel() end)
]]

local function told(scene) return scene:result "told" end

test("all events of a day fire again, at the same times, after a snapshot is restored", function()
  local scene = open_text(day)
  scene:advance(0.5)
  local noon = scene:snapshot()
  local before = told(scene)
  scene:advance(0.6)
  local whole = told(scene)
  expect(#whole > #before):is_true()
  scene:restore(noon)
  expect(told(scene)):equal(before)
  scene:advance(0.6)
  expect(told(scene)):equal(whole)
  expect(whole:find("cancelled") == nil):is_true()
  expect(whole:find("made by an event 0.8000", 1, true) ~= nil):is_true()
end)

test("a day begun anew is the same day", function()
  local scene, other = open_text(day), open_text(day)
  local dawn = scene:snapshot()
  scene:advance(1.1)
  scene:restore(dawn)
  scene:advance(1.1)
  other:advance(1.1)
  expect(told(scene)):equal(told(other))
end)
