-- Grips that draw the ends of a flat sheet apart along x and let them come back, and a probe of its Poisson's ratio.

-- The particle farthest along a direction, near the middle if there are several.
local function farthest(particles, along, middle)
  local best, most
  for _, p in ipairs(particles) do
    local d = p.position - middle
    local score = d:dot(along) - 0.01 * (d - vec(0.01, 0.01, 0)):length()
    if not most or score > most then best, most = p, score end
  end
  return best
end

-- `most` is the largest strain. The probe is - (strain across) / (strain along).
return function(name, particles, middle, most)
  local left, right = farthest(particles, vec(-1, 0, 0), middle), farthest(particles, vec(1, 0, 0), middle)
  local low, high = farthest(particles, vec(0, -1, 0), middle), farthest(particles, vec(0, 1, 0), middle)
  local width, height = right.position.x - left.position.x, high.position.y - low.position.y
  local function grip(p, way)
    local start = p.position
    scene:follow(p, function(t) return start + vec(way * (1 - math.cos(t)) / 2, 0, 0) end)
  end
  grip(left, -width * most / 2)
  grip(right, width * most / 2)
  local function whole() return left.alive and right.alive and low.alive and high.alive end
  local function along() return whole() and (right.position.x - left.position.x) / width - 1 or 0 end
  local function across() return (high.position.y - low.position.y) / height - 1 end
  scene:probe(name, function() return along() > 1e-6 and -across() / along() or 0 end)
  scene:probe(name .. " strain", along)
end
