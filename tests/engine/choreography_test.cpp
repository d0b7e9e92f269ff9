#include "choreography/choreography.hpp"

#include <catch2/catch.hpp>

#include "edit/edit.hpp"

using namespace pantin;
using Catch::Contains;

namespace {

struct Scene {
  World world;
  std::vector<std::string> done;

  Event event(double first, std::string name, double period = 0.0) {
    Event e;
    e.kind = period != 0.0 ? EventKind::every : EventKind::once;
    e.time = period != 0.0 ? first - period : first;
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
  fire_due(s.world, 0.5);
  CHECK(s.done == std::vector<std::string>{"now"});
  fire_due(s.world, 1.0);
  fire_due(s.world, 1.5);
  CHECK(s.done == std::vector<std::string>{"now", "first", "second"});
  fire_due(s.world, 10);
  CHECK(s.done.back() == "late");
  CHECK(s.world.choreography.events.empty());
}

TEST_CASE("a repeating event fires at whole multiples of its period, missed ones too") {
  Scene s;
  const EventId id = s.add(0.1, "tick", 0.1);
  fire_due(s.world, 0.05);
  CHECK(s.done.empty());
  fire_due(s.world, 0.35);
  CHECK(s.done.size() == 3);
  CHECK(s.state(id) == EventState::waiting);
  for (int step = 1; step <= 24000; step++) fire_due(s.world, step / 240.0);
  CHECK(s.done.size() == 1000);
  CHECK(s.world.choreography.heap.size() == 1);
}

TEST_CASE("a time reached up to round-off counts as reached") {
  Scene s;
  const double sum = 0.1 + 0.2;  // a little more than 0.3
  s.add(sum, "now");
  fire_due(s.world, 0.3);
  CHECK(s.done.size() == 1);
}

TEST_CASE("events at whole steps fire in just these, over hours of any step") {
  struct Case {
    double step, period;  // [s]
    std::uint64_t steps;  // in a period
  };
  for (const Case& c :
       {Case{1.0 / 60.0, 0.1, 6}, Case{1.0 / 240.0, 0.35, 84}, Case{1e-3, 0.3, 300}, Case{0.1, 0.3, 3}}) {
    Scene s;
    std::uint64_t ticks = 0, waits = 0, wrong = 0;
    Event every = s.event(c.period, "every", c.period);
    every.action = [&] { ticks++; };
    add_event(s.world, every);
    Event play;
    play.kind = EventKind::play;
    play.goes = [&]() -> std::optional<Wait> { return waits++, Wait{c.period, {}}; };
    add_event(s.world, play);
    for (std::uint64_t k = 0; k < 2'000'000; k++) {
      fire_due(s.world, static_cast<double>(k) * c.step);
      wrong += ticks != k / c.steps || waits != k / c.steps + 1;
    }
    CHECK(wrong == 0);
  }
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
  fire_due(s.world, 1);
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
  CHECK_THROWS_WITH(fire_due(s.world, 0), Contains("scene.lua:2: 1000000 events in one step"));
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
  fire_due(s.world, 5);
  CHECK(s.done.empty());
  CHECK(*state == EventState::dropped);
  REQUIRE(s.world.log.size() == 2);
  CHECK(s.world.log[0].kind == "dropped");
  CHECK(s.world.log[0].text == "event scene.lua:12, due at 1 s: particle 'ball' was removed at 0 s by hand 1");
  CHECK(s.world.log[1].text ==
        "event scene.lua:13, due at 1 s: no member of group 'pair' lives any more: particle 4 was removed at 0 s by "
        "hand 1");
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
  fire_due(s.world, 2);
  cancel(s.world, ticks);
  fire_due(s.world, 9);
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
  fire_due(s.world, 5);
  CHECK(s.done.size() == 1);
  CHECK(s.world.choreography.events.empty());
}

TEST_CASE("an action that throws does not spoil the queue") {
  Scene s;
  Event bad = s.event(1, "bad", 1);
  bad.action = [] { throw Error("oh"); };
  const EventId id = add_event(s.world, bad);
  s.add(1, "good");
  CHECK_THROWS_WITH(fire_due(s.world, 1), "oh");
  fire_due(s.world, 1);
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
  CHECK_THROWS_WITH(s.add(3, "back", -1), Contains("period must be > 0 s"));
  CHECK_THROWS_WITH(s.add(3, "dense", 1e-17), Contains("period must be long enough"));
  Event nothing;
  nothing.time = 3;
  CHECK_THROWS_WITH(add_event(s.world, nothing), Contains("no action"));
  CHECK(s.world.choreography.heap.empty());
  s.add(2, "now");
  fire_due(s.world, 2);
  CHECK(s.done.size() == 1);
}

TEST_CASE("a repeating event fires a million times, each at an exact multiple of its period") {
  World world;
  std::uint64_t count = 0, wrong = 0;
  Event e;
  e.kind = EventKind::every;
  e.period = 0.001;
  e.action = [&] { count++; };
  add_event(world, e);
  for (std::uint64_t k = 1; k <= 1'000'000; k++) {
    const double due = static_cast<double>(k) * 0.001;
    wrong += world.choreography.heap.front().time != due;
    fire_due(world, due);
    wrong += count != k;
  }
  CHECK(wrong == 0);
  CHECK(world.choreography.heap.size() == 1);
}

TEST_CASE("an over is told in each step how much of it has passed, and at last 1") {
  Scene s;
  std::vector<double> parts;
  Event e;
  e.kind = EventKind::over;
  e.time = 1.0;
  e.until = 2.0;
  e.progress = [&](double u) { parts.push_back(u); };
  const EventId id = add_event(s.world, e);
  const auto state = s.world.choreography.events[id].state;
  for (int step = 1; step <= 12; step++) fire_due(s.world, 0.25 * step);
  CHECK(parts == std::vector<double>{0.0, 0.25, 0.5, 0.75, 1.0});
  CHECK(*state == EventState::fired);
  parts.clear();
  e.time = 4.1;
  e.until = 4.15;  // within one step
  add_event(s.world, e);
  fire_due(s.world, 5);
  CHECK(parts == std::vector<double>{1.0});
}

TEST_CASE("an over whose target goes on the way is dropped there") {
  Scene s;
  const ParticleId ball = add_particle(s.world, {});
  int told = 0;
  Event e;
  e.kind = EventKind::over;
  e.until = 10.0;
  e.target = ball;
  e.label = "scene.lua:7";
  e.progress = [&](double) { told++; };
  add_event(s.world, e);
  fire_due(s.world, 1);
  fire_due(s.world, 2);
  remove(s.world, ball);
  fire_due(s.world, 3);
  CHECK(told == 2);
  REQUIRE(s.world.log.size() == 1);
  CHECK_THAT(s.world.log[0].text, Contains("event scene.lua:7, due at 0 s") && Contains("was removed at"));
}

TEST_CASE("a play goes on at exact times, when something holds, and in the next step") {
  Scene s;
  bool ready = false;
  int part = 0;
  Event e;
  e.kind = EventKind::play;
  e.goes = [&]() -> std::optional<Wait> {
    s.done.push_back(std::to_string(part));
    switch (part++) {
      case 0: return Wait{0.1, {}};
      case 1: return Wait{0.1, {}};
      case 2: return Wait{0.0, [&] { return ready; }};
      case 3: return Wait{};
      default: return {};
    }
  };
  const EventId id = add_event(s.world, e);
  const auto state = s.world.choreography.events[id].state;
  s.add(0.15, "between");
  fire_due(s.world, 1);
  CHECK(s.done == std::vector<std::string>{"0", "1", "between", "2"});
  fire_due(s.world, 2);
  CHECK(s.done.size() == 4);
  ready = true;
  fire_due(s.world, 3);
  CHECK(s.done.back() == "3");
  fire_due(s.world, 4);
  CHECK(s.done.back() == "4");
  CHECK(*state == EventState::fired);
  CHECK(s.world.choreography.heap.empty());
}

TEST_CASE("a play that fails is over, and the rest goes on") {
  Scene s;
  Event e;
  e.kind = EventKind::play;
  e.goes = []() -> std::optional<Wait> { throw Error("oh"); };
  const EventId id = add_event(s.world, e);
  const auto state = s.world.choreography.events[id].state;
  s.add(1, "good");
  CHECK_THROWS_WITH(fire_due(s.world, 1), "oh");
  CHECK(*state == EventState::dropped);
  fire_due(s.world, 1);
  CHECK(s.done == std::vector<std::string>{"good"});
}

TEST_CASE("of two events that contradict each other the earlier added is carried out first") {
  for (const bool remove_first : {true, false}) {
    Scene s;
    const ParticleId ball = add_particle(s.world, {});
    const PointId point = s.world.particles[ball].points[0];
    std::vector<Event> two(2);
    two[0].label = "removal";
    two[0].action = [&] { remove(s.world, ball); };
    two[1].label = "change";
    two[1].action = [&] {
      set_mass(s.world, point, 3.0);
      s.done.push_back("changed");
    };
    if (!remove_first) std::swap(two[0], two[1]);
    for (Event& e : two) {
      e.time = 1.0;
      e.target = ball;
      add_event(s.world, e);
    }
    fire_due(s.world, 1);
    CHECK_FALSE(s.world.particles.alive(ball));
    CHECK(s.done.size() == (remove_first ? 0 : 1));
    CHECK(s.world.log.size() == (remove_first ? 1 : 0));
  }
}

TEST_CASE("the timeline tells what was, is and will be, and does not grow") {
  Scene s;
  for (int i = 0; i < 3000; i++) s.add(1.0, "past");
  s.add(7.0, "far");
  s.add(5.0, "near", 2.0);
  fire_due(s.world, 1.0);
  s.world.time = 1.0;
  const std::vector<TimelineEntry> list = timeline(s.world);
  REQUIRE(list.size() == most_told + 2);
  CHECK(list[0].state == EventState::fired);
  CHECK(list[most_told].label == "near");
  CHECK(list[most_told].time == 5.0);
  CHECK(list[most_told].period == 2.0);
  CHECK(list[most_told + 1].label == "far");
  for (int i = 0; i < 3000; i++) s.add(10.0, "coming");
  CHECK(timeline(s.world).size() == 2 * most_told);
}

TEST_CASE("bad overs, conditions and repetitions are errors") {
  Scene s;
  Event e = s.event(1, "over");
  e.kind = EventKind::over;
  e.progress = [](double) {};
  e.until = 1.0;
  CHECK_THROWS_WITH(add_event(s.world, e), Contains("its end must be after its beginning at 1 s"));
  Event when = s.event(0, "when");
  when.kind = EventKind::when;
  CHECK_THROWS_WITH(add_event(s.world, when), Contains("nothing to measure"));
  when.condition.measure = [] { return 0.0; };
  when.condition.mean = -1.0;
  CHECK_THROWS_WITH(add_event(s.world, when), Contains("mean must be >= 0 s"));
  CHECK(s.world.choreography.events.empty());
}
