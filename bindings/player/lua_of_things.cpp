#include "player/lua_of_things.hpp"

#include <map>
#include <optional>
#include <set>

#include "measure/measure.hpp"
#include "player/lua_of_body.hpp"
#include "player/lua_of_edits.hpp"
#include "player/lua_of_ties.hpp"
#include "player/lua_rows.hpp"

namespace pantin::player {
namespace {

/// Those that were made since, in their order.
template <class Store, class Id>
void by_serial(const Store& store, std::uint64_t first, std::map<std::uint64_t, AnyId>& order, Id) {
  for (const Id id : store.ids())
    if (store[id].serial >= first) order[store[id].serial] = id;
}

class Writer {
 public:
  Writer(const World& now, const World& opened)
      : now_(now), opened_(opened), first_(opened.next_serial), names_(now, opened) {}

  LuaOfThings write() {
    find_order();
    count_uses();
    LuaOfEdits edits = lua_of_edits(now_, opened_, names_);
    lines_ = std::move(edits.lines);
    out_.left_out = std::move(edits.left_out);
    for (std::size_t i = 0; i < order_.size();) i = write_from(i);
    if (!lines_.empty()) finish();
    return std::move(out_);
  }

 private:
  void line(std::string text_of_line) { lines_.push_back(std::move(text_of_line)); }
  void leave_out(const AnyId& thing, const std::string& why) {
    out_.left_out.push_back(text(describe(now_, thing), " ", why));
  }

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
      const bool in_maker = point.body && names_.made_since(point.body) && is_made_with(now_, id);
      if (point.serial >= first_ && !in_maker && !is_grip(id)) order[point.serial] = id;
    }
    for (const ShapeId id : now_.shapes.ids()) {
      const Shape& shape = now_.shapes[id];
      if (shape.serial >= first_ && !(shape.body && names_.made_since(shape.body))) order[shape.serial] = id;
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

  // Lines of what was made.

  std::size_t write_from(std::size_t i) {
    const AnyId& thing = order_[i];
    if (const auto* id = std::get_if<BodyId>(&thing)) return write_bodies(i, *id);
    if (const auto* id = std::get_if<PointId>(&thing))
      write_point(i, *id);
    else if (const auto* ring = std::get_if<ParticleId>(&thing))
      write_tie(thing, lua_of_hinge(now_, opened_, *ring, names_));
    else if (const auto* tie = std::get_if<ConstraintId>(&thing))
      write_tie(thing, lua_of_constraint(now_, *tie, names_));
    else if (const auto* tied = std::get_if<ConnectionId>(&thing))
      write_tie(thing, lua_of_connection(now_, *tied, names_));
    else
      leave_out(thing, "came while the scene ran, and is nothing that a hand makes");
    return i + 1;
  }

  void write_tie(const AnyId& thing, LuaOfTie tie) {
    if (!tie.why_not.empty()) leave_out(thing, tie.why_not);
    for (std::string& text_of_line : tie.lines) line(std::move(text_of_line));
  }

  std::optional<LuaOfBody> body_at(std::size_t i) const {
    const auto* id = i < order_.size() ? std::get_if<BodyId>(&order_[i]) : nullptr;
    LuaOfBody lua = id ? lua_of_body(now_, *id) : LuaOfBody{};
    return lua.call.empty() ? std::nullopt : std::optional(std::move(lua));
  }
  bool is_used(std::size_t i) const { return used_.contains(order_[i]); }

  /// A body, or a row of alike ones at equal distances.
  std::size_t write_bodies(std::size_t i, BodyId id) {
    const LuaOfBody lua = lua_of_body(now_, id);
    if (lua.call.empty()) return leave_out(id, lua.why_not), i + 1;
    RowOfBodies row(lua);
    for (auto next = body_at(i + 1); next && row.take(*next); next = body_at(i + row.size())) {}
    if (row.size() >= RowOfBodies::least) return write_row(i, row, lua.word + "s"), i + row.size();
    return line(is_used(i) ? text(names_.declare(id, lua.word), " = ", lua.whole()) : lua.whole()), i + 1;
  }
  void write_row(std::size_t i, const RowOfBodies& row, const std::string& word) {
    std::string table;
    for (std::size_t k = 0; k < row.size() && table.empty(); k++) {
      if (!is_used(i + k)) continue;
      line(text(names_.declare(order_[i], word), " = {}"));
      table = names_.of(order_[i]);
    }
    for (std::size_t k = 0; k < row.size() && !table.empty(); k++)
      names_.call(order_[i + k], text(table, "[", k + 1, "]"));
    for (const std::string& text_of_line : row.lines(table)) line(text_of_line);
  }

  void write_point(std::size_t i, PointId id) {
    const Point& row = now_.points[id];
    if (!row.body) return write_particle(id);
    const std::string call = text(names_.body(row.body), ":add_point", lua_of_point(row));
    // One that is used once, by what was made right after it, is made in that call.
    if (uses_[id] == 1 && is_used_next(i, id)) {
      names_.call(id, call);
      return;
    }
    if (uses_[id] == 0) return line(call);
    line(text(names_.declare(id, "point"), " = ", call));
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
    line(text(names_.declare(id, "particle"), " = ", lua.whole()));
    names_.call(id, names_.of(id) + ".points[1]");
  }

  void finish() {
    std::string all;
    for (const std::string& text_of_line : with_loops(lines_)) all += "  " + text_of_line + "\n";
    out_.text =
        text("\n-- Built by hand", now_.time > 0.0 ? text(", and as it was at ", now_.time, " s") : std::string(),
             ".\ndo\n", names_.head(), all, "end\n");
  }

  const World& now_;
  const World& opened_;
  std::uint64_t first_;  ///< serial of what was made after the script
  std::vector<AnyId> order_;
  std::map<PointId, int> uses_;
  std::set<AnyId> used_;
  LuaNames names_;
  std::vector<std::string> lines_;
  LuaOfThings out_;
};

}  // namespace

LuaOfThings lua_of_things(const World& now, const World& opened) { return Writer(now, opened).write(); }

}  // namespace pantin::player
