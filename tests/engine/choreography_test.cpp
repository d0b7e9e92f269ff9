#include "world/choreography.hpp"

#include <catch2/catch.hpp>

#include "world/edit.hpp"

using namespace pantin;
using Catch::Contains;

namespace {

struct Scene {
  World world;
  std::vector<std::string> done;

  Event event(double first, std::string name, double period = 0.0) {
    Event e;
    e.first = first;
    e.period = period;
    e.label = name;
    e.action = [this, name] { done.push_back(name); };
    return e;
  }
  EventId add(double first, std::string name, double period = 0.0) {
    return add_event(world, event(first, name, period));
  }
  EventState state(EventId id) { return *world.choreography.events[id].state; }
};

}  // namespace

TEST_CASE("events fire in the order of time, then of adding, once") {
  Scene s;
  s.add(2, "late");
  s.add(1, "first");
  s.add(1, "second");
  s.add(0, "now");
  fire_events(s.world, 0.5);
  CHECK(s.done == std::vector<std::string>{"now"});
  fire_events(s.world, 1.0);
  fire_events(s.world, 1.5);
  CHECK(s.done == std::vector<std::string>{"now", "first", "second"});
  fire_events(s.world, 10);
  CHECK(s.done.back() == "late");
  CHECK(s.world.choreography.events.empty());
}

TEST_CASE("a repeating event fires at whole multiples of its period, missed ones too") {
  Scene s;
  const EventId id = s.add(0.1, "tick", 0.1);
  fire_events(s.world, 0.05);
  CHECK(s.done.empty());
  fire_events(s.world, 0.35);
  CHECK(s.done.size() == 3);
  CHECK(s.state(id) == EventState::waiting);
  for (int step = 1; step <= 24000; step++) fire_events(s.world, step / 240.0);
  CHECK(s.done.size() == 1000);
  CHECK(s.world.choreography.heap.size() == 1);
}

TEST_CASE("a time reached up to round-off counts as reached") {
  Scene s;
  const double sum = 0.1 + 0.2;  // a little more than 0.3
  s.add(sum, "now");
  fire_events(s.world, 0.3);
  CHECK(s.done.size() == 1);
}

TEST_CASE("an event added while firing fires in the same call if it is due") {
  Scene s;
  Event parent = s.event(1, "parent");
  parent.action = [&s] {
    s.done.push_back("parent");
    s.add(1, "child");
    s.add(2, "later");
  };
  add_event(s.world, parent);
  s.add(1, "sibling");
  fire_events(s.world, 1);
  CHECK(s.done == std::vector<std::string>{"parent", "sibling", "child"});
}

TEST_CASE("an event that sets itself again without a delay is an error, not a hang") {
  Scene s;
  std::function<void()> again = [&] {
    Event e;
    e.action = again;
    e.label = "scene.lua:2";
    add_event(s.world, e);
  };
  again();
  CHECK_THROWS_WITH(fire_events(s.world, 0), Contains("scene.lua:2: 1000000 events in one step"));
}

TEST_CASE("an event whose target is gone is dropped and logged with who removed it") {
  Scene s;
  const ParticleId ball = add_particle(s.world, {}), other = add_particle(s.world, {});
  s.world.particles[ball].name = "ball";
  Event e = s.event(1, "scene.lua:12");
  e.target = ball;
  const EventId id = add_event(s.world, e);
  const std::shared_ptr<EventState> state = s.world.choreography.events[id].state;
  Event repeating = s.event(1, "scene.lua:13", 1);
  const GroupId group = add_group(s.world, "pair");
  add_to_group(s.world, group, other);
  repeating.target = group;
  add_event(s.world, repeating);
  s.world.who = [] { return std::string("hand 1"); };
  remove(s.world, ball);
  remove(s.world, other);
  fire_events(s.world, 5);
  CHECK(s.done.empty());
  CHECK(*state == EventState::dropped);
  REQUIRE(s.world.log.size() == 2);
  CHECK(s.world.log[0].kind == "dropped");
  CHECK(s.world.log[0].text == "event scene.lua:12, due at 1 s: particle 'ball' was removed at 0 s by hand 1");
  CHECK(s.world.log[1].text == "event scene.lua:13, due at 1 s: no member of group 'pair' lives any more");
  CHECK(s.world.choreography.events.empty());
}

TEST_CASE("a cancelled event does not fire, and its state can still be read") {
  Scene s;
  const EventId once = s.add(1, "once"), ticks = s.add(1, "tick", 1);
  const auto state = s.world.choreography.events[once].state;
  CHECK(*state == EventState::waiting);
  cancel(s.world, once);
  cancel(s.world, once);
  CHECK(*state == EventState::cancelled);
  fire_events(s.world, 2);
  cancel(s.world, ticks);
  fire_events(s.world, 9);
  CHECK(s.done == std::vector<std::string>{"tick", "tick"});
}

TEST_CASE("a repeating event may cancel itself") {
  Scene s;
  EventId id;
  Event e = s.event(1, "tick", 1);
  e.action = [&] {
    s.done.push_back("tick");
    cancel(s.world, id);
  };
  id = add_event(s.world, e);
  fire_events(s.world, 5);
  CHECK(s.done.size() == 1);
  CHECK(s.world.choreography.events.empty());
}

TEST_CASE("an action that throws does not spoil the queue") {
  Scene s;
  Event bad = s.event(1, "bad", 1);
  bad.action = [] { throw Error("oh"); };
  const EventId id = add_event(s.world, bad);
  s.add(1, "good");
  CHECK_THROWS_WITH(fire_events(s.world, 1), "oh");
  fire_events(s.world, 1);
  CHECK(s.done == std::vector<std::string>{"good"});
  CHECK(s.world.choreography.events[id].fired == 1);
}

TEST_CASE("the queue does not grow with cancelled events") {
  Scene s;
  for (int i = 0; i < 10000; i++) cancel(s.world, s.add(1e6, "far"));
  CHECK(s.world.choreography.heap.size() < 200);
}

TEST_CASE("bad times and empty actions are errors") {
  Scene s;
  s.world.time = 2;
  CHECK_THROWS_WITH(s.add(1, "past"), Contains("must not be past, got 1 s"));
  CHECK_THROWS_WITH(s.add(std::nan(""), "nan"), Contains("time must be finite"));
  CHECK_THROWS_WITH(s.add(3, "back", -1), Contains("period must be >= 0 s"));
  CHECK_THROWS_WITH(s.add(3, "dense", 1e-17), Contains("period must be long enough"));
  Event nothing;
  nothing.first = 3;
  CHECK_THROWS_WITH(add_event(s.world, nothing), Contains("no action"));
  CHECK(s.world.choreography.heap.empty());
  s.add(2, "now");
  fire_events(s.world, 2);
  CHECK(s.done.size() == 1);
}
