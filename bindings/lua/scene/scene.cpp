#include "lua/scene/scene.hpp"

#include "base/parallel.hpp"

#include <algorithm>
#include <filesystem>

#include "lua/library/sandbox.hpp"
#include "lua/scene/carry_tables.hpp"
#include "lua/scene/events.hpp"
#include "lua/scene/parameters.hpp"
#include "lua/scene/scene_type.hpp"
#include "lua/scene/snapshot.hpp"
#include "lua/thing/script.hpp"
#include "scene/files.hpp"
#include "step/step.hpp"

namespace pantin::lua {

Script::Script(const SceneOptions& given)
    : ScriptHost{given, Runtime({given.script_limit, given.memory_limit}, sandbox)} {
  world.workers = std::make_unique<Workers>(options.threads);
  runtime.random = &world.random;
  runtime.home = given.home;
  if (given.read) runtime.reader = given.read;
  runtime.on_read = given.on_read;
  world.random = Random{world.settings.seed, 0};
  world.behaviours = [this] { run_behaviours(*this); };
  world.who = [] {
    const Runtime* running = Runtime::current();
    return running ? where(running->active()) : std::string{};
  };
}

void step_scene(Script& script) {
  restore_wanted(script);
  keep_start(script);
  script.drawings.clear();
  step(script.world);
  restore_wanted(script);
}

struct Scene::State {
  Script script;
};

Scene::Scene(std::unique_ptr<State> state) : state_(std::move(state)) {}
Scene::~Scene() = default;

std::unique_ptr<Scene> Scene::open(const std::string& path, const SceneOptions& options) {
  const auto source = options.read ? options.read(path) : file_content(path);
  if (!source) {
    std::error_code error;
    const bool there = std::filesystem::exists(path, error);
    throw UsageError(text(path, ": ", there ? "cannot be read as a file" : "there is no such file"));
  }
  if (options.on_read) options.on_read({path, *source});
  const std::filesystem::path file(path);
  return open_text(*source, file.filename(), file.parent_path(), options);
}

std::unique_ptr<Scene> Scene::open_text(const std::string& source, const std::string& name, const std::string& folder,
                                        const SceneOptions& options) {
  const Outside outside;
  std::unique_ptr<Scene> scene(new Scene(std::unique_ptr<State>(new State{Script(options)})));
  Script& script = scene->state_->script;
  script.runtime.folder = folder;
  script.runtime.run([&](lua_State* state) { open_globals(state, script); });
  apply_settings(script);
  script.runtime.run([&](lua_State* state) {
    script.runtime.load(state, source, name);
    lua_call(state, 0, 0);
  });
  if (options.changing) script.made = made(script.world);
  if (!options.forgiving) check_parameters_known(script);
  return scene;
}

World& Scene::world() { return state_->script.world; }
const World& Scene::world() const { return state_->script.world; }

void Scene::step() {
  const Outside outside;
  step_scene(state_->script);
}

const std::string& Scene::title() const { return state_->script.title; }
std::optional<double> Scene::duration() const { return state_->script.duration; }
double Scene::pace() const { return state_->script.pace; }
CameraWish Scene::camera() const {
  const Script& script = state_->script;
  return {script.camera_at, script.camera_look_at, script.camera_follow};
}
bool Scene::finished() const { return state_->script.finished; }
const std::vector<SceneParameter>& Scene::parameters() const { return state_->script.parameters; }
bool Scene::set_parameter(const std::string& name, const SceneValue& value) {
  const Outside outside;
  return change_parameter(state_->script, name, value);
}
std::vector<std::string> Scene::keys() const {
  std::vector<std::string> keys;
  for (const Subscription& s : state_->script.subscriptions)
    if (s.function && !s.key.empty()) keys.push_back(s.key);
  return keys;
}

const std::vector<std::string>& Scene::buttons() const { return state_->script.buttons; }
const std::map<std::string, SceneValue>& Scene::results() const { return state_->script.results; }

namespace {

std::vector<std::string> texts(const std::vector<LogLine>& log, std::string_view kind) {
  std::vector<std::string> texts;
  for (const LogLine& line : log)
    if (line.kind == kind) texts.push_back(line.text);
  return texts;
}

}  // namespace

std::vector<std::string> Scene::notices() const { return texts(world().log, "notice"); }

std::vector<std::string> Scene::warnings() const {
  std::vector<std::string> warnings = texts(world().log, "warning");
  const auto& log = world().log;
  const auto is_dropped = [](const LogLine& line) { return line.kind == "dropped"; };
  const auto first = std::find_if(log.begin(), log.end(), is_dropped);
  const auto count = std::count_if(log.begin(), log.end(), is_dropped);
  if (count == 1) warnings.push_back("1 event was dropped: " + first->text);
  if (count > 1) warnings.push_back(text(count, " events were dropped, the first: ", first->text));
  return warnings;
}

const std::vector<Drawing>& Scene::drawings() const { return state_->script.drawings; }
std::shared_ptr<const SceneSnapshot> Scene::take_snapshot() { return lua::take_snapshot(state_->script); }
void Scene::restore(const SceneSnapshot& snapshot) {
  const Outside outside;
  lua::restore(state_->script, snapshot);
}
std::string Scene::why_not_restore() const { return pantin::why_not_restore(world()); }

CarriedOver Scene::go_on_from(Scene& old) {
  const Outside outside;
  Script &from = old.script(), &to = state_->script;
  keep_start(to);
  CarriedOver carried = carry_over(from.world, from.made, to.world, to.made);
  carry_tables(from, to, carried.things);
  return carried;
}

Script& Scene::script() { return state_->script; }

}  // namespace pantin::lua
