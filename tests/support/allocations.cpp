// Replaces the global operator new to count. Array forms call these by default; nothrow ones too, but under a sanitizer
// they would take memory that the delete below does not know.
#include "support/allocations.hpp"

#include <malloc.h>
#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::uint64_t> count{0};
std::atomic<std::int64_t> in_use{0};  // [bytes]

void add_size(void* memory, std::int64_t sign) {
  in_use.fetch_add(sign * static_cast<std::int64_t>(malloc_usable_size(memory)), std::memory_order_relaxed);
}

void* counted(void* memory) {
  count.fetch_add(1, std::memory_order_relaxed);
  if (!memory) throw std::bad_alloc();
  add_size(memory, 1);
  return memory;
}

void release(void* memory) {
  if (memory) add_size(memory, -1);
  std::free(memory);
}

}  // namespace

std::int64_t pantin::live_bytes() { return in_use.load(std::memory_order_relaxed); }
std::uint64_t pantin::allocations() { return count.load(std::memory_order_relaxed); }

void* operator new(std::size_t size) { return counted(std::malloc(size > 0 ? size : 1)); }

void* operator new(std::size_t size, std::align_val_t alignment) {
  const std::size_t a = static_cast<std::size_t>(alignment);
  return counted(std::aligned_alloc(a, ((size > 0 ? size : 1) + a - 1) / a * a));
}

void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  count.fetch_add(1, std::memory_order_relaxed);
  void* memory = std::malloc(size > 0 ? size : 1);
  if (memory) add_size(memory, 1);
  return memory;
}

void operator delete(void* memory) noexcept { release(memory); }
void operator delete(void* memory, std::size_t) noexcept { release(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { release(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { release(memory); }
