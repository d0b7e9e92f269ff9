#pragma once
// Two grades of wrong: `require` tells the caller of bad input, `assume` stops on a fault of our own.
#include <sstream>
#include <stdexcept>
#include <string>

namespace pantin {

/// Bad input, as one sentence that names the value, its unit and what is allowed.
struct Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A number as people write it: the shortest text that reads back as the same double.
std::string to_text(double value);

namespace detail {
inline void put(std::ostringstream& out, double value) { out << to_text(value); }
template <class T>
void put(std::ostringstream& out, const T& value) {
  out << value;
}
}  // namespace detail

/// Joins values into one text.
template <class... Parts>
std::string text(const Parts&... parts) {
  std::ostringstream out;
  (detail::put(out, parts), ...);
  return out.str();
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
