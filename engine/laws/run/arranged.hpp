#pragma once
// Connections in the order in which they are gone through: in ranges of sites that may be gone through at once, and
// there by their first sites.
#include <array>
#include <cstdint>
#include <vector>

#include "base/aligned.hpp"
#include "laws/run/sites.hpp"

namespace pantin {

/// Connections of one law, in the order they were made.
struct BondList {
  int count = 2;                                ///< sites of each
  std::vector<std::uint32_t> sites;             ///< (count × connections) one connection after the other
  std::vector<std::vector<double>> parameters;  ///< (parameters of the law × connections), or empty: the same for all
  std::size_t size() const { return sites.size() / static_cast<std::size_t>(count); }
};

struct Arranged {
  struct Range {
    std::size_t begin = 0, end = 0;
  };

  std::size_t n = 0;
  std::array<std::vector<std::uint32_t>, 4> sites;  ///< (n) of each
  std::vector<std::uint32_t> position;              ///< of each connection, by its number in BondList
  std::vector<std::uint32_t> connection;            ///< number in BondList of each position
  std::vector<AlignedVector<double>> parameters;    ///< (n and some more) or none
  std::vector<std::vector<Range>> phases;           ///< ranges of one phase share no site

  void arrange(const BondList& ties, std::size_t site_count);

 private:
  friend struct StateFields;  ///< of snapshot/state_fields.hpp
  void number_groups(const BondList& ties, std::size_t site_count);
  void sort_by_group_and_first(const BondList& ties, std::size_t site_count);

  std::size_t ranges_ = 0;  // those that are shared out; what is in none of them has the next number
  std::vector<std::uint32_t> group_, reach_, sorted_, count_;
};

}  // namespace pantin
