-- Two layers of rigid bars, hinged where they cross: n + 1 bars each way, leaning by an angle from the x axis.
return function(n, length, lean, middle, color)
  local z = vec(0, 0, 1)
  local pitch = length / (2 * n * math.cos(lean))
  local function bars(turn, across)
    local layer = {}
    for i = 0, n do
      local bar = structure.rod { length = n * pitch, pieces = n }:rotate(turn)
      local at = middle + across:rotate(vec((i - n / 2) * pitch, 0, 0))
      layer[i] = scene:build(bar, { as = "rigid", mass_in = "edges", mass = 1 / n, at = at, color = color }).particles
    end
    return layer
  end
  local up, down = quat(z, lean), quat(z, -lean)
  local rising, falling, crossings = bars(up, down), bars(down, up), {}
  for i = 0, n do
    for j = 0, n do
      crossings[#crossings + 1] = scene:hinge(rising[i][j + 1], falling[j][i + 1])
    end
  end
  return crossings
end
