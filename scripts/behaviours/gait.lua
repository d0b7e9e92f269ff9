-- Swings motors to and fro, each with its own phase: legs that walk, arms that wave.
-- options: motors (list of { motor, swing = [rad], phase = part of a turn }), frequency ([1/s], 1)
local gait = {}

function gait:start()
  self.options.frequency = self.options.frequency or 1
  assert(type(self.options.motors) == "table", "gait: options.motors must be a list of { motor, swing, phase }")
end

function gait:step(dt)
  local turn = 2 * math.pi * self.options.frequency
  for _, m in ipairs(self.options.motors) do
    if m[1].alive then
      m[1].speed = (m.swing or 0.5) * turn * math.cos(turn * (scene.time + dt) + 2 * math.pi * (m.phase or 0))
    end
  end
end

function gait:stop()
  for _, m in ipairs(self.options.motors) do
    if m[1].alive then m[1].speed = 0 end
  end
end

return gait
