#include "lua/thing/constraint_options.hpp"
#include "lua/thing/script.hpp"
#include "lua/thing/targets.hpp"
#include "lua/vm/guard.hpp"

namespace pantin::lua {
namespace {

int scene_on_plane(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "on_plane");
  Constraint c;
  c.kind = ConstraintKind::on_plane;
  c.a = check_point(state, 2, "on_plane", argument(1));
  const Options o = tie_options(state, 3, "on_plane", {"through", "normal", "time_constant"});
  c.position.now = o.vector("through", "m").value_or(position(self.world, c.a));
  c.axis_a = o.vector("normal", "").value_or(vec(0, 1, 0));
  read_time_constant(o, c);
  return finish(self, add_constraint(self.world, std::move(c)), o);
}

}  // namespace

const ConstraintCall on_plane_call = {
    {"on_plane", guard<scene_on_plane>, "point: Point|Particle, options?: PlaneOptions", "OnPlane",
     "Keeps a point on a plane.", "scene:on_plane(p, { through = vec(0, 1, 0), normal = vec(0, 1, 0) })"},
    "a point to a plane or to a path",
    R"(---@class PlaneOptions: OrientOptions
---@field through? vec [m] a position on the plane (default where the point is)
---@field normal? vec [1] across the plane, world axes (default `vec(0, 1, 0)`)
)"};

}  // namespace pantin::lua
