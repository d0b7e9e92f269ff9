#include "lua/library/patterns.hpp"

#include <cstring>

#include "base/check.hpp"

namespace pantin::lua {
namespace {

constexpr int deepest = 200;  // as in Lua: items that wait for what follows them

bool between(unsigned char c, char first, char last) { return c >= first && c <= last; }
bool is_digit(unsigned char c) { return between(c, '0', '9'); }
bool is_lower(unsigned char c) { return between(c, 'a', 'z'); }
bool is_upper(unsigned char c) { return between(c, 'A', 'Z'); }
bool is_letter(unsigned char c) { return is_lower(c) || is_upper(c); }
bool is_visible(unsigned char c) { return between(c, '!', '~'); }

/// Whether c is of the class that the letter behind a % names, or is that character itself.
bool in_class(unsigned char c, char name) {
  const auto letter = static_cast<unsigned char>(name);
  bool in = false;
  switch (letter | 0x20) {
    case 'a': in = is_letter(c); break;
    case 'c': in = c < ' ' || c == 127; break;
    case 'd': in = is_digit(c); break;
    case 'g': in = is_visible(c); break;
    case 'l': in = is_lower(c); break;
    case 'p': in = is_visible(c) && !is_letter(c) && !is_digit(c); break;
    case 's': in = c == ' ' || between(c, '\t', '\r'); break;
    case 'u': in = is_upper(c); break;
    case 'w': in = is_letter(c) || is_digit(c); break;
    case 'x': in = is_digit(c) || between(static_cast<unsigned char>(c | 0x20), 'a', 'f'); break;
    case 'z': in = c == 0; break;
    default: return c == letter;
  }
  return in != is_upper(letter);
}

}  // namespace

std::size_t Matcher::match(std::size_t from) {
  count_ = 0;
  depth_ = 0;
  return run(from, 0);
}

/// The match of the pattern from p on with the subject from s on.
std::size_t Matcher::run(std::size_t s, std::size_t p) {
  require(++depth_ <= deepest, "pattern too complex");
  const std::size_t end = rest(s, p);
  depth_--;
  return end;
}

std::size_t Matcher::rest(std::size_t s, std::size_t p) {
  while (p < pattern_.size()) {
    loop_.count();
    const char c = at(p), next = at(p + 1);
    if (c == '(') return next == ')' ? open(s, p + 2, Capture::position) : open(s, p + 1, Capture::unclosed);
    if (c == ')') return close(s, p + 1);
    if (c == '$' && p + 1 == pattern_.size()) return s == subject_.size() ? s : none;
    if (c == '%' && (next == 'b' || is_digit(static_cast<unsigned char>(next)))) {
      s = next == 'b' ? balanced(s, p + 2) : again(s, next);
      if (s == none) return none;
      p += next == 'b' ? 4 : 2;
      continue;
    }
    if (c == '%' && next == 'f') {
      require(at(p + 2) == '[', "missing '[' after '%f' in pattern");
      const std::size_t after = item_end(p + 2);
      if (!frontier(s, p + 2, after)) return none;
      p = after;
      continue;
    }
    const std::size_t after = item_end(p);
    switch (at(after)) {
      case '*': return most(s, p, after);
      case '+': return one(s, p, after) ? most(s + 1, p, after) : none;
      case '-': return least(s, p, after);
      case '?': {
        if (one(s, p, after))
          if (const std::size_t end = run(s + 1, after + 1); end != none) return end;
        p = after + 1;
        break;
      }
      default:
        if (!one(s, p, after)) return none;
        s++;
        p = after;
    }
  }
  return s;
}

std::size_t Matcher::open(std::size_t s, std::size_t p, std::size_t length) {
  require(count_ < captures_.size(), "too many captures");
  captures_[count_++] = {s, length};
  const std::size_t end = run(s, p);
  if (end == none) count_--;
  return end;
}

std::size_t Matcher::close(std::size_t s, std::size_t p) {
  std::size_t i = count_;
  while (i > 0 && captures_[i - 1].length != Capture::unclosed) i--;
  require(i > 0, "invalid pattern capture");
  Capture& capture = captures_[i - 1];
  capture.length = s - capture.begin;
  const std::size_t end = run(s, p);
  if (end == none) capture.length = Capture::unclosed;
  return end;
}

/// As many of the item [p, after) as let the rest match.
std::size_t Matcher::most(std::size_t s, std::size_t p, std::size_t after) {
  std::size_t last = s;
  while (one(last, p, after)) last++;
  for (;; last--) {
    if (const std::size_t end = run(last, after + 1); end != none) return end;
    if (last == s) return none;
  }
}

/// As few as let the rest match.
std::size_t Matcher::least(std::size_t s, std::size_t p, std::size_t after) {
  for (;; s++) {
    if (const std::size_t end = run(s, after + 1); end != none) return end;
    if (!one(s, p, after)) return none;
  }
}

/// The end of a text that begins with the pattern's character p and goes to the p + 1 that closes it.
std::size_t Matcher::balanced(std::size_t s, std::size_t p) const {
  require(p + 1 < pattern_.size(), "malformed pattern (missing arguments to '%b')");
  const char opening = pattern_[p], closing = pattern_[p + 1];
  if (s >= subject_.size() || subject_[s] != opening) return none;
  for (std::size_t inside = 1; ++s < subject_.size();) {
    loop_.count();
    if (subject_[s] == closing) {
      if (--inside == 0) return s + 1;
    } else if (subject_[s] == opening) {
      inside++;
    }
  }
  return none;
}

/// The end of a text that equals what the capture of the digit found.
std::size_t Matcher::again(std::size_t s, char digit) const {
  const auto i = static_cast<std::size_t>(digit - '0');
  require(i > 0 && i <= count_ && captures_[i - 1].length != Capture::unclosed, "invalid capture index %", digit);
  const Capture& capture = captures_[i - 1];
  if (capture.length == Capture::position || subject_.size() - s < capture.length) return none;
  loop_.count(capture.length / 16);
  return subject_.compare(s, capture.length, subject_, capture.begin, capture.length) == 0 ? s + capture.length : none;
}

/// Whether the character before s is not of the set [set, after), and the one at s is. Outside of the subject are zeros.
bool Matcher::frontier(std::size_t s, std::size_t set, std::size_t after) const {
  const auto before = static_cast<unsigned char>(s == 0 ? '\0' : subject_[s - 1]);
  const auto here = static_cast<unsigned char>(s < subject_.size() ? subject_[s] : '\0');
  return !in_set(before, set, after) && in_set(here, set, after);
}

/// Whether the character at s is one of the item [p, after).
bool Matcher::one(std::size_t s, std::size_t p, std::size_t after) const {
  if (s >= subject_.size()) return false;
  loop_.count();
  const auto c = static_cast<unsigned char>(subject_[s]);
  switch (pattern_[p]) {
    case '.': return true;
    case '%': return in_class(c, at(p + 1));
    case '[': return in_set(c, p, after);
    default: return static_cast<unsigned char>(pattern_[p]) == c;
  }
}

/// Whether c is in the set [p, after), brackets included.
bool Matcher::in_set(unsigned char c, std::size_t p, std::size_t after) const {
  loop_.count((after - p) / 4);
  const std::size_t last = after - 1;
  const bool inverted = pattern_[++p] == '^';
  if (inverted) p++;
  const auto character = [this](std::size_t i) { return static_cast<unsigned char>(pattern_[i]); };
  while (p < last) {
    bool in = false;
    if (pattern_[p] == '%') {
      in = in_class(c, pattern_[p + 1]);
      p += 2;
    } else if (p + 2 < last && pattern_[p + 1] == '-') {
      in = character(p) <= c && c <= character(p + 2);
      p += 3;
    } else {
      in = character(p) == c;
      p++;
    }
    if (in) return !inverted;
  }
  return inverted;
}

/// Behind the single-character item at p: a character, a class or a set, without its repetition.
std::size_t Matcher::item_end(std::size_t p) const {
  const char c = pattern_[p++];
  if (c == '%') {
    require(p < pattern_.size(), "malformed pattern (ends with '%')");
    return p + 1;
  }
  if (c != '[') return p;
  const std::size_t begin = p;
  if (at(p) == '^') p++;
  do {  // a bracket that comes first is a member
    require(p < pattern_.size(), "malformed pattern (missing ']')");
    p += pattern_[p] == '%' && p + 1 < pattern_.size() ? 2u : 1u;
  } while (at(p) != ']');
  loop_.count((p - begin) / 4);
  return p + 1;
}

Matcher::Capture Matcher::capture(std::size_t i, std::size_t begin, std::size_t end) const {
  if (i == 0 && count_ == 0) return {begin, end - begin};
  require(i < count_, "invalid capture index %", i + 1);
  require(captures_[i].length != Capture::unclosed, "unfinished capture");
  return captures_[i];
}

std::size_t find_text(std::string_view subject, std::string_view text, std::size_t from, Interruptible& loop) {
  if (text.size() > subject.size()) return Matcher::none;
  if (text.empty()) return from;
  const std::size_t last = subject.size() - text.size();
  while (from <= last) {
    const void* found = std::memchr(subject.data() + from, text[0], last - from + 1);
    if (!found) return Matcher::none;
    const auto place = static_cast<std::size_t>(static_cast<const char*>(found) - subject.data());
    loop.count(1 + (place - from) / 16 + text.size() / 16);
    if (std::memcmp(found, text.data(), text.size()) == 0) return place;
    from = place + 1;
  }
  return Matcher::none;
}

}  // namespace pantin::lua
