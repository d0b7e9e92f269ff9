#include <catch2/catch.hpp>
#include <regex>
#include <string>

#include "bindings/program_support.hpp"
#include "player/options.hpp"

using namespace pantin::support;
namespace sources = pantin::sources;
using Catch::Contains;

namespace {

/// What bash offers after these words, the last of which is not complete.
std::string offered(const Folder& folder, const std::string& words) {
  write_file(folder / "completion", pantin::player::bash_completion({"chain", "cloth", "tower"}));
  const std::string script = "source ./completion; COMP_WORDS=(" + words +
                             "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _pantin; printf '%s ' \"${COMPREPLY[@]}\"";
  const Finished done = finish({{"/bin/bash", "-c", script}, {}, folder.path.string(), -1});
  CHECK(done.err == "");
  return done.out;
}

}  // namespace

TEST_CASE("manual: it has all that the help of each command has") {
  const std::string page = std::regex_replace(pantin::player::manual_page(), std::regex(R"(\\-)"), "-");
  const Folder folder;
  int options = 0;
  for (const char* command : {"play", "run", "replay", "report", "sweep", "plot", "test", "test fuzz", "test soak"}) {
    CHECK_THAT(page, Contains(std::string(".SS \"pantin ") + command + " "));
    const std::string run = sources::program() + " " + command + " --help";
    const std::string help = finish({{"/bin/bash", "-c", run}, {}, folder.path.string(), -1}).out;
    const std::regex option("\n +(?:-.,)?(--[a-z-]+)");
    for (std::sregex_iterator at(help.begin(), help.end(), option), end; at != end; ++at, options++)
      CHECK_THAT(page, Contains((*at)[1].str()));
  }
  CHECK(options > 50);
}

TEST_CASE("manual: groff has nothing to complain of") {
  if (!have_program("groff")) return;
  const Folder folder;
  write_file(folder / "pantin.1", pantin::player::manual_page());
  const Finished done = finish({{"groff", "-man", "-ww", "-Tascii", "pantin.1"}, {}, folder.path.string(), -1});
  CHECK(done.code == 0);
  CHECK(done.err == "");
}

TEST_CASE("manual: bash completes commands, options, scenes and files") {
  const Folder folder;
  write_file(folder / "clock_of_mine.lua", "");
  CHECK(offered(folder, "pantin re") == "replay report ");
  CHECK(offered(folder, "pantin run --un") == "--until --untrusted ");
  CHECK(offered(folder, "pantin play cl") == "cloth clock_of_mine.lua ");
  CHECK(offered(folder, "pantin run chain --out cl") == "clock_of_mine.lua ");
  CHECK(offered(folder, "pantin test fuzz --see") == "--seed ");
  CHECK_THAT(offered(folder, "pantin ''"), !Contains("meta"));
}
