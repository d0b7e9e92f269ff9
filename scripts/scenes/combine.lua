-- Two sticks are drawn to the point P and make a hinge when they meet there; then they are pulled apart until it breaks, and
-- meet again. What happens is told above.
local pull = scene:param("pull", 60, { min = 5, max = 500, help = "force that pulls them apart, N" })
local strength = scene:param("strength", 30, { min = 1, max = 1000, help = "force at which the hinge breaks, N" })

scene.title, scene.duration = "Combine", 24
scene.gravity = vec(0, 0, 0)
scene.camera = { at = vec(1, 2.8, 7.5), look_at = vec(0, 1.9, 0) }

local P = vec(0, 2, 0)
local function stick(name, at, color, spin)
  return scene:body {
    name = name, at = at, spin = spin, velocity = vec(0, 0.2, 0),
    points = {
      { at = vec(0, 0.25, 0), mass = 0.5, color = color }, { at = vec(0, -0.25, 0), mass = 0.5, color = color },
      tip = { at = vec(0.8, 0, 0), mass = 0.5, color = color }, far = { at = vec(-0.8, 0, 0), mass = 0.5, color = color },
    },
  }
end
local a = stick("a", vec(-2.2, 1.2, 0), "#d8573c", vec(0, 0, 0.6))
local b = stick("b", vec(2.2, 2.6, 0.4), "#2f78b7", vec(0.3, 0.4, -0.5))
scene:particle { at = P, radius = 0.05, color = "#f0c05a", name = "P" }
-- The air slows them, so that they stay in the picture.
scene:field(scene, force.drag { linear = 0.15 })

local meetings, partings, says = 0, 0, ""
scene:play(function(wait)
  while true do
    local hinge
    says = "Their tips are drawn to P"
    scene:join(a.tip, b.tip, {
      at = P, time_constant = 0.1,
      on_met = function(met)
        hinge, meetings = met, meetings + 1
        met.breaks_at = { force = strength }
      end,
    })
    wait(function() return hinge end)
    says = "They have met: one hinge is made of two tips"
    wait(2.5)
    says = ("They are pulled apart by %.0f N; the hinge bears %.0f N"):format(pull, strength)
    local grips = {
      scene:follow(a.far, P - vec(2.8, 0, 0), { max_force = pull, time_constant = 0.3 }),
      scene:follow(b.far, P + vec(2.8, 0, 0), { max_force = pull, time_constant = 0.3 }),
    }
    wait(function() return not hinge.alive end)
    partings = partings + 1
    says = "It is broken"
    wait(1.5)
    for _, grip in ipairs(grips) do grip:remove() end
  end
end)
scene:on("step", function()
  scene.draw:text(vec(20, 20, 0), ("%s\n%d meetings, %d partings"):format(says, meetings, partings), { space = "screen", size = 20 })
end)

scene:probe("distance of the tips", function() return a.alive and b.alive and (a.tip.position - b.tip.position):length() or 0 end)
scene:probe("meetings", function() return meetings end)
scene:probe("partings", function() return partings end)
