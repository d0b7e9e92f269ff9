#pragma once
// Writing a state into bytes and reading it again. One function, `visit`, goes through everything in both directions; of a
// plain struct it goes through all fields (base/fields.hpp), so that none can be forgotten, and what it does not know does
// not compile. Bits come back as they were; what was shared is shared again.
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <typeindex>
#include <typeinfo>
#include <unordered_set>
#include <utility>
#include <variant>
#include <vector>

#include "base/aligned.hpp"
#include "base/check.hpp"
#include "base/fields.hpp"
#include "base/handle.hpp"
#include "base/lanes.hpp"
#include "laws/law.hpp"
#include "model/constraint.hpp"
#include "model/force_element.hpp"
#include "world/queue.hpp"

namespace pantin {

class Writer;
class Reader;
struct Forces;
struct World;

/// Keeps functions of one type that the engine did not make.
template <class Signature>
class FunctionKeeper {
 public:
  virtual ~FunctionKeeper() = default;
  /// Writes what makes it again; throws Error where that cannot be done.
  virtual void keep(Writer& to, const std::function<Signature>& function) = 0;
  virtual void make(Reader& from, std::function<Signature>& function) = 0;
};

/// What of a state the engine does not know: functions of the script.
class Outsider : public FunctionKeeper<void()>,
                 public FunctionKeeper<void(double)>,
                 public FunctionKeeper<double()>,
                 public FunctionKeeper<bool()>,
                 public FunctionKeeper<double(double)>,
                 public FunctionKeeper<Vec3(double)>,
                 public FunctionKeeper<Quat(double)>,
                 public FunctionKeeper<void(ParticleId)>,
                 public FunctionKeeper<void(ConnectionId)>,
                 public FunctionKeeper<std::optional<Wait>()> {
 public:
  virtual void keep_called(Writer& to, const std::shared_ptr<Called>& called) = 0;
  virtual std::shared_ptr<Called> make_called(Reader& from) = 0;
};

/// What both directions know.
struct Visiting {
  World* world = nullptr;  ///< of the state
  Outsider* outside = nullptr;
  Forces* forces = nullptr;  ///< that are visited
};

class Writer : public Visiting {
 public:
  static constexpr bool reads = false;
  std::string bytes;

  void raw(void* data, std::size_t size) { bytes.append(static_cast<const char*>(data), size); }
  /// The number of a shared thing, and whether it was not seen before.
  std::pair<std::uint32_t, bool> number_of(const void* thing, std::type_index type) {
    const auto next = static_cast<std::uint32_t>(known_.size() + 1);
    const auto [at, is_new] = known_.try_emplace({thing, type}, next);
    return {at->second, is_new};
  }

 private:
  std::map<std::pair<const void*, std::type_index>, std::uint32_t> known_;
};

class Reader : public Visiting {
 public:
  static constexpr bool reads = true;
  explicit Reader(std::string_view bytes) : rest(bytes) {}
  std::string_view rest;  ///< still to be read
  /// That handles of each type name: none may lead beyond its store, which is known once all is read.
  std::map<std::type_index, std::uint32_t> largest_slots;

  void raw(void* data, std::size_t size) {
    require(size <= rest.size(), "it ends too early");
    std::copy_n(rest.data(), size, static_cast<char*>(data));
    rest.remove_prefix(size);
  }
  struct Shared {
    std::shared_ptr<void> thing;  ///< null while it is read: none leads to itself
    std::type_index type;
  };
  std::vector<Shared> known;  ///< in the order of their numbers

  /// What lies within another of its kind, in its scope; a file must not end the stack.
  class Within {
   public:
    explicit Within(Reader& from) : depth_(from.depth_) { require(++depth_ < 200, "things in it lie too deep"); }
    ~Within() { depth_--; }
    Within(const Within&) = delete;
    Within& operator=(const Within&) = delete;

   private:
    int& depth_;
  };

 private:
  int depth_ = 0;
};

/// What is its bytes: numbers, and lanes of them.
template <class T>
inline constexpr bool is_number = std::is_arithmetic_v<T> || std::is_enum_v<T> || std::is_same_v<T, Vec3>;

/// Whether an enumeration has a name for the value.
template <class E, auto value>
constexpr bool is_named() {
  const std::string_view name = __PRETTY_FUNCTION__;
  const std::size_t at = name.find("value = ") + 8;
  return name[at] != '(' && (name[at] < '0' || name[at] > '9');
}
template <class E>
bool is_one_of(E value) {
  static constexpr auto named = []<std::size_t... i>(std::index_sequence<i...>) {
    return std::array{is_named<E, static_cast<E>(i)>()...};
  }
  (std::make_index_sequence<64>());
  const auto at = static_cast<std::size_t>(value);
  return at < named.size() && named[at];
}

template <class T>
concept IsPlain = std::is_aggregate_v<T>;

template <class A, class T>
void visit(A& a, T& value);

template <class A>
std::size_t visit_size(A& a, std::size_t size) {
  std::uint64_t count = size;
  a.raw(&count, sizeof(count));
  if constexpr (A::reads) require(count <= a.rest.size(), "a list in it is longer than it is");
  return static_cast<std::size_t>(count);
}

template <class A>
void visit_own(A& a, std::string& text) {
  const std::size_t size = visit_size(a, text.size());
  if constexpr (A::reads) text.resize(size);
  a.raw(text.data(), size);
}

template <class A, class List>
void visit_list(A& a, List& list) {
  using T = std::remove_reference_t<decltype(list[0])>;
  const std::size_t size = visit_size(a, list.size());
  if constexpr (is_number<T> && !std::is_enum_v<T> && !std::is_same_v<List, std::deque<T>>) {
    if constexpr (A::reads) {
      require(size <= a.rest.size() / sizeof(T), "a list in it is longer than it is");
      list.resize(size);
    }
    a.raw(list.data(), size * sizeof(T));
  } else {
    constexpr bool grows = requires { list.emplace_back(); };
    if constexpr (A::reads && grows) list.clear();
    if constexpr (A::reads && !grows) {  // vectors of numbers
      require(size <= a.rest.size() / sizeof(double), "a list in it is longer than it is");
      list.resize(size);
    }
    for (std::size_t i = 0; i < size; i++) {
      if constexpr (A::reads && grows) list.emplace_back();  // one after the other: it may end before
      visit(a, list[i]);
    }
  }
}
template <class A, class T>
void visit_own(A& a, std::vector<T>& list) {
  visit_list(a, list);
}
template <class A, class T>
void visit_own(A& a, AlignedVector<T>& list) {
  visit_list(a, list);
}
template <class A, class T>
void visit_own(A& a, std::deque<T>& list) {
  visit_list(a, list);
}
template <class A, class T, std::size_t n>
void visit_own(A& a, std::array<T, n>& list) {
  for (T& value : list) visit(a, value);
}
template <class A, class T, std::size_t n>
void visit_own(A& a, T (&list)[n]) {
  for (T& value : list) visit(a, value);
}

template <class A, class T>
void visit_own(A& a, std::optional<T>& value) {
  bool has = value.has_value();
  visit(a, has);
  if constexpr (A::reads) {
    value.reset();
    if (has) value.emplace();
  }
  if (has) visit(a, *value);
}

template <class A, class T, class U>
void visit_own(A& a, std::pair<T, U>& pair) {
  visit(a, const_cast<std::remove_const_t<T>&>(pair.first));
  visit(a, pair.second);
}

template <class A, class... T>
void visit_own(A& a, std::tuple<T...>& tuple) {
  std::apply([&](auto&... value) { (visit(a, value), ...); }, tuple);
}

template <class A, class K, class V>
void visit_own(A& a, std::map<K, V>& map) {
  const std::size_t size = visit_size(a, map.size());
  if constexpr (A::reads) {
    map.clear();
    for (std::size_t i = 0; i < size; i++) {
      std::pair<K, V> entry;
      visit(a, entry);
      map.insert(std::move(entry));
    }
  } else {
    for (auto& entry : map) visit_own(a, entry);
  }
}

template <class A, class Set>
void visit_set(A& a, Set& set) {
  using T = typename Set::key_type;
  const std::size_t size = visit_size(a, set.size());
  if constexpr (A::reads) {
    set.clear();
    for (std::size_t i = 0; i < size; i++) {
      T value;
      visit(a, value);
      set.insert(value);
    }
  } else {
    for (const T& value : set) visit(a, const_cast<T&>(value));
  }
}

template <class A, class T>
void visit_own(A& a, std::unordered_set<T>& set) {
  visit_set(a, set);
}
template <class A, class T>
void visit_own(A& a, std::set<T>& set) {
  visit_set(a, set);
}

template <class A>
void visit_own(A&, std::monostate&) {}

template <class A, class... T>
void visit_own(A& a, std::variant<T...>& value) {
  auto index = static_cast<std::uint8_t>(value.index());
  visit(a, index);
  if constexpr (A::reads) {
    require(index < sizeof...(T), "it names a kind that there is not");
    std::size_t i = 0;
    ((i++ == index ? (void)value.template emplace<T>() : (void)0), ...);
  }
  std::visit([&](auto& held) { visit(a, held); }, value);
}

/// One that stands for itself, however many name it.
template <class A, class T>
void visit_own(A& a, std::shared_ptr<T>& pointer) {
  using Plain = std::remove_const_t<T>;
  std::uint32_t number = 0;
  bool is_new = false;
  if constexpr (!A::reads)
    if (pointer) std::tie(number, is_new) = a.number_of(pointer.get(), typeid(Plain));
  visit(a, number);
  if constexpr (A::reads) {
    is_new = number == a.known.size() + 1;
    require(is_new || number <= a.known.size(), "it names something that is not in it");
    if (is_new) a.known.push_back({nullptr, typeid(Plain)});
  }
  if (is_new) {
    if constexpr (A::reads) {
      const Reader::Within within(a);
      std::shared_ptr<void> made;
      visit_new(a, pointer, made);
      a.known[number - 1].thing = made;
    } else {
      visit_shared(a, const_cast<Plain&>(*pointer));
    }
  } else if constexpr (A::reads) {
    pointer = nullptr;
    if (number == 0) return;
    const Reader::Shared& shared = a.known[number - 1];
    require(shared.thing && shared.type == typeid(Plain), "it names something of another kind");
    pointer = std::static_pointer_cast<Plain>(shared.thing);
  }
}
/// What is behind a shared pointer; a kind without fields of its own has its own pair of these.
template <class A, class T>
void visit_shared(A& a, T& value) {
  visit(a, value);
}
template <class T>
concept IsChecked = requires(const T& thing) {
  check_read(thing);
};
template <class T>
void visit_new(Reader& a, std::shared_ptr<T>& pointer, std::shared_ptr<void>& known) {
  const auto made = std::make_shared<std::remove_const_t<T>>();
  pointer = made;
  known = made;
  visit(a, *made);
  if constexpr (IsChecked<T>) check_read(*made);
}

template <class A, class Row>
void visit_own(A& a, Handle<Row>& handle) {
  visit(a, handle.slot);
  visit(a, handle.generation);
  if constexpr (A::reads) {
    std::uint32_t& largest = a.largest_slots[typeid(handle)];
    largest = std::max(largest, handle.slot);
  }
}

/// A plain struct.
template <class A, class T>
requires IsPlain<T>
void visit_own(A& a, T& value) {
  with_fields(value, [&](auto&... field) { (visit(a, field), ...); });
}

template <class A, class T>
void visit(A& a, T& value) {
  if constexpr (A::reads && std::is_same_v<T, bool>) {
    std::uint8_t byte = 0;
    a.raw(&byte, 1);
    require(byte < 2, "something in it is neither true nor false");
    value = byte != 0;
  } else if constexpr (is_number<T>) {
    a.raw(&value, sizeof(T));
    if constexpr (A::reads && std::is_enum_v<T>) require(is_one_of(value), "it names a kind that there is not");
  } else {
    visit_own(a, value);
  }
}

}  // namespace pantin
