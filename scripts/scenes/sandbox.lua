-- A floor, two walls and a few things: build with the tools below. 8 makes rods, balls, boxes and wheels; 3 ties them.
-- Space pauses, to build in peace; ctrl + shift + s saves what was built as a scene like this one.
local dimensions = scene:param("dimensions", 2, { choices = { 2, 3 },
  help = "2: all that is built stays in the plane of the picture; 3: it is built in space, and the right button turns the view" })
local space = dimensions == 3

scene.title = "Sandbox"
scene.duration = 60
if not space then scene.plane = "xy" end
scene.camera = { at = vec(0, 3.4, 15), look_at = vec(0, 2.4, 0) }
scene:floor { friction = 0.8, color = "#cfd8d3" }

local deep = space and 6 or 1
scene:ground {
  color = "#8d7a63",
  shapes = {
    shape.box(0.3, 3, deep, { at = vec(-7, 1.5, 0) }),
    shape.box(0.3, 3, deep, { at = vec(7, 1.5, 0) }),
    shape.polygon { points = { vec(2.5, 0, 0), vec(6.85, 0, 0), vec(6.85, 1.4, 0) }, thickness = deep },
  },
}

-- A seesaw with a heavy end, a stack to throw at, and two balls.
local plank = scene:box { size = vec(3, 0.12, 0.5), at = vec(-2.5, 0.56, 0), density = 600, friction = 0.8, color = "#b5854f",
                          points = { vec(0, 0, 0) } }
scene:nail(plank.points[1])
scene:box { size = 0.5, at = vec(-3.7, 0.88, 0), density = 400, color = "#c2413b" }
for i = 0, 5 do
  scene:box { size = vec(0.5, 0.4, 0.5), at = vec(1, 0.2 + 0.4 * i, 0), density = 500,
              color = ({ "#e8833a", "#f2b45c", "#2f78b7" })[i % 3 + 1] }
end
scene:ball { radius = 0.3, at = vec(-5.5, 0.3, 0), restitution = 0.6, color = "#3f6f9f" }
scene:ball { radius = 0.2, at = vec(5.8, 2, 0), restitution = 0.8, color = "#7a5a9e" }
