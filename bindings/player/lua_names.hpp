#pragma once
// What things are called in Lua that is written for a world: those of its script, and those that are made after it.
#include <cstdint>
#include <map>
#include <set>
#include <string>

#include "world/world.hpp"

namespace pantin::player {

class LuaNames {
 public:
  /// `opened` is the same scene as its script left it.
  LuaNames(const World& now, const World& opened);

  bool made_since(BodyId body) const { return now_.bodies[body].serial >= first_; }
  /// How one of the script's bodies, particles, hinges or connections is found again.
  std::string of_script(const char* list, const AnyId& id);
  std::string of_script(BodyId id) { return of_script("bodies", id); }
  std::string body(BodyId id);
  std::string point(PointId id);
  /// A point, or a place in the world.
  std::string place(PointId id, Vec3 at);

  /// A name of its own for a thing that is made, as the beginning of the line that makes it: "local box1".
  std::string declare(const AnyId& thing, const std::string& word);
  /// A thing is known by that text from now on.
  void call(const AnyId& thing, const std::string& name) { names_[thing] = name; }
  const std::string& of(const AnyId& thing) const { return names_.at(thing); }

  /// Lines that must stand before those that use the names.
  std::string head() const;

 private:
  const World& now_;
  std::uint64_t first_;                   ///< serial of what was made after the script
  std::map<AnyId, std::size_t> numbers_;  ///< of the script's things, among their like
  std::map<AnyId, std::string> names_;
  std::map<std::string, int> counts_;
  std::set<std::string> lists_;  ///< of the script's things that are named
  std::size_t locals_ = 0;
};

}  // namespace pantin::player
