#pragma once
#include <array>
#include <cstdint>
#include <string_view>

namespace pantin {

/// How impulses of an island are found: as its size and motion ask for; always by Newton's search, too; by sweeps alone.
enum class ContactSearch : std::uint8_t { automatic, exact, fast };
/// In the order of ContactSearch.
inline constexpr std::array<std::string_view, 3> contact_search_names = {"auto", "exact", "fast"};

}  // namespace pantin
