#pragma once
#include <cstdint>
#include <optional>

#include "lua/value/callback.hpp"

namespace pantin::lua {

/// A number that changes where a value changes that a function sees from outside: its locals, those of the functions it
/// calls, the globals, and what is in tables among them; numbers, texts, truths, vecs, and which things others are. None where
/// these are more than a thousand values.
std::optional<std::uint64_t> captured_values(const Callback& function);

}  // namespace pantin::lua
