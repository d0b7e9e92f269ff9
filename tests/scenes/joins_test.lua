local beside = [[
  scene.gravity, scene.step = vec(0, 0, 0), 1 / %d
  %s
  local a = scene:box { size = 0.4, at = vec(0, 0, 0), mass = 1, points = { o = vec(0.2, 0.2, 0) } }
  local b = scene:box { size = vec(0.4, 0.4, 0.6), at = vec(1, 0.6, 0.3), mass = 1, points = { o = vec(-0.2, 0, 0.1) } }
  scene:box { size = 0.4, at = vec(0.401, -0.1, 0.05), mass = 1 }
  scene:join(a.o, b.o)
]]

test("a join that draws two together beside what they touch turns nothing, and does no work but its own", function()
  for _, accuracy in ipairs { "", "scene.accuracy = 1e-4" } do
    for _, hz in ipairs { 60, 240 } do
      local scene = open_text(beside:format(hz, accuracy))
      for _ = 1, 20 do
        scene:advance(0.1)
        expect(scene.angular_momentum:length()):below(1e-10)
        expect(scene.momentum:length()):below(1e-12)
      end
      expect(scene.bodies[3].velocity:length()):above(0.01)
      expect(scene.error.worst_energy):below(2e-3)
    end
  end
end)

test("shapes count in the size of bodies whose points are at their centres: a hinge may be as wide as tolerance says", function()
  local function apart(gap, more)
    return "local a = scene:box { size = 1, points = { p = vec(0, 0, 0) } }\n" ..
      ("local b = scene:box { size = 1, at = vec(%g, 0, 0), points = { p = vec(0, 0, 0) } }\n"):format(gap) ..
      (more or "") .. "scene:hinge(a.p, b.p)"
  end
  expect(#open_text(apart(1e-7)).hinges):equal(1)
  expect(#open_text(apart(5e-3, "scene.tolerance = 1e-2 ")).hinges):equal(1)
  expect(function() open_text(apart(1e-6)) end):fails("at most 8.660254037844386e-07 m (scene.tolerance times the size of their bodies)")
  expect(function() open_text([[
    local box, zone = shape.box(1, 1, 1), shape.ball(100, { sensor = true })
    local a = scene:body { mass = 1, shapes = { box, zone }, points = { p = vec(0, 0, 0) } }
    local b = scene:body { mass = 1, shapes = { box }, at = vec(1e-5, 0, 0), points = { p = vec(0, 0, 0) } }
    scene:hinge(a.p, b.p)]]) end):fails("at most 8.660254037844386e-07 m")
end)
