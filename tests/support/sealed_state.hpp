#pragma once
// What stands before a state in a file, for tests that change one.
#include <cstdint>
#include <string>

namespace pantin {

struct StateHead {
  char magic[16];
  std::uint64_t layout, size, hash;
};

/// The same bytes with the checksum of what they now are; as they are where they are shorter than a head.
std::string sealed(std::string state);

}  // namespace pantin
