#include "lua/events.hpp"

#include <algorithm>

#include "lua/arguments.hpp"
#include "lua/fields.hpp"
#include "lua/guard.hpp"
#include "lua/script.hpp"
#include "lua/targets.hpp"
#include "lua/tie_options.hpp"
#include "world/choreography.hpp"
#include "world/hands.hpp"

namespace pantin::lua {
namespace {

/// What the engine calls when the event is due. A removed thing ends this action only.
std::function<void()> action_of(Script& script, Callback function, AnyId target) {
  return [&script, function = std::move(function), target] {
    try {
      function.call([&](lua_State* state) {
        if (std::holds_alternative<std::monostate>(target)) return 0;
        push_thing(state, script, target);
        return 1;
      });
    } catch (const StaleHandle& error) { log_line(script.world, "dropped", error.what()); }
  };
}

/// `(time, [target,] action)`, from argument 2 of the call on.
int add(lua_State* state, const char* call, const char* time_name, bool relative, bool repeats) {
  const Self self = check_self(state, Kind::scene, call);
  const double time = check_number(state, 2, call, text("argument 1, the ", time_name, ","), "s");
  require(repeats ? time > 0 : time >= 0, call, ": argument 1, the ", time_name, ", must be ",
          repeats ? ">" : ">=", " 0 s, got ", time);
  const bool with_target = !lua_isfunction(state, 3);
  Event event;
  if (with_target) event.target = any_of(check_thing(state, 3, call, "argument 2, the target or action,"));
  const Callback function = check_function(state, with_target ? 4 : 3, call,
                                           with_target ? "argument 3, the action," : "argument 2, the action,");
  event.first = relative || repeats ? self.world.time + time : time;
  if (!relative && !repeats) event.first = std::max(event.first, self.world.time);
  event.period = repeats ? time : 0.0;
  event.action = action_of(self.script, function, event.target);
  event.label = where(state);
  push_event(state, self.script, add_event(self.world, std::move(event)));
  return 1;
}

int cancel_event(lua_State* state) {
  const Self self = check_self(state, Kind::event, "cancel");
  cancel(self.world, self.ref.id<EventId>());
  return 0;
}

/// Drops what was cancelled once it is most of the list.
void tidy(Script& script) {
  if (script.telling > 0 || 2 * script.cancelled <= script.subscriptions.size() + 64) return;
  std::erase_if(script.subscriptions, [](const Subscription& s) { return !s.function; });
  script.cancelled = 0;
}

int cancel_subscription(lua_State* state) {
  const Self self = check_self(state, Kind::subscription, "cancel");
  auto& list = self.script.subscriptions;
  const auto found = std::lower_bound(list.begin(), list.end(), self.ref.serial,
                                      [](const Subscription& s, std::uint64_t serial) { return s.serial < serial; });
  if (found == list.end() || found->serial != self.ref.serial || !found->function) return 0;
  found->function.reset();
  self.script.cancelled++;
  tidy(self.script);
  return 0;
}

const char* const moments[] = {"step", "press", "release", "key", "grab", "drop", "cut", "broke", "removed"};

const char* name_of(Notice::Kind kind) {
  switch (kind) {
    case Notice::Kind::removed: return "removed";
    case Notice::Kind::cut: return "cut";
    case Notice::Kind::broke: return "broke";
    case Notice::Kind::grab: return "grab";
    case Notice::Kind::drop: return "drop";
    case Notice::Kind::press: return "press";
    case Notice::Kind::release: return "release";
    case Notice::Kind::key: return "key";
    case Notice::Kind::button: break;
  }
  return "button";
}

/// The arguments of a callback for a notice; returns how many.
int push_notice(lua_State* state, Script& script, const Notice& notice) {
  switch (notice.kind) {
    case Notice::Kind::press:
    case Notice::Kind::release: push_hand(state, script, notice.hand); return 1;
    case Notice::Kind::key: lua_pushlstring(state, notice.text.data(), notice.text.size()); return 1;
    case Notice::Kind::grab:
    case Notice::Kind::drop:
      push_thing(state, script, notice.thing);
      push_hand(state, script, notice.hand);
      return 2;
    case Notice::Kind::cut: push_thing(state, script, notice.thing); return 1;
    case Notice::Kind::broke:
      push_thing(state, script, notice.thing);
      lua_pushnumber(state, notice.force);
      lua_pushlstring(state, notice.text.data(), notice.text.size());
      return 3;
    case Notice::Kind::removed:
      push_thing(state, script, notice.thing);
      lua_pushlstring(state, notice.text.data(), notice.text.size());
      return 2;
    case Notice::Kind::button: break;
  }
  return 0;
}

/// Keeps the subscriptions in their places while it lives.
struct Telling {
  explicit Telling(Script& s) : script(s) { script.telling++; }
  ~Telling() { script.telling--; }
  Telling(const Telling&) = delete;
  Telling& operator=(const Telling&) = delete;
  Script& script;
};

/// Calls those who wait for a moment, in the order of asking; those who ask meanwhile wait for the next.
void tell(Script& script, std::string_view moment, const std::function<int(lua_State*)>& push) {
  {
    const Telling telling(script);
    for (std::size_t i = 0, count = script.subscriptions.size(); i < count; i++) {
      if (script.subscriptions[i].name != moment) continue;
      const std::optional<Callback> function = script.subscriptions[i].function;
      if (function) function->call(push);
    }
  }
  tidy(script);
}

}  // namespace

int scene_at(lua_State* state) { return add(state, "at", "time", false, false); }
int scene_after(lua_State* state) { return add(state, "after", "delay", true, false); }
int scene_every(lua_State* state) { return add(state, "every", "period", false, true); }

int scene_on(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "on");
  const std::vector<std::string> names(std::begin(moments), std::end(moments));
  const std::string name = check_text(state, 2, "on", "argument 1, the moment,");
  require(std::find(names.begin(), names.end(), name) != names.end(), "on: unknown moment '", name, "'.",
          suggestion(name, names), " Known are ", joined(names));
  const Callback function = check_function(state, 3, "on", "argument 2");
  const std::uint64_t serial = ++self.script.subscribed;
  self.script.subscriptions.push_back({serial, name, function});
  push_ref(state, {Tag::ref, Kind::subscription, static_cast<std::uint32_t>(serial),
                   static_cast<std::uint32_t>(serial >> 32), serial, &self.script});
  return 1;
}

int scene_button(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "button");
  const std::string name = check_text(state, 2, "button", "argument 1, the name,");
  const Callback function = check_function(state, 3, "button", "argument 2");
  Script& script = self.script;
  if (!script.button_functions.contains(name)) script.buttons.push_back(name);
  script.button_functions.insert_or_assign(name, function);
  return 0;
}

int scene_probe(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "probe");
  const std::string name = check_text(state, 2, "probe", "argument 1, the name,");
  const Callback function = check_function(state, 3, "probe", "argument 2");
  require(!self.world.locked,
          "probe: probes cannot be added while the world steps; add them in an event or a step callback");
  for (const Probe& probe : self.world.probes)
    require(probe.name != name, "probe: there is a probe '", name, "' already");
  self.world.probes.push_back(
      {name, [function, name] { return function.number(text("probe '", name, "'")); }, {}, self.world.steps});
  return 0;
}

int scene_hand(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "hand");
  const Options o(state, 2, "hand", {"path"});
  std::function<Vec3(double)> path;
  if (const auto function = o.function("path")) path = place_of_time(*function, "hand: path");
  push_hand(state, self.script, add_hand(self.world, std::move(path)));
  return 1;
}

void run_behaviours(Script& script) {
  const std::size_t known = script.world.notices.size();  // callbacks may add more, for the next step
  for (std::size_t i = 0; i < known; i++) {
    const Notice notice = script.world.notices[i];
    if (notice.kind == Notice::Kind::button) {
      const auto found = script.button_functions.find(notice.text);
      if (found == script.button_functions.end()) continue;
      const Callback function = found->second;
      function.call();
    } else {
      tell(script, name_of(notice.kind), [&](lua_State* state) { return push_notice(state, script, notice); });
    }
  }
  recheck_laws(script);
  tell(script, "step", [&](lua_State* state) {
    lua_pushnumber(state, script.world.settings.step);
    return 1;
  });
}

const Type& event_type() {
  static const Type type = {
      "Event",
      "event",
      "Something set to happen.",
      {{"state", "string", "", "\"waiting\", \"fired\", \"dropped\" or \"cancelled\"",
        [](const Self& s) {
          const char* const names[] = {"waiting", "fired", "dropped", "cancelled"};
          lua_pushstring(s.state, names[static_cast<std::size_t>(state_of_event(s.ref))]);
        },
        nullptr}},
      {{"cancel", guard<cancel_event>, "", "", "Takes it out of the choreography; one that fired stays as it is."}}};
  return type;
}

const Type& subscription_type() {
  static const Type type = {"Subscription",
                            "subscription",
                            "A function that scene:on calls.",
                            {},
                            {{"cancel", guard<cancel_subscription>, "", "", "The function is called no more."}}};
  return type;
}

}  // namespace pantin::lua
