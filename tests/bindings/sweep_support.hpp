#pragma once
// What tests read of sweeps: tables, rows, cells and processes.
#include <sstream>
#include <string>
#include <vector>

#include "bindings/program_support.hpp"
#include "player/sweep/cases.hpp"

namespace pantin::support {

inline const char* const pendulum = R"(
local length = scene:param("length", 1.0, { min = 0.1, max = 10 })
local links = scene:param("links", 3)
local bob = scene:particle { at = vec(length, 0, 0), mass = 1 }
scene:rod(bob, vec(0, 0, 0))
scene:probe("height", function() return bob.position.y end)
scene:result("noise", math.random())
if length > 4.5 then error("too long") end
)";

inline std::vector<std::string> values_of(const player::Axis& axis) {
  std::vector<std::string> values;
  for (std::uint64_t i = 0; i < axis.size(); i++) values.push_back(axis.value(i));
  return values;
}

inline std::vector<std::string> rows_of(const std::string& table) {
  std::vector<std::string> rows;
  std::istringstream in(table);
  for (std::string row; std::getline(in, row);) rows.push_back(row);
  return rows;
}

inline std::vector<std::string> cells_of(const std::string& row) {
  std::vector<std::string> cells;
  std::istringstream in(row);
  for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
  return cells;
}

inline std::vector<int> children_of(int process) {
  const std::string id = std::to_string(process);
  std::istringstream in(read_file("/proc/" + id + "/task/" + id + "/children"));
  std::vector<int> all;
  for (int child = 0; in >> child;) all.push_back(child);
  return all;
}

/// A sweep in a folder that has the pendulum, into t.csv.
inline Finished sweep_pendulum(const Folder& folder, std::vector<std::string> more) {
  write_file(folder / "pendulum.lua", pendulum);
  std::vector<std::string> arguments = {"sweep", "pendulum.lua", "--until", "0.2", "--out", "t.csv"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return use(folder, arguments);
}

const std::vector<std::string> grid = {"--set", "length=1:4:4", "--set", "links=2,3", "--seeds", "1:5"};

}  // namespace pantin::support
