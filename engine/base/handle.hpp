#pragma once
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace pantin {

/// Names a row of one kind: slot and generation (32 + 32 bits). Zero is null; a handle of a removed row never comes
/// back to life.
template <class Row>
struct Handle {
  std::uint32_t slot = 0;        ///< index + 1; 0 is null
  std::uint32_t generation = 0;  ///< counts how often the slot was given out
  explicit operator bool() const { return slot != 0; }
  friend auto operator<=>(const Handle&, const Handle&) = default;
};

}  // namespace pantin

template <class Row>
struct std::hash<pantin::Handle<Row>> {
  std::size_t operator()(const pantin::Handle<Row>& h) const noexcept {
    return (static_cast<std::size_t>(h.generation) << 32) ^ h.slot;
  }
};
