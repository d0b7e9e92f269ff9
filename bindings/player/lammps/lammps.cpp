#include "player/lammps/lammps.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <thread>

#include "forces/forces.hpp"
#include "forces/integrator.hpp"
#include "lua/scene/open.hpp"
#include "player/csv.hpp"
#include "player/home.hpp"
#include "player/interrupt.hpp"
#include "player/lammps/dump.hpp"
#include "player/lammps/folder.hpp"
#include "player/lammps/lmp_process.hpp"
#include "player/lammps/refused.hpp"
#include "player/message.hpp"
#include "player/output.hpp"
#include "player/progress.hpp"
#include "player/run.hpp"
#include "player/saved_state.hpp"
#include "scene/errors.hpp"

namespace fs = std::filesystem;

namespace pantin::player {
namespace {

constexpr double most_steps = 2e9;  // LAMMPS counts those of one run in 32 bits

std::unique_ptr<Scene> open(const LammpsScene& scene) {
  if (scene.path.ends_with(state_ending)) return open_saved(scene.path, "", scene.options);
  return lua::open_scene(scene.path, scene.options);
}

/// What LAMMPS does otherwise than this program.
std::vector<std::string> notes_of(const Scene& scene, const LammpsSystem& system) {
  const World& world = scene.world();
  std::vector<std::string> notes = {"steps are those of velocity Verlet"};
  if (world.settings.integrator != Integrator::verlet || world.settings.accuracy)
    notes.back() += text(", not of scene.integrator = \"", name_of(world.settings.integrator), "\"",
                         world.settings.accuracy ? " with scene.accuracy" : "");
  if (!system.baths.empty())
    notes.emplace_back(
        "a thermostat is fix langevin: of the same rate and temperature, with other noise and splitting");
  for (const auto* list : {&system.pair_tables, &system.bond_tables})
    for (const LammpsTable& t : *list)
      if (const std::string note = "the law " + t.law + " has no energy, here and there: LAMMPS' total is without it";
          !t.has_energy && std::ranges::find(notes, note) == notes.end())
        notes.push_back(note);
  std::map<std::string, std::pair<double, double>> inner;  // of each law how far off it is, below what distance
  for (const auto* list : {&system.pair_tables, &system.bond_tables})
    for (const LammpsTable& t : *list) {
      if (t.table.inner_error == 0.0) continue;
      auto& [error, below] = inner[t.law];
      error = std::max(error, t.table.inner_error), below = std::max(below, t.table.good_from);
    }
  for (const auto& [law, off] : inner)
    notes.push_back(text("the table of ", law, " is off by up to ", rounded(off.first), " below ", rounded(off.second),
                         " m, nearer than anything is now"));
  notes.insert(notes.end(), system.notes.begin(), system.notes.end());
  if (!world.probes.empty())
    notes.push_back(text(amount(world.probes.size(), "probe is", "probes are"), " not recorded while LAMMPS runs"));
  if (!system.bodies.empty())
    notes.push_back(text(amount(system.bodies.size(), "rigid body", "rigid bodies"), ", a molecule each"));
  return notes;
}

/// LAMMPS counts how often an atom went round a periodic box from -512 to 511, and then begins anew.
void check_turns(const World& world, const LammpsSystem& system, double seconds, double reserve) {
  if (!world.settings.box) return;
  double fastest = 0.0;
  for (ParticleId id : system.atoms) fastest = std::max(fastest, norm(velocity(world, id)));
  const Vec3 edge = *world.settings.box;
  const double most = 500.0 * std::min({edge[0], edge[1], edge[2]});
  require(
      reserve * fastest * seconds < most, "at ", rounded(fastest), " m/s for ", seconds,
      " s a particle may go round the box more often than the 500 times that LAMMPS counts: let it run in pieces of ",
      rounded(most / (reserve * fastest)), " s or less (--until)");
}

void check_scene(const Scene& scene, double until) {
  const std::vector<std::string> refused = refused_by_lammps(scene, until);
  if (refused.empty()) return;
  for (const LogLine& line : scene.world().log)
    if (line.kind == "warning") say(line.text);
  std::string all = text(scene.file(), " has what LAMMPS cannot be given:");
  for (const std::string& one : refused) all += "\n  " + one;
  throw Error(all);
}

/// Parameters as they are, and fields as the command line sets them.
std::string set_of(const Scene& scene, const LammpsScene& wanted) {
  std::string all;
  const auto add = [&](const std::string& name, const std::string& value) {
    all += text(all.empty() ? "" : ", ", name, '=', value);
  };
  for (const SceneParameter& p : scene.parameters()) {
    const auto* const number = std::get_if<double>(&p.value);
    const auto* const truth = std::get_if<bool>(&p.value);
    add(p.name, number ? number_text(*number) : truth ? (*truth ? "true" : "false") : std::get<std::string>(p.value));
  }
  for (const auto& [name, value] : wanted.options.set)
    if (name.starts_with("scene.")) add(name, value);
  return all.empty() ? "none" : all;
}

/// A scene as LAMMPS is given it.
struct Given {
  std::unique_ptr<Scene> scene;
  LammpsSystem system;
  LammpsTask task;
  PresentForces forces;
  double until = 0.0;  ///< [s]
};

Given give(const LammpsOptions& options, const LammpsScene& wanted) {
  Given given;
  given.scene = open(wanted);
  const World& world = given.scene->world();
  const double until = end_of(*given.scene, wanted.until);
  const double steps = std::round((until - world.time) / world.settings.step);
  if (until < world.time)
    throw UsageError(text("the end, ", until, " s, is before the scene's time, ", world.time, " s"));
  if (steps < 1.0)
    throw UsageError(text("the end, ", until, " s, is less than half a step of ", world.settings.step, " s away from ",
                          world.time, " s"));
  require(steps <= most_steps, "LAMMPS does at most 2e9 steps in a run, and these are ", steps);
  check_scene(*given.scene, until);
  given.system = lammps_system(world, options.error);
  check_turns(world, given.system, steps * world.settings.step, 2.0);
  given.forces = present_forces(world);
  given.until = world.time + steps * world.settings.step;
  given.task.name = given.scene->file();
  given.task.set = set_of(*given.scene, wanted);
  given.task.steps = static_cast<std::uint64_t>(steps);
  given.task.every = std::max<std::uint64_t>(1, given.task.steps / 200);
  given.task.law_energy = given.forces.energy;
  given.task.notes = notes_of(*given.scene, given.system);
  return given;
}

/// What both programs have at the beginning and the end, held against each other.
class Check {
 public:
  explicit Check(const Given& given) : given_(given) {}

  /// Throws Error where it is not what the tables promise.
  void look(const std::string& folder, double energy) {
    const LammpsSystem& system = given_.system;
    const std::vector<Vec3> told = read_forces((fs::path(folder) / "start.dump").string(), system.atoms.size());
    double largest = system.usual_force, missed = 0.0;
    std::uint32_t worst = 0;
    for (std::uint32_t i = 0; i < system.atoms.size(); i++) {
      const Vec3 ours = given_.forces.on[system.atoms[i].slot - 1];
      largest = std::max(largest, norm(ours));
      const double off = norm(ours - told[i]);
      if (off > missed) missed = off, worst = i;
    }
    if (largest > 0.0) force_error_ = missed / largest;
    energy_error_ = energy_error(energy, given_.forces.energy);
    const double limit = this->limit();
    require(force_error_ <= limit, "LAMMPS has another force on ", describe(given_.scene->world(), system.atoms[worst]),
            " than this program, by ", rounded(force_error_), " of the largest, and ", system.error,
            " was promised: nothing is brought back");
    require(energy_error_ <= limit, "LAMMPS has an energy of ", energy, " J at the beginning and this program ",
            given_.forces.energy, " J, and to agree to ", system.error, " was promised: nothing is brought back");
    std::error_code kept;
    fs::remove(fs::path(folder) / "start.dump", kept);
    done_ = true;
  }

  /// Once all is where LAMMPS left it. What it found is told; after hours of work nothing is thrown away for it.
  void look_at_end(double energy) {
    const double ours = present_forces(given_.scene->world()).energy;
    end_error_ = energy_error(energy, ours);
    if (end_error_ <= limit()) return;
    say(text("LAMMPS has an energy of ", energy, " J at the end and this program ", ours,
             " J of the same positions: ", rounded(end_error_), " of it, and ", given_.system.error, " was promised",
             nearer_than_good() ? ", but for particles that come nearer than their tables are good" : "",
             ". Take a shorter step, or a smaller --error"));
  }

  bool done() const { return done_; }
  std::string told() const {
    return text("at the start the energy agrees to ", rounded(energy_error_), " and every force to ",
                rounded(force_error_), " of the largest; at the end the energy to ", rounded(end_error_));
  }

 private:
  double limit() const { return std::max(given_.system.error, 1e-12); }
  /// Of the energy, or of the usual one where that is more.
  double energy_error(double theirs, double ours) const {
    const double scale = std::max(std::abs(ours), given_.system.energy_size);
    return scale > 0.0 ? std::abs(theirs - ours) / scale : std::abs(theirs - ours);
  }
  bool nearer_than_good() const {
    const auto has_inner = [](const LammpsTable& t) { return t.table.inner_error > 0.0; };
    return std::ranges::any_of(given_.system.pair_tables, has_inner) ||
           std::ranges::any_of(given_.system.bond_tables, has_inner);
  }

  const Given& given_;
  double energy_error_ = 0.0, force_error_ = 0.0, end_error_ = 0.0;
  bool done_ = false;
};

/// Reads what LAMMPS prints.
class Listener {
 public:
  Listener(const Given& given, std::string folder)
      : given_(given), folder_(std::move(folder)), check_(given), progress_(given.scene->world().time) {}

  void hear(const std::string& line) {
    if (!begun_ && line.starts_with("pantin: energy ")) energy_ = std::strtod(line.c_str() + 15, nullptr);
    if (line.starts_with("pantin: start.dump")) check_.look(folder_, energy_), begun_ = true;
    if (line.starts_with("pantin: energy at the end ")) energy_at_end_ = std::strtod(line.c_str() + 26, nullptr);
    if (!begun_) return;
    if (line.starts_with("Loop time of ")) loop_ = std::strtod(line.c_str() + 13, nullptr);
    char* end = nullptr;
    const double step = std::strtod(line.c_str(), &end);
    double values[3] = {};
    int count = 0;
    for (const char* at = end; end != line.c_str() && count < 3; count++) {
      values[count] = std::strtod(at, &end);
      if (end == at) break;
      at = end;
    }
    if (count < 3 || loop_ > 0.0) return;
    if (!has_first_) first_ = values[2], has_first_ = true;
    last_ = values[2];
    progress_.show(given_.scene->world().time + step * given_.scene->world().settings.step, given_.until);
  }

  void look_at_end() { check_.look_at_end(energy_at_end_); }
  const Check& check() const { return check_; }
  double seconds() const { return loop_; }  ///< of the run's steps
  double first() const { return first_; }   ///< [J] kinetic and potential
  double last() const { return last_; }

 private:
  const Given& given_;
  std::string folder_;
  Check check_;
  Progress progress_;
  bool begun_ = false, has_first_ = false;
  double energy_ = 0.0, energy_at_end_ = 0.0, loop_ = 0.0, first_ = 0.0, last_ = 0.0;
};

/// LAMMPS goes on where a disk is full, and what it writes is cut off.
bool is_full(const std::string& folder) {
  std::error_code failed;
  const fs::space_info space = fs::space(folder, failed);
  return !failed && space.available < 4096;
}

/// Where LAMMPS leaves the scene.
LammpsState state_by_lmp(const std::string& folder, int ranks, const Given& given, Listener& listener) {
  try {
    run_lmp(folder, ranks, [&](const std::string& line) { listener.hear(line); });
    require(listener.check().done(), "LAMMPS did not tell its forces at the beginning (",
            (fs::path(folder) / "log.lammps").string(), ")");
    return read_state((fs::path(folder) / "end.dump").string(), given.system, given.scene->world().settings.box);
  } catch (const Error& error) {
    if (!is_full(folder)) throw;
    throw Error(text(error.what(), "; the disk of ", folder, " is full"));
  }
}

void remove_dumps(const std::string& folder) {
  std::error_code failed;
  for (const char* name : {"start.dump", "end.dump"}) fs::remove(fs::path(folder) / name, failed);
}

/// The state that is to be. Throws UsageError where it is there already, or cannot be written.
std::string free_state_name(const LammpsOptions& options, const LammpsScene& scene) {
  const std::string name = options.out.empty() ? scene_name(scene.path) + "-lammps" + state_ending : options.out;
  if (!options.overwrite && fs::exists(name))
    throw UsageError(text(name, " is there already: give another --out, or lose it with --overwrite"));
  Output(name).drop();
  return name;
}

/// A word as a shell reads it.
std::string quoted(const std::string& word) {
  constexpr const char* harmless = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,:/%@";
  if (!word.empty() && word.find_first_not_of(harmless) == std::string::npos) return word;
  std::string all = "'";
  for (const char c : word) all += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return all + "'";
}

/// What LAMMPS wrote elsewhere, as a state of the scene.
int bring_dump(const LammpsOptions& options, const LammpsScene& wanted) {
  const std::string out = free_state_name(options, wanted);
  const std::unique_ptr<Scene> scene = open(wanted);
  const std::string set = set_of(*scene, wanted), other = other_set_in(fs::path(options.dump).parent_path(), set);
  if (!other.empty())
    throw UsageError(text(options.dump, " is of an export with other parameters, ", other, ", and here they are ", set,
                          ": give the same --set"));
  World& world = scene->world();
  const LammpsSystem system = lammps_atoms(world);
  LammpsState state = read_state(options.dump, system, world.settings.box);
  const double reached = world.time + state.step * world.settings.step, time = wanted.until.value_or(reached);
  require(time >= world.time, options.dump, ": it would be at ", time, " s, and the scene begins at ", world.time,
          " s");
  check_scene(*scene, time);
  if (std::abs(time - reached) > 0.5 * world.settings.step)
    say(text(options.dump, ": its step ", state.step, " is at ", reached,
             " s by the scene's step; it is taken to be at ", time, " s, as --until says"));
  bring_back(world, system, std::move(state.atoms), time);
  save_state(*scene, out);
  std::printf("%s of step %.0f, %.10g J by all laws; %g s: %s (pantin play %s)\n",
              amount(system.atoms.size(), "particle", "particles").c_str(), state.step, present_forces(world).energy,
              time, out.c_str(), quoted(out).c_str());
  return 0;
}

/// The command that does so of a folder's last dump.
std::string way_back(const std::string& folder, const LammpsScene& scene) {
  std::string command = "pantin lammps " + quoted(scene.given);
  for (const auto& [name, value] : scene.options.set) command += " --set " + quoted(text(name, '=', value));
  return text(command, " --from-dump ", quoted((fs::path(folder) / "end.dump").string()));
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

int export_lammps(const LammpsOptions& options, const LammpsScene& scene) {
  Interrupt interrupt;
  const auto start = std::chrono::steady_clock::now();
  Given given = give(options, scene);
  const FolderLock lock(options.folder);
  given.task.back = way_back(options.folder, scene);
  for (const std::string& name : set_results_aside(options.folder))
    given.task.notes.push_back(text("what is left of an export before is ", name, " now"));
  write_lammps(options.folder, given.scene->world(), given.system, given.task);
  for (const std::string& note : given.task.notes) std::printf("note: %s\n", note.c_str());
  const LammpsSystem& system = given.system;
  std::printf("%s of %s, %s, %s in %.1f s: cd %s && lmp -in in.scene\nback: %s\n",
              amount(system.atoms.size(), "particle", "particles").c_str(),
              amount(system.types.size(), "type", "types").c_str(),
              amount(system.bonds.size(), "bond", "bonds").c_str(),
              amount(system.bodies.size(), "body", "bodies").c_str(), seconds_since(start),
              quoted(options.folder).c_str(), given.task.back.c_str());
  return 0;
}

int run_lammps(const LammpsOptions& options, const LammpsScene& scene) {
  Interrupt interrupt;
  if (!options.dump.empty()) return bring_dump(options, scene);
  const std::string out = free_state_name(options, scene);
  const std::string folder = options.folder.empty() ? fs::path(out).replace_extension("").string() : options.folder;
  const int ranks =
      options.ranks > 0 ? options.ranks : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const LmpVersion version = check_lmp(ranks);
  Given given = give(options, scene);
  if (!given.system.bodies.empty()) require_package(version, "RIGID");
  if (!given.system.bonds.empty()) require_package(version, "MOLECULE");
  World& world = given.scene->world();
  (void)given.scene->state();  // whether it can be kept in a file is known before hours are spent
  const FolderLock lock(folder);
  if (const std::string left = (fs::path(folder) / "end.dump").string(); !options.overwrite && fs::exists(left))
    throw UsageError(text(left, " is left of a run before: ", way_back(folder, scene), " --out ", quoted(out),
                          " brings it back, or lose it with --overwrite"));
  write_lammps(folder, world, given.system, given.task);
  remove_dumps(folder);
  for (const std::string& note : given.task.notes) say(note);
  Listener listener(given, folder);
  bring_back(world, given.system, state_by_lmp(folder, ranks, given, listener).atoms, given.until);
  listener.look_at_end();
  check_turns(world, given.system, static_cast<double>(given.task.steps) * world.settings.step, 1.0);
  try {
    save_state(*given.scene, out);
  } catch (const Error& error) {
    throw Error(text(error.what(), "; what LAMMPS did is kept, and once there is space this makes the state of it: ",
                     way_back(folder, scene), " --out ", quoted(out)));
  }
  remove_dumps(folder);
  const double done = static_cast<double>(given.task.steps) * static_cast<double>(given.system.atoms.size());
  std::printf("%s\n", listener.check().told().c_str());
  std::printf(
      "LAMMPS %s, %s: %llu steps in %.3g s, %.3g million atom-steps/s; total energy %.10g J before, %.10g J "
      "after\n",
      version.name.c_str(), amount(static_cast<std::size_t>(ranks), "rank", "ranks").c_str(),
      static_cast<unsigned long long>(given.task.steps), listener.seconds(),
      1e-6 * done / std::max(listener.seconds(), 1e-9), listener.first(), listener.last());
  if (world.settings.box && norm(world.settings.gravity) > 0.0)
    std::printf(
        "that has a jump by m g L where a particle crosses the periodic box along gravity: fix gravity of LAMMPS "
        "does not count how often\n");
  std::printf("%g s: %s (pantin play %s); its files and log are in %s\n", given.until, out.c_str(), quoted(out).c_str(),
              folder.c_str());
  return 0;
}

}  // namespace pantin::player
