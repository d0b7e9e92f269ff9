#pragma once
// std::stable_sort, std::stable_partition and std::inplace_merge for elements of any alignment: the C++ library of GCC (to 15 at
// least) takes their buffers from an operator new that knows of 16 bytes alone.
#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <utility>
#include <vector>

namespace pantin {

/// As std::inplace_merge.
template <class Iterator, class Before = std::less<>>
void merge_sorted(Iterator first, Iterator middle, Iterator last, Before before = {}) {
  std::vector<typename std::iterator_traits<Iterator>::value_type> left(std::make_move_iterator(first),
                                                                        std::make_move_iterator(middle));
  auto next = left.begin();
  while (next != left.end()) {
    if (middle != last && before(*middle, *next))
      *first++ = std::move(*middle++);
    else
      *first++ = std::move(*next++);
  }
}

/// As std::stable_sort.
template <class Iterator, class Before = std::less<>>
void sort_stably(Iterator first, Iterator last, Before before = {}) {
  const auto count = last - first;
  if (count < 16) {
    for (auto i = first; i != last; ++i) std::rotate(std::upper_bound(first, i, *i, before), i, std::next(i));
    return;
  }
  const Iterator middle = first + count / 2;
  sort_stably(first, middle, before);
  sort_stably(middle, last, before);
  if (before(*middle, *std::prev(middle))) merge_sorted(first, middle, last, before);
}

/// As std::stable_partition.
template <class Iterator, class Is>
Iterator partition_stably(Iterator first, Iterator last, Is is) {
  std::vector<typename std::iterator_traits<Iterator>::value_type> others;
  Iterator end = first;
  for (Iterator i = first; i != last; ++i) {
    if (!is(*i))
      others.push_back(std::move(*i));
    else if (i != end)
      *end++ = std::move(*i);
    else
      ++end;
  }
  std::move(others.begin(), others.end(), end);
  return end;
}

}  // namespace pantin
