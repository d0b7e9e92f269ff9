#pragma once
#include <cstdint>

namespace pantin {

/// How often the test program has asked for memory since its start (operator new, every form).
std::uint64_t allocations();
/// Bytes that operator new gave and that are in use [bytes].
std::int64_t live_bytes();

}  // namespace pantin
