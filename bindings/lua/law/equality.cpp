#include "lua/law/equality.hpp"

#include <cstdint>
#include <cstring>
#include <string_view>
#include <vector>

#include "base/check.hpp"

namespace pantin::lua {
namespace {

// Binary chunks and operations (lundump.c, lopcodes.h) are no interface: these releases of Lua have them as they are here.
constexpr int first_release = 50400, last_release = 50406;
// Signature, version, format, data that transfers break, sizes of an instruction, an integer and a number.
constexpr std::string_view header("\x1bLua\x54\0\x19\x93\r\n\x1a\n\x04\x08\x08", 15);
constexpr std::size_t header_size = header.size() + 8 + 8 + 1;
constexpr std::uint32_t op_gettable = 12, op_eq = 57, op_eqk = 60, op_eqi = 61;
constexpr std::uint8_t integer_constant = 0x03, float_constant = 0x13, short_string = 0x04, long_string = 0x14;
constexpr std::int8_t absolute_line = -0x80;

/// Reads a dumped function; throws Error where it is none.
class Chunk {
 public:
  explicit Chunk(std::string_view bytes) : rest_(bytes) { skip(header_size); }

  /// The line of the first equality test of a function and those inside of it, or 0.
  int function() {
    skip_string();
    const int first_line = integer();
    integer();
    skip(3);
    std::vector<std::uint32_t> code(count(4));
    for (std::uint32_t& instruction : code) {
      instruction = word();
      indexes_ = indexes_ || (instruction & 0x7f) == op_gettable;
    }
    const std::vector<bool> numbers = constants();
    skip(3 * count(3));
    int inner = 0;
    for (std::size_t left = count(1); left > 0; left--) {
      const int line = function();
      if (inner == 0) inner = line;
    }
    const std::vector<int> lines = line_numbers(first_line, code.size());
    skip_names();
    for (std::size_t i = 0; i < code.size(); i++)
      if (is_test(code[i], numbers)) return i < lines.size() ? lines[i] : first_line;
    return inner;
  }
  /// Whether one of them reads a table at a value.
  bool indexes() const { return indexes_; }

 private:
  static bool is_test(std::uint32_t instruction, const std::vector<bool>& numbers) {
    const std::uint32_t operation = instruction & 0x7f, constant = (instruction >> 16) & 0xff;
    require(operation != op_eqk || constant < numbers.size(), "a function has ", numbers.size(), " constants, not ",
            constant + 1);
    return operation == op_eq || operation == op_eqi || (operation == op_eqk && numbers[constant]);
  }

  void skip(std::size_t count) {
    require(count <= rest_.size(), "a function ends ", count - rest_.size(), " bytes too early");
    rest_.remove_prefix(count);
  }
  std::uint8_t byte() {
    const std::string_view from = rest_;
    skip(1);
    return static_cast<std::uint8_t>(from[0]);
  }
  std::uint32_t word() {
    std::uint32_t value = 0;
    const std::string_view from = rest_;
    skip(sizeof value);
    std::memcpy(&value, from.data(), sizeof value);
    return value;
  }
  /// Seven bits in each byte, the highest first; the last has its top bit set.
  std::size_t size() {
    std::size_t value = 0;
    for (;;) {
      const std::uint8_t next = byte();
      value = value << 7 | (next & 0x7f);
      if (next & 0x80) return value;
    }
  }
  int integer() {
    const std::size_t value = size();
    require(value < std::size_t{1} << 30, "a function has a number of ", value);
    return static_cast<int>(value);
  }
  /// How many things of at least `each` bytes come.
  std::size_t count(std::size_t each) {
    const std::size_t found = size();
    require(found <= rest_.size() / each, "a function ends before its ", found, " parts");
    return found;
  }
  void skip_string() {
    const std::size_t length = size();
    if (length > 0) skip(length - 1);
  }

  /// Which constants are numbers.
  std::vector<bool> constants() {
    std::vector<bool> numbers(count(1));
    for (std::size_t i = 0; i < numbers.size(); i++) {
      const std::uint8_t type = byte();
      numbers[i] = type == integer_constant || type == float_constant;
      if (numbers[i]) skip(8);
      if (type == short_string || type == long_string) skip_string();
    }
    return numbers;
  }

  std::vector<int> line_numbers(int first_line, std::size_t instructions) {
    std::vector<std::int8_t> steps(count(1));
    for (std::int8_t& step : steps) step = static_cast<std::int8_t>(byte());
    require(steps.empty() || steps.size() == instructions, "a function has ", instructions, " instructions and ",
            steps.size(), " lines");
    std::vector<int> lines(steps.size(), first_line);
    std::vector<std::pair<std::size_t, int>> known;
    for (std::size_t left = count(2); left > 0; left--) {
      const std::size_t at = size();
      known.emplace_back(at, integer());
    }
    int line = first_line;
    std::size_t next = 0;
    for (std::size_t i = 0; i < lines.size(); i++) {
      if (steps[i] != absolute_line)
        line += steps[i];
      else if (next < known.size())
        line = known[next++].second;
      lines[i] = line;
    }
    return lines;
  }

  void skip_names() {
    for (std::size_t left = count(3); left > 0; left--) {
      skip_string();
      integer();
      integer();
    }
    for (std::size_t left = count(1); left > 0; left--) skip_string();
  }

  std::string_view rest_;
  bool indexes_ = false;
};

int append(lua_State*, const void* bytes, std::size_t count, void* to) {
  static_cast<std::string*>(to)->append(static_cast<const char*>(bytes), count);
  return 0;
}

}  // namespace

std::optional<int> line_of_equality(std::string_view function, int release, bool* indexes) {
  if (release < first_release || release > last_release || !function.starts_with(header)) return {};
  try {
    Chunk chunk(function);
    const int line = chunk.function();
    if (indexes) *indexes = chunk.indexes();
    return line;
  } catch (const Error&) { return {}; }
}

Silent silent_of(lua_State* state, int index) {
  lua_Debug function;
  lua_pushvalue(state, index);
  lua_pushvalue(state, -1);
  lua_getinfo(state, ">S", &function);
  std::string bytes;
  lua_dump(state, append, &bytes, 0);
  lua_pop(state, 1);
  Silent silent;
  const std::optional<int> line = line_of_equality(bytes, LUA_VERSION_RELEASE_NUM, &silent.indexes);
  if (line == 0) return silent;
  if (!line)
    silent.equality =
        text(function.short_src, ":", function.linedefined, ": whether it tests numbers by == cannot be told in ",
             LUA_RELEASE, " (exact = false traces it, with == false of every pair)");
  else
    silent.equality =
        text(function.short_src, ":", *line,
             ": == or ~= on numbers cannot be traced, as it would be false of every pair (exact = false traces it so)");
  return silent;
}

}  // namespace pantin::lua
