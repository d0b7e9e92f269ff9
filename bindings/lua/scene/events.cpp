#include "lua/scene/events.hpp"

#include <algorithm>
#include <utility>

#include "choreography/hands.hpp"
#include "contacts/touching.hpp"
#include "lua/scene/layers.hpp"
#include "lua/scene/sounds.hpp"
#include "lua/thing/fields.hpp"
#include "lua/thing/point_constraint_options.hpp"
#include "lua/thing/script.hpp"
#include "lua/thing/script_functions.hpp"
#include "lua/thing/targets.hpp"
#include "lua/value/arguments.hpp"
#include "lua/vm/guard.hpp"
#include "scene/controls.hpp"

namespace pantin::lua {
namespace {

/// Drops what was cancelled once it is most of the list.
void tidy(Script& script) {
  if (script.telling > 0 || 2 * script.cancelled <= script.subscriptions.size() + 64) return;
  std::erase_if(script.subscriptions, [](const Subscription& s) { return !s.function; });
  script.cancelled = 0;
}

void end_subscription(Script& script, std::size_t index) {
  Subscription& subscription = script.subscriptions[index];
  const std::optional<Callback> stop = std::exchange(subscription.stop, {});
  subscription.function.reset();
  script.cancelled++;
  if (stop) stop->call();
}

int cancel_subscription(lua_State* state) {
  const Self self = check_self(state, Kind::subscription, "cancel");
  auto& list = self.script.subscriptions;
  const auto found = std::lower_bound(list.begin(), list.end(), self.ref.serial,
                                      [](const Subscription& s, std::uint64_t serial) { return s.serial < serial; });
  if (found == list.end() || found->serial != self.ref.serial || !found->function) return 0;
  end_subscription(self.script, static_cast<std::size_t>(found - list.begin()));
  tidy(self.script);
  return 0;
}

const char* const moments[] = {"step", "press", "release", "key",     "key_up",  "grab",  "drop",
                               "cut",  "broke", "joined",  "removed", "touched", "parted"};

const char* name_of(Notice::Kind kind) {
  switch (kind) {
    case Notice::Kind::removed: return "removed";
    case Notice::Kind::cut: return "cut";
    case Notice::Kind::broke: return "broke";
    case Notice::Kind::joined: return "joined";
    case Notice::Kind::grab: return "grab";
    case Notice::Kind::drop: return "drop";
    case Notice::Kind::press: return "press";
    case Notice::Kind::release: return "release";
    case Notice::Kind::key: return "key";
    case Notice::Kind::key_up: return "key_up";
    case Notice::Kind::touched: return "touched";
    case Notice::Kind::parted: return "parted";
    case Notice::Kind::button: break;
  }
  return "button";
}

/// The arguments of a callback for a notice; returns how many.
int push_notice(lua_State* state, Script& script, const Notice& notice) {
  switch (notice.kind) {
    case Notice::Kind::press:
    case Notice::Kind::release: push_hand(state, script, notice.hand); return 1;
    case Notice::Kind::key:
    case Notice::Kind::key_up: lua_pushlstring(state, notice.text.data(), notice.text.size()); return 1;
    case Notice::Kind::grab:
    case Notice::Kind::drop:
      push_thing(state, script, notice.thing);
      push_hand(state, script, notice.hand);
      return 2;
    case Notice::Kind::cut:
    case Notice::Kind::joined: push_thing(state, script, notice.thing); return 1;
    case Notice::Kind::broke:
      push_thing(state, script, notice.thing);
      lua_pushnumber(state, notice.force);
      lua_pushlstring(state, notice.text.data(), notice.text.size());
      return 3;
    case Notice::Kind::removed:
      push_thing(state, script, notice.thing);
      lua_pushlstring(state, notice.text.data(), notice.text.size());
      return 2;
    case Notice::Kind::touched:
    case Notice::Kind::parted:
    case Notice::Kind::button: break;
  }
  return 0;
}

/// Whether a thing is what a filter names, or in it.
bool is_among(const World& world, const AnyId& filter, const AnyId& thing) {
  if (filter == thing) return true;
  const auto* particle = std::get_if<ParticleId>(&thing);
  if (const auto* family = std::get_if<FamilyId>(&filter))
    return particle && world.particles.alive(*particle) && world.particles[*particle].family == *family;
  const auto* group = std::get_if<GroupId>(&filter);
  if (!group || !world.groups.alive(*group)) return false;
  const auto& members = world.groups[*group].members;
  return std::any_of(members.begin(), members.end(), [&](const AnyId& one) { return is_among(world, one, thing); });
}

bool has_layer(const World& world, const std::string& layer, const AnyId& thing) {
  const auto is = [&](std::uint32_t number) { return number > 0 && world.layers.names[number - 1] == layer; };
  const auto is_in = [&](ShapeId id) { return is(world.shapes[id].layer); };
  if (!alive(world, thing)) return false;
  if (const auto* shape = std::get_if<ShapeId>(&thing)) return is_in(*shape);
  if (const auto* particle = std::get_if<ParticleId>(&thing)) {
    const FamilyId family = world.particles[*particle].family;
    return family && world.families[family].solid && is(world.families[family].solid->layer);
  }
  const auto& shapes = world.bodies[std::get<BodyId>(thing)].shapes;
  return std::any_of(shapes.begin(), shapes.end(), is_in);
}

bool names(const World& world, const Subscription& filter, const AnyId& thing) {
  if (!filter.layer.empty()) return has_layer(world, filter.layer, thing);
  return std::holds_alternative<std::monostate>(filter.target) || is_among(world, filter.target, thing);
}

/// Pushes { a, b, … }; what a filter names is a.
int push_touch(lua_State* state, Script& script, const Notice& notice, bool turned) {
  const Touch& touch = notice.touch;
  const AnyId first = touch.pair.a, second = touch.pair.b;
  lua_createtable(state, 0, 7);
  const auto set = [&](const char* name, const AnyId& thing) {
    push_thing(state, script, thing);
    lua_setfield(state, -2, name);
  };
  set("a", turned ? second : first);
  set("b", turned ? first : second);
  if (notice.kind == Notice::Kind::parted) return 1;
  push(state, touch.at);
  lua_setfield(state, -2, "at");
  push(state, turned ? -touch.normal : touch.normal);
  lua_setfield(state, -2, "normal");
  lua_pushnumber(state, touch.impulse);
  lua_setfield(state, -2, "impulse");
  lua_pushnumber(state, touch.speed);
  lua_setfield(state, -2, "speed");
  if (touch.heat) {
    lua_pushnumber(state, *touch.heat);
    lua_setfield(state, -2, "heat");
  }
  return 1;
}

/// Keeps the subscriptions in their places while it lives.
struct Telling {
  explicit Telling(Script& s) : script(s) { script.telling++; }
  ~Telling() { script.telling--; }
  Telling(const Telling&) = delete;
  Telling& operator=(const Telling&) = delete;
  Script& script;
};

/// Calls those who wait for a moment, and whom it concerns, in the order of asking; those who ask meanwhile wait for the next.
void tell(Script& script, std::string_view moment, const std::function<bool(const Subscription&)>& concerns,
          const std::function<int(lua_State*)>& push) {
  {
    const Telling telling(script);
    for (std::size_t i = 0, count = script.subscriptions.size(); i < count; i++) {
      if (script.subscriptions[i].name != moment) continue;
      if (concerns && !concerns(script.subscriptions[i])) continue;
      const std::optional<Callback> function = script.subscriptions[i].function;
      const AnyId target = script.subscriptions[i].target;
      if (!function) continue;
      if (std::holds_alternative<std::monostate>(target) || alive(script.world, target))
        function->call(push);
      else
        end_subscription(script, i);
    }
  }
  tidy(script);
}

}  // namespace

int subscribe(lua_State* state, Script& script, Subscription subscription) {
  const std::uint64_t serial = ++script.subscribed;
  subscription.serial = serial;
  script.subscriptions.push_back(std::move(subscription));
  push_ref(state, make_ref(script, Kind::subscription, static_cast<std::uint32_t>(serial),
                           static_cast<std::uint32_t>(serial >> 32), serial));
  return 1;
}

namespace {

/// Why a thing never touches as it is; empty: it may.
std::string why_untouched(const World& world, const AnyId& thing) {
  const auto is_solid = [&](FamilyId family) { return family && world.families[family].solid; };
  if (const auto* body = std::get_if<BodyId>(&thing); body && world.bodies[*body].shapes.empty()) return "has no shape";
  if (const auto* family = std::get_if<FamilyId>(&thing); family && !is_solid(*family)) return "is not solid";
  const auto* particle = std::get_if<ParticleId>(&thing);
  return particle && !is_solid(world.particles[*particle].family) ? "is of no solid family" : "";
}

/// `[filter,] action`: a body, a particle, a floor or ground, a group of these, a family, or the name of a layer.
int subscribe_touch(lua_State* state, const Self& self, const std::string& name) {
  Subscription subscription{0, name, {}};
  int action = 3;
  if (!lua_isfunction(state, 3)) {
    action = 4;
    const char* filter = "argument 2, the filter or action,";
    if (lua_type(state, 3) == LUA_TSTRING) {
      subscription.layer = check_text(state, 3, "on", filter);
      require(!subscription.layer.empty(), "on: ", filter, " must not be an empty layer");
      speak_of_layer(self.script, state, "on", subscription.layer);
    } else {
      const Ref* ref = to_ref(state, 3);
      constexpr std::array kinds = {Kind::body, Kind::particle, Kind::collider, Kind::group, Kind::family};
      require(ref && std::find(kinds.begin(), kinds.end(), ref->kind) != kinds.end(), "on: ", filter,
              " must be a body, a particle, a floor or ground, a group of these, a family or the name of a layer, got ",
              kind_of_value(state, 3));
      require_alive(*ref);
      subscription.target = ref->thing;
      if (ref->kind == Kind::collider)
        require(!self.world.shapes[ref->id<ShapeId>()].body, "on: ", filter,
                " is a shape of a body; bodies are told of, so name that one");
      if (const std::string why = why_untouched(self.world, ref->thing); !why.empty())
        log_line(
            self.world, "warning",
            text(where(state), ": on: ", describe(self.world, ref->thing), " ", why, ", so that nothing touches it"));
    }
  }
  require(lua_isnoneornil(state, action + 1), "on: the filter comes before the function, scene:on(\"", name,
          "\", filter, function(touch) … end)");
  subscription.function = check_function(state, action, "on", argument(action - 1));
  return subscribe(state, self.script, std::move(subscription));
}

void tell_touch(Script& script, const Notice& notice) {
  const World& world = script.world;
  bool turned = false;
  const auto concerns = [&](const Subscription& s) {
    turned = !names(world, s, notice.touch.pair.a);
    return !turned || names(world, s, notice.touch.pair.b);
  };
  tell(script, name_of(notice.kind), concerns,
       [&](lua_State* state) { return push_touch(state, script, notice, turned); });
}

/// Who touches whom is only watched while somebody listens.
void watch_touch(Script& script) {
  const auto listens = [&](const Subscription& s) {
    const bool ended = !std::holds_alternative<std::monostate>(s.target) && !alive(script.world, s.target);
    return s.function && !ended && (s.name == "touched" || s.name == "parted");
  };
  const auto& list = script.subscriptions;
  const bool heard = !script.contact_sounds.empty();
  watch(script.world, script.world.contacts, heard || std::any_of(list.begin(), list.end(), listens));
}

}  // namespace

int scene_on(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "on");
  const std::vector<std::string> names(std::begin(moments), std::end(moments));
  const std::string name = check_text(state, 2, "on", "argument 1, the moment,");
  require(std::find(names.begin(), names.end(), name) != names.end(), "on: unknown moment '", name, "'.",
          suggestion(name, names), " Known are ", joined(names));
  if (name == "touched" || name == "parted") return subscribe_touch(state, self, name);
  const bool of_keys = name == "key" || name == "key_up";
  const bool one_key = of_keys && lua_type(state, 3) == LUA_TSTRING;
  require(lua_isnoneornil(state, one_key ? 5 : 4), "on: the function comes last, scene:on(\"", name,
          one_key ? "\", key, function" : "\", function", "() … end), got ", kind_of_value(state, one_key ? 5 : 4),
          " after it");
  if (!one_key) return subscribe(state, self.script, {0, name, check_function(state, 3, "on", "argument 2")});
  std::string key = check_text(state, 3, "on", "argument 2, the key,");
  if (name == "key" && !key.starts_with(pad_prefix))
    key = check_key(key);
  else
    self.script.controls.insert(key = check_control(key));
  return subscribe(state, self.script, {0, name, check_function(state, 4, "on", "argument 3"), {}, {}, key});
}

int scene_button(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "button");
  const std::string name = check_name(state, 2, "button");
  const Callback function = check_function(state, 3, "button", "argument 2");
  Script& script = self.script;
  if (!script.button_functions.contains(name)) script.buttons.push_back(name);
  script.button_functions.insert_or_assign(name, function);
  return 0;
}

int scene_probe(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "probe");
  const std::string name = check_name(state, 2, "probe");
  require(name != "time", "probe: argument 1, the name, must not be 'time', which is the first column of each table");
  const Callback function = check_function(state, 3, "probe", "argument 2");
  require(!self.world.locked,
          "probe: probes cannot be added while the world steps; add them in an event or a step callback");
  for (const Probe& probe : self.world.probes)
    require(probe.name != name, "probe: there is a probe '", name, "' already");
  self.world.probes.push_back({name, CalledProbe{function, name}, {}, self.world.steps});
  return 0;
}

int scene_hand(lua_State* state) {
  const Self self = check_self(state, Kind::scene, "hand");
  const Options o(state, 2, "hand", {"path"});
  std::function<Vec3(double)> path;
  if (const auto function = o.function("path")) path = position_of_time(*function, "hand: path");
  push_hand(state, self.script, add_hand(self.world, std::move(path)));
  return 1;
}

void run_behaviours(Script& script) {
  const std::size_t known = script.world.notices.size();  // callbacks may add more, for the next step
  for (std::size_t i = 0; i < known; i++) {
    const Notice notice = script.world.notices[i];
    script.told_of = notice.thing;
    if (notice.kind == Notice::Kind::button) {
      const auto found = script.button_functions.find(notice.text);
      if (found == script.button_functions.end()) continue;
      const Callback function = found->second;
      function.call();
    } else if (notice.kind == Notice::Kind::touched || notice.kind == Notice::Kind::parted) {
      if (notice.kind == Notice::Kind::touched) sound_touch(script, notice.touch);
      tell_touch(script, notice);
    } else {
      const auto concerns = [&](const Subscription& s) { return s.key.empty() || s.key == notice.text; };
      tell(script, name_of(notice.kind), concerns,
           [&](lua_State* state) { return push_notice(state, script, notice); });
    }
  }
  script.told_of = {};
  tell(script, "step", {}, [&](lua_State* state) {
    lua_pushnumber(state, script.world.settings.step);
    return 1;
  });
  watch_touch(script);
  recheck_laws(script.world, script.laws, script.runtime);
}

const Type& subscription_type() {
  static const Type type = {
      "Subscription",
      "subscription",
      "A function that scene:on calls, or a behaviour.",
      {},
      {{"cancel", guard<cancel_subscription>, "", "", "The function is called no more; a behaviour is stopped.",
        "local listening = scene:on(\"step\", function(dt) print(dt) end)\n"
        "listening:cancel()"}}};
  return type;
}

}  // namespace pantin::lua
