#include "base/profile.hpp"

#include <catch2/catch.hpp>
#include <thread>

using namespace pantin;

namespace {

/// Steps that those timed stand for.
int told_of(int steps, std::chrono::microseconds each) {
  Profile profile;
  int told = 0;
  for (int i = 0; i < steps; i++) {
    profile.begin();
    const Timed timed(profile, Phase::drift);
    told += profile.stands_for;
    if (each.count() > 0) std::this_thread::sleep_for(each);
  }
  return told;
}

}  // namespace

TEST_CASE("profile: of short steps those that are timed stand for all") {
  const int told = told_of(1000, std::chrono::microseconds(0));
  CHECK(told <= 1000);
  CHECK(told > 1000 - Profile::most);
}

TEST_CASE("profile: each long step is timed") { CHECK(told_of(20, 2 * Profile::enough) == 20); }
