-- Pulls strings in turn, as the bars of a puppet's cross do: each gets shorter and longer again.
-- options: strings (list of strings), lift ([m], 0.2), tempo ([1/s], 1), phases (list, parts of a turn; evenly spread)
local puppeteer = {}

function puppeteer:start()
  local o = self.options
  assert(type(o.strings) == "table" and #o.strings > 0, "puppeteer: options.strings must be a list of strings")
  o.lift, o.tempo, o.phases = o.lift or 0.2, o.tempo or 1, o.phases or {}
  self.lengths = {}
  for i, s in ipairs(o.strings) do
    self.lengths[i] = s.length
    o.phases[i] = o.phases[i] or (i - 1) / #o.strings
  end
end

function puppeteer:step()
  local o = self.options
  for i, s in ipairs(o.strings) do
    local pull = math.max(0, math.sin(2 * math.pi * (o.tempo * scene.time + o.phases[i])))
    if s.alive then s.length = self.lengths[i] - o.lift * pull ^ 2 end
  end
end

function puppeteer:stop()
  for i, s in ipairs(self.options.strings) do
    if s.alive then s.length = self.lengths[i] end
  end
end

return puppeteer
