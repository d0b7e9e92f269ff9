#include "lua/equality.hpp"

#include <cstdint>
#include <cstring>
#include <string_view>
#include <vector>

#include "base/check.hpp"

namespace pantin::lua {
namespace {

// Lua 5.4's binary chunks and operations (lundump.c, lopcodes.h).
constexpr std::size_t header_size = 4 + 1 + 1 + 6 + 3 + 8 + 8 + 1;
constexpr std::uint32_t op_eq = 57, op_eqk = 60, op_eqi = 61;
constexpr std::uint8_t integer_constant = 0x03, float_constant = 0x13, short_string = 0x04, long_string = 0x14;
constexpr std::int8_t absolute_line = -0x80;

/// Reads a dumped function.
class Chunk {
 public:
  explicit Chunk(std::string_view bytes) : rest_(bytes.substr(header_size)) {}

  /// The line of the first equality test of a function and those inside of it, or 0.
  int function() {
    skip_string();
    const int first_line = integer();
    integer();
    skip(3);
    std::vector<std::uint32_t> code(static_cast<std::size_t>(integer()));
    for (std::uint32_t& instruction : code) instruction = word();
    const std::vector<bool> numbers = constants();
    skip(3 * static_cast<std::size_t>(integer()));
    int inner = 0;
    for (int count = integer(); count > 0; count--) {
      const int line = function();
      if (inner == 0) inner = line;
    }
    const std::vector<int> lines = line_numbers(first_line, code.size());
    skip_names();
    for (std::size_t i = 0; i < code.size(); i++)
      if (is_test(code[i], numbers)) return i < lines.size() ? lines[i] : first_line;
    return inner;
  }

 private:
  static bool is_test(std::uint32_t instruction, const std::vector<bool>& numbers) {
    const std::uint32_t operation = instruction & 0x7f, constant = (instruction >> 16) & 0xff;
    return operation == op_eq || operation == op_eqi || (operation == op_eqk && numbers.at(constant));
  }

  void skip(std::size_t count) {
    assume(count <= rest_.size());
    rest_.remove_prefix(count);
  }
  std::uint8_t byte() {
    const auto value = static_cast<std::uint8_t>(rest_.at(0));
    skip(1);
    return value;
  }
  std::uint32_t word() {
    std::uint32_t value = 0;
    assume(rest_.size() >= sizeof value);
    std::memcpy(&value, rest_.data(), sizeof value);
    skip(sizeof value);
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
  int integer() { return static_cast<int>(size()); }
  void skip_string() {
    const std::size_t length = size();
    if (length > 0) skip(length - 1);
  }

  /// Which constants are numbers.
  std::vector<bool> constants() {
    std::vector<bool> numbers(static_cast<std::size_t>(integer()));
    for (std::size_t i = 0; i < numbers.size(); i++) {
      const std::uint8_t type = byte();
      numbers[i] = type == integer_constant || type == float_constant;
      if (numbers[i]) skip(8);
      if (type == short_string || type == long_string) skip_string();
    }
    return numbers;
  }

  std::vector<int> line_numbers(int first_line, std::size_t count) {
    std::vector<std::int8_t> steps(static_cast<std::size_t>(integer()));
    for (std::int8_t& step : steps) step = static_cast<std::int8_t>(byte());
    std::vector<int> lines(steps.empty() ? 0 : count, first_line);
    const int absolutes = integer();
    std::vector<std::pair<std::size_t, int>> known;
    for (int i = 0; i < absolutes; i++) {
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
    for (int count = integer(); count > 0; count--) {
      skip_string();
      integer();
      integer();
    }
    for (int count = integer(); count > 0; count--) skip_string();
  }

  std::string_view rest_;
};

int append(lua_State*, const void* bytes, std::size_t count, void* to) {
  static_cast<std::string*>(to)->append(static_cast<const char*>(bytes), count);
  return 0;
}

}  // namespace

std::string equality_test(lua_State* state, int index) {
  lua_Debug function;
  lua_pushvalue(state, index);
  lua_pushvalue(state, -1);
  lua_getinfo(state, ">S", &function);
  std::string bytes;
  lua_dump(state, append, &bytes, 0);
  lua_pop(state, 1);
  const int line = Chunk(bytes).function();
  if (line == 0) return "";
  return text(
      function.short_src, ":", line,
      ": == or ~= on numbers cannot be traced, as it would be false of every pair (exact = false traces it so)");
}

}  // namespace pantin::lua
