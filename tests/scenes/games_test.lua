-- The games of examples/games, played by held keys.
local games = "../../examples/games/"

test("pinball: the ball is shot, and a flipper strikes it up again", function()
  local game = open(games .. "pinball.lua")
  local ball = game:find("ball")
  game:advance(0.5)
  expect(ball.position.y):below(0.6)
  game:hold("space")
  game:advance(0.8)
  game:release("space")
  game:advance(1.2)
  expect(ball.position.x):below(2.4)
  -- Put where the left flipper is, it is thrown to the upper half.
  ball.position, ball.velocity, ball.spin = vec(-0.95, 2.1, 0), vec(0, 0, 0), vec(0, 0, 0)
  game:advance(0.3)
  game:hold("left")
  local highest = 0
  for _ = 1, 480 do
    game:step()
    highest = math.max(highest, ball.position.y)
  end
  expect(highest):above(4)
end)

test("hill climb: gas drives over hills, and no key leaves the car where it is", function()
  local idle, game = open(games .. "hill_climb.lua"), open(games .. "hill_climb.lua")
  idle:advance(3)
  expect(idle:find("car").position.x):near(0, 0.5)
  game:hold("right")
  game:advance(8)
  expect(game:read("far")):above(15)
  expect(game:read("fuel")):below(1)
end)

test("lander: up lifts, and burns fuel; without it the ship falls", function()
  local falls, game = open(games .. "lander.lua"), open(games .. "lander.lua")
  game:hold("up")
  falls:advance(2) game:advance(2)
  expect(falls:read("height")):below(16)
  expect(game:read("height")):above(20)
  expect(game:read("fuel")):below(falls:read("fuel"))
  falls:advance(1)
  expect(falls.next):equal(nil)
  falls:advance(7)
  expect(falls.next:match("lander.lua$")):equal("lander.lua")
end)
