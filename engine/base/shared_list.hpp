#pragma once
// Numbers that are recorded for as long as a scene is played, and kept by every snapshot of it.
#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

namespace pantin {

/// A list of numbers that grows at its end. A copy shares all whole parts with the original, and costs as much as the
/// rest: fewer than `part_size` numbers.
class SharedList {
 public:
  static constexpr std::size_t part_size = 1024;

  SharedList() = default;
  SharedList(std::initializer_list<double> values) {
    for (const double value : values) push_back(value);
  }

  std::size_t size() const { return part_size * whole_.size() + rest_.size(); }
  bool empty() const { return whole_.empty() && rest_.empty(); }
  double operator[](std::size_t i) const {
    const std::size_t part = i / part_size;
    return part < whole_.size() ? (*whole_[part])[i % part_size] : rest_[i % part_size];
  }
  double front() const { return (*this)[0]; }
  double back() const { return (*this)[size() - 1]; }

  void push_back(double value) {
    rest_.push_back(value);
    if (rest_.size() < part_size) return;
    auto part = std::make_shared<Part>();
    std::copy(rest_.begin(), rest_.end(), part->begin());
    whole_.push_back(std::move(part));
    rest_.clear();
  }
  /// Keeps the first `count`, or all where there are fewer.
  void shorten(std::size_t count) {
    if (count >= size()) return;
    if (const std::size_t whole = count / part_size; whole < whole_.size()) {
      rest_.assign(whole_[whole]->begin(), whole_[whole]->end());
      whole_.resize(whole);
    }
    rest_.resize(count % part_size);
  }
  friend bool operator==(const SharedList& a, const SharedList& b) {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); i++)
      if (a[i] != b[i]) return false;
    return true;
  }

 private:
  friend struct StateFields;  ///< of snapshot/state_fields.hpp
  using Part = std::array<double, part_size>;
  std::vector<std::shared_ptr<const Part>> whole_;
  std::vector<double> rest_;
};

}  // namespace pantin
