#include "lua/vm/prototypes.hpp"

#include <cstdint>
#include <string_view>

#include "base/check.hpp"
#include "lua/vm/runtime.hpp"

namespace pantin::lua {
namespace {

/// Goes through what Lua 5.4 dumps (ldump.c) and cuts out each function.
class Cutter {
 public:
  explicit Cutter(std::string_view dump) : dump_(dump), header_(dump.substr(0, header_size)) {
    at_ = header_size + 1;
    const std::size_t source = at_;
    skip_string();
    source_ = dump.substr(source, at_ - source);
    at_ = source;
    function();
    require(at_ == dump_.size(), "a fault of Pantin itself: what Lua dumps is not understood");
  }
  std::vector<std::string> cut;

 private:
  // "\x1bLua", version, format, 6 bytes of data, three sizes, an integer and a number.
  static constexpr std::size_t header_size = 4 + 1 + 1 + 6 + 3 + 8 + 8;
  static constexpr std::uint8_t integer = 0x03, number = 0x13, short_string = 0x04, long_string = 0x14;

  std::uint8_t byte() {
    require(at_ < dump_.size(), "a fault of Pantin itself: what Lua dumps ends too early");
    return static_cast<std::uint8_t>(dump_[at_++]);
  }
  std::size_t size() {
    std::size_t x = 0;
    for (;;) {
      const std::uint8_t b = byte();
      x = (x << 7) | (b & 0x7fu);
      if ((b & 0x80u) != 0) return x;
    }
  }
  void skip_string() {
    if (const std::size_t n = size(); n > 0) at_ += n - 1;
  }
  void skip_constant() {
    switch (byte()) {
      case integer:
      case number: at_ += 8; break;
      case short_string:
      case long_string: skip_string(); break;
      default: break;
    }
  }
  template <class Skip>
  void skip_list(Skip skip) {
    for (std::size_t n = size(); n > 0; n--) skip();
  }

  void function() {
    const std::size_t place = cut.size();
    cut.emplace_back();
    skip_string();  // of inner ones it is left out
    const std::size_t begin = at_;
    size();
    size();
    at_ += 3;
    at_ += 4 * size();
    skip_list([&] { skip_constant(); });
    const std::size_t upvalues = size();
    at_ += 3 * upvalues;
    skip_list([&] { function(); });
    at_ += size();
    skip_list([&] {
      size();
      size();
    });
    skip_list([&] {
      skip_string();
      size();
      size();
    });
    skip_list([&] { skip_string(); });
    std::string& whole = cut[place];
    whole.assign(header_);
    whole += static_cast<char>(upvalues);
    whole += source_;
    whole += dump_.substr(begin, at_ - begin);
  }

  std::string_view dump_, header_, source_;
  std::size_t at_ = 0;
};

int append(lua_State*, const void* data, std::size_t size, void* to) {
  static_cast<std::string*>(to)->append(static_cast<const char*>(data), size);
  return 0;
}

}  // namespace

std::string dumped(lua_State* state) {
  std::string dump;
  lua_dump(state, append, &dump, 0);
  return dump;
}

std::vector<std::string> prototypes(lua_State* state, const SourceText& chunk) {
  load_text(state, chunk);
  const std::string dump = dumped(state);
  lua_pop(state, 1);
  return Cutter(dump).cut;
}

}  // namespace pantin::lua
