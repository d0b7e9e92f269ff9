// `read_table "file.csv"`: numbers from the scene's folder.
#include <algorithm>
#include <charconv>
#include <string_view>
#include <vector>

#include "lua/library/sandbox.hpp"
#include "lua/value/arguments.hpp"
#include "lua/vm/runtime.hpp"
#include "scene/files.hpp"

namespace pantin::lua {
namespace {

std::string_view trimmed(std::string_view s) {
  const char* const blank = " \t\r";
  const auto from = s.find_first_not_of(blank);
  return from == s.npos ? std::string_view{} : s.substr(from, s.find_last_not_of(blank) - from + 1);
}

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  for (;;) {
    const auto comma = line.find(',');
    std::string_view cell = trimmed(line.substr(0, comma));
    if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') cell = cell.substr(1, cell.size() - 2);
    cells.push_back(cell);
    if (comma == line.npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

std::optional<double> number_of(std::string_view cell) {
  if (cell.starts_with('+')) cell.remove_prefix(1);
  double value = 0.0;
  const auto result = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (result.ec != std::errc{} || result.ptr != cell.data() + cell.size()) return {};
  return value;
}

struct Csv {
  lua_State* state;
  std::string name;
  std::vector<std::string> columns;  // names, where a first line has them
  std::size_t width = 0;
  lua_Integer rows = 0;

  void add_row(const std::vector<std::string_view>& cells, std::size_t line) {
    lua_createtable(state, static_cast<int>(cells.size()), static_cast<int>(columns.size()));
    for (std::size_t i = 0; i < cells.size(); i++) {
      const auto value = number_of(cells[i]);
      require(value.has_value(), "read_table: ", name, ":", line, ": column ", i + 1, " must be a number, got '",
              cells[i], "'");
      lua_pushnumber(state, *value);
      if (!columns.empty()) {
        lua_pushvalue(state, -1);
        lua_setfield(state, -3, columns[i].c_str());
      }
      lua_rawseti(state, -2, static_cast<lua_Integer>(i + 1));
    }
    lua_rawseti(state, -2, ++rows);
  }

  void add_line(std::string_view text_of_line, std::size_t line) {
    if (text_of_line.empty() || text_of_line.front() == '#') return;
    const auto cells = cells_of(text_of_line);
    if (width == 0) {
      width = cells.size();
      bool names = true;
      for (const auto& cell : cells) names = names && !cell.empty() && !number_of(cell);
      if (names) return columns.assign(cells.begin(), cells.end());
    }
    require(cells.size() == width, "read_table: ", name, ":", line, ": must have ", width,
            " columns like the first line, got ", cells.size());
    add_row(cells, line);
  }
};

int read_table(lua_State* state) {
  check_count(state, 1, "read_table");
  const std::string name = check_text(state, 1, "read_table", "argument 1, the file,");
  require(stays_inside(name), "read_table: '", name,
          "' must be a file below the scene's folder, not an absolute path or one with ..");
  const std::string path = path_in(Runtime::of(state).folder, name);
  require(lies_below(path, Runtime::of(state).folder), "read_table: '", name, "' leads out of the scene's folder");
  const std::string* content = Runtime::of(state).read(path, largest_file);
  require(content != nullptr, "read_table: there is no file '", path, "'");
  lua_newtable(state);
  Csv csv{state, name, {}};
  std::string_view rest = *content;
  if (rest.starts_with("\xef\xbb\xbf")) rest.remove_prefix(3);
  Interruptible loop;
  for (std::size_t line = 1; !rest.empty(); line++) {
    const auto end = std::min(rest.find('\n'), rest.size());
    loop.count_bytes(end);
    require(end <= longest_line, "read_table: ", name, ":", line, ": the line has ", end, " bytes; at most ",
            longest_line, " are read");
    csv.add_line(trimmed(rest.substr(0, end)), line);
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return 1;
}

}  // namespace

void open_read_table(lua_State* state) { lua_register(state, "read_table", guard<read_table>); }

}  // namespace pantin::lua
