#include "player/command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <limits>

#include "scene/errors.hpp"

namespace pantin::player {
namespace {

constexpr std::array<const char*, 8> known_endings = {".csv", ".h5", ".png", ".mp4", ".gif", ".webp", ".xyz", ".glb"};

std::string check_ending(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension();
  if (std::find(known_endings.begin(), known_endings.end(), ending) != known_endings.end()) return "";
  return text(
      "'", path,
      "' must end in .csv or .h5 (probes), .png (last frame), .mp4, .gif or .webp (film), .xyz (trajectory) or .glb "
      "(animation)");
}

std::string check_named(const std::string& path) { return path.empty() ? "a name must not be empty" : ""; }

/// Whether all of it is a number within bounds.
bool is_within(const std::string& value, double least, double most) {
  double x = 0.0;
  const char* const end = value.data() + value.size();
  const auto [rest, error] = std::from_chars(value.data(), end, x);
  return error == std::errc{} && rest == end && x >= least && x <= most;
}

std::string check_number(const std::string& value) {
  if (is_within(value, 0.0, std::numeric_limits<double>::max())) return "";
  return text("'", value, "' must be a number >= 0, in s");
}

std::string check_setting(const std::string& setting) {
  auto equals = setting.find('=');
  if (equals != std::string::npos && equals > 0) return "";
  return text("'", setting, "' must be name=value");
}

std::string check_size(const std::string& size) {
  try {
    read_size(size);
    return "";
  } catch (const Error& error) { return error.what(); }
}

std::string check_views(const std::string& list) {
  try {
    read_views(list);
    return "";
  } catch (const Error& error) { return error.what(); }
}

std::string check_bytes(const std::string& bytes) {
  try {
    read_bytes(bytes);
    return "";
  } catch (const Error& error) { return error.what(); }
}

/// Each use takes one value, so that `--set links=5 chain` leaves "chain" to be the scene.
void list_option(CLI::App& app, const std::string& name, std::vector<std::string>& values, const std::string& help,
                 const std::string& kind, std::string (*check)(const std::string&)) {
  app.add_option(name, values, help)->allow_extra_args(false)->check(check)->type_name(kind);
}

/// Of all that run a scene, but for recordings, which have them.
void add_settings(CLI::App& app, Texts& texts) {
  list_option(app, "--set", texts.settings,
              "Sets a parameter of the scene, or a field: --set links=50 --set scene.step=1/60", "K=V", check_setting);
}

/// Of all that run a scene.
void add_limits(CLI::App& app, RunOptions& scene, Texts& texts) {
  app.add_option("--until", scene.until, "Ends at this simulated time, s")->check(check_number)->type_name("T");
  app.add_option("--script-limit", scene.script_limit,
                 "Processor time that one call into the script may take, s; 0: no limit")
      ->check(check_number)
      ->default_str("5")
      ->type_name("S");
  app.add_option("--memory-limit", texts.memory, "Of the script's memory, at least 1MiB; with its scene 512MiB more")
      ->check(check_bytes)
      ->default_str("2GiB")
      ->type_name("SIZE");
}

/// Of all that run a scene once; a report's costs are those of one thread.
void add_threads(CLI::App& app, RunOptions& scene) {
  app.add_option("--threads", scene.threads, "Threads; 0: all processors. The results are the same")
      ->check(CLI::Range(0, 256));
}

/// Of all that draw a scene.
void add_look(CLI::App& app, Texts& texts) {
  app.add_option("--size", texts.size, "Of the window, picture or film, pixels")
      ->check(check_size)
      ->default_str("1280x720")
      ->type_name("WxH");
  std::string names;
  for (const NamedView& named : view_table()) names += std::string(" ") + named.name;
  app.add_option("--view", texts.views, "What is shown beside the scene itself; with a minus, what is not:" + names)
      ->check(check_views)
      ->type_name("NAME,...");
}

void add_scene_options(CLI::App& app, RunOptions& scene, Texts& texts) {
  add_settings(app, texts);
  add_limits(app, scene, texts);
  add_threads(app, scene);
  list_option(app, "--out", scene.outputs,
              "By its ending: .csv probes of each step, .h5 the same as HDF5, .png last frame, .mp4 .gif .webp film, "
              ".xyz trajectory of all "
              "particles, .glb animation with meshes",
              "FILE", check_ending);
  app.add_option("--every", scene.table.every,
                 "Simulated time from row to row of .csv and .h5, s; else each step has a row")
      ->check(check_number)
      ->type_name("T");
  app.add_option("--reduce", scene.table.reductions,
                 "With --every or --when: more columns of each probe, of the steps since the row before; of these: "
                 "least largest mean rms")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember(std::vector<std::string>(std::begin(reduction_names), std::end(reduction_names)))
                  .description(""))
      ->type_name("NAME,...");
  app.add_option("--summary", scene.summary, "Writes energies, errors, iterations, times and results as JSON")
      ->check(check_named)
      ->type_name("FILE");
  add_look(app, texts);
}

/// Of what may be a stranger's.
void add_untrusted(CLI::App& app, bool& untrusted) {
  app.add_flag("--untrusted", untrusted,
               "For a stranger's scene: it reaches no file but those of its folder, no network and no other program");
}

/// Of `run`, which may go on from what an earlier one left.
void add_state(CLI::App& app, RunOptions& scene) {
  app.add_option("--when", scene.table.when,
                 "A row of .csv and .h5 also at each step where one of these probes changes; without --every there "
                 "alone, and at the first and the last")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("PROBE,...");
  app.add_option("--from", scene.from, "Goes on from a saved state, to the same bits; the scene is in it")
      ->check(CLI::ExistingFile)
      ->type_name("FILE");
  app.add_option("--save-at", scene.save_at, "Saves the state at this simulated time, s")
      ->check(check_number)
      ->type_name("T");
  app.add_option("--save-to", scene.save_to, "File for that [the scene's name.pantin]")
      ->check(check_named)
      ->type_name("FILE");
}

/// `pantin test fuzz`.
void add_fuzz(CLI::App& test, FuzzOptions& fuzz) {
  CLI::App* command = test.add_subcommand(
      "fuzz", "Runs random scenes, and keeps as small as they can be those that crash or break a promise");
  command->add_option("file", fuzz.files, "Scenes to look at [random ones]")->check(CLI::ExistingFile);
  command->add_option("--seconds", fuzz.seconds, "Real time, s")->check(check_number)->capture_default_str();
  command->add_option("--seed", fuzz.seed, "Of the first scene")
      ->check(CLI::Range(0.0, 0x1p53))
      ->capture_default_str()
      ->type_name("S");
  command->add_option("--out", fuzz.folder, "Folder for what is found")
      ->check(CLI::ExistingDirectory)
      ->default_str("tests/corpus")
      ->type_name("DIR");
}

/// `pantin test soak`.
void add_soak(CLI::App& test, SoakOptions& soak) {
  CLI::App* command =
      test.add_subcommand("soak", "Runs scenes for long: whether memory, time, energy and gaps stay as they began");
  command->add_option("--scene", soak.scene, "A scene's file, or the name of a shipped one [all shipped ones]");
  command->add_option("--steps", soak.steps, "Of each scene [an hour of simulated time]")->type_name("N");
}

std::string check_table(const std::string& path) {
  return path.ends_with(".csv") || path.ends_with(".h5") ? "" : text("'", path, "' must end in .csv or .h5 (HDF5)");
}

/// `pantin sweep`.
void add_sweep(CLI::App& app, SweepOptions& sweep, RunOptions& scene, Texts& texts) {
  CLI::App* command = app.add_subcommand("sweep",
                                         "Runs a scene once for each combination of values, on all processors, into "
                                         "one table; goes on where it was stopped");
  command->add_option("scene", sweep.scene, "A scene's file, or the name of a shipped one")->required();
  list_option(
      *command, "--set", sweep.settings,
      "Values of a parameter of the scene or a field: links=10:1000:20 (20 from 10 to 1000), mass=1e-3:1e3:7:log, "
      "ratio=1,1e3,1e6, scene.step=1/60,1/240, 'kind=\"with, comma\",b'",
      "K=VALUES", check_setting);
  command->add_option("--seeds", sweep.seeds, "Of math.random: 1:100 or 1,5,9")->type_name("FIRST:LAST");
  command
      ->add_option(
          "--sample", sweep.sample,
          "Draws so many cases of the ranges (a Latin hypercube) in place of all combinations; of a search, how "
          "many it has [100 for each range]")
      ->check(CLI::Range(1.0, 1e6))
      ->type_name("N");
  CLI::Option* best = command
                          ->add_option("--best", sweep.wanted.column,
                                       "Searches the ranges, FROM:TO, for the values that make this column largest: "
                                       "what scene:result told, or of a probe --best \"height last\"")
                          ->type_name("COLUMN");
  command
      ->add_option_function<std::string>(
          "--least",
          [&sweep](const std::string& column) {
            sweep.wanted = {column, true};
          },
          "The same, for smallest")
      ->excludes(best)
      ->type_name("COLUMN");
  command->add_option("--out", sweep.out, "The table: a row a case; .csv, or .h5 (HDF5)")
      ->required()
      ->check(check_table)
      ->type_name("FILE");
  command->add_flag("--retry-failed", sweep.retry_failed,
                    "Of a sweep that was finished or stopped, runs the failed cases again, with another limit if you "
                    "like, and keeps the others");
  command->add_flag("--overwrite", sweep.overwrite,
                    "A table that is there already may be lost, and a sweep that was finished begins anew; what a "
                    "stopped one has done is kept. Else another table than this sweep's is refused");
  command->add_option("--jobs", sweep.jobs, "Processes; 0: one for each processor. The table is the same")
      ->check(CLI::Range(0, 1024))
      ->type_name("N");
  command->add_flag("--timed", sweep.timed, "With the processor time of each case, s, which differs from run to run");
  add_untrusted(*command, sweep.untrusted);
  add_limits(*command, scene, texts);
}

std::string check_svg(const std::string& path) {
  return path.ends_with(".svg") ? "" : text("'", path, "' must end in .svg");
}

/// `pantin plot`.
void add_plot(CLI::App& app, PlotOptions& plot) {
  CLI::App* command = app.add_subcommand("plot", "Draws columns of a table against each other: lines, or a heat map");
  command
      ->add_option("table", plot.table,
                   "A .csv file with names in its first row, or .h5, as `sweep` and `run --out` write it")
      ->required()
      ->check(CLI::ExistingFile);
  command->add_option("--x", plot.x, "Column along the picture")->required()->type_name("COLUMN");
  command->add_option("--y", plot.y, "Column up the picture; rows with an equal x are drawn as their mean")
      ->required()
      ->type_name("COLUMN");
  command
      ->add_option(
          "--by", plot.by,
          "A line for each value of this column; of more numbers than a legend can tell apart by a bar of colours")
      ->type_name("COLUMN");
  command->add_option("--color", plot.color, "A heat map of this column over x and y")->type_name("COLUMN");
  command->add_option("--log", plot.log, "Columns whose axis, or bar of colours, is logarithmic")
      ->delimiter(',')
      ->type_name("COLUMN,...");
  command->add_option("--title", plot.title, "[the table's name]");
  command->add_flag("--points", plot.points, "Points that no lines join");
  command->add_option("--out", plot.out, "The picture")->required()->check(check_svg)->type_name("FILE.svg");
}

std::string check_state(const std::string& path) {
  return path.ends_with(state_ending) ? "" : text("'", path, "' must end in ", state_ending);
}

std::string check_error(const std::string& value) {
  return is_within(value, 1e-10, 0.1) ? "" : text("'", value, "' must be a number from 1e-10 to 0.1");
}

/// What `export` and `lammps` share.
void add_for_lammps(CLI::App& command, LammpsOptions& lammps, RunOptions& scene, Texts& texts) {
  command.add_option("scene", scene.scene, "A scene's file, the name of a shipped one, or a state (.pantin)")
      ->required();
  command
      .add_option(
          "--error", lammps.error,
          "Of the tables that LAMMPS gets of the laws: of energy and force, relative to what they are there or, where "
          "that is more, to what is usual now")
      ->check(check_error)
      ->default_str("1e-6")
      ->type_name("E");
  add_settings(command, texts);
  add_limits(command, scene, texts);
  add_threads(command, scene);
}

/// `pantin export`, `pantin lammps`.
void add_lammps(CLI::App& app, LammpsOptions& lammps, RunOptions& scene, Texts& texts) {
  CLI::App* files = app.add_subcommand(
      "export",
      "Writes a scene of particles, springs and rigid bodies as LAMMPS runs it, on any machine: lmp -in in.scene");
  files->add_option("--lammps", lammps.folder, "Folder for in.scene, scene.data and tables of the laws")
      ->required()
      ->check(check_named)
      ->type_name("FOLDER");
  add_for_lammps(*files, lammps, scene, texts);
  CLI::App* runs = app.add_subcommand("lammps",
                                      "Has LAMMPS (Debian's packages lammps and openmpi-bin) run a scene, checks that "
                                      "it has the same forces at the start, and "
                                      "saves where all is at the end, for `pantin play STATE`");
  CLI::Option* dump =
      runs->add_option("--from-dump", lammps.dump,
                       "Runs nothing: brings back what LAMMPS wrote elsewhere of this scene's export, as end.dump")
          ->check(CLI::ExistingFile)
          ->type_name("FILE");
  runs->add_option("--ranks", lammps.ranks, "Processes; 0: one for each processor")
      ->excludes(dump)
      ->check(CLI::Range(0, 100000))
      ->type_name("N");
  runs->add_option("--out", lammps.out, "The state at the end [the scene's name and -lammps.pantin]")
      ->check(check_state)
      ->type_name("FILE.pantin");
  runs->add_flag("--overwrite", lammps.overwrite, "A state that is there already is lost; else that is refused");
  runs->add_option("--folder", lammps.folder, "Folder for LAMMPS' files and log [the state's name without its ending]")
      ->check(check_named)
      ->type_name("FOLDER");
  add_for_lammps(*runs, lammps, scene, texts);
}

}  // namespace

void add_commands(CLI::App& app, Options& options, Texts& texts) {
  app.description("A physics engine to play with, scripted in Lua.");
  app.set_version_flag("--version", "pantin " PANTIN_VERSION);
  CLI::App* play = app.add_subcommand("play", "Plays a scene in a window");
  play->add_option("scene", options.run.scene,
                   "A scene's file, or the name of a shipped one; without it, the browser of scenes");
  play->add_option("--scenes", options.run.scenes, "A folder of your own scenes, for the browser")
      ->check(CLI::ExistingDirectory)
      ->default_str("where you are")
      ->type_name("DIR");
  play->add_flag("--paused", options.run.paused, "Waits for the space bar before it starts");
  play->add_option("--record", options.run.record, "Records all that is done, for `pantin replay FILE`")
      ->check(check_named)
      ->type_name("FILE");
  add_scene_options(*play, options.run, texts);
  add_untrusted(*play, options.run.untrusted);
  CLI::App* run = app.add_subcommand("run", "Runs a scene without a window");
  run->add_option("scene", options.run.scene, "A scene's file, or the name of a shipped one");
  add_state(*run, options.run);
  add_scene_options(*run, options.run, texts);
  add_untrusted(*run, options.run.untrusted);
  CLI::App* replay = app.add_subcommand("replay",
                                        "Does again what was recorded, to the bit, and checks that: in a window where "
                                        "there is a display, where one may go "
                                        "to any time of it");
  replay->add_option("file", options.run.record, "What `pantin play --record FILE` wrote")->required();
  replay->add_flag("--headless", options.run.headless, "Without a window, as fast as it goes");
  replay->add_flag("--paused", options.run.paused, "Waits for the space bar before it starts");
  add_look(*replay, texts);
  add_limits(*replay, options.run, texts);
  add_untrusted(*replay, options.run.untrusted);
  add_threads(*replay, options.run);
  CLI::App* report = app.add_subcommand(
      "report",
      "Tells how exact a scene is with which step and integrator, and what processor time that costs on one thread");
  report->add_option("scene", options.run.scene, "A scene's file, or the name of a shipped one")->required();
  report->add_option("--out", options.prefix, "Writes PREFIX.json and PREFIX.svg [the scene's name and -report]")
      ->check(check_named)
      ->type_name("PREFIX");
  add_settings(*report, texts);
  add_limits(*report, options.run, texts);
  add_untrusted(*report, options.run.untrusted);
  CLI::App* test = app.add_subcommand("test", "Runs tests written in Lua");
  test->add_option("path", options.arguments, "Files, or folders of them [tests/scenes]");
  add_untrusted(*test, options.run.untrusted);
  add_fuzz(*test, options.fuzz);
  add_soak(*test, options.soak);
  add_sweep(app, options.sweep, options.run, texts);
  add_plot(app, options.plot);
  add_lammps(app, options.lammps, options.run, texts);
  CLI::App* bench = app.add_subcommand("bench", "Runs benchmarks");
  bench->add_option("name", options.arguments, "Which, and its arguments [all]");
  bench->add_flag("--peers", options.peers, "Measures other engines, too, where they are installed");
  CLI::App* meta = app.add_subcommand("meta", "Prints what is made of the program's own tables");
  meta->add_option("what", options.arguments, "What: annotations for a Lua language server unless given")
      ->check(CLI::IsMember({"reference", "man", "bash"}));
  meta->group("");
}

}  // namespace pantin::player
