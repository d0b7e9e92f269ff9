#pragma once
#include <bit>
#include <cstdint>
#include <string>

#include "base/lanes.hpp"

namespace pantin {

/// FNV-1a over 64-bit words with a final mix: tells whether two states have the same bits.
struct Hash {
  std::uint64_t value = 0xcbf29ce484222325u;

  void add(std::uint64_t word) {
    value = (value ^ word) * 0x100000001b3u;
    value ^= value >> 29;
  }
  void add(double x) { add(std::bit_cast<std::uint64_t>(x == 0.0 ? 0.0 : x)); }
  /// Its bytes, one by one.
  void add(const std::string& text) {
    for (const char c : text) add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
  }
  void add(Vec3 v) {
    for (int i = 0; i < 3; i++) add(static_cast<double>(v[i]));
  }
};

}  // namespace pantin
