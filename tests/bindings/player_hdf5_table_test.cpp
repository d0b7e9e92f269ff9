// Tables as HDF5, read back by the library and by its own program; without it, what is told.
#include "player/hdf5_table.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "bindings/program_support.hpp"
#include "player/csv.hpp"
#include "scene/errors.hpp"

using namespace pantin;
using namespace pantin::support;
using Catch::Contains;
using player::Column, player::csv_text, player::hdf5_content, player::read_hdf5;

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

const std::vector<Column> odd = {
    {"time", "s", std::vector<double>{1.0 / 3.0, 1e300, -0.0}, false},
    {"v/m, \"s\"", "m/s", std::vector<double>{unknown, 2, std::numeric_limits<double>::infinity()}, false},
    {"kind", "", std::vector<std::string>{"rod", "", "Stäbe,\n2"}, false},
    {"ratio", "", std::vector<std::string>{"1", "", "2.5e3"}, false},
    {"hash", "", std::vector<std::string>{"1234567890123456", "00", "1e5"}, true},
    {".", "", std::vector<double>{1, 2, 3}, false}};

const char* const ball = R"(
local height = scene:param("height", 1.0)
local kind = scene:param("kind", "a")
local p = scene:particle { at = vec(0, height, 0) }
scene:probe("y", function() return p.position.y end)
scene:result("kind told", kind)
if height == 2 then error("too high") end
)";

std::vector<Column> file_of(const Folder& folder, const std::vector<Column>& columns) {
  write_file(folder / "t.h5", hdf5_content(columns));
  return read_hdf5(folder / "t.h5");
}

}  // namespace

TEST_CASE("hdf5_table: columns come back with names, units and all bits; texts that are numbers as numbers") {
  if (!player::has_hdf5()) return;
  Folder folder;
  const std::vector<Column> back = file_of(folder, odd);
  REQUIRE(back.size() == odd.size());
  for (std::size_t i = 0; i < odd.size(); i++) {
    CHECK(back[i].name == odd[i].name);
    CHECK(back[i].unit == odd[i].unit);
  }
  const auto numbers = [&](std::size_t i) { return std::get<std::vector<double>>(back[i].cells); };
  CHECK(numbers(0) == std::get<std::vector<double>>(odd[0].cells));
  CHECK(std::signbit(numbers(0)[2]));
  CHECK((std::isnan(numbers(1)[0]) && std::isinf(numbers(1)[2])));
  CHECK(std::get<std::vector<std::string>>(back[2].cells) == std::get<std::vector<std::string>>(odd[2].cells));
  CHECK((numbers(3)[0] == 1.0 && std::isnan(numbers(3)[1]) && numbers(3)[2] == 2500.0));
  CHECK(std::get<std::vector<std::string>>(back[4].cells)[2] == "1e5");
  CHECK(hdf5_content(odd) == hdf5_content(odd));
}

TEST_CASE("hdf5_table: columns whose names HDF5 takes for one, and numbers none of which is known") {
  if (!player::has_hdf5()) return;
  Folder folder;
  const auto back = file_of(folder, {{"a/b", "", std::vector<double>{1}, false},
                                     {"a∕b", "", std::vector<double>{2}, false},
                                     {"empty", "", std::vector<std::string>{""}, false}});
  CHECK(csv_text(back) == "a/b,a∕b,empty\n1,2,\n");
  CHECK(std::holds_alternative<std::vector<double>>(back.at(2).cells));
}

TEST_CASE("hdf5_table: no rows, and more than one chunk") {
  if (!player::has_hdf5()) return;
  Folder folder;
  const auto none =
      file_of(folder, {{"a", "", std::vector<double>{}, false}, {"b", "", std::vector<std::string>{}, false}});
  CHECK(csv_text(none) == "a,b\n");
  std::vector<double> many(200'000);
  for (std::size_t i = 0; i < many.size(); i++) many[i] = std::sqrt(static_cast<double>(i));
  CHECK(std::get<std::vector<double>>(file_of(folder, {{"a", "", many, false}})[0].cells) == many);
}

TEST_CASE("hdf5_table: other programs read it") {
  if (!player::has_hdf5() || !have_program("h5dump")) return;
  Folder folder;
  write_file(folder / "t.h5", hdf5_content(odd));
  Process::Options dump = options({}, folder.path);
  dump.arguments = {"h5dump", "-p", "t.h5"};
  const Finished told = finish(dump);
  CHECK(told.code == 0);
  CHECK_THAT(told.out, Contains("GROUP \"table\"") && Contains("DATASET \"time\"") && Contains("COMPRESSION DEFLATE"));
  CHECK_THAT(told.out, Contains("PREPROCESSING SHUFFLE") && Contains("ATTRIBUTE \"unit\"") && Contains("\"m/s\""));
  CHECK_THAT(told.out, Contains("H5T_IEEE_F64LE") && Contains("H5T_CSET_UTF8") && Contains("\"rod\""));
}

TEST_CASE("hdf5_table: a run and a sweep write what they write as .csv, and plot reads it") {
  if (!player::has_hdf5()) return;
  Folder folder;
  write_file(folder / "ball.lua", ball);
  REQUIRE(use(folder, {"run", "ball.lua", "--until", "0.1", "--out", "r.csv", "--out", "r.h5"}).code == 0);
  CHECK(csv_text(read_hdf5(folder / "r.h5")) == read_file(folder / "r.csv"));
  for (const char* out : {"s.csv", "s.h5"})
    REQUIRE(use(folder,
                {"sweep", "ball.lua", "--set", "height=1,2,1/2", "--set", "kind=a,b", "--until", "0.1", "--out", out})
                .code == 0);
  CHECK(csv_text(read_hdf5(folder / "s.h5")) == read_file(folder / "s.csv"));
  CHECK(read_hdf5(folder / "s.h5").at(7).unit == "s");
  for (const char* table : {"s.csv", "s.h5"})
    REQUIRE(use(folder, {"plot", table, "--x", "height", "--y", "y last", "--by", "kind", "--title", "y", "--out",
                         std::string(table) + ".svg"})
                .code == 0);
  CHECK(read_file(folder / "s.h5.svg") == read_file(folder / "s.csv.svg"));
}

TEST_CASE("hdf5_table: what is none is told by its name") {
  Folder folder;
  write_file(folder / "no.h5", "time,y\n1,2\n");
  const Finished plot = use(folder, {"plot", "no.h5", "--x", "a", "--y", "b", "--out", "a.svg"});
  CHECK(plot.code == 2);
  if (player::has_hdf5()) {
    CHECK_THAT(plot.err, Contains("no.h5 is no table"));
    write_file(folder / "cut.h5", hdf5_content(odd).substr(0, 3000));
    CHECK_THROWS_WITH(read_hdf5(folder / "cut.h5"), Contains("cut.h5 is no table"));
  } else {
    CHECK_THAT(plot.err, Contains("without HDF5"));
    CHECK_THAT(use(folder, {"run", "chain", "--out", "a.h5"}).err, Contains("libhdf5-dev"));
    CHECK_THAT(use(folder, {"sweep", "chain", "--seeds", "1:2", "--out", "a.h5"}).err, Contains("libhdf5-dev"));
  }
}
