// The list of a struct's fields.
#include "base/fields.hpp"

#include <catch2/catch.hpp>
#include <cstring>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "snapshot/state_fields.hpp"

using namespace pantin;

namespace {

struct Plain {
  int a = 1;
  std::string b = "b";
  std::optional<double> c;
  std::function<void()> d;
  double e[3] = {1, 2, 3};
  std::variant<std::monostate, int> f;
};

/// Bytes of a struct that neither its base nor any field in the list has, but for what aligns them.
template <class T>
std::size_t uncovered(T& value) {
  std::vector<std::pair<std::size_t, std::size_t>> parts;  // where, how many bytes
  const auto* start = reinterpret_cast<const char*>(&value);
  std::size_t end = sizeof(base_of(value));
  std::size_t missing = 0;
  std::apply(
      [&](auto&... field) {
        (parts.emplace_back(static_cast<std::size_t>(reinterpret_cast<const char*>(&field) - start), sizeof(field)),
         ...);
        std::size_t i = 0;
        for (const std::size_t alignment : {alignof(std::remove_reference_t<decltype(field)>)...}) {
          const auto [at, size] = parts[i++];
          if (at > end && at - end >= alignment) missing += at - end;
          end = at + size;
        }
      },
      own_fields(value));
  return missing + (sizeof(T) - end >= alignof(T) ? sizeof(T) - end : 0);
}

}  // namespace

TEST_CASE("fields: all fields of a plain struct, in their order") {
  STATIC_REQUIRE(count_fields<Plain>() == 6);
  Plain plain;
  std::size_t seen = 0;
  with_fields(plain, [&](auto&... field) { seen = sizeof...(field); });
  CHECK(seen == 6);
  with_fields(plain, [&](int& a, std::string& b, auto&...) {
    a = 5;
    b = "c";
  });
  CHECK(plain.a == 5);
  CHECK(plain.b == "c");
}

TEST_CASE("fields: the lists of structs with a base leave nothing out") {
  const World world;
  CHECK(uncovered(const_cast<WorldData&>(static_cast<const WorldData&>(world))) == 0);
  Articulate articulate;
  CHECK(uncovered(articulate) == 0);
  Connection connection;
  CHECK(uncovered(connection) == 0);
  Interaction interaction;
  CHECK(uncovered(interaction) == 0);
  pantin::Field field;
  CHECK(uncovered(field) == 0);
}
