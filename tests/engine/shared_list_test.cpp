#include "base/shared_list.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "support/allocations.hpp"

using namespace pantin;

TEST_CASE("a shared list reads, grows and is shortened as any list is, and leaves its copies alone") {
  SharedList shared;
  std::vector<double> list;
  for (int i = 0; i < 5000; i++) {
    shared.push_back(0.5 * i);
    list.push_back(0.5 * i);
  }
  const auto same = [&](const SharedList& h) {
    bool all = h.size() == list.size();
    for (std::size_t i = 0; all && i < list.size(); i++) all = h[i] == list[i];
    return all;
  };
  CHECK(same(shared));
  CHECK((shared.front() == 0.0 && shared.back() == 2499.5));
  SharedList copy = shared;
  copy.shorten(100);
  copy.push_back(-1.0);
  CHECK(same(shared));
  for (const std::size_t count : {6000u, 4999u, 4096u, 2047u, 1024u, 3u, 0u}) {
    shared.shorten(count);
    list.resize(std::min<std::size_t>(list.size(), count));
    CHECK(same(shared));
  }
  CHECK(shared.empty());
}

TEST_CASE("a copy of a long shared list costs little memory") {
  SharedList shared;
  for (int i = 0; i < 1000000; i++) shared.push_back(i);
  const std::int64_t before = live_bytes();
  const SharedList copy = shared;
  CHECK(live_bytes() - before < 40000);  // of 8 MB
  CHECK(copy == shared);
}
