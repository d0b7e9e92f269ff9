-- A truss bridge along x with its road at y = 0: two trusses of `bays` bays, 1 m each, from supports at -bays / 2 to
-- bays / 2, braced against each other, and over each bay a plate on hinges. Returns the plates.
return function(bays, joints, bar, plate)
  local function bars(...)
    for _, ends in ipairs { ... } do
      if ends[1] and ends[2] then bar(ends[1], ends[2]) end
    end
  end
  local function truss(z)
    local road, deep = {}, {}
    for i = 0, bays do
      road[i] = scene:particle { at = vec(i - bays / 2, -0.06, z), family = joints }
      if i > 0 and i < bays then deep[i] = scene:particle { at = vec(i - bays / 2, -1.1, z), family = joints } end
    end
    for i = 1, bays do
      local slant = 2 * i <= bays and { road[i - 1], deep[i] } or { deep[i - 1], road[i] }
      bars({ road[i], deep[i] }, { deep[i - 1], deep[i] }, slant)
    end
    scene:nail(road[0])
    scene:on_plane(road[bays], { normal = vec(0, 1, 0) }) -- it may slide, as on rollers
    return road, deep
  end
  local near_road, near = truss(-0.75)
  local far_road, far = truss(0.75)
  local plates = {}
  for i = 1, bays do
    bars({ near_road[i], far[i] }, { far_road[i], near[i] }, { near[i], far[i] }, { near[i - 1], far[i] }, { far[i - 1], near[i] })
    local made = plate(vec(i - (bays + 1) / 2, -0.06, 0))
    for n, joint in ipairs { near_road[i - 1], near_road[i], far_road[i - 1], far_road[i] } do scene:hinge(joint, made.points[n]) end
    plates[i] = made
  end
  return plates
end
