#pragma once
// Two grades of wrong: `require` tells the caller of bad input, `assume` stops on a fault of our own.
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

namespace pantin {

/// Bad input, as one sentence that names the value, its unit and what is allowed.
struct Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A number as people write it: the shortest text that reads back as the same double.
std::string to_text(double value);
/// With two digits, for measured values.
std::string rounded(double value);

/// A part of a text: a text, a character, a whole number, or a number as `to_text` writes it.
class TextPart {
 public:
  TextPart(std::string_view text) : kind_(Kind::text), text_(text) {}
  TextPart(const std::string& text) : TextPart(std::string_view(text)) {}
  TextPart(const char* text) : TextPart(std::string_view(text)) {}
  TextPart(char letter) : kind_(Kind::letter), letter_(letter) {}
  TextPart(double number) : kind_(Kind::number), number_(number) {}
  template <class T, std::enable_if_t<std::is_integral_v<T> && std::is_signed_v<T>, int> = 0>
  TextPart(T number) : kind_(Kind::whole), whole_(number) {}
  template <class T, std::enable_if_t<std::is_integral_v<T> && std::is_unsigned_v<T>, int> = 0>
  TextPart(T number) : kind_(Kind::count), count_(number) {}

  void append_to(std::string& text) const;

 private:
  enum class Kind : unsigned char { text, letter, number, whole, count };
  Kind kind_;
  union {
    std::string_view text_;
    char letter_;
    double number_;
    long long whole_;
    unsigned long long count_;
  };
};

std::string joined_text(std::initializer_list<TextPart> parts);

/// Joins values into one text.
template <class... Parts>
std::string text(const Parts&... parts) {
  return joined_text({TextPart(parts)...});
}

/// Throws Error with the joined message.
template <class... Parts>
[[noreturn, gnu::noinline, gnu::cold]] void refuse(const Parts&... message) {
  throw Error(text(message...));
}

[[noreturn]] void assumption_failed(const char* condition, const char* file, int line);

}  // namespace pantin

/// Throws Error with the joined message unless `condition` holds; the message is worked out only then.
#define require(condition, ...) ((condition) ? static_cast<void>(0) : ::pantin::refuse(__VA_ARGS__))

#if defined(PANTIN_ASSUME) && PANTIN_ASSUME
#define assume(condition) \
  ((condition) ? static_cast<void>(0) : ::pantin::assumption_failed(#condition, __FILE__, __LINE__))
#else
#define assume(condition) static_cast<void>(0)
#endif
