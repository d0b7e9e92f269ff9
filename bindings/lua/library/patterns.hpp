#pragma once
// Matching of Lua's patterns (Lua 5.4 Reference Manual, 6.4.1), as the string library's own but within the limit of time.
#include <array>
#include <cstddef>
#include <string_view>

#include "lua/vm/watchdog.hpp"

namespace pantin::lua {

/// One pattern on one subject. A pattern that is malformed throws Error when the match comes to the fault, as in Lua.
class Matcher {
 public:
  static constexpr std::size_t none = std::string_view::npos;

  /// Both texts, and the steps that a match is counted in, must outlive it.
  Matcher(std::string_view subject, std::string_view pattern, Interruptible& loop)
      : subject_(subject), pattern_(pattern), loop_(loop) {}

  /// End of the match that begins at `from`, or `none`.
  std::size_t match(std::size_t from);

  struct Capture {
    static constexpr std::size_t unclosed = none, position = none - 1;
    std::size_t begin = 0;
    std::size_t length = 0;  ///< or one of the above
  };
  /// Where steps are counted.
  Interruptible& loop() const { return loop_; }
  /// Of the last match.
  std::size_t captures() const { return count_; }
  /// Capture i, from 0, of a match over [begin, end); without any, capture 0 is the whole.
  Capture capture(std::size_t i, std::size_t begin, std::size_t end) const;

 private:
  std::size_t run(std::size_t s, std::size_t p);
  std::size_t rest(std::size_t s, std::size_t p);
  std::size_t open(std::size_t s, std::size_t p, std::size_t length);
  std::size_t close(std::size_t s, std::size_t p);
  std::size_t most(std::size_t s, std::size_t p, std::size_t after);
  std::size_t least(std::size_t s, std::size_t p, std::size_t after);
  std::size_t balanced(std::size_t s, std::size_t p) const;
  std::size_t again(std::size_t s, char digit) const;
  bool frontier(std::size_t s, std::size_t set, std::size_t after) const;
  bool one(std::size_t s, std::size_t p, std::size_t after) const;
  bool in_set(unsigned char c, std::size_t p, std::size_t after) const;
  std::size_t item_end(std::size_t p) const;
  /// The pattern's character, 0 behind its end.
  char at(std::size_t p) const { return p < pattern_.size() ? pattern_[p] : '\0'; }

  std::string_view subject_, pattern_;
  Interruptible& loop_;
  std::size_t count_ = 0;
  int depth_ = 0;
  std::array<Capture, 32> captures_{};
};

/// Where `text` is in `subject` at or behind `from`, or `Matcher::none`.
std::size_t find_text(std::string_view subject, std::string_view text, std::size_t from, Interruptible& loop);

}  // namespace pantin::lua
