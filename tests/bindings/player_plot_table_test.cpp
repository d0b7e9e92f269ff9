// `pantin plot`: columns of a table as lines and as a heat map.
#include "player/plot_table.hpp"

#include <catch2/catch.hpp>
#include <regex>

#include "bindings/program_support.hpp"
#include "player/csv.hpp"
#include "scene/errors.hpp"

using namespace pantin;
using namespace pantin::support;
using Catch::Contains;

namespace {

const char* const table =
    "case,size,rate,cost,name\n0,1,10,5,a\n1,2,10,7,a\n2,1,20,1,b\n3,2,20,x,b\n4,2,20,3,b\n5,2,20,5,b\n";

std::string picture(const Folder& folder, player::PlotOptions options, const std::string& content = table) {
  write_file(folder / "t.csv", content);
  options.table = folder / "t.csv";
  options.out = folder / "t.svg";
  CHECK(player::plot_table(options) == 0);
  return read_file(options.out);
}

double number_after(const std::string& text, const std::string& name, std::size_t from) {
  return std::stod(text.substr(text.find(name, from) + name.size(), 20));
}

std::size_t count(const std::string& text, const std::string& pattern) {
  const std::regex wanted(pattern);
  return static_cast<std::size_t>(
      std::distance(std::sregex_iterator(text.begin(), text.end(), wanted), std::sregex_iterator()));
}

}  // namespace

TEST_CASE("plot_table: a line for each value of a column, through the means of rows with an equal x") {
  Folder folder;
  const std::string svg = picture(folder, {.x = "size", .y = "cost", .by = "name"});
  CHECK(count(svg, "<polyline") == 2);
  CHECK(count(svg, "<circle") == 4);
  CHECK_THAT(svg, Contains("name = a") && Contains("name = b") && Contains(">t<"));
}

TEST_CASE("plot_table: one line needs no legend") {
  Folder folder;
  CHECK(count(picture(folder, {.x = "size", .y = "cost"}), "stroke-width=\"2.5\"") == 0);
  CHECK(count(picture(folder, {.x = "size", .y = "cost", .by = "name"}), "stroke-width=\"2.5\"") == 2);
}

TEST_CASE("plot_table: points alone, and axes that are logarithmic") {
  Folder folder;
  const std::string svg =
      picture(folder, {.x = "a", .y = "b", .log = {"b"}, .title = "a < b", .points = true}, "a,b\n1,2\n2,3000\n");
  CHECK(count(svg, "<polyline") == 0);
  CHECK_THAT(svg, Contains("10⁰") && Contains("10⁴") && Contains("a &lt; b"));
}

TEST_CASE("plot_table: a heat map has a tile for each pair that is known") {
  Folder folder;
  const std::string svg = picture(folder, {.x = "size", .y = "rate", .color = "cost"});
  CHECK(count(svg, "<rect") == 4 + 60);  // and the scale of colours
  CHECK_THAT(svg, Contains("#440154") && Contains("#fde725"));
}

TEST_CASE("plot_table: a heat map of a sample has the colour of the nearest case at each place") {
  Folder folder;
  const std::string svg =
      picture(folder, {.x = "a", .y = "b", .color = "k"}, "a,b,k\n1,10,0\n2,20,1\n3,11,0.5\n4,19,1\n");
  CHECK(count(svg, "<circle") == 4);
  double covered = 0.0;  // pixels²
  for (std::size_t at = 0; (at = svg.find("<rect", at)) != std::string::npos; at++)
    covered += number_after(svg, "width=\"", at) * number_after(svg, "height=\"", at);
  CHECK_THAT(covered, Catch::WithinRel(420.0 * 420.0 + 420.0 * 16.0, 1e-3));  // and the scale of colours
}

TEST_CASE("plot_table: a heat map is of all cases, and hatched where the nearest has no number or failed") {
  Folder folder;
  const std::string grid = picture(folder, {.x = "a", .y = "b", .color = "k"},
                                   "a,b,k,error\n1,1,,\n2,1,5,\n1,2,6,\n2,2,,bad\n3,1,,\n3,2,7,\n");
  CHECK(count(grid, "fill=\"url\\(#hatched\\)\"") == 3 + 1);  // and what it means
  CHECK_THAT(grid, Contains(">no number<") && Contains(">0.5<") && Contains(">3.5<"));
  const std::string sample =
      picture(folder, {.x = "a", .y = "b", .color = "k"}, "a,b,k\n1,10,0\n2,20,\n3,11,0.5\n4,19,1\n5,18,\n");
  CHECK(count(sample, "<circle") == 5);
  CHECK(count(sample, "hatched\\)") > 10);
  CHECK(count(picture(folder, {.x = "size", .y = "cost", .color = "rate"}), "hatched\\)") == 0);
  const Finished told =
      use(folder, {"plot", "t.csv", "--x", "size", "--y", "rate", "--color", "cost", "--out", "u.svg"});
  CHECK(told.out == "1 of 6 rows have no number 'cost', or tell an error: a place where none has one is hatched\n");
}

TEST_CASE("plot_table: the name of a bar of colours is along it, whatever its length") {
  Folder folder;
  const std::string svg =
      picture(folder, {.x = "a", .y = "b", .color = "tip height largest"}, "a,b,tip height largest\n1,1,3\n2,1,4\n");
  const std::size_t name = svg.find(">tip height largest<");
  REQUIRE(name != std::string::npos);
  CHECK_THAT(svg.substr(svg.rfind("<text", name), name - svg.rfind("<text", name)),
             Contains("rotate(-90") && Contains("middle"));
}

TEST_CASE("plot_table: more lines than a legend can tell apart have a bar of colours, or are refused") {
  Folder folder;
  std::string numbers = "a,b,k\n", names = "a,b,k\n";
  for (int i = 40; i > 0; i--)
    for (const char* a : {"1", "2"}) {
      numbers += text(a, ",", i, ",", i, "\n");
      names += text(a, ",", i, ",n", i, "\n");
    }
  for (const bool points : {false, true}) {
    const std::string svg = picture(folder, {.x = "a", .y = "b", .by = "k", .points = points}, numbers);
    CHECK(count(svg, "<polyline") == (points ? 0 : 40));
    CHECK_THAT(svg, Contains("#440154") && Contains("#fde725") && Contains(">k<") && !Contains("k = "));
    CHECK(number_after(svg, "height=\"", 0) < 400.0);
  }
  write_file(folder / "t.csv", names);
  const auto draw = [&](bool points) {
    player::plot_table(
        {.table = folder / "t.csv", .x = "a", .y = "b", .by = "k", .points = points, .out = folder / "t.svg"});
  };
  CHECK_THROWS_WITH(draw(false), Contains("40 different values") && Contains("16 can be told apart"));
  CHECK_THROWS_WITH(draw(true), Contains("8 can be told apart"));
}

TEST_CASE("plot_table: a legend has numbers in rising order, and dots for points") {
  Folder folder;
  const std::string rows = "a,b,k\n1,1,20\n2,1,20\n1,2,3\n1,3,100\n";
  const std::string svg = picture(folder, {.x = "a", .y = "b", .by = "k"}, rows);
  CHECK((svg.find("k = 3<") < svg.find("k = 20<") && svg.find("k = 20<") < svg.find("k = 100<")));
  const std::string dots = picture(folder, {.x = "a", .y = "b", .by = "k", .points = true}, rows);
  CHECK(count(dots, "<circle") == 4 + 3);
  CHECK(count(dots, "stroke-width=\"2.5\"") == 0);
}

TEST_CASE("plot_table: a logarithmic axis of less than two decades has ticks between powers of ten, and ends there") {
  Folder folder;
  const std::string svg = picture(folder, {.x = "a", .y = "b", .log = {"a"}}, "a,b\n0.6,100\n1.5,200\n3,300\n");
  for (const char* label : {">0.5<", ">1<", ">2<", ">5<"}) CHECK_THAT(svg, Contains(label));
  for (const char* label : {">0.2<", ">10<"}) CHECK_THAT(svg, !Contains(label));
}

TEST_CASE("plot_table: what cannot be drawn is told, and leaves no file") {
  Folder folder;
  write_file(folder / "t.csv", table);
  const auto refused = [&](player::PlotOptions options, const char* why) {
    options.table = folder / "t.csv";
    options.out = folder / "t.svg";
    CHECK_THROWS_WITH(player::plot_table(options), Contains(why));
    CHECK(folder.files() == std::vector<std::string>{"t.csv"});
  };
  refused({.x = "sise", .y = "cost"}, "no column 'sise'. It has case, size, rate, cost, name");
  refused({.x = "size", .y = "name"}, "no row has numbers");
  refused({.x = "size", .y = "cost", .by = "name", .color = "rate"}, "one of them");
  refused({.x = "size", .y = "cost", .color = "rate", .points = true}, "one of them");
  refused({.x = "size", .y = "cost", .log = {"rate"}}, "no axis");
  write_file(folder / "t.csv", "a,b,a\n1,2,3\n");
  refused({.x = "a", .y = "b"}, "more than one column 'a'");
  write_file(folder / "t.csv", "a,b\n1\n");
  refused({.x = "a", .y = "b"}, "row 2 has 1 cells");
  write_file(folder / "t.csv", "a,b\n");
  refused({.x = "a", .y = "b"}, "has no rows");
}

TEST_CASE("plot_table: values that differ in their fifth digit are lines of their own, named in full") {
  Folder folder;
  write_file(folder / "t.csv", "a,b,k\n1,2,1.00001\n1,4,1.00002\n");
  CHECK(player::plot_table({.table = folder / "t.csv", .x = "a", .y = "b", .by = "k", .out = folder / "t.svg"}) == 0);
  const std::string svg = read_file(folder / "t.svg");
  CHECK(count(svg, "<circle") == 2);
  CHECK_THAT(svg, Contains("k = 1.00001") && Contains("k = 1.00002"));
}

TEST_CASE("plot_table: rows that tell an error are left out, and counted") {
  Folder folder;
  write_file(folder / "t.csv", "a,b,error\n1,2,\n2,3,\n3,9,too long\n");
  CHECK(player::plot_table({.table = folder / "t.csv", .x = "a", .y = "b", .out = folder / "t.svg"}) == 0);
  CHECK(count(read_file(folder / "t.svg"), "<circle") == 2);
  const Finished told = use(folder, {"plot", "t.csv", "--x", "a", "--y", "b", "--out", "u.svg"});
  CHECK(told.out == "1 row tells an error and is left out\n");
}

TEST_CASE("plot_table: a table is read as it was written, with quotes and line breaks in cells") {
  const std::string cell = "he said \"no, never\"\nand left";
  const auto rows = player::read_csv("a," + player::csv_cell(cell) + "\r\n1,2\n");
  CHECK(rows == std::vector<std::vector<std::string>>{{"a", cell}, {"1", "2"}});
}
