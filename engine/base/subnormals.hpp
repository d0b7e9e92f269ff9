#pragma once
#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace pantin {

/// While it lives, this thread takes numbers below 2.2e-308 for 0, in operands and in results. Corrections that fade
/// along a long chain reach them, and arithmetic on them takes many times as long.
class SubnormalsAreZero {
 public:
  SubnormalsAreZero(const SubnormalsAreZero&) = delete;
  SubnormalsAreZero& operator=(const SubnormalsAreZero&) = delete;
#if defined(__SSE2__)
  SubnormalsAreZero() : before_(_mm_getcsr()) { _mm_setcsr(before_ | flush_results | flush_operands); }
  ~SubnormalsAreZero() { _mm_setcsr(before_); }

 private:
  static constexpr unsigned flush_results = 0x8000, flush_operands = 0x0040;
  unsigned before_;
#else
  SubnormalsAreZero() = default;
#endif
};

}  // namespace pantin
