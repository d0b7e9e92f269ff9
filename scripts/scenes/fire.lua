-- A camp fire: hot gas rises, cools and thins to smoke, and embers fly on the wind. Blow at it with the slider.
local heat = scene:param("heat", 1, { min = 0.3, max = 2, help = "how fiercely it burns" })
local breeze = scene:param("wind", 0.25, { min = -2, max = 2, help = "wind from the left, m/s" })

scene.title, scene.duration, scene.dark = "Fire", 10, true
scene.step = 1 / 120
scene.gravity = vec(0, 0, 0) -- the law below says what rises and what falls
scene.camera = { at = vec(0.4, 1.2, 4.2), look_at = vec(0.1, 0.95, 0) }

-- Logs, leaning together.
for i = 0, 4 do
  local angle = 2 * math.pi * i / 5 + 0.3
  local foot = vec(0.55 * math.cos(angle), 0.06, 0.55 * math.sin(angle))
  scene:body {
    points = { { at = foot, mass = 2, radius = 0.06 }, { at = vec(0, 0.42, 0) - 0.12 * foot, mass = 2, radius = 0.06 } },
    color = "#5a4030",
  }
end

local flame = scene:family("flame", { mass = 1e-3, look = "glow", attributes = { lift = 2.2 },
  radius = function(age, life)
    local u = age / life
    return 0.05 + 0.5 * u * (1 - u) ^ 2
  end,
  color = function(age, life) -- pale yellow, orange, dark red
    local u = age / life
    return { 1, 0.85 * (1 - u) ^ 1.2, 0.4 * (1 - u) ^ 5, 0.55 * (1 - u) }
  end })
local smoke = scene:family("smoke", { mass = 1e-3, look = "glow", attributes = { lift = 1.1 },
  radius = function(age, life) return 0.1 + 0.35 * age / life end,
  color = function(age, life)
    local u = age / life
    return { 0.42, 0.4, 0.38, 0.5 * u * (1 - u) ^ 2 }
  end })
local ember = scene:family("ember", { mass = 1e-3, look = "streak", radius = 0.008, attributes = { lift = 1.7 },
  color = function(age, life) return { 1, 0.45 - 0.25 * age / life, 0.05, 1 - (age / life) ^ 3 } end })

-- The air carries them: up where it is hot, inwards at the foot, in eddies that rise with it.
local air = force.point {
  parameters = { rate = 5, wind = breeze }, -- 1/s, m/s
  force = function(p, own, t)
    local x, y, z = p.position.x, p.position.y, p.position.z
    local eddy = vec(math.sin(4 * y - 7 * t + 3 * z), 0, math.sin(5 * y - 6 * t + 2 * x + 1))
    local draught = vec(-x, 0, -z) * (1.6 * math.exp(-2 * y))
    local wind = vec(own.wind * y, p.lift, 0) + draught + eddy * (0.25 + 0.25 * y)
    return p.mass * own.rate * (wind - p.velocity)
  end,
}
for _, family in ipairs { flame, smoke, ember } do scene:field(family, air) end

local hearth = { vec(-0.25, 0.08, -0.25), vec(0.25, 0.12, 0.25) }
scene:emitter { family = flame, at = hearth, rate = 900 * heat, velocity = vec(0, 0.8, 0), spread = 0.6,
  lifetime = { min = 0.4, max = 0.7 + 0.5 * heat } }
scene:emitter { family = smoke, at = { vec(-0.15, 1, -0.15), vec(0.15, 1.3, 0.15) }, rate = 50, velocity = vec(0, 1, 0),
  spread = 0.5, lifetime = { min = 1.5, max = 3 } }
local sparks = scene:emitter { family = ember, at = hearth, velocity = vec(0, 2.5, 0), spread = 0.9,
  rate = function(t) return heat * (10 + 60 * math.max(0, math.sin(2.1 * t)) ^ 8) end, lifetime = { min = 0.5, max = 2 } }
scene:probe("embers", function() return sparks.count end)
