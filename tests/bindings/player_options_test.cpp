#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "player/options.hpp"
#include "scene/errors.hpp"

using namespace pantin::player;
using Catch::Contains;
using pantin::text;
using pantin::UsageError;

namespace {

Options read(std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), "pantin");
  return read_options(static_cast<int>(arguments.size()), arguments.data());
}

}  // namespace

TEST_CASE("options: run with everything") {
  Options o = read({"run",
                    "--set",
                    "links=5",
                    "chain",
                    "--set",
                    "scene.step=1/60",
                    "--until",
                    "2.5",
                    "--out",
                    "a.csv",
                    "--out",
                    "b.mp4",
                    "--summary",
                    "s.json",
                    "--size",
                    "640x480",
                    "--script-limit",
                    "0",
                    "--memory-limit",
                    "64MiB"});
  CHECK(o.command == Options::Command::run);
  CHECK(o.run.scene == "chain");
  CHECK(o.run.set == std::map<std::string, std::string>{{"links", "5"}, {"scene.step", "1/60"}});
  CHECK(o.run.until == 2.5);
  CHECK(o.run.outputs == std::vector<std::string>{"a.csv", "b.mp4"});
  CHECK(o.run.summary == "s.json");
  CHECK(o.run.size.width == 640);
  CHECK(o.run.size.height == 480);
  CHECK(o.run.script_limit == 0.0);
  CHECK(o.run.memory_limit == std::size_t{64} << 20);
}

TEST_CASE("options: views are those that are on at first, with what is named and without what has a minus") {
  const Options o = read({"run", "chain", "--out", "a.png", "--view", "rings,-shadows"});
  CHECK(o.run.views.on(pantin::View::rings));
  CHECK(o.run.views.on(pantin::View::bodies));
  CHECK_FALSE(o.run.views.on(pantin::View::shadows));
  CHECK_THROWS_WITH(read({"run", "chain", "--view", "halos"}), Contains("there is no view 'halos'; there are: bodies"));
}

TEST_CASE("options: names in a list are told apart by commas, and none is given twice") {
  const Options o = read({"run", "--out", "a.csv", "--when", "a,b", "--reduce", "mean", "--reduce", "rms", "chain"});
  CHECK(o.run.table.when == std::vector<std::string>{"a", "b"});
  CHECK(o.run.table.reductions == std::vector<std::string>{"mean", "rms"});
  CHECK(o.run.scene == "chain");
  for (const char* option : {"--reduce", "--when"})
    CHECK_THROWS_WITH(read({"run", "chain", "--out", "a.csv", "--when", "rms", option, "rms", option, "rms"}),
                      Contains(text(option, ": 'rms' is given twice")));
}

TEST_CASE("options: what is not said") {
  Options o = read({"play"});
  CHECK(o.command == Options::Command::play);
  CHECK(o.run.scene.empty());
  CHECK_FALSE(o.run.until);
  CHECK(o.run.size.width == 1280);
  CHECK(o.run.size.height == 720);
  CHECK(o.run.script_limit == 5.0);
  CHECK(o.run.memory_limit == std::size_t{2} << 30);
}

TEST_CASE("options: sizes of memory have units") {
  CHECK(read_bytes("1048576") == 1 << 20);
  CHECK(read_bytes("1.5GB") == 1'500'000'000);
  CHECK(read_bytes("64MiB") == 64 << 20);
  CHECK(read_bytes("2GiB") == std::size_t{2} << 30);
}

TEST_CASE("options: a value may hold an equals sign, or be empty") {
  CHECK(read({"run", "chain", "--set", "text=a=b"}).run.set.at("text") == "a=b");
  CHECK(read({"run", "chain", "--set", "text="}).run.set.at("text").empty());
}

TEST_CASE("options: tests and benchmarks take names") {
  CHECK(read({"test", "a", "b"}).arguments == std::vector<std::string>{"a", "b"});
  CHECK(read({"bench", "chain", "100"}).arguments == std::vector<std::string>{"chain", "100"});
  CHECK_FALSE(read({"bench", "forces"}).peers);
  CHECK(read({"bench", "forces", "--peers"}).peers);
}

TEST_CASE("options: tests of random scenes and of long runs") {
  const Options fuzz = read({"test", "fuzz", "--seconds", "5", "--seed", "12"});
  CHECK(fuzz.command == Options::Command::fuzz);
  CHECK(fuzz.fuzz.seconds == 5.0);
  CHECK(fuzz.fuzz.seed == 12);
  const Options soak = read({"test", "soak", "--scene", "chain", "--steps", "1000"});
  CHECK(soak.command == Options::Command::soak);
  CHECK(soak.soak.scene == "chain");
  CHECK(soak.soak.steps == 1000);
  CHECK(read({"test", "soak"}).soak.scene.empty());
  CHECK(read({"test", "a_test.lua"}).command == Options::Command::test);
  CHECK_THROWS_WITH(read({"test", "fuzz", "--seconds", "long"}), Contains("--seconds"));
  CHECK_THROWS_WITH(read({"test", "fuzz", "--seed", "-1"}), Contains("--seed"));
}

TEST_CASE("options: wrong use names what is wrong and what is allowed") {
  CHECK_THROWS_AS(read({}), UsageError);
  CHECK_THROWS_WITH(read({"dance"}), Contains("dance"));
  CHECK_THROWS_WITH(read({"run"}), Contains("scene"));
  CHECK_THROWS_WITH(read({"run", "chain", "--out", "a.txt"}),
                    Contains("a.txt") && Contains(".csv") && Contains(".webp"));
  CHECK_THROWS_WITH(read({"run", "chain", "--set", "links"}), Contains("links") && Contains("name=value"));
  CHECK_THROWS_WITH(read({"run", "chain", "--until", "-1"}), Contains("-1") && Contains(">= 0"));
  CHECK_THROWS_WITH(read({"run", "chain", "--until", "nan"}), Contains("nan"));
  CHECK_THROWS_WITH(read({"run", "chain", "--until", "soon"}), Contains("soon"));
  CHECK_THROWS_WITH(read({"run", "chain", "--size", "0x5"}), Contains("0x5") && Contains("pixels"));
  CHECK_THROWS_WITH(read({"run", "chain", "--size", "1280"}), Contains("WIDTHxHEIGHT"));
  for (const char* wrong : {"much", "0.1", "0", "-1GiB", "64kB", "1 furlong", "1e30GiB"})
    CHECK_THROWS_WITH(read({"run", "chain", text("--memory-limit=", wrong).c_str()}),
                      Contains(text("'", wrong, "' must be a size of 1MiB or more")));
  CHECK_THROWS_WITH(read({"run", "chain", "--colour", "red"}), Contains("--colour") && Contains("run --help"));
}

TEST_CASE("options: what would be of no use is refused") {
  CHECK_THROWS_WITH(read({"run", "chain", "--set", "links=3", "--set", "links=4"}),
                    Contains("--set links=4: 'links' is set twice"));
  CHECK_THROWS_WITH(read({"run", "chain", "--every", "0.1"}), Contains("--every is for what --out writes"));
  CHECK_THROWS_WITH(read({"run", "chain", "--out", "a.png", "--when", "height"}), Contains("--when is for"));
  CHECK_THROWS_WITH(read({"play", "chain", "--every", "0.1"}), Contains(".csv or .h5"));
  CHECK_THROWS_WITH(read({"run", "chain", "--out", "a.csv", "--size", "64x64"}), Contains("--size is for"));
  CHECK_THROWS_WITH(read({"run", "chain", "--view", "rings"}), Contains("--view is for") && Contains(".png"));
  CHECK(read({"play", "chain", "--size", "640x480", "--view", "rings"}).run.size.width == 640);
  CHECK(read({"run", "chain", "--out", "a.h5", "--every", "0.1"}).run.table.every == 0.1);
}

TEST_CASE("message: a script's line is known") {
  CHECK(pantin::names_place("chain.lua:12: body: mass must be > 0 kg, got -1"));
  CHECK(pantin::names_place("a folder/my chain.lua:3: x"));
  CHECK_FALSE(pantin::names_place("there is no scene 'x': give a file"));
  CHECK_FALSE(pantin::names_place("cannot write a.csv: 12: no"));
  CHECK_FALSE(pantin::names_place(""));
}
