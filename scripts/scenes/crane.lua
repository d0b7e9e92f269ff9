-- A crane game for two hands: keys a and d (or the left stick) move the crane, up and down (or the right stick) its rope, and
-- space (or a of the gamepad) switches the magnet. Load the ship, before the load swings too far. Untouched, it plays by itself.
local boxes = scene:param("crates", 8, { min = 1, max = 12, step = 1, help = "on the quay" })
scene.title, scene.duration, scene.plane, scene.contact_sounds = "Crane", 60, "xy", true
scene.camera = { at = vec(-0.5, 3, 14), look_at = vec(-0.5, 2.9, 0) }

-- Quay and ship, and what the crane runs on.
local function wall(width, height, x, y, color) return shape.box(width, height, 2, { at = vec(x, y, 0), friction = 0.8, color = color }) end
scene:ground { shapes = { wall(7, 1, -3.9, -0.5, "#9a958c"), wall(4.8, 0.4, 2.6, -0.6, "#7a5a3a"), wall(0.2, 1.4, 0.3, -0.1, "#7a5a3a"),
                          wall(0.2, 1.4, 4.9, -0.1, "#7a5a3a"), shape.box(13, 0.15, 0.3, { at = vec(-0.5, 6.6, -1), color = "#e0a030" }) } }
scene:floor { height = -1, color = "#8fb8d0" }

local x, v, rope, steel, air = -1, 0, 2.5, "#c2413b", scene:family "air"
local trolley = scene:particle { at = vec(x, 6.4, 0), mass = 100, radius = 0.2, color = steel }
local lead = scene:follow(trolley, trolley.position)
scene:field(air, force.drag { linear = 200 }) -- N s/m: it hangs quietly
local magnet = scene:body { at = trolley.position - vec(0, rope + 0.3, 0), mass = 40, color = steel, name = "magnet",
  shapes = { shape.cylinder(0.35, 0.2), shape.cylinder(0.06, 0.3, { at = vec(0, 0.2, 0) }) },
  points = { eye = { at = vec(0, 0.3, 0), family = air } } }
local line = scene:string({ trolley, magnet.eye }, { length = rope })
local crates, colors = {}, { "#3f6f9f", "#e8833a", "#6b8e5a", "#8a5a9e" }
for i = 1, boxes do
  crates[i] = scene:box { size = vec(0.8, 0.6, 0.8), mass = 30, friction = 0.6, color = colors[i % 4 + 1],
                          at = vec(-6.1 + 1.2 * ((i - 1) % 4), 0.3 + 0.6 * ((i - 1) // 4), 0) }
  crates[i].data.crate = true
end
local held, on, mine, along, up = nil, false, false, 0, 0
local function switch()
  on = not on
  if held and held.alive then held:remove() end
  held = nil
end
local function hold() -- the crate below it
  for _, contact in ipairs(held and {} or magnet.contacts) do
    if contact.normal.y > 0.7 and contact.with and contact.with.data.crate then
      held = scene:weld(magnet, contact.with)
      return
    end
  end
end
local function within(value, least, most) return math.max(least, math.min(most, value)) end
local keys, pad = scene.keys, scene.pad
local function played() return (keys.d and 1 or 0) - (keys.a and 1 or 0) + pad.left_x, (keys.up and 1 or 0) - (keys.down and 1 or 0) + pad.right_y end
scene:on("key", "space", function() mine = true switch() end)
scene:on("step", function(dt)
  local left, right = played()
  mine = mine or left ~= 0 or right ~= 0
  if mine then along, up = left, right end
  v = v + (3 * within(along, -1, 1) - v) * 3 * dt
  x, rope = within(x + v * dt, -6.3, 5), within(rope - 2 * within(up, -1, 1) * dt, 0.5, 6.2)
  lead.target, line.length = vec(x, 6.4, 0), rope
  if on then hold() end
end)
scene:play(function(wait)
  local function go(to_x, low) -- until the magnet's lower side is there, or somebody plays
    wait(function()
      local far, deep = to_x - x, low - (6 - rope)
      along, up = 3 * far - 0.5 * v, 4 * deep
      return mine or math.abs(far) + math.abs(deep) < 0.02
    end)
    if mine then wait(math.huge) end
    wait(0.5)
  end
  for i = boxes, 1, -1 do
    local from, n = crates[i].position, boxes - i
    local to = vec(1 + ((n % 4) * 1.1), 0.6 * (n // 4) + 0.2, 0)
    go(from.x, 3.2) wait(1)
    go(from.x, from.y + 0.28) switch() wait(0.3)
    go(from.x, 3.2) go(to.x, 3.2) wait(1.5)
    go(to.x, to.y + 0.02) switch() wait(0.3)
    go(to.x, 3.2)
  end
end)
local function aboard()
  local n = 0
  for _, crate in ipairs(crates) do if crate.alive and crate.position.x > 0.4 and crate.position.x < 4.8 then n = n + 1 end end
  return n
end
scene:probe("aboard", aboard)
scene:on("step", function()
  scene.draw:text(vec(16, 60, 0), ("%d of %d aboard, %.0f s%s"):format(aboard(), #crates, scene.time, mine and "" or "\na d, up down, space: you play"),
    { space = "screen", size = 20 })
end)
