-- Heats a group with a power, until it is as hot as it should be.
-- options: power ([W], 1; negative cools), temperature ([K], where it stops; none: never)
local heater = {}

-- J: of the target, relative to its common motion.
local function motion(things)
  local e = things.energy.kinetic - things.momentum:dot(things.momentum) / (2 * things.mass)
  return math.max(e, 0)
end

function heater:start() self.options.power = self.options.power or 1 end

function heater:step(dt)
  local o, now = self.options, self.target.temperature
  if o.temperature and (o.power > 0) == (now >= o.temperature) then return end
  if o.power > 0 or now > 0 then self.target:heat(math.max(o.power * dt, -motion(self.target))) end
end

return heater
