-- Heats a group with a power, until it is as hot as it should be.
-- options: power ([W], 1; negative cools), temperature ([K], where it stops; none: never)
local heater = {}

function heater:start() self.options.power = self.options.power or 1 end

function heater:step(dt)
  local o, now = self.options, self.target.temperature
  if o.temperature and (o.power > 0) == (now >= o.temperature) then return end
  if o.power < 0 and now <= 0 then return end
  self.target:heat(o.power * dt)
end

return heater
