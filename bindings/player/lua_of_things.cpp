#include "player/lua_of_things.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "base/shortened.hpp"
#include "constraints/kind.hpp"
#include "fields/color.hpp"
#include "laws/law.hpp"
#include "measure/measure.hpp"
#include "measure/query.hpp"
#include "player/lua_of_body.hpp"

namespace pantin::player {
namespace {

constexpr std::size_t most_locals = 100;  // of a script's 200

/// Those that were made since, in their order.
template <class Store, class Id>
void by_serial(const Store& store, std::uint64_t first, std::map<std::uint64_t, AnyId>& order, Id) {
  for (const Id id : store.ids())
    if (store[id].serial >= first) order[store[id].serial] = id;
}

class Writer {
 public:
  Writer(const World& now, const World& opened) : now_(now), opened_(opened), first_(opened.next_serial) {
    const auto number = [&](const auto& ids) {
      for (std::size_t i = 0; i < ids.size(); i++) numbers_[ids[i]] = i + 1;
    };
    number(opened.bodies.ids());
    number(particles(opened));
    number(hinges(opened));
    number(opened.connections.ids());
  }

  LuaOfThings write() {
    find_order();
    count_uses();
    write_gone();
    write_moved();
    for (std::size_t i = 0; i < order_.size();) i = write_from(i);
    if (!lines_.empty()) finish();
    return std::move(out_);
  }

 private:
  void line(const std::string& text_of_line) { lines_ += "  " + text_of_line + "\n"; }
  void leave_out(const AnyId& thing, const std::string& why) {
    out_.left_out.push_back(text(describe(now_, thing), " ", why));
  }
  bool made_since(BodyId body) const { return now_.bodies[body].serial >= first_; }

  void find_order() {
    std::map<std::uint64_t, AnyId> order;
    by_serial(now_.bodies, first_, order, BodyId{});
    by_serial(now_.constraints, first_, order, ConstraintId{});
    by_serial(now_.connections, first_, order, ConnectionId{});
    by_serial(now_.interactions, first_, order, InteractionId{});
    by_serial(now_.fields, first_, order, FieldId{});
    by_serial(now_.families, first_, order, FamilyId{});
    by_serial(now_.emitters, first_, order, EmitterId{});
    for (const ParticleId id : now_.particles.ids())
      if (now_.particles[id].is_hinge() && now_.particles[id].serial >= first_) order[now_.particles[id].serial] = id;
    for (const PointId id : now_.points.ids()) {
      const Point& point = now_.points[id];
      const bool in_maker = point.body && made_since(point.body) && is_made_with(now_, id);
      if (point.serial >= first_ && !in_maker && !is_grip(id)) order[point.serial] = id;
    }
    for (const ShapeId id : now_.shapes.ids()) {
      const Shape& shape = now_.shapes[id];
      if (shape.serial >= first_ && !(shape.body && made_since(shape.body))) order[shape.serial] = id;
    }
    for (const auto& [serial, id] : order) order_.push_back(id);
  }

  /// A point that is there only as long as a hand holds it.
  bool is_grip(PointId id) const {
    const Point& point = now_.points[id];
    return point.body && point.constraints.size() == 1 && now_.constraints[point.constraints[0]].hand >= 0 &&
           !now_.particles[point.particle].is_hinge();
  }

  void count_uses() {
    const auto use = [&](PointId id) {
      if (!now_.points.alive(id)) return;
      uses_[id]++;
      if (const BodyId body = now_.points[id].body) used_.insert(AnyId(body));
      if (!now_.points[id].body) used_.insert(AnyId(id));
    };
    for (const AnyId& thing : order_) {
      if (const auto* point = std::get_if<PointId>(&thing); point && now_.points[*point].body)
        used_.insert(AnyId(now_.points[*point].body));
      if (const auto* ring = std::get_if<ParticleId>(&thing))
        for (const PointId point : now_.particles[*ring].points) use(point);
      if (const auto* tie = std::get_if<ConstraintId>(&thing)) {
        const Constraint& c = now_.constraints[*tie];
        if (c.hand >= 0) continue;
        c.each_point(use);
        c.each_body([&](BodyId body) { used_.insert(AnyId(body)); });
      }
      if (const auto* tie = std::get_if<ConnectionId>(&thing))
        for (std::uint32_t i = 0; i < now_.connections[*tie].count; i++)
          if (const ParticleId end = now_.connections[*tie].particles[i]) use(now_.particles[end].points[0]);
    }
  }

  // What the script made.

  /// How one of the script's bodies, particles, hinges or connections is found again.
  std::string of_script(const char* list, const AnyId& id) {
    lists_.insert(list);
    return text(list, "[", numbers_.at(id), "]");
  }
  std::string body_of_script(BodyId id) { return of_script("bodies", id); }

  void write_gone() {
    for (const BodyId id : opened_.bodies.ids())
      if (!now_.bodies.alive(id) || now_.bodies[id].serial != opened_.bodies[id].serial)
        line(body_of_script(id) + ":remove()");
    for (const ParticleId id : particles(opened_))
      if (!now_.particles.alive(id) || now_.particles[id].serial != opened_.particles[id].serial)
        line(of_script("particles", id) + ":remove()");
    const auto gone = [&](const auto& store, const auto& before, auto id) {
      return !store.alive(id) || store[id].serial != before[id].serial;
    };
    for (const ParticleId id : hinges(opened_))
      if (gone(now_.particles, opened_.particles, id) && hinge_is_cut(id)) line(of_script("hinges", id) + ":cut()");
    for (const ConnectionId id : opened_.connections.ids())
      if (gone(now_.connections, opened_.connections, id) && ends_live(id))
        line(of_script("connections", id) + ":remove()");
    for (const ConstraintId id : opened_.constraints.ids())
      if (gone(now_.constraints, opened_.constraints, id) && ties_what_lives(id))
        write_gone_constraint(opened_.constraints[id], describe(opened_, id));
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
      for (const std::string& change : changes_of_body(now_, opened_, id)) line(body_of_script(id) + "." + change);
    }
    for (const ParticleId id : particles(opened_)) {
      if (!now_.particles.alive(id) || now_.particles[id].serial != opened_.particles[id].serial) continue;
      const PointId point = now_.particles[id].points[0], before = opened_.particles[id].points[0];
      if (now_.points[point].body || opened_.points[before].body) continue;
      const FreeMotion &m = now_.motion_of(point), &was = opened_.motion_of(before);
      if (!same(m.x, was.x)) line(of_script("particles", id) + ".position = " + lua_of(m.x));
      if (!same(m.v, was.v)) line(of_script("particles", id) + ".velocity = " + lua_of(m.v));
    }
  }

  // Names of what was made.

  std::string name_for(const AnyId& thing, const std::string& word) {
    const std::string name = text(word, ++counts_[word]);
    const bool table = ++locals_ > most_locals;
    if (table && !has_table_) line("local made = {}"), has_table_ = true;
    names_[thing] = table ? "made." + name : name;
    return (table ? "" : "local ") + names_[thing];
  }
  std::string body(BodyId id) {
    if (const auto known = names_.find(id); known != names_.end()) return known->second;
    return made_since(id) ? "nil" : body_of_script(id);
  }
  /// A point; one that was added to a body is added where it is used first.
  std::string point(PointId id) {
    if (const auto known = names_.find(id); known != names_.end()) return known->second;
    const Point& row = now_.points[id];
    if (!row.body) return of_script("particles", row.own) + ".points[1]";
    if (!row.name.empty()) return text(body(row.body), ".", row.name);
    const std::vector<PointId>& all = now_.bodies[row.body].points;
    return text(body(row.body), ".points[", std::find(all.begin(), all.end(), id) - all.begin() + 1, "]");
  }
  std::string place(PointId id, Vec3 at) { return id ? point(id) : lua_of(at); }

  // Lines of what was made.

  std::size_t write_from(std::size_t i) {
    const AnyId& thing = order_[i];
    if (const auto* id = std::get_if<BodyId>(&thing)) return write_bodies(i, *id);
    if (const auto* id = std::get_if<PointId>(&thing))
      write_point(i, *id);
    else if (const auto* ring = std::get_if<ParticleId>(&thing))
      write_hinge(*ring);
    else if (const auto* tie = std::get_if<ConstraintId>(&thing))
      write_constraint(*tie);
    else if (const auto* tied = std::get_if<ConnectionId>(&thing))
      write_connection(*tied);
    else
      leave_out(thing, "came while the scene ran, and is nothing that a hand makes");
    return i + 1;
  }

  std::optional<LuaOfBody> plain_body(std::size_t i) {
    const auto* id = i < order_.size() ? std::get_if<BodyId>(&order_[i]) : nullptr;
    if (!id || used_.contains(AnyId(*id))) return {};
    const LuaOfBody lua = lua_of_body(now_, *id);
    return lua.call.empty() ? std::nullopt : std::optional(lua);
  }

  /// A body, or a row of alike ones at equal distances, to which nothing refers.
  std::size_t write_bodies(std::size_t i, BodyId id) {
    const LuaOfBody lua = lua_of_body(now_, id);
    if (lua.call.empty()) return leave_out(id, lua.why_not), i + 1;
    if (used_.contains(AnyId(id))) {
      const std::string name = name_for(id, lua.word);
      return line(text(name, " = ", lua.whole())), i + 1;
    }
    std::vector<LuaOfBody> row = {lua};
    while (const auto next = plain_body(i + row.size())) {
      if (!goes_on(row, *next)) break;
      row.push_back(*next);
    }
    if (row.size() < 3) return line(lua.whole()), i + 1;
    write_row(row);
    return i + row.size();
  }

  static Vec3 step_of(const LuaOfBody& a, const LuaOfBody& b) { return shortened(b.at - a.at, largest(b.at - a.at)); }
  static bool goes_on(const std::vector<LuaOfBody>& row, const LuaOfBody& next) {
    if (next.call != row[0].call || next.options != row[0].options) return false;
    const Vec3 step = step_of(row[0], row.size() > 1 ? row[1] : next);
    const double n = static_cast<double>(row.size());
    for (int k = 0; k < 3; k++)
      if (row[0].at[k] + step[k] * n != next.at[k]) return false;
    return true;
  }
  void write_row(const std::vector<LuaOfBody>& row) {
    const Vec3 step = step_of(row[0], row[1]);
    std::string at = "vec(";
    for (int k = 0; k < 3; k++) {
      at += k > 0 ? ", " : "";
      const double by = step[k];
      at += lua_of(row[0].at[k]);
      if (by != 0.0) at += text(by < 0.0 ? " - " : " + ", lua_of(std::fabs(by)), " * i");
    }
    const bool alike = std::ranges::all_of(row, [&](const LuaOfBody& b) { return b.color == row[0].color; });
    std::string colors;
    for (const LuaOfBody& one : row) colors += text(colors.empty() ? "" : ", ", quoted(one.color));
    line(text("for i = 0, ", row.size() - 1, " do"));
    if (!alike) line(text("  local color = ({ ", colors, " })[i + 1]"));
    line("  " + row[0].with(at + ")", alike ? quoted(row[0].color) : "color"));
    line("end");
  }

  void write_point(std::size_t i, PointId id) {
    const Point& row = now_.points[id];
    if (!row.body) return write_particle(id);
    const std::string call = text(body(row.body), ":add_point", lua_of_point(row));
    // One that is used once, by what was made right after it, is made in that call.
    if (uses_[id] == 1 && is_used_next(i, id)) {
      names_[id] = call;
      return;
    }
    if (uses_[id] == 0) return line(call);
    const std::string name = name_for(id, "point");
    line(text(name, " = ", call));
  }
  bool is_used_next(std::size_t i, PointId id) const {
    for (i++; i < order_.size() && std::holds_alternative<PointId>(order_[i]); i++) {}
    if (i == order_.size()) return false;
    if (const auto* ring = std::get_if<ParticleId>(&order_[i])) {
      const Particle& hinge = now_.particles[*ring];
      return hinge.points.size() == 2 && std::ranges::count(hinge.points, id) > 0;
    }
    if (const auto* tie = std::get_if<ConstraintId>(&order_[i])) {
      bool found = false;
      now_.constraints[*tie].each_point([&](PointId p) { found = found || p == id; });
      return found;
    }
    if (const auto* tie = std::get_if<ConnectionId>(&order_[i]))
      return std::ranges::count(now_.connections[*tie].particles, now_.points[id].particle) > 0;
    return false;
  }

  void write_particle(PointId id) {
    const LuaOfBody lua = lua_of_particle(now_, id);
    if (!used_.contains(AnyId(id))) return line(lua.whole());
    const std::string name = name_for(id, "particle");
    line(text(name, " = ", lua.whole()));
    names_[id] += ".points[1]";
  }

  /// The axis of a hinge or motor, in the world; in full where it was not a short one.
  Vec3 axis_of(const Constraint& c) const {
    const Quat frame = orientation(now_, c.body_a);
    const Vec3 exact = rotate(frame, c.axis_a), plain = shortened(exact, 1.0);
    if (norm(direction(plain) - exact) <= 1e-15) return plain;
    Vec3 axis = exact;
    for (int attempt = 0; attempt < 8; attempt++) {
      const Vec3 off = c.axis_a - rotate(conjugate(frame), direction(axis));
      if (norm2(off) == 0.0) return axis;
      axis = axis + rotate(frame, off);
    }
    return exact;
  }
  /// The axis of the hinge between two bodies, in the world; nothing: they turn freely.
  std::optional<Vec3> axis_between(const Particle& ring, BodyId a, BodyId b) const {
    for (const ConstraintId id : ring.axes) {
      const Constraint& c = now_.constraints[id];
      if ((c.body_a == a && c.body_b == b) || (c.body_a == b && c.body_b == a)) return axis_of(c);
    }
    return {};
  }

  /// Joined one after the other, as each pair may have an axis of its own.
  void write_hinge(ParticleId id) {
    const Particle& ring = now_.particles[id];
    for (std::size_t i = 1; i < ring.points.size(); i++) {
      const BodyId mine = now_.points[ring.points[i]].body;
      std::size_t with = 0;
      std::optional<Vec3> axis;
      for (std::size_t k = 0; k < i && !axis; k++) {
        const BodyId other = now_.points[ring.points[k]].body;
        axis = mine && other ? axis_between(ring, other, mine) : std::nullopt;
        if (axis) with = k;
      }
      if (!axis && are_joined_by_script(ring.points[0], ring.points[i])) continue;
      const std::string options = axis ? text(", { axis = ", lua_of(*axis), " }") : "";
      line(text("scene:hinge(", point(ring.points[with]), ", ", point(ring.points[i]), options, ")"));
    }
  }
  bool are_joined_by_script(PointId a, PointId b) const {
    return opened_.points.alive(a) && opened_.points.alive(b) && opened_.points[a].serial == now_.points[a].serial &&
           opened_.points[b].serial == now_.points[b].serial &&
           opened_.points[a].particle == opened_.points[b].particle;
  }

  void write_constraint(ConstraintId id) {
    const Constraint& c = now_.constraints[id];
    if (c.hand >= 0 || c.kind == ConstraintKind::axis) return;
    if (c.number.of_time || c.position.of_time || c.turn.of_time) return leave_out(id, "follows a function of time");
    switch (c.kind) {
      case ConstraintKind::nail:
        return line(text("scene:nail(", point(c.a),
                         same(c.position.now, position(now_, c.a)) ? "" : ", " + lua_of(c.position.now), ")"));
      case ConstraintKind::rod: return write_rod(c);
      case ConstraintKind::string: return write_string(c);
      case ConstraintKind::motor: return write_motor(id, c);
      case ConstraintKind::join:
        return line(text("scene:join(", point(c.a), ", ", point(c.b), ", { max_force = ", lua_of(c.max_force),
                         ", time_constant = ", lua_of(c.time_constant), axis_of_join(c), " })"));
      default: leave_out(id, "is nothing that a hand makes");
    }
  }
  static std::string axis_of_join(const Constraint& c) {
    const Vec3 axis = c.progress()->hinge_axis;
    return norm2(axis) > 0.0 ? ", axis = " + lua_of(axis) : "";
  }
  void write_rod(const Constraint& c) {
    const Vec3 other = c.b ? position(now_, c.b) : c.position.now;
    const std::string length = c.number.now == norm(other - position(now_, c.a)) ? "" : ", " + lua_of(c.number.now);
    line(text("scene:rod(", point(c.a), ", ", place(c.b, c.position.now), length, ")"));
  }
  void write_string(const Constraint& c) {
    std::string through;
    double way = 0.0;
    std::optional<Vec3> last;
    for (const Passage& passage : c.passages()) {
      const Vec3 at = passage.point ? position(now_, passage.point) : passage.position;
      if (last) way += norm(at - *last);
      last = at;
      through += text(through.empty() ? "" : ", ", place(passage.point, passage.position));
    }
    const std::string options = c.number.now == way ? "" : text(", { length = ", lua_of(c.number.now), " }");
    line(text("scene:string({ ", through, " }", options, ")"));
  }
  void write_motor(ConstraintId id, const Constraint& c) {
    if (!c.by_speed) return leave_out(id, "keeps an angle, as no hand's does");
    const std::string against = c.body_b ? body(c.body_b) + ", " : "";
    line(text("scene:motor(", body(c.body_a), ", ", against, "{ axis = ", lua_of(axis_of(c)),
              ", speed = ", lua_of(c.number.rate), ", max_torque = ", lua_of(c.max_torque), " })"));
  }

  void write_connection(ConnectionId id) {
    const Connection& tie = now_.connections[id];
    if (tie.law->name != "spring" || tie.count != 2) return leave_out(id, "has a law that no hand gives");
    std::string ends, numbers;
    for (std::uint32_t i = 0; i < 2; i++) {
      const ParticleId end = tie.particles[i];
      ends += text(i > 0 ? ", " : "", end ? point(now_.particles[end].points[0]) : lua_of(tie.positions[i]));
    }
    for (std::size_t k = 0; k < tie.parameters.size(); k++)
      numbers += text(k > 0 ? ", " : "", tie.law->parameters[k].name, " = ", lua_of(tie.parameters[k]));
    const std::string how = tie.asked == Solve::at_middle ? ", { implicit = true }" : "";
    line(text("scene:connect(", ends, ", force.spring { ", numbers, " }", how, ")"));
  }

  void finish() {
    std::string head;
    for (const std::string& list : lists_) head += text("  local ", list, " = scene.", list, "\n");
    out_.text =
        text("\n-- Built by hand", now_.time > 0.0 ? text(", and as it was at ", now_.time, " s") : std::string(),
             ".\ndo\n", head, lines_, "end\n");
  }

  const World& now_;
  const World& opened_;
  std::uint64_t first_;  ///< serial of what was made after the script
  std::vector<AnyId> order_;
  std::map<PointId, int> uses_;
  std::set<AnyId> used_;
  std::map<AnyId, std::size_t> numbers_;  ///< of the script's things, among their like
  std::map<AnyId, std::string> names_;
  std::map<std::string, int> counts_;
  std::set<std::string> lists_;  ///< of the script's things that are named
  std::size_t locals_ = 0;
  bool has_table_ = false;
  std::string lines_;
  LuaOfThings out_;
};

}  // namespace

LuaOfThings lua_of_things(const World& now, const World& opened) { return Writer(now, opened).write(); }

}  // namespace pantin::player
