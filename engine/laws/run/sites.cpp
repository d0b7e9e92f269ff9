#include "laws/run/sites.hpp"

namespace pantin {

void Sites::resize(std::size_t count) {
  n = count;
  for (AlignedVector<Vec3>* array : {&x, &v, &force, &nonconservative_force}) {
    array->resize(n + padding);
    std::fill(array->begin() + n, array->end(), zero3());
  }
  // The square of its distance is infinite, and no sum of distances.
  std::fill(x.begin() + n, x.end(), vec(1e160, 1e160, 1e160));
  for (std::vector<std::uint32_t>* array : {&particle, &family}) array->resize(n + padding);
  serial.resize(n + padding);
  kin.resize(n + padding);
  attributes.resize(names.size());
  for (AlignedVector<double>& column : attributes) {
    column.resize(n + padding);
    std::fill(column.begin() + n, column.end(), 1.0);
  }
}

void Sites::clear_forces() {
  std::fill(force.begin(), force.end(), zero3());
  std::fill(nonconservative_force.begin(), nonconservative_force.end(), zero3());
}

}  // namespace pantin
