-- What a step costs is bounded, whatever contradicts what: counted in iterations, factorisations and projections, and three
-- for what each step does, the evaluation of its prediction and the two sweeps of its projection.

local random_scene = [[
  local state = seed * 7919 + 12345
  local function random(n)
    state = (state * 1103515245 + 12345) % 2147483648
    local x = state / 2147483648
    return n and 1 + math.floor(x * n) or x
  end
  local function some(s) return vec(random() - 0.5, random() - 0.5, random() - 0.5) * (2 * s) end
  if random() < 0.3 then scene.gravity = vec(0, 0, 0) end
  scene.step = random() < 0.5 and 1 / 60 or 1 / 240

  local bodies = {}
  local function bar(x)
    local b = scene:body { at = vec(x, 0, 0), mass = 0.5 + random(), spin = some(1),
                           inertia = vec(0.02, 0.1, 0.1), points = { a = vec(-0.5, 0, 0), b = vec(0.5, 0, 0) } }
    bodies[#bodies + 1] = b
    return b
  end
  local kind = random(3)
  if kind == 1 then  -- a chain that is dragged where it does not reach, and back
    local n, last = 3 + random(9), nil
    for i = 1, n do
      local b = bar(i - 0.5)
      if last then scene:hinge(last.b, b.a) else scene:nail(b.a) end
      last = b
    end
    local out, way = n + random() - 0.5, some(1)
    scene:follow(last.b, function(t)
      local part = math.sin(1.5 * t) ^ 2
      return vec(n + (out - n) * part, 0, 0) + way * part
    end)
  elseif kind == 2 then  -- a torus of hinges that is pulled apart
    local n, rings = 3 + random(3), 2 + random(3)
    local grid = {}
    for j = 1, rings do
      grid[j] = {}
      for i = 1, n do
        local u = 2 * math.pi * i / n
        local at = vec(math.cos(u), math.sin(u), 0.5 * j) * n / 3
        local b = scene:body { at = at, mass = 1, inertia = vec(0.05, 0.05, 0.05), points = {
          l = some(0.1), r = some(0.1), u = some(0.1), d = some(0.1) } }
        grid[j][i], bodies[#bodies + 1] = b, b
      end
    end
    scene.tolerance = 1000
    for j = 1, rings do
      for i = 1, n do
        scene:hinge(grid[j][i].r, grid[j][i % n + 1].l)
        scene:hinge(grid[j][i].u, grid[j % rings + 1][i].d)
      end
    end
    scene.tolerance = 1e-6
    scene:nail(grid[1][1].d)
    local from, way = grid[rings][1].l.position, some(3)
    scene:follow(grid[rings][1].l, function(t) return from + way * math.sin(2 * t) end)
  else  -- some bars and whatever ties them
    for i = 1, 2 + random(4) do bar(1.2 * i) end
  end
  if kind == 3 or random() < 0.5 then
    local function body() return bodies[random(#bodies)] end
    local function point(b) for _, p in ipairs(b.points) do if random() < 0.5 then return p end end return b.points[1] end
    local ties = {
      function() scene:nail(point(body()), some(2)) end,
      function() scene:follow(point(body()), function(t) return vec(math.cos(2 * t), math.sin(3 * t), 0) end) end,
      function() scene:rod(point(body()), point(body())).length = 0.2 + 3 * random() end,
      function() scene:orient(body(), quat(some(1), random())) end,
      function() scene:align(body(), some(1), body(), some(1), { angle = 2 * random() }) end,
      function() scene:motor(body(), body(), { axis = some(1), speed = 4 * random() }) end,
      function() scene:motor(body(), { axis = some(1), angle = random(), max_torque = 50 * random() }) end,
      function() scene:limit(body(), { axis = some(1), min = -0.1, max = 0.1 + random() }) end,
      function() scene:limit(point(body()), point(body()), { min = 0.5, max = 0.6 + random() }) end,
      function() scene:on_plane(point(body()), { normal = some(1), through = some(1) }) end,
      function() scene:on_path(point(body()), { some(1), some(1), some(2) }) end,
      function() scene:string({ point(body()), some(2), point(body()) }, { length = 1 + random() }) end,
      function() scene:weld(body(), body()) end,
      function() scene:gear(body(), body(), { ratio = -2, axis = some(1) }) end,
      function() scene:screw(point(body()), point(body()), { lead = 0.1, axis = some(1) }) end,
      function() scene:rack(body(), point(body()), { radius = 0.3, axis = some(1), along = some(1) }) end,
      function() scene:pulley(point(body()), some(2), some(2), point(body())) end,
      function() scene:join(point(body()), point(body()), { time_constant = 0.05 }) end,
      function() scene:slider(point(body()), body(), { axis = some(1), max = random() }) end,
    }
    for _ = 1, 2 + random(6) do pcall(ties[random(#ties)]) end
  end
]]

--- Median and worst cost of a step.
local function run(seed)
  local scene = open_text("local seed = " .. seed .. "\n" .. random_scene)
  local costs, before = {}, 0
  for i = 1, 120 do
    scene:step()
    local s = scene.stats
    local cost = s.newton_iterations + s.factorisations + s.projections + 3 * i
    costs[i], before = cost - before, cost
  end
  for _, body in ipairs(scene.bodies) do expect(body.position:length()):below(1e6) end
  table.sort(costs)
  return costs[60], costs[120]
end

test("a step that cannot be solved costs no more than some hundred iterations", function()
  for seed = 1, 60 do
    local median, worst = run(seed)
    expect(worst):below(math.max(10 * median, 400))
  end
end)
