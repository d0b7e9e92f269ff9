#pragma once
#include <algorithm>
#include <cstddef>
#include <cstring>
#include <limits>
#include <new>
#include <type_traits>
#include <utility>

namespace pantin {

#if defined(PANTIN_ASSUME) && PANTIN_ASSUME
/// What nothing has set makes all that reads it no number, where the program's assumptions are checked.
constexpr bool marks_unset = true;
#else
constexpr bool marks_unset = false;
#endif

/// Puts signalling NaN into `bytes` of memory.
inline void mark_unset(void* memory, std::size_t bytes) {
  const double nan = std::numeric_limits<double>::signaling_NaN();
  for (std::size_t i = 0; i < bytes; i += sizeof(nan))
    std::memcpy(static_cast<char*>(memory) + i, &nan, std::min(sizeof(nan), bytes - i));
}

/// An array whose first element is at a multiple of 64 bytes, for plain types. New elements are not set: see `marks_unset`.
template <class T>
class AlignedVector {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  AlignedVector() = default;
  AlignedVector(const AlignedVector& other) { *this = other; }
  AlignedVector(AlignedVector&& other) noexcept { swap(other); }
  AlignedVector& operator=(const AlignedVector& other) {
    if (this == &other) return *this;
    size_ = 0;
    resize(other.size_);
    std::copy_n(other.data_, size_, data_);
    return *this;
  }
  AlignedVector& operator=(AlignedVector&& other) noexcept {
    swap(other);
    return *this;
  }
  ~AlignedVector() { release(); }

  /// Keeps what is there; takes a little more memory than asked for when it grows.
  void resize(std::size_t n) {
    if (n > capacity_) grow(n);
    if (marks_unset && n > size_) mark_unset(data_ + size_, (n - size_) * sizeof(T));
    size_ = n;
  }
  void assign(std::size_t n, T value) {
    resize(n);
    std::fill_n(data_, n, value);
  }
  std::size_t size() const { return size_; }
  std::size_t capacity() const { return capacity_; }
  T* data() { return data_; }
  const T* data() const { return data_; }
  T& operator[](std::size_t i) { return data_[i]; }
  const T& operator[](std::size_t i) const { return data_[i]; }
  T* begin() { return data_; }
  T* end() { return data_ + size_; }
  const T* begin() const { return data_; }
  const T* end() const { return data_ + size_; }

 private:
  static constexpr std::align_val_t alignment{64};

  void grow(std::size_t n) {
    const std::size_t capacity = n + n / 4 + 16;
    T* data = static_cast<T*>(::operator new(capacity * sizeof(T), alignment));
    std::copy_n(data_, size_, data);
    release();
    data_ = data;
    capacity_ = capacity;
  }
  void release() { ::operator delete(data_, alignment); }
  void swap(AlignedVector& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
  }

  T* data_ = nullptr;
  std::size_t size_ = 0, capacity_ = 0;
};

}  // namespace pantin
