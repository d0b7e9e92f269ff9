#include "player/manual.hpp"

#include <CLI/CLI.hpp>
#include <sstream>

#include "base/check.hpp"

namespace pantin::player {
namespace {

/// As troff prints it: no sign of it is a command.
std::string plain(const std::string& text) {
  std::string result = text.starts_with('.') ? "\\&" : "";
  for (const char c : text) switch (c) {
      case '\\': result += "\\e"; break;
      case '-': result += "\\-"; break;
      case '\'': result += "\\(aq"; break;
      case '`': result += "\\(ga"; break;
      case '^': result += "\\(ha"; break;
      case '~': result += "\\(ti"; break;
      default: result += c;
    }
  return result;
}

/// Commands that a reader is told of; what has no group is for the house.
std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); });
}

std::vector<const CLI::Option*> options_of(const CLI::App& command) {
  return command.get_options([](const CLI::Option* option) { return !option->get_positional(); });
}

std::vector<const CLI::Option*> arguments_of(const CLI::App& command) {
  return command.get_options([](const CLI::Option* option) { return option->get_positional(); });
}

bool takes_value(const CLI::Option& option) { return option.get_expected_max() > 0; }

/// Without what checks it.
std::string kind_of(const CLI::Option& option) {
  const std::string kind = option.get_type_name();
  return kind.substr(0, kind.find(':'));
}

std::string signature(const CLI::App& command) {
  std::string result = "[\\fIoptions\\fR]";
  for (const CLI::Option* argument : arguments_of(command)) {
    const std::string name = "\\fI" + plain(argument->get_name()) + "\\fR";
    result += argument->get_required() ? " " + name : " [" + name + "]";
  }
  return result;
}

void write_entry(std::ostream& out, const std::string& head, const CLI::Option& option) {
  out << ".TP\n" << head << "\n" << plain(option.get_description());
  if (!option.get_default_str().empty()) out << " [" << plain(option.get_default_str()) << "]";
  out << "\n";
}

void write_command(std::ostream& out, const std::string& parent, const CLI::App& command) {
  const std::string name = parent + " " + command.get_name();
  out << ".SS \"" << name << " " << signature(command) << "\"\n" << plain(command.get_description()) << ".\n";
  for (const CLI::Option* argument : arguments_of(command))
    write_entry(out, "\\fI" + plain(argument->get_name()) + "\\fR", *argument);
  for (const CLI::Option* option : options_of(command)) {
    std::string head = "\\fB" + plain(option->get_name(false, true)) + "\\fR";
    if (takes_value(*option)) head += " \\fI" + plain(kind_of(*option)) + "\\fR";
    write_entry(out, head, *option);
  }
  for (const CLI::App* part : commands_of(command)) write_command(out, name, *part);
}

bool takes_scene(const CLI::App& command) {
  for (const CLI::Option* argument : arguments_of(command))
    if (argument->get_name() == "scene") return true;
  return false;
}

void write_case(std::ostream& out, const std::string& pattern, const CLI::App& command) {
  out << "    " << pattern << ")\n      options='";
  for (const CLI::Option* option : options_of(command))
    for (const std::string& name : option->get_lnames()) out << "--" << name << " ";
  out << "'\n      words='";
  for (const CLI::App* part : commands_of(command)) out << part->get_name() << " ";
  out << "'" << (takes_scene(command) ? "$scenes" : "") << " ;;\n";
}

constexpr const char* manual_tail = R"(.SH EXIT STATUS
0 where all went well, 1 where a scene or a test failed, 2 where the command line was wrong.
.SH ENVIRONMENT
.TP
\fBPANTIN_HOME\fR
A folder that holds scripts/scenes, in place of the installed share/pantin.
.SH FILES
.TP
share/pantin
Scenes that are shipped, what they share, and every name of the Lua API for an editor
(scripts/meta/pantin.lua). It is found from the program's own place.
.TP
share/doc/pantin
The guide, the tutorial and the reference.
.SH EXAMPLES
.TP
pantin play
All scenes in a window.
.TP
pantin run chain \-\-until 10 \-\-out chain.csv
Ten simulated seconds without a window, and a table of its probes.
)";

}  // namespace

std::string manual_page(const CLI::App& program, const std::string& version) {
  std::ostringstream out;
  out << ".TH PANTIN 1 \"\" \"pantin " << version << "\"\n.SH NAME\npantin \\- play with a physics engine that is "
      << "scripted in Lua\n.SH SYNOPSIS\n";
  for (const CLI::App* command : commands_of(program))
    out << "\\fBpantin " << command->get_name() << "\\fR " << signature(*command) << "\n.br\n";
  out << ".SH DESCRIPTION\n"
      << plain(program.get_description())
      << " A scene is a file in Lua: open it in a window and drag it about, or run it without one.\n.SH COMMANDS\n";
  for (const CLI::App* command : commands_of(program)) write_command(out, "pantin", *command);
  out << manual_tail;
  return out.str();
}

std::string bash_completion(const CLI::App& program, const std::vector<std::string>& scenes) {
  std::ostringstream out;
  out << "# Completes pantin in bash; made by `pantin meta bash`.\n_pantin() {\n  COMPREPLY=()\n"
      << "  local word=${COMP_WORDS[COMP_CWORD]} command= options= words= scenes='";
  for (const std::string& scene : scenes) out << scene << " ";
  out << R"('
  ((COMP_CWORD == 1)) || command=${COMP_WORDS[1]}
  [[ $command != test || $COMP_CWORD == 2 ]] || command+=" ${COMP_WORDS[2]}"
  case $command in
)";
  write_case(out, "''", program);
  for (const CLI::App* command : commands_of(program)) {
    for (const CLI::App* part : commands_of(*command))
      write_case(out, "'" + command->get_name() + " " + part->get_name() + "'", *part);
    write_case(out, command->get_name() + (commands_of(*command).empty() ? "" : "*"), *command);
  }
  out << R"(  esac
  if [[ $word == -* ]]; then
    COMPREPLY=($(compgen -W "$options" -- "$word"))
  else
    # After an option comes its value.
    [[ ${COMP_WORDS[COMP_CWORD - 1]} == -* ]] || COMPREPLY=($(compgen -W "$words" -- "$word"))
    [[ ! $command ]] || COMPREPLY+=($(compgen -f -- "$word"))
  fi
}
complete -o filenames -F _pantin pantin
)";
  return out.str();
}

}  // namespace pantin::player
