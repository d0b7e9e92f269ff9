#pragma once
// Bringing those of four lanes that a mask names to the front.
#include <cstdint>

#ifdef __AVX2__
#include <immintrin.h>

#include <array>

namespace pantin {

struct Compression {
  alignas(32) std::array<std::uint32_t, 8> halves{};  ///< of doubles, by their halves
  std::array<std::uint8_t, 16> bytes{};               ///< of four-byte lanes
};

constexpr std::array<Compression, 16> make_compressions() {
  std::array<Compression, 16> table{};
  for (std::uint32_t mask = 0; mask < 16; mask++) {
    std::size_t to = 0;
    for (std::uint32_t lane = 0; lane < 4; lane++) {
      if ((mask >> lane & 1) == 0) continue;
      table[mask].halves[2 * to] = 2 * lane;
      table[mask].halves[2 * to + 1] = 2 * lane + 1;
      for (std::uint32_t byte = 0; byte < 4; byte++)
        table[mask].bytes[4 * to + byte] = static_cast<std::uint8_t>(4 * lane + byte);
      to++;
    }
  }
  return table;
}
inline constexpr std::array<Compression, 16> compressions = make_compressions();

inline __m128i compressed(__m128i lanes, unsigned mask) {
  return _mm_shuffle_epi8(lanes, _mm_load_si128(reinterpret_cast<const __m128i*>(compressions[mask].bytes.data())));
}
inline __m256d compressed(__m256d lanes, unsigned mask) {
  const __m256i order = _mm256_load_si256(reinterpret_cast<const __m256i*>(compressions[mask].halves.data()));
  return _mm256_castps_pd(_mm256_permutevar8x32_ps(_mm256_castpd_ps(lanes), order));
}

}  // namespace pantin
#endif
