#include "lua/scene/choreography.hpp"

#include "choreography/choreography.hpp"
#include "fields/measures.hpp"
#include "lua/thing/fields.hpp"
#include "lua/thing/script.hpp"
#include "lua/thing/script_functions.hpp"
#include "lua/thing/targets.hpp"
#include "lua/value/arguments.hpp"
#include "lua/vm/guard.hpp"

namespace pantin::lua {
namespace {

/// `[target,] action`, from `index` on; returns the index after them.
int take_action(lua_State* state, int index, const char* call, Script& script, Event& event) {
  const bool with_target = !lua_isfunction(state, index);
  if (with_target)
    event.target = check_thing(state, index, call, argument(index - 1) + ", the target or action,").thing;
  if (with_target) index++;
  const Callback function = check_function(state, index, call, argument(index - 1) + ", the action,");
  event.label = where(state);
  event.action = CalledAction{function, &script, event.target};
  event.progress = CalledProgress{function, &script, event.target};
  return index + 1;
}

/// Throws Error where something is given from `index` on, behind all that the call takes.
void require_end(lua_State* state, int index, const char* call, const char* last) {
  require(lua_isnoneornil(state, index), call, ": ", last, " comes last, got ", kind_of_value(state, index),
          " after it");
}

int put(lua_State* state, const Self& self, Event event) {
  push_event(state, self.script, add_event(self.world, std::move(event)));
  return 1;
}

double check_time(lua_State* state, int index, const char* call, const char* name) {
  const double time = check_number(state, index, call, argument(index - 1) + ", the " + name + ",", "s");
  require(time >= 0, call, ": ", argument(index - 1), ", the ", name, ", must be >= 0 s, got ", time);
  return time;
}

void require_coming(const World& world, const char* call, double time) {
  require(with_round_off(time) >= world.time, call, ": argument 1, the time, must not be past: got ", time,
          " s, and it is ", world.time, " s now");
}

int cancel_event(lua_State* state) {
  const Self self = check_self(state, Kind::event, "cancel");
  cancel(self.world, self.ref.id<EventId>());
  return 0;
}

}  // namespace

int scene_at(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "at");
  Event event;
  event.time = check_time(state, 2, "at", "time");
  require_coming(self.world, "at", event.time);
  require_end(state, take_action(state, 3, "at", self.script, event), "at", "its action");
  return put(state, self, std::move(event));
}

int scene_after(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "after");
  Event event;
  event.time = self.world.time + check_time(state, 2, "after", "delay");
  require_end(state, take_action(state, 3, "after", self.script, event), "after", "its action");
  return put(state, self, std::move(event));
}

int scene_every(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "every");
  Event event;
  event.kind = EventKind::every;
  event.time = self.world.time;
  event.period = check_number(state, 2, "every", "argument 1, the period,", "s");
  require(event.period > 0, "every: argument 1, the period, must be > 0 s, got ", event.period);
  require_end(state, take_action(state, 3, "every", self.script, event), "every", "its action");
  return put(state, self, std::move(event));
}

int scene_over(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "over");
  Event event;
  event.kind = EventKind::over;
  event.time = check_time(state, 2, "over", "beginning");
  event.until = check_time(state, 3, "over", "end");
  require_coming(self.world, "over", event.time);
  require(event.until > event.time, "over: argument 2, the end, must be after the beginning at ", event.time,
          " s, got ", event.until, " s");
  require_end(state, take_action(state, 4, "over", self.script, event), "over", "its action");
  return put(state, self, std::move(event));
}

int scene_when(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "when");
  Event event;
  event.kind = EventKind::when;
  const int options = take_action(state, 3, "when", self.script, event);
  require_end(state, options + 1, "when", "its table of options");
  event.condition = check_condition(state, 2, options, self.script);
  return put(state, self, std::move(event));
}

int scene_play(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "play");
  Event event;
  event.kind = EventKind::play;
  event.time = self.world.time;
  const int after = take_action(state, 2, "play", self.script, event);
  require_end(state, after, "play", "its script");
  event.goes = play_of(state, after - 1, self.script, event.target);
  return put(state, self, std::move(event));
}

const Type& event_type() {
  static const Type type = {
      "Event",
      "event",
      "Something set to happen.",
      {{"state", "string", "", "\"waiting\", \"fired\", \"dropped\" or \"cancelled\"",
        [](const Self& s) { lua_pushstring(s.state, fields::name_of(state_of_event(s.ref))); }, nullptr}},
      {{"cancel", guard<cancel_event>, "", "", "Takes it out of the choreography; one that fired stays as it is.",
        "local alarm = scene:at(5, function() print(\"late\") end)\n"
        "alarm:cancel()"}}};
  return type;
}

}  // namespace pantin::lua
