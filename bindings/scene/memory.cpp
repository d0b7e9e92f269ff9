#include "scene/memory.hpp"

#include <unistd.h>

#include <cstdio>
#include <limits>

#include "base/check.hpp"

namespace pantin {

std::size_t resident_memory() {
  std::FILE* file = std::fopen("/proc/self/statm", "r");
  if (!file) return 0;
  unsigned long all = 0, resident = 0;
  const bool read = std::fscanf(file, "%lu %lu", &all, &resident) == 2;
  std::fclose(file);
  return read ? resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) : 0;
}

MemoryLimit::MemoryLimit(std::size_t bytes) {
  constexpr std::size_t beside = std::size_t{512} << 20;  // of what was freed and is still held, too
  const std::size_t now = resident_memory() + beside, most = std::numeric_limits<std::size_t>::max();
  most_ = bytes > most - now ? most : now + bytes;
}

bool MemoryLimit::exceeded(std::size_t beyond) const {
  const std::size_t now = resident_memory();
  return now > most_ && now - most_ > beyond;
}

void MemoryLimit::check() {
  constexpr unsigned often = 256;
  if (++asked_ % often == 0) require(!exceeded(), message());
}

const char* MemoryLimit::message() { return "the scene takes more memory than it may (--memory-limit)"; }

}  // namespace pantin
