#pragma once
#include <array>
#include <cstddef>
#include <new>
#include <utility>

namespace pantin::lua {

/// Memory in blocks of at most `most` bytes, for whoever knows a block's size when it is given back. It goes back to the
/// system only at the end.
class SmallBlocks {
 public:
  static constexpr std::size_t most = 256;  ///< [bytes]

  SmallBlocks() = default;
  ~SmallBlocks();
  SmallBlocks(const SmallBlocks&) = delete;
  SmallBlocks& operator=(const SmallBlocks&) = delete;

  /// Null where there is no memory. `size` [bytes] must be 1 … most.
  void* take(std::size_t size) {
    Link*& free = free_[place(size)];
    if (!free && !refill(place(size))) return nullptr;
    return std::exchange(free, free->next);
  }
  void give_back(void* block, std::size_t size) {
    Link*& free = free_[place(size)];
    free = new (block) Link{free};
  }
  /// Whether a block of one of these sizes serves for the other.
  static bool alike(std::size_t a, std::size_t b) { return place(a) == place(b); }

 private:
  struct Link {
    Link* next;
  };
  static constexpr std::size_t grain = 16, chunk = 65536;  // [bytes]

  static std::size_t place(std::size_t size) { return (size - 1) / grain; }
  bool refill(std::size_t place);

  std::array<Link*, most / grain> free_{};
  Link* chunks_ = nullptr;
};

}  // namespace pantin::lua
