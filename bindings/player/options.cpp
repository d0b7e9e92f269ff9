#include "player/options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <filesystem>
#include <iostream>
#include <utility>

#include "player/command_line.hpp"
#include "player/manual.hpp"
#include "player/saved_state.hpp"
#include "scene/errors.hpp"
#include "view/film.hpp"

namespace pantin::player {
namespace {

/// A film is written by another program.
void check_untrusted(const RunOptions& run) {
  for (const std::string& path : run.outputs)
    if (run.untrusted && Film::can_write(path))
      throw UsageError(text("--untrusted starts no other program, and ", path, " needs ffmpeg: .glb and .png do not"));
}

/// What belongs together of that.
void settle_state(RunOptions& run) {
  if (run.from.empty() && run.scene.ends_with(state_ending)) run.from = std::exchange(run.scene, "");
  if (run.from.empty() && run.scene.empty()) throw UsageError("a scene is missing (pantin run --help tells more)");
  if (!run.save_to.empty() && !run.save_at) throw UsageError("--save-to needs --save-at, the time to save at");
  if (run.save_at && run.save_to.empty())
    run.save_to = std::filesystem::path(run.from.empty() ? run.scene : run.from).stem().string() + state_ending;
}

/// What says how an output is written, where there is none.
void check_outputs(const RunOptions& run, const Texts& texts, bool draws) {
  const auto any = [&](auto is) { return std::ranges::any_of(run.outputs, is); };
  const bool tables = any([](const std::string& path) { return path.ends_with(".csv") || path.ends_with(".h5"); });
  const bool pictures = any([](const std::string& path) { return path.ends_with(".png") || Film::can_write(path); });
  const auto need = [](const char* option, bool given, const char* endings) {
    if (given) throw UsageError(text(option, " is for what --out writes: give it a file that ends in ", endings));
  };
  if (!tables) need("--every", run.table.every > 0.0, ".csv or .h5");
  if (!tables) need("--when", !run.table.when.empty(), ".csv or .h5");
  if (draws || pictures) return;
  need("--size", !texts.size.empty(), ".png, .mp4, .gif or .webp");
  need("--view", !texts.views.empty(), ".png, .mp4, .gif or .webp");
}

void refuse_twice(const char* option, const std::vector<std::string>& names) {
  for (auto name = names.begin(); name != names.end(); name++)
    if (std::find(names.begin(), name, *name) != name) throw UsageError(text(option, ": '", *name, "' is given twice"));
}

/// What texts say, and what belongs together.
void settle(Options& options, const Texts& texts) {
  for (const std::string& setting : texts.settings) {
    auto equals = setting.find('=');
    if (!options.run.set.emplace(setting.substr(0, equals), setting.substr(equals + 1)).second)
      throw UsageError(text("--set ", setting, ": '", setting.substr(0, equals), "' is set twice"));
  }
  if (!texts.size.empty()) options.run.size = read_size(texts.size);
  if (!texts.views.empty()) options.run.views = read_views(texts.views);
  if (!texts.memory.empty()) options.run.memory_limit = read_bytes(texts.memory);
  refuse_twice("--reduce", options.run.table.reductions);
  refuse_twice("--when", options.run.table.when);
  if (!options.run.table.reductions.empty() && options.run.table.every <= 0.0 && options.run.table.when.empty())
    throw UsageError("--reduce needs --every, the time from row to row, or --when");
  options.sweep.until = options.run.until;
  options.sweep.script_limit = options.run.script_limit;
  options.sweep.memory_limit = options.run.memory_limit;
  check_untrusted(options.run);
}

Options::Command command_of(const CLI::App& app) {
  using Command = Options::Command;
  constexpr std::pair<const char*, Command> commands[] = {{"play", Command::play},
                                                          {"run", Command::run},
                                                          {"replay", Command::replay},
                                                          {"report", Command::report},
                                                          {"test", Command::test},
                                                          {"fuzz", Command::fuzz},
                                                          {"soak", Command::soak},
                                                          {"sweep", Command::sweep},
                                                          {"plot", Command::plot},
                                                          {"lammps", Command::lammps},
                                                          {"export", Command::export_scene},
                                                          {"bench", Command::bench},
                                                          {"meta", Command::meta}};
  const CLI::App* used = app.get_subcommands().front();
  if (!used->get_subcommands().empty()) used = used->get_subcommands().front();
  for (const auto& [name, command] : commands)
    if (used->get_name() == name) return command;
  return Command::none;
}

[[noreturn]] void refuse_command(const std::string& command) {
  std::string what = command.empty() ? "a command is missing" : "there is no command '" + command + "'";
  throw UsageError(
      what + ": give play, run, replay, report, sweep, plot, export, lammps, test or bench (pantin --help tells more)");
}

std::string command_name(const CLI::App& app) {
  std::string name = "pantin";
  for (const CLI::App* used : app.get_subcommands()) name += " " + used->get_name();
  return name;
}

/// What no option takes, in the order in which it was given, and of which commands it is.
[[noreturn]] void refuse_extras(const CLI::App& app) {
  std::string all, others;
  for (const std::string& extra : app.remaining(true)) {
    all += " " + extra;
    const std::string name = extra.substr(0, extra.find('='));
    std::string owners;
    for (const CLI::App* command : app.get_subcommands(nullptr))
      if (extra.starts_with("--") && command->get_option_no_throw(name))
        owners += (owners.empty() ? " is of " : ", ") + command->get_name();
    if (!owners.empty()) others += name + owners + "; ";
  }
  throw UsageError(text("this is not understood:", all, " (", others, command_name(app), " --help tells more)"));
}

std::string first_line(const std::string& message) { return message.substr(0, message.find('\n')); }

}  // namespace

Size read_size(const std::string& size) {
  Size result;
  const char* end = size.data() + size.size();
  auto [x, bad_width] = std::from_chars(size.data(), end, result.width);
  bool good = bad_width == std::errc{} && x != end && *x == 'x';
  if (good) {
    auto [rest, bad_height] = std::from_chars(x + 1, end, result.height);
    good = bad_height == std::errc{} && rest == end;
  }
  good = good && std::min(result.width, result.height) >= 16 && std::max(result.width, result.height) <= 8192;
  if (!good) throw UsageError(text("'", size, "' must be WIDTHxHEIGHT, each 16 to 8192 pixels"));
  return result;
}

std::size_t read_bytes(const std::string& bytes) {
  constexpr std::pair<const char*, double> units[] = {{"", 1},         {"B", 1},        {"kB", 1e3},
                                                      {"MB", 1e6},     {"GB", 1e9},     {"KiB", 0x1p10},
                                                      {"kiB", 0x1p10}, {"MiB", 0x1p20}, {"GiB", 0x1p30}};
  double number = 0.0;
  const char* const end = bytes.data() + bytes.size();
  const auto [rest, bad] = std::from_chars(bytes.data(), end, number);
  for (const auto& [name, unit] : units)
    if (bad == std::errc{} && std::string(rest, end) == name && number * unit >= 0x1p20 && number * unit < 0x1p60)
      return static_cast<std::size_t>(number * unit);
  throw UsageError(text("'", bytes, "' must be a size of 1MiB or more, with a unit: 512MiB, 1.5GB, 2GiB"));
}

SceneOptions scene_options(const RunOptions& options, const std::string& home) {
  SceneOptions result;
  result.set = options.set;
  result.script_limit = options.script_limit;
  result.memory_limit = options.memory_limit;
  result.threads = options.threads;
  result.home = home;
  result.save = save_for_script;
  return result;
}

Options read_options(int argc, const char* const* argv) {
  Options options;
  Texts texts;
  CLI::App app("", "pantin");
  add_commands(app, options, texts);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    app.exit(success);
    return options;
  } catch (const CLI::ParseError& error) {
    if (app.get_subcommands().empty()) refuse_command(argv[1]);
    if (dynamic_cast<const CLI::ExtrasError*>(&error)) refuse_extras(app);
    throw UsageError(first_line(error.what()) + " (" + command_name(app) + " --help tells more)");
  }
  if (app.get_subcommands().empty()) refuse_command(argc > 1 ? argv[1] : "");
  settle(options, texts);
  options.command = command_of(app);
  if (options.command == Options::Command::run) settle_state(options.run);
  if (options.command == Options::Command::run || options.command == Options::Command::play)
    check_outputs(options.run, texts, options.command == Options::Command::play);
  return options;
}

std::string manual_page() {
  Options options;
  Texts texts;
  CLI::App app("", "pantin");
  add_commands(app, options, texts);
  return manual_page(app, PANTIN_VERSION);
}

std::string bash_completion(const std::vector<std::string>& scenes) {
  Options options;
  Texts texts;
  CLI::App app("", "pantin");
  add_commands(app, options, texts);
  return bash_completion(app, scenes);
}

}  // namespace pantin::player
