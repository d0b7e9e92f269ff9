#pragma once
// A number of a law, and which values it may have.
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace pantin {

/// sign: -1 to 1; whole: 1, 2, …; direction: of a vec, which may not be 0.
enum class ParameterRange : std::uint8_t { any, positive, not_negative, sign, whole, direction };

struct Parameter {
  std::string name;
  double value = 0.0;
  std::string unit;
  bool present = false;  ///< the caller gives each connection its value: what is measured when it is made
  ParameterRange range = ParameterRange::any;  ///< of one that is a vec's x, y or z: direction
};

/// Throws Error where one of `values`, of the parameters in the same order, is not finite or out of its range; `call` begins
/// the message, then the name of the law. What the world gives is left out.
void check_parameters(std::string_view call, const std::string& law, std::span<const Parameter> parameters,
                      std::span<const double> values);
/// The same of one of them.
void check_parameter(std::string_view call, const std::string& law, std::span<const Parameter> parameters,
                     std::span<const double> values, std::size_t index);

}  // namespace pantin
