-- A crane game for two hands: keys s and f (or the left stick) move the crane, up and down (or the right stick) its rope, and
-- space switches the magnet. Load the ship, before the load swings too far. Untouched, it plays by itself.
local boxes = scene:param("crates", 8, { min = 1, max = 12, step = 1, help = "on the quay" })

scene.title, scene.duration, scene.plane = "Crane", 60, "xy"
scene.camera = { at = vec(-0.7, 3.2, 13), look_at = vec(-0.7, 2.9, 0) }

local function wall(width, height, x, y, color) return shape.box(width, height, 2, { at = vec(x, y, 0), friction = 0.8, color = color }) end
scene:ground { shapes = { wall(7, 1, -3.9, -0.5, "#9a958c"), wall(4.8, 0.4, 2.6, -0.6, "#7a5a3a"), wall(0.2, 1.4, 0.3, -0.1, "#7a5a3a"),
                          wall(0.2, 1.4, 4.9, -0.1, "#7a5a3a"), shape.box(13, 0.15, 0.3, { at = vec(-0.7, 6.6, -1), color = "#e0a030" }) } }
scene:floor { height = -1, color = "#8fb8d0" }
local x, v, rope, steel, air = -1, 0, 2.5, "#c2413b", scene:family "air" -- m, m/s, m
local trolley = scene:particle { at = vec(x, 6.4, 0), mass = 100, radius = 0.2, color = steel }
local lead = scene:follow(trolley, trolley.position)
local magnet = scene:body { at = trolley.position - vec(0, rope + 0.3, 0), mass = 40, color = steel, name = "magnet",
  shapes = { shape.cylinder(0.35, 0.2), shape.cylinder(0.06, 0.3, { at = vec(0, 0.2, 0) }) },
  points = { eye = { at = vec(0, 0.3, 0), family = air } } }
scene:field(air, force.drag { linear = 40 })
local line, crates, colors = scene:string({ trolley, magnet.eye }, { length = rope }), {}, { "#3f6f9f", "#e8833a", "#6b8e5a", "#8a5a9e" }
for i = 1, boxes do
  crates[i] = scene:box { size = vec(0.8, 0.6, 0.8), mass = 30, friction = 0.6, color = colors[i % 4 + 1],
                          at = vec(-6.1 + 1.2 * ((i - 1) % 4), 0.3 + 0.6 * ((i - 1) // 4), 0) }
  crates[i].data.crate = true
end
local held, on, mine, along, up, aboard, keys, pad = nil, false, false, 0, 0, 0, scene.keys, scene.pad
local function switch()
  on, held = not on, held and held.alive and held:remove()
end
scene:on("key", "space", function() mine = true switch() end)
local function one(value) return math.max(-1, math.min(1, value)) end
scene:on("step", function(dt)
  local left, right = (keys.f and 1 or 0) - (keys.s and 1 or 0) + pad.left_x, (keys.up and 1 or 0) - (keys.down and 1 or 0) + pad.right_y
  if mine or left ~= 0 or right ~= 0 then mine, along, up = true, left, right end
  v = v + (3 * one(along) - v) * 3 * dt
  x, rope = math.max(-6.3, math.min(5, x + v * dt)), math.max(0.5, math.min(6.2, rope - 2 * one(up) * dt))
  lead.target, line.length = vec(x, 6.4, 0), rope
  for _, contact in ipairs(on and not held and magnet.contacts or {}) do -- the magnet holds the crate below it
    if not held and contact.normal.y > 0.7 and contact.with and contact.with.data.crate then held = scene:weld(magnet, contact.with) end
  end
  aboard = 0
  for _, crate in ipairs(crates) do if crate.alive and math.abs(crate.position.x - 2.6) < 2.2 then aboard = aboard + 1 end end
  scene.draw:text(vec(16, 60, 0), ("%d of %d aboard, %.0f s"):format(aboard, boxes, scene.time), { space = "screen", size = 20 })
end)
scene:play(function(wait)
  local function go(to_x, low) -- until the magnet's lower side is so low there, or somebody plays
    wait(function()
      local swing = magnet.position.x - x -- it goes after its load, which calms it
      along, up = 0.7 * one(to_x - x) + 0.3 * swing, 4 * (low + rope - 6)
      return mine or math.abs(to_x - x) + math.abs(low + rope - 6) + math.abs(swing) + 0.1 * math.abs(magnet.velocity.x) < 0.12
    end)
    wait(mine and 1e9 or 0)
  end
  for n = 0, boxes - 1 do
    local from, to = crates[boxes - n].position, vec(1.15 + 0.96 * (n % 4), 0.24 + 0.6 * (n // 4), 0)
    go(from.x, 2.6) go(from.x, from.y + 0.28) switch() wait(0.3)
    go(from.x, 2.6) go(to.x, 2.6) go(to.x, to.y) switch() wait(0.3) go(to.x, 2.6)
  end
end)
scene:probe("aboard", function() return aboard end)
