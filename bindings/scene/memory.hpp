#pragma once
#include <cstddef>

namespace pantin {

/// [bytes] of memory that this program holds now.
std::size_t resident_memory();

/// What may come to what the program holds when this is made, and 512 MiB.
class MemoryLimit {
 public:
  explicit MemoryLimit(std::size_t bytes);
  /// By more than `beyond` [bytes].
  bool exceeded(std::size_t beyond = 0) const;
  /// Throws Error, now and then asked.
  void check();
  /// What is told of it.
  static const char* message();

 private:
  std::size_t most_;
  unsigned asked_ = 0;
};

}  // namespace pantin
