#include "player/lua_names.hpp"

#include <algorithm>

#include "measure/query.hpp"
#include "player/lua_of_body.hpp"

namespace pantin::player {
namespace {

constexpr std::size_t most_locals = 100;  // of a script's 200

}  // namespace

LuaNames::LuaNames(const World& now, const World& opened) : now_(now), first_(opened.next_serial) {
  const auto number = [&](const auto& ids) {
    for (std::size_t i = 0; i < ids.size(); i++) numbers_[ids[i]] = i + 1;
  };
  number(opened.bodies.ids());
  number(particles(opened));
  number(hinges(opened));
  number(opened.connections.ids());
}

std::string LuaNames::of_script(const char* list, const AnyId& id) {
  lists_.insert(list);
  return text(list, "[", numbers_.at(id), "]");
}

std::string LuaNames::body(BodyId id) {
  if (const auto known = names_.find(id); known != names_.end()) return known->second;
  return made_since(id) ? "nil" : of_script(id);
}

std::string LuaNames::point(PointId id) {
  if (const auto known = names_.find(id); known != names_.end()) return known->second;
  const Point& row = now_.points[id];
  if (!row.body) return of_script("particles", row.own) + ".points[1]";
  if (!row.name.empty()) return text(body(row.body), ".", row.name);
  const std::vector<PointId>& all = now_.bodies[row.body].points;
  return text(body(row.body), ".points[", std::find(all.begin(), all.end(), id) - all.begin() + 1, "]");
}

std::string LuaNames::place(PointId id, Vec3 at) { return id ? point(id) : lua_of(at); }

std::string LuaNames::declare(const AnyId& thing, const std::string& word) {
  const std::string name = text(word, ++counts_[word]);
  const bool in_table = ++locals_ > most_locals;
  names_[thing] = in_table ? "made." + name : name;
  return (in_table ? "" : "local ") + names_[thing];
}

std::string LuaNames::head() const {
  std::string lines;
  for (const std::string& list : lists_) lines += text("  local ", list, " = scene.", list, "\n");
  if (locals_ > most_locals) lines += "  local made = {}\n";
  return lines;
}

}  // namespace pantin::player
