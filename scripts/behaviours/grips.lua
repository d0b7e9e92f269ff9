-- Grips that hold points and move apart along a line: a machine for tensile tests.
-- options: left, right (lists of points or particles), along (vec, (1, 0, 0)), way ([m] each side goes, 1), time ([s], 5),
--          max_force ([N] of each point, none: as hard as it takes)
local grips = {}

function grips:start()
  local o = self.options
  o.along, o.way, o.time = o.along or vec(1, 0, 0), o.way or 1, o.time or 5
  local begin, full = scene.time, o.along * (o.way / o.along:length())
  self.follows = {}
  for side, points in pairs { [-1] = o.left, [1] = o.right } do
    for _, point in ipairs(points) do
      local home = point.position
      self.follows[#self.follows + 1] = scene:follow(point, function(t)
        return home + side * math.min(1, (t - begin) / o.time) * full
      end, { max_force = o.max_force })
    end
  end
end

function grips:stop()
  for _, follow in ipairs(self.follows) do
    if follow.alive then follow:remove() end
  end
end

return grips
