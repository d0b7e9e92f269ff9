-- A tippe top: a ball whose centre of mass lies below its middle, with a peg above. Spun fast it turns over onto its peg; without
-- friction it never does. What turns it is the patch on which it rubs: the spin about its normal takes the edge off friction, so
-- that slip neither sticks nor ends (Contensou 1963, Zhuravlev 1998). At a point Coulomb's friction would stop the slip for
-- good, and the top would never turn over; with the patch at 0 it does so only in steps as long as these, not at 1/16000 s.
local rate = scene:param("spin", 240, { min = 0, max = 400, help = "about its peg at the start, rad/s" })
local friction = scene:param("friction", 0.3, { min = 0, max = 1.5, help = "of top and table" })

local patch = scene:param("patch", 0.5, { min = 0, max = 3, help = "radius on which the top rubs, mm; 0: a point" }) / 1000

scene.title = "Tippe top"
scene.duration = 12
scene.step = 1 / 1000
scene:floor { friction = patch > 0 and 0 or friction, size = 8, color = "#cbb894" }

-- A wooden ball of 2 cm, hollowed out: what is left of it has its centre of mass 3 mm below its middle.
local radius, below = 0.02, 0.003
local mass = 0.02
local lean = quat(vec(0, 0, 1), 0.1)
local axis = lean:rotate(vec(0, 1, 0))
local top = scene:body {
  points = { { at = vec(0, 0, 0), mass = mass } }, inertia = vec(1, 1.05, 1) * (0.4 * mass * radius ^ 2),
  shapes = {
    shape.ball { radius = radius, at = vec(0, below, 0), friction = friction, color = "#c2413b" },
    shape.capsule { radius = 0.005, from = vec(0, below + 0.6 * radius, 0), to = vec(0, below + 1.05 * radius, 0),
                    friction = friction, color = "#f2b45c" },
  },
  orientation = lean, at = vec(0, radius, 0) - axis * below, spin = axis * rate, name = "top",
}

scene.camera = { at = vec(0.05, 0.07, 0.13), look_at = vec(0, 0.022, 0), follow = top }

-- Friction of a patch that slides at v and spins at w about its normal is friction × N × v / (|v| + 8/(3π) patch |w|).
scene:on("step", function()
  for _, contact in ipairs(patch > 0 and top.contacts or {}) do
    local slip, load = contact.slip, contact.force:length()
    local speed = slip:length() + 8 / (3 * math.pi) * patch * math.abs(top.spin.y)
    if speed > 0 then top:kick(slip * (-friction * load * scene.step / speed), contact.at) end
  end
end)

local function leaning() return math.acos(math.max(-1, math.min(1, top.orientation:rotate(vec(0, 1, 0)).y))) end
scene:probe("lean", leaning)
scene:probe("spin about the vertical", function() return top.spin.y end)
scene:probe("height", function() return top.position.y end)
local function start()
  top.position, top.orientation = vec(0, radius, 0) - axis * below, lean
  top.velocity, top.spin = vec(0, 0, 0), axis * rate
end
scene:every(12, start)
scene:button("spin it again", start)
scene:when(function() return leaning() > 2.8 end, function() scene:result("turned over after", scene.time) end)
