#pragma once
// Of a rank: what it works on is done in a process apart, which may die without ending the rank and with it all others.
#include <sys/types.h>

#include <functional>
#include <string>

namespace pantin::player {

class Foreman {
 public:
  /// Call it before MPI begins, which does not like processes that fork. `died` makes a result of a piece of work whose process
  /// ended, and of how.
  Foreman(const std::function<std::string(const std::string&)>& work,
          const std::function<std::string(const std::string&, const std::string&)>& died);
  ~Foreman();
  Foreman(const Foreman&) = delete;
  Foreman& operator=(const Foreman&) = delete;

  /// Throws Error where the foreman is gone.
  std::string result_of(const std::string& piece) const;

 private:
  pid_t process_ = -1;
  int to_ = -1, from_ = -1;
};

}  // namespace pantin::player
