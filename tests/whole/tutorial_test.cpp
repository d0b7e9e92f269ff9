// The tutorial as a reader follows it: each file is saved, each command of a block runs.
#include <catch2/catch.hpp>
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include "bindings/program_support.hpp"

using namespace pantin::support;
namespace sources = pantin::sources;

namespace {

struct Block {
  std::string language, before, text;  ///< before: the paragraph that it follows
};

std::vector<Block> blocks_of(const std::string& page) {
  std::vector<Block> blocks;
  const std::regex fenced(R"(([^\n]*)\n\n```(\w+)\n([^`]*)```)");
  for (std::sregex_iterator at(page.begin(), page.end(), fenced), end; at != end; ++at)
    blocks.push_back({(*at)[2], (*at)[1], (*at)[3]});
  return blocks;
}

std::string tutorial() { return read_file(sources::folder() + "/assets/pages/tutorial.md"); }

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
  return text;
}

}  // namespace

TEST_CASE("tutorial: each of its scenes runs for ten seconds, and each of its commands does what it says") {
  Folder folder;
  int scenes = 0, commands = 0;
  for (const Block& block : blocks_of(tutorial())) {
    if (block.language == "lua") {
      std::smatch name;
      REQUIRE(std::regex_match(block.before, name, std::regex("`(\\w+\\.lua)`:")));
      write_file(folder / name.str(1), block.text);
      if (name.str(1).ends_with("_test.lua")) continue;
      const Finished run = use(folder, {"run", name.str(1), "--until", "10"});
      INFO(name.str(1) << ": " << run.err);
      CHECK(run.code == 0);
      CHECK(run.err == "");
      scenes++;
    } else {
      Process::Options bash = options({}, folder.path.string());
      bash.arguments = {"/bin/bash", "-ec", replaced(block.text, "./pantin", sources::program())};
      const Finished done = finish(bash);
      INFO(block.text << done.out << done.err);
      CHECK(done.code == 0);
      commands++;
    }
  }
  CHECK(scenes == 6);
  CHECK(commands == 4);
  for (const char* file : {"ball.csv", "heights.svg", "throw.csv", "throw.svg"})
    CHECK(std::filesystem::exists(folder / file));
}

TEST_CASE("tutorial: its pictures are there") {
  const std::string page = tutorial();
  const std::regex picture(R"(!\[[^\]]+\]\(([^)]+)\))");
  int count = 0;
  for (std::sregex_iterator at(page.begin(), page.end(), picture), end; at != end; ++at, count++)
    CHECK(std::filesystem::exists(sources::folder() + "/assets/pages/" + (*at)[1].str()));
  CHECK(count == 7);
}
