#include "support/sealed_state.hpp"

#include <algorithm>
#include <cstring>

#include "base/hash.hpp"

namespace pantin {

std::string sealed(std::string state) {
  StateHead head{};
  if (state.size() < sizeof head) return state;
  std::memcpy(&head, state.data(), sizeof head);
  head.size = state.size() - sizeof head;
  Hash hash;
  hash.add(head.layout);
  hash.add(head.size);
  for (std::size_t at = sizeof head; at < state.size(); at += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, state.data() + at, std::min<std::size_t>(8, state.size() - at));
    hash.add(word);
  }
  head.hash = hash.value;
  std::memcpy(state.data(), &head, sizeof head);
  return state;
}

}  // namespace pantin
