#include "base/store.hpp"

#include <catch2/catch.hpp>

using namespace pantin;

namespace {
struct Thing {
  std::uint64_t serial = 0;
  int value = 0;
};
using Id = Handle<Thing>;
}  // namespace

TEST_CASE("a handle finds its row until the row is removed") {
  Store<Thing> store;
  const Id a = store.add({1, 10}), b = store.add({2, 20});
  CHECK(store[a].value == 10);
  CHECK(store[b].value == 20);
  CHECK(store.size() == 2);
  store.remove(a, {"thing 1", 1.5, "scene.lua:12"});
  CHECK_FALSE(store.alive(a));
  CHECK(store.alive(b));
  CHECK(store.size() == 1);
}

TEST_CASE("a dead handle tells what it was, when it went and who removed it") {
  Store<Thing> store;
  const Id a = store.add({1, 0});
  store.remove(a, {"thing 1", 1.5, "scene.lua:12"});
  CHECK_THROWS_WITH(store[a], "thing 1 was removed at 1.5 s by scene.lua:12");
  CHECK_THROWS_AS(store.remove(a, {}), Error);
}

TEST_CASE("a handle never comes back to life when its slot is used again") {
  Store<Thing> store;
  const Id a = store.add({1, 0});
  store.remove(a, {"thing 1", 0.0, "test"});
  const Id b = store.add({2, 7});
  CHECK(b.slot == a.slot);
  CHECK_FALSE(store.alive(a));
  CHECK(store[b].value == 7);
  CHECK(store.story(a) == "thing 1 was removed at 0 s by test");
  store.remove(b, {"thing 2", 0.0, "test"});
  CHECK(store.story(a) == "this was removed long ago, and its slot has been used again since");
}

TEST_CASE("a null handle and one of another world are errors") {
  Store<Thing> store;
  CHECK_THROWS_WITH(store[Id{}], "this names nothing");
  CHECK_THROWS_WITH(store[(Id{9, 1})], "this handle was never given out by this world");
}

TEST_CASE("ids come in the order of making, whatever their slots are") {
  Store<Thing> store;
  const Id a = store.add({1, 0}), b = store.add({2, 0});
  store.remove(a, {});
  const Id c = store.add({3, 0});
  CHECK(c.slot < b.slot);
  CHECK(store.ids() == std::vector<Id>{b, c});
}
