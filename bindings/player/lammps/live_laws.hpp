#pragma once
// Laws as LAMMPS is given them: without what is nothing, since the values that it is multiplied by are 0.
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "laws/law.hpp"
#include "world/world.hpp"

namespace pantin::player {

class LiveLaws {
 public:
  explicit LiveLaws(const World& world) : world_(world) {}

  /// The law of a force element; another one where it depends on velocities or time only by what is 0: a parameter of the
  /// element, or an attribute of all particles.
  std::shared_ptr<const Law> of(const ForceElement& row);
  /// A sentence for each law that is another one so.
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  using Names = std::set<std::string>;

  const World& world_;
  std::map<std::pair<const Law*, Names>, std::shared_ptr<const Law>> known_;
  std::map<std::string, bool> zero_everywhere_;  // (attributes)
  std::vector<std::string> notes_;

  bool is_zero_everywhere(const std::string& attribute);
  Names zeros_of(const Law& law, const ForceElement& row);
  static std::shared_ptr<Law> without(const Law& law, const Names& zeros);
  static std::shared_ptr<const Law> live_part(const Law& law, const ForceElement& row, const Names& zeros);
  static Names needed_of(const Law& law, const Names& zeros);
};

}  // namespace pantin::player
