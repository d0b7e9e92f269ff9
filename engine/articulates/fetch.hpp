#pragma once
// Memory that a thread wants next, asked for a little at a time while it computes something else: where there is more of it
// than a cache holds, the next articulate is there when its turn comes.
#include <array>
#include <cstddef>

namespace pantin {

struct Articulate;

/// While there is one, this thread asks by it.
class Fetch {
 public:
  explicit Fetch(const Articulate& next);
  ~Fetch() { current = nullptr; }
  Fetch(const Fetch&) = delete;
  Fetch& operator=(const Fetch&) = delete;

  /// Call it between pieces of work of some 0.1 us.
  static void some() {
    if (current) current->ask();
  }

 private:
  struct Part {
    const char *begin, *end;
  };
  void add(const void* data, std::size_t size);
  void ask();

  static inline thread_local Fetch* current = nullptr;
  std::array<Part, 32> parts_;
  std::size_t count_ = 0, part_ = 0;
};

}  // namespace pantin
