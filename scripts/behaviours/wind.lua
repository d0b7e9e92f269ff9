-- Wind on a particle, a body or the members of a group: a drag towards the speed of the air, with gusts.
-- options: velocity (vec [m/s]), drag ([kg/s], 0.1), gusts (0 … 1, part of the speed that comes and goes, 0), period ([s], 3)
local wind = {}

function wind:start()
  local o = self.options
  o.velocity, o.drag, o.gusts, o.period = o.velocity or vec(1, 0, 0), o.drag or 0.1, o.gusts or 0, o.period or 3
end

local function has(thing, field)
  local known, value = pcall(function() return thing[field] end)
  return known and value
end

-- A group's bodies and its particles of no body; what ties them feels no wind.
local function blow(thing, air, drag)
  if has(thing, "each") then
    for member in thing:each() do blow(member, air, drag) end
  elseif has(thing, "push") and #(has(thing, "bodies") or {}) == 0 then
    thing:push(drag * (air - thing.velocity))
  end
end

function wind:step()
  local o = self.options
  local gust = 1 + o.gusts * math.sin(2 * math.pi * scene.time / o.period)
  blow(self.target, gust * o.velocity, o.drag)
end

return wind
