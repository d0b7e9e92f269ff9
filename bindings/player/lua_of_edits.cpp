#include "player/lua_of_edits.hpp"

#include <set>

#include "measure/measure.hpp"
#include "measure/query.hpp"
#include "player/lua_of_body.hpp"

namespace pantin::player {
namespace {

class WriterOfEdits {
 public:
  WriterOfEdits(const World& now, const World& opened, LuaNames& names) : now_(now), opened_(opened), names_(names) {}

  LuaOfEdits write() {
    write_gone();
    write_moved();
    return std::move(out_);
  }

 private:
  void line(std::string text_of_line) { out_.lines.push_back(std::move(text_of_line)); }

  void write_gone() {
    const auto gone = [](const auto& store, const auto& before, auto id) {
      return !store.alive(id) || store[id].serial != before[id].serial;
    };
    for (const BodyId id : opened_.bodies.ids())
      if (gone(now_.bodies, opened_.bodies, id)) line(names_.of_script(id) + ":remove()");
    for (const ParticleId id : particles(opened_))
      if (is_loose(id) && gone(now_.particles, opened_.particles, id))
        line(names_.of_script("particles", id) + ":remove()");
    for (const ParticleId id : hinges(opened_))
      if (gone(now_.particles, opened_.particles, id) && hinge_is_cut(id))
        line(names_.of_script("hinges", id) + ":cut()");
    for (const ConnectionId id : opened_.connections.ids())
      if (gone(now_.connections, opened_.connections, id) && ends_live(id))
        line(names_.of_script("connections", id) + ":remove()");
    for (const ConstraintId id : opened_.constraints.ids())
      if (gone(now_.constraints, opened_.constraints, id) && ties_what_lives(id))
        write_gone_constraint(opened_.constraints[id], describe(opened_, id));
  }

  /// It does not go with a body.
  bool is_loose(ParticleId id) const {
    const Particle& particle = opened_.particles[id];
    return !particle.is_hinge() && !opened_.points[particle.points[0]].body;
  }
  bool hinge_is_cut(ParticleId ring) const {
    std::set<ParticleId> now;
    for (const PointId point : opened_.particles[ring].points) {
      if (!now_.points.alive(point)) continue;
      if (!now.insert(now_.points[point].particle).second) return false;  // some of it are in another hinge together
    }
    return now.size() > 1;
  }
  bool ends_live(ConnectionId id) const {
    const Connection& tie = opened_.connections[id];
    for (std::uint32_t i = 0; i < tie.count; i++)
      if (tie.particles[i] && !now_.particles.alive(tie.particles[i])) return false;
    return true;
  }
  bool ties_what_lives(ConstraintId id) const {
    bool live = opened_.constraints[id].kind != ConstraintKind::axis;
    opened_.constraints[id].each_point([&](PointId p) { live = live && now_.points.alive(p); });
    opened_.constraints[id].each_body([&](BodyId b) { live = live && now_.bodies.alive(b); });
    return live;
  }
  void write_gone_constraint(const Constraint& c, const std::string& who) {
    if (c.name.empty())
      out_.left_out.push_back(text(who, " of the script, which is gone here, and has no name to be found by"));
    else
      line(text("scene:find ", quoted(c.name), ":remove()"));
  }

  /// What of the script's things is elsewhere, or moves in another way.
  void write_moved() {
    for (const BodyId id : opened_.bodies.ids()) {
      if (!now_.bodies.alive(id) || now_.bodies[id].serial != opened_.bodies[id].serial) continue;
      for (const std::string& change : changes_of_body(now_, opened_, id)) line(names_.of_script(id) + "." + change);
    }
    for (const ParticleId id : particles(opened_)) {
      if (!now_.particles.alive(id) || now_.particles[id].serial != opened_.particles[id].serial) continue;
      const PointId point = now_.particles[id].points[0], before = opened_.particles[id].points[0];
      if (now_.points[point].body || opened_.points[before].body) continue;
      const FreeMotion &m = now_.motion_of(point), &was = opened_.motion_of(before);
      if (!same(m.x, was.x)) line(names_.of_script("particles", id) + ".position = " + lua_of(m.x));
      if (!same(m.v, was.v)) line(names_.of_script("particles", id) + ".velocity = " + lua_of(m.v));
    }
  }

  const World& now_;
  const World& opened_;
  LuaNames& names_;
  LuaOfEdits out_;
};

}  // namespace

LuaOfEdits lua_of_edits(const World& now, const World& opened, LuaNames& names) {
  return WriterOfEdits(now, opened, names).write();
}

}  // namespace pantin::player
