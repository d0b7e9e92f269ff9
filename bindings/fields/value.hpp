#pragma once
// What a property holds.
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/color.hpp"
#include "edit/emitter.hpp"
#include "model/breaking.hpp"
#include "model/group.hpp"

namespace pantin {
struct Curve;
}

namespace pantin::fields {

using Things = std::vector<AnyId>;
struct Entry;
/// Values by name; a list, where the names are empty.
using Table = std::vector<Entry>;

/// Between which the lifetimes of an emitter's particles are random, [s].
struct Lifetimes {
  double shortest = 0.0;
  double longest = 0.0;
};

/// Functions of time [s], and of a particle's age; a value that follows one is read as what it is now.
using NumberOfTime = std::function<double(double)>;
using VecOfTime = std::function<Vec3(double)>;
using QuatOfTime = std::function<Quat(double)>;
using OfAge = std::shared_ptr<const Curve>;

/// std::monostate: there is none.
using Value =
    std::variant<std::monostate, double, std::int64_t, bool, std::string, Vec3, Quat, Color, AnyId, Things, Table, Mat3,
                 Breaking, Lifetimes, EmitterPosition, NumberOfTime, VecOfTime, QuatOfTime, OfAge>;

struct Entry {
  std::string name;
  Value value;
};

/// The diagonal, where there is nothing beside it but round-off.
std::optional<Vec3> diagonal_of(const Mat3& inertia);

}  // namespace pantin::fields
