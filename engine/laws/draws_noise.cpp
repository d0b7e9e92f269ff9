#include "laws/draws_noise.hpp"

#include <algorithm>

namespace pantin {

bool draws_noise(const Law& law) {
  const auto drawn = [](const std::vector<Input>& inputs) {
    return std::any_of(inputs.begin(), inputs.end(), [](const Input& input) { return input.role == Role::noise; });
  };
  return drawn(law.graph.inputs()) || drawn(law.inputs_wanted) || (law.also && draws_noise(*law.also));
}

}  // namespace pantin
