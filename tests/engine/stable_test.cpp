#include "base/stable.hpp"

#include <catch2/catch.hpp>
#include <cstdint>
#include <filesystem>
#include <random>

#include "support/process.hpp"
#include "support/sources.hpp"

using namespace pantin;

namespace {

/// What a vector of more than 16 bytes is to the processor.
struct alignas(64) Wide {
  int key = 0, number = 0;
  bool aligned() const { return reinterpret_cast<std::uintptr_t>(this) % alignof(Wide) == 0; }
  Wide() = default;
  Wide(int k, int n) : key(k), number(n) {}
  Wide(Wide&& from) noexcept : key(from.key), number(from.number) { CHECK((aligned() && from.aligned())); }
  Wide& operator=(Wide&& from) noexcept {
    CHECK((aligned() && from.aligned()));
    key = from.key, number = from.number;
    return *this;
  }
  Wide(const Wide&) = delete;
  Wide& operator=(const Wide&) = delete;
  ~Wide() = default;
};

bool by_key(const Wide& a, const Wide& b) { return a.key < b.key; }
bool by_both(const Wide& a, const Wide& b) { return a.key != b.key ? a.key < b.key : a.number < b.number; }

std::vector<Wide> random_list(int count) {
  std::mt19937 random(static_cast<unsigned>(count));
  std::vector<Wide> list;
  list.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; i++) list.emplace_back(static_cast<int>(random() % 7), i);
  return list;
}

}  // namespace

TEST_CASE("stable: sorted, merged or parted, equals keep their order, at any alignment") {
  const int count = GENERATE(0, 1, 2, 15, 16, 17, 100, 1000);
  CAPTURE(count);
  std::vector<Wide> sorted = random_list(count);
  sort_stably(sorted.begin(), sorted.end(), by_key);
  CHECK(std::is_sorted(sorted.begin(), sorted.end(), by_both));

  std::vector<Wide> merged = random_list(count);
  const auto middle = merged.begin() + count / 3;
  sort_stably(merged.begin(), middle, by_key);
  sort_stably(middle, merged.end(), by_key);
  merge_sorted(merged.begin(), middle, merged.end(), by_key);
  CHECK(std::is_sorted(merged.begin(), merged.end(), by_both));

  std::vector<Wide> parted = random_list(count);
  const auto is_even = [](const Wide& w) { return w.key % 2 == 0; };
  const auto by_number = [](const Wide& a, const Wide& b) { return a.number < b.number; };
  const auto odd = partition_stably(parted.begin(), parted.end(), is_even);
  CHECK((std::all_of(parted.begin(), odd, is_even) && std::none_of(odd, parted.end(), is_even)));
  CHECK((std::is_sorted(parted.begin(), odd, by_number) && std::is_sorted(odd, parted.end(), by_number)));
}

TEST_CASE("stable: the engine sorts, merges and parts by nothing else") {
  for (const auto& file : std::filesystem::recursive_directory_iterator(sources::folder() + "/engine")) {
    if (!file.is_regular_file() || file.path().filename() == "stable.hpp") continue;
    CAPTURE(file.path());
    const std::string content = support::read_file(file.path());
    for (const char* name : {"std::stable_sort(", "std::stable_partition(", "std::inplace_merge("})
      CHECK(content.find(name) == std::string::npos);
  }
}
